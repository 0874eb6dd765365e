//! From expressions to exact functions: `evaluate` for all kinds of expressions, with a file each for derivatives, integrals,
//! functions of the language (`builtins`), names with arguments, calls of other families, loops, and expressions that must
//! be numbers; `phase` and `beside` for angles; `settle` decides what has to hold for them to mean something; `print`
//! writes them into messages.

mod arguments;
#[cfg(feature = "angles")]
mod beside;
mod builtins;
mod calls;
mod derivatives;
mod evaluate;
mod integrals;
mod loops;
#[cfg(not(feature = "angles"))]
mod no_angles;
pub(crate) mod numbers;
#[cfg(feature = "angles")]
pub(crate) mod phase;
pub(crate) mod print;
mod settle;

use crate::algebra::fraction::Fraction;

/// A value of an angle: y, and the angle itself.
type AngleValue = (Fraction, Fraction);

/// What an expression is.
#[derive(Clone, Debug)]
pub(crate) enum Value {
    /// One function or number.
    Scalar(Fraction),
    /// Several, each with its index.
    List(Vec<(Vec<i64>, Fraction)>),
}
