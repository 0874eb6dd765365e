//! Degree elevation: the same spline as one of the next degree.
//!
//! Source: H. Prautzsch, *Degree elevation of B-spline curves*, Computer Aided Geometric Design 1 (1984). It consists
//! of knot insertions and one mean, so it is as stable as they are.

use alloc::vec::Vec;

use super::{Rows, clamp, insert};
use crate::bspline::{KnotError, KnotVector, MAX_DEGREE};
use crate::{Point, Scalar};

/// The same rows, of a degree that is higher by one, over a clamped vector in which each knot occurs once more.
pub(in crate::bspline) fn elevate<P: Point>(
    rows: &Rows<P::Scalar, P>,
) -> Result<Rows<P::Scalar, P>, KnotError> {
    let degree = rows.knots.degree() + 1;
    if degree > MAX_DEGREE {
        return Err(KnotError::Degree { degree });
    }
    // At a knot of multiplicity k + 1 the spline may jump: the parts between such knots are elevated one by one.
    let Rows { knots: clamped, points: all, lanes } = clamp(rows);
    let (mut knots, mut points): (Vec<P::Scalar>, _) = (Vec::new(), Vec::new());
    let (mut first, mut below) = (0, 0);
    for group in clamped.as_slice().chunk_by(|a, b| a == b) {
        let above = below + group.len();
        if below > 0 && group.len() == degree {
            let part = Rows {
                knots: KnotVector::trusted(degree - 1, clamped.as_slice()[first..above].to_vec()),
                points: all[first * lanes..below * lanes].to_vec(),
                lanes,
            };
            append(&mut knots, &mut points, &connected(&part)?);
            first = below;
        }
        below = above;
    }
    Ok(Rows { knots: KnotVector::trusted(degree, knots), points, lanes })
}

/// Adds a part behind the ones before it; they share `degree + 1` equal knots.
fn append<S: Scalar, P: Point<Scalar = S>>(knots: &mut Vec<S>, points: &mut Vec<P>, part: &Rows<S, P>) {
    let shared = if knots.is_empty() { 0 } else { part.knots.degree() + 1 };
    knots.extend_from_slice(&part.knots.as_slice()[shared..]);
    points.extend_from_slice(&part.points);
}

/// Elevates rows over a clamped vector whose inner knots have multiplicities up to k.
///
/// Let `τ` be the knots with each multiplicity raised by one. For `j = 0, …, k` leave out of `τ` every `(k+1)`-th knot,
/// beginning with the `j`-th: no knot is left out twice, so the spline has control points over what remains. Of the
/// knots `τ[i+1], …, τ[i+k+1]` one is left out each time, and
///
/// ```text
/// Q[i] = 1/(k+1) Σ_j (the control point that belongs to those of these knots that remain).
/// ```
fn connected<P: Point>(rows: &Rows<P::Scalar, P>) -> Result<Rows<P::Scalar, P>, KnotError> {
    let (k, lanes) = (rows.knots.degree(), rows.lanes);
    let raised: Vec<_> = rows
        .knots
        .as_slice()
        .chunk_by(|a, b| a == b)
        .flat_map(|group| core::iter::repeat_n(group[0], group.len() + 1))
        .collect();
    let knots = KnotVector::trusted(k + 1, raised);
    // The outermost knot at each end belongs to no control point.
    let inner = &knots.as_slice()[1..knots.as_slice().len() - 1];
    let count = knots.functions();
    let mut means = Vec::with_capacity(count * lanes);
    let share = P::Scalar::ONE / P::Scalar::from_usize(k + 1);
    for left_out in 0..=k {
        let remains = |index: &usize| index % (k + 1) != left_out;
        let wanted: Vec<_> = (0..inner.len()).filter(remains).map(|index| inner[index]).collect();
        let mut added = Vec::new();
        for group in wanted.chunk_by(|a, b| a == b) {
            let have = rows.knots.multiplicity(group[0]);
            added.extend(core::iter::repeat_n(group[0], group.len().saturating_sub(have)));
        }
        let refined = insert(rows, &added)?;
        for i in 0..count {
            // The number of inner[..i] that remain; the control point with the knots after them has that index.
            let index = i - (i + k - left_out) / (k + 1);
            for (lane, point) in refined.row(index).iter().enumerate() {
                if left_out == 0 {
                    means.push((*point, P::zero()));
                } else {
                    // Differences from the first point: the mean of equal points is that point, exactly.
                    let (first, sum) = &mut means[i * lanes + lane];
                    *sum = sum.add_scaled(point.minus(*first), P::Scalar::ONE);
                }
            }
        }
    }
    let points = means.iter().map(|(first, sum)| first.add_weighted(*sum, share)).collect();
    Ok(Rows { knots, points, lanes })
}
