//! How far numbers are off that are computed from shape values only, by sums of absolute values.
//!
//! A step is a sum of products, each of which carries some factors 1 + δ. With A the sum of the absolute values of the
//! products, and E that of each times the number of its factors, a step is at most A, and is off by at most E u to
//! first order: of a sum A is A₁ + A₂ and E is E₁ + E₂ + A, of a product A is A₁A₂ and E is A₁E₂ + E₁A₂ + A. In all it
//! is off by at most (1 + 2 d u) E u where no product has more than d factors, d u ≤ 1/8. Both are polynomials over a
//! common denominator, that of the reciprocals on the way.

use super::cell::Cell;
use super::conditions::Conditions;
use super::exact::Exact;
use super::{least_multiple, rest};
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::steps::Step;
use basis_prover::collections::list::Listed;

/// The exact value, A and E on a cell, each times `below`, which is positive there.
#[derive(Clone)]
pub(super) struct Majorant {
    pub(super) value: Poly,
    pub(super) size: Poly,
    pub(super) error: Poly,
    pub(super) below: Poly,
}

/// Those of steps on a cell, as far as they were asked for.
pub(super) struct Majorants<'c> {
    /// Those of what was asked for since they were cleared.
    pub(super) conditions: Conditions<'c>,
    /// Those of the steps themselves.
    pub(super) of_steps: Vec<Poly>,
    known: Vec<Option<Majorant>>,
    /// How many u divisors are off.
    off: Rational,
    /// Whether no variable is negative.
    is_nonnegative: bool,
}

/// The bits of the coefficients of A and E, which may be larger than they need to be.
const BITS: u64 = 24;

impl<'c> Majorants<'c> {
    pub(super) fn new(cell: &'c Cell, steps: usize) -> Self {
        let mut ranges = cell.domain.region.ranges.iter();
        let is_nonnegative = ranges.all(|(_, r)| r.low.value().is_some_and(|low| !low.is_negative()));
        Self {
            is_nonnegative,
            conditions: Conditions { cell, known: Vec::new() },
            of_steps: Vec::new(),
            known: vec![None; steps],
            off: Rational::ZERO,
        }
    }

    /// That of a step with what is of higher order; `None` when the work is spent or nothing is found.
    pub(super) fn of(&mut self, exact: &mut Exact<'_>, k: usize, work: &mut Work) -> Option<Majorant> {
        let asked = core::mem::replace(&mut self.conditions.known, core::mem::take(&mut self.of_steps));
        let mut is_known = true;
        for j in exact.reached(k) {
            if is_known && self.known[j].is_none() {
                let step = self.step(exact, j, work);
                self.known[j] = step.map(|m| Majorant {
                    size: self.shortened(m.size),
                    error: self.shortened(m.error),
                    ..m
                });
                is_known = self.known[j].is_some();
            }
        }
        self.of_steps = core::mem::replace(&mut self.conditions.known, asked);
        let mut majorant = self.known[k].clone()?;
        let small = &(&exact.depth(k) + &(&self.off * &Rational::from(4))) * &rest::unit();
        if small > Rational::new(1, 8) {
            return None;
        }
        majorant.error = majorant.error.scale(&(&Rational::ONE + &(&small * &Rational::from(2))));
        Some(majorant)
    }

    /// A polynomial with coefficients of few digits that is not less.
    fn shortened(&self, p: Poly) -> Poly {
        if !self.is_nonnegative {
            return p;
        }
        let terms = p.terms().map(|(m, c)| (m.clone(), short(c)));
        Poly::from_terms(terms.listed())
    }

    fn step(&mut self, exact: &mut Exact<'_>, k: usize, work: &mut Work) -> Option<Majorant> {
        let of = |a: &usize| self.known[*a].as_ref();
        Some(match exact.step(k) {
            _ if exact.is_leaf(k) => {
                let value = exact.value(k, work)?;
                let value = value.as_poly()?.clone();
                let size = self.conditions.size(&value, &Poly::one(), work)?;
                let weight = if exact.is_exact(k) { Rational::ZERO } else { exact.weight(k) };
                let error = size.scale(&weight);
                Majorant { value, size, error, below: Poly::one() }
            }
            Step::CutOff(a) => of(a)?.clone(),
            Step::Neg(a) => Majorant { value: -&of(a)?.value, ..of(a)?.clone() },
            Step::Add(a, b) | Step::Sub(a, b) => {
                let is_sum = matches!(exact.step(k), Step::Add(..));
                let (a, b) = (of(a)?, of(b)?);
                let value = if is_sum { &a.value + &b.value } else { &a.value - &b.value };
                if a.below != b.below {
                    return None;
                }
                let size = &a.size + &b.size;
                Majorant { value, error: &(&a.error + &b.error) + &size, size, below: a.below.clone() }
            }
            Step::Mul(a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                work.spend_product(&a.size, &b.size)?;
                work.spend_product(&a.error, &b.size)?;
                work.spend_product(&a.value, &b.value)?;
                let value = &a.value * &b.value;
                let size = &a.size * &b.size;
                let error = &(&(&a.size * &b.error) + &(&a.error * &b.size)) + &size;
                Majorant { value, size, error, below: &a.below * &b.below }
            }
            Step::Div(a, b) => {
                let (above, divisor) = (of(a)?.clone(), of(b)?.clone());
                if !divisor.below.is_one() {
                    return None;
                }
                let value = self.conditions.absolute(&divisor.value, work)?;
                let is_turned = value != divisor.value;
                // 1/(1 + b u) is within (1 + 2 b u) b u of 1 for b u ≤ 1/8.
                let off = self.conditions.most(&divisor.error, &value, work)?;
                let small = &off * &rest::unit();
                if small > Rational::new(1, 8) {
                    return None;
                }
                let off = &off * &(&Rational::ONE + &(&small * &Rational::from(2)));
                self.off = self.off.clone().max(off.clone());
                let error = &above.error + &above.size.scale(&(&off + &Rational::ONE));
                let own = if is_turned { -&above.value } else { above.value };
                Majorant { value: own, size: above.size, error, below: &above.below * &value }
            }
            Step::Input(_) | Step::Constant(_) | Step::Call(..) | Step::Unless(..) | Step::Less(..) => {
                return None;
            }
        })
    }
}

