//! The difference of two parts and its derivatives, where straight parts lie beside each other, where parts are one curve,
//! and the places near a pair of parameters at which curves are nearest.

use alloc::vec;
use alloc::vec::Vec;

use crate::CurvePiece;
use crate::geometry::derivative;
use crate::geometry::local::piece_at;
use crate::{Scalar, bernstein};

/// Intervals of two parts outside of which they are farther from each other than a distance, and a place in them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    pub(super) intervals: [[f64; 2]; 2],
    /// Parameters at which the points are near each other.
    pub(super) at: [f64; 2],
    /// How near those of the chords are.
    pub(super) distance: f64,
    /// Whether the parts are as near as the accuracy there, and not only left of a search that has become too long.
    pub(super) decided: bool,
}

/// A part that goes along its chord: no control point is farther from that than a distance, and none lies before the
/// one that comes before it, but for parts that are as short as that.
pub(super) struct Straight<'a> {
    part: &'a CurvePiece,
    ends: [Vec<f64>; 2],
    chord: Vec<f64>,
    /// How far along the chord each control point lies, from 0 to 1; of a short part nothing.
    along: Vec<f64>,
}

impl<'a> Straight<'a> {
    #[inline]
    pub(super) fn of(part: &'a CurvePiece, distance: f64) -> Option<Self> {
        let (dim, last) = (part.dimension(), part.degree());
        let control = |i: usize| (0..dim).map(|d| part.control(i, d)).collect::<Vec<f64>>();
        let ends = [control(0), control(last)];
        let chord = difference(&ends[1], &ends[0]);
        let square = dot(&chord, &chord);
        let (mut along, mut away, mut extent) = (Vec::with_capacity(last + 1), 0.0_f64, 0.0_f64);
        for i in 0..=last {
            let arm = difference(&control(i), &ends[0]);
            let x = if square > 0.0 { dot(&arm, &chord) / square } else { 0.0 };
            along.push(x);
            away = away.max(arm.iter().zip(&chord).map(|(a, c)| (a - x * c) * (a - x * c)).sum());
            extent = extent.max(dot(&arm, &arm));
        }
        let short = extent <= distance * distance;
        let goes_on = square > 0.0 && along.windows(2).all(|pair| pair[0] <= pair[1]);
        if short {
            along.clear();
        } else if !goes_on || away > distance * distance {
            return None;
        }
        Some(Self { part, ends, chord, along })
    }

    /// The places along the chord between which it is not farther from another one than a distance.
    #[inline]
    fn beside(&self, other: &Self, distance: f64) -> Option<[f64; 2]> {
        let [from, to] = [0, 1].map(|k| difference(&self.ends[0], &other.ends[k]));
        let mut found = hull(within(&from, &self.chord, distance), within(&to, &self.chord, distance));
        let square = dot(&other.chord, &other.chord);
        if square > 0.0 {
            // Beside the other chord, and across it.
            let share = [dot(&from, &other.chord) / square, dot(&self.chord, &other.chord) / square];
            let across = |v: &[f64], share: f64| -> Vec<f64> {
                v.iter().zip(&other.chord).map(|(v, c)| v - share * c).collect()
            };
            let strip = within(&across(&from, share[0]), &across(&self.chord, share[1]), distance);
            if let (Some([a, b]), Some([c, d])) = (strip, between_ends(share)) {
                let both = [a.max(c), b.min(d)];
                found = hull(found, (both[0] <= both[1]).then_some(both));
            }
        }
        let [lo, hi] = found.map(|[lo, hi]| [lo.max(0.0), hi.min(1.0)])?;
        (lo <= hi).then_some([lo, hi])
    }

    /// The place of the part, from 0 to 1, at which it is that far along the chord.
    #[inline]
    fn place(&self, along: f64) -> f64 {
        if along <= 0.0 || along >= 1.0 || self.along.is_empty() {
            return along.clamp(0.0, 1.0);
        }
        let weight = |i: usize| self.part.weights().map_or(1.0, |weights| weights[i]);
        let mut values: Vec<f64> =
            self.along.iter().enumerate().map(|(i, x)| weight(i) * (x - along)).collect();
        let mut scratch = values.clone();
        bernstein::bracketed_root(&mut values, &mut scratch)
    }

