//! What is claimed, of a family or of a theorem.

use basis_kernel::Values;
use std::rc::Rc;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::diagnostic::Place;
use crate::model::budget::{Run, TooLarge};
use crate::model::{Family, Parameter};
pub use crate::syntax::{Comparison, Expected};
use crate::theorem::Form;

/// A claim about a family, a theorem or a join.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The claim as text, index variables replaced by their values.
    pub text: String,
    /// The doc comment, one string a line.
    pub doc: Vec<String>,
    /// Whether it is declared true or false.
    pub expected: Expected,
    /// Where it stands; of an equation in a block, where that equation stands.
    pub place: Place,
    /// The statement that makes the claim.
    pub statement: Statement,
    /// What is claimed.
    pub kind: ClaimKind,
    /// The family with the values that an `at` block gives to angles, where it had to be expanded anew with them.
    pub about: Option<Rc<Family>>,
}

/// A statement of a family, a theorem or a join, or an equation in an `at` block, that makes claims: one for each value
/// of its index variables, in each order.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The number of the statement in its item and, in an `at` block, that of the equation, both from zero; the same in
    /// all orders.
    pub number: (usize, usize),
    /// As it is written, in one line, without its keyword and comments, such as `b[i] >= 0 for i in 0..=n`; of an
    /// equation in an `at` block its two sides.
    pub text: Rc<str>,
    /// Of an equation in an `at` block, what its index variables run over, such as `for i in 0..=n`; otherwise empty.
    pub range: Rc<str>,
}

/// The kinds of claims.
#[derive(Clone, Debug)]
pub enum ClaimKind {
    /// The functions sum to 1.
    PartitionOfUnity,
    /// Every function is ≥ 0 on the domain, for all shape values in their ranges.
    Nonnegative,
    /// `b[i](t) = b[n−i](low + high − t)`.
    Symmetric,
    /// The functions are linearly independent for all shape values in their ranges except the listed ones.
    Independent(Vec<Values>),
    /// Neighbouring segments, control points shifted by one, join with some continuous derivatives.
    Continuity(Joint),
    /// All minors of the functions at ascending points are ≥ 0.
    TotallyPositive,
    /// The derivatives up to this order agree at the inner knots of a domain of several spans.
    Smooth(u32),
    /// Of a domain of several spans: what is claimed on those with these numbers.
    Spans(Vec<(usize, ClaimKind)>),
    /// The computed values of all functions are within this many ε of the exact ones: relative, or absolute for a
    /// function that has no relative bound.
    Rounding(Rational),
    /// Every difference compares with zero as stated, on the declared ranges.
    Relation {
        /// Left side minus right side and how it compares with zero, for each component of two neighbouring sides.
        differences: Vec<(Comparison, Difference)>,
        /// Variables that an `at` block fixes; they no longer occur in the differences.
        fixed: Vec<(Var, Fraction)>,
        /// The values that the block fixes as text, such as `t = 0`; nothing outside of one.
        at: Option<String>,
    },
    /// A scalar of a theorem compares with zero as stated.
    Scalar {
        /// How it compares with zero.
        comparison: Comparison,
        /// Left side minus right side.
        difference: Difference,
    },
    /// A vector, or an outer product, of a theorem is zero.
    Vector {
        /// Left side minus right side as text.
        text: String,
        /// The difference.
        value: Form,
    },
    /// Of two vectors, or outer products, one is a positive multiple of the other, or both are zero.
    Parallel {
        /// The left side.
        left: Side,
        /// The right side.
        right: Side,
    },
}

/// How a segment joins its neighbour.
#[derive(Clone, Debug)]
pub struct Joint {
    /// How many derivatives are continuous.
    pub order: u32,
    /// The shape values of the next segment; none where they are those of this one.
    pub next: Vec<Fraction>,
    /// The parameters among them that are free, with the numbers of variables of no family.
    pub free: Vec<Parameter>,
}

/// Left side minus right side.
#[derive(Clone, Debug)]
pub struct Difference {
    /// The left side as text.
    pub left: String,
    /// The right side as text.
    pub right: String,
    /// The difference as text, such as `D(b[1]) - (3 + λ)`.
    pub text: String,
    /// The difference.
    pub value: Fraction,
}

/// A vector with its text.
#[derive(Clone, Debug)]
pub struct Side {
    /// As it is written.
    pub text: String,
    /// The vector.
    pub value: Form,
}

impl ClaimKind {
    /// Whether a variable occurs in what is claimed of a theorem.
    pub fn depends_on(&self, var: Var) -> bool {
        let form = |form: &Form| form.terms.values().any(|f| f.depends_on(var));
        match self {
            Self::Scalar { difference, .. } => difference.value.depends_on(var),
            Self::Vector { value, .. } => form(value),
            Self::Parallel { left, right } => form(&left.value) || form(&right.value),
            Self::Relation { differences, .. } => differences.iter().any(|(_, d)| d.value.depends_on(var)),
            _ => true,
        }
    }

    /// The claim, or of several spans what is claimed on the first one.
    pub fn on_a_span(&self) -> &Self {
        match self {
            Self::Spans(parts) => parts.first().map_or(self, |(_, kind)| kind),
            kind => kind,
        }
    }

    /// Counts what the claim keeps in memory.
    pub(crate) fn kept(&self, run: &Run) -> Result<(), TooLarge> {
        let kept = |difference: &Difference| {
            run.text(difference.left.len() + difference.right.len() + difference.text.len())?;
            run.keep(&difference.value)
        };
        let form = |form: &Form| form.terms.values().try_for_each(|f| run.keep(f));
        match self {
            Self::Relation { differences, .. } => differences.iter().try_for_each(|(_, d)| kept(d)),
            Self::Scalar { difference, .. } => kept(difference),
            Self::Vector { value, .. } => form(value),
            Self::Parallel { left, right } => form(&left.value).and_then(|()| form(&right.value)),
            _ => Ok(()),
        }
    }

    /// The variables that an `at` block fixes.
    pub fn fixed(&self) -> &[(Var, Fraction)] {
        match self {
            Self::Relation { fixed, .. } => fixed,
            _ => &[],
        }
    }
}
