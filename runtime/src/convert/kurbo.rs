//! kurbo: `Point` and `Vec2` are points; lines, quadratic and cubic Bézier curves and paths.

use kurbo::{CubicBez, Line, PathSeg, QuadBez};

use super::planar;
use crate::{Basis, Bezier, Curve, CurveError, Point};

macro_rules! points {
    ($($point:ident)+) => {$(
        impl Point for kurbo::$point {
            type Scalar = f64;
            const DIM: usize = 2;

            #[inline]
            fn from_components(mut component: impl FnMut(usize) -> f64) -> Self {
                let x = component(0);
                Self::new(x, component(1))
            }

            #[inline]
            fn component(&self, index: usize) -> f64 {
                [self.x, self.y][index]
            }
        }
    )+};
}
points! { Point Vec2 }

impl From<Line> for Bezier<kurbo::Point, 2> {
    fn from(Line { p0, p1 }: Line) -> Self {
        Self::from_points([p0, p1])
    }
}

impl From<QuadBez> for Bezier<kurbo::Point, 3> {
    fn from(QuadBez { p0, p1, p2 }: QuadBez) -> Self {
        Self::from_points([p0, p1, p2])
    }
}

impl From<CubicBez> for Bezier<kurbo::Point, 4> {
    fn from(CubicBez { p0, p1, p2, p3 }: CubicBez) -> Self {
        Self::from_points([p0, p1, p2, p3])
    }
}

/// Fails with [`CurveError::Degree`] or [`CurveError::Dimension`] if it is no line in the plane.
impl<B: Basis<Scalar = f64>, P: Point<Scalar = f64>> TryFrom<&Curve<B, P>> for Line {
    type Error = CurveError;

    fn try_from(curve: &Curve<B, P>) -> Result<Self, CurveError> {
        let [p0, p1] = planar(curve)?;
        Ok(Self::new(p0, p1))
    }
}

/// Fails with [`CurveError::Degree`] or [`CurveError::Dimension`] if it is no curve in the plane of degree up to 2.
impl<B: Basis<Scalar = f64>, P: Point<Scalar = f64>> TryFrom<&Curve<B, P>> for QuadBez {
    type Error = CurveError;

    fn try_from(curve: &Curve<B, P>) -> Result<Self, CurveError> {
        let [p0, p1, p2] = planar(curve)?;
        Ok(Self::new(p0, p1, p2))
    }
}

/// Fails with [`CurveError::Degree`] or [`CurveError::Dimension`] if it is no curve in the plane of degree up to 3.
impl<B: Basis<Scalar = f64>, P: Point<Scalar = f64>> TryFrom<&Curve<B, P>> for CubicBez {
    type Error = CurveError;

    fn try_from(curve: &Curve<B, P>) -> Result<Self, CurveError> {
        let [p0, p1, p2, p3] = planar(curve)?;
        Ok(Self::new(p0, p1, p2, p3))
    }
}

/// The segment of the degree of the family; a cubic where that is higher but the curve is not. Fails with [`CurveError::Degree`]
/// or [`CurveError::Dimension`] if it is no curve in the plane of degree up to 3.
impl<B: Basis<Scalar = f64>, P: Point<Scalar = f64>> TryFrom<&Curve<B, P>> for PathSeg {
    type Error = CurveError;

    fn try_from(curve: &Curve<B, P>) -> Result<Self, CurveError> {
        Ok(match B::DEGREE {
            0 | 1 => Self::Line(curve.try_into()?),
            2 => Self::Quad(curve.try_into()?),
            _ => Self::Cubic(curve.try_into()?),
        })
    }
}

/// A path of one piece. A segment that does not start where the one before ends starts there nevertheless, as segments of a
/// path do. Fails with [`CurveError::Degree`] or [`CurveError::Dimension`] if the segments are no curves in the plane of
/// degree up to 3.
#[cfg(feature = "alloc")]
impl<B: Basis<Scalar = f64>, P: Point<Scalar = f64>> TryFrom<&crate::PiecewiseCurve<B, P>>
    for kurbo::BezPath
{
    type Error = CurveError;

    fn try_from(curve: &crate::PiecewiseCurve<B, P>) -> Result<Self, CurveError> {
        let mut path = Self::new();
        for segment in curve.segments() {
            let segment: PathSeg = segment.try_into()?;
            if path.elements().is_empty() {
                path.move_to(kurbo::ParamCurve::start(&segment));
            }
            path.push(segment.as_path_el());
        }
        Ok(path)
    }
}
