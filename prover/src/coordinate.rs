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
    /// The coordinate as text, such as `λ = -3` or `t = root of -2 + t^2 between 1 and 3/2`.
    pub fn describe(&self, name: &str) -> String {
        format!("{name} = {}", self.value(name))
    }

    /// The value alone, such as `-3` or `root of -2 + t^2 between 1 and 3/2`, a polynomial in the given name.
    pub fn value(&self, name: &str) -> String {
        match self {
            Self::Rational(x) => x.to_string(),
            Self::Algebraic(x) => x.describe(name),
        }
    }
}
