//! Where curves meet: by exclusion of parts that are apart, and a test that two parts meet at most once.
//!
//! Two parts `A(x)` and `B(y)` are put aside when their boxes, or their control points along the direction from one to
//! the other, are farther apart than the accuracy. With a matrix `M` near the inverse of the derivative of `F = A - B`
//! in the middle and `q = max |M F' - 1| < 1` over both parts, from the control points of the derivatives, `F` has at
//! most one zero, and all places with `|F| <= d` lie within `q/2 + d |M|` of the place to which Newton's step leads from
//! the middle (the operator of Krawczyk): if that is outside of both parts there is none; otherwise Newton's method
//! finds the zero. All others are halved, until control points show that they are one curve, or that both go along
//! their chords: then the intervals in which the chords are beside each other are known. So nothing is left out.
//!
//! Intervals that touch each other are one answer, and what is beside a crossing belongs to it. The parts between two
//! places of one curve say whether these are places at which it meets itself: not if it goes on in one direction between
//! them, or no farther than twice the accuracy.

use alloc::vec;
use alloc::vec::Vec;

use super::CurvePiece;
use super::beside::{self, Near, Straight, approach, difference, dot, point, pseudo_inverse, state};
use super::clipping::{self, View};
use super::piece::{derivative, product};
use super::{line, merged};
use crate::Scalar;

/// After so many pairs of parts, those that are left are compared in twice the accuracy, and so on.
const WORK: usize = 40_000;

/// What straight parts may be away from their chords, in the unit of the accuracy.
const STRAIGHT: f64 = 0.125;

/// How far rounding errors take points that are one from each other, in the unit in which the curves have the size 1.
const NOISE: f64 = 1e-12;

/// From how many places a curve that turns is searched for the one at which it meets itself.
const STARTS: usize = 24;

/// How two curves meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum MeetingKind {
    /// At one point, at an angle.
    Crossing,
    /// Nearer to each other than the accuracy, next to one point: they touch, meet at a cusp, or just do not meet.
    Contact,
    /// Nearer to each other than the accuracy along an interval that is longer than curves have in common which merely
    /// touch: twenty times the root of the accuracy, in the unit in which the curves have the size 1. Also a contact of
    /// high order.
    Overlap,
}

/// Parameters of both curves between which they meet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    pub(crate) kind: MeetingKind,
    pub(crate) first: [f64; 2],
    pub(crate) second: [f64; 2],
    pub(crate) at: [f64; 2],
}

/// All places at which two curves meet, in the order of the first parameter; `None` if anything is not finite.
#[inline]
pub(crate) fn meetings(
    a: &[CurvePiece],
    b: &[CurvePiece],
    accuracy: f64,
    epsilon: f64,
) -> Option<Vec<Found>> {
    let (view, accuracy) = view(a, b, accuracy, epsilon)?;
    let mut search = Search::new(accuracy);
    if let ([first], [second]) = (a, b) {
        search.between(first, second, view);
        search.run();
        return Some(search.answers(a, b, accuracy, view));
    }
    let boxes = [a, b].map(|pieces| pieces.iter().map(|piece| bounds(piece, view)).collect::<Vec<_>>());
    for (first, near) in a.iter().zip(&boxes[0]) {
        for (second, other) in b.iter().zip(&boxes[1]) {
            if !near.iter().zip(other).any(|([a, b], [c, d])| (a - d).max(c - b) > accuracy) {
                search.between(first, second, view);
            }
        }
    }
    search.run();
    Some(search.answers(a, b, accuracy, view))
}

