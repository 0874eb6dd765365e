//! The parallel curve of one Bézier piece as cubic segments, with a bound of their distance from it.
//!
//! With `C = X / w`, the velocity `C' = V / w²` and a polynomial `U` that has the direction of `V` and no zero at the ends, the
//! parallel curve is `O = C + d N`, `N` the unit vector across `U` to the left. It is smooth in the parameter also at its cusps.
//! A cubic `Q` has the same points and derivatives at both ends of a part, and with `E = Q - C = A / w`, `A = Q w - X`,
//!
//! - `||E| - |d|| <= max ||A|² - d² w²| / (|d| min w²)`,
//! - the component of `E` along the curve is `A·U / (w |U|)`,
//!
//! so that Bernstein coefficients of `|A|² - d² w²` and `A·U` bound `|Q - O|` at each parameter.

use alloc::vec::Vec;

use super::super::PathSegment;
use crate::bernstein::{self, roots};
use crate::geometry::{derivative, product};
use crate::numeric::binomial::binomial;
use crate::{CurveError, CurvePiece, Scalar};

pub(super) type V = [f64; 2];

pub(super) fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn wedge(a: V, b: V) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// `a + b * factor`
pub(super) fn plus(a: V, b: V, factor: f64) -> V {
    [a[0] + b[0] * factor, a[1] + b[1] * factor]
}

/// The vector a quarter turn to the left.
pub(super) fn left(v: V) -> V {
    [-v[1], v[0]]
}

pub(super) fn length(v: V) -> f64 {
    let largest = v[0].abs().max(v[1].abs());
    let scaled = [v[0] / largest, v[1] / largest];
    if largest > 0.0 { largest * Scalar::sqrt(dot(scaled, scaled)) } else { largest }
}

/// The vector of length 1 in that direction, unless it is zero.
pub(super) fn unit(v: V) -> Option<V> {
    let largest = v[0].abs().max(v[1].abs());
    let scaled = [v[0] / largest, v[1] / largest];
    let length = Scalar::sqrt(dot(scaled, scaled));
    (largest > 0.0 && length.is_finite()).then(|| [scaled[0] / length, scaled[1] / length])
}

/// Where a part of the curve begins or ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// The point of the curve.
    pub(super) base: V,
    /// Its direction.
    pub(super) tangent: V,
}

/// A segment of the parallel curve, or of a join.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub(super) segment: PathSegment<V>,
    /// Whether it runs against the curve, because the distance is larger than the radius of curvature, or connects the sides of
    /// an inner corner: points that are nearer to the curve than the distance.
    pub(super) reversed: bool,
    /// How far it is from the curve, where it is that of no other part.
    pub(super) least: f64,
}

/// The parallel of a stretch of a curve on which the direction is continuous.
pub(super) struct Stretch {
    pub(super) parts: Vec<Part>,
    pub(super) ends: [Place; 2],
}

/// Where the direction turns within less than the tolerance, at a cusp of the curve.
const SHORTEST: f64 = 1e-12;

/// More segments are refused.
const MOST: usize = 1 << 16;

/// What is asked for.
#[derive(Clone, Copy)]
pub(super) struct Parallel {
    pub(super) distance: f64,
    pub(super) tolerance: f64,
    /// Whether the centres of curvature stand in for what is reversed: they lead from one cusp to the next as well, and normals
    /// up to them cover no point backwards.
    pub(super) evolute: bool,
}

