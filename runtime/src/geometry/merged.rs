//! Answers that are one: places of two parameters that are beside each other, and boxes that touch, found in sorted
//! order.

use alloc::collections::{BTreeMap, BTreeSet};
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

/// The boxes that are left when those that touch each other, or are no farther apart than the gaps, are replaced by the
/// smallest one around them; in the order of the first parameter.
#[inline]
pub(super) fn boxes(mut boxes: Vec<Box2>, gaps: [f64; 2]) -> Vec<Box2> {
    // One that has grown may touch one that ended before, which the next round sees.
    while boxes.len() > 1 {
        let count = boxes.len();
        boxes = round(boxes, gaps);
        if boxes.len() == count {
            break;
        }
    }
    boxes
}

/// From the lowest first parameter up. The boxes at one first parameter do not touch each other, so they are apart in
/// the second one, and sorted by it.
#[inline]
fn round(mut boxes: Vec<Box2>, gaps: [f64; 2]) -> Vec<Box2> {
    boxes.sort_unstable_by(|a, b| a[0][0].total_cmp(&b[0][0]).then(a[1][0].total_cmp(&b[1][0])));
    let mut done = Vec::with_capacity(boxes.len());
    let mut open: BTreeMap<i64, Box2> = BTreeMap::new();
    // Where the open ones end; some of these are parts of others by then.
    let mut ends: BTreeSet<(i64, i64)> = BTreeSet::new();
    for mut next in boxes {
        while let Some(&(end, start)) = ends.first() {
            let ended = open.get(&start).filter(|other| key(other[0][1]) == end);
            if let Some(&other) = ended {
                if next[0][0] <= other[0][1] + gaps[0] {
                    break;
                }
                done.push(other);
                open.remove(&start);
            }
            ends.pop_first();
        }
        // The last one that does not begin above it is the only one that it can touch first.
        while let Some((&start, &other)) = open.range(..=key(next[1][1] + gaps[1])).next_back() {
            if next[1][0] > other[1][1] + gaps[1] {
                break;
            }
            open.remove(&start);
            for (side, other) in next.iter_mut().zip(other) {
                *side = [side[0].min(other[0]), side[1].max(other[1])];
            }
        }
        ends.insert((key(next[0][1]), key(next[1][0])));
        open.insert(key(next[1][0]), next);
    }
    done.extend(open.into_values());
    done.sort_unstable_by(|a, b| a[0][0].total_cmp(&b[0][0]).then(a[1][0].total_cmp(&b[1][0])));
    done
}

/// A number of the order of a float, that of `total_cmp`; both zeros have the same.
#[inline]
fn key(x: f64) -> i64 {
    let bits = (x + 0.0).to_bits().cast_signed();
    bits ^ ((bits >> 63).cast_unsigned() >> 1).cast_signed()
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

    /// Any two that touch, until there are no such two.
    fn one_by_one(mut boxes: Vec<Box2>, gaps: [f64; 2]) -> Vec<Box2> {
        'again: loop {
            for i in 0..boxes.len() {
                for j in 0..i {
                    if touch(&boxes[i], &boxes[j], gaps) {
                        let other = boxes.swap_remove(i);
                        for (side, other) in boxes[j].iter_mut().zip(other) {
                            *side = [side[0].min(other[0]), side[1].max(other[1])];
                        }
                        continue 'again;
                    }
                }
            }
            boxes.sort_by(|a, b| a[0][0].total_cmp(&b[0][0]).then(a[1][0].total_cmp(&b[1][0])));
            return boxes;
        }
    }

    #[test]
    fn boxes_as_one_by_one() {
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
            let merged = boxes(list.clone(), [0.5, 0.0]);
            several += usize::from(merged.len() > 1 && merged.len() < list.len());
            assert_eq!(merged, one_by_one(list, [0.5, 0.0]));
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