/// All places at which a curve meets itself, the smaller parameter first, but for the one at which a closed curve ends
/// where it begins; `None` if anything is not finite.
#[inline]
pub(crate) fn self_meetings(a: &[CurvePiece], accuracy: f64, epsilon: f64) -> Option<Vec<Found>> {
    let (view, accuracy) = view(a, &[], accuracy, epsilon)?;
    let seen: Vec<CurvePiece> = a.iter().map(|piece| view.of(piece)).collect();
    let mut search = Search::new(accuracy);
    search.own = &seen;
    for (k, first) in seen.iter().enumerate() {
        search.against_itself(first);
        if let Some(second) = seen.get(k + 1) {
            search.open.push(Pair { first: first.clone(), second: second.clone() });
        }
        for n in k + 2..seen.len() {
            search.between(&a[k], &a[n], view);
        }
    }
    search.run();
    let mut found = search.answers(a, a, accuracy, view);
    let ends = [a.first()?.domain()[0], a.last()?.domain()[1]];
    let near = 1e-9 * (ends[1] - ends[0]);
    let away = difference(&point(&seen, ends[0]), &point(&seen, ends[1]));
    if dot(&away, &away) <= 4.0 * accuracy * accuracy {
        found.retain(|f| {
            let is_inside = f.first[0] > ends[0] + near || f.second[1] < ends[1] - near;
            let comes_back = f.kind == MeetingKind::Overlap || f.first[1] + near >= f.second[0];
            is_inside || comes_back
        });
    }
    Some(found)
}

/// A common origin and a common unit of both curves, and the accuracy in it.
#[inline]
fn view<'a>(
    a: &'a [CurvePiece],
    b: &'a [CurvePiece],
    accuracy: f64,
    epsilon: f64,
) -> Option<(View<'a>, f64)> {
    let first = a.first()?;
    if !a.iter().chain(b).all(CurvePiece::is_finite) {
        return None;
    }
    let mut size = 0.0_f64;
    for piece in a.iter().chain(b) {
        for d in 0..first.dimension() {
            let origin = first.control(0, d);
            size = (0..=piece.degree()).fold(size, |size, i| size.max((piece.control(i, d) - origin).abs()));
        }
    }
    if !size.is_finite() {
        return None;
    }
    let unit = if size > 0.0 { size } else { 1.0 };
    let accuracy = if accuracy > 0.0 { accuracy / unit } else { 0.0 };
    Some((View { first, unit }, accuracy.max(64.0 * epsilon)))
}

/// The box of a piece as it is seen.
#[inline]
fn bounds(piece: &CurvePiece, view: View<'_>) -> Vec<[f64; 2]> {
    let side = |d: usize| {
        let origin = view.origin(d);
        (0..=piece.degree()).fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], i| {
            let c = (piece.control(i, d) - origin) / view.unit;
            [lo.min(c), hi.max(c)]
        })
    };
    (0..piece.dimension()).map(side).collect()
}

/// Two parts that may meet; of one curve the first one comes before the second one.
struct Pair {
    first: CurvePiece,
    second: CurvePiece,
}

struct Search<'a> {
    accuracy: f64,
    /// The pieces of the curve that is asked for places at which it meets itself; nothing if there are two curves.
    own: &'a [CurvePiece],
    open: Vec<Pair>,
    crossings: Vec<[f64; 2]>,
    /// Where the curves are near each other.
    near: Vec<Near>,
}

