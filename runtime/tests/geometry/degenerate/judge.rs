//! What is wrong with answers: by a search by boxes alone, by places that are known, and by sampling.

use basis_runtime::{Meeting, MeetingKind};

use super::cases::{Case, Made, Points, value};
use crate::queries::distance;

/// A part of a curve in the search by boxes: its interval, and homogeneous control points.
type Part<const D: usize> = ([f64; 2], Vec<([f64; D], f64)>);

fn halves<const D: usize>(([lo, hi], points): &Part<D>) -> [Part<D>; 2] {
    let middle = |a: ([f64; D], f64), b: ([f64; D], f64)| {
        (core::array::from_fn(|d| 0.5 * (a.0[d] + b.0[d])), 0.5 * (a.1 + b.1))
    };
    let (mut left, mut right, mut row) = (Vec::new(), Vec::new(), points.clone());
    while let (Some(&first), Some(&last)) = (row.first(), row.last()) {
        left.push(first);
        right.push(last);
        row = row.windows(2).map(|pair| middle(pair[0], pair[1])).collect();
    }
    right.reverse();
    let between = 0.5 * (lo + hi);
    [([*lo, between], left), ([between, *hi], right)]
}

fn bounds<const D: usize>((_, points): &Part<D>) -> [[f64; 2]; D] {
    core::array::from_fn(|d| {
        points
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], (p, w)| [lo.min(p[d] / w), hi.max(p[d] / w)])
    })
}

fn whole<const D: usize>((points, weights): &Points<D>) -> Part<D> {
    ([0.0, 1.0], points.iter().zip(weights).map(|(p, w)| (p.map(|x| x * w), *w)).collect())
}

/// Pairs of parameters near which the curves may meet: middles of parts no longer than `leaf` whose boxes do; `None` if
/// they are too many.
fn candidates<const D: usize>(a: &Part<D>, b: &Part<D>, leaf: f64, adjacent: f64) -> Option<Vec<[f64; 2]>> {
    let mut found = Vec::new();
    let mut open = vec![(a.clone(), b.clone())];
    let mut work = 0;
    while let Some((a, b)) = open.pop() {
        work += 1;
        if work > 6_000 {
            return None;
        }
        let (p, q) = (bounds(&a), bounds(&b));
        // Of one curve with itself only what is that far apart, the smaller parameter first.
        let apart = (0..D).any(|d| p[d][0] - q[d][1] > 1e-12 || q[d][0] - p[d][1] > 1e-12);
        if apart || b.0[1] - a.0[0] < adjacent {
            continue;
        }
        let size = |side: &[[f64; 2]; D]| side.iter().map(|[lo, hi]| hi - lo).fold(0.0, f64::max);
        if size(&p).max(size(&q)) <= leaf {
            found.push([0.5 * (a.0[0] + a.0[1]), 0.5 * (b.0[0] + b.0[1])]);
        } else if size(&p) >= size(&q) {
            open.extend(halves(&a).map(|half| (half, b.clone())));
        } else {
            open.extend(halves(&b).map(|half| (a.clone(), half)));
        }
    }
    Some(found)
}

const STEPS: [[f64; 2]; 8] =
    [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];

/// Goes from a pair of parameters to one at which the curves are nearest; in steps that become shorter.
fn nearest<const D: usize>(a: &Points<D>, b: &Points<D>, start: [f64; 2]) -> ([f64; 2], f64) {
    let away = |at: [f64; 2]| distance_at(a, b, at);
    let (mut at, mut best, mut step) = (start, away(start), 1e-3);
    let mut rounds = 0;
    while step > 1e-17 && best > 0.0 && rounds < 300 {
        rounds += 1;
        let mut moved = false;
        for [x, y] in STEPS {
            let next = [(at[0] + x * step).clamp(0.0, 1.0), (at[1] + y * step).clamp(0.0, 1.0)];
            let distance = away(next);
            if distance < best {
                (at, best, moved) = (next, distance, true);
            }
        }
        if !moved {
            step *= 0.5;
        }
    }
    (at, best)
}

pub fn distance_at<const D: usize>(a: &Points<D>, b: &Points<D>, at: [f64; 2]) -> f64 {
    distance(value(a, at[0]), value(b, at[1]))
}

