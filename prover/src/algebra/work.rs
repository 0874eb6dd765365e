//! The kernel's counter of work, and the error of a search that runs out of it.

pub use basis_kernel::algebra::done::done;
pub use basis_kernel::algebra::work::Work;

/// No work is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spent;
