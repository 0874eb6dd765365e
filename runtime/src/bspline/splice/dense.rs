//! Method (b): both rows by least squares over several samples in each span.

use alloc::vec::Vec;

use super::SpliceError;
use super::correct::correction;
use super::strip::{Strip, Vector};
use crate::Point;
use crate::bspline::KnotVector;
use crate::bspline::fit::Banded;

/// Moves the edge onto that of the target; the ends are met exactly, and their tangents. Otherwise tangents at the
/// ends, which count for the angle, would become worse when the spans there are divided.
pub(super) fn edge(strip: &mut Strip, target: &Strip) -> Result<Vec<Vector>, SpliceError> {
    let slopes = strip.knots.domain().map(|t| target.at(t).tangent.minus(strip.at(t).tangent));
    let change = fit(&strip.knots, |t| Ok(target.at(t).point.minus(strip.at(t).point)), Some(slopes))?;
    for (point, change) in strip.edge.iter_mut().zip(&change) {
        *point = point.add_weighted(*change, 1.0);
    }
    Ok(change)
}

/// Turns the second row into the tangent planes of the target.
pub(super) fn inner(strip: &mut Strip, target: &Strip) -> Result<(), SpliceError> {
    let change = fit(&strip.knots, |t| correction(strip, target, t), None)?;
    for (point, change) in strip.inner.iter_mut().zip(&change) {
        *point = point.add_weighted(*change, 1.0);
    }
    Ok(())
}

/// The control points over clamped knots of the spline nearest to `wanted`, equal to it at both ends, and with the
/// given derivatives there if there are enough of them.
pub(in crate::bspline) fn fit(
    knots: &KnotVector<f64>,
    mut wanted: impl FnMut(f64) -> Result<Vector, SpliceError>,
    slopes: Option<[Vector; 2]>,
) -> Result<Vec<Vector>, SpliceError> {
    let (k, n, all) = (knots.degree(), knots.functions(), knots.as_slice());
    let [lo, hi] = knots.domain();
    let mut points = alloc::vec![[0.0; 3]; n];
    (points[0], points[n - 1]) = (wanted(lo)?, wanted(hi)?);
    if n <= 2 {
        return Ok(points);
    }
    // The number of control points that are known at each end.
    let mut held = 1;
    if let Some([start, end]) = slopes
        && n > 4
    {
        // C' = k (P[1] - P[0]) / (t[k+1] - t[1]) at the start.
        points[1] = points[0].add_weighted(start, (all[k + 1] - lo) / k as f64);
        points[n - 2] = points[n - 1].add_weighted(end, (all[n - 1] - hi) / k as f64);
        held = 2;
    }
    let samples = (k + 2).max(6);
    let mut system = Banded::new(n - 2 * held, k + 1, 3);
    for span in knots.spans() {
        for i in 0..samples {
            let t = all[span] + (all[span + 1] - all[span]) * ((i as f64 + 0.5) / samples as f64);
            let mut right = wanted(t)?;
            let values = knots.values_on(span, t);
            let first = span - k;
            let (mut factors, mut start) = (Vec::with_capacity(k + 1), first.saturating_sub(held));
            for (j, &value) in values.iter().enumerate() {
                let index = first + j;
                if index < held || index >= n - held {
                    right = right.add_weighted(points[index], -value);
                } else {
                    factors.push(value);
                }
            }
            start = start.min(n - 2 * held);
            system.add(start, &mut factors, &mut right);
        }
    }
    let solution = system.solve().map_err(|_| SpliceError::Singular)?;
    for (point, found) in points[held..n - held].iter_mut().zip(solution.chunks_exact(3)) {
        *point = [found[0], found[1], found[2]];
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use super::fit;
    use crate::Point;
    use crate::bspline::{BSplineCurve, KnotVector};
    use crate::vector::length;

    #[test]
    fn a_spline_of_the_space_is_reproduced() {
        for degree in 1..=6 {
            for times in 1..=degree {
                let mut breakpoints = alloc::vec![0.0];
                for t in [0.13, 0.4, 0.47, 0.9] {
                    breakpoints.extend(core::iter::repeat_n(t, times));
                }
                breakpoints.push(1.0);
                let knots = KnotVector::clamped(degree, &breakpoints).unwrap();
                let wave = |i: usize| (i * i % 7) as f64;
                let points: alloc::vec::Vec<_> =
                    (0..knots.functions()).map(|i| [i as f64, wave(i), wave(i + 2)]).collect();
                let curve = BSplineCurve::new(knots.clone(), points.clone()).unwrap();
                for slopes in [None, Some([0.0, 1.0].map(|t| curve.derivative(t, 1)))] {
                    let found = fit(&knots, |t| Ok(curve.eval(t)), slopes).unwrap();
                    for (a, b) in found.iter().zip(&points) {
                        assert!(length(a.minus(*b)) < 1e-11, "degree {degree}, {times} times: {a:?} {b:?}");
                    }
                }
            }
        }
    }
}
