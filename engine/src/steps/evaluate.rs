//! Interprets steps with floats, exactly, or as rational functions.

use super::{Function, Step, Steps};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::rational::{Rational, ToFloat as _};
use crate::plan::Input;

/// What steps can be evaluated with.
pub trait Number: Clone {
    /// A constant, as generated code has it: for floats the nearest `f64`, rounded to the type.
    fn constant(value: &Rational) -> Self;
    /// −self
    fn neg(&self) -> Self;
    /// self + other
    fn add(&self, other: &Self) -> Self;
    /// self − other
    fn sub(&self, other: &Self) -> Self;
    /// self·other
    fn mul(&self, other: &Self) -> Self;
    /// self/other; `None` where an exact quotient does not exist.
    fn div(&self, other: &Self) -> Option<Self>;
    /// A function of self; `None` where there is no exact value.
    fn call(&self, function: Function) -> Option<Self>;
    /// Whether two numbers are equal.
    fn is(&self, other: &Self) -> bool;
    /// Whether the first of two numbers is smaller; `None` of numbers that are not ordered.
    fn is_less(&self, other: &Self) -> Option<bool>;
    /// Self, or 0 where it is negative; a function that is nonnegative stays as it is.
    fn cut_off(&self) -> Self;
}

impl Steps {
    /// The results for given inputs; `None` where an exact division is by zero, or a value is irrational.
    pub fn evaluate<N: Number>(&self, input: impl FnMut(Input) -> N) -> Option<Vec<N>> {
        let values = self.trace(input)?;
        Some(self.outputs.iter().map(|output| values[*output].clone()).collect())
    }

    /// The values of all steps for given inputs; `None` as for [`evaluate`](Self::evaluate).
    pub fn trace<N: Number>(&self, mut input: impl FnMut(Input) -> N) -> Option<Vec<N>> {
        let mut values: Vec<N> = Vec::new();
        for step in &self.steps {
            let at = |k: usize| &values[k];
            let value = match step {
                Step::Input(which) => input(*which),
                Step::Constant(value) => N::constant(value),
                Step::Neg(a) => at(*a).neg(),
                Step::Add(a, b) => at(*a).add(at(*b)),
                Step::Sub(a, b) => at(*a).sub(at(*b)),
                Step::Mul(a, b) => at(*a).mul(at(*b)),
                Step::Div(a, b) => at(*a).div(at(*b))?,
                Step::Call(function, a) => at(*a).call(*function)?,
                Step::Unless(a, b, _) if at(*a).is(at(*b)) => N::constant(&Rational::ZERO),
                Step::Unless(_, _, c) => at(*c).clone(),
                Step::Less(a, b) => N::constant(&Rational::from(i64::from(at(*a).is_less(at(*b))?))),
                Step::CutOff(a) => at(*a).cut_off(),
            };
            values.push(value);
        }
        Some(values)
    }
}

macro_rules! numbers {
    ($($number:ident: $constant:expr, $quotient:expr, $call:expr, $is_less:expr, $cut_off:expr;)+) => {$(
        impl Number for $number {
            fn constant(value: &Rational) -> Self {
                $constant(value)
            }
            fn neg(&self) -> Self {
                -self
            }
            fn add(&self, other: &Self) -> Self {
                self + other
            }
            fn sub(&self, other: &Self) -> Self {
                self - other
            }
            fn mul(&self, other: &Self) -> Self {
                self * other
            }
            fn div(&self, other: &Self) -> Option<Self> {
                $quotient(self, other)
            }
            fn call(&self, function: Function) -> Option<Self> {
                $call(self, function)
            }
            fn is(&self, other: &Self) -> bool {
                self == other
            }
            fn is_less(&self, other: &Self) -> Option<bool> {
                $is_less(self, other)
            }
            fn cut_off(&self) -> Self {
                $cut_off(self)
            }
        }
    )+};
}
numbers! {
    f32: |value: &Rational| value.to_f64() as f32, |a: &f32, b: &f32| Some(a / b), |a: &f32, function| Some(match function {
        Function::Sin => a.sin(),
        Function::Cos => a.cos(),
        Function::Tan => a.tan(),
        Function::Tanh => a.tanh(),
        Function::Expm1 => a.exp_m1(),
        Function::InversePowerOfTwo => {
            let exponent = (a.to_bits() >> 23) & 255;
            f32::from_bits(254_u32.saturating_sub(exponent).max(1) << 23)
        }
    }), |a: &f32, b: &f32| Some(a < b), |a: &f32| if *a < 0.0 { 0.0 } else { *a };
    f64: Rational::to_f64, |a: &f64, b: &f64| Some(a / b), |a: &f64, function| Some(match function {
        Function::Sin => a.sin(),
        Function::Cos => a.cos(),
        Function::Tan => a.tan(),
        Function::Tanh => a.tanh(),
        Function::Expm1 => a.exp_m1(),
        Function::InversePowerOfTwo => {
            let exponent = (a.to_bits() >> 52) & 2047;
            f64::from_bits(2046_u64.saturating_sub(exponent).max(1) << 52)
        }
    }), |a: &f64, b: &f64| Some(a < b), |a: &f64| if *a < 0.0 { 0.0 } else { *a };
    Rational: Rational::clone, Rational::checked_div, |_: &Rational, _| None,
        |a: &Rational, b: &Rational| Some(a < b), |a: &Rational| if a.is_negative() { Rational::ZERO } else { a.clone() };
    Fraction: |value: &Rational| Fraction::from(Poly::constant(value.clone())), Fraction::checked_div,
        |_: &Fraction, _| None, |_: &Fraction, _| None, Fraction::clone;
}