    /// The parameters of an interval along the chord; of a short part all.
    #[inline]
    fn parameters(&self, [lo, hi]: [f64; 2]) -> [f64; 2] {
        if self.along.is_empty() {
            return self.part.domain();
        }
        // Rounding errors of the zeros.
        let room = 4.0 * f64::EPSILON;
        [(self.place(lo) - room).max(0.0), (self.place(hi) + room).min(1.0)].map(|x| self.part.parameter(x))
    }

    /// The place along this chord that is nearest to one of the other chord, and the distance.
    #[inline]
    fn foot(&self, other: &Self, along: f64) -> (f64, f64) {
        let arm: Vec<f64> = other.ends[0]
            .iter()
            .zip(&other.chord)
            .zip(&self.ends[0])
            .map(|((p, c), q)| p + along * c - q)
            .collect();
        let square = dot(&self.chord, &self.chord);
        let x = if square > 0.0 { (dot(&arm, &self.chord) / square).clamp(0.0, 1.0) } else { 0.0 };
        let away: f64 = arm.iter().zip(&self.chord).map(|(a, c)| (a - x * c) * (a - x * c)).sum();
        (x, Scalar::sqrt(away))
    }
}

/// Where two straight parts are not farther from each other than a distance; `None` if nowhere.
#[inline]
pub(super) fn near(parts: [&Straight<'_>; 2], distance: f64) -> Option<Near> {
    let [a, b] = parts;
    let (first, second) = (a.beside(b, distance)?, b.beside(a, distance)?);
    let mut best = (f64::INFINITY, [0.0; 2]);
    for x in [0.5 * (first[0] + first[1]), first[0], first[1]] {
        let (y, away) = b.foot(a, x);
        if away < best.0 {
            best = (away, [x, y]);
        }
    }
    let intervals = [a.parameters(first), b.parameters(second)];
    let at = [(a, best.1[0]), (b, best.1[1])].map(|(side, along)| side.part.parameter(side.place(along)));
    Some(Near { intervals, at, distance: best.0, decided: true })
}

/// The smallest interval around two.
#[inline]
fn hull(a: Option<[f64; 2]>, b: Option<[f64; 2]>) -> Option<[f64; 2]> {
    match (a, b) {
        (Some(a), Some(b)) => Some([a[0].min(b[0]), a[1].max(b[1])]),
        (a, b) => a.or(b),
    }
}

/// Where `|from + x direction|` is at most a distance.
#[inline]
fn within(from: &[f64], direction: &[f64], distance: f64) -> Option<[f64; 2]> {
    let square = dot(direction, direction);
    let foot = if square > 0.0 { -dot(from, direction) / square } else { 0.0 };
    let away: f64 = from.iter().zip(direction).map(|(f, d)| (f + foot * d) * (f + foot * d)).sum();
    let rest = distance * distance - away;
    if rest.is_nan() || rest < 0.0 {
        return None;
    }
    // A direction that vanishes leads nowhere.
    let reach = Scalar::sqrt(rest / square);
    Some([foot - reach, foot + reach])
}

/// Where `0 <= from + x slope <= 1`.
#[inline]
fn between_ends([from, slope]: [f64; 2]) -> Option<[f64; 2]> {
    if slope == 0.0 {
        return (0.0..=1.0).contains(&from).then_some([f64::NEG_INFINITY, f64::INFINITY]);
    }
    let ends = [-from / slope, (1.0 - from) / slope];
    Some([ends[0].min(ends[1]), ends[0].max(ends[1])])
}

/// The places of two parts between which they are one curve, up to a distance; in the order of the first part. `None` if
/// their control points do not show it.
#[inline]
pub(super) fn alike(a: &CurvePiece, b: &CurvePiece, distance: f64) -> Option<[[f64; 2]; 2]> {
    let mut ends: Vec<[f64; 2]> = Vec::with_capacity(4);
    for end in [0.0, 1.0] {
        ends.extend(foot(b, &values(a, end), distance).map(|y| [end, y]));
        ends.extend(foot(a, &values(b, end), distance).map(|x| [x, end]));
    }
    let first = ends.iter().copied().min_by(|p, q| p[0].total_cmp(&q[0]))?;
    let last = ends.iter().copied().max_by(|p, q| p[0].total_cmp(&q[0]))?;
    let (x, y) = ([first[0], last[0]], [first[1], last[1]]);
    if x[1] - x[0] < 1e-9 || (y[1] - y[0]).abs() < 1e-9 {
        return None;
    }
    let parts = [a.restricted(x[0], x[1]), b.restricted(y[0], y[1])];
    let degree = a.degree().max(b.degree());
    let [one, other] = parts.map(|part| part.elevated_to(degree));
    let weights = [&one, &other].map(|part| part.weights().map(<[f64]>::to_vec));
    if let [Some(v), Some(w)] = &weights {
        let proportional = |(p, q): (&f64, &f64)| (p * w[0] - q * v[0]).abs() <= 0.0625 * distance * p * w[0];
        if !v.iter().zip(w).all(proportional) {
            return None;
        }
    } else if weights.iter().any(Option::is_some) {
        return None;
    }
    let beside = |i: usize| {
        let square: f64 =
            (0..a.dimension()).map(|d| one.control(i, d) - other.control(i, d)).map(|x| x * x).sum();
        square <= distance * distance
    };
    (0..=degree).all(beside).then_some([x, y])
}

/// A place of a part at which it is no farther from a point than a distance, by steps of Gauss and Newton from beside the
/// chord.
#[inline]
fn foot(part: &CurvePiece, point: &[f64], distance: f64) -> Option<f64> {
    let (start, end) = (values(part, 0.0), values(part, 1.0));
    let chord = difference(&end, &start);
    let square = dot(&chord, &chord);
    let mut x = if square > 0.0 { dot(&difference(point, &start), &chord) / square } else { 0.5 };
    for _ in 0..12 {
        x = x.clamp(0.0, 1.0);
        let away = difference(point, &values(part, x));
        if dot(&away, &away) <= distance * distance {
            // One step more, so that nothing is left of the distance along the curve.
            let slope = slopes(part, x);
            let step = dot(&away, &slope) / dot(&slope, &slope);
            return Some(if step.is_finite() { (x + step).clamp(0.0, 1.0) } else { x });
        }
        let slope = slopes(part, x);
        let step = dot(&away, &slope) / dot(&slope, &slope);
        if !step.is_finite() || x + step < -0.5 || x + step > 1.5 {
            return None;
        }
        x += step;
    }
    None
}

/// The place of a part that goes on in one direction at which it is nearest to a point, by steps of Gauss and Newton.
#[inline]
pub(super) fn nearest_inside(part: &CurvePiece, point: &[f64]) -> f64 {
    let (start, end) = (values(part, 0.0), values(part, 1.0));
    let chord = difference(&end, &start);
    let along = dot(&difference(point, &start), &chord) / dot(&chord, &chord);
    let mut x = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.5 };
    for _ in 0..12 {
        let (away, slope) = (difference(point, &values(part, x)), slopes(part, x));
        let next = (x + dot(&away, &slope) / dot(&slope, &slope)).clamp(0.0, 1.0);
        if next.is_nan() || (next - x).abs() <= 2.0 * f64::EPSILON {
            break;
        }
        x = next;
    }
    x
}

