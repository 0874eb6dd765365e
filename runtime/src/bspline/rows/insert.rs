//! Knot insertion: the same spline over more knots.
//!
//! Source: W. Boehm, *Inserting new knots into B-spline curves*, Computer-Aided Design 12 (1980). A list of knots is
//! inserted in one sweep, in time proportional to the size of the net and of the list.

use alloc::vec::Vec;

use super::{Rows, between};
use crate::bspline::{KnotError, KnotVector};
use crate::{Point, Scalar};

/// The same rows over the knots and all of `inserted`, in any order.
///
/// Inserting `t` into `t[μ] <= t < t[μ+1]` replaces `P[i]`, for `μ - k < i <= μ - s`, by
///
/// ```text
/// (1 - α) P[i-1] + α P[i],    α = (t - t[i]) / (t[i+k] - t[i]),
/// ```
///
/// where `s` is the multiplicity that `t` had; the points after those move up by one.
pub(in crate::bspline) fn insert<P: Point>(
    rows: &Rows<P::Scalar, P>,
    inserted: &[P::Scalar],
) -> Result<Rows<P::Scalar, P>, KnotError> {
    let Rows { knots, points, lanes } = rows;
    let (k, lanes, old) = (knots.degree(), *lanes, knots.as_slice());
    let inserted = checked(knots, inserted)?;

    // Both lists are split where the work is done: `head…` is new, the rest of the old list follows at `next…`.
    let mut head = Vec::with_capacity(old.len() + inserted.len());
    let mut next = 0;
    let mut head_points: Vec<P> = Vec::with_capacity(points.len() + inserted.len() * lanes);
    let mut next_point = 0;

    for t in inserted {
        while next < old.len() && old[next] <= t {
            head.push(old[next]);
            next += 1;
        }
        let below = head.partition_point(|&knot| knot < t);
        // Rows below - 1 and before it are those whose functions begin before t.
        let missing = (below * lanes).saturating_sub(head_points.len());
        head_points.extend_from_slice(&points[next_point..next_point + missing]);
        next_point += missing;
        debug_assert!(below > 0 && head_points.len() >= below * lanes);

        let knot = |i: usize| if i < head.len() { head[i] } else { old[next + i - head.len()] };
        let first = head.len() - k; // μ - k + 1
        // The last of these rows is doubled; rows that earlier equal knots left behind it move up.
        let tail = head_points.split_off(below * lanes);
        head_points.extend_from_within((below - 1) * lanes..);
        head_points.extend_from_slice(&tail);
        for i in (first..below).rev() {
            let alpha = (t - knot(i)) / (knot(i + k) - knot(i));
            for lane in i * lanes..(i + 1) * lanes {
                head_points[lane] = between(head_points[lane - lanes], head_points[lane], alpha);
            }
        }
        head.push(t);
    }
    head.extend_from_slice(&old[next..]);
    head_points.extend_from_slice(&points[next_point..]);
    Ok(Rows { knots: KnotVector::trusted(k, head), points: head_points, lanes })
}

/// The knots in increasing order, if each may be inserted.
fn checked<S: Scalar>(knots: &KnotVector<S>, inserted: &[S]) -> Result<Vec<S>, KnotError> {
    let mut sorted = Vec::with_capacity(inserted.len());
    for &knot in inserted {
        sorted.push(knots.check(knot)?);
    }
    sorted.sort_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal)); // none is NaN
    for group in sorted.chunk_by(|a, b| a == b) {
        let multiplicity = knots.multiplicity(group[0]) + group.len();
        if multiplicity > knots.degree() + 1 {
            let (knot, degree) = (group[0].to_f64(), knots.degree());
            return Err(KnotError::Multiplicity { knot, multiplicity, degree });
        }
    }
    Ok(sorted)
}

/// The same rows over a clamped knot vector.
pub(in crate::bspline) fn clamp<P: Point>(rows: &Rows<P::Scalar, P>) -> Rows<P::Scalar, P> {
    if rows.knots.is_clamped() {
        return rows.clone();
    }
    let full = rows.knots.degree() + 1;
    let ends = rows.knots.domain().into_iter();
    let inserted: Vec<_> =
        ends.flat_map(|end| core::iter::repeat_n(end, full - rows.knots.multiplicity(end))).collect();
    let Ok(Rows { knots, points, lanes }) = insert(rows, &inserted) else {
        return rows.clone(); // not reached: the ends are in the domain, and no multiplicity exceeds k + 1
    };
    let [lo, hi] = knots.domain();
    let all = knots.as_slice();
    let (from, to) = (all.partition_point(|&t| t < lo), all.partition_point(|&t| t <= hi));
    Rows {
        knots: KnotVector::trusted(full - 1, all[from..to].to_vec()),
        points: points[from * lanes..(to - full) * lanes].to_vec(),
        lanes,
    }
}
