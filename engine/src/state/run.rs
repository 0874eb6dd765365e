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
        // A family with a raised budget may do more in the whole run, too.
        self.left = self.left.saturating_sub((spent() - before) / u64::from(budget.max(1)));
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Library, Selected, Source};

    #[test]
    fn claims_share_the_work_of_a_run() {
        let hard = "prove (t^5 - t - x)^2 + (x^5 - x - 1/3)^2 + (t - x)^2 > 0;";
        let spec =
            format!("family F {{ domain 0 <= t <= 1; shape 0 < x <= 1; b[0] = t; {} }}", hard.repeat(9));
        let library = Library::from_source(&crate::Disk, &crate::Prover, Source::text("hard.basis", &spec));
        let items = library.items(Selected::EveryOrder);
        let item = &items[0];
        let decide =
            |run: &mut Run| item.claims.iter().map(|c| run.decide(&item.subject, c)).collect::<Vec<_>>();
        let mut whole = Run::default();
        assert!(decide(&mut whole).iter().all(|v| matches!(v, Verdict::Proved(_))));
        let one = (UNITS - whole.left) / 9;
        assert!(one > 1000, "a claim takes {one} units");
        let mut short = Run { left: 3 * one };
        let verdicts = decide(&mut short);
        let left =
            verdicts.iter().filter(|v| matches!(v, Verdict::Undecided(why) if why.contains("a whole run")));
        assert_eq!(left.count(), 6);
        assert!(verdicts[..3].iter().all(|v| matches!(v, Verdict::Proved(_))) && short.is_spent());
    }
}
