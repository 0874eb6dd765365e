//! Certificates as files: what `basis check --certificates` writes and `basis verify` reads.
//!
//! There is one JSON file for each family and order, `DIR/<path of the spec>/<name>-<order>.json`. It says which claims
//! the spec makes and how each is proved or where it fails, and nothing that follows from the spec: `verify` reads the
//! spec itself, works out what has to be shown, and has the kernel check it.
//!
//! ```text
//! format       "basis certificate 3"
//! spec         the path of the spec as it was given
//! kind, name, order, variables     the family; variables are x0, x1, … in proofs
//! obligations  what must be true for the formulas to mean something; for each: of, `negative` where a denominator is
//!              negative everywhere, `square` where its square is positive where what is assumed holds, and
//!   proof      unless computing is enough; or where it follows from what is assumed
//!   way        the number of the way to statements that are enough; steps: their number; proofs: as of claims
//! claims       for each: claim, line, declared, and
//!   proved     steps: the number of statements that the claim makes; proofs: those of them that need more than
//!              computing, by their places
//!   refuted    of: the expression that is not as claimed; witness: where; value: its value there; given: the control
//!              points of a theorem, if it is about any points
//!   undecided  left: what is left to decide
//! ```
//!
//! Numbers of ways are those of the version of the program that wrote them, as the search that they belong to may change.
//!
//! A proof and a witness are texts of [`basis_kernel::text`], where they are described.
//!
//! `DIR/manifest.json` lists the specs with their claims, so that `verify` notices when certificates are missing.

mod fields;
mod head;
mod manifest;
mod specs;
#[cfg(test)]
mod tests;
mod verify;
mod write;

pub(crate) use manifest::Manifest;
pub(crate) use verify::run as verify;
pub(crate) use write::write;
