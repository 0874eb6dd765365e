//! Bounds of the error itself, for results that change their sign, and of points relative to the largest control point.
//!
//! The shares wₖvₖ that have one sign on a cell are added before their sum is enclosed; any other one lies between −m
//! and m for a number m. A point is linear in the control points Pᵢ, and so are the shares: Σ|wₖvₖ| is a convex function
//! of them, which is largest where every Pᵢ is 1 or −1. It is bounded for each choice of signs, one of two opposite
//! ones, if these are few, and else by the sums of the absolute values of the coefficients of each share.

use std::rc::Rc;

use super::cell::Cell;
use super::conditions::{Conditions, Shares, common_denominator, over};
use super::exact::Exact;
use super::relative::Relative;
use super::{Part, rest};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::steps::Step;

/// What the error of a result is made of, on any cell.
pub(super) struct Absolute {
    output: usize,
    /// The quotients by a sum, with the errors of the sums.
    quotients: Vec<(usize, Relative)>,
    /// The common denominator of all shares.
    below: Poly,
    /// The shares, with each choice of signs of the points.
    choices: Vec<Shares>,
    /// The coefficients of the points in the value, times the common denominator.
    coefficients: Vec<Poly>,
}

/// The highest number n of points for which all choices of signs are tried: the work grows with 2ⁿ⁻¹.
const MOST_SIGNED: usize = 7;

impl Absolute {
    /// Of a step that is linear in some points, if there are any; `None` when the work is spent.
    pub(super) fn new(exact: &mut Exact<'_>, output: usize, points: &[Var], work: &mut Work) -> Option<Self> {
        let mut quotients = Vec::new();
        for k in exact.quotients_by_sums(output) {
            if let Step::Div(_, divisor) = exact.step(k) {
                quotients.push((k, Relative::new(exact, *divisor, work)?));
            }
        }
        let shares = exact.shares(output, work)?;
        let value = exact.value(output, work)?;
        let below = common_denominator(&mut shares.iter().map(|(_, share)| share).chain([&value]), work)?;
        let mut polys = Vec::new();
        for (k, share) in &shares {
            polys.push((*k, coefficients(&over(share, &below)?, points)?));
        }
        let signed = (1..=MOST_SIGNED).contains(&points.len());
        let mut choices = Vec::new();
        for signs in 0..if signed { 1_u32 << (points.len() - 1) } else { 1 } {
            let mut grouped = Shares::default();
            for (k, coefficients) in &polys {
                if signed {
                    let signed = coefficients.iter().enumerate();
                    let sum =
                        signed.fold(
                            Poly::zero(),
                            |sum, (i, c)| {
                                if signs >> i & 1 == 1 { &sum - c } else { &sum + c }
                            },
                        );
                    grouped.add(exact, *k, &sum, work)?;
                } else {
                    for c in coefficients {
                        grouped.add(exact, *k, c, work)?;
                    }
                }
            }
            choices.push(grouped);
        }
        let coefficients = coefficients(&over(&value, &below)?, points)?;
        Some(Self { output, quotients, below, choices, coefficients })
    }

    /// A bound of the sum of the absolute values of the coefficients of the points on a cell, with what it follows from.
    pub(super) fn size_on(&self, cell: &Cell, work: &mut Work) -> Option<(Rational, Part)> {
        let mut conditions = Conditions { cell, known: Vec::new() };
        let value = conditions.absolute(&self.below, work)?;
        let (mut sum, mut between) = (Poly::zero(), Rational::ZERO);
        for coefficient in &self.coefficients {
            match cell.sign(coefficient, work) {
                Some(_) => sum = &sum + &conditions.absolute(coefficient, work)?,
                None => between += &conditions.largest(coefficient, &value, work)?,
            }
        }
        let sum = &sum + &value.scale(&between);
        let size = cell.ratio(&sum, &value, work)?;
        let (domain, conditions) = (Rc::clone(&cell.domain), conditions.known);
        Some((size, Part { domain, conditions, value, sums: vec![sum], rest: Rational::ZERO, own: None }))
    }

