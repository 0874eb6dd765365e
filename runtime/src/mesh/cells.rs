//! The parameter square of one surface, cut into rectangles over which it is flat enough.

use alloc::collections::{BTreeMap, BTreeSet};
use alloc::vec::Vec;

use super::MeshError;
use super::patch::Patch;
use crate::{Edge, Scalar};

/// The width of the parameter square: parameters are whole numbers, so that equal ones are recognised.
pub(super) const WIDTH: u32 = 1 << 20;

/// The highest number of rectangles of one surface.
const MOST: usize = 1 << 21;

/// A parameter as a number between 0 and 1.
pub(super) fn unit<S: Scalar>(parameter: u32) -> S {
    S::from_usize(parameter as usize) / S::from_usize(WIDTH as usize)
}

/// A point of the parameter square.
pub(super) type Node = [u32; 2];

/// A rectangle of the parameter square.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub(super) from: Node,
    pub(super) to: Node,
}

/// The rectangles, and the corners on each line.
#[derive(Debug, Default)]
pub(super) struct Cells {
    pub(super) leaves: Vec<Cell>,
    /// For each line `u = const` the `v` of the corners on it.
    on_u: BTreeMap<u32, BTreeSet<u32>>,
    /// For each line `v = const` the `u` of the corners on it.
    on_v: BTreeMap<u32, BTreeSet<u32>>,
}

impl Cells {
    /// Cuts until every rectangle is flat within the tolerance.
    pub(super) fn new<S: Scalar>(
        patch: &dyn Patch<S>,
        tolerance: S,
        surface: usize,
    ) -> Result<Self, MeshError> {
        let mut cells = Self::default();
        let mut open = alloc::vec![Cell { from: [0, 0], to: [WIDTH, WIDTH] }];
        while let Some(cell) = open.pop() {
            let flatness = patch.flatness(cell.from.map(unit), cell.to.map(unit));
            let distance = flatness.distance();
            if distance.is_nan() {
                return Err(MeshError::NotFinite { surface });
            }
            if distance <= tolerance {
                cells.add(cell);
                if cells.leaves.len() + open.len() > MOST {
                    return Err(MeshError::TooFine { surface, most: MOST });
                }
                continue;
            }
            let [h, k] = [0, 1].map(|c| cell.to[c] - cell.from[c]);
            // The direction that bends more; the wider one if it is the twist that is too large, or both are unknown.
            let by_u = if flatness.u > flatness.v {
                true
            } else if flatness.v > flatness.u {
                false
            } else {
                h >= k
            };
            let twisted = flatness.both > flatness.u.max(flatness.v);
            let cut_u = if twisted { h >= k } else { by_u };
            let axis = usize::from(!(if h <= 1 { false } else { cut_u || k <= 1 }));
            if h <= 1 && k <= 1 {
                let finite = distance.is_finite();
                let error = if finite {
                    MeshError::TooFine { surface, most: MOST }
                } else {
                    MeshError::NotFinite { surface }
                };
                return Err(error);
            }
            let middle = cell.from[axis] + (cell.to[axis] - cell.from[axis]) / 2;
            let (mut before, mut after) = (cell, cell);
            before.to[axis] = middle;
            after.from[axis] = middle;
            open.extend([after, before]);
            if open.len() > MOST {
                return Err(MeshError::TooFine { surface, most: MOST });
            }
        }
        Ok(cells)
    }

    fn add(&mut self, cell: Cell) {
        self.leaves.push(cell);
        for u in [cell.from[0], cell.to[0]] {
            for v in [cell.from[1], cell.to[1]] {
                self.on_u.entry(u).or_default().insert(v);
                self.on_v.entry(v).or_default().insert(u);
            }
        }
    }

    /// The parameters along an edge of the square, in increasing order.
    pub(super) fn edge(&mut self, edge: Edge) -> &mut BTreeSet<u32> {
        match edge {
            Edge::UStart => self.on_u.entry(0).or_default(),
            Edge::UEnd => self.on_u.entry(WIDTH).or_default(),
            Edge::VStart => self.on_v.entry(0).or_default(),
            Edge::VEnd => self.on_v.entry(WIDTH).or_default(),
        }
    }

    /// All corners around a rectangle, also those of smaller neighbours on its sides, counter-clockwise.
    pub(super) fn around(&self, cell: Cell) -> Vec<Node> {
        let Cell { from: [u0, v0], to: [u1, v1] } = cell;
        let along_u = |v: u32| self.on_v.get(&v).into_iter().flat_map(move |us| us.range(u0..=u1).copied());
        let along_v = |u: u32| self.on_u.get(&u).into_iter().flat_map(move |vs| vs.range(v0..=v1).copied());
        let mut nodes: Vec<Node> = Vec::with_capacity(8);
        nodes.extend(along_u(v0).take_while(|&u| u < u1).map(|u| [u, v0]));
        nodes.extend(along_v(u1).take_while(|&v| v < v1).map(|v| [u1, v]));
        let back = nodes.len();
        nodes.extend(along_u(v1).skip_while(|&u| u <= u0).map(|u| [u, v1]));
        nodes[back..].reverse();
        let back = nodes.len();
        nodes.extend(along_v(u0).skip_while(|&v| v <= v0).map(|v| [u0, v]));
        nodes[back..].reverse();
        nodes
    }
}

/// The node at a parameter along an edge.
pub(super) fn on_edge(edge: Edge, along: u32) -> Node {
    match edge {
        Edge::UStart => [0, along],
        Edge::UEnd => [WIDTH, along],
        Edge::VStart => [along, 0],
        Edge::VEnd => [along, WIDTH],
    }
}
