//! π and exp(r), as variables between bounds.

use super::limits::Limits;
use super::survey::{Use, Uses};
use crate::algebra::poly::Var;
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::model::angle::Kind;
use crate::model::scope::Scope;
/// The number exp(r) in which all others are powers.
pub(super) fn exponential(scope: &mut Scope<'_>, uses: &Uses, all: &[Option<Use>], limits: &[Limits]) {
    let mut unit = Rational::ZERO;
    for number in &uses.numbers {
        unit = unit.gcd(number);
    }
    for (of, ends) in all.iter().zip(limits) {
        let Some(of) = of.as_ref().filter(|of| of.kind == Kind::Hyperbolic) else { continue };
        for end in ends.iter().flatten() {
            unit = unit.gcd(&(&end.value.number * &of.unit));
        }
    }
    if !unit.is_zero() {
        scope.analytic.exponential = Some((Var(scope.names.len()), unit.clone()));
        scope.names.push(format!("exp({unit})"));
    }
}

/// Limits of π and exp(r).
pub(super) fn ranges(scope: &Scope<'_>) -> Vec<(Var, Range)> {
    let open =
        |(low, high): (Rational, Rational)| Range { low: End::Excluded(low), high: End::Excluded(high) };
    let mut all = Vec::new();
    if let Some(pi) = scope.analytic.pi {
        all.push((pi, open(pi_bounds())));
    }
    if let Some((var, exponent)) = &scope.analytic.exponential
        && let Some(bounds) = exponential_bounds(exponent)
    {
        all.push((*var, open(bounds)));
    }
    all
}

/// Numbers below and above π, from π = 16 arctan(1/5) − 4 arctan(1/239).
pub(in crate::model::expand) fn pi_bounds() -> (Rational, Rational) {
    // The partial sums of an alternating series lie on both sides of its value.
    let arctan = |n: i64, terms: u32| {
        let x = Rational::new(1, n);
        (0..terms).fold(Rational::ZERO, |sum, k| {
            let term = &x.pow(2 * k + 1) * &Rational::new(1, i64::from(2 * k + 1));
            if k % 2 == 0 { &sum + &term } else { &sum - &term }
        })
    };
    let bound = |terms: u32| {
        let (a, b) = (arctan(5, terms), arctan(239, terms + 1));
        &(&Rational::from(16) * &a) - &(&Rational::from(4) * &b)
    };
    (bound(16), bound(15))
}

/// Numbers below and above exp(r), r > 0, from the series of exp(r/2^k), r/2^k ≤ 1/2; `None` for large r.
pub(super) fn exponential_bounds(r: &Rational) -> Option<(Rational, Rational)> {
    const TERMS: u32 = 16;
    let half = Rational::new(1, 2);
    let (mut x, mut squarings) = (r.clone(), 0);
    while x > half {
        x = &x * &half;
        squarings += 1;
        if squarings > 6 {
            return None;
        }
    }
    let (mut term, mut low) = (Rational::ONE, Rational::ONE);
    for k in 1..=TERMS {
        term = &(&term * &x) * &Rational::new(1, i64::from(k));
        low += &term;
    }
    // The rest of the series is less than its first term times 2.
    let high = &low + &(&term + &term);
    Some(
        (0..squarings).fold((low, high), |(a, b), _| (rounded(&(&a * &a), false), rounded(&(&b * &b), true))),
    )
}

/// A number with 80 binary digits after the point, not above or not below another one.
pub(super) fn rounded(x: &Rational, up: bool) -> Rational {
    let unit = Rational::from(2).pow(80);
    let scaled = (x * &unit).floor();
    let scaled = if up { &scaled + &Rational::ONE } else { scaled };
    scaled.checked_div(&unit).unwrap_or_else(|| x.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_lie_between_their_bounds() {
        let (low, high) = pi_bounds();
        assert!(low.to_f64() <= core::f64::consts::PI && core::f64::consts::PI <= high.to_f64());
        assert!(low < high && &high - &low < Rational::from(10).pow(18).recip().unwrap());
        for r in [Rational::new(1, 7), Rational::ONE, Rational::from(3), Rational::from(20)] {
            let (low, high) = exponential_bounds(&r).expect("not too large");
            let x = r.to_f64().exp();
            assert!(low.to_f64() <= x * (1.0 + 1e-14) && x * (1.0 - 1e-14) <= high.to_f64(), "{r}");
            assert!((&high - &low).to_f64() < 1e-9 * x, "{r}");
        }
    }
}
