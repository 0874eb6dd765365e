//! Patches on boxes of two variables as B-spline surfaces, which are surfaces of a rectangle like all others.

use alloc::vec::Vec;

use core::ops::Range;

use super::{BSplineSurface, KnotVector, MAX_DEGREE, Net, SplineError};
use crate::{BoxBasis, BoxPatch, CurveError, Direction, Point, Scalar};

impl<B, P> TryFrom<&BoxPatch<B, P>> for BSplineSurface<P>
where
    B: BoxBasis<Coordinates = [<P as Point>::Scalar; 2], Scalar = <P as Point>::Scalar>,
    P: Point,
{
    type Error = SplineError;

    /// The same surface over the same rectangle, in one span: it has parts, and control points that are inserted.
    ///
    /// ```
    /// use basis_runtime::bspline::BSplineSurface;
    /// use basis_runtime::{BoundedSurface, BoxPatch, Surface, basis};
    ///
    /// basis! {
    ///     family Quadrilateral {
    ///         domain -1 <= u <= 1, -1 <= v <= 1;
    ///         b[i, j] = (1 + (2*i - 1)*u)/2 * (1 + (2*j - 1)*v)/2 for i in 0..=1, j in 0..=1;
    ///     }
    /// }
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let points = [[0.0, 0.0, 0.0], [0.0, 2.0, 0.0], [3.0, 0.0, 0.0], [3.0, 2.0, 0.0]];
    /// let patch = BoxPatch::new(Quadrilateral::new(), points);
    /// let surface = BSplineSurface::try_from(&patch)?;
    /// assert_eq!(surface.domain(), patch.domain());
    /// assert_eq!(surface.normal(0.0, 0.0), Some([0.0, 0.0, 1.0]));
    /// assert!((surface.area(1e-9).unwrap().value - 6.0_f64).abs() < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`SplineError::Knots`] for a degree above [`MAX_DEGREE`](super::MAX_DEGREE).
    fn try_from(patch: &BoxPatch<B, P>) -> Result<Self, SplineError> {
        let [low, high] = B::domain();
        let knots = |k: usize| KnotVector::clamped(B::DEGREES[k], &[low[k], high[k]]);
        let net = patch.to_bernstein();
        let rows: Vec<Vec<P>> = net.as_ref().chunks(B::DEGREES[1] + 1).map(<[P]>::to_vec).collect();
        Self::new(knots(0)?, knots(1)?, Net::from_rows(rows)?)
    }
}

/// Parts, which are B-spline surfaces because families with shape parameters are not closed under subdivision.
impl<S, B, P> BoxPatch<B, P>
where
    S: Scalar,
    B: BoxBasis<Scalar = S, Coordinates = [S; 2]>,
    P: Point<Scalar = S>,
{
    /// The parts below and above a parameter of one direction, with their parts of the rectangle.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if the parameter is outside of the rectangle or NaN, [`CurveError::AtEnd`] at an end of it,
    /// where one part would be a curve, [`CurveError::Degree`] for a degree above [`MAX_DEGREE`].
    pub fn split(&self, direction: Direction, at: S) -> Result<[BSplineSurface<P>; 2], CurveError> {
        self.spline()?.split(direction, at)
    }

    /// The part over a rectangle of parameters, which is its domain; a range with `start > end` runs backwards, over the
    /// same part of the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if an end of a range is outside of the rectangle or NaN, [`CurveError::EmptyRange`] if
    /// both ends of one are equal, [`CurveError::Degree`] for a degree above [`MAX_DEGREE`].
    pub fn subpatch(&self, u: Range<S>, v: Range<S>) -> Result<BSplineSurface<P>, CurveError> {
        self.spline()?.subpatch(u, v)
    }

    /// The same surface with one parameter running the other way; its normals turn to the other side.
    ///
    /// # Errors
    /// [`CurveError::Degree`] for a degree above [`MAX_DEGREE`].
    pub fn reversed(&self, direction: Direction) -> Result<BSplineSurface<P>, CurveError> {
        Ok(self.spline()?.reversed(direction))
    }

    fn spline(&self) -> Result<BSplineSurface<P>, CurveError> {
        let found = B::DEGREES.iter().copied().max().unwrap_or_default();
        BSplineSurface::try_from(self).map_err(|_| CurveError::Degree { most: MAX_DEGREE, found })
    }
}
