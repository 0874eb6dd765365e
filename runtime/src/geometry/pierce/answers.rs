//! From what a search found to answers.

use alloc::vec::Vec;

use super::Pierced;
use super::net::{Net, Vector, dot, minus, norm, times};
use super::search::{Near, Ranges, Search, inverse};
use crate::geometry::{CurvePiece, MeetingKind};
use crate::{Scalar, SurfacePiece};

/// Near parts that touch each other.
struct Group {
    ranges: Ranges,
    /// The box around the ends of the parts of the curve.
    ends: Ranges,
    /// Indices of the parts.
    members: Vec<usize>,
}

/// Crossings, and intervals that touch each other as one, in the order of the curve.
#[inline]
pub(super) fn answers(search: &Search<'_>, curve: &[CurvePiece], surface: &[SurfacePiece]) -> Vec<Pierced> {
    let place = |[i, j]: [usize; 2], at: Vector| {
        let [u, v] = surface[j].parameters([at[1], at[2]]);
        [curve[i].parameter(at[0]), u, v]
    };
    let widths = [
        hull(curve.iter().map(CurvePiece::domain)),
        hull(surface.iter().map(|piece| piece.domain()[0])),
        hull(surface.iter().map(|piece| piece.domain()[1])),
    ]
    .map(|[lo, hi]| hi - lo);
    let gaps = widths.map(|width| 1e-9 * width);
    let mut found: Vec<Pierced> = Vec::new();
    for crossing in &search.crossings {
        let at = place(crossing.pieces, crossing.at);
        let near = |k: usize| gaps[k] + 4.0 * widths[k] * crossing.reach[k];
        let same = |other: &Pierced| (0..3).all(|k| (other.at[k] - at[k]).abs() <= near(k));
        if !found.iter().any(same) {
            let [t, u, v] = at.map(|t| [t, t]);
            found.push(Pierced { kind: MeetingKind::Crossing, curve: t, surface: [u, v], at });
        }
    }
    for group in groups(&search.near, curve, surface, gaps) {
        // The rest of the neighbourhood of a crossing belongs to it.
        let next_to = |crossing: &&mut Pierced| {
            crossing.kind == MeetingKind::Crossing
                && (0..3).all(|k| {
                    let [lo, hi] = group.ranges[k];
                    let around = (hi - lo) + gaps[k];
                    (lo - around..=hi + around).contains(&crossing.at[k])
                })
        };
        let [t, u, v] = group.ranges;
        if let Some(crossing) = found.iter_mut().find(next_to) {
            crossing.curve = hull([crossing.curve, t].into_iter());
            crossing.surface =
                [[crossing.surface[0], u], [crossing.surface[1], v]].map(|r| hull(r.into_iter()));
            continue;
        }
        let size = norm(group.ends.map(|[lo, hi]| hi - lo));
        // What a curve has in common with a surface that it touches is some roots of the accuracy long.
        let kind = if size > 20.0 * Scalar::sqrt(search.accuracy) {
            MeetingKind::Overlap
        } else {
            MeetingKind::Contact
        };
        let at = nearest_of(search, &group.members, kind)
            .map_or_else(|| group.ranges.map(|[lo, hi]| 0.5 * (lo + hi)), |(pieces, at)| place(pieces, at));
        found.push(Pierced { kind, curve: t, surface: [u, v], at });
    }
    found.sort_by(|a, b| {
        let by = |k: usize| a.at[k].total_cmp(&b.at[k]);
        by(0).then_with(|| by(1)).then_with(|| by(2))
    });
    found
}

/// The smallest interval around others.
#[inline]
fn hull(intervals: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
    intervals.fold([f64::INFINITY, f64::NEG_INFINITY], |a, b| [a[0].min(b[0]), a[1].max(b[1])])
}

/// Near parts whose intervals touch, as one.
#[inline]
fn groups(near: &[Near], curve: &[CurvePiece], surface: &[SurfacePiece], gaps: Vector) -> Vec<Group> {
    let mut parts: Vec<Group> = Vec::with_capacity(near.len());
    for (index, part) in near.iter().enumerate() {
        let ([i, j], [t, x, y]) = (part.pieces, part.ranges);
        let [u, v] = surface[j].parameter_ranges([x, y]);
        let ends = [0, 1, 2].map(|d| hull(part.ends.iter().map(|end| [end[d]; 2])));
        let ranges = [t.map(|t| curve[i].parameter(t)), u, v];
        parts.push(Group { ranges, ends, members: alloc::vec![index] });
    }
    parts.sort_by(|a, b| a.ranges[0][0].total_cmp(&b.ranges[0][0]));
    let mut groups: Vec<Group> = Vec::new();
    for mut next in parts {
        let mut k = 0;
        while k < groups.len() {
            let touches = (0..3).all(|c| {
                let ([a, b], [lo, hi]) = (groups[k].ranges[c], next.ranges[c]);
                a <= hi + gaps[c] && lo <= b + gaps[c]
            });
            if touches {
                let mut other = groups.swap_remove(k);
                for c in 0..3 {
                    next.ranges[c] = hull([next.ranges[c], other.ranges[c]].into_iter());
                    next.ends[c] = hull([next.ends[c], other.ends[c]].into_iter());
                }
                other.members.append(&mut next.members);
                next.members = other.members;
                k = 0;
            } else {
                k += 1;
            }
        }
        groups.push(next);
    }
    groups
}

