//! Counterexamples to what is said under premises, among some points and downhill from the best of them.

use basis_kernel::Statement;
use basis_prover::collections::list::Mapped;
use basis_prover::{Coordinate, Counterexample, refute};
use core::cmp::Ordering;
use std::rc::Rc;

use super::points::{directions, fits, ranges, sample, values};
use super::touching;
use crate::algebra::poly::{PolyExt as _, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

/// Steps that are tried on the way down.
const MAX_TRIES: usize = 3000;

/// A counterexample to an equation, or to a statement about a sign, under premises, among some points.
pub(in crate::state) fn counterexample(statement: &Statement, work: &mut Work) -> Option<Counterexample> {
    let (value, relation, domain) = match statement {
        Statement::Sign { value, relation, domain } => (value, Some(relation), domain),
        Statement::Zero { value, domain } => (value, None, domain),
        Statement::Products { .. } | Statement::Independent { .. } => return None,
    };
    if domain.premises.is_empty() {
        return None;
    }
    let points = sample(value, domain)?;
    let f = values(&value.numerator, &value.denominator, &points)?;
    let counts =
        |point: &Vec<Rational>| domain.premises.iter().all(|(g, relation)| relation.holds(&g.eval(point)));
    // Of points with the same value the one that is farthest inside has the most room around it.
    let room = |point: &Vec<Rational>| domain.premises.iter().map(|(g, _)| g.eval(point)).min();
    let at = |point: &[Rational], work: &mut Work| {
        let ranges = ranges(domain);
        let coordinates = ranges.mapped(|(var, _)| (*var, Coordinate::Rational(point[var.0].clone())));
        refute(&Rc::new(statement.clone()), &coordinates, work)
    };
    let Some(relation) = relation else {
        let differs = points.iter().zip(f).filter(|(_, f)| f.as_ref().is_some_and(|f| !f.is_zero()));
        let inside = differs.map(|(point, _)| point).filter(|point| counts(point));
        return at(inside.max_by_key(|point| room(point))?, work);
    };
    let mut best: Option<(Vec<Rational>, Rational)> = None;
    for (point, f) in points.iter().zip(f) {
        let Some(f) = f else { continue };
        let better = best.as_ref().is_none_or(|(known, least)| match f.cmp(least) {
            Ordering::Equal => room(point) > room(known),
            order => order == Ordering::Less,
        });
        if better && counts(point) {
            best = Some((point.clone(), f));
        }
    }
    let (mut point, mut least) = best?;
    // Downhill in smaller and smaller steps.
    let ranges = ranges(domain);
    let moving =
        |(var, _): &&(Var, Range)| value.numerator.depends_on(*var) || value.denominator.depends_on(*var);
    let moving: Vec<&(Var, Range)> = ranges.iter().filter(moving).collect();
    let directions = directions(moving.len());
    let finest = if moving.len() <= 2 { 28 } else { 14 };
    let mut step = Rational::new(1, 16);
    let mut tries = 0;
    while tries < MAX_TRIES && relation.holds(&least) {
        let mut lower = None;
        for direction in &directions {
            let mut next = point.clone();
            for ((var, range), steps) in moving.iter().zip(direction) {
                let width = range.finite().map_or(Rational::ONE, |(low, high)| high - low);
                next[var.0] += &(&(&step * &width) * &Rational::from(*steps));
            }
            tries += 1;
            let inside = ranges.iter().all(|(var, range)| range.contains(&next[var.0]));
            if !inside || !fits(domain, &next) || !counts(&next) {
                continue;
            }
            if let Some(Some(f)) = values(&value.numerator, &value.denominator, &[next.clone()])?.pop()
                && (f < least || f == least && room(&next) > room(&point))
            {
                lower = Some((next, f));
                break;
            }
        }
        match lower {
            Some(better) => (point, least) = better,
            None if step.denom().bits() > finest => break,
            None => step = &step * &Rational::new(1, 2),
        }
    }
    if relation.holds(&least) {
        return touching::counterexample(&Rc::new(statement.clone()), &ranges, &point, work);
    }
    at(&point, work)
}
