//! Decides what has to hold while formulas are read.

use basis_prover::{Decision, Symmetries, ZeroFree, decide, zero_free};

use crate::model::obligation::{Goal, Judge, Judgement};

/// The judge that searches, and has what it finds checked.
#[derive(Clone, Copy, Debug)]
pub struct Prover;

impl Judge for Prover {
    fn judge(&self, goal: &Goal, budget: u32) -> Judgement {
        match goal {
            Goal::Nonzero(p, domain) => match zero_free(p, domain, budget) {
                ZeroFree::Proved(shown) => Judgement::Proved(shown.proof),
                ZeroFree::Zero(point) => Judgement::Fails(point),
                ZeroFree::Undecided(left) => Judgement::Undecided(left),
            },
            Goal::Holds(statement) => match decide(statement.clone(), &Symmetries::new(), budget) {
                Decision::Proved(shown) => Judgement::Proved(shown.proof),
                Decision::Refuted(found) => Judgement::Fails(found.point),
                Decision::Undecided(left) => Judgement::Undecided(left),
            },
        }
    }
}
