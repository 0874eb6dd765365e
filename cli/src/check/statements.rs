//! Claims of one statement together, in all orders of a family: an `at` block or a `for` makes many, and every
//! order makes them again.

use std::collections::BTreeMap;

use basis_engine::Verdict;
use basis_engine::claim::Expected;
use basis_engine::diagnostic::Place;

use super::prove::{Decided, DecidedClaim};

/// A claim with what it is about.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entry<'a> {
    /// The family, of one order, or the theorem.
    pub(crate) item: &'a Decided,
    /// The claim.
    pub(crate) decided: &'a DecidedClaim,
}

/// A verdict seen beside what is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Kind {
    /// Proved, as declared.
    Proved,
    /// Refuted, as declared.
    Refuted,
    /// Refuted, but declared true.
    False,
    /// Proved, but declared false.
    True,
    /// Neither proved nor refuted.
    Undecided,
}

impl Kind {
    /// The verdict of a claim beside its declaration.
    pub(crate) const fn of(decided: &DecidedClaim) -> Self {
        match (decided.claim.expected, &decided.verdict) {
            (Expected::True, Verdict::Proved(_)) => Self::Proved,
            (Expected::False, Verdict::Refuted(_)) => Self::Refuted,
            (Expected::True, Verdict::Refuted(_)) => Self::False,
            (Expected::False, Verdict::Proved(_)) => Self::True,
            (_, Verdict::Undecided(_)) => Self::Undecided,
        }
    }
}

/// The claims of a family in all its orders: one list for each statement, in the order of the file, each sorted
/// by verdict.
pub(crate) fn statements(items: &[Decided]) -> Vec<BTreeMap<Kind, Vec<Entry<'_>>>> {
    let mut statements: BTreeMap<(usize, usize), BTreeMap<Kind, Vec<Entry<'_>>>> = BTreeMap::new();
    for item in items {
        for decided in &item.claims {
            let place = match &decided.claim.place {
                Place::Text(_, range) => (range.start, range.end),
                Place::Token(..) => (0, 0),
            };
            let verdicts = statements.entry(place).or_default();
            verdicts.entry(Kind::of(decided)).or_default().push(Entry { item, decided });
        }
    }
    statements.into_values().collect()
}
