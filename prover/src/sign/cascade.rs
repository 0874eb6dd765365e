//! The order in which the methods are tried.

use super::bernstein::{Attempt, search};
use super::budget::Budget;
use super::certificate::Certificate;
use super::problem::{Point, Problem, as_rational, rational, simple};
use super::{Coordinate, Decision, Method, Proof, Relation, Witness};
use super::{cells, corners, factors, slices, univariate, witness};
use crate::algebra::poly::Poly;
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use crate::collections::list::Mapped;
use crate::collections::sort::sort_by;

/// What is known about a part of a claim.
pub(super) enum Outcome {
    Proved(Method, Certificate),
    /// A point of the ranges of the part; where a coordinate is irrational the value is 0.
    Refuted(Point),
    Unknown(String),
}

impl Outcome {
    /// A point, or the message that the work was spent on the way to it.
    pub(super) fn refuted_or_spent(point: Option<Point>) -> Self {
        point.map_or_else(
            || Self::Unknown(String::from("a negative value could not be made explicit")),
            Self::Refuted,
        )
    }
}

/// Decides a claim and makes its witness complete and simple.
pub(super) fn decide(p: &Poly, relation: Relation, region: &Region, budget: &mut Budget) -> Decision {
    if region.ranges.iter().any(|(_, r)| r.is_empty()) {
        return Decision::Proved(Proof { method: Method::Constant, certificate: Certificate::Empty });
    }
    let problem = Problem::new(p, region);
    match prove(&problem, relation, budget) {
        Outcome::Proved(method, certificate) => Decision::Proved(Proof { method, certificate }),
        Outcome::Refuted(point) => Decision::Refuted(explicit(p, &problem, relation, region, point)),
        Outcome::Unknown(left) => Decision::Undecided(left),
    }
}

/// The most work for making a witness simple.
const SIMPLIFYING: u64 = 2_000_000;

fn explicit(p: &Poly, problem: &Problem, relation: Relation, region: &Region, point: Point) -> Witness {
    let mut point = problem.complete(point);
    if let Some(exact) = as_rational(&point) {
        point = rational(witness::simplify(
            problem,
            relation,
            exact,
            &mut crate::algebra::work::Work::new(SIMPLIFYING),
        ));
    }
    for (var, range) in &region.ranges {
        if !point.iter().any(|(v, _)| v == var) {
            point.push((*var, Coordinate::Rational(simple(range))));
        }
    }
    for var in p.variables() {
        // A variable that occurs has a coordinate by now, except where the polynomial lost it.
        if !point.iter().any(|(v, _)| *v == var) {
            point.push((var, Coordinate::Rational(Rational::ZERO)));
        }
    }
    sort_by(&mut point, |a, b| a.0.cmp(&b.0));
    let value = as_rational(&point).map_or(Rational::ZERO, |exact| super::problem::value(p, &exact));
    Witness { point, value }
}

/// The number of cuts before the complete methods are tried, by the number of variables.
const fn first_cuts(variables: usize) -> usize {
    match variables {
        0..=2 => 40,
        3 => 200,
        _ => 1000,
    }
}

/// Decides a part of a claim.
pub(super) fn prove(problem: &Problem, relation: Relation, budget: &mut Budget) -> Outcome {
    if let Some(value) = problem.poly.as_constant() {
        return if relation.holds(&value) {
            Outcome::Proved(Method::Constant, Certificate::Constant)
        } else {
            Outcome::Refuted(Point::new())
        };
    }
    if budget.allows(Method::Coefficients)
        && let Some(outcome) = by_subdivision(problem, relation, 0, Method::Coefficients, budget)
    {
        return outcome;
    }
    if budget.allows(Method::Corners)
        && let Some(outcome) = corners::by_corners(problem, relation, budget)
    {
        return outcome;
    }
    if budget.allows(Method::Factors)
        && let Some(outcome) = factors::by_factors(problem, relation, budget)
    {
        return outcome;
    }
    if problem.ranges.len() == 1 {
        let found = univariate::decide(problem, relation, &mut budget.work);
        return found.unwrap_or_else(|| spent(problem, "one variable"));
    }
    if budget.allows(Method::Subdivision) {
        let cuts = first_cuts(problem.ranges.len());
        let mut part = budget.take(budget.left() / 4);
        let found = by_subdivision(problem, relation, cuts, Method::Subdivision, &mut part);
        budget.put_back(&part);
        if let Some(outcome) = found {
            return outcome;
        }
    }
    let complete = match relation {
        Relation::NonNegative if budget.allows(Method::Cells) => {
            let mut part = budget.take(budget.left() / 4 * 3);
            let found = cells::by_cells(problem, &mut part);
            budget.put_back(&part);
            Some(found)
        }
        Relation::Positive => slices::by_faces(problem, budget),
        Relation::NonNegative => None,
    };
    match complete {
        Some(outcome @ (Outcome::Proved(..) | Outcome::Refuted(_))) => return outcome,
        Some(Outcome::Unknown(left)) if budget.left() == 0 => return Outcome::Unknown(left),
        _ => {}
    }
    if budget.allows(Method::Subdivision)
        && let Some(outcome) = by_subdivision(problem, relation, usize::MAX, Method::Subdivision, budget)
    {
        return outcome;
    }
    spent(problem, "the complete methods")
}

/// By Bernstein coefficients with at most so many cuts.
fn by_subdivision(
    problem: &Problem,
    relation: Relation,
    cuts: usize,
    method: Method,
    budget: &mut Budget,
) -> Option<Outcome> {
    match search(problem, relation, cuts, &mut budget.work) {
        Attempt::Proved(tree) => Some(Outcome::Proved(method, Certificate::Bernstein(tree))),
        Attempt::Refuted(point) => Some(Outcome::Refuted(point)),
        Attempt::Open => None,
    }
}

/// What is left when the work is spent.
pub(super) fn spent(problem: &Problem, on: &str) -> Outcome {
    let degrees: Vec<String> = problem.ranges.mapped(|(v, _)| problem.poly.degree(*v).to_string());
    let variables = if degrees.len() == 1 { "a variable" } else { "variables" };
    let terms = problem.poly.len();
    let left = format!(
        "the budget is spent on {on}: the sign of a polynomial with {terms} terms in {} {variables} (of degree {}) is open",
        degrees.len(),
        degrees.join(", ")
    );
    Outcome::Unknown(left)
}
