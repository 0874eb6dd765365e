//! Verdicts from counterexamples.

use basis_prover::{Coordinate, Failure};

use super::witness::witness;
use super::{Said, Saying, Where, beside, is_wider, premises, said};
use crate::algebra::poly::Var;
use crate::algebra::range::End;
use crate::claim::{Claim, ClaimKind};
use crate::model::Family;
use crate::state::verdict::{Stated, Verdict, Witness};

/// That a claim is false by one of the statements that it makes, which is decided.
pub(super) fn refuted_alone(family: &Family, claim: &Claim, s: &Said) -> Option<Verdict> {
    let Stated { of, statement, symmetries, .. } = &s.stated;
    let Err(Failure::Refuted(found)) = basis_prover::decide(statement.clone(), symmetries, family.budget)
    else {
        return None;
    };
    let about = (s.of.clone(), found.refutation.statement());
    Some(refuted(witness(family, &claim.kind, about, &found, &s.piece), &s.of, of))
}

/// That an expression is not as claimed; where the label of the statement says more, of several parts, it is named.
pub(super) fn refuted(witness: Witness, of: &str, label: &str) -> Verdict {
    Verdict::Refuted(Box::new(if of == label { witness } else { witness.about(label) }))
}

/// A point at which a comparison fails that contains π, exp(r), or an angle beside its sine.
pub(super) fn refuted_beside(family: &Family, claim: &Claim, only_mixed: bool) -> Option<Verdict> {
    refuted_plainly(family, claim, only_mixed, Where::Everywhere)
}

/// The same where parameters are next to an end that is left out.
pub(super) fn refuted_next_to_ends(family: &Family, claim: &Claim) -> Option<Verdict> {
    let is_left_out = |end: &End| !end.is_included();
    let mut ends = family.shapes.iter().filter(|p| p.range.finite().is_some());
    if !ends.any(|p| is_left_out(&p.range.low) || is_left_out(&p.range.high)) {
        return None;
    }
    refuted_plainly(family, claim, false, Where::NextToEnds)
}

fn refuted_plainly(family: &Family, claim: &Claim, only_mixed: bool, at: Where) -> Option<Verdict> {
    let comparisons = matches!(claim.kind, ClaimKind::Nonnegative | ClaimKind::Relation { .. })
        && !family.analytic.is_empty();
    if !comparisons {
        return None;
    }
    refuted_among(family, claim, said(family, claim, &mut Saying::Plainly)?, only_mixed, at)
}

/// The same of the comparisons that are given.
pub(super) fn refuted_among(
    family: &Family,
    claim: &Claim,
    said: Vec<Said>,
    only_mixed: bool,
    at: Where,
) -> Option<Verdict> {
    let (s, whatever) = beside::refuted(family, claim, said, only_mixed, at)?;
    let witness = witness_whatever(family, claim, &s, whatever);
    Some(refuted(witness, &s.of, &s.stated.of))
}

/// The witness that a point is at which a statement fails whatever π and exp(r) are between their bounds.
fn witness_whatever(family: &Family, claim: &Claim, s: &Said, (found, proof): beside::Whatever) -> Witness {
    witness(family, &claim.kind, (s.of.clone(), &s.stated.statement), &found, &s.piece).whatever(proof)
}

/// A point of what is assumed at which one of the statements fails that a claim makes itself.
pub(super) fn refuted_under_premises(family: &Family, claim: &Claim, said: &[&Said]) -> Option<Verdict> {
    let (s, found) = basis_prover::working(family.budget, &mut |work| {
        let mut own = said.iter().filter(|s| !s.stated.is_stronger);
        own.find_map(|s| Some((s, premises::counterexample(&s.stated.statement, work)?)))
    })?;
    let witness = if is_wider(family, found.refutation.statement()) {
        let rational = |(var, c): &(Var, Coordinate)| match c {
            Coordinate::Rational(x) => Some((*var, x.clone())),
            Coordinate::Algebraic(_) => None,
        };
        let point: Option<Vec<_>> = found.point.iter().map(rational).collect();
        let whatever = beside::refuted_whatever(family, claim, &s.stated.statement, &point?)?;
        witness_whatever(family, claim, s, whatever)
    } else {
        let about = (s.of.clone(), found.refutation.statement());
        witness(family, &claim.kind, about, &found, &s.piece)
    };
    Some(refuted(witness, &s.of, &s.stated.of))
}
