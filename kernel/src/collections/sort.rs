//! Sorting that costs little to compile.
//!
//! Every call of `slice::sort_by` compiles a whole sorting algorithm for its type and its closure, and every user of
//! the macro builds them all. Here one algorithm sorts indices for all types.

use core::cmp::Ordering;

/// Sorts stably, as [`slice::sort_by`].
pub fn sort_by<T>(items: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    let mut target = positions(items.len(), &|i, j| compare(&items[i], &items[j]));
    // The element at k belongs to target[k]; each swap brings one home.
    for k in 0..items.len() {
        while target[k] != k {
            let home = target[k];
            items.swap(k, home);
            target.swap(k, home);
        }
    }
}

/// Sorts, as [`slice::sort`].
pub fn sort<T: Ord>(items: &mut [T]) {
    sort_by(items, T::cmp);
}

/// Sorts and leaves one of those that are equal.
pub fn sort_unique<T: Ord>(items: &mut Vec<T>) {
    sort(items);
    items.dedup();
}

/// For each of `len` elements its position in the sorted order.
fn positions(len: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order: Vec<usize> = (0..len).collect();
    order.sort_by(|&i, &j| compare(i, j));
    let mut positions = vec![0; len];
    for (position, &element) in order.iter().enumerate() {
        positions[element] = position;
    }
    positions
}

#[cfg(test)]
mod tests {
    use super::{sort_by, sort_unique};

    #[test]
    fn sorts_stably() {
        let mut items: Vec<(u32, usize)> = [5, 3, 5, 1, 3, 9, 0, 5].into_iter().zip(0..).collect();
        let mut expected = items.clone();
        expected.sort_by_key(|(key, _)| *key);
        sort_by(&mut items, |a, b| a.0.cmp(&b.0));
        assert_eq!(items, expected);
    }

    #[test]
    fn leaves_one_of_equals() {
        let mut items = vec!["b", "a", "b", "c", "a"];
        sort_unique(&mut items);
        assert_eq!(items, ["a", "b", "c"]);
        sort_unique(&mut Vec::<u8>::new());
    }
}
