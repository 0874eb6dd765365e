//! Decides what has to hold while formulas are read.

use basis_prover::{Failure, Proof, Symmetries, ZeroFree, decide, zero_free};

use crate::model::obligation::{Goal, Judge, Open};

/// The judge that searches, and has what it finds checked.
#[derive(Clone, Copy, Debug)]
pub struct Prover;

impl Judge for Prover {
    fn judge(&self, goal: &Goal, budget: u32) -> Result<Option<Proof>, Open> {
        match goal {
            Goal::Nonzero(p, domain) => match zero_free(p, domain, budget) {
                ZeroFree::Proved(shown) => Ok(Some(shown.proof)),
                ZeroFree::Zero(point) => Err(Open::Fails(point)),
                ZeroFree::Undecided(left) => Err(Open::Undecided(left)),
            },
            Goal::Holds(statement) => match decide(statement.clone(), &Symmetries::new(), budget) {
                Ok(shown) => Ok(Some(shown.proof)),
                Err(Failure::Refuted(found)) => Err(Open::Fails(found.point)),
                Err(Failure::Undecided(left)) => Err(Open::Undecided(left)),
            },
        }
    }
}
