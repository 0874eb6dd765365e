//! Arc length, with an error bound that is proved rather than estimated.
//!
//! On a piece of the curve, `-1 <= z <= 1`, the square of the speed is a polynomial
//! `q = c0 (1 + c1 T1(z) + c2 T2(z) + …)`. On the Bernstein ellipse of the parameter `ρ` no `|Tj|` is larger than
//! `(ρʲ + ρ⁻ʲ)/2`; with `κ = Σ_{j≥1} |cj| (ρʲ + ρ⁻ʲ)/2` no `|q|` is larger than `c0 (1 + κ)`. If `q` has no zero there,
//! the speed `√q` continues to an analytic function and the Gauss–Legendre rule with `n` nodes has an error of at most
//! `64/15 M ρ^(-2n) / (1 - ρ⁻²)` with `M = √(c0 (1 + κ))`: the coefficient of `Tj` in its Chebyshev series is at most
//! `2 M ρ⁻ʲ`, and the rule integrates all `Tj` exactly but those with even `j >= 2n`, for which it errs by at most
//! `2 + 2/(j² - 1) <= 32/15` (Trefethen, *Approximation Theory and Approximation Practice*, theorems 8.1 and 19.3).
//!
//! There is no zero if `κ < 1`. That test is sharper for `q(z) q(-z)`, a polynomial in `y = T2(z)` of the same kind,
//! whose ellipse has the parameter `ρ²` (Graeffe's method). Pieces for which no rule is good enough are halved; next to
//! a cusp, where no test succeeds, pieces end when chord and control polygon agree to within the accuracy, or when
//! nothing is left but rounding errors. The zeros of plane curves of low degree [have a formula](plane).

mod hodograph;
mod plane;
mod powers;
mod quadrature;
mod series;

use self::hodograph::Hodograph;
use self::powers::SquaredSpeed;
#[cfg(feature = "geometry")]
pub(crate) use self::quadrature::RULES;
pub(crate) use self::quadrature::Rule;
#[cfg(feature = "geometry")]
pub(crate) use self::series::ELLIPSES;
use self::series::Rules;
use crate::domain::from_unit;
use crate::vector::{difference, distance, is_finite, largest_component, safe_unit};
use crate::{Array, Basis, Curve, Point, Scalar, bernstein};

