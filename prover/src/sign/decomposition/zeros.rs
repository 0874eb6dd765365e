//! Whether a polynomial vanishes at a point with algebraic coordinates.

use crate::algebra::bernstein::{Form, Side};
use crate::algebra::divisors::resultant::resultant;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::Algebraic;
use crate::algebra::real::roots::bound;
use crate::algebra::univariate::{ToPoly, Univariate};
use crate::algebra::work::Work;
use crate::collections::list::{Listed, Mapped};

/// What is found near a point with algebraic coordinates.
pub(crate) enum Near {
    /// The polynomial is positive on a box around the point: the ends by coordinate.
    Positive(Vec<(Rational, Rational)>),
    /// It is negative at this point.
    Negative(Vec<(Var, Rational)>),
    /// It is zero at the point itself.
    Zero(Vec<(Var, Algebraic)>),
}

/// How often the intervals are shortened to a quarter before the value is tested for zero exactly.
const ROUNDS: usize = 6;

/// Shortens the intervals until the sign is clear; `None` when the work is spent.
pub(crate) fn near(poly: &Poly, mut point: Vec<(Var, Algebraic)>, work: &mut Work) -> Option<Near> {
    for round in 0.. {
        let sides: Vec<(Var, Side)> =
            point.mapped(|(v, x)| (*v, Side::Finite(x.low().clone(), x.high().clone())));
        let form = Form::new(poly, &sides, work)?;
        if form.coefficients().iter().all(Rational::is_positive) {
            return Some(Near::Positive(point.mapped(|(_, x)| (x.low().clone(), x.high().clone()))));
        }
        if form.coefficients().iter().all(Rational::is_negative) {
            return Some(Near::Negative(point.mapped(|(v, x)| (*v, x.low().clone()))));
        }
        if round == ROUNDS && is_zero(poly, &point, work)? {
            return Some(Near::Zero(point));
        }
        for (_, x) in &mut point {
            let width = &(x.high() - x.low()) * &Rational::new(1, 3);
            x.refine_below(&width, work)?;
        }
    }
    None
}

/// Whether a polynomial is zero at a point that has an algebraic coordinate for each of its variables; `None` when the
/// work is spent.
///
/// The value is a root of W(w) = res(m₁(x₁), res(m₂(x₂), … w − p)), whose roots different from zero are not
/// arbitrarily small: the value is zero when it is smaller than all of them.
pub(crate) fn is_zero(poly: &Poly, point: &[(Var, Algebraic)], work: &mut Work) -> Option<bool> {
    let mut rest = poly.clone();
    for (var, x) in point {
        rest = reduce(&rest, *var, x.polynomial(), work)?;
    }
    if let Some(value) = rest.as_constant() {
        return Some(value.is_zero());
    }
    let value =
        Var(poly.variables().iter().chain(point.iter().map(|(v, _)| v)).map(|v| v.0 + 1).max().unwrap_or(0));
    let mut values = &Poly::var(value) - &rest;
    for (var, x) in point {
        if values.depends_on(*var) {
            values = resultant(&x.polynomial().to_poly(*var), &values, *var, work)?;
        }
    }
    let values = Univariate::from_poly(&values, value)?;
    let zeros = values.coefficients().iter().take_while(|c| c.is_zero()).count();
    if zeros == 0 {
        return Some(false);
    }
    // The reciprocals of the other roots are the roots of the reversed polynomial.
    let reversed = Univariate::new(values.coefficients()[zeros..].iter().rev().cloned().listed());
    let smallest = bound(&reversed).recip()?;
    let mut point = point.to_vec();
    loop {
        let (low, high) = enclosure(&rest, &point, work)?;
        if low.is_positive() || high.is_negative() {
            return Some(false);
        }
        if -&low < smallest && high < smallest {
            return Some(true);
        }
        for (_, x) in &mut point {
            let width = &(x.high() - x.low()) * &Rational::new(1, 8);
            x.refine_below(&width, work)?;
        }
    }
}

/// The remainder modulo a polynomial in one variable.
fn reduce(poly: &Poly, var: Var, modulus: &Univariate, work: &mut Work) -> Option<Poly> {
    let n = modulus.degree() as u32;
    let lead = modulus.leading().recip()?;
    let modulus = modulus.to_poly(var).scale(&lead);
    let mut rest = poly.clone();
    while rest.degree(var) >= n && !rest.is_zero() {
        let top = rest.coefficients_in(var).pop()?;
        let shift = Monomial::one().with_exponent(var, (rest.degree(var) - n) as u16);
        let factor = &top * &Poly::term(shift, Rational::ONE);
        work.spend_product(&factor, &modulus)?;
        rest = &rest - &(&factor * &modulus);
    }
    Some(rest)
}

/// Numbers below and above all values on the box of the intervals of the coordinates.
fn enclosure(poly: &Poly, point: &[(Var, Algebraic)], work: &mut Work) -> Option<(Rational, Rational)> {
    let mut sum = (Rational::ZERO, Rational::ZERO);
    for (m, c) in poly.terms() {
        let mut term = (c.clone(), c.clone());
        for (var, x) in point {
            for _ in 0..m.exponent(*var) {
                work.spend(8 * (1 + (term.0.bits() + x.low().bits()) / 64))?;
                let products = [&term.0, &term.1].map(|a| [a * x.low(), a * x.high()]).concat();
                let low = products.iter().min()?.clone();
                let high = products.iter().max()?.clone();
                term = (low, high);
            }
        }
        sum = (&sum.0 + &term.0, &sum.1 + &term.1);
    }
    Some(sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sqrt(n: i64, low: i64) -> Algebraic {
        let p = Univariate::integers(&[-n, 0, 1]);
        Algebraic::new(&p, Rational::from(low), Rational::from(low + 1)).expect("opposite signs")
    }

    #[test]
    fn zeros_at_irrational_points() {
        let (x, y) = (Poly::var(Var(0)), Poly::var(Var(1)));
        let n = Poly::integer;
        let point = [(Var(0), sqrt(2, 1)), (Var(1), sqrt(3, 1))];
        let work = &mut Work::unlimited();
        let zero = |p: &Poly, work: &mut Work| is_zero(p, &point, work).expect("unlimited");
        // x² y² − 6, and (x + y)² − 5 − 2xy, and x⁴ − 4
        assert!(zero(&(&(&x.pow(2) * &y.pow(2)) - &n(6)), work));
        assert!(zero(&(&(&(&x + &y).pow(2) - &n(5)) - &(&x * &y).scale(&2.into())), work));
        assert!(!zero(&(&(&x + &y) - &Poly::constant(Rational::new(3_146_264, 1_000_000))), work));
        // A zero at another pair of conjugates only: 3x² − 2y² and 3x + … vanish here, x + y − (…) does not.
        let eight = [(Var(0), sqrt(2, 1)), (Var(1), sqrt(8, 2))];
        assert_eq!(is_zero(&(&y - &x.scale(&2.into())), &eight, work), Some(true));
        assert_eq!(is_zero(&(&y + &x.scale(&2.into())), &eight, work), Some(false));
    }
}