#[inline]
pub(super) fn values(part: &CurvePiece, x: f64) -> Vec<f64> {
    (0..part.dimension()).map(|d| part.value(d, x)).collect()
}

/// The derivative of the point at a place.
#[inline]
fn slopes(part: &CurvePiece, x: f64) -> Vec<f64> {
    let slope = |d: usize| {
        let numerator = bernstein::eval(&derivative(part.component(d)), x);
        match part.weights() {
            None => numerator,
            Some(weights) => {
                let bend = bernstein::eval(&derivative(weights), x);
                (numerator - part.value(d, x) * bend) / bernstein::eval(weights, x)
            }
        }
    };
    (0..part.dimension()).map(slope).collect()
}

#[inline]
pub(super) fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

/// The parameters near a pair, in intervals, at which the curves are nearest to each other, by steps of Gauss and Newton;
/// and the distance.
#[inline]
pub(super) fn approach(
    a: &[CurvePiece],
    b: &[CurvePiece],
    start: [f64; 2],
    ends: [[f64; 2]; 2],
) -> ([f64; 2], f64) {
    let distance = |at: [f64; 2]| -> f64 {
        let (p, q) = (point(a, at[0]), point(b, at[1]));
        p.iter().zip(&q).map(|(p, q)| (p - q) * (p - q)).sum()
    };
    let mut at = start;
    for _ in 0..40 {
        let [Some(first), Some(second)] = [(a, at[0]), (b, at[1])].map(|(pieces, t)| piece_at(pieces, t))
        else {
            break;
        };
        let (value, columns) = state(first, second, [first.place(at[0]), second.place(at[1])]);
        let widths = [first, second].map(|part| part.domain()[1] - part.domain()[0]);
        let moved = |steps: [f64; 2]| {
            let mut next = at;
            for (k, t) in next.iter_mut().enumerate() {
                *t = (*t - steps[k] * widths[k]).clamp(ends[k][0], ends[k][1]);
            }
            next
        };
        // Both at once, or where they are parallel, or one of them stands still or ends, one by one.
        let both = pseudo_inverse(&columns).map(|rows| [dot(&rows[0], &value), dot(&rows[1], &value)]);
        let one = |k: usize| {
            let square = dot(&columns[k], &columns[k]);
            if square > 0.0 { dot(&columns[k], &value) / square } else { 0.0 }
        };
        let steps = [both.unwrap_or([0.0; 2]), [one(0), 0.0], [0.0, one(1)]];
        let so_far = distance(at);
        let Some(next) = steps.into_iter().map(moved).find(|&next| distance(next) < so_far) else { break };
        at = next;
    }
    (at, Scalar::sqrt(distance(at)))
}