impl Search<'_> {
    #[inline]
    fn new(accuracy: f64) -> Self {
        Self { accuracy, own: &[], open: Vec::new(), crossings: Vec::new(), near: Vec::new() }
    }

    /// Two pieces, first by clipping; what that leaves is open.
    #[inline]
    fn between(&mut self, first: &CurvePiece, second: &CurvePiece, view: View<'_>) {
        let mut open = |ranges: [[f64; 2]; 2]| {
            let part = |piece: &CurvePiece, [from, to]: [f64; 2]| view.of(piece).restricted(from, to);
            let (first, second) = (part(first, ranges[0]), part(second, ranges[1]));
            self.open.push(Pair { first, second });
        };
        if !clipping::suits(first) || !clipping::suits(second) {
            open([[0.0, 1.0]; 2]);
            return;
        }
        let parameters = |[x, y]: [f64; 2]| [first.parameter(x), second.parameter(y)];
        if let Some(places) = line::crossings(first, second, view, self.accuracy) {
            self.crossings.extend(places.as_slice().iter().copied().map(parameters));
            return;
        }
        if let Some(places) = line::crossings(second, first, view, self.accuracy) {
            self.crossings.extend(places.as_slice().iter().map(|&[y, x]| parameters([x, y])));
            return;
        }
        let outcome = clipping::search(first, second, view, self.accuracy);
        outcome.left.into_iter().for_each(open);
        self.crossings.extend(outcome.crossings.into_iter().map(parameters));
        self.near.extend(outcome.near.into_iter().map(|[x, y]| {
            let intervals = [x.map(|x| first.parameter(x)), y.map(|y| second.parameter(y))];
            Near { intervals, at: intervals.map(|[lo, hi]| 0.5 * (lo + hi)), distance: 0.0 }
        }));
    }

    /// Pairs of parts of one piece.
    #[inline]
    fn against_itself(&mut self, piece: &CurvePiece) {
        let mut open = vec![piece.clone()];
        while let Some(part) = open.pop() {
            if self.goes_on(core::slice::from_ref(&part)) {
                continue;
            }
            let [before, after] = part.split(0.5);
            if before.domain()[1] >= part.domain()[1] || before.domain()[0] >= before.domain()[1] {
                continue;
            }
            self.open.push(Pair { first: before.clone(), second: after.clone() });
            open.extend([before, after]);
        }
    }

    #[inline]
    fn run(&mut self) {
        let mut work = 0;
        while let Some(pair) = self.open.pop() {
            work += 1;
            if work > WORK {
                (work, self.accuracy) = (WORK / 2, 2.0 * self.accuracy);
            }
            if self.is_apart(&pair) || self.is_one_way(&pair) {
                continue;
            }
            match at_most_one(&pair, self.accuracy) {
                Some(Single::None) => continue,
                Some(Single::At(at)) => {
                    self.crossings.push(at);
                    continue;
                }
                None => {}
            }
            let straight =
                [&pair.first, &pair.second].map(|part| Straight::of(part, STRAIGHT * self.accuracy));
            if let [Some(first), Some(second)] = &straight {
                self.near.extend(beside::near([first, second], (1.0 + 2.0 * STRAIGHT) * self.accuracy));
                continue;
            }
            let straight = straight.map(|part| part.is_some());
            if self.is_alike(&pair) {
                continue;
            }
            // What is not straight is divided first, then what is longer.
            let lengths = [&pair.first, &pair.second].map(|part| part.length_bounds()[1]);
            let first = if straight[0] == straight[1] { lengths[0] >= lengths[1] } else { straight[1] };
            let Pair { first: a, second: b } = pair;
            let halves = if first { a.split(0.5) } else { b.split(0.5) };
            if halves.iter().any(|half| half.domain()[0] >= half.domain()[1]) {
                let intervals = [a.domain(), b.domain()];
                self.near.push(Near { intervals, at: intervals.map(|[lo, _]| lo), distance: self.accuracy });
                continue;
            }
            for half in halves {
                self.open.push(if first {
                    Pair { first: half, second: b.clone() }
                } else {
                    Pair { first: a.clone(), second: half }
                });
            }
        }
    }

    /// Whether parts are one curve in intervals that are then known; what is beside these is open.
    #[inline]
    fn is_alike(&mut self, pair: &Pair) -> bool {
        let Pair { first, second } = pair;
        if !is_forward(core::slice::from_ref(first)) || !is_forward(core::slice::from_ref(second)) {
            return false;
        }
        let Some([x, y]) = beside::alike(first, second, 2.0 * STRAIGHT * self.accuracy) else { return false };
        let intervals = [x.map(|x| first.parameter(x)), y.map(|y| second.parameter(y))];
        let at = [x, y].map(|[a, b]| 0.5 * (a + b));
        let at = [first.parameter(at[0]), second.parameter(at[1])];
        let ordered = intervals.map(|[a, b]| [a.min(b), a.max(b)]);
        self.near.push(Near { intervals: ordered, at, distance: 0.0 });
        let sides = |part: &CurvePiece, [a, b]: [f64; 2]| {
            let (lo, hi) = (a.min(b), a.max(b));
            let side =
                |from: f64, to: f64| (to - from > 4.0 * f64::EPSILON).then(|| part.restricted(from, to));
            [side(0.0, lo), side(hi, 1.0)]
        };
        for side in sides(first, x).into_iter().flatten() {
            self.open.push(Pair { first: side, second: second.clone() });
        }
        let middle = first.restricted(x[0], x[1]);
        for side in sides(second, y).into_iter().flatten() {
            self.open.push(Pair { first: middle.clone(), second: side });
        }
        true
    }

    /// Whether a curve between two parts of it goes on, so that these do not meet.
    #[inline]
    fn is_one_way(&self, Pair { first, second }: &Pair) -> bool {
        let (from, to) = (first.domain()[0], second.domain()[1]);
        let part = |piece: &CurvePiece| {
            let [lo, hi] = piece.domain();
            if hi <= from || lo >= to {
                return None;
            }
            Some(if from <= lo && to >= hi {
                piece.clone()
            } else {
                piece.restricted(piece.place(from.max(lo)), piece.place(to.min(hi)))
            })
        };
        !self.own.is_empty() && self.goes_on(&self.own.iter().filter_map(part).collect::<Vec<_>>())
    }

    /// Whether consecutive parts go on in one direction, or no farther than twice the accuracy.
    #[inline]
    fn goes_on(&self, parts: &[CurvePiece]) -> bool {
        let length: f64 = parts.iter().map(|part| part.length_bounds()[1]).sum();
        length <= 2.0 * self.accuracy || is_forward(parts)
    }

    /// Whether the parts are farther from each other than the accuracy: their boxes, or their control points across the
    /// chord of one of them.
    #[inline]
    fn is_apart(&self, pair: &Pair) -> bool {
        let Pair { first, second } = pair;
        let dim = first.dimension();
        let range = |part: &CurvePiece, direction: &[f64]| {
            let mut range = [f64::INFINITY, f64::NEG_INFINITY];
            for i in 0..=part.degree() {
                let x = (0..dim).map(|d| part.control(i, d) * direction[d]).sum::<f64>();
                range = [range[0].min(x), range[1].max(x)];
            }
            range
        };
        let between = |direction: &[f64]| {
            let ([a, b], [c, d]) = (range(first, direction), range(second, direction));
            (a - d).max(c - b)
        };
        let mut axis = vec![0.0; dim];
        for d in 0..dim {
            axis[d] = 1.0;
            if between(&axis) > self.accuracy {
                return true;
            }
            axis[d] = 0.0;
        }
        [first, second].iter().any(|part| {
            // The direction across the chord in which the middles of both are apart.
            let last = part.degree();
            let chord: Vec<f64> = (0..dim).map(|d| part.control(last, d) - part.control(0, d)).collect();
            let middle: Vec<f64> = (0..dim).map(|d| second.value(d, 0.5) - first.value(d, 0.5)).collect();
            let along = dot(&middle, &chord) / dot(&chord, &chord);
            let mut across: Vec<f64> = if dim == 2 {
                vec![-chord[1], chord[0]]
            } else {
                (0..dim).map(|d| middle[d] - along * chord[d]).collect()
            };
            let length = Scalar::sqrt(dot(&across, &across));
            if !(length > 0.0 && length.is_finite()) {
                return false;
            }
            for x in &mut across {
                *x /= length;
            }
            between(&across) > self.accuracy
        })
    }

    /// The answers: crossings, and intervals that touch each other as one.
    #[inline]
    fn answers(self, a: &[CurvePiece], b: &[CurvePiece], accuracy: f64, view: View<'_>) -> Vec<Found> {
        let width = |pieces: &[CurvePiece]| match pieces {
            [first, .., last] => last.domain()[1] - first.domain()[0],
            [only] => only.domain()[1] - only.domain()[0],
            [] => 0.0,
        };
        let gaps = [1e-9 * width(a), 1e-9 * width(b)];
        let crossing =
            |at: [f64; 2]| Found { kind: MeetingKind::Crossing, first: [at[0]; 2], second: [at[1]; 2], at };
        let crossings = merged::places(self.crossings, gaps);
        if self.near.is_empty() {
            return crossings.into_iter().map(crossing).collect();
        }
        let seen = |pieces: &[CurvePiece]| pieces.iter().map(|piece| view.of(piece)).collect::<Vec<_>>();
        let answers = Answers { curves: [seen(a), seen(b)], accuracy, itself: !self.own.is_empty() };
        let mut boxes: Vec<[[f64; 2]; 2]> = self.near.iter().map(|near| near.intervals).collect();
        boxes.extend(crossings.iter().map(|&at| answers.around(at)));
        let groups = merged::groups(&boxes, gaps);
        let mut members: Vec<usize> = (0..boxes.len()).collect();
        members.sort_unstable_by_key(|&k| (groups[k], k));
        let mut found = Vec::new();
        for group in members.chunk_by(|&i, &j| groups[i] == groups[j]) {
            // Crossings have the larger indices.
            let (near, crossing_indices) = group.split_at(group.partition_point(|&k| k < self.near.len()));
            let near: Vec<Near> = near.iter().map(|&k| self.near[k]).collect();
            let own: Vec<Found> =
                crossing_indices.iter().map(|&k| crossing(crossings[k - self.near.len()])).collect();
            answers.add(&near, own, &mut found);
        }
        found.sort_by(|a: &Found, b| a.at[0].total_cmp(&b.at[0]).then(a.at[1].total_cmp(&b.at[1])));
        found
    }
}

