//! The parameter square of one surface, cut into rectangles over which it is flat enough.

use alloc::collections::{BTreeMap, BTreeSet, BinaryHeap};
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::MeshError;
use super::patch::{Flatness, Patch};
use crate::{Edge, Scalar};

/// The width of the parameter square: parameters are whole numbers, so that equal ones are recognised.
pub(super) const WIDTH: u32 = 1 << 20;

/// The highest number of rectangles of one surface.
const MOST: usize = 1 << 21;

/// The number of rectangles from which on it is worth while to estimate how many there will be.
const MANY: usize = 1 << 14;

/// The number of rectangles that are cut for the estimate.
const CUTS: usize = 1 << 11;

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

impl Cell {
    /// Both halves, cut across the direction that bends more, or across the wider one if it is the twist that is too
    /// large or both are unknown; `None` of a rectangle that is as small as parameters allow.
    fn cut<S: Scalar>(self, flatness: &Flatness<S>) -> Option<[Self; 2]> {
        let [h, k] = [0, 1].map(|c| self.to[c] - self.from[c]);
        if h <= 1 && k <= 1 {
            return None;
        }
        let twisted = flatness.both > flatness.u.max(flatness.v);
        let across_u = if twisted || !(flatness.u > flatness.v || flatness.v > flatness.u) {
            h >= k
        } else {
            flatness.u > flatness.v
        };
        let axis = usize::from(h <= 1 || !across_u && k > 1);
        let middle = self.from[axis] + (self.to[axis] - self.from[axis]) / 2;
        let (mut before, mut after) = (self, self);
        before.to[axis] = middle;
        after.from[axis] = middle;
        Some([before, after])
    }
}

/// A rectangle with the number of rectangles that it would need if it bent everywhere as much as it may somewhere.
struct Estimate<S> {
    needed: f64,
    flatness: Flatness<S>,
    cell: Cell,
}

impl<S: Scalar> Estimate<S> {
    fn new(patch: &dyn Patch<S>, cell: Cell, tolerance: S) -> Self {
        let flatness = patch.flatness(cell.from.map(unit), cell.to.map(unit));
        let [u, v, both] = [flatness.u, flatness.v, flatness.both].map(|d| (d / tolerance).to_f64().max(1.0));
        Self { needed: both.max(Scalar::sqrt(u) * Scalar::sqrt(v)), flatness, cell }
    }

    /// The sum of the widths.
    fn size(&self) -> u32 {
        self.cell.to[0] - self.cell.from[0] + self.cell.to[1] - self.cell.from[1]
    }
}

impl<S: Scalar> Ord for Estimate<S> {
    /// The rectangle that needs most is the greatest; of those without a bound the smallest, so that one which never
    /// gets a bound is found at once.
    fn cmp(&self, other: &Self) -> Ordering {
        let needed = self.needed.total_cmp(&other.needed);
        needed.then(other.size().cmp(&self.size())).then(other.cell.from.cmp(&self.cell.from))
    }
}

impl<S: Scalar> PartialOrd for Estimate<S> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<S: Scalar> PartialEq for Estimate<S> {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl<S: Scalar> Eq for Estimate<S> {}

/// The error if a rectangle will never be flat enough, or if more are needed than there may be, as far as the bounds
/// over some thousand of them tell, always over those that need most.
fn foreseen<S: Scalar>(patch: &dyn Patch<S>, tolerance: S, surface: usize) -> Result<(), MeshError> {
    let too_fine = MeshError::TooFine { surface, most: MOST };
    let mut heap = BinaryHeap::new();
    heap.push(Estimate::new(patch, Cell { from: [0, 0], to: [WIDTH, WIDTH] }, tolerance));
    for _ in 0..CUTS {
        let Some(worst) = heap.pop().filter(|worst| worst.needed > 1.0) else { break };
        match worst.cell.cut(&worst.flatness) {
            Some(halves) => heap.extend(halves.map(|half| Estimate::new(patch, half, tolerance))),
            None => {
                return Err(if worst.needed.is_finite() {
                    too_fine
                } else {
                    MeshError::NotFinite { surface }
                });
            }
        }
    }
    let needed: f64 = heap.iter().map(|estimate| estimate.needed).filter(|needed| needed.is_finite()).sum();
    if needed > 1.25 * MOST as f64 { Err(too_fine) } else { Ok(()) }
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
        let too_fine = MeshError::TooFine { surface, most: MOST };
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
                let count = cells.leaves.len();
                if count + open.len() > MOST {
                    return Err(too_fine);
                }
                if count == MANY {
                    foreseen(patch, tolerance, surface)?;
                }
                continue;
            }
            let Some([before, after]) = cell.cut(&flatness) else {
                let finite = distance.is_finite();
                return Err(if finite { too_fine } else { MeshError::NotFinite { surface } });
            };
            open.extend([after, before]);
            if open.len() > MOST {
                return Err(too_fine);
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