#[inline]
pub(super) fn point(pieces: &[CurvePiece], t: f64) -> Vec<f64> {
    piece_at(pieces, t).map_or_else(Vec::new, |piece| {
        let x = piece.place(t);
        (0..piece.dimension()).map(|d| piece.value(d, x)).collect()
    })
}

/// `F = A(x) - B(y)` and its derivatives in `x` and in `y`; of rational parts both are multiplied by the weights.
#[inline]
pub(super) fn state(first: &CurvePiece, second: &CurvePiece, at: [f64; 2]) -> (Vec<f64>, [Vec<f64>; 2]) {
    let dim = first.dimension();
    let weight = |part: &CurvePiece, x: f64| match part.weights() {
        None => [1.0, 0.0],
        Some(weights) => [bernstein::eval(weights, x), bernstein::eval(&derivative(weights), x)],
    };
    let ([w, w1], [v, v1]) = (weight(first, at[0]), weight(second, at[1]));
    let mut value = vec![0.0; dim];
    let mut columns = [vec![0.0; dim], vec![0.0; dim]];
    for d in 0..dim {
        let [a, b] = [(first, at[0]), (second, at[1])].map(|(part, x)| {
            let numerator = part.component(d);
            [bernstein::eval(numerator, x), bernstein::eval(&derivative(numerator), x)]
        });
        value[d] = a[0] * v - b[0] * w;
        columns[0][d] = a[1] * v - b[0] * w1;
        columns[1][d] = a[0] * v1 - b[1] * w;
    }
    (value, columns)
}

/// The rows of `(JᵀJ)⁻¹ Jᵀ`; `None` if the columns are parallel, or one is zero.
#[inline]
pub(super) fn pseudo_inverse(columns: &[Vec<f64>; 2]) -> Option<[Vec<f64>; 2]> {
    let [a, b] = columns;
    let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
    let determinant = aa * bb - ab * ab;
    if determinant <= 1e-12 * aa * bb || determinant.is_nan() {
        return None;
    }
    let row = |p: f64, q: f64| a.iter().zip(b).map(|(a, b)| (p * a - q * b) / determinant).collect();
    let other = |p: f64, q: f64| a.iter().zip(b).map(|(a, b)| (p * b - q * a) / determinant).collect();
    Some([row(bb, ab), other(aa, ab)])
}

#[inline]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
