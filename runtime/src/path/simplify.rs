//! Paths of fewer cubic segments within a tolerance.

use alloc::vec::Vec;

use super::approximate::deviation;
use super::{Path, PathSegment};
use crate::vector::{direction, distance, is_finite, largest_component};
use crate::{BernsteinBasis, CurveError, Fit, FitEnd, Point, Scalar};

/// How often a part is halved before it counts as too far away.
const DEPTH: usize = 12;

/// The most segments that one segment stands for.
const LONGEST: usize = 256;

/// Rounds of a fit that improve its parameters: at first, and where that is not enough.
const FEW: usize = 6;
const MANY: usize = 40;

/// By how many times the tolerance a fit may miss after the first rounds.
const HOPE: f64 = 8.0;

impl<P: Point> Path<P> {
    /// A path of fewer segments, polynomials of degree 3 at most: one passes along the other within the tolerance, so
    /// that no point of the one is farther from the other.
    ///
    /// From each joint that stays the next segment reaches as far as a cubic can follow the path, with the same ends and
    /// directions there; it is found by a fit, and the bound comes from Bernstein coefficients of the differences of parts.
    /// Joints at which the path turns sharply by more than the tolerance hides stay joints. Segments that cannot be joined
    /// stay, those of other kinds become cubics as in [`to_cubics`](Self::to_cubics).
    ///
    /// For points that were measured or traced, not a path to be kept, there is [`Fit::path_within`].
    ///
    /// ```
    /// use basis_runtime::{Bezier, ParametricCurve, Path};
    ///
    /// let arch = Bezier::from_points([[0.0, 0.0], [1.0, 3.0], [4.0, 3.0], [5.0_f64, 0.0]]);
    /// let mut pieces = Path::from_curve(&arch.subsegment(0.0..0.1)?);
    /// for k in 1..10 {
    ///     pieces.append(&arch.subsegment(f64::from(k) / 10.0..f64::from(k + 1) / 10.0)?);
    /// }
    /// assert_eq!(pieces.simplified(1e-4)?.segments().len(), 1);
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// As [`to_cubics`](Self::to_cubics).
    pub fn simplified(&self, tolerance: P::Scalar) -> Result<Self, CurveError> {
        if !(tolerance > P::Scalar::ZERO && tolerance.is_finite()) {
            return Err(CurveError::Tolerance { value: tolerance.to_f64() });
        }
        if !self.segments.iter().all(|s| s.control_points().iter().all(|&p| is_finite(p))) {
            return Err(CurveError::NotFinite);
        }
        let mut simple = Vec::new();
        let mut from = 0;
        while from < self.segments.len() {
            let rest = &self.segments[from..];
            // As far as the path does not jump by more than rounding errors.
            let meet = |pair: &&[PathSegment<P>]| {
                let [end, start] = [pair[0].end(), pair[1].start()];
                let size = largest_component(end).max(largest_component(start));
                distance(end, start) <= P::Scalar::of(64.0) * P::Scalar::EPSILON * size
            };
            let connected = 1 + rest.windows(2).take_while(meet).count();
            let most = connected.min(LONGEST);
            let (mut enough, mut found) = (1, None);
            let mut too_many = most + 1;
            let mut next = 2;
            while enough + 1 < too_many && next < too_many {
                match replacement(&rest[..next], tolerance) {
                    Some(segment) => (enough, found) = (next, Some(segment)),
                    None => too_many = next,
                }
                let ahead = if too_many > most { 2 * enough } else { usize::midpoint(enough, too_many) };
                next = ahead.clamp(enough + 1, most.max(enough + 1));
            }
            match found {
                Some(segment) => simple.push(segment),
                None => simple.extend(Self::from(rest[0].clone()).to_cubics(tolerance)?.segments),
            }
            from += enough;
        }
        Ok(Self { segments: simple })
    }
}

