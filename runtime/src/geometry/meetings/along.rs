//! Where two parts that run along each other are near each other: their distance across as a function of one parameter.
//!
//! Between two places of `A` and the feet of their points on `B`, let `y(x)` be linear and `D(x) = A(x) - B(y(x))`. With
//! the direction `c` of `B`, a unit vector `e` across it and `n(x) = e - σ(x) c`, where the linear function `σ` makes `n`
//! orthogonal to `B` at both ends, let `A(x)` and `B(y(x) + s)` be no farther from each other than the accuracy. Then
//!
//! - `|s| <= (|c·D| + accuracy) / min c·B'`,
//! - `n·(A(x) - B(y(x) + s))` differs from `n·D` by no more than `|s| (|n·B'(y(x))| + |s| |n| |B''|)`,
//!
//! which falls with a power of the length of the interval, however near the curves are to each other. So the control
//! points of `n·D` say where they are near: what is farther is clipped off, the rest is divided.

use alloc::vec;
use alloc::vec::Vec;

use super::beside::{Near, difference, dot, nearest_inside, pseudo_inverse, state, values};
use super::single::velocity_lists;
use crate::geometry::{derivative, product};
use crate::{CurvePiece, Scalar, bernstein};

/// How many intervals are looked at before the parts are handed back.
const WORK: usize = 800;

/// The least cosine of the angle between a derivative and the axis, and of two such angles together.
const CONE: f64 = 0.75;
const TWICE: f64 = 2.0 * CONE * CONE - 1.0;

/// Where intervals are divided: not in the middle, where symmetric curves meet.
const DIVISION: f64 = 0.515_625;

/// The part of the accuracy by which an answer may be too long.
const SLACK: f64 = 0.125;

/// A bound of the rounding errors of differences of points, of which no component is larger than 1.
const NOISE: f64 = 64.0 * f64::EPSILON;

/// What is known of two parts, in the parameters of their curves: everything at which they meet is in an interval.
#[derive(Default)]
pub(super) struct Along {
    pub(super) near: Vec<Near>,
    pub(super) crossings: Vec<[f64; 2]>,
}

/// Where parts are not farther from each other than the accuracy; `None` if they do not run along each other, are as far
/// apart as they bend, so that shorter parts are easily told apart, or are near each other too often.
#[inline]
pub(super) fn along(first: &CurvePiece, second: &CurvePiece, accuracy: f64) -> Option<Along> {
    if first.dimension() < 2 {
        return None;
    }
    if !have_one_direction(first, second) {
        return None;
    }
    let guide = Guide::of(first, second, accuracy)?;
    if !guide.is_flatter_than_bent() {
        return None;
    }
    let mut known = Along::default();
    let mut open = vec![[0.0, 1.0]];
    let mut work = 0;
    while let Some([lo, hi]) = open.pop() {
        work += 1;
        if work > WORK {
            return None;
        }
        let stretch = guide.stretch([lo, hi]);
        if stretch.is_beyond_the_end(&guide) {
            continue;
        }
        let Some(heights) = stretch.heights(&guide) else { continue };
        if hi - lo <= 4.0 * f64::EPSILON || heights.near {
            guide.add(&stretch, &heights, &mut known);
            continue;
        }
        let at = |x: f64| lo + x * (hi - lo);
        let [from, to] = heights.range;
        let [start, end] = [if from > 0.0 { at(from) } else { lo }, if to < 1.0 { at(to) } else { hi }];
        if to - from < 0.7 {
            open.push([start, end]);
            continue;
        }
        let middle = start + DIVISION * (end - start);
        if middle <= start || middle >= end {
            guide.add(&stretch, &heights, &mut known);
            continue;
        }
        open.extend([[middle, end], [start, middle]]);
    }
    Some(known)
}

