//! Joins of triangular patches: a second patch that continues a first one across an edge.

use alloc::vec::Vec;

use super::bernstein::elevate;
use super::edge::TriangleEdge;
use super::index::TriangleIndex;
use super::{SimplexPatch, TriangularBasis};
use crate::numeric::linear::solve;
use crate::vector::{difference, largest_component};
use crate::{Array, EdgePair, JoinError, Orientation, Point, Scalar};

/// How a triangular patch continues another one across an edge.
///
/// No parameter of a triangle runs across an edge, for which a [`Contact`](crate::Contact) could have a factor.
/// Instead, the polynomial of the first patch goes on beyond the edge. The second one agrees with it, over the triangle
/// from the edge to the apex, in all derivatives up to the order: 0 is a common edge, 1 is G1.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct TriangleContact<S> {
    /// The order of the contact.
    pub order: usize,
    /// The third corner of the triangle of the second patch, a point beyond the edge in barycentric coordinates of the first.
    pub apex: [S; 3],
}

impl<S> TriangleContact<S> {
    /// The contact of that order, over the triangle from the edge to that point, in barycentric coordinates of the first
    /// patch.
    pub const fn new(order: usize, apex: [S; 3]) -> Self {
        Self { order, apex }
    }
}

impl<B: TriangularBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The patch `next`, over any family, moved so that it continues this one across an edge of each, with that
    /// contact.
    ///
    /// Edges and their directions may be any but the corner [`Edge::UEnd`](crate::Edge::UEnd). For Bézier patches and
    /// the order 1 the conditions are the classical ones, here for the edges w = 0 of both in the same direction,
    ///
    /// ```text
    /// Q[i,j,0] = E[i,j],   Q[i,j,1] = a E[i+1,j] + b E[i,j+1] + c F[i,j]     with apex = (a, b, c), c < 0
    /// ```
    ///
    /// with the rows E and F of this patch next to the edge: every pair of triangles in the nets along the edge is one
    /// affine image of the two triangles of parameters. The control points of the new patch in the rows next to its
    /// edge, one more than `order`, are determined by elimination, whatever the families; those that do not matter, and
    /// all others, are those of `next`.
    ///
    /// ```
    /// use basis_runtime::{Edge, EdgePair, Surface, TriangleContact, TriangularBezier};
    ///
    /// // z = x y, at w = 1, v = 1 and u = 1 the places (0, 0), (0, 1) and (1, 0).
    /// let first = TriangularBezier::<[f64; 3], 3, 6>::from_points([
    ///     [0.0, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.5, 0.0, 0.0], [0.5, 0.5, 0.5], [1.0, 0.0, 0.0],
    /// ]);
    /// let draft = TriangularBezier::<[f64; 3], 3, 6>::from_points([[1.0, 1.0, 3.0]; 6]);
    /// // Beyond the edge w = 0 to the place (1, 1); its far corner may be anywhere.
    /// let edges = EdgePair::against(Edge::VEnd, Edge::VEnd);
    /// let second = first.continued(edges, TriangleContact::new(1, [1.0, 1.0, -1.0]), &draft)?;
    /// assert_eq!(second.control_points(), [
    ///     [1.0, 1.0, 3.0], [1.0, 0.5, 0.5], [1.0, 0.0, 0.0], [0.5, 1.0, 0.5], [0.5, 0.5, 0.5], [0.0, 1.0, 0.0],
    /// ]);
    /// assert_eq!(first.joint(edges, &second, 65).geometric_order(1e-14, 1e-7, 1e-9), Some(1));
    /// # Ok::<(), basis_runtime::JoinError>(())
    /// ```
    ///
    /// # Errors
    /// [`JoinError::Corner`] if an edge is a corner; [`JoinError::Apex`] if `apex` is not beyond the edge;
    /// [`JoinError::Contact`] if the order is above that of the family or its degree below that of this patch;
    /// [`JoinError::Unreachable`] if no control points of the family with these shape values touch the patch, as for
    /// the first families of *Two classes of triangular quasi-Bézier surfaces*, whose cross derivatives contain more
    /// polynomials than control points; also if anything is not finite.
    pub fn continued<C: TriangularBasis<Scalar = B::Scalar>>(
        &self,
        edges: EdgePair,
        TriangleContact { order, apex }: TriangleContact<B::Scalar>,
        next: &SimplexPatch<C, P>,
    ) -> Result<SimplexPatch<C, P>, JoinError> {
        let [first, second] = [edges.first, edges.second].map(TriangleEdge::of);
        let (Some(first), Some(second)) = (first, second) else { return Err(JoinError::Corner) };
        let beyond = apex[first.opposite()];
        // NaN is not beyond.
        if !(beyond < B::Scalar::ZERO && apex.iter().all(|x| x.is_finite())) {
            return Err(JoinError::Apex { value: beyond.to_f64() });
        }
        let rows = C::ORDER.unwrap_or(0);
        if order > rows || C::DEGREE < B::DEGREE {
            return Err(JoinError::Contact { most: rows, found: order });
        }
        let corner = |place: usize| {
            let mut corner = [B::Scalar::ZERO; 3];
            corner[place] = B::Scalar::ONE;
            corner
        };
        let ends = match edges.orientation {
            Orientation::Same => first.corners(),
            Orientation::Opposite => [first.corners()[1], first.corners()[0]],
        };
        let mut corners = [apex; 3];
        for (place, end) in second.corners().into_iter().zip(ends) {
            corners[place] = corner(end);
        }
        let mut net = self.part(corners).control_points().to_vec();
        net.resize(<C::Bernstein<()> as Array<()>>::LEN, P::zero());
        elevate(&mut net, B::DEGREE, C::DEGREE);

        let next_to_the_edge = |index: &TriangleIndex| index.components()[second.opposite()] <= order;
        let unknown: Vec<usize> =
            TriangleIndex::all(rows).filter(next_to_the_edge).map(TriangleIndex::position).collect();
        let weights = next.basis().bernstein_weights();
        let given = next.to_bernstein();
        let mut system: Vec<(Vec<B::Scalar>, P)> = TriangleIndex::all(C::DEGREE)
            .filter(next_to_the_edge)
            .map(|index| {
                let row = weights.as_ref()[index.position()];
                let target = difference(net[index.position()], given.as_ref()[index.position()]);
                (unknown.iter().map(|&place| row.component(place)).collect(), target)
            })
            .collect();
        let size = net.iter().chain(given.as_ref()).fold(B::Scalar::ZERO, |a, &p| {
            let b = largest_component(p);
            if b <= a { a } else { b }
        });
        let changes = solve(&mut system, unknown.len(), size).ok_or(JoinError::Unreachable)?;
        let mut points = C::Points::<P>::from_fn(|i| next.control_points()[i]);
        for (place, change) in unknown.into_iter().zip(changes) {
            let point = &mut points.as_mut()[place];
            *point = P::from_components(|c| point.component(c) + change.component(c));
        }
        Ok(SimplexPatch::new(next.basis(), points))
    }
}
