//! Which edges of which surfaces are the same curve.

use alloc::vec::Vec;

use super::cut::cells::{on_edge, unit};
use super::cut::lines::WIDTH;
use super::patch::Patch;
use crate::vector::distance;
use crate::{Edge, Scalar};

/// An edge of one of the surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Side {
    pub(super) surface: usize,
    pub(super) edge: Edge,
}

/// Two edges that run along each other.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seam {
    pub(super) sides: [Side; 2],
    /// Whether they run against each other.
    pub(super) reversed: bool,
}

impl Seam {
    /// The parameter on the second side that belongs to one on the first side, and the other way round.
    pub(super) fn across(self, along: u32) -> u32 {
        if self.reversed { WIDTH - along } else { along }
    }
}

/// The number of steps at which edges are compared.
const STEPS: usize = 16;

/// An edge as points at equal steps of its parameter.
struct Trace<S> {
    side: Side,
    points: Vec<[S; 3]>,
    low: [S; 3],
    high: [S; 3],
}

impl<S: Scalar> Trace<S> {
    fn new(patch: &dyn Patch<S>, side: Side) -> Self {
        let points: Vec<[S; 3]> = (0..=STEPS)
            .map(|k| patch.point(on_edge(side.edge, k as u32 * (WIDTH / STEPS as u32)).map(unit)))
            .collect();
        let extreme =
            |of: fn(S, S) -> S| [0, 1, 2].map(|c| points.iter().fold(points[0][c], |a, p| of(a, p[c])));
        Self { side, low: extreme(S::min), high: extreme(S::max), points }
    }

    fn is_point(&self, tolerance: S) -> bool {
        self.points.iter().all(|&p| distance(p, self.points[0]) <= tolerance)
    }

    /// Whether the boxes of both are near enough for a seam.
    fn may_meet(&self, other: &Self, tolerance: S) -> bool {
        (0..3).all(|c| self.low[c] <= other.high[c] + tolerance && other.low[c] <= self.high[c] + tolerance)
    }

    fn runs_along(&self, other: &Self, reversed: bool, tolerance: S) -> bool {
        (0..=STEPS).all(|k| {
            let partner = other.points[if reversed { STEPS - k } else { k }];
            distance(self.points[k], partner) <= tolerance
        })
    }
}

/// What the edges of the surfaces have to do with each other.
pub(super) struct Seams {
    /// Pairs of edges that are the same curve with the same parameter, or the opposite one.
    pub(super) seams: Vec<Seam>,
    /// Edges that are one point.
    pub(super) poles: Vec<Side>,
}

/// Compares all edges.
pub(super) fn find<S: Scalar>(patches: &[&dyn Patch<S>], tolerance: S) -> Seams {
    let traces: Vec<Trace<S>> = patches
        .iter()
        .enumerate()
        .flat_map(|(surface, patch)| Edge::ALL.map(|edge| Trace::new(*patch, Side { surface, edge })))
        .collect();
    let (poles, mut curves): (Vec<&Trace<S>>, Vec<&Trace<S>>) =
        traces.iter().partition(|trace| trace.is_point(tolerance));
    // Sorted by one coordinate, an edge is compared with its neighbours only.
    curves.sort_by(|a, b| a.low[0].partial_cmp(&b.low[0]).unwrap_or(core::cmp::Ordering::Equal));
    let mut seams = Vec::new();
    for (k, first) in curves.iter().enumerate() {
        let reach = first.high[0] + tolerance;
        for second in curves[k + 1..].iter().take_while(|second| second.low[0] <= reach) {
            if !first.may_meet(second, tolerance) {
                continue;
            }
            if let Some(reversed) =
                [false, true].into_iter().find(|&reversed| first.runs_along(second, reversed, tolerance))
            {
                seams.push(Seam { sides: [first.side, second.side], reversed });
            }
        }
    }
    Seams { seams, poles: poles.into_iter().map(|trace| trace.side).collect() }
}

/// Classes of points that become one: each is known by its first member, to whose place the others move.
pub(super) struct Classes<S> {
    parent: Vec<usize>,
    /// How far the members of the class of a first member can be from it.
    radius: Vec<S>,
    /// As far as a point may move.
    reach: S,
}

impl<S: Scalar> Classes<S> {
    pub(super) fn new(count: usize, reach: S) -> Self {
        Self { parent: (0..count).collect(), radius: alloc::vec![S::ZERO; count], reach }
    }

    pub(super) fn find(&mut self, mut member: usize) -> usize {
        while self.parent[member] != member {
            self.parent[member] = self.parent[self.parent[member]];
            member = self.parent[member];
        }
        member
    }

    /// Makes two classes one, unless a point would then move too far: a chain of points, each next to the one before
    /// it, would else draw together what is far apart.
    pub(super) fn join(&mut self, points: &[[S; 3]], a: usize, b: usize) {
        let (a, b) = (self.find(a), self.find(b));
        let (first, other) = (a.min(b), a.max(b));
        let moved = distance(points[first], points[other]) + self.radius[other];
        if first != other && moved <= self.reach {
            self.parent[other] = first;
            self.radius[first] = self.radius[first].max(moved);
        }
    }
}
