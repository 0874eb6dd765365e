//! Boxes around patches on simplices, curvatures of triangular ones, and their parts.

use super::index::TriangleIndex;
use super::net::contract;
use super::patch::SimplexPatch;
use super::{SimplexBasis, TriangularBasis, finish};
use crate::{Curvature, Point, Point3, Scalar};

impl<B: SimplexBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The smallest axis-parallel box around the Bernstein points, as its two extreme corners: cheap, and never too small up
    /// to rounding errors. NaN in a component in which a control point is NaN.
    pub fn control_box(&self) -> [P; 2] {
        let net = self.to_bernstein();
        let extreme = |of: fn(B::Scalar, B::Scalar) -> B::Scalar| {
            P::from_components(|d| {
                let components = net.as_ref().iter().map(|p| p.component(d));
                let extreme = components
                    .reduce(|a, b| if a.is_nan() || b.is_nan() { B::Scalar::NAN } else { of(a, b) });
                extreme.unwrap_or(B::Scalar::NAN)
            })
        };
        [extreme(Scalar::min), extreme(Scalar::max)]
    }
}

impl<B: TriangularBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The smallest axis-parallel box around a triangular patch, as its two extreme corners, up to rounding errors; found by
    /// subdivision as [`TensorSurface::bounding_box`](crate::TensorSurface::bounding_box).
    #[cfg(feature = "alloc")]
    pub fn bounding_box(&self) -> [P; 2] {
        self.to_tensor_surface().bounding_box()
    }

    /// How the patch bends at `(u, v)`, as seen from the side of `S_u × S_v`; `None` where that vanishes or anything is not
    /// finite.
    pub fn curvature(&self, u: B::Scalar, v: B::Scalar) -> Option<Curvature<P>>
    where
        P: Point3,
    {
        let partials = self.eval_with_partials::<3>(u, v);
        let first = [[partials[0][0], partials[0][1]], [partials[1][0], partials[1][1]]];
        Curvature::new(&partials, crate::surface::regular_normal(&first, [B::Scalar::ONE; 2])?)
    }

    /// The Bernstein points of the part of the patch over the triangle with these corners, each given by its barycentric
    /// coordinates: the corner `u = 1` of the part first. Its control points as a patch of the family of Bernstein functions of
    /// the same degree, which the families with shape parameters are not closed under.
    ///
    /// Neighbouring parts share the points of their edge up to rounding errors; corners may lie outside of the triangle, where
    /// the polynomial is continued.
    ///
    /// ```
    /// use basis_runtime::{TriangularPatch, basis};
    ///
    /// basis! {
    ///     family Quadratic {
    ///         domain triangle (u, v, w);
    ///         b[i, j, k] = 2/(factorial(i)*factorial(j)*factorial(k)) * u^i * v^j * w^k for i, j, k in simplex(2);
    ///     }
    /// }
    /// # fn main() {
    /// let patch = TriangularPatch::new(Quadratic::new(), [0.0, 0.0, 4.0, 2.0, 1.0, 8.0]);
    /// // The half on the side of the corner u = 1, cut from the corner v = 1 to the middle of the opposite edge.
    /// let part = patch.part([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.0, 0.5]]);
    /// let half = TriangularPatch::new(Quadratic::new(), part);
    /// assert_eq!(half.eval_barycentric([0.25, 0.25, 0.5]), patch.eval_barycentric([0.5, 0.25, 0.25]));
    /// # }
    /// ```
    pub fn part(&self, corners: [[B::Scalar; 3]; 3]) -> B::Bernstein<P> {
        // The point of the index (i, j, k) is the blossom of i times the first corner, j times the second, k times the third.
        let [first, second, third] = corners;
        let mut net = self.to_bernstein();
        let mut along_first = net;
        for i in 0..=B::DEGREE {
            let mut along_second = along_first;
            for j in 0..=B::DEGREE - i {
                let mut rest = along_second;
                let k = B::DEGREE - i - j;
                net.as_mut()[TriangleIndex::new([i, j, k]).position()] = finish(rest.as_mut(), k, &third);
                if k > 0 {
                    contract(along_second.as_mut(), k, &second);
                }
            }
            if i < B::DEGREE {
                contract(along_first.as_mut(), B::DEGREE - i, &first);
            }
        }
        net
    }
}
