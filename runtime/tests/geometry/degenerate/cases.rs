//! Random and degenerate curves, with what is known of where they meet.

use crate::random::Random;

/// A rational Bézier curve over 0 ≤ t ≤ 1: points, and weights.
pub type Points<const D: usize> = (Vec<[f64; D]>, Vec<f64>);

/// How two curves meet at a place at which they were made to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Made {
    /// They have a point in common.
    Meet,
    /// This number of their derivatives are those of one curve in two parametrisations.
    Touch(u32),
}

/// Two curves, or one and itself.
#[derive(Debug)]
pub struct Case<const D: usize> {
    pub curves: [Points<D>; 2],
    /// Parameters at which they meet.
    pub places: Vec<([f64; 2], Made)>,
    /// Intervals, in their own directions, between whose ends they are one curve.
    pub overlap: Option<[[f64; 2]; 2]>,
    /// Whether the curves are made to run along each other, perhaps there and back.
    pub along: bool,
}

pub const KINDS: usize = 19;

pub fn random_curve<const D: usize>(random: &mut Random, degree: usize, whole: bool) -> Points<D> {
    let mut coordinate =
        || -> f64 { if whole { random.below(7) as f64 - 3.0 } else { random.between(-1.0, 1.0) } };
    let points = (0..=degree).map(|_| [(); D].map(|()| coordinate())).collect();
    (points, vec![1.0; degree + 1])
}

/// The point at a parameter.
pub fn value<const D: usize>((points, weights): &Points<D>, t: f64) -> [f64; D] {
    let mut sum = ([0.0; D], 0.0);
    let (mut power, mut binomial) = (1.0, 1.0);
    let degree = points.len() - 1;
    for (k, (point, weight)) in points.iter().zip(weights).enumerate() {
        let factor = binomial * power * weight;
        let part = (point.map(|x| factor * x), factor);
        let rest = if k == 0 { 0.0 } else { 1.0 - t };
        sum = (core::array::from_fn(|d| rest * sum.0[d] + part.0[d]), rest * sum.1 + part.1);
        power *= t;
        binomial *= (degree - k) as f64 / (k + 1) as f64;
    }
    sum.0.map(|x| x / sum.1)
}

/// The part of a polynomial curve between two parameters, by its polar form.
fn part<const D: usize>((points, _): &Points<D>, from: f64, to: f64) -> Points<D> {
    let degree = points.len() - 1;
    let point = |k: usize| {
        let mut row = points.clone();
        for step in 0..degree {
            let t = if step < k { to } else { from };
            row = row
                .windows(2)
                .map(|pair| core::array::from_fn(|d| (1.0 - t) * pair[0][d] + t * pair[1][d]))
                .collect();
        }
        row[0]
    };
    ((0..=degree).map(point).collect(), vec![1.0; degree + 1])
}

/// Polynomials with coefficients that are small multiples of powers of two, so that nothing here is rounded.
type Power<const D: usize> = Vec<[f64; D]>;

fn added<const D: usize>(a: [f64; D], b: [f64; D], factor: f64) -> [f64; D] {
    core::array::from_fn(|d| a[d] + factor * b[d])
}

fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            sum[i + j] += x * y;
        }
    }
    sum
}

/// `Σ c[k] f^k`.
fn composed<const D: usize>(outer: &Power<D>, inner: &[f64]) -> Power<D> {
    let mut sum = vec![[0.0; D]; (outer.len() - 1) * (inner.len() - 1) + 1];
    let mut power = vec![1.0];
    for &c in outer {
        for (sum, p) in sum.iter_mut().zip(&power) {
            *sum = added(*sum, c, *p);
        }
        power = product(&power, inner);
    }
    sum
}

/// The Bézier points of a polynomial, sixty times as large up to degree 6: whole numbers if the coefficients are.
fn bezier<const D: usize>(power: &Power<D>) -> Points<D> {
    let degree = power.len() - 1;
    let binomial = |n: usize, k: usize| (0..k).fold(1.0, |b, i| b * (n - i) as f64 / (i + 1) as f64);
    let point = |i: usize| {
        (0..=i).fold([0.0; D], |sum, k| added(sum, power[k], 60.0 * binomial(i, k) / binomial(degree, k)))
    };
    ((0..=degree).map(point).collect(), vec![1.0; degree + 1])
}

