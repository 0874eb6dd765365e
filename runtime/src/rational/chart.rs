//! The map from the domain of a rational family to the unit interval.

use super::slices::TILE;
use crate::Scalar;
use crate::domain::{from_unit, unit};
use crate::numeric::elementary::{decay, inverse_power_of_two, sine};

/// The map from a domain `lo <= t <= hi` to the parameter `0 <= x <= 1` in which the functions of a
/// [`RationalBasis`](crate::RationalBasis) are quotients of polynomials.
///
/// It is affine for families of rational functions. For those with sine and cosine it is
/// `x = (tan ψ - tan ψ0) / (tan ψ1 - tan ψ0)`, for those with exponentials the same with tanh, where `ψ` is affine in
/// `t` and runs from `ψ0` to `ψ1`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chart<S: Scalar> {
    domain: [S; 2],
    /// What is to be added to the ends of the domain, which no float need be.
    tails: [S; 2],
    /// Which ends belong to the domain.
    included: [bool; 2],
    kind: Kind<S>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind<S: Scalar> {
    Affine,
    Circular(Turn<S>),
    Hyperbolic(Turn<S>),
}

/// How ψ runs.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Turn<S: Scalar> {
    /// dψ/dt.
    rate: S::Wide,
    /// The factors of the two coordinates.
    factors: [S::Wide; 2],
    /// The Bernstein coefficients of dy/dt as a polynomial of degree 2 in y, the [balanced](Chart::balanced) place.
    slopes: [S; 3],
}

/// The sum of `c p` minus `end`, in twice the precision: by the sums of Knuth and the products of Dekker, each with its
/// error.
fn lost<S: Scalar>(end: f64, terms: &[(f64, S)]) -> f64 {
    let halves = |x: f64| {
        let large = 134_217_729.0 * x; // 2²⁷ + 1
        let high = large - (large - x);
        (high, x - high)
    };
    let (mut high, mut low) = (-end, 0.0);
    for &(c, p) in terms {
        let p = p.to_f64();
        let product = c * p;
        let ((c0, c1), (p0, p1)) = (halves(c), halves(p));
        let error = ((c0 * p0 - product) + c0 * p1 + c1 * p0) + c1 * p1;
        let sum = high + product;
        let own = sum - high;
        low += ((high - (sum - own)) + (product - own)) + error;
        high = sum;
    }
    high + low
}

impl<S: Scalar> Chart<S> {
    /// The affine map, `x = (t - lo) / (hi - lo)`.
    #[inline]
    pub fn affine(domain: [S; 2]) -> Self {
        Self { domain, tails: [S::ZERO; 2], included: [true; 2], kind: Kind::Affine }
    }

    /// The map by tangents of `ψ`, where `dψ/dt` is `rate`, and `ψ` is `turn[0]` and `turn[1]` at the two ends, both
    /// between `-π/2` and `π/2`.
    ///
    /// With `a = ψ - ψ0` and `b = ψ1 - ψ` it is `1 - x : x = sin b cos ψ0 : sin a cos ψ1`; each of the two keeps its
    /// relative accuracy where it vanishes. Only their quotient counts; a power of two, which rounds nothing, makes both
    /// of moderate size.
    #[inline]
    pub fn circular(domain: [S; 2], rate: S, turn: [S; 2]) -> Self {
        let (rate, turn) = (rate.wide(), turn.map(S::wide));
        let [(_, c0), (_, c1)] = turn.map(Scalar::sin_cos);
        let (sin, cos) = Scalar::sin_cos(turn[1] - turn[0]);
        let scale = inverse_power_of_two(sin);
        let factors = [c0 * scale, c1 * scale];
        // dy/dψ = 1 / (sin Δ (s + y)²) for s = sin b / sin Δ, y = sin a / sin Δ, and sin² Δ = sin² a + sin² b + 2 sin a
        // sin b cos Δ.
        let one = S::Wide::ONE;
        let slopes = [one / sin, cos / sin, one / sin].map(|slope| S::narrow(slope * rate));
        Self {
            domain,
            tails: [S::ZERO; 2],
            included: [true; 2],
            kind: Kind::Circular(Turn { rate, factors, slopes }),
        }
    }

