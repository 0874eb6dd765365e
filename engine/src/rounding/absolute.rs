//! Bounds of the error itself, for results that change their sign, and of points relative to the largest control point.
//!
//! The shares wₖvₖ that have one sign on a cell are added before their sum is enclosed; any other one lies between −m
//! and m for a number m. A point is linear in the control points Pᵢ, and so are the shares: Σ|wₖvₖ| is a convex function
//! of them, which is largest where every Pᵢ is 1 or −1. It is bounded for each choice of signs, one of two opposite
//! ones, if these are few, and else by the sums of the absolute values of the coefficients of each share.
//!
//! Of a quotient C = N/W of two sums the steps that both need, such as powers of a coordinate, have one share: with the
//! shares n and w of a step in N and W it is (n·W − N·w)/W². The quotient of what floats have, ΔN = Σ δₖnₖ + ρ and ΔW =
//! Σ δₖwₖ + σ being the errors, is (N + ΔN)/(W + ΔW), and so is off by
//!
//! (ΔN − C·ΔW)/(W + ΔW) = (Σ δₖ(nₖ − C·wₖ) + ρ − C·σ)/W / (1 + η), η = ΔW/W.
//!
//! With the first sum at most L u, |ρ/W| ≤ r u, |σ/W| ≤ q u, |C| ≤ Λ and |η| ≤ h u ≤ 1/8, that is at most (L + r +
//! Λq)(1 + 2h u) u; the rounding of the quotient itself is a share like any other, and enlarges this by a factor 1 + u.

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
use crate::plan::Input;
use crate::steps::Step;

/// What the error of a result is made of, on any cell.
pub(super) struct Absolute {
    output: usize,
    /// What is divided by what, where the result is a quotient of sums.
    above_and_below: Option<[usize; 2]>,
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
pub(super) const MOST_SIGNED: usize = 7;

impl Absolute {
    /// Of a step that is linear in some points, if there are any, with all choices of their signs if they are at most
    /// `most_signed`; `None` when the work is spent.
    pub(super) fn new(
        exact: &mut Exact<'_>,
        output: usize,
        points: &[Var],
        most_signed: usize,
        work: &mut Work,
    ) -> Option<Self> {
        let above_and_below = match exact.step(output) {
            Step::Div(a, b) if !points.is_empty() && !exact.is_leaf(*b) => Some([*a, *b]),
            _ => None,
        };
        let mut quotients = Vec::new();
        for k in exact.quotients_by_sums(output) {
            if let Step::Div(_, divisor) = exact.step(k)
                && (k != output || above_and_below.is_none())
            {
                quotients.push((k, Relative::new(exact, *divisor, work)?));
            }
        }
        let (shares, value, below) = match above_and_below {
            Some(parts) => of_quotient(exact, output, parts, work)?,
            None => of_sum(exact, output, work)?,
        };
        let mut polys = Vec::new();
        for (k, share) in &shares {
            polys.push((*k, coefficients(share, points)?));
        }
        let signed = (1..=most_signed).contains(&points.len());
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
        let coefficients = coefficients(&value, points)?;
        Some(Self { output, above_and_below, quotients, below, choices, coefficients })
    }

