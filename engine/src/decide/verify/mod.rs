//! Checks certificates without trusting, or sharing code with, the search that found them.
//!
//! What is used from below is arithmetic with rational numbers and polynomials only: conversion to Bernstein form, root
//! counting and resultants are done here once more, in another way.

mod bernstein;
mod elimination;
mod independence;
mod levels;
mod slices;
mod sturm;

pub use independence::verify_independence;

use core::cell::RefCell;

use super::Relation;
use super::certificate::{Certificate, Factor};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

/// Parts of certificates within each other.
const MAX_DEPTH: usize = 100;
/// The most operations on numbers of a machine word for one certificate, many times what a search with the usual budget may
/// spend to find one.
const WORK: u64 = 200_000_000;

/// The Bernstein coefficients on a cell, by the indices of the variables that occur; the index of the last one changes fastest.
pub type CellCoefficients = Vec<Rational>;

/// What a check computes on its way, in the order in which it is needed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Computed {
    /// The coefficients on all cells.
    pub cells: Vec<CellCoefficients>,
    /// The minors, up to their signs.
    pub minors: Vec<Poly>,
}

/// Checks that a certificate proves p ≥ 0 or p > 0 on a box, with `budget` times the usual work; the coefficients on all cells of its subdivisions, in the order
/// in which they stand in the certificate, the lower part of a cut first.
///
/// # Errors
/// What is wrong with it, in a sentence.
pub fn verify(
    p: &Poly,
    relation: Relation,
    region: &Region,
    certificate: &Certificate,
    budget: u32,
) -> Result<Vec<CellCoefficients>, String> {
    if let Certificate::Empty = certificate {
        let empty = region.ranges.iter().any(|(_, r)| r.is_empty());
        return check(empty, || "no range is empty".into()).map(|()| Vec::new());
    }
    let mut poly = p.clone();
    for (var, range) in &region.ranges {
        if let (End::Included(a), End::Included(b)) = (&range.low, &range.high)
            && a == b
        {
            poly = poly.at(*var, a);
        }
    }
    let ranges = poly.variables().into_iter().map(|v| (v, region.range(v))).collect();
    let cells = RefCell::new(Vec::new());
    let work = RefCell::new(Work::new(WORK.saturating_mul(u64::from(budget))));
    Claim { poly, relation, ranges, cells: &cells, work: &work }.verify(certificate, 0)?;
    Ok(cells.into_inner())
}

/// Counts work that is about to be done; an error when it is more than any certificate needs that a search writes.
fn spend(work: &mut Work, units: u64) -> Result<(), String> {
    work.spend(units).ok_or_else(|| {
        format!("the certificate takes more than {WORK} operations to check, times the budget of the spec")
    })
}

/// An error unless a condition holds.
fn check(holds: bool, message: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(message()) }
}

/// A polynomial, what is claimed of it, and the ranges of exactly its variables.
struct Claim<'a> {
    poly: Poly,
    relation: Relation,
    ranges: Vec<(Var, Range)>,
    /// Where the coefficients on the cells are collected.
    cells: &'a RefCell<Vec<CellCoefficients>>,
    /// What may still be done.
    work: &'a RefCell<Work>,
}