/// Not zero.
fn whole_vector<const D: usize>(random: &mut Random) -> [f64; D] {
    loop {
        let vector = [(); D].map(|()| random.below(9) as f64 - 4.0);
        if vector != [0.0; D] {
            return vector;
        }
    }
}

/// A polynomial of this degree about a place.
fn whole_power<const D: usize>(random: &mut Random, degree: usize) -> Power<D> {
    (0..=degree).map(|_| whole_vector(random)).collect()
}

fn eighth(random: &mut Random) -> f64 {
    random.below(9) as f64 / 8.0
}

/// A factor of a parametrisation.
fn stretch(random: &mut Random) -> f64 {
    [-2.0, -1.0, -0.5, 0.5, 1.0, 2.0][random.below(6)]
}

fn case<const D: usize>(a: Points<D>, b: Points<D>, places: Vec<([f64; 2], Made)>) -> Case<D> {
    Case { curves: [a, b], places, overlap: None, along: false }
}

fn moved<const D: usize>(curve: &mut Points<D>, from: [f64; D], to: [f64; D]) {
    for p in &mut curve.0 {
        *p = core::array::from_fn(|d| p[d] - from[d] + to[d]);
    }
}

/// Two curves of a kind, of about the size 1.
pub fn pair<const D: usize>(random: &mut Random, kind: usize) -> Case<D> {
    let mut case = if kind < 11 { rounded(random, kind) } else { exact(random, kind) };
    let largest = case.curves.iter().flat_map(|c| c.0.iter().flatten()).fold(0.0_f64, |a, x| a.max(x.abs()));
    let unit = 2.0_f64.powi(largest.max(1e-300).log2().ceil() as i32);
    case.along = matches!(kind, 6..=8 | 16 | 17);
    for p in case.curves.iter_mut().flat_map(|c| c.0.iter_mut().flatten()) {
        *p /= unit;
    }
    case
}

/// Kinds whose coordinates are rounded, so that the curves meet up to rounding errors.
fn rounded<const D: usize>(random: &mut Random, kind: usize) -> Case<D> {
    let degrees = [0, 1].map(|_| {
        let most = if random.below(8) == 0 { 7 } else { 3 };
        1 + random.below(most)
    });
    let [mut a, mut b] = degrees.map(|degree| random_curve::<D>(random, degree, kind == 1));
    let (s, t): (f64, f64) = (random.unit(), random.unit());
    let meeting = |a: Points<D>, mut b: Points<D>, at: [f64; 2]| {
        let (p, q) = (value(&a, at[0]), value(&b, at[1]));
        moved(&mut b, q, p);
        case(a, b, vec![(at, Made::Meet)])
    };
    match kind {
        // In space curves meet only if they are made to.
        0 | 1 if D == 3 => meeting(a, b, [s, t]),
        2 => {
            for curve in [&mut a, &mut b] {
                let n = curve.0.len();
                match random.below(4) {
                    0 => curve.0[1] = curve.0[0],
                    1 => curve.0[n - 2] = curve.0[n - 1],
                    2 => curve.0 = vec![curve.0[0]; n],
                    _ => {}
                }
            }
            meeting(a, b, [s, t])
        }
        3 => meeting(a, b, [0.0, 1.0]),
        4 => meeting(a, b, [s, 0.0]),
        // They touch at the beginning of the second one.
        5 => {
            let (p, q) = (value(&a, s), value(&a, s + 1e-3));
            let length: f64 = random.between(-300.0, 300.0);
            b.0[0] = p;
            b.0[1] = core::array::from_fn(|d| p[d] + length * (q[d] - p[d]));
            case(a, b, vec![([s, 0.0], Made::Meet)])
        }
        6 => {
            let [from, to]: [f64; 2] = [0, 1].map(|_| random.between(-0.5, 1.5));
            b = part(&a, from, to);
            Case { overlap: common(from, to), ..case(a, b, Vec::new()) }
        }
        7 => {
            let whole = random.below(2) == 0;
            let line = random_curve::<D>(random, 1, whole);
            let ends: [f64; 2] = [0, 1].map(|_| random.between(-1.0, 2.0));
            b = part(&line, ends[0], ends[1]);
            Case { overlap: common(ends[0], ends[1]), ..case(line, b, Vec::new()) }
        }
        8 => Case { overlap: Some([[0.0, 1.0]; 2]), ..case(a.clone(), a, Vec::new()) },
        9 => {
            for curve in [&mut a, &mut b] {
                curve.1 = curve.0.iter().map(|_| random.between(0.2, 4.0)).collect();
            }
            if random.below(2) == 0 { meeting(a, b, [s, t]) } else { case(a, b, Vec::new()) }
        }
        10 => {
            for curve in [&mut a, &mut b] {
                let n = curve.0.len();
                curve.0[n - 1] = curve.0[0];
            }
            meeting(a, b, [s, t])
        }
        _ => case(a, b, Vec::new()),
    }
}

