//! Decides what has to hold while formulas are read.
//!
//! Where something is assumed that is no part of a box, a statement that fails elsewhere in the box may follow from what is assumed,
//! as claims do: by one of the ways of [`premises`], of which the number is noted.

use basis_kernel::{Domain, Statement};
use basis_prover::collections::list::Mapped as _;
use basis_prover::{
    Coordinate, Failure, Symmetries, ZeroFree, decide, refute, working, zero_between, zero_free,
};
use std::rc::Rc;

use super::family::premises::{self, NOT_DERIVED};
use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::model::obligation::{Goal, Ground, Judge, Open};

/// The judge that searches, and has what it finds checked.
#[derive(Clone, Copy, Debug)]
pub struct Prover;

impl Judge for Prover {
    fn judge(&self, goal: &Goal, budget: u32) -> Result<Option<Ground>, Open> {
        let alternatives = goal.alternatives();
        let ground = match goal {
            Goal::Nonzero(p, domain) if domain.premises.is_empty() => match zero_free(p, domain, budget) {
                ZeroFree::Proved(shown) => {
                    let alternative = alternatives.iter().position(|s| s == shown.proof.statement());
                    Ground::Alone { alternative: alternative.unwrap_or_default(), proof: shown.proof }
                }
                ZeroFree::Zero(point) => return Err(Open::Fails(point)),
                ZeroFree::Undecided(left) => return Err(Open::Undecided(left)),
            },
            Goal::Nonzero(p, domain) => nonzero_where_assumed(p, domain, &alternatives, budget)?,
            Goal::Holds(statement) => holds(statement, budget)?,
        };
        Ok(Some(ground))
    }
}

/// A statement.
fn holds(statement: &Statement, budget: u32) -> Result<Ground, Open> {
    let left = match decide(statement.clone(), &Symmetries::new(), budget) {
        Ok(shown) => return Ok(Ground::Alone { alternative: 0, proof: shown.proof }),
        Err(Failure::Refuted(found)) => return Err(Open::Fails(found.point)),
        Err(Failure::Undecided(left)) => left,
    };
    if !premises::is_assumed(statement) {
        return Err(Open::Undecided(left));
    }
    if let Some((way, proofs)) = premises::proved(statement, budget) {
        return Ok(Ground::Derived { alternative: 0, way, proofs });
    }
    Err(match working(budget, &mut |work| premises::counterexample(statement, work)) {
        Some(found) => Open::Fails(found.point),
        None => Open::Undecided(String::from(NOT_DERIVED)),
    })
}

/// That a polynomial has no zero where premises hold: it has the sign that it has at a point there, or its square is positive.
fn nonzero_where_assumed(
    p: &Poly,
    domain: &Rc<Domain>,
    alternatives: &[Statement],
    budget: u32,
) -> Result<Ground, Open> {
    let [_, _, square] = alternatives else { return Err(Open::Undecided(String::from(NOT_DERIVED))) };
    let start = premises::inside(p, domain);
    let is_negative = start.as_ref().is_some_and(|point| p.eval(point).is_negative());
    for alternative in [usize::from(is_negative), 2] {
        match decide(alternatives[alternative].clone(), &Symmetries::new(), budget) {
            Ok(shown) => return Ok(Ground::Alone { alternative, proof: shown.proof }),
            // A point at which the square is not positive is a zero.
            Err(Failure::Refuted(found)) if alternative == 2 => return Err(Open::Fails(found.point)),
            Err(_) => {}
        }
    }
    for alternative in [usize::from(is_negative), 2] {
        if let Some((way, proofs)) = premises::proved(&alternatives[alternative], budget) {
            return Ok(Ground::Derived { alternative, way, proofs });
        }
    }
    let counterexample = |statement: &Statement| {
        working(budget, &mut |work| premises::counterexample(statement, work)).map(|found| found.point)
    };
    let (Some(start), Some(other)) = (start, counterexample(&alternatives[usize::from(is_negative)])) else {
        return Err(Open::Undecided(String::from(NOT_DERIVED)));
    };
    let start: Vec<(Var, Coordinate)> =
        other.mapped(|(var, _)| (*var, Coordinate::Rational(start[var.0].clone())));
    // A zero on the way between points with different signs need not be one where the premises hold.
    let square = Rc::new(square.clone());
    let is_zero = |point: &Vec<(Var, Coordinate)>| {
        working(budget, &mut |work| refute(&square, point, work).map(|_| ())).is_some()
    };
    let ways = [zero_between(p, &other, &start, budget), zero_between(p, &start, &other, budget)];
    let zeros = [other].into_iter().chain(ways.into_iter().filter_map(ZeroFree::zero));
    let zero = zeros.into_iter().find(is_zero).or_else(|| counterexample(&square));
    Err(zero.map_or_else(|| Open::Undecided(String::from(CHANGES)), Open::Fails))
}

const CHANGES: &str = "its sign is not the same everywhere where what is assumed holds";

/// Statements of which the proofs are a ground for a goal: one of its alternatives, by the way that is given to what is enough for it.
pub fn ground_statements(goal: &Goal, alternative: usize, way: Option<usize>) -> Option<Vec<Statement>> {
    let statement = goal.alternatives().into_iter().nth(alternative)?;
    match way {
        Some(way) => premises::by(&statement, way),
        None => Some(vec![statement]),
    }
}
