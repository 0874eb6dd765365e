//! The parameter square of one surface, cut into rectangles over which it is flat enough.

use alloc::collections::{BTreeMap, BTreeSet, BinaryHeap};
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::facets::{Cell, Cut, Node, middle, triangles};
use super::flat::{self, Flatness, P3, Part};
use super::graph::{self, Corner};
use super::index::Index;
use super::limits::Limits;
use super::lines::{Lines, WIDTH};
use super::steps::lines;
use crate::mesh::MeshError;
use crate::mesh::patch::Patch;
use crate::vector::{cross, distance, dot, length, safe_unit};
use crate::{Edge, Scalar, SurfacePiece};

/// The highest number of rectangles of one surface.
const MOST: usize = 1 << 21;

/// The number of rectangles that are judged before it is estimated how many there will be.
const MANY: usize = 1 << 15;

/// The number of rectangles that are cut for the estimate.
const CUTS: usize = 1 << 11;

/// A parameter as a number between 0 and 1.
pub(in crate::mesh) fn unit<S: Scalar>(parameter: u32) -> S {
    S::from_usize(parameter as usize) / S::from_usize(WIDTH as usize)
}

impl Cell {
    const WHOLE: Self = Self { from: [0, 0], to: [WIDTH, WIDTH] };

    /// The corners, counter-clockwise.
    fn corners(self) -> [Node; 4] {
        let Self { from: [u0, v0], to: [u1, v1] } = self;
        [[u0, v0], [u1, v0], [u1, v1], [u0, v1]]
    }

    /// The direction in which to cut: across what bends more, or across the wider side if neither says much; `None` of
    /// a rectangle that is as small as parameters allow.
    fn direction(self, flatness: &Flatness, lines: &[Lines; 2]) -> Option<usize> {
        let [h, k] = [0, 1].map(|c| self.to[c] - self.from[c]);
        if h <= 1 && k <= 1 {
            return None;
        }
        let crosses = [0, 1].map(|c| lines[c].cross(self.from[c], self.to[c]));
        // A cut beside all lines would give corners to neighbours.
        let weight = |axis: usize| if crosses[axis] && !crosses[1 - axis] { 4.0 } else { 1.0 };
        let [u, v] = [0, 1].map(|axis| flatness.bends[axis] * weight(axis));
        let twisted = u.max(v) < 0.25 * flatness.distance && flatness.distance.is_finite();
        let across_u = if twisted || u == v { h >= k } else { u > v };
        Some(usize::from(h <= 1 || !across_u && k > 1))
    }

    /// The parts before and after a parameter.
    fn cut(self, axis: usize, along: u32) -> [Self; 2] {
        let (mut before, mut after) = (self, self);
        before.to[axis] = along;
        after.from[axis] = along;
        [before, after]
    }

    /// Whether one of these points, sorted as `[u, v]` and as `[v, u]`, lies within a side.
    fn has_on_sides(self, points: &[Vec<Node>; 2]) -> bool {
        [0, 1].into_iter().any(|axis| {
            let (from, to) = (self.from[1 - axis], self.to[1 - axis]);
            [self.from[axis], self.to[axis]].into_iter().any(|line| {
                let next = points[axis].partition_point(|&point| point <= [line, from]);
                points[axis].get(next).is_some_and(|&point| point < [line, to])
            })
        })
    }

    /// Whether a side lies on an edge of the parameter square.
    fn is_outer(self) -> bool {
        self.from.contains(&0) || self.to.contains(&WIDTH)
    }
}

/// A rectangle over which the surface is flat enough.
#[derive(Clone, Copy, Debug)]
pub(in crate::mesh) struct Leaf {
    pub(in crate::mesh) cell: Cell,
    /// The bound of the distance of its triangles from the surface, both ways.
    distance: f64,
    /// The number of corners around it for which its triangles are known to be good enough.
    corners: usize,
}

/// A rectangle that is not judged yet, with the parts of the surface over it and the points at its corners.
struct Open {
    cell: Cell,
    corners: [P3; 4],
    parts: Vec<Part>,
}