/// What makes answers of groups.
struct Answers {
    curves: [Vec<CurvePiece>; 2],
    accuracy: f64,
    /// Whether both curves are one.
    itself: bool,
}

impl Answers {
    /// The answers to intervals that are connected to each other, and crossings among them.
    #[inline]
    fn add(&self, near: &[Near], mut crossings: Vec<Found>, found: &mut Vec<Found>) {
        let Some(best) = near.iter().min_by(|a, b| a.distance.total_cmp(&b.distance)) else {
            found.append(&mut crossings);
            return;
        };
        let mut around = best.intervals;
        for part in near {
            for (side, part) in around.iter_mut().zip(part.intervals) {
                *side = [side[0].min(part[0]), side[1].max(part[1])];
            }
        }
        let extent = self.extent(around[0]);
        let long = extent > 20.0 * Scalar::sqrt(self.accuracy);
        let [first, second] = around;
        if !long && !crossings.is_empty() {
            // The rest of the neighbourhood of a crossing belongs to it.
            for part in near {
                let middle = part.intervals.map(|[lo, hi]| 0.5 * (lo + hi));
                let away = |f: &Found| (0..2).map(|k| (f.at[k] - middle[k]).abs()).fold(0.0, f64::max);
                let nearest = crossings.iter_mut().min_by(|a, b| away(a).total_cmp(&away(b)));
                let Some(crossing) = nearest else { continue };
                for (interval, [lo, hi]) in
                    [&mut crossing.first, &mut crossing.second].into_iter().zip(part.intervals)
                {
                    *interval = [interval[0].min(lo), interval[1].max(hi)];
                }
            }
            for crossing in crossings.iter_mut().filter(|crossing| self.is_tangent(crossing.at)) {
                crossing.kind = MeetingKind::Contact;
            }
            found.extend(told_apart(crossings));
            return;
        }
        let Some(at) = self.place(near, best, around, extent) else { return };
        let kind = if long { MeetingKind::Overlap } else { MeetingKind::Contact };
        found.push(Found { kind, first, second, at });
    }

