//! Signs of polynomials on boxes: the search for proofs and counterexamples.
//!
//! A cascade, from the cheap methods that decide nearly everything to the complete ones:
//!
//! 1. Bernstein coefficients on the box, factors that vanish on faces taken out;
//! 2. corners: a polynomial of degree 1 in a variable is decided by its restrictions to the ends of the range;
//! 3. factors: of a square-free decomposition every factor is decided for itself, squares not at all;
//! 4. one variable: Descartes' rule of signs (complete);
//! 5. sums of squares, where a range has no ends or one;
//! 6. subdivision of the box, with values at the corners of the cells as counterexamples;
//! 7. counterexamples with equal coordinates where an exchange of two variables changes nothing, and by Newton's method
//!    in three variables or more; then open cylindrical decomposition (complete for p ≥ 0); for p > 0 the faces of the
//!    box one by one, and on each open face the slices in which p can have a zero (complete for one and two variables).

mod cascade;
mod corners;
pub(crate) mod decomposition;
mod descent;
mod diagonal;
mod factors;
pub(crate) mod outcome;
pub(crate) mod problem;

pub use problem::open;
mod squares;
mod subdivision;
pub(crate) mod univariate;
mod witness;

#[cfg(feature = "ranges")]
pub(crate) use cascade::prove;
pub use cascade::{Found, search};
#[cfg(feature = "ranges")]
pub(crate) use outcome::Outcome;