/// A surface and what its mesh has to keep.
pub(in crate::mesh) struct Sheet<'a, S> {
    patch: &'a dyn Patch<S>,
    pieces: Vec<SurfacePiece>,
    surface: usize,
    /// What lengths are measured in: fourth powers of them neither overflow nor vanish.
    unit: f64,
    limits: Limits,
    lines: [Lines; 2],
}

impl<'a, S: Scalar> Sheet<'a, S> {
    pub(in crate::mesh) fn new(patch: &'a dyn Patch<S>, surface: usize, limits: Limits) -> Self {
        let mut pieces = patch.bezier();
        let size =
            pieces.iter().map(|piece| piece.net.farthest(&[0.0; 3])).fold(limits.tolerance, flat::larger);
        let unit = if size.is_finite() { safe_unit(size, 2) } else { 1.0 };
        if unit != 1.0 {
            for piece in &mut pieces {
                piece.net = piece.net.seen_from(&[0.0; 3], unit);
            }
        }
        let limits = limits.measured_in(unit);
        let mut sheet = Self { patch, pieces, surface, unit, limits, lines: Default::default() };
        if sheet.flatness(&sheet.whole()).distance > sheet.allowed(Cell::WHOLE) {
            sheet.lines = sheet.lines();
        }
        sheet
    }

    /// The knots, and the parts of which the bend of the surface asks for.
    fn lines(&self) -> [Lines; 2] {
        let knots = [0, 1].map(|axis| {
            let [start, end] = [0, WIDTH].map(|along| self.parameter(axis, along));
            let along = |t: f64| ((t - start) / (end - start) * f64::from(WIDTH) + 0.5) as u32;
            self.pieces.iter().flat_map(|piece| piece.domain[axis]).map(along).collect()
        });
        let Limits { tolerance, reach, .. } = self.limits;
        lines(knots, tolerance, reach, |x| self.at(x.map(S::of)))
    }

    /// The largest distance of the triangles over a rectangle: those on edges have to leave something to the seams.
    fn allowed(&self, cell: Cell) -> f64 {
        self.limits.tolerance - if cell.is_outer() { self.limits.reach } else { 0.0 }
    }

    fn point(&self, node: Node) -> P3 {
        self.at(node.map(unit))
    }

    fn at(&self, uv: [S; 2]) -> P3 {
        self.patch.point(uv).map(|x| x.to_f64() / self.unit)
    }

    fn whole(&self) -> Open {
        self.open(Cell::WHOLE)
    }

    /// The parts of the surface over a rectangle.
    fn open(&self, cell: Cell) -> Open {
        let ranges = [0, 1].map(|axis| {
            let start = |at: u32| if at > 0 { self.parameter(axis, at) } else { f64::NEG_INFINITY };
            let end = |at: u32| if at < WIDTH { self.parameter(axis, at) } else { f64::INFINITY };
            [start(cell.from[axis]), end(cell.to[axis])]
        });
        let mut parts = flat::whole(&self.pieces, ranges);
        for axis in [0, 1] {
            if cell.from[axis] > 0 {
                [_, parts] = flat::cut(&self.pieces, parts, axis, ranges[axis][0]);
            }
            if cell.to[axis] < WIDTH {
                [parts, _] = flat::cut(&self.pieces, parts, axis, ranges[axis][1]);
            }
        }
        Open { cell, corners: cell.corners().map(|node| self.point(node)), parts }
    }

    fn parameter(&self, axis: usize, along: u32) -> f64 {
        self.patch.parameter(axis, unit(along))
    }

    fn cut(&self, open: Open, axis: usize) -> [Open; 2] {
        let along = self.lines[axis].between(open.cell.from[axis], open.cell.to[axis]);
        let [before, after] = open.cell.cut(axis, along);
        let [low, high] = flat::cut(&self.pieces, open.parts, axis, self.parameter(axis, along));
        let [a, b, c, d] = open.corners;
        let new = |index: usize| self.point(before.corners()[index]);
        let (corners_before, corners_after) = if axis == 0 {
            let (from, to) = (new(1), new(2));
            ([a, from, to, d], [from, b, c, to])
        } else {
            let (from, to) = (new(3), new(2));
            ([a, b, to, from], [from, to, c, d])
        };
        [
            Open { cell: before, corners: corners_before, parts: low },
            Open { cell: after, corners: corners_after, parts: high },
        ]
    }

