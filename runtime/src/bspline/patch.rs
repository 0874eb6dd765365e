//! Patches on boxes of two variables as B-spline surfaces, which are surfaces of a rectangle like all others.

use alloc::vec::Vec;

use super::{BSplineSurface, KnotVector, Net, SplineError};
use crate::{BoxBasis, BoxPatch, Point};

impl<B, P> TryFrom<&BoxPatch<B, P>> for BSplineSurface<P>
where
    B: BoxBasis<Coordinates = [<P as Point>::Scalar; 2], Scalar = <P as Point>::Scalar>,
    P: Point,
{
    type Error = SplineError;

    /// The same surface over the same rectangle, in one span: it has normals, nearest points, boundaries, triangles.
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
    /// let surface = BSplineSurface::try_from(&BoxPatch::new(Quadrilateral::new(), points))?;
    /// assert_eq!(surface.domain(), [[-1.0, 1.0], [-1.0, 1.0]]);
    /// assert_eq!(surface.normal(0.0, 0.0), Some([0.0, 0.0, 1.0]));
    /// assert!((surface.area(1e-9).unwrap().value - 6.0_f64).abs() < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`SplineError::Knots`] for a degree above [`MAX_DEGREE`](super::MAX_DEGREE).
    fn try_from(patch: &BoxPatch<B, P>) -> Result<Self, SplineError> {
        let [low, high] = patch.domain();
        let knots = |k: usize| KnotVector::clamped(B::DEGREES[k], &[low[k], high[k]]);
        let net = patch.to_bernstein();
        let rows: Vec<Vec<P>> = net.as_ref().chunks(B::DEGREES[1] + 1).map(<[P]>::to_vec).collect();
        Self::new(knots(0)?, knots(1)?, Net::from_rows(rows)?)
    }
}