/// Whether the chords do not turn by more than a third of a right angle from each other.
#[inline]
fn have_one_direction(first: &CurvePiece, second: &CurvePiece) -> bool {
    let [a, b] = [first, second].map(|part| difference(&values(part, 1.0), &values(part, 0.0)));
    let along = dot(&a, &b);
    along * along > CONE * dot(&a, &a) * dot(&b, &b)
}

/// Two parts, of which the second one is that along which distances are measured.
struct Guide<'a> {
    first: &'a CurvePiece,
    second: &'a CurvePiece,
    accuracy: f64,
    /// The numerators of the derivative of the second part, and its denominator, the square of these weights.
    velocity: Vec<Vec<f64>>,
    weights: [f64; 2],
    /// The direction in which the second part goes.
    axis: Vec<f64>,
    /// The smallest speed, and the largest second derivative.
    slowest: f64,
    bend: f64,
}

impl<'a> Guide<'a> {
    /// `None` if the parts do not go in one direction, or in opposite ones.
    #[inline]
    fn of(first: &'a CurvePiece, second: &'a CurvePiece, accuracy: f64) -> Option<Self> {
        let velocity = velocity_lists(second);
        let sum: Vec<f64> = velocity.iter().map(|list| list.iter().sum()).collect();
        let axis = unit(&sum)?;
        let (mut slowest, mut fastest) = (f64::INFINITY, 0.0_f64);
        for i in 0..velocity[0].len() {
            let vector: Vec<f64> = velocity.iter().map(|list| list[i]).collect();
            let (size, ahead) = (Scalar::sqrt(dot(&vector, &vector)), dot(&vector, &axis));
            if ahead.is_nan() || ahead < CONE * size || size == 0.0 {
                return None;
            }
            (slowest, fastest) = (slowest.min(ahead), fastest.max(size));
        }
        let other = velocity_lists(first);
        let sum: Vec<f64> = other.iter().map(|list| list.iter().sum()).collect();
        let side = if dot(&sum, &axis) < 0.0 { -1.0 } else { 1.0 };
        for i in 0..other[0].len() {
            let vector: Vec<f64> = other.iter().map(|list| side * list[i]).collect();
            let ahead = dot(&vector, &axis);
            if ahead.is_nan() || ahead <= 0.5 * Scalar::sqrt(dot(&vector, &vector)) {
                return None;
            }
        }
        let weights = second.weights().map_or([1.0; 2], bernstein::bounds);
        let [low, high] = weights;
        let slopes: Vec<Vec<f64>> = velocity.iter().map(|list| derivative(list)).collect();
        let mut bend = largest(&slopes) / (low * low);
        if let Some(weights) = second.weights() {
            let slope = derivative(weights).iter().fold(0.0_f64, |most, c| most.max(c.abs()));
            bend += 2.0 * fastest * slope / (low * low * low);
        }
        let slowest = slowest / (high * high);
        Some(Self { first, second, accuracy, velocity, weights, axis, slowest, bend })
    }

    /// Whether the parts, as far as they are beside each other, are nearer to each other than the second one is bent.
    #[inline]
    fn is_flatter_than_bent(&self) -> bool {
        let feet = [0.0, 1.0].map(|y| nearest_inside(self.first, &values(self.second, y)));
        let (lo, hi) = (feet[0].min(feet[1]), feet[0].max(feet[1]));
        if hi - lo < 0.01 {
            return false;
        }
        let stretch = self.stretch([lo, hi]);
        let [from, to] = stretch.y;
        let [start, middle, end] = [from, 0.5 * (from + to), to].map(|y| values(self.second, y));
        let Some(chord) = unit(&difference(&end, &start)) else { return false };
        let bow: f64 =
            (0..start.len()).map(|d| 2.0 * middle[d] - start[d] - end[d]).map(|bow| bow * bow).sum();
        let across: Vec<Vec<f64>> =
            axes_across(&chord).iter().map(|axis| combined(&stretch.apart, axis)).collect();
        let apart = largest(&across) / stretch.lightest();
        16.0 * apart * apart <= bow
    }

