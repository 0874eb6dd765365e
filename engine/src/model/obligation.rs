//! What must be true for formulas to mean something, and the interface of what decides it.

use basis_kernel::{Domain, Proof, Quotient, Relation, Statement};
use basis_prover::Coordinate;

use crate::algebra::poly::{Poly, Var};

/// Something that has to hold on the declared ranges.
#[derive(Clone, Debug)]
pub struct Obligation {
    /// What it is, such as `1 + λ != 0`.
    pub of: String,
    /// Statements of which one has to be true.
    pub goal: Goal,
    /// Why one of them is; `None` only where somebody else checks it.
    pub proof: Option<Proof>,
}

/// What has to be shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Goal {
    /// A polynomial vanishes nowhere: on a connected domain it, or its negative, is positive.
    Nonzero(Poly, std::rc::Rc<Domain>),
    /// A statement.
    Holds(Statement),
}

impl Goal {
    /// The statements of which one has to be true.
    pub fn alternatives(&self) -> Vec<Statement> {
        match self {
            Self::Holds(statement) => vec![statement.clone()],
            Self::Nonzero(p, domain) => [p.clone(), -p]
                .map(|p| Statement::Sign {
                    value: Quotient::from(p),
                    relation: Relation::Positive,
                    domain: std::rc::Rc::clone(domain),
                })
                .to_vec(),
        }
    }
}

/// Why a judge has no proof of a goal.
#[derive(Clone, Debug)]
pub enum Open {
    /// It fails at this point.
    Fails(Vec<(Var, Coordinate)>),
    /// The budget is spent; what is left to decide, in words.
    Undecided(String),
}

/// Decides what has to hold while formulas are read, so that the model knows nothing of proofs.
pub trait Judge {
    /// Decides a goal with `budget` times the usual work. `None` in place of a proof: it is taken for true, and
    /// somebody else checks it.
    ///
    /// # Errors
    /// The goal is false, or undecided.
    fn judge(&self, goal: &Goal, budget: u32) -> Result<Option<Proof>, Open>;
}

/// Takes everything for true: for reading a spec whose obligations are checked later, by certificates.
#[derive(Clone, Copy, Debug)]
pub struct Later;

impl Judge for Later {
    fn judge(&self, _: &Goal, _: u32) -> Result<Option<Proof>, Open> {
        Ok(None)
    }
}
