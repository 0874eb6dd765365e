//! What can be asked of a curve as a whole, answered from the segments.

use alloc::vec::Vec;

use super::PiecewiseCurve;
use crate::vector::{is_finite, length, lerp};
use crate::{CurveError, CurveScalar, CurveVector, Nearest, ParametricCurve, Point, Scalar};

impl<C: ParametricCurve> PiecewiseCurve<C> {
    /// The arc length of all segments; the error is at most `accuracy`. See [`ParametricCurve::arclen`].
    pub fn arclen(&self, accuracy: CurveScalar<C>) -> CurveScalar<C> {
        let accuracy = self.share(accuracy);
        self.segments.iter().fold(CurveScalar::<C>::ZERO, |sum, segment| sum + segment.arclen(accuracy))
    }

    /// The parameter up to which the curve has that length, up to `accuracy`. See
    /// [`ParametricCurve::inv_arclen`].
    pub fn inv_arclen(&self, length: CurveScalar<C>, accuracy: CurveScalar<C>) -> CurveScalar<C> {
        let accuracy = self.share(accuracy);
        self.inverse(&self.lengths(accuracy), length, accuracy)
    }

    /// `count` points at equal distances along the curve, both ends included. See
    /// [`ParametricCurve::samples_by_arclen`].
    pub fn samples_by_arclen(&self, count: usize, accuracy: CurveScalar<C>) -> Vec<C::Point> {
        let accuracy = self.share(accuracy);
        let lengths = self.lengths(accuracy);
        let total = lengths.iter().fold(CurveScalar::<C>::ZERO, |sum, &length| sum + length);
        let steps = CurveScalar::<C>::from_usize(count.saturating_sub(1).max(1));
        (0..count)
            .map(|i| match i {
                0 => self.start(),
                _ if i == count - 1 => self.end(),
                _ => self.eval(self.inverse(
                    &lengths,
                    total * (CurveScalar::<C>::from_usize(i) / steps),
                    accuracy,
                )),
            })
            .collect()
    }

    /// The arc lengths of the segments.
    fn lengths(&self, accuracy: CurveScalar<C>) -> Vec<CurveScalar<C>> {
        self.segments.iter().map(|segment| segment.arclen(accuracy)).collect()
    }

    fn inverse(
        &self,
        lengths: &[CurveScalar<C>],
        length: CurveScalar<C>,
        accuracy: CurveScalar<C>,
    ) -> CurveScalar<C> {
        let mut rest = length;
        for (index, (segment, &piece)) in self.segments.iter().zip(lengths).enumerate() {
            if rest < piece || rest.is_nan() || piece.is_nan() {
                return self.global(index, segment.inv_arclen(rest, accuracy));
            }
            rest = rest - piece;
        }
        self.domain()[1]
    }

    /// `count` points at equal distances of the parameter, both ends included, exactly.
    pub fn samples(&self, count: usize) -> impl ExactSizeIterator<Item = C::Point> + DoubleEndedIterator {
        let steps = CurveScalar::<C>::from_usize(count.saturating_sub(1).max(1));
        let end = self.domain()[1];
        (0..count).map(move |i| {
            self.eval(lerp(CurveScalar::<C>::ZERO, end, CurveScalar::<C>::from_usize(i) / steps))
        })
    }

    /// The point of the curve nearest to `point`, with the parameter of this curve. See
    /// [`ParametricCurve::nearest`].
    pub fn nearest(&self, point: C::Point, accuracy: CurveScalar<C>) -> Option<Nearest<C::Point>> {
        let mut best: Option<Nearest<C::Point>> = None;
        // No segment is nearer than this.
        let mut at_least = CurveScalar::<C>::INFINITY;
        for (index, segment) in self.segments.iter().enumerate() {
            // A segment whose box is farther away than the best point needs no search.
            let far = best.is_some_and(|best| distance_to_box(point, segment.control_box()) > best.distance);
            if far {
                continue;
            }
            let found = segment.nearest(point, accuracy)?;
            at_least = at_least.min(found.at_least);
            if best.is_none_or(|best| found.distance < best.distance) {
                best = Some(Nearest { at: self.global(index, found.at), ..found });
            }
        }
        best.map(|best| Nearest { at_least: at_least.min(best.distance), ..best })
    }

    /// The smallest axis-parallel box around the curve, as its two extreme corners `[min, max]`. See
    /// [`ParametricCurve::bounding_box`].
    pub fn bounding_box(&self) -> [C::Point; 2] {
        union(self.segments.iter().map(ParametricCurve::bounding_box))
    }

    /// The smallest axis-parallel box around the Bézier control points, as its two extreme corners `[min, max]`.
    pub fn control_box(&self) -> [C::Point; 2] {
        union(self.segments.iter().map(ParametricCurve::control_box))
    }

    /// The corners of a polygon that follows the curve within the tolerance; corners at joints stand once where the
    /// segments meet exactly. See [`ParametricCurve::flatten`].
    ///
    /// # Errors
    /// Those of [`ParametricCurve::flatten`].
    pub fn flatten(&self, tolerance: CurveScalar<C>) -> Result<Vec<C::Point>, CurveError> {
        let mut corners: Vec<C::Point> = Vec::new();
        for segment in &self.segments {
            let next = segment.flatten(tolerance)?;
            let repeated = usize::from(corners.last() == next.first());
            corners.extend_from_slice(&next[repeated..]);
        }
        Ok(corners)
    }

    /// The curvature at `u`; see [`ParametricCurve::curvature`]. At a joint that of the later segment.
    pub fn curvature(&self, u: CurveScalar<C>) -> CurveScalar<C> {
        let (index, t) = self.locate(u);
        self.segments[index].curvature(t)
    }

    /// The unit vector in which the curve goes on at `u`; see [`ParametricCurve::tangent`].
    pub fn tangent(&self, u: CurveScalar<C>) -> Option<CurveVector<C>> {
        let (index, t) = self.locate(u);
        self.segments[index].tangent(t)
    }

    /// The part of an accuracy that each segment may use.
    fn share(&self, accuracy: CurveScalar<C>) -> CurveScalar<C> {
        accuracy / CurveScalar::<C>::from_usize(self.segments.len())
    }
}

/// NaN in a component in which one of the boxes is NaN.
fn union<P: Point>(boxes: impl Iterator<Item = [P; 2]>) -> [P; 2] {
    let extreme = |a: P, b: P, of: fn(P::Scalar, P::Scalar) -> P::Scalar| {
        P::from_components(|d| {
            let (a, b) = (a.component(d), b.component(d));
            if a.is_nan() || b.is_nan() { P::Scalar::NAN } else { of(a, b) }
        })
    };
    boxes
        .reduce(|a, b| [extreme(a[0], b[0], Scalar::min), extreme(a[1], b[1], Scalar::max)])
        .unwrap_or_else(|| [P::from_components(|_| P::Scalar::NAN); 2])
}

/// Zero if the box is infinite or NaN in a component.
fn distance_to_box<P: Point>(point: P, [low, high]: [P; 2]) -> P::Scalar {
    if !(is_finite(low) && is_finite(high)) {
        return P::Scalar::ZERO;
    }
    length(P::from_components(|d| {
        let p = point.component(d);
        (low.component(d) - p).max(p - high.component(d)).max(P::Scalar::ZERO)
    }))
}