    /// The difference of both parts in an interval of the first one.
    #[inline]
    fn stretch(&self, x: [f64; 2]) -> Stretch {
        let y = x.map(|x| nearest_inside(self.second, &values(self.first, x)));
        let (a, b) = (self.first.restricted(x[0], x[1]), self.second.restricted(y[0], y[1]));
        let one = |part: &CurvePiece| vec![1.0; part.degree() + 1];
        let [v, w] = [&a, &b].map(|part| part.weights().map_or_else(|| one(part), <[f64]>::to_vec));
        let apart = (0..a.dimension())
            .map(|d| {
                let mut row = product(a.component(d), &w);
                for (row, other) in row.iter_mut().zip(product(b.component(d), &v)) {
                    *row -= other;
                }
                row
            })
            .collect();
        let mut velocity = self.velocity.clone();
        for list in &mut velocity {
            bernstein::restrict(list, y[0], y[1]);
        }
        Stretch { x, y, apart, weight: product(&v, &w), velocity }
    }

    /// Adds an interval in which the parts are near each other, and the place at which they cross.
    #[inline]
    fn add(&self, stretch: &Stretch, heights: &Heights, known: &mut Along) {
        let Stretch { x: [lo, hi], y, .. } = stretch;
        let place = |u: f64| [lo + u * (hi - lo), y[0] + u * (y[1] - y[0])];
        let (u, distance) = heights.least();
        let side = [y[0].min(y[1]) - heights.reach, y[0].max(y[1]) + heights.reach];
        let intervals = [[*lo, *hi], side.map(|y| y.clamp(0.0, 1.0))];
        let parameters = |[x, y]: [f64; 2]| [self.first.parameter(x), self.second.parameter(y)];
        let mut at = place(u);
        if let Some(found) = self.crossing(at, intervals) {
            at = found;
            known.crossings.push(parameters(at));
        }
        let [x, y] = intervals;
        let intervals = [x.map(|x| self.first.parameter(x)), y.map(|y| self.second.parameter(y))];
        known.near.push(Near { intervals, at: parameters(at), distance, decided: true });
    }

    /// The place in intervals at which the parts cross, by Newton's method; `None` if that does not converge as it does
    /// to a simple zero.
    #[inline]
    fn crossing(&self, start: [f64; 2], intervals: [[f64; 2]; 2]) -> Option<[f64; 2]> {
        let mut at = start;
        for _ in 0..8 {
            let (value, columns) = state(self.first, self.second, at);
            let rows = pseudo_inverse(&columns)?;
            let step = [0, 1].map(|k| dot(&rows[k], &value));
            at = [at[0] - step[0], at[1] - step[1]];
            for (at, [lo, hi]) in at.iter_mut().zip(intervals) {
                let room = 1e-10 + 0.5 * (hi - lo);
                if !(*at >= lo - room && *at <= hi + room) {
                    return None;
                }
            }
            let noise = |k: usize| 1e-14 + NOISE * Scalar::sqrt(dot(&rows[k], &rows[k]));
            if step[0].abs() <= noise(0) && step[1].abs() <= noise(1) {
                let (value, _) = state(self.first, self.second, at);
                let inside =
                    (0..2).all(|k| at[k] >= intervals[k][0] - 1e-10 && at[k] <= intervals[k][1] + 1e-10);
                let is_zero = dot(&value, &value) <= NOISE * NOISE;
                return (inside && is_zero).then(|| at.map(|x| x.clamp(0.0, 1.0)));
            }
        }
        None
    }
}

/// The difference of both parts between two places of the first one and their feet.
struct Stretch {
    x: [f64; 2],
    y: [f64; 2],
    /// The numerators of the difference, and its denominator.
    apart: Vec<Vec<f64>>,
    weight: Vec<f64>,
    /// The numerators of the derivative of the second part.
    velocity: Vec<Vec<f64>>,
}