impl Parallel {
    /// The stretches of a piece; none if it is a point.
    pub(super) fn of(&self, piece: &CurvePiece) -> Result<Vec<Stretch>, CurveError> {
        // Seen from its start, where its control points are as exact as they can be, in a unit in which no power of a number is
        // too large.
        let origin = [piece.control(0, 0), piece.control(0, 1)];
        let unit = piece.seen_from(&origin, 1.0).largest().max(self.distance.abs());
        if !unit.is_finite() {
            return Err(CurveError::NotFinite);
        }
        let piece = piece.seen_from(&origin, unit);
        let noise = 64.0 * f64::EPSILON * (origin[0].abs().max(origin[1].abs()) / unit + 1.0);
        let limit = (self.tolerance / unit).max(noise);
        let scaled = Self { distance: self.distance / unit, tolerance: limit, ..*self };
        let moved = |p: V| plus(origin, p, unit);
        let mut stretches: Vec<Stretch> = Vec::new();
        let mut broken = true;
        let mut open = Vec::new();
        let mut from = 0.0;
        for x in scaled.cusps(&piece).into_iter().chain([1.0]) {
            open.push([from, x]);
            from = x;
        }
        open.reverse();
        let mut count = 0;
        while let Some([from, to]) = open.pop() {
            let part = piece.restricted(from, to);
            let (excess, found) = scaled.candidate(&part);
            match found {
                Some((segment, ends, reversed)) if excess <= 1.0 => {
                    let ends = ends.map(|end| Place { base: moved(end.base), ..end });
                    let least = self.distance.abs();
                    let whole =
                        |segment: PathSegment<V>| Part { segment: segment.map(moved), reversed, least };
                    count += 1;
                    // A curve that turns back just here, at a zero of its velocity.
                    let turned =
                        stretches.last().is_some_and(|s| dot(s.ends[1].tangent, ends[0].tangent) < 0.0);
                    if broken || turned {
                        stretches.push(Stretch { parts: Vec::new(), ends });
                        broken = false;
                    }
                    if let Some(stretch) = stretches.last_mut() {
                        match scaled.evolute.then(|| centres(&part)).flatten() {
                            Some(lines) if reversed => stretch.parts.extend(lines.into_iter().map(whole)),
                            _ => stretch.parts.push(whole(segment)),
                        }
                        stretch.ends[1] = ends[1];
                    }
                }
                _ => {
                    let short = part.length_bounds()[1] <= 1e-3 * limit;
                    if to - from <= SHORTEST || short && found.is_none() {
                        // A cusp, or a point.
                        broken = true;
                        continue;
                    }
                    if count + open.len() > MOST {
                        return Err(CurveError::TooManyPoints { needed: 2.0 * MOST as f64 });
                    }
                    // The error falls like the fourth power of the length.
                    let pieces = (2..8_usize).find(|&n| (n * n * n * n) as f64 >= excess).unwrap_or(8);
                    let pieces = if found.is_none() { 2 } else { pieces };
                    let at = |i: usize| from + (to - from) * (i as f64 / pieces as f64);
                    for i in (0..pieces).rev() {
                        open.push([at(i), if i + 1 == pieces { to } else { at(i + 1) }]);
                    }
                }
            }
        }
        Ok(stretches)
    }

    /// The cubic segment for a part, the ends of the part, and whether it is reversed; and the quotient of the bound of its error
    /// and the limit. `None` if the direction of the part turns too much to tell.
    #[allow(clippy::type_complexity)] // used once
    fn candidate(&self, part: &CurvePiece) -> (f64, Option<(PathSegment<V>, [Place; 2], bool)>) {
        let d = self.distance;
        let Some(heading) = Heading::of(part) else { return (f64::INFINITY, None) };
        let one = [1.0];
        let weights = part.weights().unwrap_or(&one);
        let [w_min, _] = bernstein::bounds(weights);
        let Some([start, end]) = heading.ends(part, d) else { return (f64::INFINITY, None) };
        let third = 1.0 / 3.0;
        let control = [
            start.point,
            plus(start.point, start.slope, third),
            plus(end.point, end.slope, -third),
            end.point,
        ];
        // A = Q w - X
        let difference = |k: usize| -> Vec<f64> {
            let own: Vec<f64> = control.iter().map(|p| p[k]).collect();
            let raised = part.weights().map_or_else(|| alloc::vec![1.0; part.degree() + 1], <[f64]>::to_vec);
            let mut a = product(&own, &raised);
            for (a, x) in a.iter_mut().zip(product(part.component(k), &[1.0; 4])) {
                *a -= x;
            }
            a
        };
        let a = [difference(0), difference(1)];
        let mut square = product(&a[0], &a[0]);
        for (s, y) in square.iter_mut().zip(product(&a[1], &a[1])) {
            *s += y;
        }
        let largest = |list: &[f64]| {
            list.iter().fold(0.0_f64, |m, &c| if c.abs() > m || c.is_nan() { c.abs() } else { m })
        };
        let farthest = Scalar::sqrt(largest(&square)) / w_min;
        let mut band = square;
        let own = if part.weights().is_some() { product(weights, weights) } else { alloc::vec![1.0] };
        let ones = alloc::vec![1.0; band.len() + 1 - own.len()];
        for (b, w) in band.iter_mut().zip(product(&own, &ones)) {
            *b -= d * d * w;
        }
        let mut along = product(&a[0], &heading.u[0]);
        for (s, y) in along.iter_mut().zip(product(&a[1], &heading.u[1])) {
            *s += y;
        }
        let across = largest(&band) / (d.abs() * w_min * w_min);
        let along = largest(&along) / (w_min * heading.least);
        let size = d.abs();
        let error = if across < 0.5 * size && along < 0.5 * size {
            let rest = across + 2.0 * along * along / size;
            Scalar::sqrt(along * along + rest * rest)
        } else {
            farthest + size
        };
        let middle = heading.slope_at(part, 0.5, d);
        let places = [
            Place { base: start.base, tangent: start.tangent },
            Place { base: end.base, tangent: end.tangent },
        ];
        let segment = PathSegment::trusted(control.to_vec(), Vec::new());
        let excess = if error.is_nan() { f64::INFINITY } else { error / self.tolerance };
        (excess, Some((segment, places, middle < 0.0)))
    }

