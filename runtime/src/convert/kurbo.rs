//! kurbo: `Point` and `Vec2` are points; lines, quadratic and cubic Bézier curves and paths.

use kurbo::{CubicBez, Line, PathSeg, QuadBez};

use super::planar;
#[cfg(feature = "alloc")]
use crate::domain::from_unit;
use crate::{Basis, Bezier, Curve, CurveError, Point};

macro_rules! points {
    ($($point:ident)+) => {$(
        impl Point for kurbo::$point {
            type Scalar = f64;
            type Vector = kurbo::Vec2;
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

/// The segment of the degree of the family; a cubic where that is higher but the curve is not. Fails with
/// [`CurveError::Degree`] or [`CurveError::Dimension`] if it is no curve in the plane of degree up to 3.
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

/// A path of one piece. A segment that does not start where the one before ends starts there nevertheless, as segments
/// of a path do. Fails with [`CurveError::Degree`] or [`CurveError::Dimension`] if the segments are no curves in the
/// plane of degree up to 3.
#[cfg(feature = "geometry")]
impl<B: Basis<Scalar = f64>, P: Point<Scalar = f64>> TryFrom<&crate::PiecewiseCurve<Curve<B, P>>>
    for kurbo::BezPath
{
    type Error = CurveError;

    fn try_from(curve: &crate::PiecewiseCurve<Curve<B, P>>) -> Result<Self, CurveError> {
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

/// So [`kurbo::fit_to_bezpath`] writes curves of any degree as cubics, within a tolerance: where the degree is above 3,
/// and in place of the exact conversion.
///
/// ```
/// use basis_runtime::Bezier;
/// use kurbo::{BezPath, Point};
///
/// let quartic = Bezier::from_points([(0.0, 0.0), (0.0, 2.0), (3.0, 3.0), (4.0, 0.0), (6.0, 1.0)].map(Point::from));
/// let path: BezPath = kurbo::fit_to_bezpath(&quartic, 1e-3);
/// assert!(path.segments().count() <= 4);
/// ```
#[cfg(feature = "alloc")]
impl<B: Basis<Scalar = f64>> kurbo::ParamCurveFit for Curve<B, kurbo::Point> {
    fn sample_pt_tangent(&self, t: f64, sign: f64) -> kurbo::CurveFitSample {
        // At a cusp the direction of arriving is that of leaving on the way back.
        let leaving = |tangent: Option<kurbo::Vec2>| tangent.unwrap_or_default();
        let tangent = if sign < 0.0 {
            -leaving(self.reversed().tangent(1.0 - t))
        } else {
            leaving(self.tangent(from_unit(B::domain(), t)))
        };
        kurbo::CurveFitSample { p: self.eval(from_unit(B::domain(), t)), tangent }
    }

    fn sample_pt_deriv(&self, t: f64) -> (kurbo::Point, kurbo::Vec2) {
        let [lo, hi] = B::domain();
        let [point, velocity] = self.eval_with_derivs(from_unit([lo, hi], t));
        (point.to_point(), velocity * (hi - lo))
    }

    /// Where a curve turns back at a cusp, the component that turns has an extremum.
    fn break_cusp(&self, range: core::ops::Range<f64>) -> Option<f64> {
        let [lo, hi] = B::domain();
        let velocities = self.hodograph();
        let largest = velocities.control_points().iter().fold(0.0, |largest, v| v.hypot().max(largest));
        let margin = 1e-6 * (range.end - range.start);
        let inside = |&t: &f64| t > range.start + margin && t < range.end - margin;
        let stops = |&t: &f64| velocities.eval(t).hypot() <= 1e-7 * largest;
        self.extrema().into_iter().map(|t| (t - lo) / (hi - lo)).filter(inside).find(stops)
    }
}