/// Below this depth a piece is narrower than the distance of two floats.
const DEPTH: u32 = 56;

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The arc length `∫ |C'(t)| dt` over the domain; the error is at most `accuracy`.
    ///
    /// The bound of the error is proved, up to rounding: an `accuracy` below about `ε` times the length, also zero or
    /// NaN, asks for what the scalar type can give. Infinite or NaN control points have the length NaN; a length that is no
    /// number of the scalar type is infinite.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// // y = x², 0 <= x <= 1: √5/2 + asinh(2)/4.
    /// let parabola = Bezier::from_points([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]]);
    /// assert!((parabola.arclen(1e-12) - 1.478942857544597_f64).abs() < 1e-12);
    /// ```
    pub fn arclen(&self, accuracy: B::Scalar) -> B::Scalar {
        match self.prepare(accuracy, Rules::First) {
            Some(whole) => whole.unit * whole.length(),
            None => B::Scalar::NAN,
        }
    }

    /// The parameter `t` for which the curve from its start to `C(t)` has that length; the length up to there differs
    /// from `length` by at most `accuracy`, as in [`arclen`](Self::arclen).
    ///
    /// A `length` below zero gives the start of the domain, one above the length of the curve its end, and NaN gives
    /// NaN.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let parabola = Bezier::from_points([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]]);
    /// let half = parabola.inv_arclen(0.5 * parabola.arclen(1e-12), 1e-12);
    /// let [left, right] = parabola.split(half).unwrap();
    /// let difference: f64 = left.arclen(1e-12) - right.arclen(1e-12);
    /// assert!(difference.abs() < 4e-12);
    /// ```
    pub fn inv_arclen(&self, length: B::Scalar, accuracy: B::Scalar) -> B::Scalar {
        if length.is_nan() {
            return length;
        }
        let Some(whole) = self.prepare(accuracy, Rules::Smallest) else { return B::Scalar::NAN };
        let mut found = B::Scalar::ONE;
        let mut rest = length / whole.unit;
        whole.piece.walk(&mut |leaf| {
            let piece = leaf.length;
            if rest < piece {
                found = leaf.invert(rest.max(B::Scalar::ZERO));
                return false;
            }
            rest = rest - piece;
            true
        });
        from_unit(B::domain(), found)
    }

    /// The parameters of `count` points at equal distances along the curve, both ends included; each as in
    /// [`inv_arclen`](Self::inv_arclen), but found in one pass.
    ///
    /// All NaN if a control point is infinite or NaN.
    #[cfg(feature = "alloc")]
    pub fn arclen_parameters(&self, count: usize, accuracy: B::Scalar) -> alloc::vec::Vec<B::Scalar> {
        let Some(whole) = self.prepare(accuracy, Rules::Smallest) else {
            return alloc::vec![B::Scalar::NAN; count];
        };
        let total = whole.length();
        let step = total / B::Scalar::from_usize(count.saturating_sub(1).max(1));
        let mut parameters = alloc::vec::Vec::with_capacity(count);
        let mut before = B::Scalar::ZERO;
        whole.piece.walk(&mut |leaf| {
            let after = before + leaf.length;
            while parameters.len() < count {
                let target = step * B::Scalar::from_usize(parameters.len());
                if target >= after {
                    break;
                }
                parameters.push(from_unit(B::domain(), leaf.invert(target - before)));
            }
            before = after;
            true
        });
        // The last one, and on a curve of length zero all of them.
        let end = if total > B::Scalar::ZERO { B::domain()[1] } else { B::domain()[0] };
        parameters.resize(count, end);
        if count > 1 {
            parameters[count - 1] = B::domain()[1];
        }
        parameters
    }

    /// `count` points at equal distances along the curve, both ends included, exactly: the points at the
    /// [`arclen_parameters`](Self::arclen_parameters).
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// // A straight line with a parameter that is not proportional to its length.
    /// let line = Bezier::from_points([0.0_f64, 0.0, 1.0]);
    /// for (point, expected) in line.samples_by_arclen(5, 1e-12).iter().zip([0.0, 0.25, 0.5, 0.75, 1.0]) {
    ///     assert!((point - expected).abs() < 1e-11);
    /// }
    /// ```
    #[cfg(feature = "alloc")]
    pub fn samples_by_arclen(&self, count: usize, accuracy: B::Scalar) -> alloc::vec::Vec<P> {
        self.arclen_parameters(count, accuracy).into_iter().map(|t| self.eval(t)).collect()
    }

    /// The whole curve, ready to be walked along; `None` if it is not finite.
    fn prepare(&self, accuracy: B::Scalar, rules: Rules) -> Option<Whole<B, P>> {
        let mut points = self.to_bernstein();
        // Of the size of the control polygon, and no square root.
        let mut polygon = steps(points.as_ref());
        let mut size = B::Scalar::ONE;
        if !polygon.is_finite() {
            // The differences of finite points may be too large.
            size = points.as_ref().iter().fold(size, |size, &p| size.max(largest_component(p)));
            for p in points.as_mut() {
                *p = P::from_components(|d| p.component(d) / size);
            }
            polygon = steps(points.as_ref());
        }
        // With finite differences all points are finite if the first one is.
        if !polygon.is_finite() || !is_finite(points.as_ref()[0]) {
            return None;
        }
        // Products of eight velocities are formed.
        let unit = safe_unit(polygon, 3);
        // The start becomes the origin, so that no digits are lost far from it, and nothing overflows.
        let start = points.as_ref()[0];
        for p in points.as_mut() {
            *p = difference(*p, start);
            if unit != B::Scalar::ONE {
                *p = P::from_components(|d| p.component(d) / unit);
            }
        }
        let accuracy = (accuracy / size / unit).max(B::Scalar::EPSILON * (polygon / unit));
        // So long can a piece be of which nothing is left but the rounding errors of its control points.
        let noise = B::Scalar::EPSILON * B::Scalar::from_usize(4 * B::DEGREE) * (polygon / unit);
        let (from, to) = (B::Scalar::ZERO, B::Scalar::ONE);
        Some(Whole { piece: Piece { points, from, to, accuracy, noise, depth: 0, rules }, unit: unit * size })
    }
}