    /// As [`circular`](Self::circular) with hyperbolic tangents: `1 - x : x = sinh b cosh ψ0 : sinh a cosh ψ1`.
    #[inline]
    pub fn hyperbolic(domain: [S; 2], rate: S, turn: [S; 2]) -> Self {
        let (rate, turn) = (rate.wide(), turn.map(S::wide));
        let [one, two] = [S::Wide::ONE, S::Wide::of(2.0)];
        let decay = |x: S::Wide| (-(two * x)).exp_m1();
        // 1 - exp(-2Δ) is twice sinh Δ exp(-Δ).
        let width = -decay(turn[1] - turn[0]);
        let ends = turn.map(|end| two + decay(end));
        let scale = inverse_power_of_two(width);
        let factors = ends.map(|end| end * scale);
        // dx/dψ = 1 / (cosh² ψ (tanh ψ1 - tanh ψ0)), and cosh ψ1 / cosh ψ0 = exp(Δ) ends[1] / ends[0].
        let falls = falling(turn[1] - turn[0]);
        let [first, last] = ends.map(|end| two * (end / width));
        let slopes = [last / ends[0], (one + falls) / width, first / ends[1] * falls];
        let slopes = slopes.map(|slope| S::narrow(slope * rate));
        Self {
            domain,
            tails: [S::ZERO; 2],
            included: [true; 2],
            kind: Kind::Hyperbolic(Turn { rate, factors, slopes }),
        }
    }

    /// The same map where the ends of the domain are the sums of two numbers: `ends` as floats of 64 bits, which may be
    /// too many for `S`, and what is missing to them.
    #[inline]
    #[must_use]
    pub fn with_exact_ends(mut self, ends: [f64; 2], missing: [f64; 2]) -> Self {
        for k in 0..2 {
            self.tails[k] = S::of(ends[k] - self.domain[k].to_f64() + missing[k]);
        }
        self
    }

    /// The same map where the ends of the domain are sums of multiples `c p` of numbers, such as a knot that is the sum
    /// of the lengths before it: what is lost by rounding them counts next to these ends.
    #[inline]
    #[must_use]
    pub fn with_sums_as_ends(mut self, sums: [&[(f64, S)]; 2]) -> Self {
        for ((tail, end), sum) in self.tails.iter_mut().zip(self.domain).zip(sums) {
            let rest = lost(end.to_f64(), sum);
            *tail = if rest.is_finite() { S::of(rest) } else { S::ZERO };
        }
        self
    }

    /// The same map of a domain without its lower end.
    #[inline]
    #[must_use]
    pub fn without_start(mut self) -> Self {
        self.included[0] = false;
        self
    }

    /// The same map of a domain without its upper end.
    #[inline]
    #[must_use]
    pub fn without_end(mut self) -> Self {
        self.included[1] = false;
        self
    }

    /// Whether `t` lies in the domain; an end may be left out.
    #[inline]
    pub fn contains(&self, t: S) -> bool {
        let [lo, hi] = self.domain;
        (if self.included[0] { lo <= t } else { lo < t }) && if self.included[1] { t <= hi } else { t < hi }
    }

    /// The two ends `[lo, hi]` of the domain.
    #[inline]
    pub fn domain(&self) -> [S; 2] {
        self.domain
    }

    /// Whether the map is affine.
    #[inline]
    pub fn is_affine(&self) -> bool {
        matches!(self.kind, Kind::Affine)
    }

