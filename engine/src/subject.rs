//! What claims are about.

use std::rc::Rc;

use crate::claim::Claim;
use crate::model::Family;
use crate::model::obligation::Obligation;
use crate::theorem::Theorem;

/// A family of one order, a theorem or a join.
#[derive(Clone, Debug)]
pub enum Subject {
    /// A family of one order.
    Family(Rc<Family>),
    /// A theorem or a join.
    Theorem(Rc<Theorem>),
}

impl Subject {
    /// `family`, `theorem` or `join`.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Family(_) => "family",
            Self::Theorem(theorem) => theorem.kind.keyword(),
        }
    }

    /// The name.
    pub fn name(&self) -> &str {
        match self {
            Self::Family(family) => &family.name,
            Self::Theorem(theorem) => &theorem.name,
        }
    }

    /// The name as it stands in messages, such as `Bernstein(3)` or `theorem T`.
    pub fn title(&self) -> String {
        match self {
            Self::Family(family) => family.title(),
            Self::Theorem(theorem) => theorem.title(),
        }
    }

    /// The doc comment, one string a line.
    pub fn doc(&self) -> &[String] {
        match self {
            Self::Family(family) => &family.doc,
            Self::Theorem(theorem) => &theorem.doc,
        }
    }

    /// The values of the index parameters; theorems have none.
    pub fn order(&self) -> &[(String, i64)] {
        match self {
            Self::Family(family) => &family.order,
            Self::Theorem(_) => &[],
        }
    }

    /// The names of the variables.
    pub fn names(&self) -> &[String] {
        match self {
            Self::Family(family) => &family.names,
            Self::Theorem(theorem) => &theorem.names,
        }
    }

    /// The factor of the usual work that may be spent on a claim.
    pub fn budget(&self) -> u32 {
        match self {
            Self::Family(family) => family.budget,
            Self::Theorem(theorem) => theorem.budget,
        }
    }

    /// Whether two subjects are the same family in perhaps different orders.
    pub fn is_same(&self, other: &Self) -> bool {
        self.kind() == other.kind() && self.name() == other.name()
    }
}

/// What a spec says of one subject.
#[derive(Clone, Debug)]
pub struct Item {
    /// The family, theorem or join.
    pub subject: Subject,
    /// What must be true for its formulas and claims to mean something.
    pub obligations: Vec<Obligation>,
    /// Its claims, in the order in which they are written.
    pub claims: Vec<Claim>,
}