/// How far a point is from a curve between two parameters; less than `enough` is enough.
fn away<const D: usize>(point: [f64; D], curve: &Points<D>, [lo, hi]: [f64; 2], enough: f64) -> f64 {
    const COUNT: usize = 48;
    let at = |t: f64| distance(point, value(curve, t));
    let step = (hi - lo) / COUNT as f64;
    let samples: Vec<f64> = (0..=COUNT).map(|k| at(lo + k as f64 * step)).collect();
    let mut best = samples.iter().copied().fold(f64::INFINITY, f64::min);
    for k in 0..=COUNT {
        let lowest = samples[k] <= samples[k.saturating_sub(1)] && samples[k] <= samples[(k + 1).min(COUNT)];
        if !lowest || best <= enough {
            continue;
        }
        let (mut from, mut to) =
            (lo + k.saturating_sub(1) as f64 * step, lo + (k + 1).min(COUNT) as f64 * step);
        for _ in 0..60 {
            let [left, right] = [from + 0.382 * (to - from), from + 0.618 * (to - from)];
            if at(left) <= at(right) {
                to = right;
            } else {
                from = left;
            }
        }
        best = best.min(at(0.5 * (from + to)));
    }
    best
}

/// The largest distance of points of either curve between two parameters from the other curve between two others.
fn apart<const D: usize>([a, b]: &[Points<D>; 2], first: [f64; 2], second: [f64; 2], enough: f64) -> f64 {
    let side = |a: &Points<D>, b: &Points<D>, first: [f64; 2], second: [f64; 2]| {
        let at = |k: u32| first[0] + 0.125 * f64::from(k) * (first[1] - first[0]);
        (0..=8).map(|k| away(value(a, at(k)), b, second, enough)).fold(0.0, f64::max)
    };
    side(a, b, first, second).max(side(b, a, second, first))
}

/// How far a curve goes away from its point at the first of two parameters.
fn extent<const D: usize>(curve: &Points<D>, [lo, hi]: [f64; 2]) -> f64 {
    let start = value(curve, lo);
    let at = |k: u32| lo + f64::from(k) / 32.0 * (hi - lo);
    (1..32).map(|k| distance(start, value(curve, at(k)))).fold(0.0, f64::max)
}

pub fn covers<const D: usize>(meeting: &Meeting<[f64; D]>, at: [f64; 2], gap: f64) -> bool {
    let within = |[lo, hi]: [f64; 2], t: f64| {
        if lo > hi { t >= lo - gap || t <= hi + gap } else { t >= lo - gap && t <= hi + gap }
    };
    within(meeting.first, at[0]) && within(meeting.second, at[1])
}

/// What is asked of a curve and another one, or itself.
#[derive(Clone, Copy, PartialEq)]
pub enum Asked {
    Two,
    Itself,
}