    /// The places `0 < x < 1` at which the radius of curvature is the distance: zeros of `|V|⁶ - d² w⁶ det(X, X', X'')²`.
    fn cusps(&self, piece: &CurvePiece) -> Vec<f64> {
        let size = piece.largest();
        if piece.degree() < 2 || piece.degree() > 12 || size == 0.0 {
            return Vec::new();
        }
        let piece = piece.seen_from(&[0.0; 2], size);
        let d = self.distance / size;
        let one = alloc::vec![1.0; piece.degree() + 1];
        let rows = [piece.component(0), piece.component(1), piece.weights().unwrap_or(&one)];
        let first = rows.map(derivative);
        let second = [0, 1, 2].map(|k| derivative(&first[k]));
        let minor = |i: usize, j: usize, a: &[Vec<f64>; 3], b: &[Vec<f64>; 3]| {
            subtract(product(&a[i], &b[j]), &product(&a[j], &b[i]))
        };
        let turn = if piece.weights().is_none() {
            minor(0, 1, &first, &second)
        } else {
            let mut turn = product(rows[0], &minor(1, 2, &first, &second));
            for (k, (i, j)) in [(1, (2, 0)), (2, (0, 1))] {
                for (t, x) in turn.iter_mut().zip(product(rows[k], &minor(i, j, &first, &second))) {
                    *t += x;
                }
            }
            turn
        };
        let v = velocity(&piece);
        let speed = add(&product(&v[0], &v[0]), &product(&v[1], &v[1]));
        let left = product(&product(&speed, &speed), &speed);
        let mut right = product(&turn, &turn);
        if let Some(w) = piece.weights() {
            let cube = product(&product(w, w), w);
            right = product(&right, &product(&cube, &cube));
        }
        for c in &mut right {
            *c *= d * d;
        }
        let polynomial = add_signed(&left, &right, -1.0);
        let inner = |x: f64| x > 1e-9 && x < 1.0 - 1e-9;
        let turns_there = |x: f64| bernstein::eval(&turn, x) * d > 0.0;
        roots(&polynomial).into_iter().map(|root| root.x).filter(|&x| inner(x) && turns_there(x)).collect()
    }
}

/// Lines between centres of curvature of a part.
fn centres(part: &CurvePiece) -> Option<Vec<PathSegment<V>>> {
    let heading = Heading::of(part)?;
    let centre = |i: u32| {
        let x = f64::from(i) / 4.0;
        let tangent = unit([0, 1].map(|k| bernstein::eval(&heading.u[k], x)))?;
        let [speed, turn] = heading.speed_and_turn(part, x);
        let centre = plus([part.value(0, x), part.value(1, x)], left(tangent), speed / turn);
        (turn != 0.0 && centre.iter().all(|c| c.is_finite())).then_some(centre)
    };
    let all: Vec<V> = (0..=4).map(centre).collect::<Option<_>>()?;
    Some(all.windows(2).map(|pair| PathSegment::line(pair[0], pair[1])).collect())
}

/// `a - b`, lists of one length.
fn subtract(mut a: Vec<f64>, b: &[f64]) -> Vec<f64> {
    for (a, b) in a.iter_mut().zip(b) {
        *a -= b;
    }
    a
}

fn add(a: &[f64], b: &[f64]) -> Vec<f64> {
    add_signed(a, b, 1.0)
}

/// `a + sign b` as polynomials of the higher degree.
fn add_signed(a: &[f64], b: &[f64], sign: f64) -> Vec<f64> {
    let len = a.len().max(b.len());
    let raised = |list: &[f64]| product(list, &alloc::vec![1.0; len + 1 - list.len()]);
    let mut sum = raised(a);
    for (s, x) in sum.iter_mut().zip(raised(b)) {
        *s += sign * x;
    }
    sum
}

/// The Bernstein coefficients of `V = X' w - X w'`, which has the direction of the velocity.
fn velocity(piece: &CurvePiece) -> [Vec<f64>; 2] {
    [0, 1].map(|k| {
        let own = derivative(piece.component(k));
        match piece.weights() {
            None => own,
            Some(w) => subtract(product(&own, w), &product(piece.component(k), &derivative(w))),
        }
    })
}

