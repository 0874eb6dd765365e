//! What has to be true on a cell for a bound to follow.

use super::cell::Cell;
use super::exact::{Exact, Rounds};
use super::least_multiple;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

/// Conditions that are collected on the way to a bound.
pub(super) struct Conditions<'a> {
    pub(super) cell: &'a Cell,
    /// Polynomials that are ≥ 0.
    pub(super) known: Vec<Poly>,
}

impl Conditions<'_> {
    /// Adds p ≥ 0; numbers, and what is there already, are not added.
    pub(super) fn add(&mut self, p: Poly) {
        if p.as_constant().is_none() && !self.known.contains(&p) {
            self.known.push(p);
        }
    }

    /// |p|, if p has one sign on the cell.
    pub(super) fn absolute(&mut self, p: &Poly, work: &mut Work) -> Option<Poly> {
        let p = if self.cell.sign(p, work)? { p.clone() } else { -p };
        self.add(p.clone());
        Some(p)
    }

    /// |p|, or where p changes its sign on the cell, as t² − ω(1 − t)² does for ω > 0, what is not less: a multiple m·q, or where
    /// there is one on one side only, as for ω itself on −1 < ω, p + 2m·q with −p ≤ m·q.
    pub(super) fn size(&mut self, p: &Poly, q: &Poly, work: &mut Work) -> Option<Poly> {
        if let Some(size) = self.absolute(p, work) {
            return Some(size);
        }
        if let Some(most) = self.largest(p, q, work) {
            return Some(q.scale(&most));
        }
        for p in [p.clone(), -p] {
            if let Some(most) = self.cell.ratio(&-&p, q, work) {
                self.add(&p + &q.scale(&most));
                return Some(&p + &q.scale(&(&most * &Rational::from(2))));
            }
        }
        None
    }

    /// Whether a step does not round on the cell.
    pub(super) fn is_exact(&mut self, exact: &mut Exact<'_>, k: usize, work: &mut Work) -> Option<bool> {
        let either = match exact.rounds(k, work)? {
            Rounds::Never => return Some(true),
            Rounds::Always => return Some(false),
            Rounds::Unless(either) => either,
        };
        for both in either {
            if both.iter().all(|p| self.cell.sign(p, work) == Some(true)) {
                for p in both {
                    self.add(p);
                }
                return Some(true);
            }
        }
        Some(false)
    }

    /// A number m ≥ 0 with p ≤ m·q.
    pub(super) fn most(&mut self, p: &Poly, q: &Poly, work: &mut Work) -> Option<Rational> {
        let most = least_multiple(&self.cell.ratio(p, q, work)?, 1 << 20);
        self.add(&q.scale(&most) - p);
        Some(most)
    }

    /// A number m with |p| ≤ m·q.
    pub(super) fn largest(&mut self, p: &Poly, q: &Poly, work: &mut Work) -> Option<Rational> {
        let (above, below) = (self.cell.ratio(p, q, work)?, self.cell.ratio(&-p, q, work)?);
        let most = if above > below { above } else { below };
        let most = least_multiple(&most, 1 << 20);
        let scaled = q.scale(&most);
        self.add(&scaled - p);
        self.add(&scaled + p);
        Some(most)
    }
}

/// The shares of steps in an error, those that are multiples of one another together.
#[derive(Default)]
pub(super) struct Shares {
    pub(super) groups: Vec<Group>,
}

/// Steps whose shares are multiples of one polynomial.
pub(super) struct Group {
    pub(super) poly: Poly,
    /// The sum of the factors of those that always round.
    always: Rational,
    /// The others, with their factors.
    sometimes: Vec<(usize, Rational)>,
}

impl Shares {
    /// Adds the share of a step; `None` when the work is spent.
    pub(super) fn add(
        &mut self,
        exact: &mut Exact<'_>,
        k: usize,
        share: &Poly,
        work: &mut Work,
    ) -> Option<()> {
        let Some((_, leading)) = share.leading_term() else { return Some(()) };
        let poly = share.scale(&leading.recip()?);
        let factor = leading.abs();
        let place = self.groups.iter().position(|group| group.poly == poly);
        let place = place.unwrap_or_else(|| {
            self.groups.push(Group { poly, always: Rational::ZERO, sometimes: Vec::new() });
            self.groups.len() - 1
        });
        let group = &mut self.groups[place];
        match exact.rounds(k, work)? {
            Rounds::Never => {}
            Rounds::Always if !exact.has_own_weight(k) => group.always += &(&factor * &exact.weight(k)),
            Rounds::Always | Rounds::Unless(_) => group.sometimes.push((k, factor)),
        }
        Some(())
    }
}

impl Group {
    /// The sum of the factors of the steps that round on a cell.
    pub(super) fn weight(
        &self,
        exact: &mut Exact<'_>,
        conditions: &mut Conditions<'_>,
        work: &mut Work,
    ) -> Option<Rational> {
        let mut weight = self.always.clone();
        for (k, factor) in &self.sometimes {
            if !conditions.is_exact(exact, *k, work)? {
                weight += &(factor * &exact.weight(*k));
            }
        }
        Some(weight)
    }
}

/// A product of the denominators of quotients, each once; `None` when the work is spent.
pub(super) fn common_denominator(
    quotients: &mut dyn Iterator<Item = &Fraction>,
    work: &mut Work,
) -> Option<Poly> {
    let mut below = Poly::one();
    for quotient in quotients {
        if below.div_exact(quotient.denom()).is_none() {
            work.spend_product(&below, quotient.denom())?;
            below = &below * quotient.denom();
        }
    }
    Some(below)
}

/// A quotient times a multiple of its denominator.
pub(super) fn over(quotient: &Fraction, below: &Poly) -> Option<Poly> {
    Some(quotient.numer() * &below.div_exact(quotient.denom())?)
}
