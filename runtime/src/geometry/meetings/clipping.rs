//! Where two polynomial pieces of low degree cross: Bézier clipping on the stack.
//!
//! Parts `A(x)` and `B(y)` are put aside when their boxes are farther apart than the accuracy. What of one of them lies
//! farther than that from the strip along the chord of the other one is cut off by the convex hull of its distances,
//! whose Bernstein coefficients are those of the control points. When no derivative of the one is parallel to one of the
//! other, `A'(x) × B'(y) ≠ 0` for all control points of both, the parts meet at most once: between two places the chord
//! would be a mean of derivatives of both. Newton's method finds that place; if it is outside of the parts, and the same
//! holds for parts that are extended to it, then there is none inside. In space all this is asked of projections to the
//! plane of both chords, and how far the parts are from each other across it.
//!
//! Parts are always restricted from the whole, so that rounding errors do not add up: the control points of a part are
//! those of a curve nearer to the whole than `noise`, and all tests leave that much room. What is not decided in some
//! dozens of steps, contacts and parts that run along each other, is handed back.

#![allow(clippy::inline_always)] // only then is a step one piece of code: a fifth of the time

use alloc::vec::Vec;

use crate::CurvePiece;
use crate::Scalar;

/// How many pairs of parts are looked at before the rest is handed back.
const WORK: usize = 96;

/// A part that is not shorter than this after a cut is halved.
const SHRUNK: f64 = 0.7;

/// The powers of 1/2, and the inverses of whole numbers.
const MIDDLE: [f64; 8] = [1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015_625, 0.007_812_5];
const INVERSE: [f64; 8] = [1.0, 1.0, 1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0, 1.0 / 5.0, 1.0 / 6.0, 1.0 / 7.0];

/// The components of the control points of a piece.
pub(super) type Net<const N: usize, const D: usize> = [[f64; N]; D];

/// What is known of two pieces, in places between 0 and 1 of both.
#[derive(Default)]
pub(super) struct Outcome {
    /// The places at which they cross.
    pub(super) crossings: Vec<[f64; 2]>,
    /// Intervals in which they are nearer than the accuracy, where one of them ends.
    pub(super) near: Vec<[[f64; 2]; 2]>,
    /// Intervals of which nothing is known.
    pub(super) left: Vec<[[f64; 2]; 2]>,
}

/// A place of both parts some steps away, or on the way to it as far as neither of them ends.
#[inline]
pub(super) fn both_inside(from: [f64; 2], sides: [f64; 2], steps: [f64; 2]) -> [f64; 2] {
    let mut share = 1.0_f64;
    for k in 0..2 {
        let left = if sides[k] > 0.0 { 1.0 - from[k] } else { from[k] };
        if steps[k] > left {
            share = share.min(left / steps[k]);
        }
    }
    core::array::from_fn(|k| (from[k] + share * sides[k] * steps[k]).clamp(0.0, 1.0))
}

/// Extends intervals to a place.
#[inline]
pub(super) fn extend(intervals: &mut [[f64; 2]; 2], to: [f64; 2]) {
    for (interval, x) in intervals.iter_mut().zip(to) {
        *interval = [interval[0].min(x), interval[1].max(x)];
    }
}

/// Extends intervals to the places that are some steps away in one of both parameters.
#[inline]
pub(super) fn extend_alone(intervals: &mut [[f64; 2]; 2], from: [f64; 2], steps: [f64; 2]) {
    for k in 0..2 {
        for step in [steps[k], -steps[k]] {
            let mut aside = from;
            aside[k] = (aside[k] + step).clamp(0.0, 1.0);
            extend(intervals, aside);
        }
    }
}

/// From where, and in which unit, pieces are seen: all components are at most 1 then.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    /// Its first control point is the origin.
    pub(super) first: &'a CurvePiece,
    pub(super) unit: f64,
}

impl View<'_> {
    #[inline]
    pub(super) fn origin(&self, d: usize) -> f64 {
        self.first.control(0, d)
    }

    #[inline]
    pub(super) fn of(&self, piece: &CurvePiece) -> CurvePiece {
        let origin: Vec<f64> = (0..piece.dimension()).map(|d| self.origin(d)).collect();
        piece.seen_from(&origin, self.unit)
    }
}

/// Whether pieces of this kind can be looked at.
#[inline]
pub(super) fn suits(piece: &CurvePiece) -> bool {
    matches!(piece.dimension(), 2 | 3) && piece.degree() < 8 && piece.weights().is_none()
}

