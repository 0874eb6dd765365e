//! Parts of triangular patches, their Bézier form and degree elevation.

use super::bernstein::{TriangularBernsteinOf, TriangularBezier, TriangularBezierOf, elevate};
use super::edge::TriangleEdge;
use super::index::TriangleIndex;
use super::net::{contract, moved_corner};
use super::{SimplexBasis, SimplexPatch, TriangularBasis, finish};
use crate::{Array, Point};

impl<B: TriangularBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The same patch as a Bézier patch of the same degree.
    pub fn to_bezier(&self) -> TriangularBezierOf<B, P> {
        bezier::<B, P>(&self.to_bernstein())
    }

    /// The same patch as a Bézier patch of degree `N - 1`, with `T` control points, `N` of them on each edge:
    ///
    /// ```text
    /// (n + 1) Q[i,j,k] = i P[i-1,j,k] + j P[i,j-1,k] + k P[i,j,k-1]     for each step from n to n + 1
    /// ```
    ///
    /// `N` must be greater than the degree of the family; this is checked when the call is compiled.
    ///
    /// ```
    /// use basis_runtime::TriangularBezier;
    ///
    /// let linear = TriangularBezier::<f64, 2, 3>::from_points([0.0, 6.0, 3.0]); // at w = 1, v = 1, u = 1
    /// assert_eq!(linear.elevate::<3, 6>().control_points(), [0.0, 3.0, 6.0, 1.5, 4.5, 3.0]);
    /// ```
    pub fn elevate<const N: usize, const T: usize>(&self) -> TriangularBezier<P, N, T> {
        const { assert!(N > B::DEGREE, "degree elevation cannot lower the degree") };
        let mut points = [P::zero(); T];
        let net = self.to_bernstein();
        points[..net.as_ref().len()].copy_from_slice(net.as_ref());
        elevate(&mut points, B::DEGREE, N - 1);
        TriangularBezier::from_points(points)
    }

    /// The two parts on both sides of the line from the point `t` of an edge to the opposite corner, that with the
    /// start of the edge first. Each has the corners of the patch in their places, but for the one that has moved to
    /// `t`.
    ///
    /// They share the control points of that line exactly.
    ///
    /// ```
    /// use basis_runtime::{TriangleEdge, TriangularBezier};
    ///
    /// let patch = TriangularBezier::<f64, 3, 6>::from_points([0.0, 0.0, 4.0, 2.0, 1.0, 8.0]);
    /// let [first, second] = patch.split_edge(TriangleEdge::W, 0.5); // from the corner v = 1 to the corner u = 1
    /// assert_eq!(second.eval_at([1.0, 0.0, 0.0]), 8.0);
    /// assert_eq!(second.eval_at([0.0, 1.0, 0.0]), 3.5);
    /// assert_eq!(first.edge_curve(TriangleEdge::V).control_points(), [0.0, 1.0, 3.5]);
    /// ```
    pub fn split_edge(&self, edge: TriangleEdge, t: P::Scalar) -> [TriangularBezierOf<B, P>; 2] {
        let [start, end] = edge.corners();
        let at = edge.point(t);
        [end, start].map(|place| bezier::<B, P>(&moved_corner(self.to_bernstein(), B::DEGREE, place, at)))
    }

    /// The part of the patch over the triangle with these corners, each given by its barycentric coordinates: the
    /// corner `u = 1` of the part first.
    ///
    /// Neighbouring parts share the points of their edge up to rounding errors; corners may lie outside of the
    /// triangle, where the polynomial is continued. With the same corners in another order it is the same patch, turned
    /// or turned over.
    ///
    /// ```
    /// use basis_runtime::TriangularBezier;
    ///
    /// let patch = TriangularBezier::<f64, 3, 6>::from_points([0.0, 0.0, 4.0, 2.0, 1.0, 8.0]);
    /// // The half on the side of the corner u = 1, cut from the corner v = 1 to the middle of the opposite edge.
    /// let half = patch.part([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.0, 0.5]]);
    /// assert_eq!(half.eval_at([0.25, 0.25, 0.5]), patch.eval_at([0.5, 0.25, 0.25]));
    /// ```
    pub fn part(&self, corners: [[B::Scalar; 3]; 3]) -> TriangularBezierOf<B, P> {
        // The point of the index (i, j, k) is the blossom of i times the first corner, j times the second, k times the
        // third.
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
        bezier::<B, P>(&net)
    }
}

/// The Bézier patch over these control points.
fn bezier<B: TriangularBasis, P: Point<Scalar = B::Scalar>>(
    net: &B::Bernstein<P>,
) -> TriangularBezierOf<B, P> {
    let points = <TriangularBernsteinOf<B> as SimplexBasis>::Points::<P>::from_fn(|k| net.as_ref()[k]);
    SimplexPatch::new(TriangularBernsteinOf::<B>::default(), points)
}
