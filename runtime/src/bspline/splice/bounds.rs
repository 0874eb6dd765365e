//! Upper bounds of the gap and of the angle between two strips, for all parameters of a piece on which both are
//! polynomial.
//!
//! Over the piece both edges, and the derivatives along and across them, are polynomials in Bernstein form. So are the
//! normals `N = across × tangent` (not of length one), their products `C = N₁ × N₂` and `D = N₁ · N₂`, and the
//! difference `G` of the edges:
//!
//! ```text
//! gap = |G(t)| <= max |G_i|,   tan(angle) = |C(t)| / D(t) <= max |C_i| / D_i   where all D_i > 0
//! ```
//!
//! because a polynomial curve lies in the convex hull of its coefficients `G_i`, and `C / D`, a rational one with the
//! weights `D_i`, in that of the points `C_i / D_i`. The piece is halved where the bound is worst, until it is at most
//! half a percent above a value that occurs. All coefficients carry a bound of what rounding may have done to them, in
//! the comments as multiples of the distance ε from 1 to the next number, and this *noise* is added on the unfavourable
//! side.
//!
//! A normal may vanish at an end of the piece, as at a pole; its coefficient there is zero up to the rounding of the
//! control points. Then the factor `t` or `1 - t` is divided out, and what is bounded there is the limit.

use alloc::vec;
use alloc::vec::Vec;

use super::strip::{Strip, Vector};
use crate::bernstein::{elevate, product::bilinear};
use crate::bspline::KnotVector;
use crate::vector::{cross, dot, length};
use crate::{Point, Scalar};

/// How far a bound may be above a value that occurs before a part is halved again, as a factor.
const SLACK: f64 = 1.005;

/// The most halvings of a piece.
const HALVINGS: usize = 200;

/// The width of the parts, of the unit interval, around a parameter at which a normal vanishes inside of a piece, that
/// are left out.
const LEFT_OUT: f64 = 1.0 / 8192.0;

/// Normals that are shorter than this, of vectors no longer than 1, are none.
const PARALLEL: f64 = 1e-12;

const EPSILON: f64 = f64::EPSILON;

/// An upper bound of a quantity over a piece, no more than one percent above its largest value but for rounding errors.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound {
    pub(super) most: f64,
    /// A parameter, from 0 to 1, at which the quantity is about as large.
    pub(super) at: f64,
}

/// The quantity `|C| / D`, or a monotone function of it, over a part of a piece.
struct Part {
    ends: [f64; 2],
    numerator: Vec<Vector>,
    denominator: Vec<f64>,
    /// What rounding did to each coefficient, at most.
    noise: f64,
    /// The bound over the part.
    most: f64,
    /// Whether halving makes it better.
    divisible: bool,
}

/// What is bounded.
#[derive(Clone, Copy, PartialEq)]
enum Quantity {
    /// `|C|`; the denominator is 1.
    Length,
    /// The angle from 0 to π with the sine proportional to `|C|` and the cosine to `D`.
    Angle,
}

impl Quantity {
    /// The value at a point of the curves.
    fn value(self, c: Vector, d: f64) -> f64 {
        match self {
            Self::Length => length(c),
            Self::Angle => Scalar::atan2(length(c), d),
        }
    }

    /// An upper bound over a part, if the coefficients are known up to `noise`.
    fn most(self, part: &Part, noise: f64) -> f64 {
        let pairs = || part.numerator.iter().zip(&part.denominator);
        let most = match self {
            Self::Length => pairs().fold(0.0, |most, (&c, _)| larger(most, length(c) + noise)),
            Self::Angle if part.denominator.iter().all(|&d| d > noise) => {
                pairs().fold(0.0, |most, (&c, &d)| larger(most, Scalar::atan2(length(c) + noise, d - noise)))
            }
            // Above π/2: `|C|` is at least its component in one direction, and the points (D, that component) of the
            // plane lie in a convex cone that begins with the positive first axis.
            Self::Angle => {
                let middle = part.numerator[part.numerator.len() / 2];
                let Some(direction) = crate::vector::direction(middle) else { return f64::PI };
                pairs().fold(0.5 * f64::PI, |most, (&c, &d)| {
                    let sine = dot(c, direction) - noise;
                    larger(most, if sine >= 0.0 { Scalar::atan2(sine, d - noise) } else { f64::PI })
                })
            }
        };
        // The functions used here are accurate to a few ε.
        most * (1.0 + 8.0 * EPSILON)
    }
}

