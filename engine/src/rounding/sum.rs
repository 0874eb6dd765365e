//! The roundings of long sums in Bernstein form, whose coefficients cⱼ are numbers of which bounds are known.
//!
//! *In the smaller coordinate* y ≤ 1/2 the sum is T := T − T y + tⱼ, tⱼ = cⱼ binomial(n, j) yʲ, j = 1, …, n, from T = c₀ on,
//! where what the addition loses is kept in a second number. A local error goes on with the factor (1 − y)ⁿ⁻ʲ, with which
//! |tⱼ| becomes |cⱼ|Bⱼ and |T y|, summed over the steps after the i-th, at most (i + 1)|cᵢ|Bᵢ₊₁. There are j + 1 roundings
//! in tⱼ, one in T y, and two in the difference tⱼ − T y, that of its own and that of finding what is lost, which is 0 or
//! at most the difference. With the last addition that is, to first order,
//!
//! Σⱼ ((j + 3)|cⱼ| + 3j|cⱼ₋₁|) Bⱼ + Σ |cⱼ|Bⱼ.
//!
//! A coordinate that is off by w u moves the sum by w y n Σ (cⱼ₊₁ − cⱼ) Bⱼⁿ⁻¹, at most w Σ j|cⱼ − cⱼ₋₁| Bⱼ. What is of
//! higher order is at most a multiple of n²u of Σ |cⱼ|Bⱼ with a factor below 50, and (n w)²u with one below 2: together
//! less than 1 for n ≤ 64 and n w ≤ 512. That is counted by hand; `engine/tests/proofs/rounding_of_sines.rs` looks for
//! larger errors.
//!
//! *In both coordinates* the sum is T := T s + cⱼ binomial(n, j) xʲ: at most j + 2 roundings in a term, and two in each
//! step after it. Coordinates that are off by w₀ u and w₁ u count (n − j)w₀ + j w₁ times. Where such a sum is divided
//! by that of binomial(n, j) sⁿ⁻ʲ xʲ, only the quotient of both coordinates counts, and moves the result by at most (w₀
//! + w₁) times the largest |cⱼ| times Σ |j − n x| Bⱼ ≤ √(n x s) ≤ √n/2.

use super::majorant::Known;
use super::{exact::is_float, rest};
use crate::algebra::number::binomial;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use basis_prover::collections::list::{Listed, Mapped};

/// The highest degree for which roundings are counted, and n w for which coordinates are.
const MOST: [i64; 2] = [64, 512];

/// A sum as Bernstein coefficients in one coordinate.
pub(super) struct Sum {
    /// It is at least this; of one that is not positive what its absolute value is at least.
    pub(super) low: Vec<Rational>,
    /// No term is larger than those of this.
    pub(super) size: Vec<Rational>,
    /// It is off by at most this many u.
    pub(super) error: Vec<Rational>,
}

/// Whether roundings are counted for sums of this degree.
pub(super) fn is_counted(degree: usize, off: &[Rational; 2]) -> bool {
    let n = Rational::from(i64::try_from(degree).unwrap_or(i64::MAX));
    let worse = off[0].clone().max(off[1].clone());
    n <= Rational::from(MOST[0]) && &n * &worse <= Rational::from(MOST[1])
}

fn number(k: usize) -> Rational {
    Rational::from(i64::try_from(k).unwrap_or(i64::MAX))
}

/// How many u the constant binomial(n, j) is off.
fn of_constant(n: usize, j: usize) -> usize {
    // As an `f32` a constant may be rounded twice.
    if is_float(&binomial(n as u32, j as u32)) { 0 } else { 2 }
}

/// What coefficients, or all their negatives, are at least.
fn least(coefficients: &[&Known]) -> Vec<Rational> {
    let is_negative = coefficients.iter().all(|c| !c.least.is_positive())
        && coefficients.iter().any(|c| c.least.is_negative());
    coefficients.mapped(|c| if is_negative { -&c.high() } else { c.low() })
}

