//! The claims of a run together: each has a budget of its own, but a spec may have any number of claims.

use basis_prover::collections::list::Listed;
use basis_prover::{cut_short_within, measured, within};

use super::{Evidence, Verdict};
use crate::claim::Claim;
use crate::subject::Subject;

/// Units of work for all decisions of a run.
const UNITS: u64 = 60_000_000;

/// What is left for claims however much it took to expand them.
const LEAST: u64 = UNITS / 10;

/// What a claim takes before there is anything to decide.
const CLAIM: u64 = 500;

/// What a claim may take in each round. Nineteen of twenty claims about angles and exponentials are decided in the first two, as
/// are nearly all about polynomials; together the rounds before the last one take a fifth of what that may take, and not much more
/// where the budget is raised: with more work a search may find a proof that takes too much work to check, and with less a short one.
const ROUNDS: [u64; 5] = [250_000, 1_000_000, 4_000_000, 10_000_000, UNITS];

/// The round that is for raised budgets alone.
const RAISED: usize = 3;

/// Why a claim stays undecided after others have taken all the work.
pub(super) const SPENT: &str =
    "the other claims have used up the work of a whole run; check it in a spec of its own";

/// Of a proof that took all the work there was for it.
const IN_PARTS: &str = "the other claims have left too little work for it; check it in a spec of its own";

/// Whether proofs are of the statements that are made again, with all the work of a claim alone, when a certificate is verified.
fn is_of_its_statements(subject: &Subject, claim: &Claim, evidence: &Evidence) -> bool {
    let shown = evidence.steps().iter().map(|(_, proof)| proof.statement());
    super::statements(subject, claim, evidence.ways())
        .is_some_and(|all| shown.eq(all.iter().map(|stated| &stated.statement)))
}