/// The larger number; infinite if one is not a number.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::INFINITY } else { a.max(b) }
}

impl Part {
    fn new(
        quantity: Quantity,
        ends: [f64; 2],
        numerator: Vec<Vector>,
        denominator: Vec<f64>,
        noise: f64,
    ) -> Self {
        let mut part = Self { ends, numerator, denominator, noise, most: 0.0, divisible: true };
        part.most = quantity.most(&part, noise);
        part
    }

    /// The value at each end with its parameter; none where noise alone could make it.
    fn occurring(&self, quantity: Quantity) -> impl Iterator<Item = (f64, f64)> {
        let first = self.numerator.first().zip(self.denominator.first());
        let last = self.numerator.last().zip(self.denominator.last());
        [(self.ends[0], first), (self.ends[1], last)].into_iter().filter_map(move |(t, pair)| {
            let (&c, &d) = pair?;
            (length(c) + d.abs() > 64.0 * self.noise).then(|| (t, quantity.value(c, d)))
        })
    }

    fn halved(self, quantity: Quantity) -> [Self; 2] {
        let [lo, hi] = self.ends;
        let middle = 0.5 * (lo + hi);
        let (mut c, mut d) = (self.numerator, self.denominator);
        let (mut c_right, mut d_right) = (c.clone(), d.clone());
        crate::bernstein::split(&mut c, 0.5, &mut c_right);
        crate::bernstein::split(&mut d, 0.5, &mut d_right);
        // Each of the steps of de Casteljau's algorithm rounds a mean, of numbers no larger than all of them.
        let size = c_right.iter().chain(&c).map(|&c| length(c)).fold(0.0, larger);
        let size = d_right.iter().chain(&d).map(|d| d.abs()).fold(size, larger);
        let noise = self.noise + c.len() as f64 * EPSILON * size;
        [
            Self::new(quantity, [lo, middle], c, d, noise),
            Self::new(quantity, [middle, hi], c_right, d_right, noise),
        ]
    }
}

/// The bound over a piece, which is the only part at first. Narrow parts that `is_left_out` are.
fn bound(quantity: Quantity, whole: Part, is_left_out: impl Fn(&Part) -> bool) -> Bound {
    // The largest value that occurs, and where.
    let (mut at, mut occurs) = (whole.ends[0], 0.0);
    let mut see = |part: &Part| {
        for (t, value) in part.occurring(quantity) {
            if value > occurs {
                (at, occurs) = (t, value);
            }
        }
        occurs
    };
    let mut occurs_now = see(&whole);
    let mut parts = vec![whole];
    for _ in 0..HALVINGS {
        let divisible = (0..parts.len()).filter(|&i| parts[i].divisible);
        let worst = divisible.reduce(|a, b| if parts[b].most > parts[a].most { b } else { a });
        let Some(worst) = worst.filter(|&worst| parts[worst].most > SLACK * occurs_now) else { break };
        let part = &mut parts[worst];
        let (width, exact) = (part.ends[1] - part.ends[0], quantity.most(part, 0.0));
        let only_noise = exact <= SLACK * occurs_now + (part.most - exact) && part.most < 0.5 * f64::PI;
        if only_noise || quantity == Quantity::Length && !part.most.is_finite() {
            part.divisible = false;
        } else if width <= LEFT_OUT && is_left_out(part) {
            parts.swap_remove(worst);
        } else {
            let halves = parts.swap_remove(worst).halved(quantity);
            occurs_now = halves.iter().map(&mut see).fold(occurs_now, f64::max);
            parts.extend(halves);
        }
    }
    Bound { most: parts.iter().fold(0.0, |most, part| larger(most, part.most)), at }
}

