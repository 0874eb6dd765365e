//! What can be proved or refuted: statements about polynomials and quotients of polynomials, nothing else.
//!
//! A claim of a spec is translated into a list of such statements before it reaches this crate; it is true if all of
//! them are. Every statement is about *all* points of its domain.

use std::rc::Rc;

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;

/// What is claimed of a number x.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// x ≥ 0.
    NonNegative,
    /// x > 0.
    Positive,
}

impl Relation {
    /// Whether a number is as claimed.
    pub fn holds(self, value: &Rational) -> bool {
        self.allows(value.signum())
    }

    /// Whether a number with the sign −1, 0 or 1 is as claimed.
    pub const fn allows(self, sign: i32) -> bool {
        match self {
            Self::NonNegative => sign >= 0,
            Self::Positive => sign > 0,
        }
    }
}

/// Variables x₁, …, xₖ with xᵢ ≥ 0 and x₁ + … + xₖ ≤ c: of k + 1 barycentric coordinates that sum to c all but the
/// last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Simplex {
    /// The variables, at least one.
    pub variables: Vec<Var>,
    /// The number c, which is not negative.
    pub sum: Rational,
}

/// A quotient of two polynomials, in lowest terms or not. It has no value where the denominator is 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quotient {
    /// What stands above the fraction line.
    pub numerator: Poly,
    /// What stands below, not the polynomial 0.
    pub denominator: Poly,
}

impl From<Poly> for Quotient {
    fn from(numerator: Poly) -> Self {
        Self { numerator, denominator: Poly::one() }
    }
}

/// The points that a statement is about: those that satisfy all of its parts.
///
/// A variable that no part mentions stands for all real numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Domain {
    /// A range for each of some variables.
    pub region: Region,
    /// Simplices; no variable belongs to two of them or has a range beside.
    pub simplices: Vec<Simplex>,
    /// Polynomials that have the sign stated: only points where they do count.
    pub premises: Vec<(Poly, Relation)>,
}

impl Domain {
    /// The domain that is a box.
    pub const fn of(region: Region) -> Self {
        Self { region, simplices: Vec::new(), premises: Vec::new() }
    }
}

/// The dot products of points that variables stand for, the points by their numbers.
pub type Products = Vec<(Var, (usize, usize))>;

/// Values of some variables, the others free.
pub type Values = Vec<(Var, Rational)>;

/// A statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Statement {
    /// The value is 0 wherever it is defined.
    Zero {
        /// The value.
        value: Quotient,
        /// Where it is looked at; as the value is 0 everywhere if it is on a box, only a refutation needs it.
        domain: Rc<Domain>,
    },
    /// The value is ≥ 0 (> 0) at every point of the domain at which it is defined.
    Sign {
        /// The value.
        value: Quotient,
        /// What is claimed of it.
        relation: Relation,
        /// The points.
        domain: Rc<Domain>,
    },
    /// A polynomial of degree 1 in dot products pᵢ·pⱼ is ≥ 0 (> 0) for all points pᵢ of any space, at every point of
    /// the domain of the other variables.
    Products {
        /// The polynomial.
        value: Poly,
        /// What is claimed of it.
        relation: Relation,
        /// The dot products that occur.
        products: Products,
        /// The ranges of the other variables.
        domain: Rc<Domain>,
    },
    /// The rows of a matrix are linearly independent at all points of a box but the exceptions, and dependent at all
    /// points of the box that have the values of an exception.
    Independent {
        /// The rows, all of one length; their entries are polynomials in the variables of the box.
        rows: Vec<Vec<Poly>>,
        /// The exceptions.
        except: Vec<Values>,
        /// The box.
        region: Region,
    },
}
