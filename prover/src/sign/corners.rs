//! Step 2: a polynomial of degree 1 in a variable is decided by its restrictions to the ends of the range.

use super::outcome::{Outcome, Prove};
use super::problem::{Problem, as_rational, rational};
use super::witness;
use crate::algebra::poly::Var;
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::real::simplest::simplest_between;
use crate::budget::Budget;
use crate::coordinate::Coordinate;
use crate::method::Method;
use basis_kernel::Relation;
use basis_kernel::SignProof;

/// Of more variables the one with the most terms comes first: of h₁ ≤ h₂ ≤ …, products of y₁, y₂, …, one end leaves hardly
/// anything, where in another order both ends leave half of 2ⁿ cases.
const FEW: usize = 8;

/// Decides by the corners of one variable, if there is one of degree 1 among several.
pub(super) fn by_corners(
    problem: &Problem,
    relation: Relation,
    budget: &mut Budget,
    prove: Prove,
) -> Option<Outcome> {
    if problem.ranges.len() < 2 {
        return None;
    }
    let linear = |(v, _): &&(Var, Range)| problem.poly.degree(*v) == 1;
    let (var, range) = if problem.ranges.len() <= FEW {
        problem.ranges.iter().find(linear)?
    } else {
        let terms = |v: Var| problem.poly.terms().filter(|(m, _)| m.exponent(v) == 1).count();
        problem.ranges.iter().filter(linear).max_by_key(|(v, _)| terms(*v))?
    };
    let coefficients = problem.poly.coefficients_in(*var);
    let [_, slope] = &coefficients[..] else { return None };
    if range.low == End::Infinite && range.high == End::Infinite {
        return unbounded(problem, relation, *var, budget);
    }
    let end = |end: &End, high: bool| match end.value() {
        Some(x) => problem.fix(*var, x),
        None => problem.with(if high { slope.clone() } else { -slope }),
    };
    let mut hardest = Method::Corners;
    let mut parts = Vec::new();
    for (place, high) in [(&range.low, false), (&range.high, true)] {
        let needed = if place.is_included() { relation } else { Relation::NonNegative };
        match prove(&end(place, high), needed, budget) {
            Outcome::Proved(method, certificate) => {
                hardest = hardest.max(method);
                parts.push(Box::new(certificate));
            }
            Outcome::Refuted(point) => {
                let point = problem.with(coefficients_without(problem, *var)).complete(point);
                if let (true, Some(x)) = (place.is_included(), place.value()) {
                    let mut point = point;
                    point.push((*var, Coordinate::Rational(x.clone())));
                    return Some(Outcome::Refuted(point));
                }
                // Strictly negative at the end, and so near to it.
                let found = as_rational(&point)
                    .and_then(|p| witness::near_end(problem, relation, *var, high, &p, &mut budget.work));
                return Some(Outcome::refuted_or_spent(found.map(rational)));
            }
            unknown @ Outcome::Unknown(_) => return Some(unknown),
        }
    }
    let mut middle = None;
    if relation == Relation::Positive && !range.low.is_included() && !range.high.is_included() {
        let x = simplest_between(range.low.value(), range.high.value());
        match prove(&problem.fix(*var, &x), relation, budget) {
            Outcome::Proved(method, certificate) => {
                hardest = hardest.max(method);
                middle = Some((x, Box::new(certificate)));
            }
            Outcome::Refuted(mut point) => {
                point.push((*var, Coordinate::Rational(x)));
                return Some(Outcome::Refuted(problem.complete(point)));
            }
            unknown @ Outcome::Unknown(_) => return Some(unknown),
        }
    }
    let high = parts.pop()?;
    let low = parts.pop()?;
    Some(Outcome::Proved(hardest, SignProof::Corners { var: *var, low, high, middle }))
}

/// A polynomial in the other variables, to complete points with.
fn coefficients_without(problem: &Problem, var: Var) -> crate::algebra::poly::Poly {
    let others = problem.ranges.iter().filter(|(v, _)| *v != var);
    others.fold(crate::algebra::poly::Poly::one(), |p, (v, _)| &p + &crate::algebra::poly::Poly::var(*v))
}

/// Of degree 1 in a variable that ranges over all real numbers: negative far out wherever the slope is not zero.
fn unbounded(problem: &Problem, relation: Relation, var: Var, budget: &mut Budget) -> Option<Outcome> {
    let coefficients = problem.poly.coefficients_in(var);
    let others = problem.with(coefficients_without(problem, var));
    let point = others.nonzero_point(&coefficients[1])?;
    let slope = super::problem::value(&coefficients[1], &point);
    let mut x = Rational::from(-i64::from(slope.signum()));
    for k in 0..300 {
        budget.work.spend(problem.poly.len() as u64 * (10 + k))?;
        let mut point = point.clone();
        point.push((var, x.clone()));
        if witness::violates(problem, relation, &point) {
            return Some(Outcome::Refuted(rational(point)));
        }
        x = &x + &x;
    }
    None
}
