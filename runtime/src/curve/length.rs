//! Arc length, with an error bound that is proved rather than estimated.
//!
//! On a piece of the curve, `-1 <= z <= 1`, the square of the speed is a polynomial
//! `q = c0 (1 + c1 T1(z) + c2 T2(z) + …)`. On the Bernstein ellipse of the parameter `ρ` no `|Tj|` is larger than
//! `(ρʲ + ρ⁻ʲ)/2`; with `κ = Σ_{j≥1} |cj| (ρʲ + ρ⁻ʲ)/2` no `|q|` is larger than `c0 (1 + κ)`. If `q` has no zero there,
//! the speed `√q` continues to an analytic function and the Gauss–Legendre rule with `n` nodes has an error of at most
//! `8 √(c0 (1 + κ)) ρ / (ρ - 1) ρ^(-2n)` (from the best approximation of degree `2n - 1`; Trefethen, *Approximation
//! Theory and Approximation Practice*, theorems 8.2 and 19.3).
//!
//! There is no zero if `κ < 1`. That test is sharper for `q(z) q(-z)`, a polynomial in `y = T2(z)` of the same kind,
//! whose ellipse has the parameter `ρ²` (Graeffe's method). Pieces for which no rule is good enough are halved; next to
//! a cusp, where no test succeeds, pieces end when chord and control polygon agree to within the accuracy, or when
//! nothing is left but rounding errors.

use super::quadrature::{RULES, Rule};
use super::steady::Hodograph;
use crate::domain::from_unit;
use crate::vector::{distance, dot, is_finite, safe_unit};
use crate::{Array, Basis, Curve, FUSED_HERE, Point, Scalar, bernstein};

/// The `ρ` of the ellipses that are tried.
const ELLIPSES: [f64; 8] = [1.4, 1.55, 1.75, 2.0, 2.5, 3.5, 6.0, 24.0];

/// For all ellipses `ρ` and `(1 + ρ⁻²)/2`, so that `(ρʲ + ρ⁻ʲ)/2 <= (1 + ρ⁻²)/2 ρʲ`; then the same for `ρ²` and for
/// `ρ⁴`.
static RADII: [[[f64; ELLIPSES.len()]; 2]; 3] = {
    let mut radii = [[[0.0; ELLIPSES.len()]; 2]; 3];
    let mut e = 0;
    while e < ELLIPSES.len() {
        let mut rho = ELLIPSES[e];
        let mut step = 0;
        while step < radii.len() {
            radii[step][0][e] = rho;
            radii[step][1][e] = 0.5 + 0.5 / (rho * rho);
            rho *= rho;
            step += 1;
        }
        e += 1;
    }
    radii
};

/// `8 ρ / (ρ - 1) ρ^(-2n)` for each ellipse and the number of nodes `n` of each rule.
static FACTORS: [[f64; RULES.len()]; ELLIPSES.len()] = {
    let mut factors = [[0.0; RULES.len()]; ELLIPSES.len()];
    let mut e = 0;
    while e < ELLIPSES.len() {
        let rho = ELLIPSES[e];
        let mut r = 0;
        while r < RULES.len() {
            let mut factor = 8.0 * rho / (rho - 1.0);
            let mut n = 0;
            while n < RULES[r].len() {
                factor /= rho * rho;
                n += 1;
            }
            factors[e][r] = factor;
            r += 1;
        }
        e += 1;
    }
    factors
};

