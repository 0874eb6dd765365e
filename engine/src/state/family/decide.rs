//! Decides claims about families: proofs by one way after the other, and counterexamples.

use basis_kernel::{Statement, Values};
use basis_prover::collections::list::Listed;
use basis_prover::{Failure, within_half};

use super::conditions::{proved_at_once, proved_with_others};
use super::independent::Squares;
use super::premises::NOT_DERIVED;
use super::proved::proved;
use super::refuted::{refuted, refuted_alone, refuted_beside, refuted_next_to_ends, refuted_under_premises};
#[cfg(any(test, feature = "rounding"))]
use super::rounding;
use super::witness::witness;
use super::{Said, Saying, beside, independent, is_wider, positivity, premises, said};
use crate::claim::{Claim, ClaimKind};
use crate::model::Family;
use crate::state::proofs::all;
use crate::state::verdict::Verdict;

const TOO_LONG: &str =
    "the budget is spent on a common denominator of the functions, or on ranges that depend on one another";

/// Why a claim about functions with variables beside their sines is open.
const BESIDE: &str = "no proof was found by derivatives and by bounds for what stands beside its sine or exponential, and no point \
                      where it fails";

/// What is left where a proof for all values is not found.
const WIDER: &str =
    "it is not seen from bounds for pi, exp, or for a variable beside its sine or exponential";

/// Decides a claim about one span.
pub(super) fn decide(family: &Family, claim: &Claim) -> Verdict {
    if let Some(verdict) = proved_at_once(family, claim) {
        return verdict;
    }
    match decided(family, claim) {
        Verdict::Undecided(left) => proved_with_others(family, claim).unwrap_or(Verdict::Undecided(left)),
        verdict => verdict,
    }
}

/// The same by proofs for the shape values that the claim is about.
fn decided(family: &Family, claim: &Claim) -> Verdict {
    #[cfg(any(test, feature = "rounding"))]
    if let ClaimKind::Rounding(epsilons) = &claim.kind {
        return rounding::decide(family, epsilons);
    }
    if matches!(claim.kind, ClaimKind::TotallyPositive) {
        return positivity::decide(family, claim);
    }
    if let Some((shown, ways)) = beside::proved_at_once(family, claim) {
        return proved(family, claim, shown, ways);
    }
    if let Some(verdict) = refuted_beside(family, claim, true) {
        return verdict;
    }
    let mut ways = Vec::new();
    let Some(mut said) = said(family, claim, &mut Saying::Found(&mut ways)) else {
        return match claim.kind {
            ClaimKind::Independent(_) => Verdict::Undecided(String::from(independent::NOT_IN_PARTS)),
            _ => Verdict::Undecided(String::from(TOO_LONG)),
        };
    };
    // Where what is assumed is no part of a box, the claim itself is looked at if what would be enough is not proved.
    let assumed = said.iter().any(|s| !s.piece.is_exact());
    if assumed {
        let stated = said.iter().map(|s| s.stated.clone()).listed();
        if let Ok(shown) = within_half(&mut || all(stated.clone(), family.budget)) {
            return proved(family, claim, shown, ways);
        }
        if let ClaimKind::Independent(except) = &claim.kind
            && let Some(verdict) = decided_by_squares(family, claim, except)
        {
            return verdict;
        }
        said = self::said(family, claim, &mut Saying::Plainly).unwrap_or(said);
        ways = Vec::new();
        let is_sign = |s: &&Said| matches!(s.stated.statement, Statement::Sign { .. });
        if let Some(verdict) = refuted_under_premises(family, claim, &said.iter().filter(is_sign).listed()) {
            return verdict;
        }
        if let Some(verdict) = proved_by_later_ways(family, claim) {
            return verdict;
        }
    }
    let labels = said.iter().map(|s| (s.stated.of.clone(), s.of.clone(), s.piece.clone())).listed();
    let find = |of: &str| labels.iter().find(|(label, ..)| label == of);
    let stronger: Vec<String> =
        said.iter().filter(|s| s.stated.is_stronger).map(|s| s.stated.of.clone()).listed();
    let open = |s: &&Said| !s.stated.is_stronger && is_wider(family, &s.stated.statement);
    let beside: Vec<String> = said.iter().filter(open).map(|s| s.stated.of.clone()).listed();
    let stated = said.iter().map(|s| s.stated.clone()).listed();
    match all(stated, family.budget) {
        Ok(shown) => proved(family, claim, shown, ways),
        Err((of, Failure::Refuted(found)))
            if stronger.contains(&of) || is_wider(family, found.refutation.statement()) =>
        {
            let verdict = refuted_beside(family, claim, false)
                .or_else(|| dependent_apart(family, claim))
                .or_else(|| refuted_next_to_ends(family, claim));
            verdict.unwrap_or_else(|| Verdict::Undecided(format!("`{of}`: {WIDER}")))
        }
        Err((label, Failure::Refuted(found))) => {
            let Some((_, of, piece)) = find(&label) else { return Verdict::Undecided(label) };
            if matches!(claim.kind, ClaimKind::Independent(_)) && !piece.is_exact() {
                return Verdict::Undecided(String::from(
                    "the functions are dependent at values that the assumptions may rule out",
                ));
            }
            let there = family.where_fixed(claim.kind.fixed());
            let found = beside::genuine(there.as_deref().unwrap_or(family), *found);
            let about = (of.clone(), found.refutation.statement());
            let witness = witness(family, &claim.kind, about, &found, piece);
            refuted(witness, of, &label)
        }
        Err((of, Failure::Undecided(left))) => Verdict::Undecided(match &claim.kind {
            ClaimKind::Independent(_) => match dependent_apart(family, claim) {
                Some(verdict) => return verdict,
                None => left,
            },
            _ if assumed => {
                // Of an equation simple points come first, which need not be among those that are assumed.
                let verdict = refuted_under_premises(family, claim, &said.iter().listed());
                let verdict = verdict.or_else(|| refuted_beside(family, claim, false));
                let verdict = verdict.or_else(|| refuted_next_to_ends(family, claim));
                return verdict.unwrap_or_else(|| Verdict::Undecided(format!("`{of}`: {NOT_DERIVED}")));
            }
            ClaimKind::Relation { .. } | ClaimKind::Nonnegative if beside.contains(&of) => {
                match refuted_next_to_ends(family, claim) {
                    Some(verdict) => return verdict,
                    None => format!("`{of}`: {BESIDE}"),
                }
            }
            _ => format!("`{of}`: {left}"),
        }),
    }
}

