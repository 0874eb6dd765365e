//! The kernel's lists and sorting, with a list from any iterator, and a map of two lists.

pub mod list;
pub mod map;
pub mod sort;