/// Below this depth a piece is narrower than the distance of two floats.
const DEPTH: u32 = 56;

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The arc length `∫ |C'(t)| dt` over the domain; the error is at most `accuracy`.
    ///
    /// The bound of the error is proved, up to rounding: an `accuracy` below about `ε` times the length, also zero or
    /// NaN, asks for what the scalar type can give. Infinite or NaN control points have the length NaN.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// // y = x², 0 <= x <= 1: √5/2 + asinh(2)/4.
    /// let parabola = Bezier::from_points([[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]]);
    /// assert!((parabola.arclen(1e-12) - 1.478942857544597_f64).abs() < 1e-12);
    /// ```
    pub fn arclen(&self, accuracy: B::Scalar) -> B::Scalar {
        self.length(accuracy, Rules::First)
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
    /// let [left, right] = parabola.split(half);
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
        let total = self.length(accuracy, Rules::Smallest) / whole.unit;
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

    /// [`arclen`](Self::arclen) with rules of that kind.
    fn length(&self, accuracy: B::Scalar, rules: Rules) -> B::Scalar {
        let Some(whole) = self.prepare(accuracy, rules) else { return B::Scalar::NAN };
        let unit = whole.unit;
        let mut sum = B::Scalar::ZERO;
        whole.piece.walk(&mut |leaf| {
            sum = sum + leaf.length;
            true
        });
        sum * unit
    }

    /// The whole curve, ready to be walked along; `None` if it is not finite.
    fn prepare(&self, accuracy: B::Scalar, rules: Rules) -> Option<Whole<B, P>> {
        let mut points = self.to_bernstein();
        let polygon = polygon(points.as_ref());
        if !points.as_ref().iter().all(|&p| is_finite(p)) || !polygon.is_finite() {
            return None;
        }
        // Products of eight velocities are formed.
        let unit = safe_unit(polygon, 3);
        // The start becomes the origin, so that no digits are lost far from it, and nothing overflows.
        let start = points.as_ref()[0];
        for p in points.as_mut() {
            *p = p.minus(start);
            if unit != B::Scalar::ONE {
                *p = P::from_components(|d| p.component(d) / unit);
            }
        }
        let accuracy = (accuracy / unit).max(B::Scalar::EPSILON * (polygon / unit));
        // So long can a piece be of which nothing is left but the rounding errors of its control points.
        let noise = B::Scalar::EPSILON * B::Scalar::from_usize(4 * B::DEGREE) * (polygon / unit);
        let (from, to) = (B::Scalar::ZERO, B::Scalar::ONE);
        Some(Whole { piece: Piece { points, from, to, accuracy, noise, depth: 0, rules }, unit })
    }
}

/// A curve whose lengths are measured in `unit`: so that powers of velocities neither overflow nor vanish.
struct Whole<B: Basis, P: Point<Scalar = B::Scalar>> {
    piece: Piece<B, P>,
    unit: B::Scalar,
}

/// The length of the control polygon.
fn polygon<P: Point>(points: &[P]) -> P::Scalar {
    points.windows(2).fold(P::Scalar::ZERO, |sum, pair| sum + distance(pair[0], pair[1]))
}

/// Which rule is looked for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Rules {
    /// The first that is proved to be good enough: to look for a smaller one takes longer than to use it once.
    First,
    /// The smallest one, to be used many times.
    Smallest,
}

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

/// The square of the speed `|dC/dz|` of a piece in powers of `z`: pairs of coefficients `[q[2k], q[2k+1]]`, of which
/// the last ones are zero. The degree is `2n - 2` on a curve of degree `n`, and there are `n + 1` pairs.
pub(super) struct SquaredSpeed<B: Basis> {
    coefficients: B::Bernstein<[B::Scalar; 2]>,
}

impl<B: Basis> SquaredSpeed<B> {
    /// The number of coefficients that need not be zero.
    pub(super) const LEN: usize = if B::DEGREE == 0 { 0 } else { 2 * B::DEGREE - 1 };

    /// Of the piece with these Bézier control points over `0 <= x <= 1`, with `z = 2x - 1`.
    fn of<P: Point<Scalar = B::Scalar>>(mut points: B::Bernstein<P>) -> Self {
        let velocity = bernstein::differentiate(points.as_mut());
        bernstein::centred_powers(velocity);
        let quarter = B::Scalar::of(0.25); // of (dx/dz)²
        let half = B::Scalar::of(0.5);
        let mut coefficients = B::Bernstein::from_fn(|_| [B::Scalar::ZERO; 2]);
        let q = coefficients.as_mut().as_flattened_mut();
        for (i, &v) in velocity.iter().enumerate() {
            q[2 * i] = q[2 * i] + dot(v, v) * quarter;
            for (j, &w) in velocity.iter().enumerate().take(i) {
                q[i + j] = q[i + j] + dot(v, w) * half;
            }
        }
        Self { coefficients }
    }