    fn flatness(&self, open: &Open) -> Flatness {
        let corners = open.corners;
        let Cell { from, to } = open.cell;
        let halves = |n: [u32; 2]| {
            let at = [0, 1].map(|c| {
                (unit::<S>(from[c]) * S::from_usize(2 - n[c] as usize)
                    + unit::<S>(to[c]) * S::from_usize(n[c] as usize))
                    * S::of(0.5)
            });
            self.at(at)
        };
        let allowed = self.allowed(open.cell);
        // A rectangle that no line crosses is likely to be flat enough, so that samples would tell nothing new.
        let is_likely = (0..2).all(|axis| !self.lines[axis].cross(open.cell.from[axis], open.cell.to[axis]));
        let is_crowded = is_crowded(&corners, 2.0 * self.limits.weld);
        let measured = || flat::measure(&open.parts, corners, allowed, self.limits.weld);
        let mut flatness = if is_likely && !is_crowded { measured() } else { flat::sampled(corners, halves) };
        if flatness.distance <= allowed && (is_crowded || !is_likely) {
            let moved = flatness.distance;
            flatness = measured();
            // A corner in the middle moves the triangles.
            if is_crowded {
                flatness.distance += moved;
            }
        }
        let [a, b, c, d] = corners;
        let sides = [[a, b], [d, c], [a, d], [b, c]].map(|[from, to]| flat::distance(from, to));
        let lengths = [sides[0].max(sides[1]), sides[2].max(sides[3])];
        let [short, long] = [lengths[0].min(lengths[1]), lengths[0].max(lengths[1])];
        // Around a pole no cut makes a triangle less slender.
        let ends_in_a_point = sides.iter().any(|&side| side <= self.limits.weld);
        let is_slender = long > self.limits.aspect * short && !ends_in_a_point;
        if long > self.limits.edge || is_slender {
            flatness = Flatness { bends: lengths, distance: f64::INFINITY };
        } else if self.limits.angle < f64::PI && flatness.distance <= allowed {
            let turns = self.turns(open.cell);
            if turns[0].max(turns[1]) > self.limits.angle {
                flatness = Flatness { bends: turns, distance: f64::INFINITY };
            }
        }
        flatness
    }

    /// The largest angle between normals at corners along each parameter; those without a normal do not count.
    fn turns(&self, cell: Cell) -> [f64; 2] {
        let normals = cell.corners().map(|node| self.patch.normal(node.map(unit)));
        let angle = |i: usize, j: usize| match (normals[i], normals[j]) {
            (Some(a), Some(b)) => length(cross(a, b)).atan2(dot(a, b)).to_f64(),
            _ => 0.0,
        };
        [angle(0, 1).max(angle(3, 2)), angle(0, 3).max(angle(1, 2))]
    }

    /// The bound for a rectangle with one corner of a neighbour on a side, at which all triangles meet.
    ///
    /// With a point `f` of the opposite side the triangles are those of two quadrilaterals, one on each side of the line
    /// from that corner to `f`, and the bound holds for each of them. As `f` is not on the surface, the point of the
    /// surface that belongs to it may not be farther from it than that either.
    fn fan(&self, cell: Cell, nodes: &[Node]) -> Option<f64> {
        let points: Vec<P3> = nodes.iter().map(|&node| self.point(node)).collect();
        if nodes.len() != 5 || is_crowded(&points, 2.0 * self.limits.weld) {
            return None;
        }
        let corners = cell.corners();
        let node = *nodes.iter().find(|node| !corners.contains(node))?;
        let axis = usize::from(node[1] > cell.from[1] && node[1] < cell.to[1]);
        let is_low = node[1 - axis] == cell.from[1 - axis];
        let mut opposite = node;
        opposite[1 - axis] = if is_low { cell.to[1 - axis] } else { cell.from[1 - axis] };
        let ([a, b, c, d], apex, opposite) =
            (corners.map(|node| self.point(node)), self.point(node), self.point(opposite));
        let [from, to] = match (axis, is_low) {
            (0, true) => [d, c],
            (0, false) => [a, b],
            (_, true) => [b, c],
            (_, false) => [a, d],
        };
        let foot = flat::foot(opposite, from, to);
        let [low, high] = if is_low { [apex, foot] } else { [foot, apex] };
        let quadrilaterals = if axis == 0 {
            [[a, low, high, d], [low, b, c, high]]
        } else {
            [[a, b, high, low], [low, high, c, d]]
        };
        let parts = flat::cut(&self.pieces, self.open(cell).parts, axis, self.parameter(axis, node[axis]));
        let bounds = parts.iter().zip(quadrilaterals).map(|(parts, corners)| {
            flat::measure(parts, corners, self.allowed(cell), self.limits.weld).distance
        });
        Some(bounds.fold(flat::distance(opposite, foot), f64::max))
    }