impl Stretch {
    /// Whether the first part is before the start or behind the end of the second one, farther than the accuracy.
    #[inline]
    fn is_beyond_the_end(&self, guide: &Guide<'_>) -> bool {
        let [from, to] = self.y;
        if from != to || from != 0.0 && from != 1.0 {
            return false;
        }
        let side = if from == 0.0 { -1.0 } else { 1.0 };
        let ahead = combined(&self.apart, &guide.axis);
        ahead.iter().zip(&self.weight).all(|(a, w)| side * a > (guide.accuracy + NOISE) * w)
    }

    /// A lower bound of the denominator.
    #[inline]
    fn lightest(&self) -> f64 {
        self.weight.iter().fold(f64::INFINITY, |least, &w| least.min(w))
    }

    /// The distance across the second part; `None` if that is nowhere as small as the accuracy.
    #[inline]
    fn heights(&self, guide: &Guide<'_>) -> Option<Heights> {
        let last = self.velocity[0].len() - 1;
        let ends = [0, last].map(|i| self.velocity.iter().map(|list| list[i]).collect::<Vec<f64>>());
        let both: Vec<f64> = ends[0].iter().zip(&ends[1]).map(|(a, b)| a + b).collect();
        let Some(chord) = unit(&both) else { return Some(Heights::default()) };
        let ahead = combined(&self.apart, &chord);
        let shift =
            ahead.iter().fold(0.0_f64, |most, a| most.max(a.abs())) / self.lightest() + guide.accuracy;
        let speed = combined(&self.velocity, &chord);
        let [low, high] = guide.weights;
        let slowest = speed.iter().fold(f64::INFINITY, |least, &v| least.min(v)) / (high * high);
        let mut reach = shift / (TWICE * guide.slowest);
        if slowest > reach * guide.bend {
            reach = reach.min(shift / (slowest - reach * guide.bend));
        }
        // Not where the second part ends.
        let beside = |end: f64, weight: f64| end.abs() <= (1.0 + SLACK) * (guide.accuracy + NOISE) * weight;
        let near = beside(ahead[0], self.weight[0])
            && beside(ahead[ahead.len() - 1], self.weight[self.weight.len() - 1]);
        let alone = guide.accuracy / slowest.max(guide.slowest);
        let mut heights = Heights { range: [0.0, 1.0], near, reach: alone, rows: Vec::new() };
        let weight = product(&self.weight, &[1.0, 1.0]);
        let mut limit = f64::INFINITY;
        for across in axes_across(&chord) {
            let slope = [0, 1].map(|k| dot(&ends[k], &across) / dot(&ends[k], &chord));
            let steepest = slope[0].abs().max(slope[1].abs());
            let size = Scalar::sqrt(1.0 + steepest * steepest);
            let turned = |rows: &[Vec<f64>], along: &[f64]| {
                let mut row = product(&combined(rows, &across), &[1.0, 1.0]);
                for (row, other) in row.iter_mut().zip(product(along, &slope)) {
                    *row -= other;
                }
                row
            };
            let sideways = turned(&self.velocity, &speed).iter().fold(0.0_f64, |most, v| most.max(v.abs()));
            let slack = reach * (sideways / (low * low) + reach * guide.bend * size);
            let bound = guide.accuracy * size + slack + NOISE;
            let row = turned(&self.apart, &ahead);
            for sign in [-1.0, 1.0] {
                let room: Vec<f64> = row.iter().zip(&weight).map(|(g, w)| bound * w + sign * g).collect();
                let [lo, hi] = positive(&room)?;
                heights.range = [heights.range[0].max(lo), heights.range[1].min(hi)];
            }
            heights.near &= slack <= SLACK * guide.accuracy;
            heights.rows.push(row);
            limit = limit.min((1.0 + SLACK) * bound);
        }
        heights.near &= (0..weight.len()).all(|i| {
            let square: f64 = heights.rows.iter().map(|row| row[i] * row[i]).sum();
            square <= limit * limit * weight[i] * weight[i]
        });
        (heights.range[0] <= heights.range[1]).then_some(heights)
    }
}