/// The direction of a part: the polynomial `U`, which is `V` without its zeros at the ends.
struct Heading {
    u: [Vec<f64>; 2],
    /// How many zeros were taken away, at the start and at the end.
    zeros: [usize; 2],
    /// A lower bound of `|U|`.
    least: f64,
}

/// An end of a part, and the point and the derivative of the parallel curve there.
struct End {
    base: V,
    tangent: V,
    point: V,
    slope: V,
}

impl Heading {
    /// `None` if the direction may turn by a half turn, or if the part is a point.
    fn of(part: &CurvePiece) -> Option<Self> {
        let v = velocity(part);
        let n = v[0].len();
        let size = |i: usize| v[0][i].abs().max(v[1][i].abs());
        let largest = (0..n).map(size).fold(0.0, f64::max);
        if largest.is_nan() || largest <= 0.0 {
            return None;
        }
        let first = (0..n).find(|&i| size(i) > 1e-12 * largest)?;
        let last = (0..n).rfind(|&i| size(i) > 1e-12 * largest)?;
        let (degree, low) = (n - 1, last - first);
        let factor = |i: usize| binomial::<f64>(degree, i) / binomial::<f64>(low, i - first);
        let u = [0, 1].map(|k| (first..=last).map(|i| v[k][i] * factor(i)).collect::<Vec<f64>>());
        let mut middle = [u[0].iter().sum::<f64>(), u[1].iter().sum::<f64>()];
        if low > 0 {
            // Between the directions of the ends, so that these are no farther from it than needed.
            let [a, b] = [0, low].map(|i| unit([u[0][i], u[1][i]]).unwrap_or_default());
            middle = plus(a, b, 1.0);
        }
        let middle = unit(middle)?;
        let least = (0..=low).map(|i| dot([u[0][i], u[1][i]], middle)).fold(f64::INFINITY, f64::min);
        (least > 0.0).then_some(Self { u, zeros: [first, degree - last], least })
    }

    fn ends(&self, part: &CurvePiece, d: f64) -> Option<[End; 2]> {
        let last = self.u[0].len() - 1;
        let n = part.degree();
        let at = |e: usize| {
            let i = if e == 0 { 0 } else { last };
            let u = [self.u[0][i], self.u[1][i]];
            let size = length(u);
            let tangent = unit(u)?;
            let bend = if last == 0 {
                [0.0; 2]
            } else {
                let j = if e == 0 { 0 } else { last - 1 };
                [0, 1].map(|k| (self.u[k][j + 1] - self.u[k][j]) * last as f64)
            };
            let control = if e == 0 { 0 } else { n };
            let base = [part.control(control, 0), part.control(control, 1)];
            let weight = part.weights().map_or(1.0, |w| w[control]);
            // V is U where no zero was taken away, and zero where one was.
            let speed = if self.zeros[e] == 0 { size / (weight * weight) } else { 0.0 };
            let turn = dot(left(tangent), bend) / size;
            Some(End {
                base,
                tangent,
                point: plus(base, left(tangent), d),
                slope: plus([0.0; 2], tangent, speed - d * turn),
            })
        };
        Some([at(0)?, at(1)?])
    }

    /// The speed of the curve at `x`, and how fast its direction turns.
    fn speed_and_turn(&self, part: &CurvePiece, x: f64) -> [f64; 2] {
        let u = [0, 1].map(|k| bernstein::eval(&self.u[k], x));
        let bend = [0, 1].map(|k| {
            let slopes = derivative(&self.u[k]);
            if slopes.is_empty() { 0.0 } else { bernstein::eval(&slopes, x) }
        });
        let weight = part.weights().map_or(1.0, |w| bernstein::eval(w, x));
        let power =
            (0..self.zeros[0]).fold(1.0, |p, _| p * x) * (0..self.zeros[1]).fold(1.0, |p, _| p * (1.0 - x));
        [length(u) * power / (weight * weight), wedge(u, bend) / dot(u, u)]
    }

    /// The speed of the parallel curve along the direction of the curve at `x`.
    fn slope_at(&self, part: &CurvePiece, x: f64, d: f64) -> f64 {
        let [speed, turn] = self.speed_and_turn(part, x);
        // Rounding errors do not make a curve run backwards.
        let slope = speed - d * turn;
        if slope.abs() <= 1e-9 * (speed + (d * turn).abs()) { 0.0 } else { slope }
    }
}
