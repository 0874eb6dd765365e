//! The arc length of a plane curve of degree 3 or less, by the zeros of its velocity.
//!
//! With `x + iy` for a point the velocity `dC/dz`, `-1 <= z <= 1`, is a polynomial `p = a + bz + cz²`, and the speed is
//! `√(p(z) p̄(z))`, where `p̄` has the conjugate coefficients. Its zeros are those of `p` and their conjugates, which lie
//! on the same Bernstein ellipse: that of a zero `w` has the semi-major axis `A = (|w + 1| + |w - 1|)/2` and the
//! parameter `ρ = A + √(A² - 1)`. Inside of the smallest one the speed is analytic, and at most
//! `M = |a| + |b|A + |c|A²`, because no point there is farther from 0 than `A`; so the rule with `n` nodes has an error of
//! at most `64/15 M ρ^(-2n) / (1 - ρ⁻²)`, as in the [parent module](super).
//!
//! A part for which no rule is good enough is divided beside the nearest zero: a zero beside an end leaves a much larger
//! ellipse than one at the same distance beside the middle.

// What is marked so is compiled once for each set of vector instructions.
#![allow(clippy::inline_always)]

use core::ops::{Add, Mul, Sub};

use super::DEPTH;
use super::quadrature::{RULES, Rule};
use crate::numeric::simd::{Kernel, WORTHWHILE, dispatch};
use crate::{Point, Scalar};

/// Up to this degree the zeros have a formula.
pub(super) const HIGHEST_DEGREE: usize = 3;

/// What rounding leaves of `ρ²`: zeros have half of the digits where they are nearly double.
const KEPT: f64 = 1.0 - 1e-5;

/// From this `ρ²` on it is known to [`KEPT`].
const SMALLEST: f64 = 1.04;

/// A larger `A²` is worth nothing more.
const LARGEST: f64 = 4096.0;

/// A part is divided beside a zero that is not farther from its middle than this, and otherwise here, next to the end at
/// which the zero is.
const OUTER: f64 = 0.7;

/// The length of the curve with these Bézier control points, one more than its degree, which is [`HIGHEST_DEGREE`] or less;
/// its error is at most `accuracy`, and what is shorter than `noise` consists of rounding errors.
pub(super) fn length<P: Point>(points: &[P], accuracy: P::Scalar, noise: P::Scalar) -> P::Scalar {
    let degree = points.len().saturating_sub(1);
    let coordinate = |k: usize, d: usize| if d < P::DIM { points[k].component(d).to_f64() } else { 0.0 };
    // The coefficients of the velocity, of the degree below that of the curve; dx/dz is 1/2.
    let difference = |k: usize| {
        if k >= degree {
            return Complex { re: 0.0, im: 0.0 };
        }
        let step = |d: usize| coordinate(k + 1, d) - coordinate(k, d);
        Complex { re: step(0), im: step(1) } * (0.5 * degree as f64)
    };
    let [u, v, w] = [difference(0), difference(1), difference(2)];
    let zero = Complex { re: 0.0, im: 0.0 };
    let [a, b, c] = match degree {
        0 | 1 => [u, zero, zero],
        2 => [(u + v) * 0.5, (v - u) * 0.5, zero],
        _ => [(u + w + v * 2.0) * 0.25, (w - u) * 0.5, (u + w - v * 2.0) * 0.25],
    };
    let root = (b * b - a * c * 4.0).sqrt();
    let curve =
        Plane { whole: Velocity { a, b, c, root }, accuracy: accuracy.to_f64(), noise: noise.to_f64() };
    let length = match curve.whole.rule(curve.accuracy) {
        Ok(rule) => curve.whole.integral(rule),
        Err(nearest) => curve.divided(&curve.whole, nearest, 0.0, 1.0, 0),
    };
    P::Scalar::of(length)
}

/// A curve and how exact its length has to be.
struct Plane {
    whole: Velocity,
    accuracy: f64,
    noise: f64,
}

impl Plane {
    /// The length over `middle - half <= z <= middle + half`.
    fn part(&self, middle: f64, half: f64, depth: u32) -> f64 {
        let part = self.whole.over(middle, half);
        match part.rule(self.accuracy) {
            Ok(rule) => half * part.integral(rule),
            Err(nearest) => self.divided(&part, nearest, middle, half, depth),
        }
    }

    /// The same of a part for which no rule is good enough, with its velocity and the real part of the nearest zero.
    fn divided(&self, part: &Velocity, nearest: f64, middle: f64, half: f64, depth: u32) -> f64 {
        let [shortest, longest] = part.bounds();
        if longest - shortest <= 2.0 * self.accuracy || half * longest <= self.noise || depth == DEPTH {
            return half * 0.5 * (shortest + longest);
        }
        let place = if nearest.abs() < OUTER { nearest } else { OUTER.copysign(nearest) };
        let [left, right] = [0.5 * (1.0 + place), 0.5 * (1.0 - place)];
        self.part(middle - half * right, half * left, depth + 1)
            + self.part(middle + half * left, half * right, depth + 1)
    }
}

