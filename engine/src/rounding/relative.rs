//! Bounds relative to the value.
//!
//! A result is a product ∏ f^m of factors that are inputs, numbers, single differences such as 1 − t, and sums; its
//! relative error is the sum of those of its factors and of the roundings of the products. With the shares N of the
//! steps in the sums F and G = ∏ F, to first order
//!
//! error = value·Σₖ δₖ Rₖ/G, Rₖ = mₖG + Σ_F m_F·N_F,ₖ·G/F.
//!
//! If G has one sign on a cell, and each Rₖ has one or is at most a multiple of |G|, κ|G| − Σ|Rₖ| is at least a
//! polynomial.

use std::rc::Rc;

use super::cell::Cell;
use super::conditions::{Conditions, Shares, common_denominator, over};
use super::exact::{Exact, Share};
use super::refine::Lack;
use super::{Part, least_multiple, rest};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::steps::Step;
use basis_prover::collections::list::Listed;

type Factor = (usize, i64, i64);

/// What the relative error of a result is made of, on any cell.
pub(super) struct Relative {
    /// The roundings of factors and products: the step, its exponent, and how often it occurs above or below the
    /// fraction line.
    roundings: Vec<Factor>,
    /// The sums with their values, likewise.
    sums: Vec<(usize, Fraction, i64)>,
    /// G
    value: Poly,
    /// The Rₖ.
    shares: Shares,
}

impl Relative {
    /// Of a step; `None` when the work is spent, or a sum has a sum in a denominator.
    pub(super) fn new(exact: &mut Exact<'_>, output: usize, work: &mut Work) -> Option<Self> {
        let (roundings, sums) = product(exact, output);
        let mut factors: Vec<(Fraction, Vec<Share>)> = Vec::new();
        for (f, ..) in &sums {
            // Sums on the way to sums are no quotients: their divisors are products.
            if !exact.quotients_by_sums(*f).is_empty() {
                return None;
            }
            factors.push((exact.value(*f, work)?, exact.shares(*f, work)?));
        }
        let product_of = |skip: Option<usize>, work: &mut Work| {
            let mut product = Fraction::constant(Rational::ONE);
            for (i, (f, _)) in factors.iter().enumerate() {
                if Some(i) != skip {
                    product = product.mul_within(f, work)?;
                }
            }
            Some(product)
        };
        let all = product_of(None, work)?;
        let mut shares: Vec<Share> = Vec::new();
        let mut add = |k: usize, share: Fraction, work: &mut Work| {
            match shares.iter_mut().find(|(j, _)| *j == k) {
                Some((_, sum)) => *sum = sum.add_within(&share, work)?,
                None => shares.push((k, share)),
            }
            Some(())
        };
        for (k, exponent, _) in &roundings {
            add(*k, scaled(&all, *exponent), work)?;
        }
        for (i, (_, exponent, _)) in sums.iter().enumerate() {
            let others = scaled(&product_of(Some(i), work)?, *exponent);
            for (k, share) in &factors[i].1 {
                add(*k, share.mul_within(&others, work)?, work)?;
            }
        }
        // Everything times the denominators, which are numbers or polynomials in shape values.
        let quotients = shares.iter().map(|(_, share)| share);
        let below = common_denominator(&mut quotients.chain([&all]), work)?;
        let value = over(&all, &below)?;
        let mut grouped = Shares::default();
        for (k, share) in &shares {
            grouped.add(exact, *k, &over(share, &below)?, work)?;
        }
        let values = factors.into_iter().map(|(value, _)| value);
        let sums = sums.into_iter().zip(values).map(|((f, _, total), value)| (f, value, total)).listed();
        Some(Self { roundings, sums, value, shares: grouped })
    }

    /// Why there is no bound on a cell: where the value changes its sign there is none.
    pub(super) fn lack(&self, cell: &Cell, work: &mut Work) -> Lack {
        if cell.has_both_signs(&self.value, work) == Some(true) { Lack::Everywhere } else { Lack::Here }
    }

    /// The bound on a cell in u, and what it follows from; `None` if there is none.
    pub(super) fn on(&self, exact: &mut Exact<'_>, cell: &Cell, work: &mut Work) -> Option<(Rational, Part)> {
        let mut conditions = Conditions { cell, known: Vec::new() };
        let value = conditions.absolute(&self.value, work)?;
        let mut sum = Poly::zero();
        for share in &self.shares.groups {
            let weight = share.weight(exact, &mut conditions, work)?;
            if !weight.is_zero() {
                sum = &sum + &conditions.size(&share.poly, &value, work)?.scale(&weight);
            }
        }
        let (sum, value) = (cell.times_power(sum, work)?, cell.times_power(value, work)?);
        let first = cell.ratio(&sum, &value, work)?;
        let rest = self.higher(exact, &mut conditions, work)?;
        let (domain, conditions) = (Rc::clone(&cell.domain), conditions.known);
        let part = Part { domain, conditions, value, sums: vec![sum], rest: rest.clone(), own: None };
        Some((&first + &rest, part))
    }

