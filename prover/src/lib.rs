#![doc = include_str!("../README.md")]

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

pub(crate) use basis_kernel::collections;
pub use basis_kernel::{Proof, Refutation};
pub use budget::Budget;
pub use coordinate::Coordinate;
pub use counterexample::{Counterexample, refute};
pub use decide::{Decision, Shown, decide, simple};
pub use method::Method;
pub use nonzero::{candidates, typical};
pub use rank::symmetry::{Symmetries, Symmetry};
pub use semidefinite::semidefinite;
