//! What a method comes to.

use crate::collections::list::Mapped;
use basis_kernel::SignProof;

use super::problem::{Point, Problem};
use crate::budget::Budget;
use crate::method::Method;
use basis_kernel::Relation;

/// How the search for a sign on a part of a region ended.
pub(crate) enum Outcome {
    Proved(Method, SignProof),
    /// A point of the ranges of the part; where a coordinate is irrational the value is 0.
    Refuted(Point),
    Unknown(String),
}

impl Outcome {
    /// A point, or the message that the work was spent on the way to it.
    pub(crate) fn refuted_or_spent(point: Option<Point>) -> Self {
        point.map_or_else(
            || Self::Unknown(String::from("a negative value could not be made explicit")),
            Self::Refuted,
        )
    }
}

/// What is left when the work is spent.
pub(crate) fn spent(problem: &Problem, on: &str) -> Outcome {
    let degrees: Vec<String> = problem.ranges.mapped(|(v, _)| problem.poly.degree(*v).to_string());
    let variables = match degrees.len() {
        1 => String::from("one variable"),
        count => format!("{count} variables"),
    };
    let terms = problem.poly.len();
    let left = format!(
        "the budget is spent on {on}: the sign of a polynomial with {terms} terms in {variables} (of degree {}) is open",
        degrees.join(", ")
    );
    Outcome::Unknown(left)
}

/// The whole cascade, for methods that need parts of a claim to be decided.
pub(crate) type Prove = fn(&Problem, Relation, &mut Budget) -> Outcome;
