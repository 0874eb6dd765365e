//! The curves over families as parametric curves.

use alloc::vec::Vec;
use core::ops::Range;

use super::{CurvePiece, ParametricCurve};
use crate::{Basis, BezierOf, Curve, CurveError, Frame, Nearest, Point, Point3};

/// Answers with the methods of the type, or of one of its fields, which have the same names.
macro_rules! forward {
    ($([$field:tt])? $($name:ident($($argument:ident: $type:ty),*) -> $result:ty;)+) => {
        crate::geometry::forward! { @[$($field)?] $($name($($argument: $type),*) -> $result;)+ }
    };
    (@$field:tt $($name:ident($($argument:ident: $type:ty),*) -> $result:ty;)+) => {
        $(crate::geometry::forward! { #$field $name($($argument: $type),*) -> $result })+
    };
    (#[$($field:tt)?] $name:ident($($argument:ident: $type:ty),*) -> $result:ty) => {
        #[inline]
        fn $name(&self, $($argument: $type),*) -> $result {
            self.$($field.)?$name($($argument),*)
        }
    };
}
pub(crate) use forward;

impl<B: Basis, P: Point<Scalar = B::Scalar>> ParametricCurve for Curve<B, P> {
    type Point = P;
    type Part = BezierOf<B, P>;

    forward! {
        domain() -> [P::Scalar; 2];
        eval(t: P::Scalar) -> P;
        split(t: P::Scalar) -> Result<[Self::Part; 2], CurveError>;
        subsegment(range: Range<P::Scalar>) -> Result<Self::Part, CurveError>;
        reversed() -> Self::Part;
        start() -> P;
        end() -> P;
        derivative(t: P::Scalar, order: usize) -> P::Vector;
        tangent(t: P::Scalar) -> Option<P::Vector>;
        curvature(t: P::Scalar) -> P::Scalar;
        arclen(accuracy: P::Scalar) -> P::Scalar;
        inv_arclen(length: P::Scalar, accuracy: P::Scalar) -> P::Scalar;
        arclen_parameters(count: usize, accuracy: P::Scalar) -> Vec<P::Scalar>;
        samples_by_arclen(count: usize, accuracy: P::Scalar) -> Vec<P>;
        flatten(tolerance: P::Scalar) -> Result<Vec<P>, CurveError>;
        control_box() -> [P; 2];
        bounding_box() -> [P; 2];
        extrema() -> Vec<P::Scalar>;
        inflections() -> Result<Vec<P::Scalar>, CurveError>;
        nearest(point: P, accuracy: P::Scalar) -> Option<Nearest<P>>;
    }

    #[inline]
    fn derivatives_into(&self, t: P::Scalar, derivatives: &mut [P::Vector]) {
        self.derivatives_into(t, derivatives);
    }

    #[inline]
    fn eval_with_derivs<const K: usize>(&self, t: P::Scalar) -> [P::Vector; K] {
        self.eval_with_derivs(t)
    }

    #[inline]
    fn samples(&self, count: usize) -> impl ExactSizeIterator<Item = P> + DoubleEndedIterator {
        self.samples(count)
    }

    fn eval_into(&self, ts: &[P::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        self.eval_into(ts, out)
    }

    #[inline]
    fn samples_into(&self, out: &mut [P]) {
        self.samples_into(out);
    }

    fn frenet_frame(&self, t: P::Scalar) -> Result<Frame<P>, CurveError>
    where
        P: Point3,
    {
        self.frenet_frame(t)
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        alloc::vec![CurvePiece::polynomial(B::domain(), self.to_bernstein().as_ref())]
    }
}
