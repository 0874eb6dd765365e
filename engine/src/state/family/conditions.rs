//! Claims that are proved with other conditions on the shape values than they have: with fewer, or with the same ones as they are
//! written.
//!
//! What is true at all points of a set is true at those of a part of it. A claim about λ alone, where 4 ≤ κ ≤ λ ≤ 6, follows from what
//! holds for 4 ≤ λ ≤ 6, and q > 0, where 0 < q and p² ≤ q, from the range of q. Without conditions the points are a box, on which signs
//! are decided completely; the ways away from the conditions, or the variables of a chain, only make that harder.
//!
//! Conditions are made part of a box where they can be: where p² ≤ q ≤ 2, q = p² + (2 − p²)·s. A multiple of a condition may be easier to
//! find before that, such as that of q − p² in q·(1 − t)² + 2·p·t·(1 − t) + t² = (q − p²)·(1 − t)² + (p·(1 − t) + t)².

use basis_prover::collections::list::Listed;
use basis_prover::within;

use super::proved::proved;
use super::{Said, Saying, said_of};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::claim::{Claim, ClaimKind};
use crate::model::Family;
use crate::model::chart::Constraint;
use crate::state::inequality;
use crate::state::proofs::all;
use crate::state::verdict::Verdict;

/// Other conditions, each of them a way to a proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Conditions {
    /// All of them, as they are written.
    AsWritten = 96,
    /// Those that are about shape parameters of the claim alone.
    OfItsOwn = 97,
    /// None: all values in their ranges.
    None = 98,
}

use Conditions::{AsWritten, None as Unconditional, OfItsOwn};

/// The work for one of them.
const TRIED: u64 = 2_000_000;

/// The work for a first look, before proofs with all conditions.
const FIRST_LOOK: u64 = 100_000;

/// A claim that is easy without conditions that are no part of a box, with which it may take all the work there is.
pub(super) fn proved_at_once(family: &Family, claim: &Claim) -> Option<Verdict> {
    if family.constraints.is_empty() || !is_of_points(&claim.kind) {
        return None;
    }
    if inequality::parts(family, claim.kind.fixed()).iter().all(|(piece, _)| piece.is_exact()) {
        return None;
    }
    let found = |ways| within(FIRST_LOOK, &mut || by(family, claim, ways, &mut |ways| Saying::Found(ways)));
    found(Unconditional).or_else(|| found(OfItsOwn))
}

/// A claim that is proved with other conditions.
pub(super) fn proved_with_others(family: &Family, claim: &Claim) -> Option<Verdict> {
    if family.constraints.is_empty() {
        return None;
    }
    let found = |ways| by(family, claim, ways, &mut |ways| Saying::Found(ways));
    let tried = |ways| by(family, claim, ways, &mut |ways| Saying::Tried(ways));
    found(OfItsOwn).or_else(|| found(Unconditional)).or_else(|| found(AsWritten)).or_else(|| tried(AsWritten))
}

fn by(
    family: &Family,
    claim: &Claim,
    conditions: Conditions,
    saying: &mut dyn for<'w> FnMut(&'w mut Vec<usize>) -> Saying<'w>,
) -> Option<Verdict> {
    let mut ways = Vec::new();
    let shown = within(TRIED, &mut || {
        let said = said_with(family, claim, conditions, &mut saying(&mut ways))?;
        all(said.into_iter().map(|said| said.stated).listed(), family.budget).ok()
    })?;
    ways.insert(0, conditions as usize);
    Some(proved(family, claim, shown, ways))
}

/// The conditions that the next one of some ways stands for, if it is one of these.
pub(super) fn next_of(ways: &mut core::slice::Iter<'_, usize>) -> Option<Conditions> {
    let next = *ways.as_slice().first()?;
    let found = [AsWritten, OfItsOwn, Unconditional].into_iter().find(|c| *c as usize == next)?;
    ways.next();
    Some(found)
}

/// What a claim says with other conditions; `None` where they are not others, or the claim is not only about points.
pub(super) fn said_with(
    family: &Family,
    claim: &Claim,
    conditions: Conditions,
    saying: &mut Saying<'_>,
) -> Option<Vec<Said>> {
    if conditions == AsWritten {
        let is_other =
            || !inequality::parts(family, claim.kind.fixed()).iter().all(|(p, _)| p.steps.is_empty());
        return if is_of_points(&claim.kind) && is_other() {
            said_of(family, claim, saying, &inequality::as_written)
        } else {
            None
        };
    }
    said_of(&with_fewer(family, &claim.kind, conditions)?, claim, saying, &inequality::parts)
}

/// Whether a claim is about each point by itself.
const fn is_of_points(kind: &ClaimKind) -> bool {
    matches!(kind, ClaimKind::Nonnegative | ClaimKind::Relation { .. })
}

/// The family with fewer conditions; `None` where no other ones are left than there are.
fn with_fewer(family: &Family, kind: &ClaimKind, conditions: Conditions) -> Option<Family> {
    let own = variables(family, kind)?;
    // The ends of angles are those of the functions themselves, which beyond them need not mean anything.
    let of_angle = |v: &Var| family.analytic.angles.iter().any(|a| a.var == *v || a.itself == *v);
    let always = |c: &Constraint| c.is_end || c.value.variables().iter().any(of_angle);
    let of_claim = |c: &Constraint| c.value.variables().iter().all(|v| own.contains(v));
    let stays = |c: &&Constraint| always(c) || conditions == OfItsOwn && of_claim(c);
    let constraints = family.constraints.iter().filter(stays).cloned().listed();
    let is_unconditional = constraints.iter().all(always);
    if constraints.len() == family.constraints.len() || conditions == OfItsOwn && is_unconditional {
        return None;
    }
    Some(Family { constraints, ..family.clone() })
}

/// The variables of what a claim compares with 0.
fn variables(family: &Family, kind: &ClaimKind) -> Option<Vec<Var>> {
    let of_functions = || family.functions.iter().map(|f| &f.value).listed();
    let values: Vec<&Fraction> = match kind {
        ClaimKind::Nonnegative => of_functions(),
        ClaimKind::Independent(except) if except.is_empty() => of_functions(),
        ClaimKind::Relation { differences, .. } => differences.iter().map(|(_, d)| &d.value).listed(),
        _ => return None,
    };
    let polynomials = values.into_iter().flat_map(|f| [f.numer(), f.denom()]);
    Some(polynomials.flat_map(Poly::variables).listed())
}
