//! The search for places at which parts of curves may meet, by exclusion and bisection.

use alloc::vec;
use alloc::vec::Vec;

use super::along::along;
use super::answers::Answers;
use super::beside::{self, Near, Straight, dot};
use super::clipping::{self, View};
use super::single::{Pair, Single, at_most_one, is_forward};
use super::{Found, MeetingKind, line, merged};
use crate::{CurvePiece, Scalar};

/// After this number of pairs of parts, those that are left are compared in twice the accuracy, and so on: what is near
/// each other then is an answer that is not decided.
const WORK: usize = 40_000;

/// What straight parts may be away from their chords, in the unit of the accuracy.
const STRAIGHT: f64 = 0.125;

pub(super) struct Search<'a> {
    accuracy: f64,
    /// Whether this is still the accuracy that was asked for.
    decided: bool,
    /// The pieces of the curve that is asked for places at which it meets itself; nothing if there are two curves.
    pub(super) own: &'a [CurvePiece],
    pub(super) open: Vec<Pair>,
    crossings: Vec<[f64; 2]>,
    /// Where the curves are near each other.
    near: Vec<Near>,
}

impl Search<'_> {
    #[inline]
    pub(super) fn new(accuracy: f64) -> Self {
        Self { accuracy, decided: true, own: &[], open: Vec::new(), crossings: Vec::new(), near: Vec::new() }
    }

    /// Two pieces, first by clipping; what that leaves is open.
    #[inline]
    pub(super) fn between(&mut self, first: &CurvePiece, second: &CurvePiece, view: View<'_>) {
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
            Near { intervals, at: intervals.map(|[lo, hi]| 0.5 * (lo + hi)), distance: 0.0, decided: true }
        }));
    }

    /// Pairs of parts of one piece.
    #[inline]
    pub(super) fn against_itself(&mut self, piece: &CurvePiece) {
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
    pub(super) fn run(&mut self) {
        let mut work = 0;
        while let Some(pair) = self.open.pop() {
            work += 1;
            if work > WORK {
                (work, self.accuracy, self.decided) = (WORK / 2, 2.0 * self.accuracy, false);
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
                let near = beside::near([first, second], (1.0 + 2.0 * STRAIGHT) * self.accuracy);
                self.near.extend(near.map(|near| Near { decided: self.decided, ..near }));
                continue;
            }
            let straight = straight.map(|part| part.is_some());
            if self.is_alike(&pair) || self.is_along(&pair) {
                continue;
            }
            // What is not straight is divided first, then what is longer.
            let lengths = [&pair.first, &pair.second].map(|part| part.length_bounds()[1]);
            let first = if straight[0] == straight[1] { lengths[0] >= lengths[1] } else { straight[1] };
            let Pair { first: a, second: b } = pair;
            let halves = if first { a.split(0.5) } else { b.split(0.5) };
            if halves.iter().any(|half| half.domain()[0] >= half.domain()[1]) {
                let intervals = [a.domain(), b.domain()];
                self.near.push(Near {
                    intervals,
                    at: intervals.map(|[lo, _]| lo),
                    distance: self.accuracy,
                    decided: false,
                });
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
        self.near.push(Near { intervals: ordered, at, distance: 0.0, decided: self.decided });
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

    /// Whether parts run along each other, so that all is known of them.
    #[inline]
    fn is_along(&mut self, pair: &Pair) -> bool {
        let Some(known) = along(&pair.first, &pair.second, self.accuracy) else { return false };
        self.near.extend(known.near.into_iter().map(|near| Near { decided: self.decided, ..near }));
        self.crossings.extend(known.crossings);
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
        let start = self.own.partition_point(|piece| piece.domain()[1] <= from);
        let end = self.own.partition_point(|piece| piece.domain()[0] < to);
        let between = self.own.get(start..end).unwrap_or_default();
        !self.own.is_empty() && self.goes_on(&between.iter().filter_map(part).collect::<Vec<_>>())
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
    pub(super) fn answers(
        self,
        a: &[CurvePiece],
        b: &[CurvePiece],
        accuracy: f64,
        view: View<'_>,
    ) -> Vec<Found> {
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