    /// Coordinates `[s, x]` of `t`, proportional to `1 - x` and `x`: their sum is 1 where the map is affine and at both
    /// ends, and some positive number otherwise, whose size says nothing. Each has a small relative error where it is
    /// small, and is 0 at the end.
    #[inline]
    pub fn coordinates(&self, t: S) -> [S; 2] {
        let turn = match self.kind {
            Kind::Affine if self.tails == [S::ZERO; 2] => return unit(self.domain, t),
            Kind::Affine => {
                // An end is what its float stands for.
                let [lo, hi] = self.domain;
                let width = (hi - lo) + (self.tails[1] - self.tails[0]);
                let [after, before] = [(t - lo) - self.tails[0], (hi - t) + self.tails[1]];
                let ends = [
                    if t == hi { S::ZERO } else { before / width },
                    if t == lo { S::ZERO } else { after / width },
                ];
                return [if t == lo { S::ONE } else { ends[0] }, if t == hi { S::ONE } else { ends[1] }];
            }
            Kind::Circular(turn) | Kind::Hyperbolic(turn) => turn,
        };
        let [lo, hi] = self.domain;
        // An end is what its float stands for.
        if t == lo || t == hi {
            return if t == lo { [S::ONE, S::ZERO] } else { [S::ZERO, S::ONE] };
        }
        let [t, lo, hi] = [t, lo, hi].map(S::wide);
        let after = turn.rate * ((t - lo) - self.tails[0].wide());
        let before = turn.rate * ((hi - t) + self.tails[1].wide());
        let [first, second] = turn.factors;
        if matches!(self.kind, Kind::Circular(_)) {
            return [before.sin_cos().0 * first, after.sin_cos().0 * second].map(S::narrow);
        }
        // sinh(b) : sinh(a) = 1 - exp(-2b) : exp(2a) - 1, both times a power of two near exp(-2a).
        let two = S::Wide::of(2.0);
        let (risen, left) = ((two * after).exp_m1(), -(-(two * before)).exp_m1());
        let size = inverse_power_of_two(S::Wide::ONE + risen);
        [left * size * first, risen * size * second].map(S::narrow)
    }

    /// The [`coordinates`](Self::coordinates) of parameters inside of the domain, by vector instructions and in the
    /// numbers of the scalar, up to a common factor; at an end some number in place of 0 or 1.
    #[inline(always)]
    #[allow(clippy::inline_always)] // it is compiled for the instructions of the caller
    pub(super) fn coordinates_into<const FUSED: bool>(
        &self,
        ts: &[S; TILE],
        s: &mut [S; TILE],
        x: &mut [S; TILE],
    ) {
        let [lo, hi] = self.domain;
        let [after, before] = self.tails;
        match self.kind {
            Kind::Affine => {
                let width = (hi - lo) + (before - after);
                for i in 0..TILE {
                    s[i] = ((hi - ts[i]) + before) / width;
                    x[i] = ((ts[i] - lo) - after) / width;
                }
            }
            Kind::Circular(Turn { rate, factors, .. }) => {
                let (rate, [first, second]) = (S::narrow(rate), factors.map(S::narrow));
                for i in 0..TILE {
                    s[i] = sine::<FUSED, S>(rate * ((hi - ts[i]) + before)) * first;
                    x[i] = sine::<FUSED, S>(rate * ((ts[i] - lo) - after)) * second;
                }
            }
            Kind::Hyperbolic(Turn { rate, factors, .. }) => {
                let (rate, [first, second]) = (S::narrow(rate), factors.map(S::narrow));
                for i in 0..TILE {
                    let [less, falls] = decay::<FUSED, S>(rate * ((ts[i] - lo) - after));
                    let [beyond, _] = decay::<FUSED, S>(rate * ((hi - ts[i]) + before));
                    s[i] = -beyond * falls * first;
                    x[i] = -less * second;
                }
            }
        }
    }

    /// The place `0 <= x <= 1` of `t`.
    #[inline]
    pub fn place(&self, t: S) -> S {
        let [s, x] = self.coordinates(t);
        if matches!(self.kind, Kind::Affine) { x } else { x / (s + x) }
    }

