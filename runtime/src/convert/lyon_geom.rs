//! lyon_geom: points and vectors are points; line, quadratic and cubic Bézier segments.

use lyon_geom::{CubicBezierSegment, LineSegment, QuadraticBezierSegment};

use super::planar;
use crate::{Basis, Bezier, Curve, CurveError, Point, Scalar};

macro_rules! points {
    ($($point:ident)+) => {$(
        impl<S: Scalar> Point for lyon_geom::$point<S> {
            type Scalar = S;
            type Vector = lyon_geom::Vector<S>;
            const DIM: usize = 2;

            #[inline]
            fn from_components(mut component: impl FnMut(usize) -> S) -> Self {
                let x = component(0);
                Self::new(x, component(1))
            }

            #[inline]
            fn component(&self, index: usize) -> S {
                [self.x, self.y][index]
            }
        }
    )+};
}
points! { Point Vector }

impl<S: Scalar> From<LineSegment<S>> for Bezier<lyon_geom::Point<S>, 2> {
    fn from(LineSegment { from, to }: LineSegment<S>) -> Self {
        Self::from_points([from, to])
    }
}

impl<S: Scalar> From<QuadraticBezierSegment<S>> for Bezier<lyon_geom::Point<S>, 3> {
    fn from(QuadraticBezierSegment { from, ctrl, to }: QuadraticBezierSegment<S>) -> Self {
        Self::from_points([from, ctrl, to])
    }
}

impl<S: Scalar> From<CubicBezierSegment<S>> for Bezier<lyon_geom::Point<S>, 4> {
    fn from(CubicBezierSegment { from, ctrl1, ctrl2, to }: CubicBezierSegment<S>) -> Self {
        Self::from_points([from, ctrl1, ctrl2, to])
    }
}

macro_rules! segments {
    ($($scalar:ident)+) => {$(
        /// Fails with [`CurveError::Degree`] or [`CurveError::Dimension`] if it is no line in the plane.
        impl<B: Basis<Scalar = $scalar>, P: Point<Scalar = $scalar>> TryFrom<&Curve<B, P>> for LineSegment<$scalar> {
            type Error = CurveError;

            fn try_from(curve: &Curve<B, P>) -> Result<Self, CurveError> {
                let [from, to] = planar(curve)?.map(lyon_geom::Point::from);
                Ok(Self { from, to })
            }
        }

        /// Fails with [`CurveError::Degree`] or [`CurveError::Dimension`] if it is no curve in the plane of degree up
        /// to 2.
        impl<B: Basis<Scalar = $scalar>, P: Point<Scalar = $scalar>> TryFrom<&Curve<B, P>>
            for QuadraticBezierSegment<$scalar>
        {
            type Error = CurveError;

            fn try_from(curve: &Curve<B, P>) -> Result<Self, CurveError> {
                let [from, ctrl, to] = planar(curve)?.map(lyon_geom::Point::from);
                Ok(Self { from, ctrl, to })
            }
        }

        /// Fails with [`CurveError::Degree`] or [`CurveError::Dimension`] if it is no curve in the plane of degree up
        /// to 3.
        impl<B: Basis<Scalar = $scalar>, P: Point<Scalar = $scalar>> TryFrom<&Curve<B, P>>
            for CubicBezierSegment<$scalar>
        {
            type Error = CurveError;

            fn try_from(curve: &Curve<B, P>) -> Result<Self, CurveError> {
                let [from, ctrl1, ctrl2, to] = planar(curve)?.map(lyon_geom::Point::from);
                Ok(Self { from, ctrl1, ctrl2, to })
            }
        }
    )+};
}
segments! { f32 f64 }