/// The largest distance of the edges between two neighbouring breakpoints, `ends`, which lie on these spans of both.
pub(super) fn gap([a, b]: [&Strip; 2], spans: [usize; 2], ends: [f64; 2]) -> Bound {
    // Measured from a point of the piece: rounding is in proportion to its size, not to the distance from the origin.
    let origin = a.edge[spans[0]];
    let mut size = 0.0;
    let [p, q] = [(a, spans[0]), (b, spans[1])].map(|(strip, span)| {
        let points = strip.local_points(span).map(|p| p.minus(origin)).collect::<Vec<_>>();
        size = points.iter().fold(size, |size, &p| larger(size, length(p)));
        bezier(&strip.knots, span, points, ends)
    });
    let degree = p.len().max(q.len());
    // Twice that of `bezier` and of the difference from the origin, and that of the means by which a degree is raised.
    let raised = if p.len() == q.len() { 0 } else { 8 * degree };
    let noise = (10 * degree + raised) as f64 * EPSILON * size;
    let elevated = |points: Vec<Vector>| {
        let mut raised = vec![[0.0; 3]; degree];
        elevate(&points, &mut raised);
        raised
    };
    let differences = elevated(p).into_iter().zip(elevated(q)).map(|(p, q)| p.minus(q)).collect::<Vec<_>>();
    let part = Part::new(Quantity::Length, [0.0, 1.0], differences, vec![1.0; degree], noise);
    bound(Quantity::Length, part, |_| false)
}

/// The largest angle of the normals between two neighbouring breakpoints; `None` if a strip has no normal there at all.
pub(super) fn angle([a, b]: [&Strip; 2], spans: [usize; 2], ends: [f64; 2]) -> Option<Bound> {
    // The directions across point into the strips: out of the first one is the opposite one.
    let (a, b) = (Normals::new(a, spans[0], ends, -1.0)?, Normals::new(b, spans[1], ends, 1.0)?);
    let degree = a.coefficients.len() + b.coefficients.len() - 2;
    let (mut c, mut d) = (vec![[0.0; 3]; degree + 1], vec![0.0; degree + 1]);
    bilinear(&a.coefficients, &b.coefficients, &mut c, cross);
    bilinear(&a.coefficients, &b.coefficients, &mut d, dot);
    let noise = a.noise + b.noise + a.noise * b.noise + product_noise(degree);
    if !d.iter().all(|d| d.is_finite()) {
        return Some(Bound { most: f64::PI, at: 0.0 }); // the binomial coefficients of a degree above 250
    }
    let part = Part::new(Quantity::Angle, [0.0, 1.0], c, d, noise);
    Some(bound(Quantity::Angle, part, |part| {
        let middle = 0.5 * (part.ends[0] + part.ends[1]);
        a.may_vanish_near(middle) || b.may_vanish_near(middle)
    }))
}

/// What rounding does to the coefficients of a product of that degree of two vector functions that are no longer than
/// 1: seven roundings for each of the steps that lead to a weight, those of the product itself, and of the sum.
fn product_noise(degree: usize) -> f64 {
    (4 * degree + 4) as f64 * EPSILON
}

/// The normals of a strip over a piece, of any length up to 1, as the coefficients of a polynomial.
struct Normals {
    coefficients: Vec<Vector>,
    /// The error of each coefficient, at most.
    noise: f64,
}