    /// The parameters of an answer; `None` if the curves are not near each other, or parts of one curve are so only
    /// because it turns between them.
    #[inline]
    fn place(&self, near: &[Near], best: &Near, around: [[f64; 2]; 2], extent: f64) -> Option<[f64; 2]> {
        let [a, b] = &self.curves;
        if !self.itself || !self.is_turn(around) {
            let (at, distance) = approach(a, b, best.at, around);
            return (distance <= self.accuracy).then_some(at);
        }
        // If it comes back the way that it went, then from as far as it does.
        let is_place = |at: [f64; 2], distance: f64, enough: f64| {
            at[0] < at[1] && distance <= enough && self.extent(at) > 2.0 * self.accuracy
        };
        let mut starts: Vec<&Near> = near.iter().collect();
        starts.sort_by(|a, b| a.distance.total_cmp(&b.distance));
        let starts = starts.iter().take(STARTS).map(|near| near.at);
        for start in core::iter::once([around[0][0], around[1][1]]).chain(starts) {
            let (at, distance) = approach(a, b, start, around);
            if is_place(at, distance, NOISE) {
                return Some(at);
            }
        }
        if extent <= 4.0 * Scalar::sqrt(self.accuracy) {
            return None;
        }
        let apart = |near: &&Near| near.at[1] - near.at[0];
        let farthest = near
            .iter()
            .filter(|near| is_place(near.at, near.distance, self.accuracy))
            .max_by(|a, b| apart(a).total_cmp(&apart(b)))?;
        Some(farthest.at)
    }

