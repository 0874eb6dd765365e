//! Largest ranges on which polynomials stay nonnegative.

mod largest;
mod parts;

pub use largest::{LargestRange, largest_range};
pub use parts::{Part, nonnegative_parts};
