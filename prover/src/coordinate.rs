//! Coordinates of points.

use basis_kernel::algebra::rational::Rational;

use crate::algebra::real::algebraic::Algebraic;

/// A coordinate of a point.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Coordinate {
    /// A rational number.
    Rational(Rational),
    /// An irrational number.
    Algebraic(Algebraic),
}

impl Coordinate {
    /// The coordinate as text for readers, such as `λ = -3`, `t = sqrt(2)` or `t = root of -1 - t + t^3 between 1 and
    /// 3/2`.
    pub fn describe(&self, name: &str) -> String {
        match self {
            Self::Rational(x) => format!("{name} = {x}"),
            Self::Algebraic(x) => format!("{name} = {}", x.reading(name)),
        }
    }

    /// The value alone for programs, such as `-3` or `root of -2 + t^2 between 1 and 3/2`, a polynomial in the given name.
    pub fn value(&self, name: &str) -> String {
        match self {
            Self::Rational(x) => x.to_string(),
            Self::Algebraic(x) => x.describe(name),
        }
    }
}