    /// The bound on a cell in u, and what it follows from; `None` if there is none.
    pub(super) fn on(&self, exact: &mut Exact<'_>, cell: &Cell, work: &mut Work) -> Option<(Rational, Part)> {
        let mut conditions = Conditions { cell, known: Vec::new() };
        for (k, divisor) in &self.quotients {
            let (bound, part) = divisor.on(exact, cell, work)?;
            let last = part.last(&bound);
            part.conditions.into_iter().chain(last).for_each(|p| conditions.add(p));
            exact.set_weight(*k, &bound)?;
        }
        let value = conditions.absolute(&self.below, work)?;
        let size = size(exact, self.output, &mut conditions, work)?;
        let rest = rest::of_sum(&exact.depth(self.output), &size)?;
        let (mut sums, mut most) = (Vec::new(), Rational::ZERO);
        for shares in &self.choices {
            let (mut sum, mut between) = (Poly::zero(), Rational::ZERO);
            for share in &shares.groups {
                let weight = share.weight(exact, &mut conditions, work)?;
                if weight.is_zero() {
                    continue;
                }
                match cell.sign(&share.poly, work) {
                    Some(_) => sum = &sum + &conditions.absolute(&share.poly, work)?.scale(&weight),
                    None => between += &(&conditions.largest(&share.poly, &value, work)? * &weight),
                }
            }
            let sum = &sum + &value.scale(&between);
            let first = cell.ratio(&sum, &value, work)?;
            if first > most {
                most = first;
            }
            sums.push(sum);
        }
        let (domain, conditions) = (Rc::clone(&cell.domain), conditions.known);
        let part = Part { domain, conditions, value, sums, rest: rest.clone(), own: None };
        Some((&most + &rest, part))
    }
}

/// The coefficients of the points in a linear form in them; without points the polynomial itself.
fn coefficients(share: &Poly, points: &[Var]) -> Option<Vec<Poly>> {
    if points.is_empty() {
        return Some(vec![share.clone()]);
    }
    let mut coefficients = Vec::new();
    let mut left = share.clone();
    for point in points {
        let coefficient = share.derivative(*point);
        left = &left - &(&coefficient * &Poly::var(*point));
        coefficients.push(coefficient);
    }
    left.is_zero().then_some(coefficients)
}

/// A bound of the sum of the absolute values of the products of which a step is the sum.
fn size(
    exact: &mut Exact<'_>,
    of: usize,
    conditions: &mut Conditions<'_>,
    work: &mut Work,
) -> Option<Rational> {
    let mut sizes: Vec<Option<Rational>> = vec![None; of + 1];
    for k in exact.reached(of) {
        let size = |a: &usize| sizes[*a].as_ref();
        let here = match exact.step(k) {
            _ if exact.is_leaf(k) => {
                let value = exact.value(k, work)?;
                bounded(&value, conditions, work)?
            }
            Step::Neg(a) | Step::CutOff(a) => size(a)?.clone(),
            Step::Add(a, b) | Step::Sub(a, b) => size(a)? + size(b)?,
            Step::Mul(a, b) => size(a)? * size(b)?,
            Step::Div(a, b) => {
                let inverse = Fraction::constant(Rational::ONE).div_within(&exact.value(*b, work)?, work);
                size(a)? * &bounded(&inverse.ok()??, conditions, work)?
            }
            Step::Input(_) | Step::Constant(_) | Step::Call(..) | Step::Unless(..) | Step::Less(..) => {
                return None;
            }
        };
        sizes[k] = Some(here);
    }
    sizes[of].take()
}

/// A number that the absolute value of a quotient does not exceed on the cell.
fn bounded(value: &Fraction, conditions: &mut Conditions<'_>, work: &mut Work) -> Option<Rational> {
    let below = conditions.absolute(value.denom(), work)?;
    conditions.largest(value.numer(), &below, work)
}
