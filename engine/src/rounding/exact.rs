//! What each step computes exactly, which steps round, and how their errors reach a result.

use super::{Inputs, rest};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::steps::{Step, Steps};
use basis_prover::collections::list::Listed;

/// When a step rounds.
pub(super) enum Rounds {
    Never,
    Always,
    /// Not where all polynomials of one of the two lists are ≥ 0: a difference of two floats, of which each is at most
    /// twice the other.
    Unless([[Poly; 2]; 2]),
}

/// wₖvₖ for a step k: how much the result changes when the step is off by a factor 1 + δ, to first order.
pub(super) type Share = (usize, Fraction);

/// The steps with their exact values, as far as they were asked for.
pub(super) struct Exact<'a> {
    steps: &'a [Step],
    variables: Vec<Option<Var>>,
    values: Vec<Option<Fraction>>,
    /// Of quotients by a sum, and of inputs that are not exact: how many u they are off.
    weights: Vec<Option<Rational>>,
}

impl<'a> Exact<'a> {
    /// `None` when an input is no variable.
    pub(super) fn new(steps: &'a Steps, inputs: &Inputs) -> Option<Self> {
        let steps = &steps.steps[..];
        let mut variables = Vec::new();
        let (mut values, mut weights) = (Vec::new(), Vec::new());
        for step in steps {
            let off = inputs.off.iter().find(|(input, ..)| *step == Step::Input(*input));
            if let Some((_, value, weight)) = off {
                values.push(Some(Fraction::from(value.clone())));
                weights.push((!weight.is_zero()).then(|| weight.clone()));
                variables.push(None);
                continue;
            }
            weights.push(None);
            values.push(None);
            variables.push(match step {
                Step::Input(input) => Some(inputs.variable(*input)?),
                _ => None,
            });
        }
        Some(Self { steps, variables, values, weights })
    }

