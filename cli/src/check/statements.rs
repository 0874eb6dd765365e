//! Claims of one statement together, in all orders of a family.

use basis_engine::state::{self, Part};
use basis_engine::{Claim, Verdict};

use super::prove::{Decided, DecidedClaim};

/// A claim with what it is about.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry<'a> {
    /// The family, of one order, or the theorem.
    pub(crate) item: &'a Decided,
    /// The claim.
    pub(crate) decided: &'a DecidedClaim,
}

/// The claims of a family in all its orders, divided by statement, in the order of the file, and by verdict.
pub(crate) fn parts(items: &[Decided]) -> Vec<(Part, Vec<Entry<'_>>)> {
    let of_item = |item| move |decided| Entry { item, decided };
    let all: Vec<Entry<'_>> = items.iter().flat_map(|i| i.claims.iter().map(of_item(i))).collect();
    let claims: Vec<(&Claim, &Verdict)> =
        all.iter().map(|e| (&e.decided.claim, &e.decided.verdict)).collect();
    let entries = |part: &Part| part.claims.iter().map(|k| all[*k]).collect();
    state::parts(&claims).into_iter().map(|part| (part.clone(), entries(&part))).collect()
}
