//! The claims of a run together: each has a budget of its own, but a spec may have any number of claims.

use basis_prover::{measured, within};

use super::Verdict;
use crate::claim::Claim;
use crate::subject::Subject;

/// Units of work for all decisions of a run.
const UNITS: u64 = 100_000_000;

/// What a claim takes before there is anything to decide.
const CLAIM: u64 = 500;

/// What is kept for claims that are easy, however many hard ones stand before them.
const RESERVE: u64 = 40_000_000;

/// What a claim may take of the reserve: nineteen of twenty claims about angles and exponentials need no more, nor do nearly all
/// about polynomials.
const EASY: u64 = 1_000_000;

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

    /// What the next claim may take: a quarter of what is left beyond the reserve, so that the claims after it have
    /// the rest.
    const fn share(&self) -> u64 {
        let quarter = self.left.saturating_sub(RESERVE) / 4;
        if quarter > EASY { quarter } else { EASY }
    }

    /// Decides a claim.
    pub fn decide(&mut self, subject: &Subject, claim: &Claim) -> Verdict {
        if self.is_spent() {
            return Verdict::Undecided(String::from(
                "the claims before it have used up the work of a whole run; check it in a spec of its own",
            ));
        }
        self.left = self.left.saturating_sub(CLAIM);
        let (budget, share) = (subject.budget(), self.share());
        let units = share.saturating_mul(u64::from(budget));
        self.counted_work(budget, &mut || within(units, &mut || super::decide(subject, claim)))
    }

    /// Counts other work of the provers, with `budget` times the usual work.
    pub fn counted_work<T>(&mut self, budget: u32, work: &mut dyn FnMut() -> T) -> T {
        let (result, units) = measured(work);
        // A family with a raised budget may do more in the whole run, too.
        self.left = self.left.saturating_sub(units / u64::from(budget.max(1)));
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

    #[test]
    fn easy_claims_are_decided_after_hard_ones() {
        let spec = "family F {
            shape 0 < α <= pi/2;
            domain 0 <= t <= α;
            b[0] = t - sin(t);
            b[1] = cos(t);
            prove b[0]*b[1] <= 577/2500 - t^2/1000 + t^4/100000;
            prove b[0]^2*b[1] <= 9/100 + t^2/1000;
            prove b[0] >= 0;
        }";
        let library = Library::from_source(&crate::Disk, &crate::Prover, Source::text("hard.basis", spec));
        let items = library.items(Selected::EveryOrder);
        let item = &items[0];
        // Nothing is left but the reserve.
        let mut run = Run { left: RESERVE };
        let verdicts: Vec<_> = item.claims.iter().map(|c| run.decide(&item.subject, c)).collect();
        assert!(verdicts[..2].iter().all(|v| matches!(v, Verdict::Undecided(_))), "{verdicts:?}");
        assert!(run.left >= RESERVE - 3 * EASY, "{}", run.left);
        assert!(matches!(verdicts[2], Verdict::Proved(_)), "{verdicts:?}");
    }
}