/// Where a curve and its part from one parameter to another are one, if they are longer than a point.
fn common(from: f64, to: f64) -> Option<[[f64; 2]; 2]> {
    let first = [from.min(to).max(0.0), from.max(to).min(1.0)];
    let mut second = first.map(|s| (s - from) / (to - from));
    if from > to {
        second.reverse();
    }
    (first[1] > first[0]).then_some([first, second])
}

/// Kinds of whole numbers: what they have in common they have exactly.
fn exact<const D: usize>(random: &mut Random, kind: usize) -> Case<D> {
    let degree = 1 + random.below(4);
    let (s, t) = (eighth(random), eighth(random));
    let mut a = whole_power::<D>(random, degree);
    let about = |power: &Power<D>, s: f64| bezier(&composed(power, &[-s, 1.0]));
    let along = |a: &Power<D>, order: usize, factor: f64| -> Power<D> {
        (0..=order)
            .map(|k| a.get(k).map_or([0.0; D], |c| c.map(|x| x * factor.powi(k as i32))))
            .collect::<Vec<_>>()
    };
    match kind {
        // A contact of this order, inside or at ends.
        11 | 12 => {
            let order = 1 + random.below(if kind == 11 { 1 } else { 3 });
            let mut b = along(&a, order, stretch(random));
            b.push(whole_vector(random));
            if random.below(2) == 0 {
                b.push(whole_vector(random));
            }
            case(about(&a, s), about(&b, t), vec![([s, t], Made::Touch(order as u32))])
        }
        // A line along a tangent.
        13 => {
            let b = along(&a, 1, stretch(random));
            case(about(&a, s), about(&b, t), vec![([s, t], Made::Touch(1))])
        }
        // A cusp, at which the other curve has any direction, that of the cusp, or a cusp as well.
        14 | 15 => {
            let mut a = whole_power::<D>(random, 3);
            a[1] = [0.0; D];
            let degree = 1 + random.below(3);
            let mut b = whole_power::<D>(random, degree);
            b[0] = a[0];
            match random.below(4) {
                0 if b.len() > 2 => b[1] = [0.0; D],
                1 => b[1] = a[2],
                2 if b.len() > 2 => (b[1], b[2]) = ([0.0; D], a[2]),
                _ => {}
            }
            let (s, t) = if kind == 14 { (s, t) } else { (0.0, [0.0, 1.0][random.below(2)]) };
            case(about(&a, s), about(&b, t), vec![([s, t], Made::Meet)])
        }
        // One curve in two parametrisations, the other one of twice the degree; it may turn round.
        16 => {
            a.truncate(4);
            let quadratic = [eighth(random), stretch(random), 0.25 * stretch(random)];
            let b = composed(&a, &quadratic);
            let phi = |t: f64| quadratic[0] + t * (quadratic[1] + t * quadratic[2]);
            let places = (0..=8)
                .map(|k| 0.125 * f64::from(k))
                .map(|t| [phi(t), t])
                .filter(|at| (0.0..=1.0).contains(&at[0]))
                .map(|at| (at, Made::Meet));
            case(bezier(&a), bezier(&b), places.collect())
        }
        // Straight cubics, which may turn round, on one line or across each other.
        17 => {
            let [p, v, w]: [[f64; D]; 3] = [(); 3].map(|()| whole_vector(random));
            let mut straight = |v: [f64; D]| {
                let f = [(); 4].map(|()| random.below(9) as f64 - 4.0);
                let points = f.map(|x| added(p, v, x)).to_vec();
                (points, vec![1.0; 4])
            };
            let (a, b) = (straight(v), straight(v));
            let c = straight(w);
            if random.below(2) == 0 { case(a, b, Vec::new()) } else { case(a, c, Vec::new()) }
        }
        // Almost a contact.
        _ => {
            let mut b = along(&a, 1, stretch(random));
            b.push(whole_vector(random));
            let away = 2.0_f64.powi(-3 - random.below(45) as i32);
            let aside: [f64; D] = whole_vector(random);
            b[0] = added(b[0], aside, away);
            case(about(&a, s), about(&b, t), Vec::new())
        }
    }
}

