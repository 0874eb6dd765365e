//! Where curves meet: by exclusion of parts that are apart, and a test that two parts meet at most once.
//!
//! Two parts `A(x)` and `B(y)` are put aside when their boxes, or their control points along the direction from one to
//! the other, are farther apart than the accuracy. With a matrix `M` near the inverse of the derivative of `F = A - B`
//! in the middle and `q = max |M F' - 1| < 1` over both parts, from the control points of the derivatives, `F` has at
//! most one zero, and that lies within `q/2` of the place to which Newton's step leads from the middle (the operator of
//! Krawczyk): if that is outside of both parts there is none; otherwise Newton's method finds it. All others are
//! halved, until they are so short, or so straight, that they are one answer within the accuracy. So nothing is left
//! out.

use alloc::vec;
use alloc::vec::Vec;

use super::CurvePiece;
use super::beside::{approach, beside, dot, is_beside, point, pseudo_inverse, state};
use super::clipping::{self, View};
use super::piece::{derivative, product};
use super::{line, merged};
use crate::Scalar;

/// The most pairs of parts that are looked at; those that are left then are answers as they are.
const WORK: usize = 300_000;

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
        return Some(search.answers(a, b, view));
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
    Some(search.answers(a, b, view))
}

/// All places at which a curve meets itself, the smaller parameter first, but for the one at which a closed curve ends
/// where it begins; `None` if anything is not finite.
#[inline]
pub(crate) fn self_meetings(a: &[CurvePiece], accuracy: f64, epsilon: f64) -> Option<Vec<Found>> {
    let (view, accuracy) = view(a, &[], accuracy, epsilon)?;
    let mut search = Search::new(accuracy);
    let seen: Vec<CurvePiece> = a.iter().map(|piece| view.of(piece)).collect();
    for (k, first) in seen.iter().enumerate() {
        search.against_itself(first);
        for (n, second) in seen.iter().enumerate().skip(k + 1) {
            if n == k + 1 {
                search.open.push(Pair { first: first.clone(), second: second.clone(), adjacent: true });
            } else {
                search.between(&a[k], &a[n], view);
            }
        }
    }
    search.run();
    let mut found = search.answers(a, a, view);
    let ends = [a.first()?.domain()[0], a.last()?.domain()[1]];
    let near = 1e-9 * (ends[1] - ends[0]);
    found.retain(|f| {
        f.first[0] > ends[0] + near || f.second[1] < ends[1] - near || f.kind == MeetingKind::Overlap
    });
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

/// Two parts that may meet.
struct Pair {
    first: CurvePiece,
    second: CurvePiece,
    /// Whether the second one begins where the first one ends, which is not asked for.
    adjacent: bool,
}

struct Search {
    accuracy: f64,
    open: Vec<Pair>,
    crossings: Vec<[f64; 2]>,
    /// Intervals of both parameters in which the curves are near each other.
    near: Vec<[[f64; 2]; 2]>,
}

impl Search {
    #[inline]
    fn new(accuracy: f64) -> Self {
        Self { accuracy, open: Vec::new(), crossings: Vec::new(), near: Vec::new() }
    }

    /// Two pieces, first by clipping; what that leaves is open.
    #[inline]
    fn between(&mut self, first: &CurvePiece, second: &CurvePiece, view: View<'_>) {
        let mut open = |ranges: [[f64; 2]; 2]| {
            let part = |piece: &CurvePiece, [from, to]: [f64; 2]| view.of(piece).restricted(from, to);
            let (first, second) = (part(first, ranges[0]), part(second, ranges[1]));
            self.open.push(Pair { first, second, adjacent: false });
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
        self.near.extend(
            outcome
                .near
                .into_iter()
                .map(|[x, y]| [x.map(|x| first.parameter(x)), y.map(|y| second.parameter(y))]),
        );
    }

    /// Pairs of parts of one piece.
    #[inline]
    fn against_itself(&mut self, piece: &CurvePiece) {
        let mut open = vec![piece.clone()];
        while let Some(part) = open.pop() {
            let velocities = velocities(&part);
            let axis: Vec<f64> =
                (0..part.dimension()).map(|d| velocities.iter().map(|v| v[d]).sum()).collect();
            let forward = velocities.iter().all(|v| dot(v, &axis) > 0.0);
            // A curve that goes on in one direction does not come back.
            if forward || part.length_bounds()[1] <= self.accuracy {
                continue;
            }
            let [before, after] = part.split(0.5);
            self.open.push(Pair { first: before.clone(), second: after.clone(), adjacent: true });
            open.extend([before, after]);
        }
    }

    #[inline]
    fn run(&mut self) {
        let mut work = 0;
        while let Some(pair) = self.open.pop() {
            work += 1;
            if self.is_apart(&pair) {
                continue;
            }
            if pair.adjacent {
                if !self.goes_on(&pair) {
                    self.divide_neighbours(&pair);
                }
                continue;
            }
            if work > WORK {
                self.near.push([pair.first.domain(), pair.second.domain()]);
                continue;
            }
            match at_most_one(&pair) {
                Some(Single::None) => continue,
                Some(Single::At(at)) => {
                    self.crossings.push(at);
                    continue;
                }
                None => {}
            }
            let lengths = [&pair.first, &pair.second].map(|part| part.length_bounds()[1]);
            let straight = [&pair.first, &pair.second].map(|part| width(part) <= 0.125 * self.accuracy);
            if straight == [true, true] || lengths[0].max(lengths[1]) <= self.accuracy {
                let beside = [
                    beside(&pair.first, &pair.second, self.accuracy),
                    beside(&pair.second, &pair.first, self.accuracy),
                ];
                let [Some(first), Some(second)] = beside else { continue };
                // Straight parts may also cross each other.
                let short = lengths[0].max(lengths[1]) <= self.accuracy;
                if short
                    || first.iter().all(|&t| is_beside(&pair.first, t, &pair.second, 2.0 * self.accuracy))
                {
                    self.near.push([first, second]);
                    continue;
                }
            }
            // What is not straight is divided first, then what is longer.
            let first = if straight[0] == straight[1] { lengths[0] >= lengths[1] } else { straight[1] };
            let part = if first { &pair.first } else { &pair.second };
            let halves = part.split(0.5);
            if halves.iter().any(|half| half.domain()[0] >= half.domain()[1]) {
                self.near.push([pair.first.domain(), pair.second.domain()]);
                continue;
            }
            for half in halves {
                self.open.push(if first {
                    Pair { first: half, second: pair.second.clone(), adjacent: false }
                } else {
                    Pair { first: pair.first.clone(), second: half, adjacent: false }
                });
            }
        }
    }

    /// Whether the curve goes on in one direction from the first part to the second, so that they meet only there; also
    /// if both are as short as the accuracy.
    #[inline]
    fn goes_on(&self, pair: &Pair) -> bool {
        let mut all = velocities(&pair.first);
        all.extend(velocities(&pair.second));
        let axis: Vec<f64> = (0..pair.first.dimension()).map(|d| all.iter().map(|v| v[d]).sum()).collect();
        let lengths = [&pair.first, &pair.second].map(|part| part.length_bounds()[1]);
        all.iter().all(|v| dot(v, &axis) > 0.0) || lengths[0].max(lengths[1]) <= self.accuracy
    }

    #[inline]
    fn divide_neighbours(&mut self, pair: &Pair) {
        let ([a, b], [c, d]) = (pair.first.split(0.5), pair.second.split(0.5));
        let apart = |first: &CurvePiece, second: &CurvePiece| Pair {
            first: first.clone(),
            second: second.clone(),
            adjacent: false,
        };
        self.open.extend([apart(&a, &c), apart(&a, &d), apart(&b, &d)]);
        self.open.push(Pair { first: b, second: c, adjacent: true });
    }

    /// Whether the parts are farther from each other than the accuracy: their boxes, or their control points across the
    /// chord of one of them.
    #[inline]
    fn is_apart(&self, pair: &Pair) -> bool {
        let Pair { first, second, .. } = pair;
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
    fn answers(mut self, a: &[CurvePiece], b: &[CurvePiece], view: View<'_>) -> Vec<Found> {
        let width = |pieces: &[CurvePiece]| match pieces {
            [first, .., last] => last.domain()[1] - first.domain()[0],
            [only] => only.domain()[1] - only.domain()[0],
            [] => 0.0,
        };
        let gaps = [1e-9 * width(a), 1e-9 * width(b)];
        let groups = merged::boxes(core::mem::take(&mut self.near), gaps);
        let mut found: Vec<Found> = Vec::new();
        for at in merged::places(self.crossings, gaps) {
            let [first, second] = at.map(|t| [t, t]);
            found.push(Found { kind: MeetingKind::Crossing, first, second, at });
        }
        let count = found.len();
        let seen = |pieces: &[CurvePiece]| pieces.iter().map(|piece| view.of(piece)).collect::<Vec<_>>();
        let (a, b) = if groups.is_empty() { (Vec::new(), Vec::new()) } else { (seen(a), seen(b)) };
        for [first, second] in groups {
            // The rest of the neighbourhood of a crossing belongs to it.
            let reach = |[lo, hi]: [f64; 2], gap: f64| [lo - (hi - lo) - gap, hi + (hi - lo) + gap];
            let ([from, to], [low, high]) = (reach(first, gaps[0]), reach(second, gaps[1]));
            let crossings = &mut found[..count];
            let start = crossings.partition_point(|f| f.at[0] < from);
            let mut near = crossings[start..].iter_mut().take_while(|f| f.at[0] <= to);
            if let Some(crossing) = near.find(|f| (low..=high).contains(&f.at[1])) {
                for (interval, [lo, hi]) in [(&mut crossing.first, first), (&mut crossing.second, second)] {
                    *interval = [interval[0].min(lo), interval[1].max(hi)];
                }
                continue;
            }
            let at = approach(&a, &b, [0.5 * (first[0] + first[1]), 0.5 * (second[0] + second[1])]);
            let at = [at[0].clamp(first[0], first[1]), at[1].clamp(second[0], second[1])];
            let ends = first.map(|t| point(&a, t));
            let square: f64 = ends[0].iter().zip(&ends[1]).map(|(a, b)| (a - b) * (a - b)).sum();
            // What two curves that touch have in common is some roots of the accuracy long.
            let long = Scalar::sqrt(square) > 20.0 * Scalar::sqrt(self.accuracy);
            let kind = if long { MeetingKind::Overlap } else { MeetingKind::Contact };
            found.push(Found { kind, first, second, at });
        }
        found.sort_by(|a, b| a.at[0].total_cmp(&b.at[0]).then(a.at[1].total_cmp(&b.at[1])));
        found
    }
}

/// What is known of parts that meet at most once.
enum Single {
    /// They do not meet.
    None,
    /// They meet at these parameters of the curves.
    At([f64; 2]),
}

/// Whether the parts meet, if they meet at most once.
#[inline]
fn at_most_one(pair: &Pair) -> Option<Single> {
    let Pair { first, second, .. } = pair;
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
    let possible = (0..2).all(|k| (step[k]).abs() <= 0.5 + 0.5 * q + margin);
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

/// The largest distance of a control point from the line through the ends; the length of a part whose ends coincide.
#[inline]
fn width(part: &CurvePiece) -> f64 {
    let (dim, last) = (part.dimension(), part.degree());
    let chord: Vec<f64> = (0..dim).map(|d| part.control(last, d) - part.control(0, d)).collect();
    let square = dot(&chord, &chord);
    let mut widest = 0.0_f64;
    for i in 1..last {
        let arm: Vec<f64> = (0..dim).map(|d| part.control(i, d) - part.control(0, d)).collect();
        let x = if square > 0.0 { (dot(&arm, &chord) / square).clamp(0.0, 1.0) } else { 0.0 };
        let away: f64 = arm.iter().zip(&chord).map(|(a, c)| (a - x * c) * (a - x * c)).sum();
        widest = widest.max(Scalar::sqrt(away));
    }
    widest
}
