//! Simple points: where a value that is not zero everywhere is defined and not zero.

use crate::collections::list::Listed;
use basis_kernel::{Domain, Quotient};

use crate::algebra::poly::Var;
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::collections::sort::sort_by;
use crate::coordinate::Coordinate;

/// At least `count` different numbers inside a range, simple ones first; the ends of short ranges come last.
pub fn candidates(range: &Range, count: u32) -> Vec<Rational> {
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

/// A simple number inside a range, away from its ends where that is possible.
pub fn typical(range: &Range) -> Rational {
    candidates(range, 1).into_iter().next().unwrap_or(Rational::ZERO)
}

/// A point of a domain without premises at which a value is defined and not zero; `None` only where a range of one
/// number makes that impossible.
pub(crate) fn nonzero(value: &Quotient, domain: &Domain) -> Option<Vec<(Var, Coordinate)>> {
    // Variables with a single value leave no choice; on a simplex the coordinates that are chosen leave less for the
    // next one.
    let mut choices: Vec<(Var, Option<usize>, Range)> = Vec::new();
    for (var, range) in &domain.region.ranges {
        choices.push((*var, None, range.clone()));
    }
    for (k, simplex) in domain.simplices.iter().enumerate() {
        choices.extend(simplex.variables.iter().map(|v| (*v, Some(k), Range::all())));
    }
    for var in value.numerator.variables().into_iter().chain(value.denominator.variables()) {
        if choices.iter().all(|(v, ..)| *v != var) {
            choices.push((var, None, Range::all()));
        }
    }
    let single = |range: &Range| range.finite().is_some_and(|(low, high)| low == high);
    sort_by(&mut choices, |a, b| (!single(&a.2), a.0).cmp(&(!single(&b.2), b.0)));
    let mut rest = [value.numerator.clone(), value.denominator.clone()];
    let mut left: Vec<Rational> = domain.simplices.iter().map(|s| s.sum.clone()).listed();
    let mut point: Vec<(Var, Coordinate)> = Vec::new();
    for (var, simplex, range) in choices {
        let range = match simplex {
            Some(k) => Range::closed(Rational::ZERO, left[k].clone()),
            None => range,
        };
        // Of more numbers than the two have zeros in this variable together, one is a zero of neither.
        let count = rest.iter().map(|p| p.degree(var)).sum::<u32>() + 1;
        let found =
            candidates(&range, count).into_iter().find(|x| rest.iter().all(|p| !p.at(var, x).is_zero()))?;
        rest = rest.map(|p| p.at(var, &found));
        if let Some(k) = simplex {
            left[k] -= &found;
        }
        point.push((var, Coordinate::Rational(found)));
    }
    sort_by(&mut point, |a, b| a.0.cmp(&b.0));
    Some(point)
}