    /// How far the first curve goes away from its point at one end of an interval.
    #[inline]
    fn extent(&self, [lo, hi]: [f64; 2]) -> f64 {
        let start = point(&self.curves[0], lo);
        let away = |k: u32| {
            let end = point(&self.curves[0], lo + 0.125 * f64::from(k) * (hi - lo));
            start.iter().zip(&end).map(|(a, b)| (a - b) * (a - b)).sum::<f64>()
        };
        Scalar::sqrt((1..=8).map(away).fold(0.0, f64::max))
    }

    /// Whether a curve turns between parts of it, at a cusp or a corner, so that they are near each other there.
    #[inline]
    fn is_turn(&self, [first, second]: [[f64; 2]; 2]) -> bool {
        let [from, to] = [first[1], second[0]].map(|t| point(&self.curves[0], t));
        let square: f64 = from.iter().zip(&to).map(|(a, b)| (a - b) * (a - b)).sum();
        first[1] >= second[0] || square <= 64.0 * self.accuracy * self.accuracy
    }

    /// Whether the curves have one tangent at a place, up to what rounding errors make of a contact.
    #[inline]
    fn is_tangent(&self, at: [f64; 2]) -> bool {
        let pieces = [0, 1].map(|k| super::local::piece_at(&self.curves[k], at[k]));
        let [Some(a), Some(b)] = pieces else { return false };
        let (_, [p, q]) = state(a, b, [a.place(at[0]), b.place(at[1])]);
        let (pp, pq, qq) = (dot(&p, &p), dot(&p, &q), dot(&q, &q));
        pp * qq - pq * pq <= 1e-11 * pp * qq
    }

