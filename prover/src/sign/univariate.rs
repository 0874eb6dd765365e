//! Step 4: one variable, by Descartes' rule of signs; complete.

use super::outcome::Outcome;
use super::problem::{Problem, rational};
use super::subdivision::{Attempt, search};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::number;
use crate::algebra::real::roots::{Root, between_roots, isolate};
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::coordinate::Coordinate;
use crate::method::Method;
use basis_kernel::Relation;
use basis_kernel::SignProof;

/// Decides a polynomial in one variable; `None` when the work is spent.
///
/// A polynomial with multiple roots inside of the range is decided only if it is negative somewhere or p > 0 is
/// claimed: the others are the business of the factors.
pub(crate) fn decide(problem: &Problem, relation: Relation, work: &mut Work) -> Option<Outcome> {
    let [(var, range)] = &problem.ranges[..] else { return None };
    let p = Univariate::from_poly(&problem.poly, *var)?;
    let square_free = p.square_free_part(work)?;
    let mut roots = isolate(&square_free, range.low.value(), range.high.value(), work)?;
    let bad = |x: &Rational| !relation.holds(&Rational::from(i64::from(p.sign_at(x))));
    let ends =
        [&range.low, &range.high].into_iter().filter(|e| e.is_included()).filter_map(|e| e.value().cloned());
    let samples = between_roots(&roots, range.low.value(), range.high.value());
    if let Some(x) = ends.chain(samples).find(bad) {
        return Some(Outcome::Refuted(rational(vec![(*var, x)])));
    }
    if !roots.is_empty() {
        if relation == Relation::NonNegative {
            return None;
        }
        return Some(Outcome::Refuted(vec![(*var, simplest_root(&square_free, &mut roots, work)?)]));
    }
    // Without roots inside, the number of changes of sign on short enough intervals is zero.
    match search(problem, relation, usize::MAX, work) {
        Attempt::Proved(tree) => Some(Outcome::Proved(Method::Descartes, SignProof::Cuts(tree))),
        Attempt::Refuted(point) => Some(Outcome::Refuted(point)),
        Attempt::Open => None,
    }
}

/// The root that is easiest to write down: a rational one if there is any.
fn simplest_root(p: &Univariate, roots: &mut [Root], work: &mut Work) -> Option<Coordinate> {
    for root in roots.iter_mut() {
        root.detect_rational(p, work)?;
    }
    let exact = roots.iter().filter(|r| matches!(r, Root::Exact(_)));
    let best = exact.min_by_key(|r| (r.low().denom(), r.low().abs())).or(roots.first())?;
    let best = best.clone();
    coordinate(p, &best, work)
}

/// A root as a coordinate, with a short interval if it is not rational.
pub(crate) fn coordinate(p: &Univariate, root: &Root, work: &mut Work) -> Option<Coordinate> {
    Some(match number(p, root)? {
        Ok(x) => Coordinate::Rational(x),
        Err(x) => Coordinate::Algebraic(x.tidy(work)?),
    })
}

/// A zero of a polynomial in one variable on its range; `None` when it has no zero there or the work is spent.
pub(crate) fn some_zero(problem: &Problem, work: &mut Work) -> Option<Coordinate> {
    let [(var, range)] = &problem.ranges[..] else { return None };
    let p = Univariate::from_poly(&problem.poly, *var)?;
    let ends = [&range.low, &range.high].into_iter().filter(|e| e.is_included()).filter_map(|e| e.value());
    if let Some(x) = ends.into_iter().find(|x| p.sign_at(x) == 0) {
        return Some(Coordinate::Rational(x.clone()));
    }
    let square_free = p.square_free_part(work)?;
    let Range { low, high } = range;
    let mut roots = isolate(&square_free, low.value(), high.value(), work)?;
    simplest_root(&square_free, &mut roots, work)
}