/// A curve whose lengths are measured in `unit`: so that powers of velocities neither overflow nor vanish.
struct Whole<B: Basis, P: Point<Scalar = B::Scalar>> {
    piece: Piece<B, P>,
    unit: B::Scalar,
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Whole<B, P> {
    /// The length in the unit.
    fn length(&self) -> B::Scalar {
        let Piece { points, accuracy, noise, rules, .. } = self.piece;
        if P::DIM <= 2 && B::DEGREE <= plane::HIGHEST_DEGREE && rules == Rules::First {
            return plane::length(points.as_ref(), accuracy, noise);
        }
        // Most curves are one smooth piece.
        if B::DEGREE <= MOST_POWERS && rules == Rules::First {
            let square = SquaredSpeed::<B>::of(points);
            if let Some(length) = square.length_by_single(accuracy) {
                return length;
            }
        }
        let mut sum = B::Scalar::ZERO;
        self.piece.walk(&mut |leaf| {
            sum = sum + leaf.length;
            true
        });
        sum
    }
}

/// The sum of the absolute values of all components of the differences of control points next to each other.
fn steps<P: Point>(points: &[P]) -> P::Scalar {
    let mut sum = P::Scalar::ZERO;
    for pair in points.windows(2) {
        for d in 0..P::DIM {
            sum = sum + (pair[1].component(d) - pair[0].component(d)).abs();
        }
    }
    sum
}

/// The length of the control polygon.
fn polygon<P: Point>(points: &[P]) -> P::Scalar {
    points.windows(2).fold(P::Scalar::ZERO, |sum, pair| sum + distance(pair[0], pair[1]))
}

#[derive(Clone, Copy)]
struct Piece<B: Basis, P: Point<Scalar = B::Scalar>> {
    points: B::Bernstein<P>,
    from: B::Scalar,
    to: B::Scalar,
    accuracy: B::Scalar,
    noise: B::Scalar,
    depth: u32,
    rules: Rules,
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Piece<B, P> {
    /// Returns whether to go on after this piece.
    fn walk(self, visit: &mut impl FnMut(&Leaf<B, P>) -> bool) -> bool {
        let Self { points, from, to, accuracy, noise, depth, rules } = self;
        let smooth = if B::DEGREE <= MOST_POWERS {
            let square = SquaredSpeed::<B>::of(points);
            square.rule(accuracy, rules).map(|rule| (square.length(rule), Speed::Smooth { square, rule }))
        } else {
            let velocity = Hodograph::of(points);
            let rule = velocity.rule(accuracy);
            rule.map(|rule| (rule.integrate(|z| velocity.speed(z)), Speed::Steady { velocity, rule }))
        };
        if let Some((length, speed)) = smooth {
            return visit(&Leaf { from, to, length, speed });
        }
        let [shortest, longest] = length_bounds(points.as_ref());
        if longest - shortest <= accuracy + accuracy || longest <= noise || depth == DEPTH {
            let length = mean([shortest, longest]);
            return visit(&Leaf { from, to, length, speed: Speed::Straight { points } });
        }
        let half = B::Scalar::of(0.5);
        let middle = from + (to - from) * half;
        let (mut left, mut right) = (points, points);
        bernstein::split(left.as_mut(), half, right.as_mut());
        let (accuracy, depth) = (accuracy * half, depth + 1);
        Self { points: left, from, to: middle, accuracy, noise, depth, rules }.walk(visit)
            && Self { points: right, from: middle, to, accuracy, noise, depth, rules }.walk(visit)
    }
}

/// Up to this degree the square of the speed is written in powers, which is faster; above it that would lose too many
/// digits.
const MOST_POWERS: usize = 8;

/// The lengths of the chord and of the control polygon, between which the length of the curve lies.
fn length_bounds<P: Point>(points: &[P]) -> [P::Scalar; 2] {
    match points {
        [start, .., end] => [distance(*start, *end), polygon(points)],
        _ => [P::Scalar::ZERO; 2],
    }
}

/// A piece whose length is known.
struct Leaf<B: Basis, P: Point<Scalar = B::Scalar>> {
    from: B::Scalar,
    to: B::Scalar,
    length: B::Scalar,
    speed: Speed<B, P>,
}

enum Speed<B: Basis, P: Point<Scalar = B::Scalar>> {
    /// The rule is good enough on every part of the piece that starts at its start.
    Smooth { square: SquaredSpeed<B>, rule: &'static Rule },
    /// The same for curves of high degree.
    Steady { velocity: Hodograph<B, P>, rule: &'static Rule },
    /// Chord and control polygon agree; so they do on every part, because subdivision shortens the polygons and
    /// lengthens the chords.
    Straight { points: B::Bernstein<P> },
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Leaf<B, P> {
    /// The parameter in the unit interval up to which the piece has that length.
    fn invert(&self, target: B::Scalar) -> B::Scalar {
        if target <= B::Scalar::ZERO {
            return self.from;
        }
        let part = match &self.speed {
            Speed::Smooth { square, rule } => invert(rule, target, |z| square.speed(z)),
            Speed::Steady { velocity, rule } => invert(rule, target, |z| velocity.speed(z)),
            Speed::Straight { points } => halve(*points, target),
        };
        self.from + (self.to - self.from) * part
    }
}

/// The part of a smooth piece, from 0 to 1, that has that length: Newton's method, and halving where it leaves the
/// bracket.
fn invert<S: Scalar>(rule: &Rule, target: S, speed: impl Fn(S) -> S) -> S {
    let [one, two, half] = [S::ONE, S::of(2.0), S::of(0.5)];
    // The length over -1..z, and its derivative.
    let up_to = |part: S| rule.integrate(|y| speed((y + one) * part - one)) * part;
    let [mut lo, mut hi] = [S::ZERO, one];
    let mut part = half;
    for _ in 0..80 {
        let gap = up_to(part) - target;
        if gap == S::ZERO {
            break;
        }
        if gap < S::ZERO {
            lo = part;
        } else {
            hi = part;
        }
        let slope = two * speed(two * part - one);
        let newton = part - gap / slope;
        let next = if newton > lo && newton < hi { newton } else { lo + (hi - lo) * half };
        let step = (next - part).abs();
        part = next;
        if step <= S::EPSILON * part {
            break;
        }
    }
    part
}

fn mean<S: Scalar>([a, b]: [S; 2]) -> S {
    (a + b) * S::of(0.5)
}

/// The part of a straight piece, from 0 to 1, that has that length. The speed need not be constant, and may vanish.
fn halve<A: Array<P>, P: Point>(mut points: A, mut target: P::Scalar) -> P::Scalar {
    let half = P::Scalar::of(0.5);
    let [mut part, mut width] = [P::Scalar::ZERO, P::Scalar::ONE];
    for _ in 0..DEPTH {
        width = width * half;
        let mut right = points;
        bernstein::split(points.as_mut(), half, right.as_mut());
        let left = mean(length_bounds(points.as_ref()));
        if target >= left {
            target = target - left;
            part = part + width;
            points = right;
        }
    }
    part
}