    /// The bound for a rectangle with corners of neighbours on its sides, of its triangles as a graph.
    fn graph(&self, cell: Cell, nodes: &[Node]) -> Option<f64> {
        let points: Vec<P3> = nodes.iter().map(|&node| self.point(node)).collect();
        if is_crowded(&points, 2.0 * self.limits.weld) {
            return None;
        }
        let of_cell = cell.corners();
        let mut parts = self.open(cell).parts;
        let mut corners = Vec::with_capacity(nodes.len());
        for (&node, &point) in nodes.iter().zip(&points) {
            let is_on_side = !of_cell.contains(&node);
            let at = [0, 1].map(|axis| self.parameter(axis, node[axis]));
            if is_on_side {
                let axis = usize::from(node[0] == cell.from[0] || node[0] == cell.to[0]);
                let [mut before, after] = flat::cut(&self.pieces, parts, axis, at[axis]);
                before.extend(after);
                parts = before;
            }
            corners.push(Corner { point, at, is_on_side });
        }
        let mut all = Vec::with_capacity(nodes.len());
        triangles(
            cell,
            nodes,
            Cut::Shortest,
            || true,
            |triangle| {
                all.push(triangle.map(|node| match nodes.iter().position(|&other| other == node) {
                    Some(k) => points[k],
                    None => self.point(node),
                }));
            },
        );
        graph::bound(&parts, &corners, &all, self.limits.weld)
    }

    fn too_fine(&self) -> MeshError {
        MeshError::TooFine { surface: self.surface, most: MOST }
    }

    /// The error of a rectangle that is not flat enough and cannot be cut, also where the tolerance is as small as
    /// rounding errors.
    fn stuck(&self) -> MeshError {
        let size = self.pieces.iter().map(|piece| piece.net.farthest(&[0.0; 3])).fold(0.0, flat::larger);
        if size.is_finite() { self.too_fine() } else { MeshError::NotFinite { surface: self.surface } }
    }

    /// The error if a rectangle will never be flat enough, or if more are needed than there may be, as far as the
    /// bounds over some thousand of them tell, always over those that need most.
    fn foreseen(&self) -> Result<(), MeshError> {
        let mut heap = BinaryHeap::new();
        heap.push(Estimate::new(self, self.whole()));
        for _ in 0..CUTS {
            let Some(worst) = heap.pop().filter(|worst| worst.needed > 1.0) else { break };
            let Some(axis) = worst.open.cell.direction(&worst.flatness, &self.lines) else {
                return Err(self.stuck());
            };
            heap.extend(self.cut(worst.open, axis).map(|half| Estimate::new(self, half)));
        }
        let needed: f64 =
            heap.iter().map(|estimate| estimate.needed).filter(|needed| needed.is_finite()).sum();
        if needed > 4.0 * MOST as f64 { Err(self.too_fine()) } else { Ok(()) }
    }
}

/// A rectangle with the number of rectangles that it would need if it bent everywhere as much as it may somewhere.
struct Estimate {
    needed: f64,
    flatness: Flatness,
    open: Open,
}