    /// As [`Chebyshev::rule`]; `None` also where the powers cancel each other.
    #[inline]
    fn rule(&self, accuracy: B::Scalar, rules: Rules) -> Option<&'static Rule> {
        let powers = self.coefficients.as_ref().as_flattened();
        let sum = Chebyshev::of(self);
        let absolute = powers.iter().fold(B::Scalar::ZERO, |sum, c| sum + c.abs());
        let stable = absolute <= B::Scalar::of(4.0) * sum.mean()?;
        if stable { sum.rule(accuracy, rules) } else { None }
    }

    /// The sum of the rule, by even and odd powers.
    fn length(&self, rule: &Rule) -> B::Scalar {
        let pairs = &self.coefficients.as_ref()[..B::DEGREE];
        rule.integrate_fours(|z: [B::Scalar; 4]| {
            let [mut even, mut odd] = [[B::Scalar::ZERO; 4]; 2];
            for &[a, b] in pairs.iter().rev() {
                for k in 0..4 {
                    let square = z[k] * z[k];
                    even[k] = even[k].fma::<FUSED_HERE>(square, a);
                    odd[k] = odd[k].fma::<FUSED_HERE>(square, b);
                }
            }
            let mut speeds = [[B::Scalar::ZERO; 4]; 2];
            for k in 0..4 {
                let odd = odd[k] * z[k];
                speeds[0][k] = (even[k] + odd).sqrt();
                speeds[1][k] = (even[k] - odd).sqrt();
            }
            speeds
        })
    }

    #[inline]
    fn speed(&self, z: B::Scalar) -> B::Scalar {
        let q = self.coefficients.as_ref().as_flattened().iter().rev();
        q.fold(B::Scalar::ZERO, |sum, &c| sum * z + c).sqrt()
    }
}

/// `c0 + c1 T1 + c2 T2 + …`, each coefficient with an error of at most `noise`.
pub(super) struct Chebyshev<B: Basis> {
    pub(super) coefficients: B::Bernstein<[B::Scalar; 2]>,
    pub(super) noise: B::Scalar,
}

impl<B: Basis> Chebyshev<B> {
    /// From powers: `zᵐ = Σ_k 2^(1-m) binomial(m, k) T(m-2k)`, half of the last one if it is that of `T0`.
    #[inline]
    fn of(powers: &SquaredSpeed<B>) -> Self {
        let powers = &powers.coefficients.as_ref().as_flattened()[..SquaredSpeed::<B>::LEN];
        let mut coefficients = B::Bernstein::from_fn(|_| [B::Scalar::ZERO; 2]);
        let c = coefficients.as_mut().as_flattened_mut();
        let mut first = 4.0; // 2^(1-m)
        for (m, &power) in powers.iter().enumerate() {
            first *= 0.5;
            let mut weight = first;
            for k in 0..=m / 2 {
                let half = if m == 2 * k { 0.5 } else { 1.0 };
                c[m - 2 * k] = c[m - 2 * k] + power * B::Scalar::of(weight * half);
                weight = weight * (m - k) as f64 / (k + 1) as f64;
            }
        }
        Self { coefficients, noise: B::Scalar::ZERO }
    }