/// A cubic segment along a row of segments, if there is one within the tolerance.
fn replacement<P: Point>(run: &[PathSegment<P>], tolerance: P::Scalar) -> Option<PathSegment<P>> {
    let [first, .., last] = run else { return None };
    let slope = |segment: &PathSegment<P>, x: P::Scalar, sign: P::Scalar| {
        let mut derivatives = [P::Vector::zero(); 2];
        segment.derivatives_into(x, &mut derivatives);
        // Where the first control points coincide, the chord has the direction well enough.
        direction(derivatives[1]).or_else(|| {
            let inside = segment.eval(P::Scalar::of(1e-3) * (P::Scalar::ONE - x) + P::Scalar::of(0.999) * x);
            direction(inside.minus(segment.eval(x)).scale(sign))
        })
    };
    let ends = [
        FitEnd::Tangent(slope(first, P::Scalar::ZERO, P::Scalar::ONE)?),
        FitEnd::Tangent(slope(last, P::Scalar::ONE, -P::Scalar::ONE)?),
    ];
    let each = (24 / run.len()).max(3);
    let mut points = Vec::with_capacity(run.len() * each + 1);
    for segment in run {
        points
            .extend((0..each).map(|i| segment.eval(P::Scalar::from_usize(i) / P::Scalar::from_usize(each))));
    }
    points.push(last.end());
    let cubic = BernsteinBasis::<P::Scalar, 4>::default();
    let fitted = |rounds: usize| Fit::new(&points).ends(ends).orthogonal(rounds).curve(cubic).ok();
    // A few rounds tell whether all of them could be enough.
    let mut fit = fitted(FEW)?;
    if fit.largest > tolerance && fit.largest <= tolerance * P::Scalar::of(HOPE) {
        fit = fitted(MANY)?;
    }
    if fit.largest > tolerance {
        return None;
    }
    let found = PathSegment::trusted(fit.curve.control_points().to_vec(), Vec::new());
    let mut at = P::Scalar::ZERO;
    for (k, segment) in run.iter().enumerate() {
        let to = if k + 1 == run.len() {
            P::Scalar::ONE
        } else {
            beside(&found, segment.end(), [at, P::Scalar::ONE])
        };
        if !goes_along(segment, &found, [at, to], tolerance, DEPTH) {
            return None;
        }
        at = to;
    }
    Some(found)
}

/// Whether a segment and the part of a cubic between two parameters pass along each other within the tolerance.
fn goes_along<P: Point>(
    segment: &PathSegment<P>,
    cubic: &PathSegment<P>,
    [from, to]: [P::Scalar; 2],
    tolerance: P::Scalar,
    depth: usize,
) -> bool {
    let part = cubic.restricted(from, to);
    if deviation(segment, part.control_points()) <= tolerance {
        return true;
    }
    let half = P::Scalar::of(0.5);
    let middle = segment.eval(half);
    let at = beside(cubic, middle, [from, to]);
    let near = distance(cubic.eval(at), middle) <= tolerance;
    if depth == 0 || !near {
        return false;
    }
    let [before, after] = segment.split(half);
    goes_along(&before, cubic, [from, at], tolerance, depth - 1)
        && goes_along(&after, cubic, [at, to], tolerance, depth - 1)
}

/// The parameter between two others at which a segment is near a point: the best of some, made better by bisection.
fn beside<P: Point>(segment: &PathSegment<P>, point: P, [from, to]: [P::Scalar; 2]) -> P::Scalar {
    let away = |t: P::Scalar| distance(segment.eval(t), point);
    let place = |i: usize| from + (to - from) * (P::Scalar::from_usize(i) / P::Scalar::of(16.0));
    let mut best = from;
    let mut least = away(from);
    for t in (1..=16).map(place) {
        let there = away(t);
        if there < least {
            (best, least) = (t, there);
        }
    }
    let mut step = (to - from) / P::Scalar::of(32.0);
    for _ in 0..40 {
        let clamp = |t: P::Scalar| {
            if t < from {
                from
            } else if t > to {
                to
            } else {
                t
            }
        };
        let [before, after] = [clamp(best - step), clamp(best + step)];
        let (low, high) = (away(before), away(after));
        if low < least && low <= high {
            (best, least) = (before, low);
        } else if high < least {
            (best, least) = (after, high);
        } else {
            step = step * P::Scalar::of(0.5);
        }
    }
    best
}
