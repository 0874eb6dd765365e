//! Tuples of indices: those with one sum, and those below given sizes.

use core::ops::Range;

use basis_prover::collections::list::Listed;

/// All tuples of whole numbers ≥ 0 with the given sum, in lexicographic order; at most `limit` + 1 of them.
pub(crate) fn multi_indices(len: usize, sum: i64, limit: usize) -> Vec<Vec<i64>> {
    let mut all = Vec::new();
    if sum < 0 || len == 0 {
        return all;
    }
    // The first tuple in lexicographic order has everything in the last place.
    let mut index = vec![0; len];
    index[len - 1] = sum;
    while all.len() <= limit {
        all.push(index.clone());
        // The next one: move one unit left from the last place that has any, the rest back to the end.
        let Some(from) = (1..len).rev().find(|k| index[*k] > 0) else { break };
        let rest = index[from] - 1;
        index[from] = 0;
        index[from - 1] += 1;
        index[len - 1] = rest;
    }
    all
}

/// All tuples below the given sizes, in lexicographic order; at most `limit` + 1 of them.
pub(crate) fn grid(sizes: &[i64], limit: usize) -> Vec<Vec<i64>> {
    let mut all = vec![Vec::new()];
    for size in sizes {
        all = all
            .iter()
            .flat_map(|start: &Vec<i64>| (0..*size).map(move |k| [start.as_slice(), &[k]].concat()))
            .take(limit + 1)
            .listed();
    }
    all
}

/// The indices of functions, in lexicographic order, at most `limit` + 1 of them. At the places of a simplex all tuples
/// whose sum is greater by `more` than that of the given index, at other places all numbers below the size. Without
/// places every one is on its own.
pub(crate) fn numbered(
    places: &[Range<usize>],
    of: &[i64],
    more: i64,
    sizes: &[i64],
    limit: usize,
) -> Vec<Vec<i64>> {
    if places.is_empty() {
        return grid(sizes, limit);
    }
    let mut all = vec![Vec::new()];
    for own in places {
        let parts = if own.len() > 1 {
            let sum = of[own.clone()].iter().sum::<i64>() + more;
            multi_indices(own.len(), sum, limit)
        } else {
            grid(&sizes[own.clone()], limit)
        };
        all = all
            .iter()
            .flat_map(|start: &Vec<i64>| parts.iter().map(move |part| [&start[..], part].concat()))
            .take(limit + 1)
            .listed();
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multi_indices_are_lexicographic() {
        let all = multi_indices(3, 2, 100);
        assert_eq!(all, [[0, 0, 2], [0, 1, 1], [0, 2, 0], [1, 0, 1], [1, 1, 0], [2, 0, 0]]);
        assert_eq!(multi_indices(3, 8, 100).len(), 45);
        assert_eq!(multi_indices(4, 1_000_000, 10).len(), 11);
        assert!(multi_indices(2, -1, 10).is_empty());
    }
}
