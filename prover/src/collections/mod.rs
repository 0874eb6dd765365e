//! The kernel's lists and sorting, with a list from any iterator.

pub use basis_kernel::collections::sort;

pub mod list;
