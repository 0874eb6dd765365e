//! Linear equations for points.

use alloc::vec::Vec;

use crate::vector::{is_finite, largest_component};
use crate::{Point, Scalar};

/// Solves linear equations by elimination with the largest pivots; unknowns that do not matter are zero. `None` if
/// there is no solution, up to rounding errors of points of that size.
pub(crate) fn solve<P: Point>(
    system: &mut [(Vec<P::Scalar>, P)],
    unknowns: usize,
    size: P::Scalar,
) -> Option<Vec<P>> {
    let noise = P::Scalar::EPSILON * P::Scalar::from_usize(64 * (unknowns + 1));
    let mut solved: Vec<usize> = Vec::new();
    while solved.len() < system.len() {
        let first = solved.len();
        let entries = (first..system.len()).flat_map(|row| (0..unknowns).map(move |column| (row, column)));
        let entry = |(row, column): (usize, usize)| system[row].0[column].abs();
        let Some(pivot) = entries.reduce(|a, b| if entry(b) > entry(a) { b } else { a }) else { break };
        if entry(pivot) <= noise {
            break;
        }
        system.swap(first, pivot.0);
        let column = pivot.1;
        let (head, rest) = system.split_at_mut(first + 1);
        let (row, right) = &head[first];
        for (other, target) in rest {
            let factor = other[column] / row[column];
            if factor != P::Scalar::ZERO {
                for (a, &b) in other.iter_mut().zip(row) {
                    *a = *a - factor * b;
                }
                other[column] = P::Scalar::ZERO;
                *target = target.add_weighted(*right, -factor);
            }
        }
        solved.push(column);
    }
    let left_over = &system[solved.len()..];
    if !left_over.iter().all(|(_, target)| largest_component(*target) <= noise * size * P::Scalar::of(16.0)) {
        return None;
    }
    let mut changes = alloc::vec![P::zero(); unknowns];
    for (k, &column) in solved.iter().enumerate().rev() {
        let (row, right) = &system[k];
        let mut value = *right;
        for &later in &solved[k + 1..] {
            value = value.add_weighted(changes[later], -row[later]);
        }
        changes[column] = P::from_components(|c| value.component(c) / row[column]);
    }
    changes.iter().all(|&change| is_finite(change)).then_some(changes)
}
