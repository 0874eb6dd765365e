//! Boxes around patches on simplices, and nearest points of triangular ones.

use super::patch::SimplexPatch;
use super::{SimplexBasis, TriangularBasis};
use crate::Point;
#[cfg(feature = "alloc")]
use crate::SurfaceDomain;

impl<B: SimplexBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The smallest axis-parallel box around the Bernstein points, as its two extreme corners: cheap, and never too
    /// small up to rounding errors. NaN in a component in which a control point is NaN.
    pub fn control_box(&self) -> [P; 2] {
        crate::vector::box_of(self.to_bernstein().as_ref())
    }
}

impl<B: TriangularBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The smallest axis-parallel box around a triangular patch, as its two extreme corners, up to rounding errors;
    /// found by subdivision as [`TensorSurface::bounding_box`](crate::TensorSurface::bounding_box).
    #[cfg(feature = "alloc")]
    pub fn bounding_box(&self) -> [P; 2] {
        self.to_tensor_surface().bounding_box()
    }

    /// The point of the patch that is nearest to `point`, with the parameters `[u, v]`, where `w = 1 - u - v`; as
    /// [`TensorSurface::nearest`](crate::TensorSurface::nearest), whose promises it keeps.
    ///
    /// ```
    /// use basis_runtime::TriangularBezier;
    ///
    /// // The points of w = 1, v = 1, u = 1.
    /// let plane = TriangularBezier::<[f64; 3], 2, 3>::from_points([[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
    /// let found = plane.nearest([0.25, 0.5, 2.0], 1e-9).unwrap();
    /// assert!((found.distance - 2.0).abs() < 1e-15);
    /// assert!((found.at[0] - 0.25).abs() < 1e-8 && (found.at[1] - 0.5).abs() < 1e-8);
    /// ```
    #[cfg(feature = "alloc")]
    pub fn nearest(&self, point: P, accuracy: B::Scalar) -> Option<crate::Nearest<P, [P::Scalar; 2]>> {
        let found = self.to_tensor_surface().nearest(point, accuracy)?;
        let [x, y] = found.at;
        Some(crate::Nearest { at: SurfaceDomain::Triangle.at(x, y).into(), ..found })
    }
}
