//! Answers that are one: places of two parameters that are beside each other, and boxes that touch, found in sorted
//! order.

use alloc::vec::Vec;

/// Intervals of two parameters.
type Box2 = [[f64; 2]; 2];

/// Places in the order of the first parameter, of those that are no farther from each other than the gaps the first
/// one.
#[inline]
pub(super) fn places(mut places: Vec<[f64; 2]>, gaps: [f64; 2]) -> Vec<[f64; 2]> {
    let order = |a: &[f64; 2], b: &[f64; 2]| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]));
    places.sort_unstable_by(order);
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(places.len());
    // Neighbours in the first parameter are sorted by the second one, at which a curve may come back many times.
    for chain in places.chunk_by_mut(|a, b| b[0] - a[0] <= gaps[0]) {
        chain.sort_unstable_by(|a, b| a[1].total_cmp(&b[1]));
        let start = kept.len();
        for &mut at in chain {
            let mut before = kept[start..].iter().rev().take_while(|other| at[1] - other[1] <= gaps[1]);
            if !before.any(|other| (at[0] - other[0]).abs() <= gaps[0]) {
                kept.push(at);
            }
        }
    }
    kept.sort_unstable_by(order);
    kept
}

/// For each box the index of a box of its group: of those that are connected by boxes that touch each other, or are no
/// farther apart than the gaps.
#[inline]
pub(super) fn groups(boxes: &[Box2], gaps: [f64; 2]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_unstable_by(|&i, &j| boxes[i][0][0].total_cmp(&boxes[j][0][0]));
    let mut group: Vec<usize> = (0..boxes.len()).collect();
    // Those that have not ended below the first parameter of the next one.
    let mut open: Vec<usize> = Vec::new();
    for i in order {
        let next = boxes[i];
        open.retain(|&j| boxes[j][0][1] + gaps[0] >= next[0][0]);
        for &j in &open {
            let other = boxes[j][1];
            if next[1][0] <= other[1] + gaps[1] && other[0] <= next[1][1] + gaps[1] {
                let [a, b] = [i, j].map(|k| root(&mut group, k));
                group[a] = b;
            }
        }
        open.push(i);
    }
    for i in 0..group.len() {
        group[i] = root(&mut group, i);
    }
    group
}

/// The pairs of boxes that are no farther from each other than a distance, the smaller index first, of those that are
/// asked for; in their order. Boxes are compared in the order of their first sides.
#[inline]
pub(super) fn beside(
    boxes: &[Vec<[f64; 2]>],
    distance: f64,
    asked: impl Fn(usize, usize) -> bool,
) -> Vec<[usize; 2]> {
    let start = |k: usize| boxes[k].first().map_or(0.0, |side| side[0]);
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_unstable_by(|&i, &j| start(i).total_cmp(&start(j)));
    let mut found = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    for i in order {
        open.retain(|&j| boxes[j].first().is_none_or(|side| side[1] + distance >= start(i)));
        for &j in &open {
            let apart = |([a, b], [c, d]): (&[f64; 2], &[f64; 2])| (a - d).max(c - b) > distance;
            let [k, n] = [i.min(j), i.max(j)];
            if asked(k, n) && !boxes[i].iter().zip(&boxes[j]).any(apart) {
                found.push([k, n]);
            }
        }
        open.push(i);
    }
    found.sort_unstable();
    found
}

/// The box that stands for a group, which shortens the way to it.
#[inline]
fn root(group: &mut [usize], mut i: usize) -> usize {
    while group[i] != i {
        group[i] = group[group[i]];
        i = group[i];
    }
    i
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random(state: &mut u64) -> f64 {
        *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*state >> 40) as f64 % 64.0 - 32.0
    }

    fn touch(a: &Box2, b: &Box2, gaps: [f64; 2]) -> bool {
        (0..2).all(|c| a[c][0] <= b[c][1] + gaps[c] && b[c][0] <= a[c][1] + gaps[c])
    }

    /// The smallest index of each group, one pair after the other.
    fn one_by_one(boxes: &[Box2], gaps: [f64; 2]) -> Vec<usize> {
        let mut group: Vec<usize> = (0..boxes.len()).collect();
        for i in 0..boxes.len() {
            for j in 0..i {
                if touch(&boxes[i], &boxes[j], gaps) {
                    let (from, to) = (group[i].max(group[j]), group[i].min(group[j]));
                    group.iter_mut().filter(|g| **g == from).for_each(|g| *g = to);
                }
            }
        }
        group
    }

    #[test]
    fn groups_as_one_by_one() {
        let state = &mut 1;
        let mut several = 0;
        for round in 0..3000 {
            let size = if round % 2 == 0 { 0.125 } else { 0.03 };
            let list: Vec<Box2> = (0..round % 60)
                .map(|_| {
                    [(); 2].map(|()| {
                        let lo = random(state);
                        [lo, lo + size * (random(state) + 32.0)]
                    })
                })
                .collect();
            let found = groups(&list, [0.5, 0.0]);
            let smallest = |i: usize| (0..list.len()).find(|&j| found[j] == found[i]).unwrap();
            let found: Vec<usize> = (0..list.len()).map(smallest).collect();
            let expected = one_by_one(&list, [0.5, 0.0]);
            assert_eq!(found, expected);
            let count = expected.iter().enumerate().filter(|(i, g)| i == *g).count();
            several += usize::from(count > 1 && count < list.len());
        }
        assert!(several > 500, "{several}");
    }

    #[test]
    fn places_are_apart_and_beside_all() {
        let state = &mut 2;
        for count in 0..300 {
            let list: Vec<[f64; 2]> = (0..count).map(|_| [(); 2].map(|()| 0.25 * random(state))).collect();
            let gaps = [0.25, 0.5];
            let beside = |a: &[f64; 2], b: &[f64; 2]| (0..2).all(|c| (a[c] - b[c]).abs() <= gaps[c]);
            let kept = places(list.clone(), gaps);
            assert!(list.iter().all(|a| kept.iter().any(|b| beside(a, b))));
            assert!(kept.iter().enumerate().all(|(i, a)| !kept[..i].iter().any(|b| beside(a, b))));
            assert!(kept.windows(2).all(|pair| pair[0][0] <= pair[1][0]));
        }
    }
}
