#![doc = include_str!("../README.md")]
#![cfg_attr(docsrs, feature(doc_cfg))] // items say which feature they need

pub mod algebra;
mod budget;
pub mod collections;
mod coordinate;
mod counterexample;
mod decide;
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

pub use basis_kernel::{Proof, Refutation};
pub use budget::{
    Budget, charge, charged, cut_short_within, done_less_often, measured, spent, within, within_half,
    working, working_with,
};
pub use coordinate::Coordinate;
pub use counterexample::{Counterexample, refute, value_at};
pub use decide::{Failure, Shown, decide, minor_signs, of_negative, pull_back, simple};
pub use method::Method;
pub use nonzero::{candidates, typical};
pub use rank::symmetry::{Symmetries, Symmetry};
pub use semidefinite::semidefinite;
pub use zero_free::{ZeroFree, zero_between, zero_free};
