//! The claims of a run together: each has a budget of its own, but a spec may have any number of claims.

use basis_prover::spent;

use super::Verdict;
use crate::claim::Claim;
use crate::subject::Subject;

/// Units of work for all decisions of a run: eight claims that use up their budgets.
const UNITS: u64 = 40_000_000;

/// The work that is left for the claims of a run, which are decided one after the other.
#[derive(Debug)]
pub struct Run {
    left: u64,
}

impl Default for Run {
    fn default() -> Self {
        Self { left: UNITS }
    }
}

impl Run {
    /// Whether nothing is left: further claims stay undecided.
    pub const fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// Decides a claim.
    pub fn decide(&mut self, subject: &Subject, claim: &Claim) -> Verdict {
        if self.is_spent() {
            return Verdict::Undecided(String::from(
                "the claims before it have used up the work of a whole run; check it in a spec of its own",
            ));
        }
        self.counted_work(subject.budget(), &mut || super::decide(subject, claim))
    }

    /// Counts other work of the provers, with `budget` times the usual work.
    pub fn counted_work<T>(&mut self, budget: u32, work: &mut dyn FnMut() -> T) -> T {
        let before = spent();
        let result = work();
        // Who raises the budget of a family wants more to be done in the whole run.
        self.left = self.left.saturating_sub((spent() - before) / u64::from(budget.max(1)));
        result
    }
}
