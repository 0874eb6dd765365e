//! The order in which the methods are tried.

use super::decomposition::{cells, slices};
use super::outcome::{Outcome, spent};
use super::problem::{Point, Problem, as_rational, rational, simple};
use super::subdivision::{self, Attempt};
use super::{corners, descent, diagonal, factors, squares, univariate, witness};
use crate::algebra::poly::Poly;
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::budget::Budget;
use crate::collections::sort::sort_by;
use crate::coordinate::Coordinate;
use crate::method::Method;
use basis_kernel::Relation;
use basis_kernel::SignProof;

/// What a search finds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Found {
    /// A proof, by this method.
    Proof(Method, SignProof),
    /// A point with a coordinate for each variable of the box and of the polynomial, in increasing order, at which the
    /// claim fails; where a coordinate is irrational, the value is 0.
    Point(Point),
    /// The budget is spent; what is left to decide, in words.
    Nothing(String),
}

/// Looks for a proof of p ≥ 0 (> 0) on a box, or for a simple point at which it fails.
pub fn search(p: &Poly, relation: Relation, region: &Region, budget: &mut Budget) -> Found {
    if region.ranges.iter().any(|(_, r)| r.is_empty()) {
        return Found::Proof(Method::Constant, SignProof::direct());
    }
    let problem = Problem::new(p, region);
    match prove(&problem, relation, budget) {
        Outcome::Proved(method, proof) => Found::Proof(method, proof),
        Outcome::Refuted(point) => Found::Point(explicit(p, &problem, relation, region, point)),
        Outcome::Unknown(left) => Found::Nothing(left),
    }
}

/// The most work for making a witness simple.
const SIMPLIFYING: u64 = 2_000_000;

fn explicit(p: &Poly, problem: &Problem, relation: Relation, region: &Region, point: Point) -> Point {
    let mut point = problem.complete(point);
    if let Some(exact) = as_rational(&point) {
        point = rational(witness::simplify(problem, relation, exact, &mut Work::new(SIMPLIFYING)));
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
    point
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
pub(crate) fn prove(problem: &Problem, relation: Relation, budget: &mut Budget) -> Outcome {
    if let Some(value) = problem.poly.as_constant() {
        return if relation.holds(&value) {
            Outcome::Proved(Method::Constant, SignProof::direct())
        } else {
            Outcome::Refuted(Point::new())
        };
    }
    if budget.allows(Method::Coefficients)
        && budget.suffices(subdivision::least_work(problem))
        && let Some(outcome) = by_subdivision(problem, relation, 0, Method::Coefficients, budget)
    {
        return outcome;
    }
    if budget.allows(Method::Corners)
        && let Some(outcome) = corners::by_corners(problem, relation, budget, prove)
    {
        return outcome;
    }
    if budget.allows(Method::Factors)
        && let Some(outcome) = factors::by_factors(problem, relation, budget, prove)
    {
        return outcome;
    }
    if problem.ranges.len() == 1 {
        let found = univariate::decide(problem, relation, &mut budget.work);
        return found.unwrap_or_else(|| spent(problem, "one variable"));
    }
    if budget.allows(Method::Squares) {
        let mut part = budget.take_sixteenths(1);
        let found = squares::by_squares(problem, relation, &mut part.work);
        budget.put_back(&part);
        if let Some(proof) = found {
            return Outcome::Proved(Method::Squares, proof);
        }
    }
    if budget.allows(Method::Subdivision) {
        let cuts = first_cuts(problem.ranges.len());
        let mut part = budget.take_sixteenths(4);
        let found = by_subdivision(problem, relation, cuts, Method::Subdivision, &mut part);
        budget.put_back(&part);
        if let Some(outcome) = found {
            return outcome;
        }
    }
    let mut part = budget.take_sixteenths(2);
    let found = diagonal::on_diagonals(problem, relation, &mut part, prove);
    budget.put_back(&part);
    if let Some(point) = found {
        return Outcome::Refuted(point);
    }
    if problem.ranges.len() > 2 {
        let mut part = budget.take_sixteenths(4);
        let found = descent::downhill(problem, relation, &mut part);
        budget.put_back(&part);
        if let Some(point) = found {
            return Outcome::Refuted(rational(point));
        }
    }
    let complete = match relation {
        Relation::NonNegative if budget.allows(Method::Cells) => {
            let mut part = budget.take_sixteenths(12);
            let found = cells::by_cells(problem, &mut part);
            budget.put_back(&part);
            Some(found)
        }
        Relation::Positive => slices::by_faces(problem, budget, prove),
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

/// By Bernstein coefficients with at most `cuts` cuts.
fn by_subdivision(
    problem: &Problem,
    relation: Relation,
    cuts: usize,
    method: Method,
    budget: &mut Budget,
) -> Option<Outcome> {
    match subdivision::search(problem, relation, cuts, &mut budget.work) {
        Attempt::Proved(tree) => Some(Outcome::Proved(method, SignProof::Cuts(tree))),
        Attempt::Refuted(point) => Some(Outcome::Refuted(point)),
        Attempt::Open => None,
    }
}
