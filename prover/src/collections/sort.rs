//! The kernel's sorting, and by keys.

pub use basis_kernel::collections::sort::{sort, sort_by, sort_unique};

/// Sorts stably, as [`slice::sort_by_key`].
pub fn sort_by_key<T, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K) {
    sort_by(items, |a, b| key(a).cmp(&key(b)));
}
