//! Points of an angle that are seen to be zeros: rational multiples of π, and rational numbers.
//!
//! The tangent of q·π with a fraction q = m/n is a root of Im (1 + ix)ⁿ. Beside it the angle itself is a multiple of
//! π, which is transcendental: a function is 0 there if the coefficients of all powers of π are.

use super::interval::Interval;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::roots::isolate;
use crate::algebra::real::simplest::simplest_within;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::model::angle::{Analytic, Angle, Kind, multiple_of_pi};

/// Multiples of π are looked for with this denominator, fractions with denominators up to another one.
const PARTS: i64 = 24;
const LARGEST: i64 = 100;

/// A point that is known exactly.
pub(super) struct Exact {
    /// The angle as it is written.
    pub(super) text: String,
    /// The angle.
    pub(super) itself: Fraction,
    /// Its variable, where that is rational.
    pub(super) y: Option<Rational>,
}

/// The only zero of a function in an interval of the variable, if it is such a point; the angle is in another interval.
pub(super) fn exact(
    (analytic, angle): (&Analytic, &Angle),
    f: &Fraction,
    [y, s]: [&Interval; 2],
    work: &mut Work,
) -> Option<Exact> {
    let holds = |x: &Rational, s: &Interval| &s.low <= x && x <= &s.high;
    let number = simplest_within(&s.low, &s.high);
    let is_short = number.denom() <= Rational::from(LARGEST);
    let turns = &s.middle() * &Rational::from(PARTS);
    let turns = &turns.checked_div(&Analytic::pi())? + &Rational::new(1, 2);
    let turns = turns.floor().checked_div(&Rational::from(PARTS))?;
    let of_pi = &turns * &Analytic::pi();
    let mut ways = Vec::new();
    if is_short {
        let q = (angle.turns || number.is_zero() && angle.shift.is_zero())
            .then(|| &angle.rate * &(&number - &angle.shift));
        ways.push((number.to_string(), Fraction::constant(number), q));
    }
    if let Some(pi) = analytic.pi
        && holds(&of_pi, s)
    {
        let value = Fraction::constant(turns.clone()).mul_within(&Fraction::var(pi), work)?;
        let q = (!angle.turns).then(|| &angle.rate * &(&turns - &angle.shift));
        ways.push((multiple_of_pi(&turns), value, q));
    }
    for (text, itself, q) in ways {
        let own = f.substitute_within(angle.itself, &itself, work).ok()??;
        let tangent = q.filter(|_| angle.kind == Kind::Circular).and_then(|q| equation(angle, &q));
        let is_root =
            tangent.as_ref().and_then(|p| is_root(own.numer(), (p, angle.var, analytic.pi), y, work));
        if !own.is_zero() && is_root != Some(true) {
            continue;
        }
        let rational = tangent.and_then(|p| {
            let mut root = isolate(&p, Some(&y.low), Some(&y.high), work)?.into_iter().next()?;
            root.detect_rational(&p, work)?;
            (root.low() == root.high()).then(|| root.low().clone())
        });
        return Some(Exact { text, itself, y: rational });
    }
    None
}

/// A polynomial without multiple roots that vanishes where the tangent is that of q·π, in the variable of the angle.
fn equation(angle: &Angle, q: &Rational) -> Option<Univariate> {
    let (low, width) = (angle.low.as_constant()?, angle.width.as_constant()?);
    let n = q.denom().to_i64().filter(|n| *n <= 2 * PARTS)?;
    let x = Univariate::new(vec![low, width]);
    let (mut real, mut imaginary) = (Univariate::integers(&[1]), Univariate::default());
    for _ in 0..n {
        let minus = Rational::from(-1);
        (real, imaginary) = (real.add(&imaginary.mul(&x).scale(&minus)), imaginary.add(&real.mul(&x)));
    }
    Some(imaginary)
}

/// Whether all coefficients of powers of π vanish at the only root of a polynomial in an interval.
fn is_root(
    f: &Poly,
    (p, var, pi): (&Univariate, Var, Option<Var>),
    y: &Interval,
    work: &mut Work,
) -> Option<bool> {
    if p.sign_at(&y.low) * p.sign_at(&y.high) != -1
        || isolate(p, Some(&y.low), Some(&y.high), work)?.len() != 1
    {
        return Some(false);
    }
    let parts = pi.map_or_else(|| vec![f.clone()], |pi| f.coefficients_in(pi));
    for part in &parts {
        let common = Univariate::from_poly(part, var)?.gcd(p, work)?;
        if common.sign_at(&y.low) * common.sign_at(&y.high) != -1 {
            return Some(false);
        }
    }
    Some(true)
}
