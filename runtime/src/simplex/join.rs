//! Joins of triangular patches: a second patch that continues a first one across an edge.

use alloc::vec::Vec;

use super::bernstein::elevate;
use super::edge::TriangleEdge;
use super::index::TriangleIndex;
use super::{SimplexPatch, TriangularBasis};
use crate::vector::largest_component;
use crate::{Array, JoinError, Point, Scalar};

impl<B: TriangularBasis, P: Point<Scalar = B::Scalar>> SimplexPatch<B, P> {
    /// The patch over another basis that continues this one across an edge, C0, G1, or of a higher order of contact.
    ///
    /// The polynomial of this patch goes on beyond the edge; the new patch touches it up to the derivatives of that
    /// order over the triangle from the edge to `apex`, a point beyond it in barycentric coordinates of this patch. Its
    /// edge w = 0 is the common edge, from its corner u = 1 at the end of `edge` to its corner v = 1 at the start, so
    /// that both patches have one orientation. For Bézier patches and the order 1 that are the classical conditions
    ///
    /// ```text
    /// Q[i,j,0] = E[i,j],   Q[i,j,1] = a E[i+1,j] + b E[i,j+1] + c F[i,j]     with apex = (a, b, c), c < 0
    /// ```
    ///
    /// with the rows E and F of this patch next to the edge: every pair of triangles in the nets along the edge is one
    /// affine image of the two triangles of parameters. The control points of the new patch with `w` components up to
    /// `order` are determined by elimination, whatever the families; those that do not matter, and all others, are
    /// those of `points`.
    ///
    /// ```
    /// use basis_runtime::{TriangleEdge, TriangularBernsteinBasis, TriangularBezier};
    ///
    /// // z = x y, at w = 1, v = 1 and u = 1 the places (0, 0), (0, 1) and (1, 0).
    /// let first = TriangularBezier::<[f64; 3], 3, 6>::from_points([
    ///     [0.0, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 1.0, 0.0], [0.5, 0.0, 0.0], [0.5, 0.5, 0.5], [1.0, 0.0, 0.0],
    /// ]);
    /// let basis = TriangularBernsteinBasis::<f64, 3, 6>::new();
    /// // Beyond the edge w = 0 to the place (1, 1); its far corner may be anywhere.
    /// let second = first.continued(TriangleEdge::W, [1.0, 1.0, -1.0], 1, basis, [[1.0, 1.0, 3.0]; 6])?;
    /// assert_eq!(second.control_points(), [
    ///     [1.0, 1.0, 3.0], [1.0, 0.5, 0.5], [1.0, 0.0, 0.0], [0.5, 1.0, 0.5], [0.5, 0.5, 0.5], [0.0, 1.0, 0.0],
    /// ]);
    /// # Ok::<(), basis_runtime::JoinError>(())
    /// ```
    ///
    /// # Errors
    /// [`JoinError::Apex`] if `apex` is not beyond the edge; [`JoinError::Contact`] if the order is above that of the
    /// family or its degree below that of this patch; [`JoinError::Unreachable`] if no control points of the family
    /// with these shape values touch the patch, as for the first families of *Two classes of triangular quasi-Bézier
    /// surfaces*, whose cross derivatives contain more polynomials than control points; also if anything is not finite.
    pub fn continued<C: TriangularBasis<Scalar = B::Scalar>>(
        &self,
        edge: TriangleEdge,
        apex: [B::Scalar; 3],
        order: usize,
        basis: C,
        points: C::Points<P>,
    ) -> Result<SimplexPatch<C, P>, JoinError> {
        let [start, end] = edge.corners();
        let beyond = apex[3 - start - end];
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
        let mut net = self.part([corner(end), corner(start), apex]).control_points().to_vec();
        net.resize(<C::Bernstein<()> as Array<()>>::LEN, P::zero());
        elevate(&mut net, B::DEGREE, C::DEGREE);

        let next_to_the_edge = |index: &TriangleIndex| index.components()[2] <= order;
        let unknown: Vec<usize> =
            TriangleIndex::all(rows).filter(next_to_the_edge).map(TriangleIndex::position).collect();
        let weights = basis.bernstein_weights();
        let given = basis.to_bernstein(&points);
        let mut system: Vec<(Vec<B::Scalar>, P)> = TriangleIndex::all(C::DEGREE)
            .filter(next_to_the_edge)
            .map(|index| {
                let row = weights.as_ref()[index.position()];
                let target = net[index.position()].minus(given.as_ref()[index.position()]);
                (unknown.iter().map(|&place| row.component(place)).collect(), target)
            })
            .collect();
        let size = net.iter().chain(given.as_ref()).fold(B::Scalar::ZERO, |a, &p| {
            let b = largest_component(p);
            if b <= a { a } else { b }
        });
        let changes = solve(&mut system, unknown.len(), size).ok_or(JoinError::Unreachable)?;
        let mut points = points;
        for (place, change) in unknown.into_iter().zip(changes) {
            let point = &mut points.as_mut()[place];
            *point = P::from_components(|c| point.component(c) + change.component(c));
        }
        Ok(SimplexPatch::new(basis, points))
    }
}

/// Solves linear equations by elimination with the largest pivots; unknowns that do not matter are zero. `None` if
/// there is no solution, up to rounding errors of points of that size.
fn solve<P: Point>(system: &mut [(Vec<P::Scalar>, P)], unknowns: usize, size: P::Scalar) -> Option<Vec<P>> {
    let noise = P::Scalar::EPSILON * P::Scalar::from_usize(64 * (unknowns + 1));
    let mut solved: Vec<usize> = Vec::new();
    while solved.len() < system.len() {
        let first = solved.len();
        let entries = (first..system.len()).flat_map(|row| (0..unknowns).map(move |column| (row, column)));
        let entry = |(row, column): (usize, usize)| system[row].0[column].abs();
        let Some(pivot) = entries.reduce(|a, b| if entry(b) > entry(a) { b } else { a }) else { break };
        if entry(pivot) <= noise {
            break;
        }
        system.swap(first, pivot.0);
        let column = pivot.1;
        let (head, rest) = system.split_at_mut(first + 1);
        let (row, right) = &head[first];
        for (other, target) in rest {
            let factor = other[column] / row[column];
            if factor != P::Scalar::ZERO {
                for (a, &b) in other.iter_mut().zip(row) {
                    *a = *a - factor * b;
                }
                other[column] = P::Scalar::ZERO;
                *target = target.add_scaled(*right, -factor);
            }
        }
        solved.push(column);
    }
    let left_over = &system[solved.len()..];
    if !left_over.iter().all(|(_, target)| largest_component(*target) <= noise * size * P::Scalar::of(16.0)) {
        return None;
    }
    let mut changes = alloc::vec![P::zero(); unknowns];
    for (k, &column) in solved.iter().enumerate().rev() {
        let (row, right) = &system[k];
        let mut value = *right;
        for &later in &solved[k + 1..] {
            value = value.add_scaled(changes[later], -row[later]);
        }
        changes[column] = P::from_components(|c| value.component(c) / row[column]);
    }
    changes.iter().all(|&change| crate::vector::is_finite(change)).then_some(changes)
}
