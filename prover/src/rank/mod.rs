//! Linear independence of functions whose coefficients depend on parameters.
//!
//! The functions are the rows of a matrix of polynomials in the parameters. They are independent at a point exactly
//! when one of the maximal minors is not zero there. The matrix is cut into blocks first, by its symmetries and by the
//! places of its zeros. Of a block a few minors are enough: as long as those that are known vanish together at some
//! point of the region, either the rank drops at that point, or a minor that does not vanish there joins them.

mod blocks;
mod combination;
mod cut;
mod exception;
#[cfg(feature = "ranges")]
mod exceptional;
mod independent;
mod irrational;
pub(crate) mod symmetry;
mod table;

pub(crate) use combination::combination;
#[cfg(feature = "ranges")]
pub use exceptional::{Exceptional, ExceptionalSet, exceptional_set};
pub use independent::{Independence, independent};
pub use symmetry::{Symmetries, Symmetry};
pub use table::Table;