/// What is wrong with answers, of curves of about the size 1 that were asked in a scale; or how many places there are.
pub fn judge<const D: usize>(
    case: &Case<D>,
    found: &[Meeting<[f64; D]>],
    scale: f64,
    accuracy: f64,
    asked: Asked,
) -> Result<usize, String> {
    let [a, b] = &case.curves;
    let about = 3.0 * accuracy + 1e-13;
    for meeting in found {
        let distance = distance_at(a, b, meeting.at);
        if distance.max(meeting.distance / scale) > 2.0 * accuracy + 1e-13 {
            return Err(format!("invented, {distance:e}: {meeting:?}"));
        }
        if !covers(meeting, meeting.at, 0.0) || asked == Asked::Itself && meeting.at[0] >= meeting.at[1] {
            return Err(format!("not in order: {meeting:?}"));
        }
        let sides = [meeting.first, meeting.second];
        let through_an_end = sides.iter().any(|[lo, hi]| lo > hi);
        if !through_an_end && sides.iter().any(|[lo, hi]| lo < hi) {
            let apart = apart(&case.curves, meeting.first, meeting.second, about);
            if apart > about {
                return Err(format!("apart, {apart:e}: {meeting:?}"));
            }
        }
    }
    for (k, one) in found.iter().enumerate() {
        for other in &found[..k] {
            // A place beside an overlap, or a short one that is a contact, may have parameters that are in its intervals.
            let overlap =
                case.along || one.kind == MeetingKind::Overlap || other.kind == MeetingKind::Overlap;
            if !overlap && (covers(one, other.at, 0.0) || covers(other, one.at, 0.0)) {
                return Err(format!("twice: {one:?} {other:?}"));
            }
            let both = one.kind == MeetingKind::Crossing && other.kind == MeetingKind::Crossing;
            let enough = if both { 4e-16 } else { 0.5 * accuracy };
            let between = [0, 1].map(|c| [one.at[c].min(other.at[c]), one.at[c].max(other.at[c])]);
            // Where a curve meets itself, the same curve does twice.
            let mirrored = a == b && (0..2).all(|k| (one.at[k] - other.at[1 - k]).abs() < 1e-6);
            if mirrored || case.along {
                continue;
            }
            // Only one after the other: between crossings far apart of nearly parallel curves there is no more to be said.
            if apart(&case.curves, between[0], between[1], enough) <= enough {
                return Err(format!("twice, with nothing between: {one:?} {other:?}"));
            }
        }
    }
    for &(at, made) in &case.places {
        let order = if let Made::Touch(order) = made { order } else { 0 };
        let gap = [1e-6, 1e-5, 1e-3, 1e-2][order as usize];
        let least = if order == 0 { 8.0 * accuracy } else { 8.0 * accuracy.sqrt() };
        if asked == Asked::Itself && extent(a, at) <= least {
            continue;
        }
        let Some(meeting) = found.iter().find(|m| covers(m, at, gap)) else {
            return Err(format!("missing {at:?}, {made:?}, {:e}", distance_at(a, b, at)));
        };
        // A crossing beside it, nearer than the accuracy along the curves, is one answer with it.
        let is_here = (0..2).all(|k| (meeting.at[k] - at[k]).abs() <= gap);
        if order > 0 && meeting.kind == MeetingKind::Crossing && is_here {
            return Err(format!("a contact is no crossing: {meeting:?}, {made:?}"));
        }
    }
    if let Some([first, second]) = case.overlap {
        let ends =
            [[first[0], second[0]], [first[1], second[1]], [first[0], second[1]], [first[1], second[0]]];
        let one = found.iter().any(|m| ends.iter().all(|&at| covers(m, at, 1e-6)));
        if !one {
            return Err(format!("no one overlap {first:?} {second:?}"));
        }
    }
    missing(case, found, accuracy, asked).map(|met| met + case.places.len())
}

/// Looks for places between or beside the answers.
fn missing<const D: usize>(
    case: &Case<D>,
    found: &[Meeting<[f64; D]>],
    accuracy: f64,
    asked: Asked,
) -> Result<usize, String> {
    let [a, b] = &case.curves;
    let adjacent = if asked == Asked::Itself { 0.05 } else { -2.0 };
    let (p, q) = (whole(a), whole(b));
    let places = [1e-5, 1e-4, 1e-3, 1e-2].iter().find_map(|leaf| candidates(&p, &q, *leaf, adjacent));
    let mut met = 0;
    let mut looked_at: Vec<[f64; 2]> = Vec::new();
    for start in places.unwrap_or_default() {
        if found.iter().any(|meeting| covers(meeting, start, 0.0)) {
            met += 1;
            continue;
        }
        if looked_at.iter().any(|other| (0..2).all(|k| (other[k] - start[k]).abs() < 1e-4))
            || looked_at.len() > 30
        {
            continue;
        }
        looked_at.push(start);
        let (at, distance) = nearest(a, b, start);
        // That a curve ends where it begins is no answer.
        let apart = asked == Asked::Two
            || (adjacent..1.0 - 1e-6).contains(&(at[1] - at[0])) && extent(a, at) > 8.0 * accuracy;
        if distance <= 1e-15 && apart {
            met += 1;
            if !found.iter().any(|meeting| covers(meeting, at, 1e-5)) {
                return Err(format!("missing {at:?}, {distance:e}"));
            }
        }
    }
    Ok(met)
}
