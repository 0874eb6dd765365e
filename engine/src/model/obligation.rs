//! What must be true for formulas to mean something, and the interface of what decides it.

use basis_kernel::{Domain, Proof, Quotient, Relation, Statement};
use basis_prover::Coordinate;
use basis_prover::collections::list::Listed as _;

use crate::algebra::poly::{Poly, Var};

/// Something that has to hold on the declared ranges.
#[derive(Clone, Debug)]
pub struct Obligation {
    /// What it is, such as `1 + λ != 0`.
    pub of: String,
    /// Statements of which one has to be true.
    pub goal: Goal,
    /// Why one of them is; `None` only where somebody else checks it.
    pub ground: Option<Ground>,
}

/// Why one of the [alternatives](Goal::alternatives) of a goal, which is numbered, is true.
#[derive(Clone, Debug)]
pub enum Ground {
    /// It is proved itself.
    Alone {
        /// Its number.
        alternative: usize,
        /// The proof.
        proof: Proof,
    },
    /// It follows where what is assumed holds.
    Derived {
        /// Its number.
        alternative: usize,
        /// The number of the way to statements that are enough for it.
        way: usize,
        /// Proofs of these statements.
        proofs: Vec<Proof>,
    },
}

impl Ground {
    /// The number of the alternative.
    pub const fn alternative(&self) -> usize {
        match self {
            Self::Alone { alternative, .. } | Self::Derived { alternative, .. } => *alternative,
        }
    }
}

impl Obligation {
    /// The proof of one of the alternatives itself, also that of the square, if it needs nothing that is assumed.
    pub const fn proof(&self) -> Option<&Proof> {
        match &self.ground {
            Some(Ground::Alone { proof, .. }) => Some(proof),
            _ => None,
        }
    }
}

/// What has to be shown.
#[derive(Clone, Debug, PartialEq)]
pub enum Goal {
    /// A polynomial vanishes nowhere: it, or its negative, is positive, as on a connected domain one of them has to be; under
    /// assumptions, which may leave several parts of a domain, it is enough that its square is: then it may have another sign on
    /// each part.
    Nonzero(Poly, std::rc::Rc<Domain>),
    /// A statement.
    Holds(Statement),
}

impl Goal {
    /// The statements of which one has to be true.
    pub fn alternatives(&self) -> Vec<Statement> {
        match self {
            Self::Holds(statement) => vec![statement.clone()],
            Self::Nonzero(p, domain) => {
                let square = (!domain.premises.is_empty()).then(|| p * p);
                let positive = |p: Poly| Statement::Sign {
                    value: Quotient::from(p),
                    relation: Relation::Positive,
                    domain: std::rc::Rc::clone(domain),
                };
                [p.clone(), -p].into_iter().chain(square).map(positive).listed()
            }
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
    fn judge(&self, goal: &Goal, budget: u32) -> Result<Option<Ground>, Open>;
}

/// Takes everything for true: for reading a spec whose obligations are checked later, by certificates.
#[derive(Clone, Copy, Debug)]
pub struct Later;

impl Judge for Later {
    fn judge(&self, _: &Goal, _: u32) -> Result<Option<Ground>, Open> {
        Ok(None)
    }
}