    pub(super) fn step(&self, k: usize) -> &'a Step {
        &self.steps[k]
    }

    /// vₖ; `None` when the work is spent, or for a division by 0.
    pub(super) fn value(&mut self, k: usize, work: &mut Work) -> Option<Fraction> {
        if let Some(known) = &self.values[k] {
            return Some(known.clone());
        }
        // What a step is made of stands before it: each value is computed once, from the first to the last.
        let mut needed = vec![k];
        while let Some(k) = needed.last().copied() {
            let missing = self.step(k).operands().into_iter().find(|a| self.values[*a].is_none());
            if let Some(a) = missing {
                needed.push(a);
                continue;
            }
            needed.pop();
            let of = |a: &usize| self.values[*a].clone();
            let value = match self.step(k) {
                Step::Input(_) => Fraction::var(self.variables[k]?),
                Step::Constant(c) => Fraction::constant(c.clone()),
                Step::Neg(a) => -&of(a)?,
                Step::CutOff(a) => of(a)?,
                Step::Add(a, b) => of(a)?.add_within(&of(b)?, work)?,
                Step::Sub(a, b) => of(a)?.sub_within(&of(b)?, work)?,
                Step::Mul(a, b) => of(a)?.mul_within(&of(b)?, work)?,
                Step::Div(a, b) => of(a)?.div_within(&of(b)?, work).ok()??,
                Step::Call(..) | Step::Unless(..) | Step::Less(..) => return None,
            };
            self.values[k] = Some(value);
        }
        self.values[k].clone()
    }

    /// Whether a step gives its exact value: inputs, floats, and what only changes their sign or exponent.
    pub(super) fn is_exact(&self, k: usize) -> bool {
        match self.step(k) {
            Step::Input(_) => self.weights[k].is_none(),
            Step::Constant(c) => is_float(c),
            Step::Neg(a) | Step::CutOff(a) => self.is_exact(*a),
            Step::Mul(a, b) => {
                (self.is_power(*a) && self.is_exact(*b)) || (self.is_power(*b) && self.is_exact(*a))
            }
            Step::Div(a, b) => self.is_power(*b) && self.is_exact(*a),
            Step::Add(..) | Step::Sub(..) | Step::Call(..) | Step::Unless(..) | Step::Less(..) => false,
        }
    }

    /// Whether a step is a sum or a difference of exact values: off by one factor 1 + δ at most.
    pub(super) fn is_leaf(&self, k: usize) -> bool {
        match self.step(k) {
            Step::Add(a, b) | Step::Sub(a, b) => self.is_exact(*a) && self.is_exact(*b),
            Step::Constant(_) | Step::Input(_) => true,
            _ => self.is_exact(k),
        }
    }

    fn is_power(&self, k: usize) -> bool {
        matches!(self.step(k), Step::Constant(c) if is_power_of_two(c))
    }

    /// When a step rounds.
    pub(super) fn rounds(&mut self, k: usize, work: &mut Work) -> Option<Rounds> {
        Some(match self.step(k) {
            _ if self.is_exact(k) => Rounds::Never,
            Step::Neg(_) | Step::CutOff(_) => Rounds::Never,
            Step::Mul(a, b) if self.is_power(*a) || self.is_power(*b) => Rounds::Never,
            Step::Div(_, b) if self.is_power(*b) => Rounds::Never,
            Step::Add(a, b) | Step::Sub(a, b) if self.is_leaf(k) => {
                let (a, b) = (*a, *b);
                let (x, y) = (self.value(a, work)?, self.value(b, work)?);
                let y = if matches!(self.step(k), Step::Add(..)) { -&y } else { y };
                let (x, y) = (x.as_poly()?, y.as_poly()?);
                let two = Rational::from(2);
                let both = [&y.scale(&two) - x, &x.scale(&two) - y];
                let negative = [-&both[0], -&both[1]];
                Rounds::Unless([both, negative])
            }
            _ => Rounds::Always,
        })
    }

    /// How many u a step is off by its own rounding.
    pub(super) fn weight(&self, k: usize) -> Rational {
        match self.step(k) {
            // As an `f32` a constant is rounded twice, to the nearest `f64` before.
            Step::Constant(_) => &Rational::ONE + &rest::unit(),
            _ => self.weights[k].clone().unwrap_or(Rational::ONE),
        }
    }

    /// Whether a step is a quotient by a sum, whose weight depends on the cell.
    pub(super) fn has_own_weight(&self, k: usize) -> bool {
        matches!(self.step(k), Step::Div(_, b) if !self.is_leaf(*b))
    }

    /// Of a quotient by a sum: the sum may be off by `bound` u. The quotient is then off by a factor between
    /// (1 − u)/(1 + b u) and (1 + u)/(1 − b u), b = `bound`, which is within (1 + b)(1 + 2(1 + b) u) u of 1.
    pub(super) fn set_weight(&mut self, k: usize, bound: &Rational) -> Option<()> {
        let b = bound + &Rational::ONE;
        let small = &b * &rest::unit();
        if small > Rational::new(1, 8) {
            return None;
        }
        self.weights[k] = Some(&b * &(&Rational::ONE + &(&small * &Rational::from(2))));
        Some(())
    }

    /// The shares of all steps in the error of a step, down to values that are exact or off by one rounding.
    ///
    /// `None` when the work is spent.
    pub(super) fn shares(&mut self, of: usize, work: &mut Work) -> Option<Vec<Share>> {
        let mut weights: Vec<Option<Fraction>> = vec![None; of + 1];
        weights[of] = Some(Fraction::constant(Rational::ONE));
        let mut shares = Vec::new();
        for k in (0..=of).rev() {
            let Some(w) = weights[k].take().filter(|w| !w.is_zero()) else { continue };
            let rounds = !matches!(self.rounds(k, work)?, Rounds::Never);
            if rounds {
                let value = self.value(k, work)?;
                shares.push((k, w.mul_within(&value, work)?));
            }
            if self.is_leaf(k) {
                continue;
            }
            let add = |weights: &mut Vec<Option<Fraction>>, a: usize, w: Fraction, work: &mut Work| {
                let sum = match weights[a].take() {
                    Some(known) => known.add_within(&w, work)?,
                    None => w,
                };
                weights[a] = Some(sum);
                Some(())
            };
            match self.step(k) {
                Step::Input(_) | Step::Constant(_) => {}
                Step::Neg(a) => add(&mut weights, *a, -&w, work)?,
                Step::CutOff(a) => add(&mut weights, *a, w, work)?,
                Step::Add(a, b) => {
                    add(&mut weights, *a, w.clone(), work)?;
                    add(&mut weights, *b, w, work)?;
                }
                Step::Sub(a, b) => {
                    add(&mut weights, *a, w.clone(), work)?;
                    add(&mut weights, *b, -&w, work)?;
                }
                Step::Mul(a, b) => {
                    let (x, y) = (self.value(*a, work)?, self.value(*b, work)?);
                    add(&mut weights, *a, w.mul_within(&y, work)?, work)?;
                    add(&mut weights, *b, w.mul_within(&x, work)?, work)?;
                }
                Step::Div(a, b) => {
                    let y = self.value(*b, work)?;
                    let w = w.div_within(&y, work).ok()??;
                    // A divisor that is a sum has its share in the weight of the quotient.
                    if self.is_leaf(*b) {
                        let value = self.value(k, work)?;
                        add(&mut weights, *b, -&w.mul_within(&value, work)?, work)?;
                    }
                    add(&mut weights, *a, w, work)?;
                }
                Step::Call(..) | Step::Unless(..) | Step::Less(..) => return None,
            }
        }
        Some(shares)
    }

    /// The quotients by a sum on the way to a step.
    pub(super) fn quotients_by_sums(&self, of: usize) -> Vec<usize> {
        let mut reached = vec![false; of + 1];
        reached[of] = true;
        let mut found = Vec::new();
        for k in (0..=of).rev() {
            if !reached[k] {
                continue;
            }
            if let Step::Div(_, b) = self.step(k)
                && !self.is_leaf(*b)
            {
                found.push(k);
            }
            for a in self.step(k).operands() {
                reached[a] = true;
            }
        }
        found
    }

    /// The steps that a step is made of, down to values that are exact or off by one rounding, and the step itself,
    /// from the first to the last.
    pub(super) fn reached(&self, of: usize) -> Vec<usize> {
        let mut reached = vec![false; of + 1];
        reached[of] = true;
        for k in (0..=of).rev() {
            if reached[k] && !self.is_leaf(k) {
                self.step(k).operands().into_iter().for_each(|a| reached[a] = true);
            }
        }
        (0..=of).filter(|k| reached[*k]).listed()
    }

    /// The largest number of roundings in a product of which a step is the sum.
    pub(super) fn depth(&self, of: usize) -> Rational {
        let mut depths = vec![Rational::ZERO; of + 1];
        for k in 0..=of {
            let larger = |a: usize, b: usize| {
                if depths[a] > depths[b] { depths[a].clone() } else { depths[b].clone() }
            };
            depths[k] = match self.step(k) {
                _ if self.is_exact(k) => Rational::ZERO,
                Step::Input(_) => self.weight(k),
                Step::Constant(_) | Step::Call(..) | Step::Unless(..) | Step::Less(..) => Rational::ONE,
                Step::Neg(a) | Step::CutOff(a) => depths[*a].clone(),
                Step::Add(a, b) | Step::Sub(a, b) => &larger(*a, *b) + &Rational::ONE,
                Step::Mul(a, b) => &(&depths[*a] + &depths[*b]) + &Rational::ONE,
                Step::Div(a, b) if self.is_leaf(*b) => {
                    // 1/(1 + δ) ≤ (1 + u)² for the divisor
                    &(&depths[*a] + &(&depths[*b] * &Rational::from(2))) + &Rational::ONE
                }
                Step::Div(a, _) => &depths[*a] + &(&self.weight(k) + &Rational::ONE),
            };
        }
        depths[of].clone()
    }
}

/// ±2ⁿ
pub(super) fn is_power_of_two(c: &Rational) -> bool {
    let odd = |x: &Rational| odd_part(x).is_some_and(|odd| odd.is_one());
    !c.is_zero() && odd(&c.numer().abs()) && odd(&c.denom())
}

/// Whether a number is a float of 24 bits, and so of every type of floats here.
pub(super) fn is_float(c: &Rational) -> bool {
    c.is_zero()
        || (odd_part(&c.denom()).is_some_and(|odd| odd.is_one())
            && odd_part(&c.numer().abs()).is_some_and(|odd| odd.bits() <= 24))
}

/// A whole positive number without its factors of 2; `None` beyond a thousand bits.
fn odd_part(x: &Rational) -> Option<Rational> {
    let half = Rational::new(1, 2);
    let mut odd = x.clone();
    if odd.bits() > 1000 {
        return None;
    }
    loop {
        let next = &odd * &half;
        if !next.is_integer() {
            return Some(odd);
        }
        odd = next;
    }
}
