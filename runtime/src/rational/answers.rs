//! Curves over rational families as parametric curves.

use alloc::vec::Vec;
use core::ops::Range;

use super::series::{derivative, derivatives_into};
use super::{RationalBasis, RationalBezier, RationalCurve};
use crate::{CurveError, CurvePiece, ParametricCurve, Point};

impl<B: RationalBasis, P: Point<Scalar = B::Scalar>> RationalCurve<B, P> {
    /// The same curve in Bézier form over its own domain.
    fn bezier(&self) -> RationalBezier<P> {
        self.to_rational_bezier().with_domain(self.domain())
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

    fn derivatives_into(&self, t: P::Scalar, derivatives: &mut [P]) {
        let (mut numerator, mut weights) = (self.to_bernstein(), self.basis().denominator());
        derivatives_into(numerator.as_mut(), weights.as_mut(), &self.chart(), t, derivatives);
        if let Some(point) = derivatives.first_mut() {
            *point = self.eval(t);
        }
    }

    #[inline]
    fn eval_with_derivs<const K: usize>(&self, t: P::Scalar) -> [P; K] {
        self.eval_with_derivs(t)
    }

    fn derivative(&self, t: P::Scalar, order: usize) -> P {
        if order == 0 {
            return self.eval(t);
        }
        let (mut numerator, mut weights) = (self.to_bernstein(), self.basis().denominator());
        derivative(numerator.as_mut(), weights.as_mut(), &self.chart(), t, order)
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        self.bezier().pieces()
    }

    fn split(&self, t: P::Scalar) -> Result<[RationalBezier<P>; 2], CurveError> {
        self.bezier().split(t)
    }

    fn subsegment(&self, range: Range<P::Scalar>) -> Result<RationalBezier<P>, CurveError> {
        self.bezier().subsegment(range)
    }

    fn reversed(&self) -> RationalBezier<P> {
        self.bezier().reversed()
    }
}
