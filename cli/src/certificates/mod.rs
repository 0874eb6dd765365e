//! Certificates as files: what `basis check --certificates` writes and `basis verify` reads.
//!
//! There is one JSON file for each family and order, `DIR/<path of the spec>/<name>-<order>.json`. It says what the spec
//! says, all of which `verify` compares with the spec, and for every claim why it is true or where it fails:
//!
//! ```text
//! format      "basis certificate 1"
//! spec        the path of the spec as it was given
//! kind, name, order, shape, domain, variables, functions      the family; polynomials are expanded in the variables
//! claims      for each: claim, line, declared, verdict, and
//!   proved      steps: a list of statements, each with its proof
//!   refuted     witness: of, at, value
//!   undecided   left: what is left to decide
//! ```
//!
//! `DIR/manifest.json` lists the specs with their claims, so that `verify` notices when certificates are missing.
//!
//! Statements, and their proofs:
//!
//! ```text
//! identity       difference = 0                  "expansion": whoever expands both sides anew has checked it
//! sign           polynomial, relation, box       a certificate, see below; on a simplex the polynomial is pulled back to the
//!                                                unit box by u = 1 − s1, v = s1 (1 − s2), w = s1 s2 (1 − s3), …
//! dot products   polynomial, relation, points: a sum of dot products of points, which are numbered
//!                a list of squares, factor times dot(vector, vector) with a positive factor; a vector is a list of points
//!                with how much of each. The squares are the sum but for its constant
//! independence   rows, except, box: the coefficients of the functions, up to denominators that vanish nowhere
//!                exceptions    for each a combination of the rows that vanishes there
//!                pieces        boxes that cover the rest; in each, after a change of bases (rows, columns: combinations
//!                              of the old ones), blocks of rows that are zero in the columns of later blocks, with minors
//!                              (columns, value) and a certificate: one minor, or the sum of the squares of several, is > 0 or < 0
//! ```
//!
//! Certificates for signs are those of [`basis_engine::decide::Certificate`]: `empty`, `constant`, `bernstein` (parts: a cut
//! is followed by its lower and its upper part, a cell has its Bernstein coefficients, the index of the last variable
//! fastest), `corners`, `factors`, `faces`, `cells`, `slices`. Numbers are fractions in lowest terms.

mod fields;
mod manifest;
mod proofs;
mod signs;
mod statements;
#[cfg(test)]
mod tests;
mod text;
mod verify;
mod write;

pub(crate) use manifest::Manifest;
pub(crate) use text::coordinate_text;
pub(crate) use verify::run as verify;
pub(crate) use write::write;

/// The first field of every certificate.
const FORMAT: &str = "basis certificate 1";
