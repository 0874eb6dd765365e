//! The nodes of nodal families: one point for each function, at which it is 1 and all others are 0.
//!
//! A family whose functions are nodal at points `x[i]` and span the coordinates has `Σ x[i] b[i] = x`. So the nodes are
//! the coefficients of the coordinates in the basis, wherever they are. Those that the boundary of the cell has but for the
//! rounding errors of the solution lie on it.

use alloc::vec::Vec;

use super::cell::{Factor, places, product};
use crate::domain::from_unit;
use crate::{Array, Basis, BoxBasis, Point, ProductBasis, Scalar, SimplexBasis};

/// The nodes of a family on an interval.
pub(crate) fn interval_nodes<B: Basis>(basis: &B) -> Option<B::Points<B::Scalar>> {
    let found = coordinates(basis.bernstein_weights().as_ref(), &[Factor::interval(B::DEGREE)])?;
    let nodes = B::Points::from_fn(|i| from_unit(B::domain(), B::Scalar::of(found[i])));
    nodal(nodes.as_ref(), |&at| basis.values(at)).then_some(nodes)
}

/// The nodes of a family on a simplex.
pub(crate) fn simplex_nodes<B: SimplexBasis>(basis: &B) -> Option<B::Points<B::Coordinates>> {
    let corners = <B::Coordinates as Array<B::Scalar>>::LEN;
    let found = coordinates(basis.bernstein_weights().as_ref(), &[Factor::simplex(corners, B::DEGREE)])?;
    let nodes = B::Points::from_fn(|i| B::Coordinates::from_fn(|j| B::Scalar::of(found[i * corners + j])));
    nodal(nodes.as_ref(), |&at| basis.values(at)).then_some(nodes)
}

/// The nodes of a family on a box.
pub(crate) fn box_nodes<B: BoxBasis>(basis: &B) -> Option<B::Points<B::Coordinates>> {
    let factors: Vec<Factor> = B::DEGREES.iter().map(|&degree| Factor::interval(degree)).collect();
    let found = coordinates(basis.bernstein_weights().as_ref(), &factors)?;
    let nodes: B::Points<B::Coordinates> = placed(&found, B::domain());
    nodal(nodes.as_ref(), |&at| basis.values(at)).then_some(nodes)
}

/// The nodes of a family on a product of simplices and intervals.
pub(crate) fn product_nodes<B: ProductBasis>(basis: &B) -> Option<B::Points<B::Coordinates>> {
    let found = coordinates(basis.bernstein_weights().as_ref(), &product(B::FACTORS))?;
    let nodes: B::Points<B::Coordinates> = placed(&found, B::domain());
    nodal(nodes.as_ref(), |&at| basis.values(at)).then_some(nodes)
}

/// The points with these coordinates in units of a domain, one after the other.
fn placed<S: Scalar, X: Array<S>, N: Array<X>>(units: &[f64], [low, high]: [X; 2]) -> N {
    N::from_fn(|i| {
        let unit = |d| S::of(units[i * X::LEN + d]);
        X::from_fn(|d| from_unit([low.as_ref()[d], high.as_ref()[d]], unit(d)))
    })
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

/// The coefficients of the unit coordinates in the functions with these Bernstein coefficients: of an interval the
/// coordinate, of a simplex all barycentric ones. The Bernstein coefficients of a coordinate are the quotients of the
/// components of the indices by the degree.
fn coordinates<V: Point>(weights: &[V], factors: &[Factor]) -> Option<Vec<f64>> {
    if factors.iter().any(|factor| factor.degree == 0) {
        return None;
    }
    let columns: usize = factors.iter().map(|factor| factor.coordinates.len()).sum();
    let mut matrix = Vec::with_capacity(weights.len() * (V::DIM + columns));
    for (row, weights) in weights.iter().enumerate() {
        matrix.extend((0..V::DIM).map(|i| weights.component(i).to_f64()));
        for (factor, place) in factors.iter().zip(places(factors, row)) {
            let index = &factor.index(place)[factor.coordinates.clone()];
            matrix.extend(index.iter().map(|&k| k as f64 / factor.degree as f64));
        }
    }
    let mut found = least_squares(matrix, weights.len(), V::DIM, columns)?;
    for node in found.chunks_mut(columns) {
        let mut rest = node;
        for factor in factors {
            let (own, others) = rest.split_at_mut(factor.coordinates.len());
            on_boundary(own, NOISE * V::Scalar::EPSILON.to_f64());
            rest = others;
        }
    }
    Some(found)
}

/// The errors that rounding leaves in coordinates, at most, in rounding errors of the coefficients of the functions.
const NOISE: f64 = 256.0;

/// Moves a point that lies on the boundary of a factor up to rounding errors to it. The barycentric coordinates of a simplex
/// have the sum 1 again, by what is not rounded of the largest.
fn on_boundary(coordinates: &mut [f64], noise: f64) {
    for c in coordinates.iter_mut() {
        for end in [0.0, 1.0] {
            if (*c - end).abs() <= noise {
                *c = end;
            }
        }
    }
    if coordinates.len() > 1 {
        let largest =
            (0..coordinates.len()).fold(0, |a, b| if coordinates[b] > coordinates[a] { b } else { a });
        let others: f64 = (0..coordinates.len()).filter(|&i| i != largest).map(|i| coordinates[i]).sum();
        coordinates[largest] = 1.0 - others;
    }
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
