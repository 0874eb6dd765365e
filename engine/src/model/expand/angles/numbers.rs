//! π, exp(r), tan(r) and tan(π/n), as variables between bounds.

use super::limits::Limits;
use super::rate::between_numbers;
use super::survey::{Use, Uses};
use crate::algebra::poly::Var;
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::model::angle::Kind;
use crate::model::angle::enclosure::pi_bounds;
use crate::model::scope::Scope;
use basis_prover::collections::list::Listed;

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

/// The number tan(r) of which the tangents at the ends of all ranges are made that end in numbers.
pub(super) fn tangent(scope: &mut Scope<'_>, all: &[Option<Use>], limits: &[Limits]) {
    let mut unit = Rational::ZERO;
    for (of, ends) in all.iter().zip(limits) {
        let Some(of) = of.as_ref().filter(|of| of.kind == Kind::Circular) else { continue };
        let Some(rate) = between_numbers(&of.unit, &ends.iter().flatten().listed()) else { continue };
        for end in ends.iter().flatten() {
            unit = unit.gcd(&(&end.value.number * &rate));
        }
    }
    if !unit.is_zero() {
        scope.analytic.tangent = Some((Var(scope.names.len()), unit.clone()));
        scope.names.push(format!("tan({unit})"));
    }
}

/// Limits of the numbers.
pub(super) fn ranges(scope: &Scope<'_>) -> Vec<(Var, Range)> {
    // Short numbers: those of the series have hundreds of bits.
    let open = |(low, high): (Rational, Rational)| Range {
        low: End::Excluded(rounded(&low, false)),
        high: End::Excluded(rounded(&high, true)),
    };
    let mut all = Vec::new();
    if let Some(pi) = scope.analytic.pi {
        all.push((pi, open(pi_bounds().clone())));
    }
    if let Some((var, exponent)) = &scope.analytic.exponential
        && let Some(bounds) = exponential_bounds(exponent)
    {
        all.push((*var, open(bounds)));
    }
    if let Some((var, angle)) = &scope.analytic.tangent
        && let Some(bounds) = tangent_bounds(angle)
    {
        all.push((*var, open(bounds)));
    }
    for root in &scope.analytic.roots {
        all.push((root.var, open((root.number.low().clone(), root.number.high().clone()))));
    }
    all
}

/// How often the series of exp is squared: r is at most 2⁹ = 512, and exp(r) has 739 binary digits before the point.
const SQUARINGS: u32 = 10;

/// Numbers below and above exp(r), r > 0, from the series of exp(r/2^k), r/2^k ≤ 1/2; `None` for large r.
pub(super) fn exponential_bounds(r: &Rational) -> Option<(Rational, Rational)> {
    const TERMS: u32 = 16;
    let half = Rational::new(1, 2);
    let (mut x, mut squarings) = (r.clone(), 0);
    while x > half {
        x = &x * &half;
        squarings += 1;
        if squarings > SQUARINGS {
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

/// Numbers below and above tan(r), 0 < r < π/2, from the series of sin r and cos r; `None` where cos r is nearly 0.
pub(super) fn tangent_bounds(r: &Rational) -> Option<(Rational, Rational)> {
    const TERMS: i64 = 16;
    let square = r * r;
    // The terms become smaller from the second one on, with alternating signs: two partial sums lie on both sides.
    let sums = |first: Rational, from: i64| {
        let (mut term, mut before, mut sum) = (first.clone(), Rational::ZERO, first);
        for k in 0..TERMS {
            let n = from + 2 * k;
            term = -&(&(&term * &square) * &Rational::new(1, (n + 1) * (n + 2)));
            before = sum.clone();
            sum += &term;
        }
        if before < sum { (before, sum) } else { (sum, before) }
    };
    let (sin, cos) = (sums(r.clone(), 1), sums(Rational::ONE, 0));
    if !cos.0.is_positive() {
        return None;
    }
    Some((rounded(&sin.0.checked_div(&cos.1)?, false), rounded(&sin.1.checked_div(&cos.0)?, true)))
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
    use crate::algebra::rational::ToFloat as _;

    #[test]
    fn numbers_lie_between_their_bounds() {
        for r in
            [Rational::new(1, 7), Rational::ONE, Rational::from(3), Rational::from(20), Rational::from(500)]
        {
            let (low, high) = exponential_bounds(&r).expect("not too large");
            let x = r.to_f64().exp();
            assert!(low.to_f64() <= x * (1.0 + 1e-14) && x * (1.0 - 1e-14) <= high.to_f64(), "{r}");
            assert!((&high - &low).to_f64() < 1e-9 * x, "{r}");
        }
        for r in [Rational::new(1, 100), Rational::new(1, 2), Rational::ONE, Rational::new(157, 100)] {
            let (low, high) = tangent_bounds(&r).expect("below a quarter turn");
            let x = r.to_f64().tan();
            assert!(low < high && (&high - &low).to_f64() < 1e-18 * x, "{r}");
            assert!(low.to_f64() <= x * (1.0 + 1e-12) && x * (1.0 - 1e-12) <= high.to_f64(), "{r}");
        }
        assert!(tangent_bounds(&Rational::new(355, 226)).is_none());
    }
}