/// A claim that is proved by other ways from what is assumed than the first ones.
fn proved_by_later_ways(family: &Family, claim: &Claim) -> Option<Verdict> {
    let mut ways = Vec::new();
    let said = said(family, claim, &mut Saying::Tried(&mut ways))?;
    // By the first ways these are the statements that are not proved.
    if premises::are_first(&ways) {
        return None;
    }
    let stated = said.into_iter().map(|s| s.stated).listed();
    all(stated, family.budget).ok().map(|shown| proved(family, claim, shown, ways))
}

/// Whether functions are independent where what is assumed holds, by one inequality.
fn decided_by_squares(family: &Family, claim: &Claim, except: &[Values]) -> Option<Verdict> {
    let found = squares_proved(family, claim, except, &mut |s, _| premises::without(s));
    if found.is_some() {
        return found;
    }
    let plain = independent::by_squares(family, except, Squares::Plain, &mut premises::without)?;
    refuted_under_premises(family, claim, &plain.iter().listed())
        .or_else(|| squares_proved(family, claim, except, &mut premises::tried))
}

/// What is enough for a statement where something is assumed, by a way of which the number may be noted.
type Away<'a> = dyn FnMut(&Statement, &mut Vec<usize>) -> Option<Vec<Statement>> + 'a;

/// The proof of one of these inequalities by some ways away from what is assumed, which are noted.
fn squares_proved(family: &Family, claim: &Claim, except: &[Values], away: &mut Away<'_>) -> Option<Verdict> {
    let mut tried = Vec::new();
    for (of, way) in independent::BY_SQUARES.into_iter().zip(1..) {
        let mut ways = vec![way];
        let enough = independent::by_squares(family, except, of, &mut |s| away(s, &mut ways))?;
        let stated = enough.into_iter().map(|said| said.stated).listed();
        let statements = stated.iter().map(|stated| stated.statement.clone()).listed();
        if core::mem::replace(&mut tried, statements.clone()) == statements {
            continue;
        }
        if let Ok(shown) = all(stated, family.budget) {
            return Some(proved(family, claim, shown, ways));
        }
    }
    None
}

/// That functions are dependent whatever the numbers are that occur in them.
fn dependent_apart(family: &Family, claim: &Claim) -> Option<Verdict> {
    if !matches!(&claim.kind, ClaimKind::Independent(except) if except.is_empty()) {
        return None;
    }
    independent::apart(family).iter().find_map(|s| refuted_alone(family, claim, s))
}
