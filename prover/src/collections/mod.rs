//! The kernel's lists and sorting, with a list from any iterator, and a map of two lists.

pub use basis_kernel::collections::sort;

pub mod list;
pub mod map;
