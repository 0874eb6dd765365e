//! Knot insertion: the same spline over more knots.
//!
//! Source: W. Boehm, *Inserting new knots into B-spline curves*, Computer-Aided Design 12 (1980). A list of knots is
//! inserted in one sweep, in time proportional to the size of the net and of the list.

use alloc::vec::Vec;

use super::{Rows, between};
use crate::bspline::{KnotError, KnotVector};
use crate::{Point, Scalar};

/// The same rows over the knots and all of `inserted`, in any order.
pub(in crate::bspline) fn insert<P: Point>(
    rows: &Rows<P::Scalar, P>,
    inserted: &[P::Scalar],
) -> Result<Rows<P::Scalar, P>, KnotError> {
    insert_into(&rows.knots, &rows.points, rows.lanes, inserted)
}

/// The same for rows that are borrowed: `lanes` points for each basis function.
///
/// Inserting `t` into `t[μ] <= t < t[μ+1]` replaces `P[i]`, for `μ - k < i <= μ - s`, by
///
/// ```text
/// (1 - α) P[i-1] + α P[i],    α = (t - t[i]) / (t[i+k] - t[i]),
/// ```
///
/// where `s` is the multiplicity that `t` had; the points after those move up by one.
pub(in crate::bspline) fn insert_into<P: Point>(
    knots: &KnotVector<P::Scalar>,
    points: &[P],
    lanes: usize,
    inserted: &[P::Scalar],
) -> Result<Rows<P::Scalar, P>, KnotError> {
    let (k, mut old) = (knots.degree(), knots.as_slice());
    let inserted = in_order(knots, inserted)?;

    // Both lists are split where the work is done: `head…` is new, what follows is the rest of the old list.
    let mut head = Vec::with_capacity(old.len() + inserted.len());
    let mut rest = points;
    let mut head_points: Vec<P> = Vec::with_capacity(points.len() + inserted.len() * lanes);
    let mut below = 0; // the number of knots below t

    for (index, &t) in inserted.iter().enumerate() {
        if index == 0 || inserted[index - 1] < t {
            advance(&mut head, &mut old, |knot| knot < t);
            below = head.len();
            advance(&mut head, &mut old, |knot| knot == t);
        }
        if head.len() - below > k {
            let multiplicity =
                head.len() - below + inserted[index..].iter().take_while(|&&other| other == t).count();
            return Err(KnotError::Multiplicity { knot: t.to_f64(), multiplicity, degree: k });
        }
        // Rows below - 1 and before it are those whose functions begin before t.
        let (missing, later) = rest.split_at((below * lanes).saturating_sub(head_points.len()));
        head_points.extend_from_slice(missing);
        rest = later;

        // The last of these rows is doubled; rows that earlier equal knots left behind it move up.
        let first = head.len() - k; // μ - k + 1
        if lanes == 1 {
            head_points.insert(below, head_points[below - 1]);
            blend(&mut head_points[first - 1..], 1, t, &head[first..below], old);
        } else {
            let end = head_points.len();
            head_points.extend_from_within(end - lanes..);
            head_points.copy_within((below - 1) * lanes..end, below * lanes);
            blend(&mut head_points[(first - 1) * lanes..], lanes, t, &head[first..below], old);
        }
        head.push(t);
    }
    head.extend_from_slice(old);
    head_points.extend_from_slice(rest);
    Ok(Rows { knots: KnotVector::trusted(k, head), points: head_points, lanes })
}

/// Replaces the row `i + 1` by a mean of it and the row before it, for each pair of knots `t[i]`, `t[i+k]`.
#[inline(always)]
#[allow(clippy::inline_always)] // only then is there nothing left of the lanes of a curve
fn blend<P: Point>(rows: &mut [P], lanes: usize, t: P::Scalar, starts: &[P::Scalar], ends: &[P::Scalar]) {
    for (i, (&start, &end)) in starts.iter().zip(ends).enumerate().rev() {
        let alpha = (t - start) / (end - start);
        let (before, here) = rows[i * lanes..(i + 2) * lanes].split_at_mut(lanes);
        for (point, &before) in here.iter_mut().zip(&*before) {
            *point = between(before, *point, alpha);
        }
    }
}

/// Moves the knots at the front of `old` for which that holds to the end of `head`.
#[inline]
fn advance<S: Scalar>(head: &mut Vec<S>, old: &mut &[S], moves: impl Fn(S) -> bool) {
    let count = old.iter().position(|&knot| !moves(knot)).unwrap_or(old.len());
    let (moved, rest) = old.split_at(count);
    head.extend_from_slice(moved);
    *old = rest;
}

/// The knots in increasing order, if all are in the domain.
fn in_order<S: Scalar>(knots: &KnotVector<S>, inserted: &[S]) -> Result<Vec<S>, KnotError> {
    let mut sorted = Vec::with_capacity(inserted.len());
    for &knot in inserted {
        sorted.push(knots.check(knot)?);
    }
    if !sorted.is_sorted() {
        sorted.sort_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal)); // none is NaN
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
