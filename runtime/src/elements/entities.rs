//! Which functions belong to which corner, edge, face, or to the inside of a cell.

use alloc::vec::Vec;

use super::cell::{Factor, places};
use crate::{Point, Scalar};

/// A corner, an edge, a face of a cell, or the cell itself.
///
/// Corners are numbered: on a simplex the corner `j` is where the coordinate `j` is 1; on an interval 0 is the lower end;
/// on boxes and products they stand in lexicographic order, low before high and the last factor fastest, so that the wedge
/// over `(u, v, w), z` has the corners `u = 1` below and above, `v = 1` below and above, `w = 1` below and above.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Entity {
    dimension: usize,
    corners: Vec<usize>,
}

impl Entity {
    /// The dimension: 0 of a corner, 1 of an edge, 2 of a face.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The numbers of its corners, in increasing order.
    pub fn corners(&self) -> &[usize] {
        &self.corners
    }
}

/// The corner, edge, face or cell to which each function of a family belongs: the one on which it does not vanish,
/// while it vanishes on every side of the cell that does not contain it.
///
/// Functions of neighbouring cells that belong to one corner, edge or face and agree on it make a continuous function
/// together; those of the inside take no part in that. A function that vanishes on no side, or on too few for the rest
/// to have a point in common, belongs to nothing: with it, neighbours do not meet continuously.
///
/// ```
/// use basis_runtime::{SimplexBasis, basis};
///
/// basis!(library "lagrange", TriangularLagrange(3));
/// # fn main() {
/// // The indices (0,0,3) (0,1,2) (0,2,1) (0,3,0) (1,0,2) (1,1,1) (1,2,0) (2,0,1) (2,1,0) (3,0,0).
/// let entities = TriangularLagrange::<f64>::new().entities();
/// assert_eq!(entities.functions(&[1]), [3]); // the corner v = 1
/// assert_eq!(entities.functions(&[1, 2]), [1, 2]); // the edge from v = 1 to w = 1, without its ends
/// assert_eq!(entities.closure(&[1, 2]), [0, 1, 2, 3]); // with them
/// assert_eq!(entities.functions(&[0, 1, 2]), [5]); // the inside
/// # }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entities {
    of: Vec<Option<Entity>>,
}

impl Entities {
    /// To what the function `i` belongs; `None` if it belongs to nothing.
    ///
    /// # Panics
    /// If there is no function `i`.
    pub fn entity(&self, i: usize) -> Option<&Entity> {
        self.of[i].as_ref()
    }

    /// The functions that belong to the corner, edge, face or cell with exactly these corners, in increasing order.
    pub fn functions(&self, corners: &[usize]) -> Vec<usize> {
        self.chosen(|entity| {
            entity.corners.len() == corners.len() && entity.corners.iter().all(|c| corners.contains(c))
        })
    }

    /// The functions that belong to the corner, edge, face or cell with these corners or to a part of it: those that do
    /// not vanish there, in increasing order.
    pub fn closure(&self, corners: &[usize]) -> Vec<usize> {
        self.chosen(|entity| entity.corners.iter().all(|c| corners.contains(c)))
    }

    /// The functions that belong to corners (0), edges (1), faces (2), in increasing order.
    pub fn of_dimension(&self, dimension: usize) -> Vec<usize> {
        self.chosen(|entity| entity.dimension == dimension)
    }

    /// Whether every function belongs to something, so that continuous functions over several cells can be made.
    pub fn is_complete(&self) -> bool {
        self.of.iter().all(Option::is_some)
    }

    fn chosen(&self, test: impl Fn(&Entity) -> bool) -> Vec<usize> {
        let tested = self.of.iter().enumerate();
        tested.filter(|(_, entity)| entity.as_ref().is_some_and(&test)).map(|(i, _)| i).collect()
    }
}

/// Of the functions with these Bernstein coefficients: whether each vanishes where only the rows chosen do not.
fn vanishing<V: Point>(weights: &[V], mut chosen: impl FnMut(usize) -> bool) -> Vec<bool> {
    let mut largest = alloc::vec![[V::Scalar::ZERO; 2]; V::DIM];
    for (row, weights) in weights.iter().enumerate() {
        let here = chosen(row);
        for (i, [side, all]) in largest.iter_mut().enumerate() {
            let size = weights.component(i).abs();
            *all = all.max(size);
            if here {
                *side = side.max(size);
            }
        }
    }
    let noise = V::Scalar::of(64.0) * V::Scalar::EPSILON;
    largest.into_iter().map(|[side, all]| side <= noise * all).collect()
}

/// For the functions with these Bernstein coefficients on a product of factors, those of the last one fastest.
pub(crate) fn in_cell<V: Point>(weights: &[V], factors: &[Factor]) -> Entities {
    let places: Vec<Vec<usize>> = (0..weights.len()).map(|row| places(factors, row)).collect();
    // Of each function in each factor: whether it vanishes on the side opposite to each corner.
    let sides = |(k, factor): (usize, &Factor)| {
        let side = |corner| vanishing(weights, |row| factor.index(places[row][k])[corner] == 0);
        (0..factor.corners).map(side).collect::<Vec<_>>()
    };
    let zero: Vec<Vec<Vec<bool>>> = factors.iter().enumerate().map(sides).collect();
    let of = (0..V::DIM).map(|i| {
        let (mut dimension, mut corners) = (0, alloc::vec![0]);
        for sides in &zero {
            let own: Vec<usize> = (0..sides.len()).filter(|&corner| sides[corner][i]).collect();
            dimension += own.len().checked_sub(1)?;
            corners =
                corners.iter().flat_map(|c| own.iter().map(move |corner| sides.len() * c + corner)).collect();
        }
        Some(Entity { dimension, corners })
    });
    Entities { of: of.collect() }
}