impl Estimate {
    fn new<S: Scalar>(sheet: &Sheet<'_, S>, open: Open) -> Self {
        let flatness = sheet.flatness(&open);
        let tolerance = sheet.allowed(open.cell);
        let [u, v, all] =
            [flatness.bends[0], flatness.bends[1], flatness.distance].map(|d| (d / tolerance).max(1.0));
        Self { needed: Scalar::sqrt(all).max(Scalar::sqrt(u) * Scalar::sqrt(v)), flatness, open }
    }

    /// The sum of the widths.
    fn size(&self) -> u32 {
        let Cell { from, to } = self.open.cell;
        to[0] - from[0] + to[1] - from[1]
    }
}

impl Ord for Estimate {
    /// The rectangle that needs most is the greatest; of those without a bound the smallest, so that one which never
    /// gets a bound is found at once.
    fn cmp(&self, other: &Self) -> Ordering {
        let needed = self.needed.total_cmp(&other.needed);
        needed.then(other.size().cmp(&self.size())).then(other.open.cell.from.cmp(&self.open.cell.from))
    }
}

impl PartialOrd for Estimate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Estimate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Estimate {}

/// The rectangles, and the corners on each line.
#[derive(Debug, Default)]
pub(in crate::mesh) struct Cells {
    pub(in crate::mesh) leaves: Vec<Leaf>,
    /// For each line `u = const` the `v` of the corners on it.
    on_u: BTreeMap<u32, BTreeSet<u32>>,
    /// For each line `v = const` the `u` of the corners on it.
    on_v: BTreeMap<u32, BTreeSet<u32>>,
    /// The corners of rectangles.
    corners: Index<()>,
    /// The number of rectangles, the first ones, that [`Cells::refine`] has looked at.
    seen: usize,
    /// The corners that have been added since then, as `[u, v]` and as `[v, u]`.
    fresh: [Vec<Node>; 2],
}

impl Cells {
    /// Cuts until every rectangle is flat within the tolerance.
    pub(in crate::mesh) fn new<S: Scalar>(sheet: &Sheet<'_, S>) -> Result<Self, MeshError> {
        let mut cells = Self::default();
        let mut judged = 0;
        cells.cut(sheet, alloc::vec![sheet.whole()], &mut judged)?;
        Ok(cells)
    }

    fn cut<S: Scalar>(
        &mut self,
        sheet: &Sheet<'_, S>,
        mut open: Vec<Open>,
        judged: &mut usize,
    ) -> Result<(), MeshError> {
        while let Some(next) = open.pop() {
            let flatness = sheet.flatness(&next);
            *judged += 1;
            if *judged == MANY {
                sheet.foreseen()?;
            }
            if flatness.distance <= sheet.allowed(next.cell) {
                self.add(Leaf { cell: next.cell, distance: flatness.distance, corners: 4 });
            } else {
                let axis = next.cell.direction(&flatness, &sheet.lines).ok_or_else(|| sheet.stuck())?;
                let [before, after] = sheet.cut(next, axis);
                open.extend([after, before]);
            }
            if self.leaves.len() + open.len() > MOST {
                return Err(sheet.too_fine());
            }
        }
        Ok(())
    }