pub const OWN_KINDS: usize = 7;

/// A curve that meets itself, of about the size 1, and the parameters at which it is known to.
pub fn own<const D: usize>(random: &mut Random, kind: usize) -> Case<D> {
    let (mut s, mut t) = (eighth(random), eighth(random));
    if s == t {
        (s, t) = (0.25, 0.75);
    }
    let [s, t] = [s.min(t), s.max(t)];
    let node = product(&[-s, 1.0], &[-t, 1.0]);
    let scaled = |f: &[f64], v: [f64; D]| -> Power<D> { f.iter().map(|&x| v.map(|c| c * x)).collect() };
    let sum = |a: Power<D>, b: Power<D>| -> Power<D> {
        (0..a.len().max(b.len()))
            .map(|k| {
                let zero = [0.0; D];
                added(*a.get(k).unwrap_or(&zero), *b.get(k).unwrap_or(&zero), 1.0)
            })
            .collect()
    };
    let mut vector = || whole_vector::<D>(random);
    let curve = match kind {
        // (x - s) (x - t) (v + w x) has a double point, of any two directions.
        0 => sum(scaled(&node, vector()), scaled(&product(&node, &[0.0, 1.0]), vector())),
        // With one direction, but for (x - s)² (x - t)² w: it touches itself.
        1 => sum(scaled(&product(&node, &[3.0, 1.0]), vector()), scaled(&product(&node, &node), vector())),
        // A cusp.
        2 => {
            let square = product(&[-s, 1.0], &[-s, 1.0]);
            sum(scaled(&square, vector()), scaled(&product(&square, &[-s, 1.0]), vector()))
        }
        // A double point through an end.
        3 => {
            let node = product(&[0.0, 1.0], &[-t, 1.0]);
            sum(scaled(&node, vector()), scaled(&product(&node, &[0.0, 1.0]), vector()))
        }
        // There and back.
        4 => {
            let there: Power<D> = (0..=1 + random.below(3)).map(|_| whole_vector(random)).collect();
            composed(&there, &product(&[-s, 1.0], &[-s, 1.0]))
        }
        _ => Vec::new(),
    };
    let (points, weights) = match kind {
        0..=4 => bezier(&curve),
        5 => {
            let degree = 3 + random.below(3);
            let whole = random.below(3) == 0;
            random_curve(random, degree, whole)
        }
        // Closed, or with control points that are repeated.
        _ => {
            let degree = 3 + random.below(3);
            let mut curve = random_curve::<D>(random, degree, true);
            let (i, j) = (random.below(degree + 1), random.below(degree + 1));
            curve.0[i] = curve.0[j];
            curve
        }
    };
    let largest = points.iter().flatten().fold(0.0_f64, |a, x| a.max(x.abs()));
    let unit = 2.0_f64.powi(largest.max(1e-300).log2().ceil() as i32);
    let curve = (points.into_iter().map(|p| p.map(|x| x / unit)).collect::<Vec<_>>(), weights);
    let places = match kind {
        0 if t - s < 1.0 => vec![([s, t], Made::Meet)],
        1 if t - s < 1.0 => vec![([s, t], Made::Touch(1))],
        3 if t < 1.0 => vec![([0.0, t], Made::Meet)],
        4 => (0..=8)
            .map(|k| 0.125 * f64::from(k))
            .map(|x| [x, 2.0 * s - x])
            .filter(|at| at[0] < at[1] && at[1] <= 1.0)
            .map(|at| (at, Made::Meet))
            .collect(),
        _ => Vec::new(),
    };
    Case { curves: [curve.clone(), curve], places, overlap: None, along: kind == 4 }
}
