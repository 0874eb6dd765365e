//! Finds proofs and counterexamples of statements about polynomials. Nothing that is found here counts before the kernel has
//! accepted it: every decision holds a [`Proof`] or a [`Refutation`], which only the kernel makes.
//!
//! [`decide`] offers the empty certificate first. It is enough for nearly all statements, and then everything is computed once.
//! Otherwise `sign` and `rank` search, and propose what they find.

pub mod algebra;
mod budget;
mod coordinate;
mod counterexample;
mod decide;
pub mod map;
mod method;
mod nonzero;
#[cfg(feature = "ranges")]
pub mod range;
pub mod rank;
mod semidefinite;
pub mod sign;
#[cfg(test)]
mod tests;
mod zero_free;

pub(crate) use basis_kernel::collections;
pub use basis_kernel::{Proof, Refutation};
pub use budget::{Budget, spent};
pub use coordinate::Coordinate;
pub use counterexample::{Counterexample, refute};
pub use decide::{Failure, Shown, decide, simple};
pub use method::Method;
pub use nonzero::{candidates, typical};
pub use rank::symmetry::{Symmetries, Symmetry};
pub use semidefinite::semidefinite;
pub use zero_free::{ZeroFree, zero_free};