    /// Intervals around a crossing outside of which the curves are not near each other, as far as they are straight.
    #[inline]
    fn around(&self, at: [f64; 2]) -> [[f64; 2]; 2] {
        let pieces = [0, 1].map(|k| super::local::piece_at(&self.curves[k], at[k]));
        let [Some(a), Some(b)] = pieces else { return at.map(|t| [t, t]) };
        let places = [a.place(at[0]), b.place(at[1])];
        let (_, columns) = state(a, b, places);
        let Some(rows) = pseudo_inverse(&columns) else { return at.map(|t| [t, t]) };
        let reach = rows.map(|row| 2.0 * self.accuracy * Scalar::sqrt(dot(&row, &row)));
        let sign = if dot(&columns[0], &columns[1]) > 0.0 { -1.0 } else { 1.0 };
        let mut around = places.map(|place| [place; 2]);
        for side in [1.0, -1.0] {
            // Almost parallel ones are not straight as far as that.
            let is_near = |at: [f64; 2]| {
                let (value, _) = state(a, b, at);
                dot(&value, &value) <= 16.0 * self.accuracy * self.accuracy
            };
            let mut steps = reach;
            let mut aside = clipping::both_inside(places, [side, side * sign], steps);
            while steps[0].max(steps[1]) > 1e-12 && !is_near(aside) {
                steps = steps.map(|step| 0.5 * step);
                aside = clipping::both_inside(places, [side, side * sign], steps);
            }
            clipping::extend(&mut around, aside);
        }
        // Where one ends, the other one goes on alone.
        for k in 0..2 {
            let alone = 2.0 * self.accuracy / Scalar::sqrt(dot(&columns[k], &columns[k]));
            for step in [alone, -alone] {
                let mut aside = places;
                aside[k] = (aside[k] + step).clamp(0.0, 1.0);
                clipping::extend(&mut around, aside);
            }
        }
        let pieces = [a, b];
        [0, 1].map(|k| around[k].map(|place| pieces[k].parameter(place)))
    }
}

/// Crossings with their neighbourhoods; those in the neighbourhoods of each other are one place at which the curves touch.
#[inline]
fn told_apart(mut crossings: Vec<Found>) -> Vec<Found> {
    let within = |f: &Found, at: [f64; 2]| {
        [f.first, f.second].iter().zip(at).all(|(side, t)| (side[0]..=side[1]).contains(&t))
    };
    let mut kept: Vec<Found> = Vec::with_capacity(crossings.len());
    while let Some(mut next) = crossings.pop() {
        // One that has grown may contain another one.
        while let Some(k) = kept.iter().position(|f| within(f, next.at) || within(&next, f.at)) {
            let other = kept.swap_remove(k);
            for (side, [lo, hi]) in [(&mut next.first, other.first), (&mut next.second, other.second)] {
                *side = [side[0].min(lo), side[1].max(hi)];
            }
            next.kind = MeetingKind::Contact;
        }
        kept.push(next);
    }
    kept
}

/// What is known of parts that meet at most once.
enum Single {
    /// They do not meet.
    None,
    /// They meet at these parameters of the curves.
    At([f64; 2]),
}

/// Whether the parts meet, or come as near to each other as a distance, if they meet at most once.
#[inline]
fn at_most_one(pair: &Pair, distance: f64) -> Option<Single> {
    let Pair { first, second } = pair;
    let dim = first.dimension();
    let (value, columns) = state(first, second, [0.5; 2]);
    let inverse = pseudo_inverse(&columns)?;
    let step: Vec<f64> = inverse.iter().map(|row| -dot(row, &value)).collect();
    // |M F' - 1| by rows, from the control points of both derivatives.
    let mut sums = [0.0_f64; 2];
    for (column, vectors) in derivatives(first, second).into_iter().enumerate() {
        for (r, row) in inverse.iter().enumerate() {
            let one = if r == column { 1.0 } else { 0.0 };
            sums[r] += vectors.iter().map(|v| (dot(row, v) - one).abs()).fold(0.0, f64::max);
        }
    }
    let q = sums[0].max(sums[1]);
    if q.is_nan() || q >= 0.9 {
        return None;
    }
    let margin = 1e-10;
    let reach = |k: usize| distance * Scalar::sqrt(dot(&inverse[k], &inverse[k]));
    let possible = (0..2).all(|k| (step[k]).abs() <= 0.5 + 0.5 * q + reach(k) + margin);
    if !possible {
        return Some(Single::None);
    }
    let mut at = [0.5 + step[0], 0.5 + step[1]];
    for _ in 0..12 {
        let (value, columns) = state(first, second, at);
        let inverse = pseudo_inverse(&columns)?;
        let step = [0, 1].map(|r| -dot(&inverse[r], &value));
        at = [at[0] + step[0], at[1] + step[1]];
        if !(at[0].abs() < 4.0 && at[1].abs() < 4.0) {
            return None;
        }
        if step[0].abs().max(step[1].abs()) < 1e-15 {
            break;
        }
    }
    let (value, _) = state(first, second, at);
    let noise = 64.0 * f64::EPSILON * (first.degree() + second.degree() + dim) as f64;
    if dot(&value, &value) > noise * noise || !at.iter().all(|&x| x >= -margin && x <= 1.0 + margin) {
        return None;
    }
    let at = at.map(|x| x.clamp(0.0, 1.0));
    Some(Single::At([first.parameter(at[0]), second.parameter(at[1])]))
}

