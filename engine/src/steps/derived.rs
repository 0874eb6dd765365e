//! Numbers that depend on the shape values only and are computed once for them.

use super::{Builder, Steps};
use crate::algebra::rational::Rational;
use crate::plan::Input;

/// Numbers that depend on the shape values and are computed once for them.
#[derive(Clone, Debug)]
pub struct Derived {
    /// What they are called; no two are the same.
    pub names: Vec<String>,
    /// Their values, from the shape values.
    pub steps: Steps,
}

/// A number that is known, or an input.
#[derive(Clone, Debug)]
pub(super) enum Scalar {
    Known(Rational),
    Input(Input),
}

/// Makes the derived values of all spans.
pub(super) struct Deriving {
    pub(super) builder: Builder,
    pub(super) shapes: usize,
    pub(super) names: Vec<String>,
    pub(super) outputs: Vec<usize>,
}

impl Deriving {
    /// A step as a number for other steps.
    pub(super) fn keep(&mut self, step: usize, name: &str) -> Scalar {
        if let Some(value) = self.builder.constant_at(step) {
            return Scalar::Known(value.clone());
        }
        Scalar::Input(Input::Shape(self.position(step, name)))
    }

    /// The position of a step among shape values and derived values.
    pub(super) fn position(&mut self, step: usize, name: &str) -> usize {
        if let Some(k) = (0..self.shapes).find(|k| self.builder.input(Input::Shape(*k)) == step) {
            return k;
        }
        let known = self.outputs.iter().position(|output| *output == step);
        let place = known.unwrap_or_else(|| {
            let mut name = String::from(name);
            while self.names.contains(&name) {
                name.push('x');
            }
            self.names.push(name);
            self.outputs.push(step);
            self.outputs.len() - 1
        });
        self.shapes + place
    }
}

impl Builder {
    pub(super) fn scalar(&mut self, scalar: &Scalar) -> usize {
        match scalar {
            Scalar::Known(value) => self.constant(value.clone()),
            Scalar::Input(input) => self.input(*input),
        }
    }
}
