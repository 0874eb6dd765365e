//! Decides whether a polynomial is nonnegative or positive on a box, exactly.
//!
//! A cascade, from the cheap methods that decide nearly everything to the complete ones:
//!
//! 1. Bernstein coefficients on the box, factors that vanish on faces taken out;
//! 2. corners: a polynomial of degree 1 in a variable is decided by its restrictions to the ends of the range;
//! 3. factors: of a square-free decomposition every factor is decided for itself, squares not at all;
//! 4. one variable: Descartes' rule of signs (complete);
//! 5. subdivision of the box, with values at the corners of the cells as counterexamples;
//! 6. open cylindrical decomposition (complete for p ≥ 0); for p > 0 the faces of the box one by one, and on each
//!    open face the slices in which p can have a zero (complete for one and two variables).
//!
//! A proof carries a [`Certificate`], which `verify` checks on its own; a refutation is a point with the exact
//! value there. Nothing here knows of specs.

mod bernstein;
mod blocks;
mod budget;
mod cascade;
mod cells;
mod certificate;
mod corners;
#[cfg(any(test, feature = "tools"))]
mod exceptional;
mod factors;
mod independence;
#[cfg(any(test, feature = "tools"))]
mod largest;
#[cfg(any(test, feature = "tools"))]
mod parts;
mod pieces;
mod problem;
mod projection;
mod slices;
mod symmetry;
mod univariate;
#[cfg(any(test, feature = "tools"))]
mod verify;
mod witness;
mod zeros;

use core::fmt;

pub use budget::Budget;
pub(crate) use budget::spent;
pub use certificate::{Base, Cells, Certificate, Factor, Sample, Section, Slices, Subdivision};
#[cfg(any(test, feature = "tools"))]
pub use exceptional::{Exceptional, ExceptionalSet, exceptional_set};
#[cfg(any(test, feature = "tools"))]
pub use independence::dependent_at;
pub use independence::{
    Dependence, Exception, Independence, Minors, Piece, Table, Values, dependent, independent,
};
#[cfg(any(test, feature = "tools"))]
pub use largest::{LargestRange, largest_range};
#[cfg(any(test, feature = "tools"))]
pub use parts::{Part, nonnegative_parts};
pub(crate) use problem::simple;
pub use symmetry::{ChangeOfBasis, Combination, Symmetries, Symmetry};
#[cfg(any(test, feature = "tools"))]
pub use verify::{CellCoefficients, Computed, verify, verify_independence};
pub(crate) use zeros::is_zero;

use crate::algebra::algebraic::Algebraic;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;

/// What is claimed of a polynomial p.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// p ≥ 0.
    NonNegative,
    /// p > 0.
    Positive,
}

impl Relation {
    /// Whether a value is as claimed.
    pub fn holds(self, value: &Rational) -> bool {
        match self {
            Self::NonNegative => !value.is_negative(),
            Self::Positive => value.is_positive(),
        }
    }
}

/// How a claim was proved, in increasing order of effort.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Method {
    /// The value of a number.
    Constant,
    /// Signs of Bernstein coefficients.
    Coefficients,
    /// Restrictions to the ends of ranges of variables of degree 1.
    Corners,
    /// Signs of the factors of a product.
    Factors,
    /// Descartes' rule of signs.
    Descartes,
    /// Bernstein coefficients on the cells of a subdivision.
    Subdivision,
    /// Each face of the box for itself.
    Faces,
    /// Open cylindrical decomposition.
    Cells,
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Constant => "constant",
            Self::Coefficients => "Bernstein coefficients",
            Self::Corners => "corners",
            Self::Factors => "factors",
            Self::Descartes => "Descartes",
            Self::Subdivision => "subdivision",
            Self::Faces => "faces",
            Self::Cells => "cylindrical decomposition",
        })
    }
}

/// Why a claim is true.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proof {
    /// The most elaborate method that was needed.
    pub method: Method,
    /// What to check.
    pub certificate: Certificate,
}

/// A coordinate of a point.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Coordinate {
    /// A rational number.
    Rational(Rational),
    /// An irrational number.
    Algebraic(Algebraic),
}

impl Coordinate {
    /// The coordinate as text, such as `λ = -3` or `t = root of -2 + t^2 between 1 and 3/2`.
    pub fn describe(&self, name: &str) -> String {
        match self {
            Self::Rational(x) => format!("{name} = {x}"),
            Self::Algebraic(x) => format!("{name} = {}", x.describe(name)),
        }
    }
}

/// A point at which a claim fails.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Witness {
    /// A coordinate for each variable of the box and of the polynomial, in increasing order.
    pub point: Vec<(Var, Coordinate)>,
    /// The exact value of the polynomial there.
    pub value: Rational,
}

/// What is known about a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Decision {
    /// It is true.
    Proved(Proof),
    /// It is false.
    Refuted(Witness),
    /// The budget is spent; what is left to decide, for people.
    Undecided(String),
}

/// Decides whether p ≥ 0 or p > 0 at every point of a box, with its ends included or not as stated.
///
/// A variable of p without a range in the box stands for all real numbers. On an empty box every claim holds.
pub fn decide(p: &Poly, relation: Relation, region: &Region, budget: &mut Budget) -> Decision {
    cascade::decide(p, relation, region, budget)
}

#[cfg(test)]
mod tests;