    /// A rule whose error for `∫ |dC/dz| dz` is proved to be at most `accuracy`, if this is the square of the speed.
    #[inline]
    pub(super) fn rule(self, accuracy: B::Scalar, rules: Rules) -> Option<&'static Rule> {
        let margin = B::Scalar::of(0.99); // for rounding errors
        let mut sum = self;
        let mean = sum.mean()?;
        let change = sum.largest_changes(&RADII[0]);
        let mut analytic = change.map(|change| change < mean * margin);
        for radii in &RADII[1..] {
            if rules == Rules::First
                && let Some(rule) = choose(analytic, mean, change, accuracy)
            {
                return Some(rule);
            }
            sum = sum.opposites();
            let Some(mean) = sum.mean() else { break };
            let change = sum.largest_changes(radii);
            for k in 0..ELLIPSES.len() {
                analytic[k] |= change[k] < mean * margin;
            }
        }
        choose(analytic, mean, change, accuracy)
    }

    /// The first coefficient, if it is positive for certain.
    #[inline]
    fn mean(&self) -> Option<B::Scalar> {
        let mean = *self.coefficients.as_ref().as_flattened().first()? - self.noise;
        (mean > B::Scalar::ZERO).then_some(mean)
    }

    /// `Σ_{j≥1} |cj| (ρʲ + ρ⁻ʲ)/2` for each `ρ`; in one loop for all, without a branch.
    #[inline]
    fn largest_changes(&self, radii: &[[f64; ELLIPSES.len()]; 2]) -> [B::Scalar; ELLIPSES.len()] {
        let [rho, stretch] = radii;
        let mut sums = [B::Scalar::ZERO; ELLIPSES.len()];
        for &c in self.coefficients.as_ref().as_flattened()[1..SquaredSpeed::<B>::LEN].iter().rev() {
            let largest = c.abs() + self.noise;
            for k in 0..ELLIPSES.len() {
                sums[k] = (sums[k] + largest) * B::Scalar::of(rho[k]);
            }
        }
        for k in 0..ELLIPSES.len() {
            sums[k] = sums[k] * B::Scalar::of(stretch[k]);
        }
        sums
    }

    /// `q(z) q(-z)` as a polynomial in `y = T2(z)`, with `Ta Tb = (T(a+b) + T(a-b))/2` and `T2j(z) = Tj(y)`; what has
    /// odd indices cancels.
    #[inline]
    fn opposites(&self) -> Self {
        let half = B::Scalar::of(0.5);
        let c = &self.coefficients.as_ref().as_flattened()[..SquaredSpeed::<B>::LEN];
        let mut product = B::Bernstein::from_fn(|_| [B::Scalar::ZERO; 2]);
        let p = product.as_mut().as_flattened_mut();
        let mut absolute = B::Scalar::ZERO;
        for (a, &size) in c.iter().enumerate() {
            absolute = absolute + size.abs() + self.noise;
            let ca = if a % 2 == 0 { size } else { -size };
            let square = ca * size * half;
            p[0] = p[0] + square;
            p[a] = p[a] + square;
            for b in (a % 2..a).step_by(2) {
                let both = ca * c[b];
                p[a.midpoint(b)] = p[a.midpoint(b)] + both;
                p[(a - b) / 2] = p[(a - b) / 2] + both;
            }
        }
        let count = B::Scalar::from_usize(SquaredSpeed::<B>::LEN);
        let noise = absolute * (absolute * B::Scalar::EPSILON + self.noise) * (count + count);
        Self { coefficients: product, noise }
    }
}

/// The smallest rule that is good enough by the largest ellipse on which the speed is `analytic`, its square at most
/// `mean + change`.
fn choose<S: Scalar>(
    analytic: [bool; ELLIPSES.len()],
    mean: S,
    change: [S; ELLIPSES.len()],
    accuracy: S,
) -> Option<&'static Rule> {
    // The ellipses grow, and so do the changes.
    let largest = analytic.iter().filter(|&&analytic| analytic).count().checked_sub(1)?;
    let bound = (mean + change[largest]).sqrt();
    let bad = FACTORS[largest].iter().filter(|&&factor| bound * S::of(factor) > accuracy);
    RULES.get(bad.count())
}

/// The smallest rule for a velocity with Bernstein coefficients of that degree that differ from one of the length
/// `speed` by at most `spread`: on the ellipse `|x| + |1 - x|` is `(ρ + 1/ρ)/2`, so that they differ there by at most
/// its power times `spread`.
pub(super) fn rule_of_hull<S: Scalar>(
    degree: usize,
    speed: S,
    spread: S,
    accuracy: S,
) -> Option<&'static Rule> {
    let mut change = [S::ZERO; ELLIPSES.len()];
    for (e, change) in change.iter_mut().enumerate() {
        let axis = S::of(RADII[0][0][e] * RADII[0][1][e]);
        let width = (0..degree).fold(spread, |width, _| width * axis);
        // |(c + w)² - c²|
        *change = (speed + speed + width) * width;
    }
    let mean = speed * speed;
    choose(change.map(|change| change < mean * S::of(0.99)), mean, change, accuracy)
}

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