/// The place of near parts at which curve and surface are nearest to each other, of some of many parts; of an overlap one
/// in the middle, if that is within the accuracy.
#[inline]
fn nearest_of(search: &Search<'_>, members: &[usize], kind: MeetingKind) -> Option<([usize; 2], Vector)> {
    let some = members.iter().step_by(members.len().div_ceil(32).max(1));
    let middle = members.get(members.len() / 2).into_iter();
    let mut best: Option<(f64, [usize; 2], Vector)> = None;
    for &index in middle.chain(some) {
        let part = &search.near[index];
        let [i, j] = part.pieces;
        let (distance, at) = approach(&search.curves[i], &search.surfaces[j], &part.ranges);
        if best.as_ref().is_none_or(|best| distance < best.0) {
            best = Some((distance, part.pieces, at));
        }
        if kind == MeetingKind::Overlap && distance <= search.accuracy {
            break;
        }
    }
    best.map(|(_, pieces, at)| (pieces, at))
}

/// A place between these parameters at which a curve and a surface are near each other: by Newton's steps, and where these
/// lead nowhere, by damped ones, or those of one parameter alone.
#[inline]
fn approach(curve: &Net, surface: &Net, ranges: &Ranges) -> (f64, Vector) {
    let locals = |at: Vector| (curve.local([at[0], 0.0]), surface.local([at[1], at[2]]));
    let mut at = ranges.map(|[lo, hi]| 0.5 * (lo + hi));
    let (mut a, mut s) = locals(at);
    // From the nearest corner, if that is nearer.
    for corner in 0..8 {
        let there = [0, 1, 2].map(|k| ranges[k][corner >> k & 1]);
        let (b, r) = locals(there);
        if norm(minus(b.point, r.point)) < norm(minus(a.point, s.point)) {
            (at, a, s) = (there, b, r);
        }
    }
    for _ in 0..40 {
        let difference = minus(a.point, s.point);
        let distance = norm(difference);
        let alone = |slope: Vector, sign: f64| {
            let square = dot(slope, slope);
            if square > 0.0 { sign * dot(slope, difference) / square } else { 0.0 }
        };
        let alone = [alone(a.slopes[0], 1.0), alone(s.slopes[0], -1.0), alone(s.slopes[1], -1.0)];
        let newton = inverse(a.slopes[0], s.slopes).map(|rows| rows.map(|row| dot(row, difference)));
        let only = |k: usize| [0, 1, 2].map(|c| if c == k { alone[c] } else { 0.0 });
        // (JᵀJ + μ) step = Jᵀ difference, with J = [A', -S_u, -S_v].
        let columns = [a.slopes[0], times(s.slopes[0], -1.0), times(s.slopes[1], -1.0)];
        let downhill = columns.map(|column| dot(column, difference));
        let damped = |factor: f64| {
            let damping = factor * columns.iter().map(|&column| dot(column, column)).sum::<f64>();
            let normal = |c: usize| {
                [0, 1, 2].map(|r| dot(columns[r], columns[c]) + if r == c { damping } else { 0.0 })
            };
            let rows = inverse(normal(0), [times(normal(1), -1.0), times(normal(2), -1.0)]);
            rows.map_or([0.0; 3], |rows| rows.map(|row| dot(row, downhill)))
        };
        let steps = [newton.unwrap_or_default(), damped(1e-6), damped(1e-2), only(0), only(1), only(2)];
        let better = steps.into_iter().find_map(|step| {
            let mut next = minus(at, step);
            for (x, [lo, hi]) in next.iter_mut().zip(ranges) {
                *x = x.clamp(*lo, *hi);
            }
            let (a, s) = locals(next);
            (norm(minus(a.point, s.point)) < distance * (1.0 - 1e-9)).then_some((next, a, s))
        });
        let Some((next, next_a, next_s)) = better else { break };
        (at, a, s) = (next, next_a, next_s);
    }
    (norm(minus(a.point, s.point)), at)
}