/// `a + bz + cz²`, with a square root of `b² - 4ac`.
#[derive(Clone, Copy)]
struct Velocity {
    a: Complex,
    b: Complex,
    c: Complex,
    root: Complex,
}

impl Velocity {
    /// The velocity over a part, divided by `half`, in the part's own variable.
    fn over(&self, middle: f64, half: f64) -> Self {
        let Self { a, b, c, root } = *self;
        Self {
            a: (c * middle + b) * middle + a,
            b: (c * (2.0 * middle) + b) * half,
            c: c * (half * half),
            root: root * half,
        }
    }

    /// The smallest rule whose error is proved to be at most `accuracy`, or the real part of the nearest zero.
    #[inline]
    fn rule(&self, accuracy: f64) -> Result<&'static Rule, f64> {
        let Self { a, b, c, root } = *self;
        // The zeros are -s/2c and -2a/s with the sum s = b ± root that does not cancel.
        let s = b + root * 1.0_f64.copysign(b.re * root.re + b.im * root.im);
        let [first, second] = [(s, c * 2.0), (a * 2.0, s)];
        // A² = (|w|² + 1 + |w² - 1|)/2, as a fraction like w.
        let axis = |(above, below): (Complex, Complex)| {
            let [over, under] = [above.norm(), below.norm()];
            (over + under + (above * above - below * below).norm().sqrt(), under + under)
        };
        let [one, other] = [axis(first), axis(second)];
        // Nothing is known of a zero that is at no place.
        let [one, other] = [(one.0 / one.1).min(LARGEST), (other.0 / other.1).min(LARGEST)];
        let axis = one.min(other);
        // ρ² = 2A² - 1 + 2A√(A² - 1), and A <= (A² + 1)/2
        let square = ((axis + axis - 1.0) + 2.0 * Scalar::sqrt(axis * (axis - 1.0))) * KEPT;
        let most = a.sum() + 0.5 * (axis + 1.0) * b.sum() + axis * c.sum();
        // Not for NaN either.
        if square > SMALLEST {
            let fourth = square * square;
            let eighth = fourth * fourth;
            let power = eighth * eighth;
            let mut largest = accuracy * (square - 1.0) * (15.0 / 64.0);
            for rule in &RULES {
                largest *= power;
                if most * square <= largest {
                    return Ok(rule);
                }
            }
        }
        let (above, below) = if one <= other { first } else { second };
        Err(-(above.re * below.re + above.im * below.im) / below.norm())
    }

    /// Twice the lengths of the chord and of the control polygon of the integral, between which its own lies.
    fn bounds(&self) -> [f64; 2] {
        let Self { a, b, c, .. } = *self;
        let [u, v, w] = [a + c - b, a - c, a + c + b];
        let length = |z: Complex| z.norm().sqrt() * (2.0 / 3.0);
        [length(u + v + w), length(u) + length(v) + length(w)]
    }

    /// `∫|p|` by a rule.
    #[inline]
    fn integral(&self, rule: &Rule) -> f64 {
        let mut parts = [0.0; 4];
        dispatch(WORTHWHILE, Sum { velocity: self, rule, parts: &mut parts });
        let [a, b, c, d] = parts;
        (a + b) + (c + d)
    }
}

/// The sum of a rule over the absolute value of a velocity.
struct Sum<'a> {
    velocity: &'a Velocity,
    rule: &'a Rule,
    parts: &'a mut [f64; 4],
}

impl Kernel for Sum<'_> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Velocity { a, b, c, .. } = *self.velocity;
        *self.parts = self.rule.parts(
            #[inline(always)]
            |z: [f64; 4]| {
                let mut speeds = [[0.0; 4]; 2];
                for k in 0..4 {
                    let square = z[k] * z[k];
                    let [x, y] = [c.re.fma::<FUSED>(square, a.re), c.im.fma::<FUSED>(square, a.im)];
                    let [u, v] = [b.re * z[k], b.im * z[k]];
                    speeds[0][k] = Scalar::sqrt((x + u).fma::<FUSED>(x + u, (y + v) * (y + v)));
                    speeds[1][k] = Scalar::sqrt((x - u).fma::<FUSED>(x - u, (y - v) * (y - v)));
                }
                speeds
            },
        );
    }
}

/// `re + i·im`; a struct, which stays in registers where an array does not.
#[derive(Clone, Copy)]
struct Complex {
    re: f64,
    im: f64,
}

impl Complex {
    /// The square of the absolute value.
    fn norm(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    /// Not less than the absolute value, and a square root cheaper.
    fn sum(self) -> f64 {
        self.re.abs() + self.im.abs()
    }

    fn sqrt(self) -> Self {
        // The sum that does not cancel; the other part follows from the product.
        let part = Scalar::sqrt(0.5 * (Scalar::sqrt(self.norm()) + self.re.abs()));
        let other = if part == 0.0 { 0.0 } else { 0.5 * self.im / part };
        if self.re >= 0.0 {
            Self { re: part, im: other }
        } else {
            Self { re: other.abs(), im: part.copysign(self.im) }
        }
    }
}

impl Add for Complex {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Complex {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for Complex {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

impl Mul<f64> for Complex {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self { re: factor * self.re, im: factor * self.im }
    }
}