impl Sum {
    /// The sum in the smaller coordinate, which is off by `off` u, from the coefficient on where it is 0.
    pub(super) fn in_smaller(coefficients: &[&Known], off: &Rational) -> Self {
        let n = coefficients.len().saturating_sub(1);
        let low = least(coefficients);
        let size = coefficients.mapped(|c| c.computed());
        let mut error = Vec::new();
        for (j, c) in coefficients.iter().enumerate() {
            let own = if j == 0 { 0 } else { j + 3 + of_constant(n, j) };
            // With the last addition, and what is of higher order.
            let mut sum = &(&number(own + 2) * &size[j]) + &c.error;
            if j > 0 {
                sum += &(&number(3 * j) * &size[j - 1]);
                sum += &(&(off * &number(j)) * &c.distance(coefficients[j - 1]));
            }
            error.push(sum);
        }
        Self { low, size, error }
    }

    /// The sum of degree 0 or 1 in both coordinates.
    pub(super) fn linear(coefficients: &[&Known], off: &[Rational; 2]) -> Self {
        let low = least(coefficients);
        let size = coefficients.mapped(|c| c.computed());
        let is_sum = coefficients.len() > 1;
        let errors = coefficients.iter().zip(off).map(|(c, off)| {
            let roundings = if is_sum { &number(3) + off } else { Rational::ZERO };
            &(&roundings * &c.computed()) + &c.error
        });
        Self { low, error: errors.listed(), size }
    }

    /// As a polynomial in a coordinate.
    pub(super) fn polynomial(coefficients: &[Rational], y: Var) -> Poly {
        let n = coefficients.len().saturating_sub(1) as u32;
        let powers = (0..=n).map(|k| {
            let sum = (0..=k).fold(Rational::ZERO, |sum, j| {
                let term = &binomial(k, j) * &coefficients[j as usize];
                if (k - j) % 2 == 0 { &sum + &term } else { &sum - &term }
            });
            &binomial(n, k) * &sum
        });
        let y = Poly::var(y);
        powers.rev().fold(Poly::zero(), |sum, c| &(&sum * &y) + &Poly::constant(c))
    }
}

/// How many u a sum in both coordinates is off, as Bernstein coefficients, whose own coefficients are at most `size`,
/// are off by `error` u, and have already been multiplied by the binomial coefficients if it `is_divided` by the sum of
/// these; `None` where that is too much to be counted. With what is of higher order.
pub(super) fn in_both(
    size: &[Rational],
    error: &[Rational],
    off: &[Rational; 2],
    is_divided: bool,
) -> Option<Vec<Rational>> {
    let n = size.len().saturating_sub(1);
    let most = size.iter().max()?.clone();
    let coordinates = |j: usize| &(&number(n - j) * &off[0]) + &(&number(j) * &off[1]);
    let roundings = |j: usize| number(2 * (n - j) + j + 2 + of_constant(n, j));
    let mut depth = Rational::ZERO;
    for (j, error) in error.iter().enumerate() {
        let own = if size[j].is_zero() { Rational::ZERO } else { error.checked_div(&size[j])? };
        depth = depth.max(&(&roundings(j) + &coordinates(j)) + &own);
    }
    let higher = rest::of_sum(&depth, &most)?;
    let mut all = Vec::new();
    // √n/2 ≤ (n/k + k)/4 for any k.
    let root = (1..=n).find(|k| k * k >= n).unwrap_or(1);
    let deviation = &(&number(n).checked_div(&number(root))? + &number(root)) * &Rational::new(1, 4);
    for (j, (size, error)) in size.iter().zip(error).enumerate() {
        let sum = &(&roundings(j) * size) + error;
        if !is_divided {
            all.push(&(&sum + &(&coordinates(j) * size)) + &higher);
            continue;
        }
        // (ΔN − C·ΔW)/(1 + η), |η| ≤ `depth` u, with the rounding of the quotient; as in file `absolute`.
        let moved = &(&(&off[0] + &off[1]) * &deviation) + &Rational::ONE;
        let first = &(&sum + &(&roundings(j) * &most)) + &(&moved * &most);
        let small = &(&depth * &rest::unit()) * &Rational::from(2);
        let grown = &Rational::ONE + &(&small + &rest::unit());
        all.push(&(&first + &(&higher * &Rational::from(2))) * &grown);
    }
    Some(all)
}
