//! Curves of several segments as parametric curves.

use alloc::vec::Vec;
use core::ops::Range;

use super::PiecewiseCurve;
use crate::domain::{from_unit, unit};
use crate::geometry::forward;
use crate::{CurveError, CurvePiece, CurveScalar, CurveVector, Nearest, ParametricCurve};

/// The place in its unit interval of a place between the two ends of a segment.
fn within(ends: [f64; 2], place: f64) -> f64 {
    if ends[0] == ends[1] { 0.0 } else { unit(ends, place)[1] }
}

impl<C: ParametricCurve> PiecewiseCurve<C> {
    /// The places at which the pieces of a segment begin and end.
    fn ends(&self, index: usize) -> [f64; 2] {
        let segment = &self.segments[index];
        segment.domain().map(|t| segment.place_of(t))
    }
}

impl<C: ParametricCurve> ParametricCurve for PiecewiseCurve<C> {
    type Point = C::Point;
    type Part = PiecewiseCurve<C::Part>;

    forward! {
        domain() -> [CurveScalar<C>; 2];
        eval(t: CurveScalar<C>) -> C::Point;
        split(t: CurveScalar<C>) -> Result<[Self::Part; 2], CurveError>;
        subsegment(range: Range<CurveScalar<C>>) -> Result<Self::Part, CurveError>;
        reversed() -> Self::Part;
        start() -> C::Point;
        end() -> C::Point;
        tangent(t: CurveScalar<C>) -> Option<CurveVector<C>>;
        curvature(t: CurveScalar<C>) -> CurveScalar<C>;
        arclen(accuracy: CurveScalar<C>) -> CurveScalar<C>;
        inv_arclen(length: CurveScalar<C>, accuracy: CurveScalar<C>) -> CurveScalar<C>;
        samples_by_arclen(count: usize, accuracy: CurveScalar<C>) -> Vec<C::Point>;
        flatten(tolerance: CurveScalar<C>) -> Result<Vec<C::Point>, CurveError>;
        control_box() -> [C::Point; 2];
        bounding_box() -> [C::Point; 2];
        nearest(point: C::Point, accuracy: CurveScalar<C>) -> Option<Nearest<C::Point>>;
    }

    fn derivatives_into(&self, t: CurveScalar<C>, derivatives: &mut [CurveVector<C>]) {
        let (index, local) = self.locate(t);
        self.segments[index].derivatives_into(local, derivatives);
        self.in_own_parameter(index, derivatives);
    }

    #[inline]
    fn eval_with_derivs<const K: usize>(&self, t: CurveScalar<C>) -> [CurveVector<C>; K] {
        self.eval_with_derivs(t)
    }

    #[inline]
    fn samples(&self, count: usize) -> impl ExactSizeIterator<Item = C::Point> + DoubleEndedIterator {
        self.samples(count)
    }

    /// Where the parameter is the number of a segment `k`, the places of its pieces run from `k` to `k + 1`.
    fn pieces(&self) -> Vec<CurvePiece> {
        let of = |k: usize| {
            let pieces = self.segments[k].pieces();
            let ends = [pieces.first().map(|p| p.domain()[0]), pieces.last().map(|p| p.domain()[1])];
            let ends = ends.map(Option::unwrap_or_default);
            let whole = pieces.len() == 1;
            pieces.into_iter().map(move |piece| {
                let domain = if whole { [0.0, 1.0] } else { piece.domain().map(|end| within(ends, end)) };
                piece.over(domain.map(|x| k as f64 + x))
            })
        };
        (0..self.segments.len()).flat_map(of).collect()
    }

    fn parameter_of(&self, place: f64) -> CurveScalar<C> {
        // The cast rounds down, and takes NaN and negative numbers to 0.
        let index = (place as usize).min(self.segments.len() - 1);
        let place = from_unit(self.ends(index), place - index as f64);
        self.global(index, self.segments[index].parameter_of(place))
    }

    fn place_of(&self, t: CurveScalar<C>) -> f64 {
        let (index, local) = self.locate(t);
        index as f64 + within(self.ends(index), self.segments[index].place_of(local))
    }
}
