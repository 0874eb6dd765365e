//! Chebyshev series of the square of a speed, and the quadrature rule whose error they bound.

// What is marked so is compiled once for each set of vector instructions.
#![allow(clippy::inline_always)]

use super::MOST_POWERS;
use super::quadrature::{RULES, Rule};
use crate::{Array, Basis, Scalar};

/// The `ρ` of the ellipses that are tried.
pub(crate) const ELLIPSES: [f64; 8] = [1.4, 1.55, 1.75, 2.0, 2.5, 3.5, 6.0, 24.0];

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

/// `64/15 ρ^(-2n) / (1 - ρ⁻²)` for each ellipse and the number of nodes `n` of each rule.
static FACTORS: [[f64; RULES.len()]; ELLIPSES.len()] = {
    let mut factors = [[0.0; RULES.len()]; ELLIPSES.len()];
    let mut e = 0;
    while e < ELLIPSES.len() {
        let rho = ELLIPSES[e];
        let mut r = 0;
        while r < RULES.len() {
            let mut factor = 64.0 / 15.0 / (1.0 - 1.0 / (rho * rho));
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

/// `zᵐ = Σ_j POWERS[m][j] Tj(z)` up to the powers in the square of a speed of degree [`MOST_POWERS`].
static POWERS: [[f64; 2 * MOST_POWERS - 1]; 2 * MOST_POWERS - 1] = {
    let mut all = [[0.0; 2 * MOST_POWERS - 1]; 2 * MOST_POWERS - 1];
    all[0][0] = 1.0;
    let mut m = 1;
    while m < all.len() {
        // z T0 = T1, z Tj = (T(j+1) + T(j-1))/2
        let mut j = 0;
        while j < m {
            let half = 0.5 * all[m - 1][j];
            if j == 0 {
                all[m][1] += 2.0 * half;
            } else {
                all[m][j + 1] += half;
                all[m][j - 1] += half;
            }
            j += 1;
        }
        m += 1;
    }
    all
};

/// How many rules are tried on one ellipse each.
const FIRST: usize = 4;

/// On such an ellipse the square of the speed may be as many times its mean.
const MOST: f64 = 8.0;

/// For the first rules the smallest `ρ` with `64/15 ρ^(-2n) / (1 - ρ⁻²) <= 2⁻ᵏ`, one row for each `k`.
static RHO: [[f64; FIRST]; 64] = {
    let mut all = [[0.0; FIRST]; 64];
    let mut k = 0;
    let mut wanted = 1.0;
    while k < all.len() {
        let mut r = 0;
        while r < FIRST {
            let (mut low, mut high) = (1.0, 1e6);
            let mut step = 0;
            while step < 40 {
                let rho = 0.5 * (low + high);
                // ρ^(2n) with n = 8, 16, 24, 32
                let mut eighth = rho * rho * rho * rho;
                eighth *= eighth;
                let sixteenth = eighth * eighth;
                let mut power = 1.0;
                let mut m = 0;
                while m < RULES[r].len() {
                    power *= sixteenth;
                    m += 8;
                }
                if 64.0 <= 15.0 * wanted * (1.0 - 1.0 / (rho * rho)) * power {
                    high = rho;
                } else {
                    low = rho;
                }
                step += 1;
            }
            all[k][r] = high;
            r += 1;
        }
        wanted *= 0.5;
        k += 1;
    }
    all
};

/// Which rule is looked for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Rules {
    /// The first that is proved to be good enough: to look for a smaller one takes longer than to use it once.
    First,
    /// The smallest one, to be used many times.
    Smallest,
}

/// `c0 + c1 T1 + c2 T2 + …`, each coefficient with an error of at most `noise`.
pub(super) struct Chebyshev<B: Basis> {
    pub(super) coefficients: B::Bernstein<[B::Scalar; 2]>,
    pub(super) noise: B::Scalar,
}

impl<B: Basis> Chebyshev<B> {
    /// The number of coefficients that need not be zero in the square of a speed: its degree is `2n - 2` on a curve of
    /// degree `n`.
    pub(super) const LEN: usize = if B::DEGREE == 0 { 0 } else { 2 * B::DEGREE - 1 };

    /// From powers, of a curve of degree [`MOST_POWERS`] or less: `zᵐ = Σ_k 2^(1-m) binomial(m, k) T(m-2k)`, half of the
    /// last one if it is that of `T0`.
    #[inline(always)]
    pub(super) fn of_powers(powers: &[B::Scalar]) -> Self {
        let mut coefficients = B::Bernstein::from_fn(|_| [B::Scalar::ZERO; 2]);
        let c = &mut coefficients.as_mut().as_flattened_mut()[..Self::LEN];
        for (m, &power) in powers[..Self::LEN].iter().enumerate() {
            for (j, c) in c.iter_mut().enumerate() {
                if j <= m && (m - j).is_multiple_of(2) {
                    *c = *c + power * B::Scalar::of(POWERS[m][j]);
                }
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

    /// A rule whose error is proved to be at most `accuracy`, likewise, from one ellipse for each of the first rules: the
    /// smallest on which the error is small enough if the square of the speed is nowhere on it more than [`MOST`] times its
    /// mean. This takes a fraction of the time of [`rule`](Self::rule), which finds others.
    #[inline(always)]
    pub(super) fn single(&self, accuracy: B::Scalar) -> Option<&'static Rule> {
        let mean = self.mean()?;
        // The square of the accuracy in units of the largest speed is at least a power of two, of which the exponent is even.
        let least = (accuracy * accuracy / (mean * B::Scalar::of(MOST))).to_f64();
        let exponent = (1023_u64).saturating_sub(least.to_bits() >> 52) as usize;
        let row = RHO.get(exponent.div_ceil(2))?;
        let mut rho = row.map(B::Scalar::of);
        let mut inverse = rho.map(|rho| B::Scalar::ONE / (rho * rho));
        let change = self.largest_change(rho, inverse);
        // Rounding errors have their part of the margin.
        let (margin, most) = (B::Scalar::of(0.99), B::Scalar::of(0.99 * (MOST - 1.0)));
        let mut steady = change.map(|change| change < mean * margin);
        let mut next = self.opposites();
        for level in 1..=2 {
            for k in 0..FIRST {
                rho[k] = rho[k] * rho[k];
                inverse[k] = inverse[k] * inverse[k];
            }
            let Some(mean) = next.mean() else { break };
            let change = next.largest_change(rho, inverse);
            for k in 0..FIRST {
                steady[k] |= change[k] < mean * margin;
            }
            if level < 2 {
                next = next.opposites();
            }
        }
        (0..FIRST).find(|&k| steady[k] && change[k] < mean * most).map(|k| &RULES[k])
    }

    /// `Σ_{j≥1} |cj| (ρʲ + ρ⁻ʲ)/2` or a little more, for several `ρ`, of which the inverse squares are given.
    #[inline(always)]
    fn largest_change(&self, rho: [B::Scalar; FIRST], inverse: [B::Scalar; FIRST]) -> [B::Scalar; FIRST] {
        let mut sums = [B::Scalar::ZERO; FIRST];
        for &c in self.coefficients.as_ref().as_flattened()[1..Self::LEN].iter().rev() {
            let largest = c.abs() + self.noise;
            for k in 0..FIRST {
                sums[k] = (sums[k] + largest) * rho[k];
            }
        }
        let half = B::Scalar::of(0.5);
        for k in 0..FIRST {
            sums[k] = sums[k] * (half + half * inverse[k]);
        }
        sums
    }

    /// The first coefficient, if it is positive for certain.
    #[inline(always)]
    pub(super) fn mean(&self) -> Option<B::Scalar> {
        let mean = *self.coefficients.as_ref().as_flattened().first()? - self.noise;
        (mean > B::Scalar::ZERO).then_some(mean)
    }

    /// `Σ_{j≥1} |cj| (ρʲ + ρ⁻ʲ)/2` for each `ρ`; in one loop for all, without a branch.
    #[inline]
    fn largest_changes(&self, radii: &[[f64; ELLIPSES.len()]; 2]) -> [B::Scalar; ELLIPSES.len()] {
        let [rho, stretch] = radii;
        let mut sums = [B::Scalar::ZERO; ELLIPSES.len()];
        for &c in self.coefficients.as_ref().as_flattened()[1..Self::LEN].iter().rev() {
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
    #[inline(always)]
    fn opposites(&self) -> Self {
        let half = B::Scalar::of(0.5);
        let c = &self.coefficients.as_ref().as_flattened()[..Self::LEN];
        let mut product = B::Bernstein::from_fn(|_| [B::Scalar::ZERO; 2]);
        let p = product.as_mut().as_flattened_mut();
        let mut absolute = B::Scalar::ZERO;
        for (a, &size) in c.iter().enumerate() {
            absolute = absolute + size.abs() + self.noise;
            let ca = if a % 2 == 0 { size } else { -size };
            let square = ca * size * half;
            p[0] = p[0] + square;
            p[a] = p[a] + square;
            for b in 0..c.len() {
                if b < a && (a - b).is_multiple_of(2) {
                    let both = ca * c[b];
                    p[a.midpoint(b)] = p[a.midpoint(b)] + both;
                    p[(a - b) / 2] = p[(a - b) / 2] + both;
                }
            }
        }
        let count = B::Scalar::from_usize(Self::LEN);
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
