//! Knot removal: fewer knots where the spline hardly changes.
//!
//! Source: W. Tiller, *Knot-removal algorithms for NURBS curves and surfaces*, Computer-Aided Design 24 (1992), for the
//! points. The change is not estimated but bounded: the removed knots are inserted again and the nets compared.

use alloc::vec::Vec;

use super::{Rows, insert};
use crate::bspline::{KnotError, KnotVector};
use crate::vector::length;
use crate::{Point, Scalar};

/// Removes an inner knot up to `times` times, as long as each control point may become what it then is; also says how
/// often it was removed.
pub(in crate::bspline) fn remove<P: Point>(
    rows: &Rows<P::Scalar, P>,
    knot: P::Scalar,
    times: usize,
    may_become: impl Fn(P, P) -> bool,
) -> Result<(Rows<P::Scalar, P>, usize), KnotError> {
    let [lo, hi] = rows.knots.domain();
    let multiplicity = rows.knots.multiplicity(knot);
    if multiplicity == 0 || knot <= lo || knot >= hi {
        return Err(KnotError::NoInnerKnot { parameter: knot.to_f64() });
    }
    let mut best = rows.clone();
    let mut copies = Vec::new();
    for removed in 0..times.min(multiplicity) {
        let fewer = remove_once(&best, knot);
        copies.push(knot);
        let again = insert(&fewer, &copies)?;
        if !rows.points.iter().zip(&again.points).all(|(&before, &after)| may_become(before, after)) {
            return Ok((best, removed));
        }
        best = fewer;
    }
    Ok((best, times.min(multiplicity)))
}

/// Whether a control point moves by at most `tolerance`: the basis functions are not negative and sum to 1, so no point
/// of the spline moves further than a control point.
pub(in crate::bspline) fn within<P: Point>(tolerance: P::Scalar) -> impl Fn(P, P) -> bool {
    move |before, after| length(after.minus(before)) <= tolerance
}

/// Solves the equations of [`insert`] for the rows before, from both sides towards the middle. There is one equation
/// more than unknown rows; the one in the middle is left out.
fn remove_once<P: Point>(rows: &Rows<P::Scalar, P>, knot: P::Scalar) -> Rows<P::Scalar, P> {
    let Rows { knots, points, lanes } = rows;
    let (k, lanes) = (knots.degree(), *lanes);
    let t = knots.as_slice();
    let last = t.partition_point(|&other| other <= knot) - 1;
    let multiplicity = knots.multiplicity(knot);
    // Before the removal P[i] = (1 - α_i) Q[i-1] + α_i Q[i] for first <= i <= end; all others are only renumbered.
    let (first, end) = (last - k, last - multiplicity);
    let alpha = |i: usize| (knot - t[i]) / (t[i + k + 1] - t[i]);
    let mut new: Vec<P> = points.clone();
    // new[i] holds Q[i] on the left side and Q[i - 1] on the right side.
    let (mut left, mut right) = (first, end);
    while left < right {
        let (a, b) = (alpha(left), alpha(right));
        for lane in 0..lanes {
            let (here, before) = (left * lanes + lane, (left - 1) * lanes + lane);
            new[here] = new[before].add_scaled(points[here].minus(new[before]), P::Scalar::ONE / a);
        }
        left += 1;
        if left < right {
            for lane in 0..lanes {
                let (here, after) = (right * lanes + lane, (right + 1) * lanes + lane);
                let back = P::Scalar::ONE / (P::Scalar::ONE - b);
                new[here] = new[after].add_scaled(points[here].minus(new[after]), back);
            }
            right -= 1;
        }
    }
    // The row in the middle has no unknown of its own. (At multiplicity k + 1 there is no equation, and one of the two
    // rows that meet at the knot is dropped.)
    new.drain(left * lanes..(left + 1) * lanes);
    let mut fewer = t.to_vec();
    fewer.remove(last);
    Rows { knots: KnotVector::trusted(k, fewer), points: new, lanes }
}
