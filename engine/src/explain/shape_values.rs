//! Values of the shape parameters that count: in their ranges, in the order of a chain, and as it is assumed.

use std::rc::Rc;

use basis_kernel::{Domain, Relation, Statement, Values};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::{Coordinate, candidates, decide, typical};

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::claim::ClaimKind;
use crate::model::Family;
use crate::model::chart::Piece;
use crate::state::{self, Verdict, Witness};

/// Choices of simple numbers that are tried.
const MAX_CHOICES: usize = 4_000;

/// Whether there are shape values that count among which are these; of an irrational one, next to it.
pub(super) fn exist(family: &Family, values: &[(Var, Coordinate)]) -> bool {
    if family.constraints.is_empty() {
        return true;
    }
    let next_to = |upper: bool| {
        let value = |(var, c): &(Var, Coordinate)| match c {
            Coordinate::Rational(x) => (*var, x.clone()),
            Coordinate::Algebraic(x) => (*var, if upper { x.high() } else { x.low() }.clone()),
        };
        let fixed = values.iter().map(value).map(|(var, x)| (var, Fraction::constant(x))).listed();
        let pieces = family.pieces(&fixed, &[], true);
        pieces.iter().any(|piece| piece.is_exact() || inside(piece).is_some())
    };
    next_to(false) || values.iter().any(|(_, c)| matches!(c, Coordinate::Algebraic(_))) && next_to(true)
}

/// Simple shape values that count, away from the ends of their ranges and from where something assumed fails where that is
/// possible; nothing if none are found.
pub(super) fn simple(family: &Family) -> Vec<(Var, Rational)> {
    let pieces = family.pieces(&[], &[], true);
    pieces.iter().find_map(|piece| as_rational(&piece.image(&inside(piece)?))).unwrap_or_default()
}

/// Values, if all of them are rational.
pub(super) fn as_rational(point: &[(Var, Coordinate)]) -> Option<Values> {
    let rational = |(var, c): &(Var, Coordinate)| match c {
        Coordinate::Rational(x) => Some((*var, x.clone())),
        Coordinate::Algebraic(_) => None,
    };
    point.iter().map(rational).collect()
}

/// A point of the box of a piece that counts.
fn inside(piece: &Piece) -> Option<Vec<(Var, Coordinate)>> {
    let domain = piece.domain();
    let point = simplest(&domain).or_else(|| far_inside(&domain))?;
    Some(point.into_iter().map(|(var, x)| (var, Coordinate::Rational(x))).listed())
}

/// The point with the simplest numbers.
fn simplest(domain: &Domain) -> Option<Values> {
    let occurs = |var: &Var| domain.premises.iter().any(|(g, _)| g.depends_on(*var));
    let is_end = |range: &Range, x: &Rational| [&range.low, &range.high].iter().any(|e| e.value() == Some(x));
    let choices = domain.region.ranges.mapped(|(var, range)| {
        let (ends, inner): (Vec<Rational>, Vec<Rational>) =
            candidates(range, 3).into_iter().partition(|x| is_end(range, x));
        let mut all = [inner, ends].concat();
        if all.is_empty() {
            all.push(typical(range));
        }
        all.truncate(if occurs(var) { all.len() } else { 1 });
        (*var, all)
    });
    // Those that come early in all ranges first.
    let mut found: Option<Values> = None;
    let mut tries = 0;
    let most: usize = choices.iter().map(|(_, all)| all.len() - 1).sum();
    for rank in 0..=most {
        let mut open: Vec<(usize, Values)> = vec![(rank, Vec::new())];
        for (k, (var, all)) in choices.iter().enumerate() {
            let last = k + 1 == choices.len();
            let mut longer = Vec::new();
            for (left, point) in open {
                for (place, x) in all.iter().enumerate().take(left + 1) {
                    if !last || place == left {
                        longer.push((left - place, [&point[..], &[(*var, x.clone())]].concat()));
                    }
                }
            }
            open = longer;
            if open.len() > MAX_CHOICES {
                return found;
            }
        }
        for (_, point) in open.into_iter().filter(|(left, _)| *left == 0) {
            tries += 1;
            if tries > MAX_CHOICES {
                return found;
            }
            match room(domain, &point) {
                Some(true) => return Some(point),
                Some(false) if found.is_none() => found = Some(point),
                _ => {}
            }
        }
    }
    found
}

/// Whether a point has room on all sides; `None` where it does not count.
fn room(domain: &Domain, point: &Values) -> Option<bool> {
    let value = |p: &Poly| point.iter().fold(p.clone(), |p, (var, x)| p.at(*var, x)).as_constant();
    let mut has_room = true;
    for (g, relation) in &domain.premises {
        let value = value(g)?;
        if !relation.holds(&value) {
            return None;
        }
        has_room = has_room && value.is_positive();
    }
    Some(has_room)
}

fn far_inside(domain: &Domain) -> Option<Values> {
    let first = domain.premises.first()?;
    let point = state::inside(&first.0, domain)?;
    let value = |(var, _): &(Var, Range)| Some((*var, point.get(var.0)?.clone()));
    domain.region.ranges.iter().map(value).collect()
}

/// Whether it is proved that a polynomial vanishes at no shape values that count, where these are no box.
pub(super) fn vanishes_nowhere(family: &Family, p: &Poly) -> bool {
    let is_positive = |p: &Poly, piece: &Piece| {
        let Some(p) = piece.pull_back(p) else { return false };
        let domain = Rc::new(piece.domain());
        let positive = Statement::Sign { value: p.into(), relation: Relation::Positive, domain };
        let plain = || decide(positive.clone(), &Vec::new(), family.budget).is_ok();
        if piece.is_exact() {
            plain()
        } else {
            state::proved_from_premises(&positive, family.budget).is_some()
        }
    };
    let pieces = if family.constraints.is_empty() { Vec::new() } else { family.pieces(&[], &[], true) };
    !pieces.is_empty() && pieces.iter().all(|piece| is_positive(p, piece) || is_positive(&-p, piece))
}

/// Shape values at which a function is negative, if the claim that it is nowhere is refuted.
pub(super) fn where_negative(family: &Family, position: usize) -> Option<Values> {
    if !family.analytic.is_empty() || !family.pieces.is_empty() {
        return None;
    }
    let mut only = family.clone();
    only.functions = vec![family.functions.get(position)?.clone()];
    let Verdict::Refuted(witness) = super::verdict(&only, ClaimKind::Nonnegative) else { return None };
    of_witness(family, &witness)
}

/// The shape values of a counterexample, if all of them are rational.
pub(super) fn of_witness(family: &Family, witness: &Witness) -> Option<Values> {
    let value = |(name, c): &(String, Coordinate)| {
        let shape = family.shapes.iter().find(|p| p.name == *name)?;
        Some((shape.var, c.clone()))
    };
    as_rational(&witness.at.iter().filter_map(value).listed())
}