    /// The factor `cos ψ1 / cos ψ0` of a circular map, 1 of others. Where an end is near a right angle `x` is near 0 on
    /// all of the domain but a small part, and derivatives by it have no digits. Those by `y` keep them, with `1 - y :
    /// y = sin b : sin a`: a polynomial with the Bernstein coefficients `c[j]` in `x` has in `y`, but for a common
    /// factor of all, the coefficients `c[j]` times the j-th power of this.
    #[inline]
    pub(crate) fn balance(&self) -> S {
        match self.kind {
            Kind::Circular(turn) => S::narrow(turn.factors[1] / turn.factors[0]),
            Kind::Affine | Kind::Hyperbolic(_) => S::ONE,
        }
    }

    /// The place `0 <= y <= 1` of `t`: see [`balance`](Self::balance).
    #[inline]
    pub(crate) fn balanced(&self, t: S) -> S {
        let Kind::Circular(turn) = self.kind else { return self.place(t) };
        let [first, second] = turn.factors.map(S::narrow);
        let [s, x] = self.coordinates(t);
        let [s, y] = [s * second, x * first];
        y / (s + y)
    }

    /// The parameter `t` at the place `x`, exact at both ends.
    #[inline]
    pub fn parameter(&self, x: S) -> S {
        let [lo, hi] = self.domain;
        let (circular, turn) = match self.kind {
            Kind::Affine => return from_unit(self.domain, x),
            Kind::Circular(turn) => (true, turn),
            Kind::Hyperbolic(turn) => (false, turn),
        };
        if x == S::ZERO || x == S::ONE {
            return if x == S::ZERO { lo } else { hi };
        }
        let (s, [first, second], rate) = (S::ONE - x, turn.factors.map(S::narrow), S::narrow(turn.rate));
        let width = rate * (hi - lo);
        if circular {
            // (1 - x) : x = sin(Δ - a) cos ψ0 : sin a cos ψ1
            let (sin, cos) = width.sin_cos();
            return lo + (x * first * sin).atan2(s * second + x * first * cos) / rate;
        }
        // x second : (1 - x) first is the quotient of 1 - q and (1 - d/q) q, where q = exp(-2a), d = exp(-2Δ).
        let (x, s) = (x / second, s / first);
        let falls = (-(S::of(2.0) * width)).exp_m1();
        // x (q - d) = s (1 - q), so that q - 1 = x (d - 1) / (s + x)
        let q = x * falls / (s + x);
        lo - q.ln_1p() / (S::of(2.0) * rate)
    }

    /// The Taylor coefficients of `y(t + h) - y(t)` in `h`, from that of `h⁰`, which is zero; `y` is the
    /// [balanced](Self::balanced) place.
    ///
    /// `dy/dt` is a polynomial `a + b (y - y0) + c (y - y0)²`, so that each coefficient follows from those before it.
    #[inline]
    pub(crate) fn expansion(&self, t: S, series: &mut [S]) {
        series.fill(S::ZERO);
        let turn = match self.kind {
            Kind::Affine => {
                if let Some(first) = series.get_mut(1) {
                    *first = S::ONE / (self.domain[1] - self.domain[0]);
                }
                return;
            }
            Kind::Circular(turn) | Kind::Hyperbolic(turn) => turn,
        };
        let x = self.balanced(t);
        let s = S::ONE - x;
        let two = S::of(2.0);
        let [q0, q1, q2] = turn.slopes;
        let a = q0 * s * s + two * q1 * s * x + q2 * x * x;
        let b = two * ((q1 - q0) * s + (q2 - q1) * x);
        let c = q0 - two * q1 + q2;
        for k in 1..series.len() {
            let mut sum = b * series[k - 1];
            if k == 1 {
                sum = sum + a;
            }
            for i in 1..k {
                sum = sum + c * series[i] * series[k - 1 - i];
            }
            series[k] = sum / S::from_usize(k);
        }
    }
}

/// `exp(-2x)`, with a small relative error.
#[inline]
fn falling<S: Scalar>(x: S) -> S {
    // Not the sum of 1 and the exponential of a negative number, which cancel.
    S::ONE / (S::ONE + (S::of(2.0) * x).exp_m1())
}
