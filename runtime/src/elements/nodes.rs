//! The nodes of nodal families: one point for each function, at which it is 1 and all others are 0.
//!
//! A family whose functions are nodal at points `x[i]` and span the coordinates has `Σ x[i] b[i] = x`. So the nodes are
//! the coefficients of the coordinates in the basis, wherever they are.

use alloc::vec::Vec;

use super::tabulation::lattice;
use crate::domain::from_unit;
use crate::{Array, Basis, BoxBasis, Point, Scalar, SimplexBasis};

/// The nodes of a family on an interval.
pub(crate) fn interval_nodes<B: Basis>(basis: &B) -> Option<B::Points<B::Scalar>> {
    let rows: Vec<f64> = (0..=B::DEGREE).map(|j| j as f64).collect();
    let found = coordinates(basis.bernstein_weights().as_ref(), &rows, &[B::DEGREE])?;
    let nodes = B::Points::from_fn(|i| from_unit(B::domain(), B::Scalar::of(found[i])));
    nodal(nodes.as_ref(), |&at| basis.values(at)).then_some(nodes)
}

/// The nodes of a family on a simplex.
pub(crate) fn simplex_nodes<B: SimplexBasis>(basis: &B) -> Option<B::Points<B::Coordinates>> {
    let corners = <B::Coordinates as Array<B::Scalar>>::LEN;
    let rows: Vec<f64> = lattice(corners, B::DEGREE).into_iter().map(|k| k as f64).collect();
    let degrees = alloc::vec![B::DEGREE; corners];
    let found = coordinates(basis.bernstein_weights().as_ref(), &rows, &degrees)?;
    let nodes = B::Points::from_fn(|i| B::Coordinates::from_fn(|j| B::Scalar::of(found[i * corners + j])));
    nodal(nodes.as_ref(), |&at| basis.values(at)).then_some(nodes)
}

/// The nodes of a family on a box.
pub(crate) fn box_nodes<B: BoxBasis>(basis: &B) -> Option<B::Points<B::Coordinates>> {
    let axes = B::DEGREES.len();
    let weights = basis.bernstein_weights();
    let mut rows = Vec::new();
    for row in 0..weights.as_ref().len() {
        let mut rest = row;
        let start = rows.len();
        rows.resize(start + axes, 0.0);
        for (axis, &degree) in B::DEGREES.iter().enumerate().rev() {
            rows[start + axis] = (rest % (degree + 1)) as f64;
            rest /= degree + 1;
        }
    }
    let found = coordinates(weights.as_ref(), &rows, B::DEGREES)?;
    let [low, high] = B::domain();
    let nodes = B::Points::from_fn(|i| {
        B::Coordinates::from_fn(|d| {
            from_unit([low.as_ref()[d], high.as_ref()[d]], B::Scalar::of(found[i * axes + d]))
        })
    });
    nodal(nodes.as_ref(), |&at| basis.values(at)).then_some(nodes)
}

/// Whether the functions have the values 1 and 0 at the nodes, up to rounding errors.
fn nodal<V: Point, X>(nodes: &[X], values: impl Fn(&X) -> V) -> bool {
    let tolerance = V::Scalar::EPSILON.sqrt();
    nodes.iter().enumerate().all(|(i, node)| {
        let values = values(node);
        (0..V::DIM).all(|j| {
            let expected = if i == j { V::Scalar::ONE } else { V::Scalar::ZERO };
            (values.component(j) - expected).abs() <= tolerance
        })
    })
}

/// The coefficients of the unit coordinates in the functions with these Bernstein coefficients; `indices` holds the index
/// of each row, whose quotients by the degrees are the Bernstein coefficients of the coordinates.
fn coordinates<V: Point>(weights: &[V], indices: &[f64], degrees: &[usize]) -> Option<Vec<f64>> {
    if degrees.contains(&0) {
        return None;
    }
    let columns = degrees.len();
    let mut matrix = Vec::with_capacity(weights.len() * (V::DIM + columns));
    for (row, indices) in weights.iter().zip(indices.chunks_exact(columns)) {
        matrix.extend((0..V::DIM).map(|i| row.component(i).to_f64()));
        matrix.extend(indices.iter().zip(degrees).map(|(index, &degree)| index / degree as f64));
    }
    least_squares(matrix, weights.len(), V::DIM, columns)
}

/// The solution of an overdetermined linear system by Householder's reflections: each row of the matrix has `unknowns`
/// coefficients and then `columns` right-hand sides; `None` if the rank is lower up to rounding errors.
#[inline]
fn least_squares(mut matrix: Vec<f64>, rows: usize, unknowns: usize, columns: usize) -> Option<Vec<f64>> {
    let width = unknowns + columns;
    if rows < unknowns {
        return None;
    }
    let size = matrix.iter().fold(0.0_f64, |size, c| size.max(c.abs()));
    for k in 0..unknowns {
        let norm =
            Scalar::sqrt((k..rows).map(|r| matrix[r * width + k] * matrix[r * width + k]).sum::<f64>());
        if norm.is_nan() || norm <= 1e-13 * size {
            return None;
        }
        let pivot = if matrix[k * width + k] > 0.0 { -norm } else { norm };
        let mut normal: Vec<f64> = (k..rows).map(|r| matrix[r * width + k]).collect();
        normal[0] -= pivot;
        let square: f64 = normal.iter().map(|c| c * c).sum();
        for column in k..width {
            let along: f64 = normal.iter().zip(k..).map(|(c, r)| c * matrix[r * width + column]).sum();
            let factor = 2.0 * along / square;
            for (c, r) in normal.iter().zip(k..) {
                matrix[r * width + column] -= factor * c;
            }
        }
    }
    let mut solution = alloc::vec![0.0; unknowns * columns];
    for c in 0..columns {
        for k in (0..unknowns).rev() {
            let known: f64 =
                (k + 1..unknowns).map(|j| matrix[k * width + j] * solution[j * columns + c]).sum();
            solution[k * columns + c] = (matrix[k * width + unknowns + c] - known) / matrix[k * width + k];
        }
    }
    Some(solution)
}
