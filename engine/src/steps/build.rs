//! Puts operations together to steps.

use super::{Function, Step, Steps, series};
use crate::algebra::rational::Rational;
use crate::plan::Input;
use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::sort;

/// Steps that are being made: no operation occurs twice, and none changes nothing.
#[derive(Clone, Debug, Default)]
pub struct Builder {
    steps: Vec<Step>,
    places: SortedMap<Step, usize>,
    names: Vec<(usize, String)>,
    pub(super) manner: Manner,
}

/// What is done otherwise than it is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Manner {
    /// Nothing.
    #[default]
    Plain,
    /// Constants are computed with each other before they are rounded.
    Folding,
    /// Every [`Function::InversePowerOfTwo`] is 1.
    WithoutScales,
    /// Sums in Bernstein form are those of coordinates with the sum 1.
    SumsToOne,
    /// These, in one of both coordinates, as if it were the smaller one.
    InCoordinate(usize),
}

impl Builder {
    /// Computes constants with each other before they are rounded to floats, and functions of them to more digits than any
    /// float has: for numbers that are no operations of the runtime.
    pub fn folding() -> Self {
        Self { manner: Manner::Folding, ..Self::default() }
    }

    /// Takes all [`Function::InversePowerOfTwo`] for 1: of results in which they cancel, as they round nothing.
    pub(crate) fn without_scales() -> Self {
        Self { manner: Manner::WithoutScales, ..Self::default() }
    }

    /// With sums in Bernstein form whose coordinates have the sum 1.
    pub(super) fn of_sums_to_one() -> Self {
        Self { manner: Manner::SumsToOne, ..Self::default() }
    }

    /// With such sums in one of both coordinates, as if it were the smaller one.
    pub(crate) fn in_coordinate(k: usize) -> Self {
        Self { manner: Manner::InCoordinate(k), ..Self::default() }
    }

    fn push(&mut self, step: Step) -> usize {
        let next = self.steps.len();
        let place = *self.places.get_or_insert_with(step.clone(), || next);
        if place == next {
            self.steps.push(step);
        }
        place
    }

    pub(super) fn constant_at(&self, at: usize) -> Option<&Rational> {
        match &self.steps[at] {
            Step::Constant(value) => Some(value),
            _ => None,
        }
    }

    fn is(&self, at: usize, value: &Rational) -> bool {
        self.constant_at(at) == Some(value)
    }

    fn negated(&self, at: usize) -> Option<usize> {
        match self.steps[at] {
            Step::Neg(a) => Some(a),
            _ => None,
        }
    }

    /// The result of an operation on constants that no float rounds.
    fn folded(
        &self,
        a: usize,
        b: usize,
        result: impl Fn(&Rational, &Rational) -> Option<Rational>,
    ) -> Option<Rational> {
        let (a, b) = (self.constant_at(a)?, self.constant_at(b)?);
        let value = result(a, b)?;
        if self.manner == Manner::Folding {
            return Some(series::rounded(&value));
        }
        (is_exact(a) && is_exact(b) && is_exact(&value)).then_some(value)
    }

    /// A number from outside.
    pub fn input(&mut self, input: Input) -> usize {
        self.push(Step::Input(input))
    }

    /// A constant.
    pub fn constant(&mut self, value: Rational) -> usize {
        self.push(Step::Constant(value))
    }

    /// A whole number.
    pub fn integer(&mut self, value: usize) -> usize {
        // Degrees and binomial coefficients of families that can be generated.
        self.constant(Rational::from(i64::try_from(value).unwrap_or(i64::MAX)))
    }

    /// −a
    pub fn neg(&mut self, a: usize) -> usize {
        if let Some(value) = self.constant_at(a) {
            let value = -value;
            return self.constant(value);
        }
        match self.negated(a) {
            Some(inner) => inner,
            None => self.push(Step::Neg(a)),
        }
    }

    /// a + b
    pub fn add(&mut self, a: usize, b: usize) -> usize {
        if self.is(a, &Rational::ZERO) {
            return b;
        }
        if self.is(b, &Rational::ZERO) {
            return a;
        }
        if let Some(value) = self.folded(a, b, |a, b| Some(a + b)) {
            return self.constant(value);
        }
        match (self.negated(a), self.negated(b)) {
            (_, Some(b)) => self.sub(a, b),
            (Some(a), None) => self.sub(b, a),
            (None, None) => self.push(Step::Add(a, b)),
        }
    }

    /// a − b
    pub fn sub(&mut self, a: usize, b: usize) -> usize {
        if self.is(b, &Rational::ZERO) {
            return a;
        }
        if self.is(a, &Rational::ZERO) {
            return self.neg(b);
        }
        if let Some(value) = self.folded(a, b, |a, b| Some(a - b)) {
            return self.constant(value);
        }
        match self.negated(b) {
            Some(b) => self.add(a, b),
            None => self.push(Step::Sub(a, b)),
        }
    }

    /// a·b
    pub fn mul(&mut self, a: usize, b: usize) -> usize {
        for (factor, other) in [(a, b), (b, a)] {
            match self.constant_at(factor) {
                Some(value) if value.is_one() => return other,
                Some(value) if value.is_zero() => return factor,
                Some(value) if (-value).is_one() => return self.neg(other),
                _ => {}
            }
        }
        if let Some(value) = self.folded(a, b, |a, b| Some(a * b)) {
            return self.constant(value);
        }
        // A sign comes last, so that P·c and P·(−c) are one product.
        for (factor, other) in [(a, b), (b, a)] {
            if let Some(positive) = self.negated(factor) {
                let product = self.mul(positive, other);
                return self.neg(product);
            }
            if let Some(value) = self.constant_at(factor).filter(|value| value.is_negative()) {
                let positive = -value;
                let positive = self.constant(positive);
                let product = self.mul(positive, other);
                return self.neg(product);
            }
        }
        if self.places.contains_key(&Step::Mul(b, a)) {
            return self.push(Step::Mul(b, a));
        }
        self.push(Step::Mul(a, b))
    }