/// Where two pieces cross, as far as some steps tell; `accuracy` is measured in the unit of the view, and at least 64 `ε`.
#[inline]
pub(super) fn search(first: &CurvePiece, second: &CurvePiece, view: View<'_>, accuracy: f64) -> Outcome {
    let low = first.degree().max(second.degree()) < 4;
    match (first.dimension(), low) {
        (2, true) => run::<4, 2>(first, second, view, accuracy),
        (2, false) => run::<8, 2>(first, second, view, accuracy),
        (_, true) => run::<4, 3>(first, second, view, accuracy),
        (_, false) => run::<8, 3>(first, second, view, accuracy),
    }
}

#[inline]
fn run<const N: usize, const D: usize>(
    first: &CurvePiece,
    second: &CurvePiece,
    view: View<'_>,
    accuracy: f64,
) -> Outcome {
    let wholes = [first, second].map(|piece| net::<N, D>(piece, view));
    let mut outcome = Outcome::default();
    if are_apart(&wholes[0], &wholes[1], accuracy) {
        return outcome;
    }
    let mut search = Search { wholes, accuracy, outcome: &mut outcome, open: Vec::new() };
    search.run();
    outcome
}

/// The control points of a piece as it is seen, of degree `N - 1`.
#[inline]
pub(super) fn net<const N: usize, const D: usize>(piece: &CurvePiece, view: View<'_>) -> Net<N, D> {
    let mut net = [[0.0; N]; D];
    for (d, row) in net.iter_mut().enumerate() {
        let (component, origin) = (piece.component(d), view.origin(d));
        for (seen, c) in row.iter_mut().zip(component) {
            *seen = (c - origin) / view.unit;
        }
        for degree in component.len()..N {
            row[degree] = row[degree - 1];
            for i in (1..degree).rev() {
                let share = i as f64 / degree as f64;
                row[i] = share * row[i - 1] + (1.0 - share) * row[i];
            }
        }
    }
    net
}

/// A pair of parts: an interval of each piece, and its control points.
#[derive(Clone, Copy)]
struct Pair<const N: usize, const D: usize> {
    ranges: [[f64; 2]; 2],
    nets: [Net<N, D>; 2],
}

struct Search<'a, const N: usize, const D: usize> {
    wholes: [Net<N, D>; 2],
    accuracy: f64,
    outcome: &'a mut Outcome,
    open: Vec<[[f64; 2]; 2]>,
}

/// What a test says of two parts.
enum Answer {
    /// All that there is has been found.
    Done,
    /// Nothing.
    Unknown,
}