/// What is known of the distance across the second part.
#[derive(Default)]
struct Heights {
    /// The places between which it can be as small as the accuracy.
    range: [f64; 2],
    /// Whether it is about as small as that everywhere.
    near: bool,
    /// How far the second part goes on beside an end of the interval.
    reach: f64,
    /// Its coefficients, a list for each direction across.
    rows: Vec<Vec<f64>>,
}

impl Heights {
    /// A place at which it is small, and how small it is about there.
    #[inline]
    fn least(&self) -> (f64, f64) {
        if let [row] = &self.rows[..]
            && let (Some(&start), Some(&end)) = (row.first(), row.last())
            && start * end < 0.0
        {
            let (mut row, mut scratch) = (row.clone(), row.clone());
            return (bernstein::bracketed_root(&mut row, &mut scratch), 0.0);
        }
        let square = |x: f64| self.rows.iter().map(|row| bernstein::eval(row, x)).map(|h| h * h).sum::<f64>();
        let best = [0.5, 0.0, 1.0].map(|x| (x, square(x))).into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
        best.map_or((0.5, 0.0), |(x, square)| (x, Scalar::sqrt(square)))
    }
}

/// The places between which a polynomial can be positive, by the convex hull of its coefficients; `None` if nowhere.
#[inline]
fn positive(row: &[f64]) -> Option<[f64; 2]> {
    let last = row.len() - 1;
    let entry = |at: &dyn Fn(usize) -> f64| -> Option<f64> {
        let start = at(0);
        if start.is_nan() || start >= 0.0 {
            return Some(0.0);
        }
        let places = (1..=last).filter(|&j| at(j) > start).map(|j| -start * j as f64 / (at(j) - start));
        let first = places.fold(f64::INFINITY, f64::min) / last as f64;
        (first <= 1.0 + 4.0 * f64::EPSILON).then_some(first)
    };
    let start = entry(&|j| row[j])?;
    let end = 1.0 - entry(&|j| row[last - j])?;
    let slack = 8.0 * f64::EPSILON;
    Some([(start.min(end) - slack).max(0.0), (end.max(start) + slack).min(1.0)])
}

/// The component of vectors of coefficients in a direction.
#[inline]
fn combined(rows: &[Vec<f64>], direction: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; rows.first().map_or(0, Vec::len)];
    for (row, c) in rows.iter().zip(direction) {
        for (sum, x) in sum.iter_mut().zip(row) {
            *sum += c * x;
        }
    }
    sum
}

/// The length of the longest vector of coefficients.
#[inline]
fn largest(rows: &[Vec<f64>]) -> f64 {
    let count = rows.first().map_or(0, Vec::len);
    let square = |i: usize| rows.iter().map(|row| row[i] * row[i]).sum::<f64>();
    Scalar::sqrt((0..count).map(square).fold(0.0, f64::max))
}

#[inline]
fn unit(v: &[f64]) -> Option<Vec<f64>> {
    let length = Scalar::sqrt(dot(v, v));
    (length > 0.0 && length.is_finite()).then(|| v.iter().map(|x| x / length).collect())
}

/// Unit vectors that are orthogonal to a direction and to each other, one less than the dimension.
#[inline]
fn axes_across(chord: &[f64]) -> Vec<Vec<f64>> {
    let dim = chord.len();
    let mut found: Vec<Vec<f64>> = vec![chord.to_vec()];
    // The axis that is nearest to the direction is left out.
    let steepest = (0..dim).max_by(|&i, &j| chord[i].abs().total_cmp(&chord[j].abs())).unwrap_or(0);
    for d in (0..dim).filter(|&d| d != steepest) {
        let mut rest = vec![0.0; dim];
        rest[d] = 1.0;
        for axis in &found {
            let along = dot(&rest, axis);
            rest = difference(&rest, &axis.iter().map(|x| along * x).collect::<Vec<f64>>());
        }
        found.extend(unit(&rest));
    }
    found.split_off(1)
}
