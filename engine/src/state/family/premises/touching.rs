//! Points on the border of what is assumed at which an expression that is ≥ 0 there vanishes, such as α = β = 1/√2 for
//! 1/2 − α·β on the disk α² + β² ≤ 1: nearly always irrational, so that no search among rational points meets them.
//!
//! All variables but two have the values of a point near by. Where f(x, y) = 0 and g(x, y) = 0, x is a zero of the
//! resultant in y, and y of that in x. Which of the pairs are such points is for the kernel to see.

use basis_kernel::{Relation, Statement};
use basis_prover::collections::list::Listed;
use basis_prover::{Coordinate, Counterexample, refute};
use std::rc::Rc;

use super::points::all_ranges;
use crate::algebra::divisors::resultant::resultant;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::number;
use crate::algebra::real::roots::{isolate, linear, rational_roots};
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;

/// Zeros farther from the point near by than this part of a range are not tried.
const NEAR: (i64, i64) = (1, 8);

/// Pairs of zeros that are tried, at most.
const MAX_PAIRS: usize = 6;

/// Of higher degree no resultant is looked for.
const MAX_DEGREE: u32 = 6;

/// A counterexample to a strict inequality under premises next to a point of which the coordinates are given by variable.
pub(super) fn counterexample(
    statement: &Rc<Statement>,
    near: &[Rational],
    work: &mut Work,
) -> Option<Counterexample> {
    let Statement::Sign { value, relation: Relation::Positive, domain } = &**statement else { return None };
    let ranges = all_ranges(value, domain);
    let f = &value.numerator;
    for (g, relation) in &domain.premises {
        let own = g.variables();
        if *relation == Relation::Positive || g.total_degree() < 2 {
            continue;
        }
        // An end that is irrational, such as that of an angle.
        if let [x] = own[..] {
            let range = &ranges.iter().find(|(v, _)| *v == x)?.1;
            for end in zeros(g, x, range, &near[x.0], work).unwrap_or_default() {
                let coordinate =
                    |v: Var| if v == x { end.clone() } else { Coordinate::Rational(near[v.0].clone()) };
                let point = ranges.iter().map(|(v, _)| (*v, coordinate(*v))).listed();
                if let Some(found) = refute(statement, &point, work) {
                    return Some(found);
                }
            }
        }
        for (k, x) in own.iter().enumerate() {
            for y in &own[k + 1..] {
                let on_plane = |p: &Poly| {
                    let others = p.variables().into_iter().filter(|v| v != x && v != y);
                    others.fold(p.clone(), |p, v| p.at(v, &near[v.0]))
                };
                let (f, g) = (on_plane(f), on_plane(g));
                if f.is_zero() || f.total_degree().max(g.total_degree()) > MAX_DEGREE {
                    continue;
                }
                let found = |of: Var, without: Var, work: &mut Work| {
                    let range = &ranges.iter().find(|(v, _)| *v == of)?.1;
                    zeros(&resultant(&f, &g, without, work)?, of, range, &near[of.0], work)
                };
                let (Some(first), Some(second)) = (found(*x, *y, work), found(*y, *x, work)) else {
                    continue;
                };
                let pairs = first.iter().flat_map(|a| second.iter().map(move |b| (a, b)));
                for (a, b) in pairs.take(MAX_PAIRS) {
                    let coordinate = |v: Var| match v {
                        v if v == *x => a.clone(),
                        v if v == *y => b.clone(),
                        v => Coordinate::Rational(near[v.0].clone()),
                    };
                    let point = ranges.iter().map(|(v, _)| (*v, coordinate(*v))).listed();
                    if let Some(found) = refute(statement, &point, work) {
                        return Some(found);
                    }
                }
            }
        }
    }
    None
}

/// The zeros of a polynomial in one variable next to a number of a range.
fn zeros(p: &Poly, var: Var, range: &Range, near: &Rational, work: &mut Work) -> Option<Vec<Coordinate>> {
    let width = range.finite().map_or(Rational::ONE, |(low, high)| high - low);
    let reach = &width * &Rational::new(NEAR.0, NEAR.1);
    zeros_between(p, var, [&(near - &reach), &(near + &reach)].map(Some), work)
}

/// Those between two numbers if there are any, each of a factor of the polynomial that is as short as it is found.
pub(super) fn zeros_between(
    p: &Poly,
    var: Var,
    [low, high]: [Option<&Rational>; 2],
    work: &mut Work,
) -> Option<Vec<Coordinate>> {
    let p = Univariate::from_poly(p, var).filter(|p| !p.is_zero())?.square_free_part(work)?;
    let mut all = Vec::new();
    for factor in factors(&p, work)? {
        for mut root in isolate(&factor, low, high, work)? {
            root.detect_rational(&factor, work)?;
            let coordinate = number(&factor, &root)?;
            all.push(coordinate.map_or_else(Coordinate::Algebraic, Coordinate::Rational));
        }
    }
    Some(all)
}

/// The factors x − a of a polynomial, those x² − a of an even one, and the rest.
fn factors(p: &Univariate, work: &mut Work) -> Option<Vec<Univariate>> {
    let mut rest = p.clone();
    let mut all = Vec::new();
    let mut take = |factor: Univariate, rest: &mut Univariate| {
        if let Some(quotient) = rest.div_exact(&factor) {
            *rest = quotient;
            all.push(factor.primitive());
        }
    };
    for root in rational_roots(&rest.clone(), work)? {
        take(linear(&root), &mut rest);
    }
    let is_even = rest.coefficients().iter().skip(1).step_by(2).all(Rational::is_zero);
    if is_even && rest.degree() > 2 {
        let half = Univariate::new(rest.coefficients().iter().step_by(2).cloned().listed());
        for square in rational_roots(&half, work)? {
            take(Univariate::new(vec![-square, Rational::ZERO, Rational::ONE]), &mut rest);
        }
    }
    if !rest.is_constant() {
        all.push(rest);
    }
    Some(all)
}