    /// Cuts rectangles whose triangles are moved too far by the corners of neighbours on their sides; whether there
    /// were any.
    pub(in crate::mesh) fn refine<S: Scalar>(&mut self, sheet: &Sheet<'_, S>) -> Result<bool, MeshError> {
        let leaves = core::mem::take(&mut self.leaves);
        let mut fresh = core::mem::take(&mut self.fresh);
        for nodes in &mut fresh {
            nodes.sort_unstable();
        }
        let mut open = Vec::new();
        let mut judged = 0;
        for (index, leaf) in leaves.into_iter().enumerate() {
            // Seams give corners to edges at any time.
            if index < self.seen && !leaf.cell.is_outer() && !leaf.cell.has_on_sides(&fresh) {
                self.leaves.push(leaf);
                continue;
            }
            let nodes = self.around(leaf.cell);
            let is_kept = nodes.len() == leaf.corners || {
                let allowed = sheet.allowed(leaf.cell);
                leaf.distance + displacement(sheet, leaf.cell, &nodes) <= allowed
                    || sheet.fan(leaf.cell, &nodes).is_some_and(|distance| distance <= allowed)
                    || sheet.graph(leaf.cell, &nodes).is_some_and(|distance| distance <= allowed)
            };
            if is_kept {
                self.leaves.push(Leaf { corners: nodes.len(), ..leaf });
                continue;
            }
            let whole = sheet.open(leaf.cell);
            // Between the corners of neighbours, or else across what bends more.
            let on_sides = [1, 0].map(|axis| {
                let is_on = |node: &&Node| [leaf.cell.from[axis], leaf.cell.to[axis]].contains(&node[axis]);
                nodes.iter().filter(is_on).count()
            });
            let axis = match on_sides[0].cmp(&on_sides[1]) {
                Ordering::Greater => 0,
                Ordering::Less => 1,
                Ordering::Equal => {
                    let flatness = sheet.flatness(&whole);
                    leaf.cell.direction(&flatness, &sheet.lines).ok_or_else(|| sheet.stuck())?
                }
            };
            open.extend(sheet.cut(whole, axis));
        }
        let changed = !open.is_empty();
        self.seen = self.leaves.len();
        self.cut(sheet, open, &mut judged)?;
        Ok(changed)
    }

    fn add(&mut self, leaf: Leaf) {
        let cell = leaf.cell;
        self.leaves.push(leaf);
        for node @ [u, v] in cell.corners() {
            // Most corners are those of neighbours too.
            if self.corners.get(node).is_some() {
                continue;
            }
            self.corners.insert(node, ());
            if self.on_u.entry(u).or_default().insert(v) {
                self.fresh[0].push([u, v]);
            }
            if self.on_v.entry(v).or_default().insert(u) {
                self.fresh[1].push([v, u]);
            }
        }
    }

    /// The parameters along an edge of the square, in increasing order.
    pub(in crate::mesh) fn edge(&mut self, edge: Edge) -> &mut BTreeSet<u32> {
        match edge {
            Edge::UStart => self.on_u.entry(0).or_default(),
            Edge::UEnd => self.on_u.entry(WIDTH).or_default(),
            Edge::VStart => self.on_v.entry(0).or_default(),
            Edge::VEnd => self.on_v.entry(WIDTH).or_default(),
        }
    }

    /// All corners around a rectangle, also those of smaller neighbours on its sides, counter-clockwise.
    pub(in crate::mesh) fn around(&self, cell: Cell) -> Vec<Node> {
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

/// How far the corners of neighbours, and a corner in the middle, move the triangles over a rectangle.
fn displacement<S: Scalar>(sheet: &Sheet<'_, S>, cell: Cell, nodes: &[Node]) -> f64 {
    let corners = cell.corners();
    let mut largest = 0.0_f64;
    let mut side: Vec<P3> = Vec::new();
    for &node in nodes.iter().chain(nodes.first()) {
        let point = sheet.point(node);
        side.push(point);
        if corners.contains(&node) {
            largest = largest.max(flat::displacement(&side));
            side.clear();
            side.push(point);
        }
    }
    if nodes.len() > 4 {
        let [a, b, c, d] = corners.map(|node| sheet.point(node));
        let middle = sheet.point(middle(cell));
        largest = largest.max(flat::distance_to_triangles(middle, [a, b, c, d]));
    }
    largest
}

/// Whether corners that are not next to each other may become one point, so that triangles between them would vanish.
pub(in crate::mesh) fn is_crowded<S: Scalar>(points: &[[S; 3]], reach: S) -> bool {
    let count = points.len();
    let apart = |i: usize, j: usize| j - i >= 2 && (i, j) != (0, count - 1);
    (0..count).any(|i| (i + 1..count).any(|j| apart(i, j) && distance(points[i], points[j]) <= reach))
}

/// The node at a parameter along an edge.
pub(in crate::mesh) fn on_edge(edge: Edge, along: u32) -> Node {
    match edge {
        Edge::UStart => [0, along],
        Edge::UEnd => [WIDTH, along],
        Edge::VStart => [along, 0],
        Edge::VEnd => [along, WIDTH],
    }
}
