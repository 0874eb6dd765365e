//! Shape parameters in sin, cos, exp, sinh or cosh whose ranges end in numbers, in terms of their own tangents.
//!
//! Claims about such a parameter α are decided in y = (tanh(v·α) − low)/width, with tan in place of tanh in sin and cos, which
//! goes from 0 to 1 on its range. Evaluators compute tanh(v·α), and 1 − tanh(v·α) without a difference, so that these are what
//! formulas should be in. Proofs are shorter in it as well: exp(r) or tan(r), of which the end of the range is made, does not
//! occur then.

use std::borrow::Cow;
use std::rc::Rc;

use basis_prover::collections::list::Listed;

use super::{Angle, Kind};
use crate::algebra::divisors::gcd::gcd_all;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::real::simplest::simplest_within;
use crate::algebra::work::Work;
use crate::model::{Family, Function};

/// The work for one family.
const WORK: u64 = 50_000_000;

/// The family with the tangents of its shape parameters as variables wherever they were measured from the low end of a
/// range; `None` where the work is spent.
pub(crate) fn in_tangents(family: &Family) -> Option<Cow<'_, Family>> {
    let work = &mut Work::new(WORK);
    let mut result = Cow::Borrowed(family);
    for p in &family.shapes {
        let Some(angle) = family.analytic.angle(p.var).filter(|a| is_measured(a)) else { continue };
        let y = (&Fraction::var(p.var) - &angle.low).checked_div(&angle.width)?;
        result = Cow::Owned(replaced(&result, p.var, &y, work)?);
    }
    Some(result)
}

/// The family with the tangents of these shape parameters as variables and without an end of their ranges but 0: what holds for
/// all of these values holds for those in the declared ranges. `None` where there is no such parameter, or the ranges are not all
/// that is assumed.
pub(crate) fn wider(family: &Family) -> Option<Family> {
    let measured =
        family.shapes.iter().filter_map(|p| family.analytic.angle(p.var)).filter(|a| is_measured(a)).listed();
    if measured.is_empty() || !family.constraints.is_empty() {
        return None;
    }
    let mut wide = in_tangents(family)?.into_owned();
    for angle in measured {
        let own = wide.analytic.angles.iter_mut().find(|a| a.var == angle.var)?;
        let range = &mut wide.shapes.iter_mut().find(|p| p.var == angle.var)?.range;
        for (k, end) in [&mut range.low, &mut range.high].into_iter().enumerate() {
            if !angle.limits[k].is_zero() {
                let tangent = end.value()?.clone();
                own.ends[k] = if tangent.is_zero() { String::from("0") } else { String::new() };
                own.limits[k] = Fraction::zero();
                *end = End::Excluded(tangent);
            }
        }
    }
    Some(wide)
}

/// Whether a family has such a parameter.
pub(crate) fn has_ends(family: &Family) -> bool {
    family.shapes.iter().filter_map(|p| family.analytic.angle(p.var)).any(is_measured)
}

/// Whether the variable is not the tangent itself.
fn is_measured(angle: &Angle) -> bool {
    !angle.low.is_zero() || angle.width.as_constant() != Some(Rational::ONE)
}

/// A common denominator without a factor that is made of numbers such as exp(r) only, of which the functions have none: floats
/// would overflow by it although no value is large.
fn without_common_numbers(family: &Family, functions: &[Function], over: &Poly, work: &mut Work) -> Poly {
    let numbers = family.analytic.numbers();
    let mut parts: Vec<(Monomial, Poly)> = Vec::new();
    for (monomial, c) in over.terms() {
        let rest = numbers.iter().fold(monomial.clone(), |m, var| m.with_exponent(*var, 0));
        let number = monomial.checked_div(&rest).map(|number| Poly::term(number, c.clone()));
        let Some(number) = number else { return over.clone() };
        match parts.iter_mut().find(|(known, _)| *known == rest) {
            Some((_, sum)) => *sum = &*sum + &number,
            None => parts.push((rest, number)),
        }
    }
    let parts = parts.into_iter().map(|(_, number)| number).listed();
    let shorter = gcd_all(&parts, work)
        .filter(|common| common.as_constant().is_none())
        .and_then(|common| over.div_exact(&common));
    let is_common = |over: &Poly| functions.iter().all(|f| over.div_exact(f.value.denom()).is_some());
    shorter.filter(is_common).unwrap_or_else(|| over.clone())
}

/// Numbers beyond the tangents at the ends of a range; of exponentials −1, 0 or 1.
fn beyond(family: &Family, angle: &Angle) -> Option<[Rational; 2]> {
    let ends = [angle.low.clone(), &angle.low + &angle.width];
    let mut found = [-Rational::ONE, Rational::ONE];
    for ((tangent, beyond), up) in ends.iter().zip(&mut found).zip([false, true]) {
        let x = family.analytic.number(tangent);
        if angle.kind == Kind::Hyperbolic {
            if x.is_some_and(|x| if up { !x.is_positive() } else { !x.is_negative() }) {
                *beyond = Rational::ZERO;
            }
            continue;
        }
        let x = x?;
        let (near, far) = if x.is_negative() == up { (63, 62) } else { (65, 66) };
        let [near, far] = [near, far].map(|n| &x * &Rational::new(n, 64));
        *beyond = if near < far { simplest_within(&near, &far) } else { simplest_within(&far, &near) };
    }
    Some(found)
}

/// The family with the tangent x for y, where y is `value` in terms of x; both are called `var`.
fn replaced(family: &Family, var: Var, value: &Fraction, work: &mut Work) -> Option<Family> {
    let mut put = |f: &Fraction| f.substitute_within(var, value, work).ok()?;
    let mut over = put(&Fraction::from(family.over.clone()))?.numer().clone();
    let mut functions = Vec::new();
    for f in &family.functions {
        functions.push(Function { value: put(&f.value)?, ..f.clone() });
    }
    let mut analytic = family.analytic.clone();
    let mut tangents = [-Rational::ONE, Rational::ONE];
    for angle in &mut analytic.angles {
        if angle.var == var {
            tangents = beyond(family, angle)?;
            (angle.low, angle.width) = (Fraction::zero(), Fraction::constant(Rational::ONE));
        } else {
            (angle.low, angle.width) = (put(&angle.low)?, put(&angle.width)?);
        }
    }
    if family.is_rational() {
        // Factors that contain shape parameters only may stand below the fraction line now.
        for f in &functions {
            let rest = Fraction::new(f.value.denom().clone(), over.clone())?;
            over = &over * rest.numer();
        }
        over = without_common_numbers(family, &functions, &over, work);
    } else {
        over = Poly::one();
    }
    let mut shapes = family.shapes.clone();
    for p in shapes.iter_mut().filter(|p| p.var == var) {
        let end = |own: &End, x| if own.is_included() { End::Included(x) } else { End::Excluded(x) };
        let [low, high] = tangents.clone();
        p.range = Range { low: end(&p.range.low, low), high: end(&p.range.high, high) };
    }
    let pieces = family.pieces.iter().map(|piece| Some(Rc::new(replaced(piece, var, value, work)?)));
    let pieces = pieces.collect::<Option<Vec<_>>>()?.into_iter().listed();
    Some(Family { shapes, analytic, functions, over, pieces, ..family.clone() })
}
