//! Coordinates of points.

use basis_kernel::algebra::rational::Rational;

use crate::algebra::algebraic::Algebraic;

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