impl Normals {
    fn new(strip: &Strip, span: usize, ends: [f64; 2], sign: f64) -> Option<Self> {
        let k = strip.knots.degree();
        let knots = strip.knots.as_slice();
        let edge = strip.local_points(span).collect::<Vec<_>>();
        let inner = &strip.inner[span - k..=span];
        let across = inner.iter().zip(&edge).map(|(p, &q)| p.minus(q).scale(sign)).collect::<Vec<_>>();
        // P'[i] = k (P[i+1] - P[i]) / (t[i+k+1] - t[i+1]); the factor k does not matter.
        let widths = (span - k..span).map(|i| knots[i + k + 1] - knots[i + 1]);
        let narrowest = widths.clone().fold(f64::INFINITY, f64::min);
        let steps = edge.windows(2).zip(widths);
        let tangent =
            steps.map(|(pair, width)| pair[1].minus(pair[0]).scale(narrowest / width)).collect::<Vec<_>>();
        let (across, across_size) = of_length_one(&across)?;
        let (tangent, tangent_size) = of_length_one(&tangent)?;
        let across = bezier(&strip.knots, span, across, ends);
        let tangent = bezier(&strip.knots, span, tangent, ends);
        let mut coefficients = vec![[0.0; 3]; 2 * k];
        bilinear(&across, &tangent, &mut coefficients, cross);
        let mut noise = (10 * k + 6) as f64 * EPSILON + product_noise(2 * k - 1);
        // What the last digits of the control points do to differences.
        let coordinates = edge.iter().chain(inner).flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        let rounding = 4.0 * EPSILON * coordinates * (1.0 / across_size + 1.0 / tangent_size);
        let zero = noise + rounding;
        for end in [0, 1] {
            while let Some(&last) = if end == 0 { coefficients.first() } else { coefficients.last() } {
                // Written so that NaN ends the loop.
                if !(length(last) <= zero && coefficients.len() > 1) {
                    break;
                }
                divide(&mut coefficients, end == 0);
                noise *= coefficients.len() as f64;
            }
        }
        let size = coefficients.iter().fold(0.0, |size, &n| larger(size, length(n)));
        if !(size.is_finite() && size > noise.max(PARALLEL)) {
            return None;
        }
        let coefficients = coefficients.iter().map(|n| n.scale(1.0 / size)).collect();
        Some(Self { coefficients, noise: noise / size + 2.0 * EPSILON })
    }

    /// Whether the normal can vanish on a part of the width that is left out, around that parameter.
    fn may_vanish_near(&self, at: f64) -> bool {
        // No derivative is longer than twice the degree.
        let steepest = 2 * self.coefficients.len();
        length(crate::bernstein::eval(&self.coefficients, at)) <= LEFT_OUT * steepest as f64 + self.noise
    }
}

/// Divides by the parameter, or by one minus it, a polynomial in Bernstein form that is zero at that end.
fn divide(coefficients: &mut Vec<Vector>, at_start: bool) {
    let degree = coefficients.len() - 1;
    if at_start {
        coefficients.remove(0);
    } else {
        coefficients.pop();
    }
    for (j, c) in coefficients.iter_mut().enumerate() {
        *c = c.scale(degree as f64 / if at_start { j + 1 } else { degree - j } as f64);
    }
}

/// The vectors divided by the length of the longest, and that length; `None` if it is zero or not finite, or there is
/// none.
fn of_length_one(vectors: &[Vector]) -> Option<(Vec<Vector>, f64)> {
    let size = vectors.iter().fold(0.0, |size, &v| larger(size, length(v)));
    let unit = |v: &Vector| v.map(|x| x / size);
    (size > 0.0 && size.is_finite()).then(|| (vectors.iter().map(unit).collect(), size))
}

/// The Bernstein coefficients between `lo` and `hi`, which lie on a span, of the polynomial that a B-spline is on that
/// span, from its coefficients there: those of the degree of the knot vector, or of its derivative, one less.
///
/// With the blossom `f` and the knots `a[1], …, a[2k]` around the span they are `c[i] = f(a[i+1], …, a[i+k])`, first
/// replaced by `f(a[i+1], …, a[k], hi, …, hi)` and then by `f(lo, …, lo, hi, …, hi)`. Each of the 2k steps forms means,
/// with an error of at most 5/2 ε of the largest coefficient.
fn bezier(knots: &KnotVector<f64>, span: usize, mut c: Vec<Vector>, [lo, hi]: [f64; 2]) -> Vec<Vector> {
    let k = c.len() - 1;
    let a = |j: usize| knots.as_slice()[span + j - k];
    let mean = |p: Vector, q: Vector, weights: [f64; 2], whole: f64| {
        p.scale(weights[0] / whole).add_weighted(q, weights[1] / whole)
    };
    for r in 1..=k {
        for i in (r..=k).rev() {
            let (from, to) = (a(i), a(i + k - r + 1));
            c[i] = mean(c[i - 1], c[i], [to - hi, hi - from], to - from);
        }
    }
    for r in 1..=k {
        for i in 0..=k - r {
            let from = a(i + r);
            c[i] = mean(c[i], c[i + 1], [hi - lo, lo - from], hi - from);
        }
    }
    c
}
