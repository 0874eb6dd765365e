//! Plans written out as single operations: constants, neg, add, sub, mul and div, and for angles and exponentials a few
//! elementary functions.
//!
//! [`Steps`] do what the compiled Rust of a family does, operation by operation, with the functions of the runtime
//! written out. Each step has an exact meaning, a rational function of the inputs, and a rounded one in each kind of
//! float; [`Steps::evaluate`] has both. So one list gives the code of a language without our runtime, the exact value to
//! test it with, and the rounding errors to bound. [`FamilySteps`] are the steps of all that can be evaluated of a
//! family.
//!
//! Left out are operations that change no number: a product with 1 or 0, a sum with 0, and those on constants that are
//! exact in every float. What is left gives the floats of the compiled code bit for bit, but for the sign of a zero, as
//! long as the inputs are finite. There is no step for a fused multiplication and addition; where a compiler fuses an
//! addition with a product it adds, a rounding is left out. The loops of the runtime over slices use other associations.

mod build;
mod chart;
mod derived;
mod evaluate;
mod family;
#[cfg(any(test, feature = "tools"))]
mod join;
mod lower;
pub(crate) mod point;
mod quotient;
mod runtime;
mod series;

use crate::algebra::rational::Rational;
use crate::plan::Input;
use basis_prover::collections::sort::sort;

pub use build::Builder;
pub(crate) use chart::sums;
pub use derived::Derived;
pub use evaluate::Number;
pub use family::{EndSteps, FamilySteps};
#[cfg(any(test, feature = "tools"))]
pub use join::JoinSteps;
pub use lower::lower;
pub(crate) use series::value as elementary;

/// A computation in single operations.
#[derive(Clone, Debug, PartialEq)]
pub struct Steps {
    /// The operations; each refers to steps before it only, no two are the same, and every one is needed.
    pub steps: Vec<Step>,
    /// The names that some steps have in the plan, such as `s2` or `c0`, in the order of the steps; no two are the same.
    pub names: Vec<(usize, String)>,
    /// The steps that are the results.
    pub outputs: Vec<usize>,
}

/// An operation on the results of steps before it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Step {
    /// A number from outside.
    Input(Input),
    /// A constant: the `f64` nearest to this number, as a float of the kind in use.
    Constant(Rational),
    /// −a
    Neg(usize),
    /// a + b
    Add(usize, usize),
    /// a − b
    Sub(usize, usize),
    /// a·b
    Mul(usize, usize),
    /// a/b
    Div(usize, usize),
    /// An elementary function of a.
    Call(Function, usize),
    /// 0 where a = b, else c.
    Unless(usize, usize, usize),
    /// 1 where a < b, else 0.
    Less(usize, usize),
    /// a, or 0 where a is negative: exactly a is nonnegative.
    CutOff(usize),
}

/// A function that no finite number of operations gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Function {
    /// sin a
    Sin,
    /// cos a
    Cos,
    /// tan a
    Tan,
    /// tanh a
    Tanh,
    /// exp(a) − 1
    Expm1,
    /// The power of two by which a > 0 becomes a number from 1 to 2. A language may be off by a power of two where a is
    /// next to one: what it multiplies counts up to a factor only.
    InversePowerOfTwo,
}

impl Step {
    /// The steps it refers to.
    pub fn operands(&self) -> Vec<usize> {
        match *self {
            Self::Input(_) | Self::Constant(_) => Vec::new(),
            Self::Neg(a) | Self::Call(_, a) | Self::CutOff(a) => vec![a],
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) | Self::Div(a, b) | Self::Less(a, b) => {
                vec![a, b]
            }
            Self::Unless(a, b, c) => vec![a, b, c],
        }
    }
}

impl Steps {
    /// The name of a step, if it has one.
    pub fn name(&self, step: usize) -> Option<&str> {
        let place = self.names.binary_search_by_key(&step, |(step, _)| *step).ok()?;
        Some(&self.names[place].1)
    }

    /// The different inputs, ascending.
    pub fn inputs(&self) -> Vec<Input> {
        let inputs = self.steps.iter().filter_map(|step| match step {
            Step::Input(input) => Some(*input),
            _ => None,
        });
        let mut inputs: Vec<Input> = inputs.collect();
        sort(&mut inputs);
        inputs
    }
}
