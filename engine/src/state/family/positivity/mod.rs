//! Whether functions are totally positive: the proofs and the counterexamples, in the order in which they are looked for.

pub(super) mod chebyshev;
pub(super) mod minors;
pub(super) mod wronskian;

use basis_prover::collections::list::Listed;
use basis_prover::within;

use super::proved::proved;
use super::refuted::{refuted_alone, refuted_among, refuted_under_premises};
use super::{Saying, Where, is_wider, said};
use crate::claim::Claim;
use crate::model::Family;
use crate::state::proofs::all;
use crate::state::verdict::Verdict;

/// Decides whether functions are totally positive.
pub(super) fn decide(family: &Family, claim: &Claim) -> Verdict {
    // Beside sines and exponentials, the search for a proof takes all the work that there is.
    if chebyshev::is_mixed(family)
        && let Some(verdict) = within(wronskian::FIRST_LOOK, &mut || refuted_by_wronskians(family, claim))
    {
        return verdict;
    }
    let by = |mut ways: Vec<usize>| {
        let enough = said(family, claim, &mut Saying::Found(&mut ways))?;
        let shown = all(enough.into_iter().map(|s| s.stated).listed(), family.budget).ok()?;
        Some(proved(family, claim, shown, ways))
    };
    let wronskians = || by(vec![wronskian::BY_WRONSKIANS]);
    let found = if chebyshev::is_mixed(family) {
        within(wronskian::FIRST_PROOF, &mut || wronskians()).or_else(|| by(Vec::new()))
    } else {
        by(Vec::new())
    };
    if let Some(verdict) = found {
        return verdict;
    }
    if let Some(witness) = basis_prover::working(family.budget, &mut |work| minors::refutation(family, work))
    {
        return Verdict::Refuted(Box::new(witness));
    }
    if let Some(verdict) = within(wronskian::WORK, &mut || refuted_by_wronskians(family, claim)) {
        return verdict;
    }
    if let Some(verdict) = wronskians() {
        return verdict;
    }
    Verdict::Undecided(String::from(if family.functions.len() > minors::MAX_FUNCTIONS {
        minors::TOO_MANY
    } else if chebyshev::is_mixed(family) {
        chebyshev::OPEN
    } else {
        minors::OPEN
    }))
}

/// That functions are not totally positive by a Wronskian that is negative at a point.
fn refuted_by_wronskians(family: &Family, claim: &Claim) -> Option<Verdict> {
    let all = said(family, claim, &mut Saying::Plainly)?;
    let assumed = all.iter().any(|s| !s.piece.is_exact());
    let plain = all.iter().filter(|s| !is_wider(family, &s.stated.statement)).listed();
    let found = if assumed {
        refuted_under_premises(family, claim, &plain)
    } else {
        plain.into_iter().find_map(|s| refuted_alone(family, claim, s))
    };
    found.or_else(|| refuted_among(family, claim, all, false, Where::Everywhere))
}