    /// What is of higher order, in u.
    fn higher(
        &self,
        exact: &mut Exact<'_>,
        conditions: &mut Conditions<'_>,
        work: &mut Work,
    ) -> Option<Rational> {
        let mut size = Rational::ZERO;
        for (k, _, total) in &self.roundings {
            size += &(&exact.weight(*k) * &Rational::from(*total));
        }
        let mut rest = Rational::ZERO;
        for (f, value, total) in &self.sums {
            let times = cancellation(exact, *f, value, conditions, work)?;
            let (depth, total) = (exact.depth(*f), Rational::from(*total));
            let of_sum = rest::of_sum(&depth, &times)?;
            size += &(&total * &(&(&depth * &times) + &of_sum));
            rest += &(&total * &of_sum);
        }
        Some(&rest + &rest::of_product(&size)?)
    }
}

fn scaled(f: &Fraction, exponent: i64) -> Fraction {
    f * &Fraction::constant(Rational::from(exponent))
}

/// The factors of a step: single roundings and sums, each with its exponent, and how often it occurs above or below the
/// fraction line.
fn product(exact: &Exact<'_>, output: usize) -> (Vec<Factor>, Vec<Factor>) {
    let mut exponents = vec![(0_i64, 0_i64); output + 1];
    exponents[output] = (1, 1);
    let (mut roundings, mut sums) = (Vec::new(), Vec::new());
    for k in (0..=output).rev() {
        let (net, total) = exponents[k];
        if total == 0 || exact.is_exact(k) {
            continue;
        }
        let mut pass = |a: usize, sign: i64| {
            exponents[a].0 += sign * net;
            exponents[a].1 += total;
        };
        match exact.step(k) {
            Step::Neg(a) | Step::CutOff(a) => {
                pass(*a, 1);
                continue;
            }
            Step::Mul(a, b) => {
                pass(*a, 1);
                pass(*b, 1);
            }
            Step::Div(a, b) => {
                pass(*a, 1);
                pass(*b, -1);
            }
            Step::Add(..) | Step::Sub(..) if !exact.is_leaf(k) => {
                sums.push((k, net, total));
                continue;
            }
            _ => {}
        }
        roundings.push((k, net, total));
    }
    (roundings, sums)
}

/// A number m for which the absolute values of the products, of which a step is the sum, add up to at most m times its
/// absolute value.
fn cancellation(
    exact: &mut Exact<'_>,
    of: usize,
    value: &Fraction,
    conditions: &mut Conditions<'_>,
    work: &mut Work,
) -> Option<Rational> {
    let size = size(exact, of, conditions, work)?;
    if !value.denom().is_one() {
        return None;
    }
    let value = conditions.absolute(value.numer(), work)?;
    if size == value {
        return Some(Rational::ONE);
    }
    let times = least_multiple(&conditions.cell.ratio(&size, &value, work)?, 1);
    conditions.add(&value.scale(&times) - &size);
    Some(times)
}

/// The sum of the absolute values of the products of which a step is the sum.
fn size(exact: &mut Exact<'_>, of: usize, conditions: &mut Conditions<'_>, work: &mut Work) -> Option<Poly> {
    let mut sizes: Vec<Option<Poly>> = vec![None; of + 1];
    for k in exact.reached(of) {
        let size = |a: &usize| sizes[*a].as_ref();
        let here = match exact.step(k) {
            _ if exact.is_leaf(k) => {
                let value = exact.value(k, work)?;
                conditions.size(value.as_poly()?, &Poly::one(), work)?
            }
            Step::Neg(a) | Step::CutOff(a) => size(a)?.clone(),
            Step::Add(a, b) | Step::Sub(a, b) => size(a)? + size(b)?,
            Step::Mul(a, b) => {
                work.spend_product(size(a)?, size(b)?)?;
                size(a)? * size(b)?
            }
            Step::Div(a, b) => {
                let divisor = exact.value(*b, work)?.as_constant()?;
                size(a)?.scale(&divisor.abs().recip()?)
            }
            Step::Input(_) | Step::Constant(_) | Step::Call(..) | Step::Unless(..) | Step::Less(..) => {
                return None;
            }
        };
        sizes[k] = Some(here);
    }
    sizes[of].take()
}
