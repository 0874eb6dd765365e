//! Edges that run along each other with different parameters, or only for a part of their length.

use alloc::collections::BTreeSet;
use alloc::vec::Vec;

use super::cut::cells::{Cells, on_edge};
use super::cut::facets::Node;
use super::cut::lines::WIDTH;
use super::patch::Patch;
use super::weld::{Seams, Side};
use crate::vector::{cross, distance, dot, length};
use crate::{Edge, Scalar};

/// A corner of the triangles of a surface.
pub(super) type Place = (usize, Node);

/// An edge as the polyline of its corners. The curve is nowhere farther from it than the tolerance of the mesh.
struct Line<S> {
    side: Side,
    along: Vec<u32>,
    points: Vec<[S; 3]>,
    low: [S; 3],
    high: [S; 3],
}

impl<S: Scalar> Line<S> {
    fn new(patch: &dyn Patch<S>, cells: &mut Cells, side: Side) -> Self {
        let along: Vec<u32> = cells.edge(side.edge).iter().copied().collect();
        let points: Vec<[S; 3]> = along.iter().map(|&k| point(patch, side.edge, real(k))).collect();
        let extreme =
            |of: fn(S, S) -> S| [0, 1, 2].map(|c| points.iter().map(|p| p[c]).reduce(of).unwrap_or(S::NAN));
        Self { side, low: extreme(S::min), high: extreme(S::max), along, points }
    }

    fn is_near(&self, low: [S; 3], high: [S; 3], reach: S) -> bool {
        (0..3).all(|c| self.low[c] <= high[c] + reach && low[c] <= self.high[c] + reach)
    }

    /// The parameter of the nearest point of the curve to a point, if that is nearer than `weld`.
    fn project(&self, patch: &dyn Patch<S>, target: [S; 3], tolerance: S, weld: S) -> Option<S> {
        if !self.is_near(target, target, tolerance + weld) {
            return None;
        }
        let mut best: Option<(S, S)> = None;
        for (ends, points) in self.along.windows(2).zip(self.points.windows(2)) {
            if chord_distance(target, points[0], points[1]) > tolerance + weld {
                continue;
            }
            let at = |x: S| distance(point(patch, self.side.edge, x), target);
            let (x, found) = least(at, real(ends[0]), real(ends[1]));
            if found <= weld && best.is_none_or(|(_, other)| found < other) {
                best = Some((x, found));
            }
        }
        best.map(|(x, _)| x)
    }
}

/// The point of an edge at a parameter from 0 to the width of the square.
fn point<S: Scalar>(patch: &dyn Patch<S>, edge: Edge, x: S) -> [S; 3] {
    let x = x / real(WIDTH);
    patch.point(match edge {
        Edge::UStart => [S::ZERO, x],
        Edge::UEnd => [S::ONE, x],
        Edge::VStart => [x, S::ZERO],
        Edge::VEnd => [x, S::ONE],
    })
}

fn real<S: Scalar>(along: u32) -> S {
    S::from_usize(along as usize)
}

fn chord_distance<S: Scalar>(target: [S; 3], from: [S; 3], to: [S; 3]) -> S {
    let minus = |a: [S; 3], b: [S; 3]| [0, 1, 2].map(|c| a[c] - b[c]);
    let (chord, arm) = (minus(to, from), minus(target, from));
    let (along, square) = (dot(chord, arm), dot(chord, chord));
    if along <= S::ZERO {
        length(arm)
    } else if along >= square {
        distance(target, to)
    } else {
        length(cross(chord, arm)) / square.sqrt()
    }
}

/// Where a function with one minimum between two numbers is least, by golden section, and its value there.
fn least<S: Scalar>(at: impl Fn(S) -> S, mut from: S, mut to: S) -> (S, S) {
    // Both ends are candidates: corners of neighbours lie on each other.
    let mut best = (from, at(from));
    let mut better = |x: S, value: S| {
        if value < best.1 {
            best = (x, value);
        }
    };
    better(to, at(to));
    let ratio = S::of(0.618_033_988_749_894_9);
    let (mut x, mut y) = (to - (to - from) * ratio, from + (to - from) * ratio);
    let (mut at_x, mut at_y) = (at(x), at(y));
    for _ in 0..48 {
        better(x, at_x);
        better(y, at_y);
        if at_x < at_y {
            (to, y, at_y) = (y, x, at_x);
            x = to - (to - from) * ratio;
            at_x = at(x);
        } else {
            (from, x, at_x) = (x, y, at_y);
            y = from + (to - from) * ratio;
            at_y = at(y);
        }
    }
    best
}

/// Gives every edge the corners of others that lie on it: the pairs of corners that are one point.
///
/// Edges of a seam have theirs already; poles have no length.
pub(super) fn meet<S: Scalar>(
    patches: &[&dyn Patch<S>],
    cells: &mut [Cells],
    found: &Seams,
    tolerance: S,
    weld: S,
) -> Vec<[Place; 2]> {
    let poles: BTreeSet<Side> = found.poles.iter().copied().collect();
    let seams: BTreeSet<[Side; 2]> =
        found.seams.iter().flat_map(|seam| [seam.sides, [seam.sides[1], seam.sides[0]]]).collect();
    let mut lines: Vec<Line<S>> = Vec::new();
    for (surface, patch) in patches.iter().enumerate() {
        for edge in Edge::ALL {
            let side = Side { surface, edge };
            if !poles.contains(&side) {
                lines.push(Line::new(*patch, &mut cells[surface], side));
            }
        }
    }
    // Sorted by one coordinate, an edge is compared with its neighbours only.
    lines.sort_by(|a, b| a.low[0].partial_cmp(&b.low[0]).unwrap_or(core::cmp::Ordering::Equal));
    let mut pairs = Vec::new();
    for (k, first) in lines.iter().enumerate() {
        let reach = first.high[0] + tolerance;
        for second in lines[k + 1..].iter().take_while(|second| second.low[0] <= reach) {
            if second.is_near(first.low, first.high, tolerance) && !seams.contains(&[first.side, second.side])
            {
                for (from, onto) in [(first, second), (second, first)] {
                    transfer(patches, cells, from, onto, [tolerance, weld], &mut pairs);
                }
            }
        }
    }
    pairs
}

/// Gives an edge the corners of another one that lie on it.
fn transfer<S: Scalar>(
    patches: &[&dyn Patch<S>],
    cells: &mut [Cells],
    from: &Line<S>,
    onto: &Line<S>,
    [tolerance, weld]: [S; 2],
    pairs: &mut Vec<[Place; 2]>,
) {
    let Side { surface, edge } = onto.side;
    for (&along, &target) in from.along.iter().zip(&from.points) {
        let Some(x) = onto.project(patches[surface], target, tolerance, weld) else { continue };
        let corners = cells[surface].edge(edge);
        let mut nearest = rounded(x);
        // A corner that is there already serves, so that no sliver stands between both.
        let neighbours = [corners.range(..=nearest).next_back(), corners.range(nearest..).next()];
        for &corner in neighbours.into_iter().flatten() {
            if distance(point(patches[surface], edge, real(corner)), target) <= weld {
                nearest = corner;
                break;
            }
        }
        corners.insert(nearest);
        let places = [(from.side.surface, on_edge(from.side.edge, along)), (surface, on_edge(edge, nearest))];
        pairs.push(places);
    }
}

/// The nearest whole number; the parameter is between 0 and the width.
fn rounded<S: Scalar>(x: S) -> u32 {
    ((x.to_f64() + 0.5) as u32).min(WIDTH)
}
