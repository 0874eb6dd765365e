//! Certificates and witnesses as text: nested lists in round brackets, on one line.
//!
//! Variables are `x0`, `x1`, …; numbers fractions in lowest terms, `-3/2`; polynomials expanded sums without spaces in
//! the order of [`Poly`](crate::algebra::poly::Poly), `1-3*x0+x0*x1^2`. There is one text for each certificate, and no
//! other text is read.
//!
//! ```text
//! certificate  direct
//!              (sign DENOMINATOR PROOF)      DENOMINATOR: _ for a number, else SIGNED
//!              (minors PROOF …)
//!              (rank (PIECE …) (EXCEPTION …))
//! PROOF        .                             Bernstein coefficients on the whole box
//!              (cut x0 PROOF PROOF)          the lower half, the upper half; inside only . and (cut …)
//!              (corners x0 PROOF PROOF)      for both ends; (corners x0 PROOF PROOF 1/2 PROOF) with a point between
//!              (factors (FACTOR ANY) … SIGNED)   ANY: ^ for an even power, else SIGNED; last the sign of what is left
//!              (squares (FACTOR POLYNOMIAL) … PROOF)     a sum of squares, last of what is left
//!              (faces PROOF …)
//!              (cells (x0 …) ((POLYNOMIAL …) …) (SAMPLE …))      SAMPLE: 1/2, or (1/2 SAMPLE …) with those above
//!              (slices (BASE …) (BOX …))     BOX: (low high …) by variable
//! SIGNED       + or -, or (+ PROOF), (- PROOF): the polynomial or its opposite has the sign that is needed
//! BASE         ((x0 …) ((POLYNOMIAL …) …) (SECTION …) ((1/2 PROOF) …))    SECTION: (= 1/2 PROOF) or (low high)
//! PIECE        (BLOCK …), or (change (COMBINATION …) (COMBINATION …) BLOCK …) with new rows and columns
//! BLOCK        ((row …) ((column …) …) SIGNED)
//! COMBINATION  (index factor …)             EXCEPTION: (POLYNOMIAL …)
//!
//! witness      (at (x0 VALUE) …)             VALUE: a number; or (c0 c1 …) for c0 + c1 θ + …
//!              (at (root (m0 m1 …) low high) (x0 VALUE) …)   θ: a root of m0 + m1 θ + … between two numbers
//!              (dependent (at …) VALUE …)    the factors of the rows
//!              (independent (at …) 0)        the number of the exception
//!              (line (at …) index number …)  the places of points on a line, for dot products
//! ```

mod read;
mod tree;
mod write;

pub use read::{certificate, witness};
pub use write::{certificate_text, witness_text};
