//! Knot insertion: the same spline over more knots.
//!
//! Source: W. Boehm, *Inserting new knots into B-spline curves*, Computer-Aided Design 12 (1980). A list of knots is
//! inserted in one sweep, in time proportional to the size of the net and of the list.

use alloc::borrow::Cow;
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
    let inserted = &*in_order(knots, inserted)?;
    if let (1, &[t]) = (lanes, inserted) {
        return insert_one(knots, points, t);
    }
    match (lanes, knots.degree()) {
        (1, 1) => insert_points::<P, 2>(knots, points, inserted),
        (1, 2) => insert_points::<P, 3>(knots, points, inserted),
        (1, 3) => insert_points::<P, 4>(knots, points, inserted),
        (1, 4) => insert_points::<P, 5>(knots, points, inserted),
        (1, 5) => insert_points::<P, 6>(knots, points, inserted),
        _ => insert_rows(knots, points, lanes, inserted),
    }
}

/// One knot into a curve.
fn insert_one<P: Point>(
    knots: &KnotVector<P::Scalar>,
    points: &[P],
    t: P::Scalar,
) -> Result<Rows<P::Scalar, P>, KnotError> {
    let (k, old) = (knots.degree(), knots.as_slice());
    let next = old.partition_point(|&knot| knot <= t);
    if old[next - k - 1] == t {
        return Err(too_often(&old[..next], &[t], 0, k));
    }
    let mut out = Vec::with_capacity(points.len() + 1);
    let mut done = next - k; // points before this one stay
    out.extend_from_slice(&points[..done]);
    while done < next && old[done] < t {
        let alpha = (t - old[done]) / (old[done + k] - old[done]);
        out.push(between(points[done - 1], points[done], alpha));
        done += 1;
    }
    out.extend_from_slice(&points[done - 1..]);
    let mut all = Vec::with_capacity(old.len() + 1);
    all.extend_from_slice(&old[..next]);
    all.push(t);
    all.extend_from_slice(&old[next..]);
    Ok(Rows { knots: KnotVector::trusted(k, all), points: out, lanes: 1 })
}

/// The same for the points of a curve: only the `N = k + 1` of them over the span of the next knot can still change.
fn insert_points<P: Point, const N: usize>(
    knots: &KnotVector<P::Scalar>,
    points: &[P],
    inserted: &[P::Scalar],
) -> Result<Rows<P::Scalar, P>, KnotError> {
    let (k, old) = (N - 1, knots.as_slice());
    let count = points.len() + inserted.len();
    let mut head = Vec::with_capacity(old.len() + inserted.len());
    let mut out: Vec<P> = Vec::with_capacity(count + N);
    // Where an end of the domain is inserted the window reaches beyond the last point; what stands there is cut off.
    let point = |index: usize| points[index.min(points.len() - 1)];
    let mut window = [points[0]; N];
    let mut next = 0; // the number of old knots, and of points, that are taken
    for (index, &t) in inserted.iter().enumerate() {
        let before = next;
        next += match index {
            0 => old.partition_point(|&knot| knot <= t),
            _ => old[next..].iter().take_while(|&&knot| knot <= t).count(),
        };
        if index == 0 || next - before >= N {
            if index > 0 {
                out.extend_from_slice(&window);
            }
            head.extend_from_slice(&old[before..next]);
            out.extend_from_slice(&points[before..next - N]);
            window = core::array::from_fn(|j| point(next - N + j));
        } else {
            // A few, one by one, which is faster than calls that copy.
            for (taken, &knot) in (before..next).zip(&old[before..next]) {
                head.push(knot);
                out.push(window[0]);
                for j in 1..N {
                    window[j - 1] = window[j];
                }
                window[k] = point(taken);
            }
        }
        let starts = &head[head.len() - N..];
        if starts[0] == t {
            return Err(too_often(&head, inserted, index, k));
        }
        out.push(window[0]);
        // Where equal knots stand before it, a mean is the point that is there.
        for (j, (&start, &end)) in starts[1..].iter().zip(&old[next..]).enumerate() {
            if start < t {
                window[j] = between(window[j], window[j + 1], (t - start) / (end - start));
            }
        }
        head.push(t);
    }
    if !inserted.is_empty() {
        out.extend_from_slice(&window);
    }
    head.extend_from_slice(&old[next..]);
    out.extend_from_slice(points.get(next..).unwrap_or_default());
    out.truncate(count);
    Ok(Rows { knots: KnotVector::trusted(k, head), points: out, lanes: 1 })
}

/// The error of a knot that would occur more than `k + 1` times, after those of `head`.
fn too_often<S: Scalar>(head: &[S], inserted: &[S], index: usize, k: usize) -> KnotError {
    let knot = inserted[index];
    let equal = |&&other: &&S| other == knot;
    let multiplicity =
        head.iter().rev().take_while(equal).count() + inserted[index..].iter().take_while(equal).count();
    KnotError::Multiplicity { knot: knot.to_f64(), multiplicity, degree: k }
}

/// The same for rows of several points.
fn insert_rows<P: Point>(
    knots: &KnotVector<P::Scalar>,
    points: &[P],
    lanes: usize,
    inserted: &[P::Scalar],
) -> Result<Rows<P::Scalar, P>, KnotError> {
    let (k, mut old) = (knots.degree(), knots.as_slice());

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
            return Err(too_often(&head, inserted, index, k));
        }
        // Rows below - 1 and before it are those whose functions begin before t.
        let (missing, later) = rest.split_at((below * lanes).saturating_sub(head_points.len()));
        head_points.extend_from_slice(missing);
        rest = later;

        // The last of these rows is doubled; rows that earlier equal knots left behind it move up.
        let first = head.len() - k; // μ - k + 1
        let end = head_points.len();
        head_points.extend_from_within(end - lanes..);
        head_points.copy_within((below - 1) * lanes..end, below * lanes);
        blend(&mut head_points[(first - 1) * lanes..], lanes, t, &head[first..below], old);
        head.push(t);
    }
    head.extend_from_slice(old);
    head_points.extend_from_slice(rest);
    Ok(Rows { knots: KnotVector::trusted(k, head), points: head_points, lanes })
}

/// Replaces the row `i + 1` by a mean of it and the row before it, for each pair of knots `t[i]`, `t[i+k]`.
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
fn in_order<'a, S: Scalar>(knots: &KnotVector<S>, inserted: &'a [S]) -> Result<Cow<'a, [S]>, KnotError> {
    for &knot in inserted {
        knots.check(knot)?;
    }
    let mut sorted = Cow::Borrowed(inserted);
    if !inserted.is_sorted() {
        sorted.to_mut().sort_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal)); // none is NaN
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