    /// A bound of the sum of the absolute values of the coefficients of the points on a cell, with what it follows from.
    pub(super) fn size_on(&self, cell: &Cell, work: &mut Work) -> Option<(Rational, Part)> {
        let mut conditions = Conditions { cell, known: Vec::new() };
        let value = conditions.absolute(&self.below, work)?;
        let mut sum = Poly::zero();
        for coefficient in &self.coefficients {
            sum = &sum + &conditions.size(coefficient, &value, work)?;
        }
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
        let shares = self.choices.iter().flat_map(|shares| &shares.groups).map(|group| &group.poly);
        let below = cell.of_degree(&self.below, &mut { shares });
        let value = conditions.absolute(&below, work)?;
        let compared = cell.times_power(value.clone(), work)?;
        let (mut sums, mut most) = (Vec::new(), Rational::ZERO);
        for shares in &self.choices {
            let mut sum = Poly::zero();
            for share in &shares.groups {
                let weight = share.weight(exact, &mut conditions, work)?;
                if !weight.is_zero() {
                    sum = &sum + &conditions.size(&share.poly, &value, work)?.scale(&weight);
                }
            }
            let sum = cell.times_power(sum, work)?;
            let first = cell.ratio(&sum, &compared, work)?;
            if first > most {
                most = first;
            }
            sums.push(sum);
        }
        let Some(parts) = self.above_and_below else {
            let size = match size(exact, self.output, &mut conditions, work) {
                Some(size) => size,
                None => {
                    let one = Fraction::constant(Rational::ONE);
                    relative_size(exact, self.output, &one, &mut conditions, work)?
                }
            };
            let rest = rest::of_sum(&exact.depth(self.output), &size)?;
            let (domain, conditions) = (Rc::clone(&cell.domain), conditions.known);
            let part = Part { domain, conditions, value: compared, sums, rest: rest.clone(), own: None };
            return Some((&most + &rest, part));
        };
        let rest = higher(exact, parts, &most, &mut conditions, work)?;
        let (domain, conditions) = (Rc::clone(&cell.domain), conditions.known);
        // What is of higher order is a multiple of L, so that L is what is proved.
        let own = Some(most.clone());
        let part = Part { domain, conditions, value: compared, sums, rest: Rational::ZERO, own };
        Some((&most + &rest, part))
    }
}

/// A bound where the shares of all steps take too much work, by counting: a sum of products with at most d factors
/// 1 + δ, whose absolute values add up to at most A, is off by at most A((1 + u)ᵈ − 1).
pub(super) fn counted(
    exact: &mut Exact<'_>,
    output: usize,
    cell: &Cell,
    work: &mut Work,
) -> Option<(Rational, Part)> {
    let mut conditions = Conditions { cell, known: Vec::new() };
    for k in exact.quotients_by_sums(output) {
        let Step::Div(_, divisor) = exact.step(k) else { continue };
        let (bound, part) = Relative::new(exact, *divisor, work)?.on(exact, cell, work)?;
        let last = part.last(&bound);
        part.conditions.into_iter().chain(last).for_each(|p| conditions.add(p));
        exact.set_weight(k, &bound)?;
    }
    let size = relative_size(exact, output, &Fraction::constant(Rational::ONE), &mut conditions, work)?;
    let depth = exact.depth(output);
    let bound = &(&depth * &size) + &rest::of_sum(&depth, &size)?;
    let (domain, conditions, own) = (Rc::clone(&cell.domain), conditions.known, Some(bound.clone()));
    let part = Part { domain, conditions, value: Poly::zero(), sums: Vec::new(), rest: Rational::ZERO, own };
    Some((bound, part))
}

type InShares = (Vec<(usize, Poly)>, Poly, Poly);

/// The shares of the steps of a sum and its value, all times their common denominator, and this.
fn of_sum(exact: &mut Exact<'_>, output: usize, work: &mut Work) -> Option<InShares> {
    let shares = exact.shares(output, work)?;
    let value = exact.value(output, work)?;
    let below = common_denominator(&mut shares.iter().map(|(_, share)| share).chain([&value]), work)?;
    let mut polys = Vec::new();
    for (k, share) in &shares {
        polys.push((*k, over(share, &below)?));
    }
    Some((polys, over(&value, &below)?, below))
}

/// Those of the quotient N/W of two sums, times W².
fn of_quotient(
    exact: &mut Exact<'_>,
    output: usize,
    [above, below]: [usize; 2],
    work: &mut Work,
) -> Option<InShares> {
    let (n, w) = (exact.value(above, work)?, exact.value(below, work)?);
    let shares = [exact.shares(above, work)?, exact.shares(below, work)?];
    let all = shares.iter().flatten().map(|(_, share)| share);
    let common = common_denominator(&mut all.chain([&n, &w]), work)?;
    let (n, w) = (over(&n, &common)?, over(&w, &common)?);
    work.spend_product(&n, &w)?;
    let value = &n * &w;
    let mut polys: Vec<(usize, Poly)> = vec![(output, value.clone())];
    for (shares, factor) in shares.iter().zip([&w, &-&n]) {
        for (k, share) in shares {
            let share = over(share, &common)?;
            work.spend_product(&share, factor)?;
            let share = &share * factor;
            match polys.iter_mut().find(|(j, _)| j == k) {
                Some((_, sum)) => *sum = &*sum + &share,
                None => polys.push((*k, share)),
            }
        }
    }
    work.spend_product(&w, &w)?;
    Some((polys, value, &w * &w))
}

/// What the error of a quotient is beyond L, in u.
fn higher(
    exact: &mut Exact<'_>,
    [above, below]: [usize; 2],
    first: &Rational,
    conditions: &mut Conditions<'_>,
    work: &mut Work,
) -> Option<Rational> {
    let divisor = exact.value(below, work)?;
    let [of_above, of_below] = [
        relative_size(exact, above, &divisor, conditions, work)?,
        relative_size(exact, below, &divisor, conditions, work)?,
    ];
    let rest = rest::of_sum(&exact.depth(below), &of_below)?;
    let off = &(&exact.depth(below) * &of_below) + &rest;
    if &off * &rest::unit() > Rational::new(1, 8) {
        return None;
    }
    // No |C| is larger than the sum of the absolute values of the products above, divided by W.
    let rests = &rest::of_sum(&exact.depth(above), &of_above)? + &(&of_above * &rest);
    let factor = &(&(&off + &Rational::ONE) * &Rational::from(2)) * &rest::unit();
    Some(&rests + &(&(first + &rests) * &factor))
}

/// A number m for which the absolute values of the products, of which a step is the sum, add up to at most m times a
/// divisor.
fn relative_size(
    exact: &mut Exact<'_>,
    of: usize,
    divisor: &Fraction,
    conditions: &mut Conditions<'_>,
    work: &mut Work,
) -> Option<Rational> {
    let mut sizes: Vec<Option<Fraction>> = vec![None; of + 1];
    for k in exact.reached(of) {
        let size = |a: &usize| sizes[*a].as_ref();
        let here = match exact.step(k) {
            // A number times something between −1 and 1.
            Step::Input(Input::Point(_)) => {
                let value = exact.value(k, work)?;
                let sum = value.as_poly()?.terms().fold(Rational::ZERO, |sum, (_, c)| &sum + &c.abs());
                Fraction::constant(sum)
            }
            _ if exact.is_leaf(k) => {
                let value = exact.value(k, work)?;
                absolute(&value, conditions, work)?
            }
            Step::Neg(a) | Step::CutOff(a) => size(a)?.clone(),
            Step::Add(a, b) | Step::Sub(a, b) => size(a)?.add_within(size(b)?, work)?,
            Step::Mul(a, b) => size(a)?.mul_within(size(b)?, work)?,
            Step::Div(a, b) => {
                let size = size(a)?.clone();
                let value = exact.value(*b, work)?;
                size.div_within(&absolute(&value, conditions, work)?, work).ok()??
            }
            Step::Input(_) | Step::Constant(_) | Step::Call(..) | Step::Unless(..) | Step::Less(..) => {
                return None;
            }
        };
        sizes[k] = Some(here);
    }
    let divisor = absolute(divisor, conditions, work)?;
    let ratio = sizes[of].take()?.div_within(&divisor, work).ok()??;
    bounded(&ratio, conditions, work)
}

/// |f|, of a quotient whose numerator and denominator have one sign each, or else a number that it does not exceed.
fn absolute(f: &Fraction, conditions: &mut Conditions<'_>, work: &mut Work) -> Option<Fraction> {
    let below = conditions.absolute(f.denom(), work)?;
    let above = conditions.size(f.numer(), &below, work)?;
    Fraction::new(above, below)
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
