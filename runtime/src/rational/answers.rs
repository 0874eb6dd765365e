//! Curves over rational families as parametric curves.

use alloc::vec::Vec;
use core::ops::Range;

use super::series::{derivative, derivatives_into};
use super::{RationalBasis, RationalBezier, RationalCurve};
use crate::curve::{divisible, nonempty};
use crate::geometry::clamped;
use crate::{CurveError, CurvePiece, ParametricCurve, Point, Scalar};

impl<B: RationalBasis, P: Point<Scalar = B::Scalar>> RationalCurve<B, P> {
    /// The same curve in Bézier form; over its own domain if the map from there is affine.
    fn bezier(&self) -> RationalBezier<P> {
        let curve = self.to_rational_bezier();
        if self.chart().is_affine() { curve.with_domain(self.domain()) } else { curve }
    }

    /// The parameter of the Bézier form; errors are those of the curve.
    fn bezier_parameter(&self, t: P::Scalar) -> P::Scalar {
        if self.chart().is_affine() { t } else { self.chart().place(t) }
    }
}

impl<B: RationalBasis, P: Point<Scalar = B::Scalar>> ParametricCurve for RationalCurve<B, P> {
    type Point = P;
    type Part = RationalBezier<P>;

    #[inline]
    fn domain(&self) -> [P::Scalar; 2] {
        self.domain()
    }

    #[inline]
    fn eval(&self, t: P::Scalar) -> P {
        self.eval(t)
    }

    #[inline]
    fn start(&self) -> P {
        self.start()
    }

    #[inline]
    fn end(&self) -> P {
        self.end()
    }

    fn eval_checked(&self, t: P::Scalar) -> Result<P, CurveError> {
        self.eval_checked(t)
    }

    fn eval_into(&self, ts: &[P::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        self.eval_into(ts, out)
    }

    fn derivatives_into(&self, t: P::Scalar, derivatives: &mut [P::Vector]) {
        let (mut numerator, mut weights) = (self.numerator_vectors(), self.basis().denominator());
        derivatives_into(numerator.as_mut(), weights.as_mut(), &self.chart(), t, derivatives);
        if let Some(point) = derivatives.first_mut() {
            *point = self.eval(t).to_vector();
        }
    }

    #[inline]
    fn eval_with_derivs<const K: usize>(&self, t: P::Scalar) -> [P::Vector; K] {
        self.eval_with_derivs(t)
    }

    fn derivative(&self, t: P::Scalar, order: usize) -> P::Vector {
        if order == 0 {
            return self.eval(t).to_vector();
        }
        let (mut numerator, mut weights) = (self.numerator_vectors(), self.basis().denominator());
        derivative(numerator.as_mut(), weights.as_mut(), &self.chart(), t, order)
    }

    fn parameter_of(&self, place: f64) -> P::Scalar {
        let place = P::Scalar::of(place);
        let t = if self.chart().is_affine() { place } else { self.chart().parameter(place) };
        clamped(self.domain(), t)
    }

    fn place_of(&self, t: P::Scalar) -> f64 {
        self.bezier_parameter(t).to_f64()
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        self.bezier().pieces()
    }

    fn split(&self, t: P::Scalar) -> Result<[RationalBezier<P>; 2], CurveError> {
        divisible(self.domain(), t)?;
        self.bezier().split(self.bezier_parameter(t))
    }

    fn subsegment(&self, range: Range<P::Scalar>) -> Result<RationalBezier<P>, CurveError> {
        nonempty(self.domain(), &range)?;
        self.bezier().subsegment(self.bezier_parameter(range.start)..self.bezier_parameter(range.end))
    }

    fn reversed(&self) -> RationalBezier<P> {
        self.bezier().reversed()
    }
}