impl<const N: usize, const D: usize> Search<'_, N, D> {
    /// A bound of the rounding errors of control points, of which no component is larger than 1.
    const NOISE: f64 = 8.0 * N as f64 * f64::EPSILON;

    #[inline]
    fn run(&mut self) {
        let mut pair = Pair { ranges: [[0.0, 1.0]; 2], nets: self.wholes };
        let mut work = 0;
        loop {
            while self.step(&mut pair) {
                work += 1;
                if work > WORK {
                    self.outcome.left.push(pair.ranges);
                    self.outcome.left.append(&mut self.open);
                    return;
                }
            }
            let Some(ranges) = self.open.pop() else { return };
            pair.ranges = ranges;
            self.restrict(&mut pair, 0);
            self.restrict(&mut pair, 1);
        }
    }

    /// Brings the control points of one part in line with its interval.
    #[inline]
    fn restrict(&self, pair: &mut Pair<N, D>, k: usize) {
        pair.nets[k] = self.wholes[k];
        restrict(&mut pair.nets[k], pair.ranges[k]);
    }

    /// Makes a pair smaller, `false` if nothing is left of it; another part of it may be open.
    #[inline]
    fn step(&mut self, pair: &mut Pair<N, D>) -> bool {
        let apart = self.accuracy + 2.0 * Self::NOISE;
        let [a, b] = &pair.nets;
        if are_apart(a, b, apart) {
            return false;
        }
        let plane = Plane::of(a, b);
        if plane.is_between(a, b, apart) {
            return false;
        }
        let flat = [plane.image(a), plane.image(b)];
        if let Answer::Done = self.only_one(pair.ranges, &plane, &flat) {
            return false;
        }
        let Some(first) = clipped(&flat[1], &flat[0], apart + 2.0 * Self::NOISE) else { return false };
        let Some(second) = clipped(&flat[0], &flat[1], apart + 2.0 * Self::NOISE) else { return false };
        let mut shrunk = false;
        for (k, part) in [first, second].into_iter().enumerate() {
            if part[1] - part[0] < SHRUNK {
                shrunk = true;
                pair.ranges[k] = within(pair.ranges[k], part);
                self.restrict(pair, k);
            }
        }
        if !shrunk {
            let k = usize::from(extent(&flat[1]) > extent(&flat[0]));
            let [lo, hi] = pair.ranges[k];
            let middle = 0.5 * (lo + hi);
            if hi - lo < 1e-12 {
                self.outcome.left.push(pair.ranges);
                return false;
            }
            let mut other = pair.ranges;
            (other[k], pair.ranges[k]) = ([middle, hi], [lo, middle]);
            self.open.push(other);
            self.restrict(pair, k);
        }
        true
    }

    /// Finds the only place at which parts can meet, if there is no more than one.
    #[inline]
    fn only_one(&mut self, ranges: [[f64; 2]; 2], plane: &Plane<D>, [a, b]: &[Net<N, 2>; 2]) -> Answer {
        if !are_across(a, b, 4.0 * Self::NOISE) {
            return Answer::Unknown;
        }
        // Where the chords meet.
        let chords = [a, b].map(|net| [net[0][N - 1] - net[0][0], net[1][N - 1] - net[1][0]]);
        let between = [b[0][0] - a[0][0], b[1][0] - a[1][0]];
        let determinant = cross(chords[0], chords[1]);
        let places = [cross(between, chords[1]) / determinant, cross(between, chords[0]) / determinant];
        if !((-0.5..=1.5).contains(&places[0]) && (-0.5..=1.5).contains(&places[1])) {
            return Answer::Unknown;
        }
        let mut at = [0.0; 2];
        for (k, at) in at.iter_mut().enumerate() {
            *at = ranges[k][0] + places[k] * (ranges[k][1] - ranges[k][0]);
        }
        let Some(found) = self.newton(plane, &mut at) else { return Answer::Unknown };
        let outside = |k: usize, by: f64| at[k] < ranges[k][0] - by || at[k] > ranges[k][1] + by;
        let [aside, near] = [Self::NOISE, self.accuracy]
            .map(|by| (0..2).any(|k| outside(k, by * found.reach[k] + 4.0 * f64::EPSILON)));
        if aside {
            // The parts, extended to that place.
            let mut wider = ranges;
            for (range, at) in wider.iter_mut().zip(at) {
                let room = 0.25 * (range[1] - range[0]);
                if at < range[0] - room || at > range[1] + room {
                    return Answer::Unknown;
                }
                *range = [range[0].min(at), range[1].max(at)];
            }
            let mut nets = self.wholes;
            restrict(&mut nets[0], wider[0]);
            restrict(&mut nets[1], wider[1]);
            if !are_across(&plane.image(&nets[0]), &plane.image(&nets[1]), 80.0 * Self::NOISE) {
                return Answer::Unknown;
            }
            if !near && !self.add_end(at, found.reach) {
                return Answer::Unknown;
            }
            return Answer::Done;
        }
        if found.gap > 4.0 * Self::NOISE {
            // In space the projections cross, the curves do not; how near they come elsewhere depends on their slopes across
            // the plane. Shorter parts are apart, or as near as that.
            return Answer::Unknown;
        }
        self.outcome.crossings.push(at.map(|x| x.clamp(0.0, 1.0)));
        Answer::Done
    }

    /// Adds the place at which a piece ends before it meets the other one, not farther from it than the accuracy. Not if
    /// they are almost parallel there, and bend away from each other before they are as far apart as slopes say.
    #[inline]
    fn add_end(&mut self, at: [f64; 2], reach: [f64; 2]) -> bool {
        if at.iter().all(|x| (0.0..=1.0).contains(x)) {
            // It belongs to the part on the other side.
            return true;
        }
        let end = at.map(|x| x.clamp(0.0, 1.0));
        let k = usize::from((at[1] - end[1]).abs() * reach[0] > (at[0] - end[0]).abs() * reach[1]);
        let (values, slopes) = (self.values(end), self.slopes(end));
        let (square, along) = (0..D).fold((0.0, 0.0), |(square, along), d| {
            let slope = slopes[1 - k][d];
            (square + slope * slope, along + slope * (values[k][d] - values[1 - k][d]))
        });
        let mut foot = end;
        foot[1 - k] = (foot[1 - k] + along / square).clamp(0.0, 1.0);
        if self.square_distance(foot) > self.accuracy * self.accuracy {
            return true;
        }
        let opposed = (0..D).map(|d| slopes[0][d] * slopes[1][d]).sum::<f64>() < 0.0;
        let mut around = foot.map(|x| [x, x]);
        for side in [1.0, -1.0] {
            let second = if opposed { -side } else { side };
            let aside = both_inside(foot, [side, second], reach.map(|reach| self.accuracy * reach));
            if self.square_distance(aside) > 6.25 * self.accuracy * self.accuracy {
                return false;
            }
            extend(&mut around, aside);
        }
        // Where one ends, the other one goes on alone.
        let squares = slopes.map(|slope| slope.iter().map(|x| x * x).sum::<f64>());
        extend_alone(&mut around, foot, squares.map(|square| self.accuracy / Scalar::sqrt(square)));
        self.outcome.near.push(around);
        true
    }

    #[inline]
    fn square_distance(&self, at: [f64; 2]) -> f64 {
        let values = self.values(at);
        (0..D).fold(0.0, |sum, d| {
            let apart = values[0][d] - values[1][d];
            sum + apart * apart
        })
    }

    #[inline]
    fn values(&self, at: [f64; 2]) -> [[f64; D]; 2] {
        [0, 1].map(|k| core::array::from_fn(|d| value_and_slope(&self.wholes[k][d], at[k])[0]))
    }

    #[inline]
    fn slopes(&self, at: [f64; 2]) -> [[f64; D]; 2] {
        [0, 1].map(|k| core::array::from_fn(|d| value_and_slope(&self.wholes[k][d], at[k])[1]))
    }

    /// Goes to the place at which the images of both pieces meet; `None` if it is not reached, or rounding errors move it
    /// so far that it may be a contact.
    #[inline]
    fn newton(&self, plane: &Plane<D>, at: &mut [f64; 2]) -> Option<Place> {
        for _ in 0..12 {
            let mut difference = [0.0; D];
            let mut slopes = [[0.0; D]; 2];
            for d in 0..D {
                let a = value_and_slope(&self.wholes[0][d], at[0]);
                let b = value_and_slope(&self.wholes[1][d], at[1]);
                difference[d] = a[0] - b[0];
                (slopes[0][d], slopes[1][d]) = (a[1], b[1]);
            }
            let (f, a, b) = (plane.vector(difference), plane.vector(slopes[0]), plane.vector(slopes[1]));
            let determinant = cross(a, b);
            let step = [-cross(f, b) / determinant, cross(a, f) / determinant];
            *at = [at[0] + step[0], at[1] + step[1]];
            if !(at[0].abs() < 4.0 && at[1].abs() < 4.0) {
                return None;
            }
            // What is left is of the order of its square, of which the noise is larger.
            if step[0].abs() < 5e-9 && step[1].abs() < 5e-9 {
                let sizes = [a[0].abs() + a[1].abs(), b[0].abs() + b[1].abs()];
                let reach = [sizes[1] / determinant.abs(), sizes[0] / determinant.abs()];
                let noise = Self::NOISE;
                // Next to a contact rounding errors look like crossings, some roots of them apart.
                if noise * reach[0].max(reach[1]) * sizes[0].max(sizes[1]) > 0.1 * Scalar::sqrt(noise) {
                    return None;
                }
                let mut gap = 0.0_f64;
                for d in 0..D {
                    gap = gap.max((difference[d] + slopes[0][d] * step[0] - slopes[1][d] * step[1]).abs());
                }
                return Some(Place { reach, gap });
            }
        }
        None
    }
}

