//! Arcs, circles, ellipses and polygons as paths.

use alloc::vec::Vec;

use super::{Path, PathSegment};
use crate::vector::recast;
use crate::{CurveError, Point, Scalar};

impl<P: Point> Path<P> {
    /// The straight lines from one point to the next.
    ///
    /// # Errors
    /// [`CurveError::Length`] for fewer than two points.
    pub fn polyline(points: &[P]) -> Result<Self, CurveError> {
        if points.len() < 2 {
            return Err(CurveError::Length { expected: 2, found: points.len() });
        }
        Ok(Self { segments: points.windows(2).map(|ends| PathSegment::line(ends[0], ends[1])).collect() })
    }

    /// The straight lines from one point to the next and from the last to the first.
    ///
    /// # Errors
    /// [`CurveError::Length`] for fewer than two points.
    pub fn polygon(points: &[P]) -> Result<Self, CurveError> {
        let mut path = Self::polyline(points)?;
        path.close();
        Ok(path)
    }

    /// The rectangle with these opposite corners, with sides along the first two axes, from the first corner along the
    /// first axis; other components are those of the first corner.
    pub fn rectangle([from, to]: [P; 2]) -> Self {
        const { assert!(P::DIM >= 2, "a rectangle has two dimensions") };
        let corner = |mixed: [P; 2]| {
            P::from_components(|d| if d < 2 { mixed[d].component(d) } else { from.component(d) })
        };
        let corners = [[from, from], [to, from], [to, to], [from, to]].map(corner);
        let sides = (0..4).map(|i| PathSegment::line(corners[i], corners[(i + 1) % 4]));
        Self { segments: sides.collect() }
    }

    /// The circle around a point in the plane of the first two axes, anticlockwise from its point on the first axis: four
    /// rational quadratic segments, exact.
    pub fn circle(centre: P, radius: P::Scalar) -> Self {
        let [x, y] = axes::<P::Vector>(radius, radius);
        Self::ellipse_arc(centre, [x, y], P::Scalar::ZERO, P::Scalar::PI * P::Scalar::of(2.0))
    }

    /// The arc of that circle from the angle `start`, in radians from the first axis, that turns by the angle `turn`,
    /// anticlockwise if it is positive: rational quadratic segments of at most a quarter of the circle each, exact.
    pub fn circle_arc(centre: P, radius: P::Scalar, start: P::Scalar, turn: P::Scalar) -> Self {
        Self::ellipse_arc(centre, axes::<P::Vector>(radius, radius), start, turn)
    }

    /// The ellipse around a point in the plane of the first two axes with these half axes, the first of them turned by
    /// an angle in radians, anticlockwise.
    pub fn ellipse(centre: P, radii: [P::Scalar; 2], rotation: P::Scalar) -> Self {
        const { assert!(P::DIM >= 2, "an ellipse has two dimensions") };
        let (sin, cos) = exact_sin_cos(rotation);
        let vector = |x: P::Scalar, y: P::Scalar| {
            P::Vector::from_components(|d| match d {
                0 => x,
                1 => y,
                _ => P::Scalar::ZERO,
            })
        };
        let axes = [vector(radii[0] * cos, radii[0] * sin), vector(-radii[1] * sin, radii[1] * cos)];
        Self::ellipse_arc(centre, axes, P::Scalar::ZERO, P::Scalar::PI * P::Scalar::of(2.0))
    }

    /// The arc `centre + cos α · axes[0] + sin α · axes[1]` from `α = start` to `start + turn`, in a space of any
    /// dimension: rational quadratic segments of at most a quarter of the ellipse each, exact. The two vectors need
    /// not be perpendicular. Turns by more than 2π, and NaN, count as a full turn.
    pub fn ellipse_arc(centre: P, axes: [P::Vector; 2], start: P::Scalar, turn: P::Scalar) -> Self {
        let axes = axes.map(recast::<_, P>);
        let full = P::Scalar::PI * P::Scalar::of(2.0);
        let closed = turn.abs() >= full || turn.is_nan();
        let turn = match closed {
            true if turn < P::Scalar::ZERO => -full,
            true => full,
            false => turn,
        };
        let quarters = turn.abs() / (P::Scalar::PI * P::Scalar::of(0.5));
        // A turn that is a quarter up to rounding is one.
        let slack = P::Scalar::ONE + P::Scalar::of(4.0) * P::Scalar::EPSILON;
        let count = (1..4).find(|&n| quarters <= P::Scalar::from_usize(n) * slack).unwrap_or(4);
        let half = turn / P::Scalar::from_usize(2 * count);
        let (_, weight) = half.sin_cos();
        let at = |halves: usize| {
            // A full turn ends where it begins.
            let halves = if closed && halves == 2 * count { 0 } else { halves };
            let (sin, cos) = exact_sin_cos(start + half * P::Scalar::from_usize(halves));
            let length = if halves % 2 == 1 { P::Scalar::ONE / weight } else { P::Scalar::ONE };
            centre.add_weighted(axes[0], cos * length).add_weighted(axes[1], sin * length)
        };
        let segment = |k: usize| {
            let weights = alloc::vec![P::Scalar::ONE, weight, P::Scalar::ONE];
            PathSegment::trusted([2 * k, 2 * k + 1, 2 * k + 2].map(at).to_vec(), weights)
        };
        Self { segments: (0..count).map(segment).collect::<Vec<_>>() }
    }
}

/// Vectors of these lengths along the first two axes.
fn axes<P: Point>(x: P::Scalar, y: P::Scalar) -> [P; 2] {
    const { assert!(P::DIM >= 2, "a circle has two dimensions") };
    let along = |axis: usize, length: P::Scalar| {
        P::from_components(|d| if d == axis { length } else { P::Scalar::ZERO })
    };
    [along(0, x), along(1, y)]
}

/// Sine and cosine, exact at multiples of a quarter turn up to the rounding of the angle.
fn exact_sin_cos<S: Scalar>(angle: S) -> (S, S) {
    let (sin, cos) = angle.sin_cos();
    let tiny = |x: S| x.abs() <= S::of(4.0) * S::EPSILON * (S::ONE + angle.abs());
    let sign = |x: S| if x < S::ZERO { -S::ONE } else { S::ONE };
    if tiny(sin) {
        (S::ZERO, sign(cos))
    } else if tiny(cos) {
        (sign(sin), S::ZERO)
    } else {
        (sin, cos)
    }
}
