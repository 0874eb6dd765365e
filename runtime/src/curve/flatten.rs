//! Polygons that follow a curve within a tolerance.

use alloc::vec::Vec;

use crate::vector::{distance, dot, is_finite, length};
use crate::{Basis, Curve, CurveError, Point, Scalar, bernstein};

/// More points are refused.
const MOST: f64 = 16_777_216.0;

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The corners of a polygon that follows the curve: no point of the one is farther than `tolerance` from the other.
    ///
    /// The curve is halved until its Bézier control points are that close to the chord, or until `n (n-1)/8` times
    /// their largest second difference is, up to rounding errors. Both ends of the curve are corners, exactly. A curve
    /// that is a point gives this point twice.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let parabola = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]);
    /// assert_eq!(parabola.flatten(0.25)?, [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]]);
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Tolerance`] if the tolerance is not positive and finite, [`CurveError::NotFinite`] if a control
    /// point is infinite or NaN, [`CurveError::TooManyPoints`] if more than 2²⁴ corners would be needed.
    pub fn flatten(&self, tolerance: B::Scalar) -> Result<Vec<P>, CurveError> {
        if !(tolerance > B::Scalar::ZERO && tolerance.is_finite()) {
            return Err(CurveError::Tolerance { value: tolerance.to_f64() });
        }
        let points = self.to_bernstein();
        if !points.as_ref().iter().all(|&p| is_finite(p)) {
            return Err(CurveError::NotFinite);
        }
        let needed = (bend(points.as_ref()).to_f64() / tolerance.to_f64()).max(1.0);
        // Each halving divides the bend by four.
        let needed = 2.0 * B::Scalar::of(needed).sqrt().to_f64();
        if needed.is_nan() || needed > MOST {
            return Err(CurveError::TooManyPoints { needed });
        }
        // As often as it has to be halved; without rounding errors it never is more often, with them it could be
        // without end.
        let deepest = (0..25).find(|&depth| 2.0 * f64::from(1_u32 << depth) >= needed).unwrap_or(25);
        let mut corners = alloc::vec![points.as_ref()[0]];
        let mut pieces = alloc::vec![(points, 0)];
        while let Some((mut piece, depth)) = pieces.pop() {
            if depth == deepest || is_flat(piece.as_ref(), tolerance) {
                corners.push(piece.as_ref()[piece.as_ref().len() - 1]);
                continue;
            }
            let mut right = piece;
            bernstein::split(piece.as_mut(), B::Scalar::of(0.5), right.as_mut());
            pieces.push((right, depth + 1));
            pieces.push((piece, depth + 1));
        }
        Ok(corners)
    }
}

/// The largest distance between a point of the curve and the point of the chord at the same parameter is at most
/// `n (n-1)/8` times the largest second difference of the control points.
fn bend<P: Point>(points: &[P]) -> P::Scalar {
    let degree = points.len().saturating_sub(1);
    let factor = P::Scalar::of((degree * degree.saturating_sub(1)) as f64 / 8.0);
    let second = points.windows(3).map(|p| length(p[2].minus(p[1]).minus(p[1].minus(p[0]))));
    second.fold(P::Scalar::ZERO, P::Scalar::max) * factor
}

fn is_flat<P: Point>(points: &[P], tolerance: P::Scalar) -> bool {
    let (Some(&start), Some(&end)) = (points.first(), points.last()) else { return true };
    bend(points) <= tolerance || points.iter().all(|&p| distance_to_segment(p, start, end) <= tolerance)
}

/// The distance of a point from a segment.
fn distance_to_segment<P: Point>(p: P, start: P, end: P) -> P::Scalar {
    let along = end.minus(start);
    let square = dot(along, along);
    let gap = p.minus(start);
    let foot = dot(gap, along) / square;
    if foot > P::Scalar::ZERO && foot < P::Scalar::ONE {
        length(gap.add_weighted(along, -foot))
    } else {
        distance(p, start).min(distance(p, end))
    }
}