/// What Newton's method says of a place.
struct Place {
    /// How far each parameter moves when a point does by 1.
    reach: [f64; 2],
    /// The distance of both points, the largest component.
    gap: f64,
}

/// Orthogonal unit vectors that span the plane of two chords, and the one across it; in the plane the axes.
struct Plane<const D: usize> {
    axes: [[f64; D]; 3],
}

impl<const D: usize> Plane<D> {
    #[inline]
    fn of<const N: usize>(a: &Net<N, D>, b: &Net<N, D>) -> Self {
        let mut axes = [[0.0; D]; 3];
        if D < 3 {
            (axes[0][0], axes[1][1]) = (1.0, 1.0);
            return Self { axes };
        }
        let chord = |net: &Net<N, D>| [0, 1, 2].map(|d| net[d][N - 1] - net[d][0]);
        let middle = [0, 1, 2].map(|d| b[d][N / 2] - a[d][N / 2]);
        // Those that are not linearly independent are replaced; every plane will do.
        let candidates = [chord(a), chord(b), middle, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mut found = [[0.0; 3]; 2];
        let mut count = 0;
        for candidate in candidates {
            let mut rest = candidate;
            for axis in &found[..count] {
                let along = dot(rest, *axis);
                rest = [0, 1, 2].map(|d| rest[d] - along * axis[d]);
            }
            let (square, whole) = (dot(rest, rest), dot(candidate, candidate));
            if square > 1e-6 * whole && square > f64::MIN_POSITIVE {
                let length = Scalar::sqrt(square);
                found[count] = rest.map(|x| x / length);
                count += 1;
                if count == 2 {
                    break;
                }
            }
        }
        let [u, v] = found;
        let across = crate::vector::cross(u, v);
        for (axis, vector) in axes.iter_mut().zip([u, v, across]) {
            axis.copy_from_slice(&vector[..D]);
        }
        Self { axes }
    }

    /// Both components of a vector in the plane.
    #[inline]
    fn vector(&self, v: [f64; D]) -> [f64; 2] {
        if D == 2 {
            return [v[0], v[1]];
        }
        let mut image = [0.0; 2];
        for (image, axis) in image.iter_mut().zip(&self.axes) {
            for d in 0..D {
                *image += axis[d] * v[d];
            }
        }
        image
    }

    /// The control points along an axis.
    #[inline]
    fn along<const N: usize>(&self, k: usize, net: &Net<N, D>) -> [f64; N] {
        let mut image = [0.0; N];
        for (axis, row) in self.axes[k].iter().zip(net) {
            for (image, c) in image.iter_mut().zip(row) {
                *image += axis * c;
            }
        }
        image
    }

    #[inline]
    fn image<const N: usize>(&self, net: &Net<N, D>) -> Net<N, 2> {
        if D == 2 { [net[0], net[1]] } else { [self.along(0, net), self.along(1, net)] }
    }

    /// Whether parts in space are farther apart than a distance across the plane.
    #[inline]
    fn is_between<const N: usize>(&self, a: &Net<N, D>, b: &Net<N, D>, distance: f64) -> bool {
        if D == 2 {
            return false;
        }
        let ([a, b], [c, d]) = (range(&self.along(2, a)), range(&self.along(2, b)));
        (a - d).max(c - b) > distance
    }
}

/// Replaces the control points by those of a part, by de Casteljau's algorithm.
#[inline(always)]
pub(super) fn restrict<const N: usize, const D: usize>(net: &mut Net<N, D>, [from, to]: [f64; 2]) {
    // The longer part comes first, so that the quotient is one of numbers that are not small.
    if to >= 1.0 - from {
        if to != 1.0 {
            keep_left(net, to);
        }
        if from != 0.0 {
            keep_right(net, from / to);
        }
    } else {
        if from != 0.0 {
            keep_right(net, from);
        }
        keep_left(net, (to - from) / (1.0 - from));
    }
}

#[inline]
fn keep_left<const N: usize, const D: usize>(net: &mut Net<N, D>, x: f64) {
    for row in net {
        for step in 1..N {
            for i in (step..N).rev() {
                row[i] = (1.0 - x) * row[i - 1] + x * row[i];
            }
        }
    }
}

#[inline]
fn keep_right<const N: usize, const D: usize>(net: &mut Net<N, D>, x: f64) {
    for row in net {
        for step in 1..N {
            for i in 0..N - step {
                row[i] = (1.0 - x) * row[i] + x * row[i + 1];
            }
        }
    }
}

/// A polynomial and its derivative.
#[inline(always)]
pub(super) fn value_and_slope<const N: usize>(row: &[f64; N], x: f64) -> [f64; 2] {
    let mut row = *row;
    for last in (2..N).rev() {
        for i in 0..last {
            row[i] = (1.0 - x) * row[i] + x * row[i + 1];
        }
    }
    [(1.0 - x) * row[0] + x * row[1], (N - 1) as f64 * (row[1] - row[0])]
}

#[inline(always)]
pub(super) fn range<const N: usize>(row: &[f64; N]) -> [f64; 2] {
    let (mut lo, mut hi) = (row[0], row[0]);
    for &c in &row[1..] {
        lo = if c < lo { c } else { lo };
        hi = if c > hi { c } else { hi };
    }
    [lo, hi]
}

/// Whether the boxes of parts are farther apart than a distance.
#[inline(always)]
fn are_apart<const N: usize, const D: usize>(a: &Net<N, D>, b: &Net<N, D>, distance: f64) -> bool {
    for d in 0..D {
        let ([a, b], [c, d]) = (range(&a[d]), range(&b[d]));
        if a - d > distance || c - b > distance {
            return true;
        }
    }
    false
}

/// Whether no derivative of the one part is parallel to one of the other; their control points are known up to `noise`.
#[inline(always)]
fn are_across<const N: usize>(a: &Net<N, 2>, b: &Net<N, 2>, noise: f64) -> bool {
    let (mut lo, mut hi) = (f64::INFINITY, f64::NEG_INFINITY);
    for i in 1..N {
        let [x, y] = [a[0][i] - a[0][i - 1], a[1][i] - a[1][i - 1]];
        for j in 1..N {
            let c = x * (b[1][j] - b[1][j - 1]) - y * (b[0][j] - b[0][j - 1]);
            lo = if c < lo { c } else { lo };
            hi = if c > hi { c } else { hi };
        }
        if lo < 0.0 && hi > 0.0 {
            return false;
        }
    }
    let size = extent(a) + extent(b);
    lo > noise * size || hi < -noise * size
}

/// The part of a curve, between two places, outside of which it is farther than a distance from the strip along the chord
/// of another one; `None` if that is all of it.
#[inline(always)]
fn clipped<const N: usize>(other: &Net<N, 2>, curve: &Net<N, 2>, distance: f64) -> Option<[f64; 2]> {
    let mut along = [other[0][N - 1] - other[0][0], other[1][N - 1] - other[1][0]];
    let middle = [other[0][N / 2] - other[0][0], other[1][N / 2] - other[1][0]];
    let closed = along[0].abs() + along[1].abs() < 0.01 * (middle[0].abs() + middle[1].abs());
    if closed {
        // Any direction bounds a strip.
        along = middle;
    }
    let heights = |net: &Net<N, 2>| {
        let mut heights = [0.0; N];
        for i in 0..N {
            heights[i] = along[0] * (net[1][i] - other[1][0]) - along[1] * (net[0][i] - other[0][0]);
        }
        heights
    };
    let room = distance * (along[0].abs() + along[1].abs());
    let [mut lo, mut hi] = range(&heights(other));
    if !closed {
        // Both ends are on the chord, and the functions between them add up to no more than 1 - 2^(1-n); two of degree
        // 3 with different signs to no more than 4/9 each.
        let most = if N == 4 && lo < 0.0 && hi > 0.0 { 4.0 / 9.0 } else { 1.0 - MIDDLE[N - 2] };
        (lo, hi) = (lo * most, hi * most);
    }
    let (lo, hi) = (lo - room, hi + room);
    let mut heights = heights(curve);
    let start = entry(&heights, lo, hi)?;
    heights.reverse();
    let end = 1.0 - entry(&heights, lo, hi)?;
    let slack = 8.0 * f64::EPSILON;
    Some([(start.min(end) - slack).max(0.0), (end.max(start) + slack).min(1.0)])
}

/// A place before which the convex hull of coefficients does not reach a range, by the steepest line from the first of
/// them to another one; `None` if it nowhere does.
#[inline(always)]
fn entry<const N: usize>(heights: &[f64; N], lo: f64, hi: f64) -> Option<f64> {
    let (above, below) = (heights[0] - hi, lo - heights[0]);
    let away = if above > below { above } else { below };
    if away.is_nan() || away <= 0.0 {
        return Some(0.0);
    }
    // The steepest slopes down and up.
    let (mut down, mut up) = (0.0, 0.0);
    for j in 1..N {
        let slope = (heights[j] - heights[0]) * INVERSE[j];
        down = if slope < down { slope } else { down };
        up = if slope > up { slope } else { up };
    }
    let steepest = if above > below { -down } else { up };
    let first = away / steepest;
    // With a slope of zero infinite.
    (first <= (N - 1) as f64 * (1.0 + 4.0 * f64::EPSILON)).then(|| first * INVERSE[N - 1])
}

/// How long the sides of the box are, together.
#[inline]
fn extent<const N: usize>(net: &Net<N, 2>) -> f64 {
    let ([a, b], [c, d]) = (range(&net[0]), range(&net[1]));
    b - a + (d - c)
}

/// The part of an interval.
#[inline]
fn within([lo, hi]: [f64; 2], part: [f64; 2]) -> [f64; 2] {
    [lo + part[0] * (hi - lo), if part[1] == 1.0 { hi } else { lo + part[1] * (hi - lo) }]
}

#[inline]
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[inline]
fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
