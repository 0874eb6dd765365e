//! Witnesses of false claims about families: the point with its names, the value for reading, and what plays no part.

use std::rc::Rc;

use basis_kernel::Statement;
use basis_prover::{Coordinate, Counterexample};

use super::point::{domain_names, named_point};
use super::{beside, identity, independent, with_numbers, without_numbers};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::claim::{ClaimKind, Comparison, Difference};
use crate::decimals;
use crate::model::angle::Angle;
use crate::model::chart::Piece;
use crate::model::{Family, Parameter};
use crate::state::inequality::{self, compared_on};
use crate::state::verdict::{self, Witness};
use basis_prover::collections::list::Listed;

/// How the expression of a statement compares with zero, as the claim has it.
fn stated_comparison(
    family: &Family,
    kind: &ClaimKind,
    of: &str,
    statement: &Statement,
    piece: &Piece,
) -> Option<Comparison> {
    let ClaimKind::Relation { differences, .. } = kind else { return Some(Comparison::Equal) };
    let (Statement::Zero { domain, .. } | Statement::Sign { domain, .. }) = statement else { return None };
    let part = (piece.clone(), Rc::clone(domain));
    let own = |(comparison, d): &&(Comparison, Difference)| {
        let (text, value) = match comparison {
            Comparison::Equal => (d.text.clone(), d.value.clone()),
            _ => without_numbers(family, d.text.clone(), d.value.clone()),
        };
        text == of && compared_on(&value, *comparison, &part).as_ref() == Some(statement)
    };
    differences.iter().find(own).map(|(comparison, _)| *comparison)
}

/// The witness that a counterexample is, to what is stated of an expression.
pub(super) fn witness(
    family: &Family,
    kind: &ClaimKind,
    (of, stated): (String, &Statement),
    found: &Counterexample,
    piece: &Piece,
) -> Witness {
    if let ClaimKind::Independent(except) = kind {
        return independent::witness(family, except, &of, found, piece);
    }
    let at = named_point(family, found, kind.fixed(), piece);
    // Of the statements of a chain several may be about one expression.
    let comparison = stated_comparison(family, kind, &of, stated, piece).unwrap_or(Comparison::Equal);
    let negated = inequality::is_negated(comparison);
    let mut witness = Witness::at_point(of.clone(), at, found, negated);
    let there = family.where_fixed(kind.fixed());
    let there = there.as_deref().unwrap_or(family);
    let whole = with_numbers(family, kind, &of);
    let factor = whole.as_ref().map(|(_, factor)| factor);
    let shown = beside::shown(family, there, found, (&witness.value, negated), factor);
    if let Some((text, factor)) = whole {
        (witness.of, witness.value) = (text, beside::about_number(family, &factor, &witness.value));
        witness.shown = witness.shown.map(|_| verdict::about(&witness.value));
    }
    witness.shown = shown.or(witness.shown);
    if matches!(kind, ClaimKind::Smooth(_)) {
        witness.idle = domain_names(family);
    }
    if let ClaimKind::Continuity(joint) = kind {
        witness.idle = domain_names(family);
        for p in &joint.free {
            let known = found.point.iter().find(|(v, _)| *v == p.var).map(|(_, c)| c.clone());
            witness.at.extend(known.map(|c| (p.name.clone(), c)));
        }
    }
    // Of Wronskians each has its own variables.
    if matches!(kind, ClaimKind::Relation { .. } | ClaimKind::TotallyPositive) {
        witness.idle = idle(family, kind.fixed(), stated);
    }
    // What `at` fixes is where it says, whatever the counterexample has for it.
    let fixed = kind.fixed();
    let fixed_point = fixed.iter().filter_map(|(var, f)| Some((*var, beside::value_at(family, found, f)?)));
    let others =
        piece.image(&found.point).into_iter().filter(|(var, _)| fixed.iter().all(|(own, _)| own != var));
    let point = others.chain(fixed_point).listed();
    witness.places = beside::places(family, kind.fixed(), &witness.at, &point);
    witness.notes = identity::notes(family, kind, &witness);
    let rational = point.iter().filter_map(|(var, c)| match c {
        Coordinate::Rational(x) => Some((*var, x.clone())),
        Coordinate::Algebraic(_) => None,
    });
    for (name, x) in beside::about(family, there, &rational.listed()) {
        if !witness.idle.contains(&name) {
            witness.notes.push(format!("{name} is about {} there", decimals::fixed(&x, 6)));
        }
    }
    witness
}

/// The names of variables that play no part in what is stated: those of the domain where none of them does, and shape parameters
/// that are related to no others, nor to a domain that does.
fn idle(family: &Family, fixed: &[(Var, Fraction)], stated: &Statement) -> Vec<String> {
    let (Statement::Zero { value, .. } | Statement::Sign { value, .. }) = stated else { return Vec::new() };
    // What `at` fixes has been put in.
    let is_fixed = |v: Var| fixed.iter().any(|(own, _)| *own == v);
    let occurs = |v: Var| is_fixed(v) || value.numerator.depends_on(v) || value.denominator.depends_on(v);
    let itself = |v: Var| family.analytic.angle(v).is_some_and(|angle| occurs(angle.itself));
    let over_domain = family.domain.iter().any(|p| occurs(p.var) || itself(p.var));
    let mut all = if over_domain { Vec::new() } else { domain_names(family) };
    let ends = |v: Var| {
        let of = |angle: &Angle| angle.var != v && (angle.low.depends_on(v) || angle.width.depends_on(v));
        over_domain && family.analytic.angles.iter().any(of)
    };
    let related = |v: Var| ends(v) || family.constraints.iter().any(|c| c.value.depends_on(v));
    let alone = |p: &&Parameter| !occurs(p.var) && !itself(p.var) && !related(p.var);
    all.extend(family.shapes.iter().filter(alone).map(|p| p.name.clone()));
    all
}