    /// a/b
    pub fn div(&mut self, a: usize, b: usize) -> usize {
        if self.is(b, &Rational::ONE) {
            return a;
        }
        if let Some(value) = self.folded(a, b, Rational::checked_div) {
            return self.constant(value);
        }
        self.push(Step::Div(a, b))
    }

    /// A function of a.
    pub fn call(&mut self, function: Function, a: usize) -> usize {
        if self.manner == Manner::WithoutScales && function == Function::InversePowerOfTwo {
            return self.constant(Rational::ONE);
        }
        if self.manner == Manner::Folding
            && let Some(value) = self.constant_at(a).and_then(|value| series::value(function, value))
        {
            return self.constant(value);
        }
        self.push(Step::Call(function, a))
    }

    /// 0 where a = b, else c.
    pub fn unless(&mut self, a: usize, b: usize, c: usize) -> usize {
        self.push(Step::Unless(a, b, c))
    }

    /// 1 where a < b, else 0.
    pub fn less(&mut self, a: usize, b: usize) -> usize {
        self.push(Step::Less(a, b))
    }

    /// a, or 0 where a is negative.
    pub fn cut_off(&mut self, a: usize) -> usize {
        match self.constant_at(a) {
            Some(value) if !value.is_negative() => a,
            _ => self.push(Step::CutOff(a)),
        }
    }

    /// Gives a step a name, if it has none and the name is free.
    pub fn name(&mut self, step: usize, name: &str) {
        let computed = !matches!(self.steps[step], Step::Input(_) | Step::Constant(_));
        if computed && self.names.iter().all(|(other, taken)| *other != step && taken != name) {
            self.names.push((step, name.to_string()));
        }
    }

    /// The outputs of other steps on inputs that are steps of these, or on inputs of their own where there is `None`.
    pub fn inline(&mut self, other: &Steps, input: &dyn Fn(Input) -> Option<usize>) -> Vec<usize> {
        let mut places: Vec<usize> = Vec::new();
        for (k, step) in other.steps.iter().enumerate() {
            let at = |k: usize| places[k];
            let place = match step {
                Step::Input(which) => input(*which).unwrap_or_else(|| self.input(*which)),
                Step::Constant(value) => self.constant(value.clone()),
                Step::Neg(a) => self.neg(at(*a)),
                Step::Add(a, b) => self.add(at(*a), at(*b)),
                Step::Sub(a, b) => self.sub(at(*a), at(*b)),
                Step::Mul(a, b) => self.mul(at(*a), at(*b)),
                Step::Div(a, b) => self.div(at(*a), at(*b)),
                Step::Call(function, a) => self.call(*function, at(*a)),
                Step::Unless(a, b, c) => self.unless(at(*a), at(*b), at(*c)),
                Step::Less(a, b) => self.less(at(*a), at(*b)),
                Step::CutOff(a) => self.cut_off(at(*a)),
            };
            if let Some(name) = other.name(k) {
                self.name(place, name);
            }
            places.push(place);
        }
        other.outputs.iter().map(|output| places[*output]).collect()
    }

    /// The steps that these outputs need.
    pub fn finish(self, outputs: &[usize]) -> Steps {
        let mut needed = vec![false; self.steps.len()];
        for output in outputs {
            needed[*output] = true;
        }
        for k in (0..self.steps.len()).rev() {
            if needed[k] {
                for operand in self.steps[k].operands() {
                    needed[operand] = true;
                }
            }
        }
        let mut places = vec![0; self.steps.len()];
        let mut steps = Vec::new();
        for (k, step) in self.steps.into_iter().enumerate().filter(|(k, _)| needed[*k]) {
            places[k] = steps.len();
            let at = |k: usize| places[k];
            steps.push(match step {
                Step::Input(_) | Step::Constant(_) => step,
                Step::Neg(a) => Step::Neg(at(a)),
                Step::Add(a, b) => Step::Add(at(a), at(b)),
                Step::Sub(a, b) => Step::Sub(at(a), at(b)),
                Step::Mul(a, b) => Step::Mul(at(a), at(b)),
                Step::Div(a, b) => Step::Div(at(a), at(b)),
                Step::Call(function, a) => Step::Call(function, at(a)),
                Step::Unless(a, b, c) => Step::Unless(at(a), at(b), at(c)),
                Step::Less(a, b) => Step::Less(at(a), at(b)),
                Step::CutOff(a) => Step::CutOff(at(a)),
            });
        }
        let mut names: Vec<(usize, String)> =
            self.names.into_iter().filter(|(k, _)| needed[*k]).map(|(k, name)| (places[k], name)).collect();
        sort(&mut names);
        Steps { steps, names, outputs: outputs.iter().map(|output| places[*output]).collect() }
    }
}

/// Whether a number is one of every kind of float: n·2ᵏ with |n| < 2²⁴ and k far from the ends of the exponents.
pub(super) fn is_exact(value: &Rational) -> bool {
    let (Some(numer), Some(denom)) = (value.numer().to_i64(), value.denom().to_i64()) else { return false };
    let odd = numer >> numer.trailing_zeros().min(62);
    denom.count_ones() == 1 && odd.unsigned_abs() < 1 << 24
}