/// The control vectors of the derivatives of `F` in `x` and in `y` over both parts.
#[inline]
fn derivatives(first: &CurvePiece, second: &CurvePiece) -> [Vec<Vec<f64>>; 2] {
    let dim = first.dimension();
    let one = |part: &CurvePiece| vec![1.0; part.degree() + 1];
    let weights = [first, second].map(|part| part.weights().map_or_else(|| one(part), <[f64]>::to_vec));
    let slopes = [0, 1].map(|k| derivative(&weights[k]));
    let rational = first.weights().is_some() || second.weights().is_some();
    let combine = |inner: &dyn Fn(usize, usize, usize) -> f64, sizes: [usize; 2]| -> Vec<Vec<f64>> {
        let pairs = (0..sizes[0]).flat_map(|i| (0..sizes[1]).map(move |j| (i, j)));
        pairs.map(|(i, j)| (0..dim).map(|d| inner(d, i, j)).collect()).collect()
    };
    let a: Vec<[Vec<f64>; 2]> =
        (0..dim).map(|d| [first.component(d).to_vec(), derivative(first.component(d))]).collect();
    let b: Vec<[Vec<f64>; 2]> =
        (0..dim).map(|d| [second.component(d).to_vec(), derivative(second.component(d))]).collect();
    let [m, n] = [first.degree(), second.degree()];
    if !rational {
        return [combine(&|d, i, _| a[d][1][i], [m, 1]), combine(&|d, _, j| -b[d][1][j], [1, n])];
    }
    [
        combine(&|d, i, j| a[d][1][i] * weights[1][j] - b[d][0][j] * slopes[0][i], [m, n + 1]),
        combine(&|d, i, j| a[d][0][i] * slopes[1][j] - b[d][1][j] * weights[0][i], [m + 1, n]),
    ]
}

/// The control vectors of a curve in the direction of the velocity.
#[inline]
fn velocities(part: &CurvePiece) -> Vec<Vec<f64>> {
    let dim = part.dimension();
    let lists: Vec<Vec<f64>> = (0..dim)
        .map(|d| match part.weights() {
            None => derivative(part.component(d)),
            Some(weights) => {
                let mut slope = product(&derivative(part.component(d)), weights);
                for (s, p) in slope.iter_mut().zip(product(part.component(d), &derivative(weights))) {
                    *s -= p;
                }
                slope
            }
        })
        .collect();
    let count = lists.first().map_or(0, Vec::len);
    (0..count).map(|i| lists.iter().map(|list| list[i]).collect()).collect()
}

/// Whether consecutive parts go on in one direction, from the control vectors of their derivatives: such a curve does not
/// come back.
#[inline]
fn is_forward(parts: &[CurvePiece]) -> bool {
    let all: Vec<Vec<f64>> = parts.iter().flat_map(velocities).collect();
    let dim = all.first().map_or(0, Vec::len);
    let axis: Vec<f64> = (0..dim).map(|d| all.iter().map(|v| v[d]).sum()).collect();
    all.iter().all(|v| dot(v, &axis) > 0.0)
}