/// A number of few digits that is not less.
fn short(x: &Rational) -> Rational {
    let two = Rational::from(2);
    let power = |bits: u64| two.pow(u32::try_from(bits).unwrap_or(u32::MAX));
    let up = || {
        let unit = &power(x.denom().bits() + BITS) * &power(x.numer().bits()).recip()?;
        Some(&-&(-&(x * &unit)).floor() * &unit.recip()?)
    };
    up().unwrap_or_else(|| x.clone())
}

/// What is known of a number on some cells.
#[derive(Clone)]
pub(super) struct Known {
    /// The largest absolute value, at most.
    pub(super) most: Rational,
    /// The one nearest to 0, with its sign; 0 where it changes its sign.
    pub(super) least: Rational,
    /// How many u it is off, at most.
    pub(super) error: Rational,
}

impl Known {
    /// A number that it is at least.
    pub(super) fn low(&self) -> Rational {
        if self.least.is_positive() { self.least.clone() } else { -&self.most }
    }

    /// A number that it is at most.
    pub(super) fn high(&self) -> Rational {
        if self.least.is_negative() { self.least.clone() } else { self.most.clone() }
    }

    /// The largest absolute value of what is computed.
    pub(super) fn computed(&self) -> Rational {
        &self.most + &(&self.error * &rest::unit())
    }

    /// A number that is at least the distance from another one.
    pub(super) fn distance(&self, other: &Self) -> Rational {
        (&self.high() - &other.low()).max(&other.high() - &self.low()).max(Rational::ZERO)
    }

    /// This many times as much.
    pub(super) fn scaled(&self, factor: &Rational) -> Self {
        let size = factor.abs();
        Self { most: &self.most * &size, least: &self.least * factor, error: &self.error * &size }
    }

    /// The same with numbers of few digits.
    pub(super) fn shortened(&self) -> Self {
        let least = &self.least.abs();
        let least = -&short(&-least);
        let least = if self.least.is_negative() { -&least } else { least };
        Self { most: short(&self.most), least, error: short(&self.error) }
    }

    /// Of a step times a factor, a quotient that is not 0: its exact value is that of the step times the factor, and so
    /// is what it is off by.
    pub(super) fn of(
        exact: &mut Exact<'_>,
        k: usize,
        factor: &[Poly; 2],
        cells: &mut [Majorants<'_>],
        work: &mut Work,
    ) -> Option<Self> {
        let (mut most, mut error, mut all) = (Rational::ZERO, Rational::ZERO, Vec::new());
        for cell in cells {
            let majorant = cell.of(exact, k, work)?;
            let conditions = &mut cell.conditions;
            let own = conditions.absolute(&factor[0], work)?;
            let below = &majorant.below * &conditions.absolute(&factor[1], work)?;
            let off = conditions.most(&(&majorant.error * &own), &below, work)?;
            error = error.max(off);
            let value = [&majorant.value * &factor[0], &majorant.below * &factor[1]];
            let (largest, nearest) = between(&value, conditions, work)?;
            most = most.max(largest);
            all.push(nearest);
        }
        Some(Self { most, least: nearest(&all), error })
    }

    /// Of a step that is not 0, relative to itself, with the step as a quotient.
    pub(super) fn relative(
        exact: &mut Exact<'_>,
        k: usize,
        cells: &mut [Majorants<'_>],
        work: &mut Work,
    ) -> Option<(Self, [Poly; 2])> {
        let first = cells.first_mut()?.of(exact, k, work)?;
        let value = [first.value, first.below];
        let inverse = [value[1].clone(), value[0].clone()];
        let known = Self::of(exact, k, &inverse, cells, work)?;
        Some((known, value))
    }
}

/// The number that is nearest to 0, if all have the same sign.
pub(super) fn nearest(numbers: &[Rational]) -> Rational {
    let Some(first) = numbers.iter().min_by_key(|x| x.abs()) else { return Rational::ZERO };
    if numbers.iter().all(|x| x.signum() == first.signum()) { first.clone() } else { Rational::ZERO }
}

/// The largest absolute value of a quotient on a cell, at most, and the number nearest to 0, with its sign; 0 where
/// that changes.
pub(super) fn between(
    [numer, denom]: &[Poly; 2],
    conditions: &mut Conditions<'_>,
    work: &mut Work,
) -> Option<(Rational, Rational)> {
    let below = conditions.absolute(denom, work)?;
    let is_turned = below != *denom;
    let Some(is_positive) = conditions.cell.sign(numer, work) else {
        return Some((conditions.largest(numer, &below, work)?, Rational::ZERO));
    };
    let above = if is_positive { numer.clone() } else { -numer };
    conditions.add(above.clone());
    let most = conditions.most(&above, &below, work)?;
    let Some(least) = conditions.cell.ratio(&below, &above, work).and_then(|ratio| ratio.recip()) else {
        return Some((most, Rational::ZERO));
    };
    // With few digits, if these tell it from 0.
    let least = Some(-&least_multiple(&-&least, 1 << 20)).filter(Rational::is_positive).unwrap_or(least);
    conditions.add(&above - &below.scale(&least));
    Some((most, if is_positive == is_turned { -least } else { least }))
}