/// The work that is left for the claims of a run. These are decided in rounds, so that a hard claim takes nothing from
/// an easy one, wherever they stand.
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
    /// How many rounds there are.
    pub const ROUNDS: usize = ROUNDS.len();

    /// Whether nothing is left: further claims stay undecided.
    pub const fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// Decides a claim in one of the rounds, which are numbered from 0; `None` where a later one may do so.
    pub fn decide_in(&mut self, round: usize, subject: &Subject, claim: &Claim) -> Option<Verdict> {
        if self.is_spent() {
            return Some(Verdict::Undecided(String::from(SPENT)));
        }
        let budget = u64::from(subject.budget());
        if round == RAISED && budget == 1 {
            return None;
        }
        self.left = self.left.saturating_sub(CLAIM);
        // A quarter of what is left, so that the claims after it have the rest.
        let quarter = core::cmp::max(self.left / 4, ROUNDS[0]);
        let is_last = round + 1 == Self::ROUNDS;
        // A raised budget counts in full, or the whole run had no bound: in the end the claim may take half of what is left.
        let half = core::cmp::max(self.left / 2, ROUNDS[0]);
        let share = if is_last { quarter.saturating_mul(budget).min(half) } else { quarter };
        let units = ROUNDS.get(round)?.saturating_mul(if is_last { budget } else { 1 }).min(share);
        let mut decide = || cut_short_within(units, &mut || super::decide(subject, claim));
        let (verdict, is_cut) = self.counted(&mut decide);
        // A counterexample is checked by itself. A proof may be of other statements than those that the claim alone makes, where
        // something went without work; where statements have been searched for they are made again in any case.
        match &verdict {
            Verdict::Refuted(_) => Some(verdict),
            Verdict::Proved(evidence)
                if !is_cut && evidence.ways().is_empty()
                    || self.counted(&mut || is_of_its_statements(subject, claim, evidence)) =>
            {
                Some(verdict)
            }
            Verdict::Undecided(_) if !is_cut => Some(verdict),
            _ if !is_last => None,
            Verdict::Proved(_) => Some(Verdict::Undecided(String::from(IN_PARTS))),
            Verdict::Undecided(_) => Some(verdict),
        }
    }

    /// Decides a claim alone, in the last round.
    pub fn decide(&mut self, subject: &Subject, claim: &Claim) -> Verdict {
        let verdict = self.decide_in(Self::ROUNDS - 1, subject, claim);
        verdict.unwrap_or_else(|| Verdict::Undecided(String::from("there is no later round")))
    }

    /// Decides claims. After each attempt `said` gets the number of the claim and its verdict, or nothing if it comes up again.
    pub fn decide_all(
        &mut self,
        claims: &[(&Subject, &Claim)],
        said: &mut dyn FnMut(usize, Option<Verdict>),
    ) {
        let mut open = claims.iter().enumerate().listed();
        for round in 0..Self::ROUNDS {
            open.retain(|(k, (subject, claim))| {
                let verdict = self.decide_in(round, subject, claim);
                let again = verdict.is_none();
                said(*k, verdict);
                again
            });
        }
    }

    /// Expands formulas, which has limits of its own. Half of the work counts for the claims, so that a file that comes
    /// near to both limits does not take the sum of the two.
    pub fn expanding<T>(&mut self, work: &mut dyn FnMut() -> T) -> T {
        let (result, units) = measured(work);
        self.left = core::cmp::max(self.left.saturating_sub(units / 2), self.left.min(LEAST));
        result
    }

    /// Does other work of the provers, which takes no more than what is left.
    pub fn counted_work<T>(&mut self, work: &mut dyn FnMut() -> T) -> T {
        let left = self.left;
        self.counted(&mut || within(left, work))
    }

    fn counted<T>(&mut self, work: &mut dyn FnMut() -> T) -> T {
        let (result, units) = measured(work);
        self.left = self.left.saturating_sub(units);
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Item;
    use crate::{Library, Selected, Source};

    fn library(spec: &str) -> Library<'static> {
        Library::from_source(&crate::Disk, &crate::Prover, Source::text("run.basis", spec))
    }

    fn decided(item: &Item, run: &mut Run) -> Vec<Verdict> {
        let item = item.clone();
        let checked = crate::decide_all(vec![item], run).remove(0);
        checked.claims.into_iter().map(|(_, verdict)| verdict).collect()
    }

    #[test]
    fn claims_share_the_work_of_a_run() {
        let hard = "prove (t^5 - t - x)^2 + (x^5 - x - 1/3)^2 + (t - x)^2 > 0;";
        let spec =
            format!("family F {{ domain 0 <= t <= 1; shape 0 < x <= 1; b[0] = t; {} }}", hard.repeat(9));
        let library = library(&spec);
        let items = library.items(Selected::EveryOrder);
        let item = &items[0];
        let decide = |run: &mut Run| decided(item, run);
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

    /// Nothing is done of what ends a check; until it was seen so, one proof that was too large took the work of all claims.
    #[test]
    fn a_proof_that_is_too_large_to_check_takes_a_share() {
        let spec = "theorem T {
            curve P = Bernstein(1);
            dimension 3;
            prove dot(P[0], P[1])^2 <= dot(P[0], P[0])*dot(P[1], P[1]);
            prove dot(cross(P[0], P[1]), P[0]) == 0;
        }";
        let library = library(spec);
        let item = &crate::theorem::theorems(&library)[0];
        let mut run = Run::default();
        let verdicts: Vec<_> = item.claims.iter().map(|c| run.decide(&item.subject, c)).collect();
        assert!(run.left > UNITS / 2, "{}", run.left);
        assert!(matches!(verdicts[1], Verdict::Proved(_)), "{verdicts:?}");
    }

    /// What expanding took is not there for claims, of which some can always be decided.
    #[test]
    fn expanding_counts_for_the_claims() {
        let taken = |left: u64, units: u64| {
            let mut run = Run { left };
            run.expanding(&mut || basis_prover::charge(units));
            left - run.left
        };
        assert_eq!(taken(UNITS, 1_000_000), 500_000);
        assert_eq!(taken(UNITS, 3 * UNITS), UNITS - LEAST);
        assert_eq!(taken(LEAST / 2, UNITS), 0);
    }

    /// Families of many functions of high degree count for what it takes to expand them and to decide about them.
    #[test]
    fn families_count_for_what_they_take() {
        for (last, power, claim, expanding, deciding) in [
            (30, 100, "prove independent;", 200_000, 250_000),
            (30, 30, "prove independent;", 10_000, 50_000),
            (100, 30, "refute independent;", 50_000, 1_000_000),
            (40, 30, "refute independent;", 20_000, 700_000),
        ] {
            let functions = format!("b[i] = (t + i/7)^{power} for i in 0..={last};");
            let spec = format!("family F {{ domain 0 <= t <= 1; {functions} {claim} }}");
            let library = library(&spec);
            let mut run = Run::default();
            let item = run.expanding(&mut || library.items(Selected::EveryOrder)).remove(0);
            let (expanded, before) = (UNITS - run.left, run.left);
            decided(&item, &mut run);
            let decided = before - run.left;
            assert!(
                expanded >= expanding && decided >= deciding,
                "{functions} {expanded} and {decided} units"
            );
        }
    }

    /// A file cannot give itself more work than a run has by `budget`: until that was so, one claim could run for hours.
    #[test]
    fn raised_budgets_share_the_work_of_a_run() {
        let family = |budget: u32| {
            format!(
                "family F {{ domain 0 <= t <= 1; shape 0 < x <= 1; budget {budget};
                b[i] = (t + x*i/7)^9 for i in 0..=9; {} }}",
                "prove independent;".repeat(60)
            )
        };
        let taken = |budget: u32| {
            let spec = family(budget);
            let library = library(&spec);
            let item = library.items(Selected::EveryOrder).remove(0);
            let mut run = Run { left: 1_000_000 };
            let before = basis_prover::spent();
            decided(&item, &mut run);
            assert!(run.left < 1_000_000);
            basis_prover::spent() - before
        };
        let [usual, raised] = [1, 10_000].map(taken);
        assert!(raised > 500_000 && raised < 2_000_000, "{usual} and {raised} units");
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
        let library = library(spec);
        let items = library.items(Selected::EveryOrder);
        let item = &items[0];
        // Enough for the easy one and for the first rounds of the others.
        let mut run = Run { left: 3_000_000 };
        let verdicts = decided(item, &mut run);
        assert!(verdicts[..2].iter().all(|v| matches!(v, Verdict::Undecided(_))), "{verdicts:?}");
        assert!(matches!(verdicts[2], Verdict::Proved(_)), "{verdicts:?}");
    }

    /// However little work there is: a verdict that was not cut short is that of the claim alone, and its proofs are of
    /// the statements that are made again for a certificate.
    #[test]
    fn proofs_do_not_depend_on_the_work_of_others() {
        let spec = "family F {
            shape 0 < α <= pi/2;
            domain 0 <= t <= α;
            b[0] = t - sin(t);
            b[1] = cos(t);
            b[2] = (t - sin(t))/(α - sin(α));
            prove b[0] >= 0;
            prove b[2] <= 1;
            prove b[0]*b[1] <= 1/10;
            prove t*b[1] <= sin(t);
            refute b[0] >= t/2;
        }
        family G {
            shape 0 < α;
            domain 0 <= t <= α;
            b[0] = sinh(t) - t;
            b[1] = t*cosh(t) - sinh(t);
            prove nonnegative;
            prove b[1] >= b[0];
        }";
        let library = library(spec);
        let (mut cut, mut proved) = (0, 0);
        for item in library.items(Selected::EveryOrder) {
            for claim in &item.claims {
                let decide =
                    |units: u64| cut_short_within(units, &mut || super::super::decide(&item.subject, claim));
                let (alone, is_cut) = decide(u64::MAX);
                assert!(!is_cut);
                for units in (4..28).map(|k| (1 << k) / 3 * 2) {
                    let (verdict, is_cut) = decide(units);
                    if is_cut {
                        cut += 1;
                        continue;
                    }
                    assert_eq!(
                        core::mem::discriminant(&verdict),
                        core::mem::discriminant(&alone),
                        "{}",
                        claim.text
                    );
                    let Verdict::Proved(evidence) = verdict else { continue };
                    assert!(is_of_its_statements(&item.subject, claim, &evidence), "{}", claim.text);
                    proved += 1;
                }
            }
        }
        assert!(cut > 20 && proved > 20, "{cut} attempts were cut short, {proved} proved");
    }
}
