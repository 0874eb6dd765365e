//! Simple points: where a polynomial that is not zero has a value that is not zero.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::decide::Coordinate;
use crate::model::Family;

/// A simple number inside a range, away from its ends where that is possible.
pub(super) fn simple(range: &Range) -> Rational {
    candidates(range, 1).into_iter().next().unwrap_or(Rational::ZERO)
}

/// At least `count` different numbers inside a range, simple ones first; the ends of short ranges come last.
pub(super) fn candidates(range: &Range, count: u32) -> Vec<Rational> {
    let mut list: Vec<Rational> = Vec::new();
    let mut push = |x: Rational| {
        if range.contains(&x) && !list.contains(&x) {
            list.push(x);
        }
    };
    if let Some((low, high)) = range.finite() {
        let width = high - low;
        // On the unit interval and on others without an inner whole number, halves and thirds come first.
        if width <= Rational::ONE {
            for (n, d) in [(1, 2), (1, 3), (2, 3), (1, 4), (3, 4)] {
                push(low + &(&width * &Rational::new(n, d)));
            }
        }
    }
    let parts = i64::from(count) + 2;
    if range.finite().is_some_and(|(low, high)| high - low <= Rational::ONE) {
        for k in 1..parts {
            if let Some((low, high)) = range.finite() {
                push(low + &(&(high - low) * &Rational::new(k, parts)));
            }
        }
    }
    for (n, d) in [(1, 1), (0, 1), (-1, 1), (2, 1), (-2, 1), (1, 2), (-1, 2), (3, 1), (-3, 1)] {
        push(Rational::new(n, d));
    }
    for k in 1..parts {
        match (range.low.value(), range.high.value()) {
            (Some(low), Some(high)) => push(low + &(&(high - low) * &Rational::new(k, parts))),
            (Some(low), None) => push(low + &Rational::from(k)),
            (None, Some(high)) => push(high - &Rational::from(k)),
            (None, None) => push(Rational::from(k + 3)),
        }
    }
    if list.is_empty() {
        // A range of one number.
        list.extend(range.low.value().cloned());
    }
    list
}

/// A point of the declared ranges at which a polynomial that is not zero has a value that is not zero;
/// `None` only where a range of one number makes that impossible. Fixed variables do not occur in the polynomial.
pub(super) fn nonzero(
    family: &Family,
    polynomial: &Poly,
    fixed: &[(Var, Fraction)],
) -> Option<Vec<(Var, Coordinate)>> {
    let mut rest = polynomial.clone();
    let mut point = Vec::new();
    // On a simplex the coordinates that are chosen leave less for the next one.
    let mut left = left_on_simplex(family, fixed);
    for (k, parameter) in family.shapes.iter().chain(&family.domain).enumerate() {
        if fixed.iter().any(|(v, _)| *v == parameter.var) {
            continue;
        }
        let count = rest.degree(parameter.var) + 1;
        let on_simplex = family.is_simplex() && k >= family.shapes.len();
        let range =
            if on_simplex { Range::closed(Rational::ZERO, left.clone()) } else { parameter.range.clone() };
        let value = candidates(&range, count).into_iter().find(|x| !rest.at(parameter.var, x).is_zero())?;
        rest = rest.at(parameter.var, &value);
        if on_simplex {
            left -= &value;
        }
        point.push((parameter.var, Coordinate::Rational(value)));
    }
    Some(point)
}

/// What fixed barycentric coordinates leave of 1 for the others; 1 where nothing is fixed, and on a box.
///
/// A fixed last coordinate stands among the fixed ones as another coordinate that it expresses.
pub(super) fn left_on_simplex(family: &Family, fixed: &[(Var, Fraction)]) -> Rational {
    let mut left = Rational::ONE;
    if !family.is_simplex() {
        return left;
    }
    let mut sum = Fraction::zero();
    let mut expressed = false;
    for parameter in &family.domain {
        let value = fixed.iter().find(|(v, _)| *v == parameter.var).map(|(_, f)| f);
        match value.map(|f| (f, f.as_constant())) {
            Some((_, Some(c))) => left -= &c,
            Some(_) => expressed = true,
            None => {}
        }
        sum = &sum + &value.cloned().unwrap_or_else(|| Fraction::var(parameter.var));
    }
    match sum.as_constant() {
        // The sum is 1 minus the last coordinate.
        Some(sum) if expressed => &left - &(&Rational::ONE - &sum),
        _ => left,
    }
}

/// The rational coordinates by variable; 0 for what is not rational.
pub(super) fn coordinates(point: &[(Var, Coordinate)], len: usize) -> Vec<Rational> {
    let mut all = vec![Rational::ZERO; len];
    for (var, c) in point {
        if let (Some(slot), Coordinate::Rational(x)) = (all.get_mut(var.0), c) {
            *slot = x.clone();
        }
    }
    all
}