impl Claim<'_> {
    /// A claim of another polynomial on the same ranges.
    fn part(&self, poly: Poly, relation: Relation) -> Result<Self, String> {
        let variables = poly.variables();
        let known = variables.iter().all(|v| self.ranges.iter().any(|(w, _)| w == v));
        check(known, || "a part has other variables than the whole".into())?;
        let ranges = self.ranges.iter().filter(|(v, _)| variables.contains(v)).cloned().collect();
        Ok(Self { poly, relation, ranges, cells: self.cells, work: self.work })
    }

    /// Counts work that is about to be done.
    fn spend(&self, units: u64) -> Result<(), String> {
        spend(&mut self.work.borrow_mut(), units)
    }

    fn range(&self, var: Var) -> Result<&Range, String> {
        let found = self.ranges.iter().find(|(v, _)| *v == var);
        found.map(|(_, r)| r).ok_or_else(|| format!("variable {} does not occur", var.0))
    }

    fn verify(&self, certificate: &Certificate, depth: usize) -> Result<(), String> {
        check(depth < MAX_DEPTH, || "the certificate is nested too deeply".into())?;
        match certificate {
            Certificate::Empty => Err("the ranges of a part are never empty".into()),
            Certificate::Constant => {
                let value = self.poly.as_constant().ok_or("the polynomial is not a number")?;
                check(self.relation.holds(&value), || format!("the value {value} is not as claimed"))
            }
            Certificate::Bernstein(tree) => bernstein::subdivision(self, tree),
            Certificate::Corners { var, low, high, middle } => {
                let middle = middle.as_ref().map(|(x, c)| (x, &**c));
                self.corners(*var, low, high, middle, depth)
            }
            Certificate::Factors { number, factors } => self.factors(number, factors, depth),
            Certificate::Faces(faces) => self.faces(faces, depth),
            Certificate::Cells(cells) => levels::cells(self, cells),
            Certificate::Slices(slices) => slices::slices(self, slices, depth),
        }
    }

    /// p = c + m·x lies between its values at the ends of the range of x.
    fn corners(
        &self,
        var: Var,
        low: &Certificate,
        high: &Certificate,
        middle: Option<(&Rational, &Certificate)>,
        depth: usize,
    ) -> Result<(), String> {
        let range = self.range(var)?;
        check(self.poly.degree(var) == 1, || {
            "the polynomial is not of degree 1 in the variable of the corners".into()
        })?;
        let slope = self.poly.derivative(var);
        let mut strict = false;
        for (end, sign, certificate) in [(&range.low, -1, low), (&range.high, 1, high)] {
            let (poly, relation) = match end {
                End::Infinite => (slope.scale(&Rational::from(sign)), Relation::NonNegative),
                End::Excluded(x) => (self.poly.at(var, x), Relation::NonNegative),
                End::Included(x) => {
                    strict = true;
                    (self.poly.at(var, x), self.relation)
                }
            };
            self.part(poly, relation)?.verify(certificate, depth + 1)?;
        }
        let finite = range.low != End::Infinite || range.high != End::Infinite;
        check(finite, || "a range without ends has no corners".into())?;
        if let Some((x, certificate)) = middle {
            check(inside(range, x), || format!("{x} is not strictly inside the range"))?;
            self.part(self.poly.at(var, x), self.relation)?.verify(certificate, depth + 1)?;
            strict = true;
        }
        check(strict || self.relation == Relation::NonNegative, || {
            "nothing shows that the value is not zero".into()
        })
    }

    /// p is a positive multiple of the product of (±f)ᵉ.
    fn factors(&self, number: &Rational, factors: &[Factor], depth: usize) -> Result<(), String> {
        let mut product = Poly::constant(number.clone());
        let mut sign = number.signum();
        for Factor { base, exponent, sign: proof } in factors {
            let degree = u64::from(base.total_degree()) * u64::from(*exponent);
            check(degree <= u64::from(self.poly.total_degree()), || "a factor is too large".into())?;
            check(base.as_constant().is_none() && *exponent > 0, || "a factor is trivial".into())?;
            check(*base == base.normalized(), || {
                "a factor has another sign or number than it could have".into()
            })?;
            product = &product * &base.pow(*exponent);
            let even = exponent % 2 == 0;
            match proof {
                Some((negative, certificate)) => {
                    let signed = if *negative { -base } else { base.clone() };
                    self.part(signed, self.relation)?.verify(certificate, depth + 1)?;
                    if *negative && !even {
                        sign = -sign;
                    }
                }
                None => check(even && self.relation == Relation::NonNegative, || {
                    "the sign of a factor is open".into()
                })?,
            }
        }
        check(product == self.poly, || "the product of the factors is another polynomial".into())?;
        check(sign > 0, || "the product of the signs is negative".into())
    }

    /// p > 0 on each of the open faces.
    fn faces(&self, certificates: &[Certificate], depth: usize) -> Result<(), String> {
        check(self.relation == Relation::Positive, || "faces are for p > 0 only".into())?;
        // The choices by variable, the first variable slowest.
        let choices: Vec<Vec<Option<&Rational>>> = self
            .ranges
            .iter()
            .map(|(_, range)| {
                let ends = [&range.low, &range.high].into_iter().filter(|e| e.is_included()).map(End::value);
                [None].into_iter().chain(ends).collect()
            })
            .collect();
        let count = choices.iter().try_fold(1_usize, |n, c| n.checked_mul(c.len()));
        check(count == Some(certificates.len()), || "the number of faces is another one".into())?;
        for (number, certificate) in certificates.iter().enumerate() {
            let mut rest = number;
            let mut poly = self.poly.clone();
            let mut open = Vec::new();
            for ((var, range), choices) in self.ranges.iter().zip(&choices).rev() {
                match choices[rest % choices.len()] {
                    Some(x) => poly = poly.at(*var, x),
                    None => open.insert(0, (*var, without_ends(range))),
                }
                rest /= choices.len();
            }
            let (relation, cells, work) = (self.relation, self.cells, self.work);
            let whole = Self { poly: poly.clone(), relation, ranges: open, cells, work };
            whole.part(poly, self.relation)?.verify(certificate, depth + 1)?;
        }
        Ok(())
    }
}

/// Whether a number is in a range and not one of its ends.
fn inside(range: &Range, x: &Rational) -> bool {
    range.low.value().is_none_or(|a| a < x) && range.high.value().is_none_or(|b| x < b)
}

fn without_ends(range: &Range) -> Range {
    let open = |end: &End| match end {
        End::Included(x) | End::Excluded(x) => End::Excluded(x.clone()),
        End::Infinite => End::Infinite,
    };
    Range { low: open(&range.low), high: open(&range.high) }
}
