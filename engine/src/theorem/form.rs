//! Vectors and outer products as linear forms: combinations of points, or of pairs of points, whose coefficients are
//! rational functions of the scalars.

use crate::algebra::fraction::Fraction;
use crate::algebra::rational::Rational;
#[cfg(feature = "joins")]
use crate::model::budget::{Budget, TooLarge};
use basis_prover::collections::map::SortedMap;

/// What a coefficient stands before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Unit {
    /// A point that is given; with coordinates a basis vector.
    Point(usize),
    /// The outer product p ∧ q of two of them, p before q.
    Pair(usize, usize),
}

/// A linear combination of units; no coefficient is zero.
///
/// As an expression in points that can be any points of a space of two or more dimensions it is zero only if it has no
/// terms: points and, likewise, outer products of pairs are linearly independent as functions of the points.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Form {
    /// The terms.
    pub terms: SortedMap<Unit, Fraction>,
}

impl Form {
    /// 1 times a unit.
    pub fn unit(unit: Unit) -> Self {
        let mut terms = SortedMap::new();
        terms.insert(unit, Fraction::constant(Rational::ONE));
        Self { terms }
    }

    /// Whether nothing is left.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The coefficient of a unit.
    pub fn coefficient(&self, unit: Unit) -> Fraction {
        self.terms.get(&unit).cloned().unwrap_or_else(Fraction::zero)
    }

    /// The value at a point of the scalars when the points are given by coordinates; a pair has one coordinate, that of
    /// the plane of the first two; `None` where a denominator is zero.
    pub fn eval(&self, scalars: &[Rational], points: &[Vec<Rational>]) -> Option<Vec<Rational>> {
        let mut sum: Vec<Rational> = Vec::new();
        for (unit, value) in &self.terms {
            let factor = value.eval(scalars)?;
            let vector = match unit {
                Unit::Point(p) => points.get(*p)?.clone(),
                Unit::Pair(p, q) => {
                    let (p, q) = (points.get(*p)?, points.get(*q)?);
                    vec![&(&p[0] * &q[1]) - &(&p[1] * &q[0])]
                }
            };
            sum.resize(vector.len().max(sum.len()), Rational::ZERO);
            for (s, x) in sum.iter_mut().zip(vector) {
                *s += &(&factor * &x);
            }
        }
        Some(sum)
    }
}

/// Arithmetic within a budget, for the expressions of theorems and joins.
#[cfg(feature = "joins")]
impl Form {
    /// Adds a multiple of a unit.
    pub(super) fn add_term(&mut self, unit: Unit, value: &Fraction, budget: &Budget) -> Result<(), TooLarge> {
        let sum = match self.terms.get(&unit) {
            Some(old) => budget.add(old, value)?,
            None => value.clone(),
        };
        if sum.is_zero() {
            self.terms.remove(&unit);
        } else {
            self.terms.insert(unit, sum);
        }
        Ok(())
    }

    /// Adds a multiple of another form.
    pub(super) fn add_scaled(
        &mut self,
        other: &Self,
        factor: &Fraction,
        budget: &Budget,
    ) -> Result<(), TooLarge> {
        for (unit, value) in &other.terms {
            self.add_term(*unit, &budget.mul(value, factor)?, budget)?;
        }
        Ok(())
    }

    /// Every coefficient replaced by another.
    pub(crate) fn map<E>(&self, with: &mut dyn FnMut(&Fraction) -> Result<Fraction, E>) -> Result<Self, E> {
        let mut terms = SortedMap::new();
        for (unit, value) in &self.terms {
            let value = with(value)?;
            if !value.is_zero() {
                terms.insert(*unit, value);
            }
        }
        Ok(Self { terms })
    }

    /// a ∧ b: Σ (aₚ·b_q − a_q·bₚ) p ∧ q over the pairs p before q.
    pub(super) fn outer(&self, other: &Self, budget: &Budget) -> Result<Self, TooLarge> {
        let mut result = Self::default();
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                let (Unit::Point(p), Unit::Point(q)) = (*a, *b) else { continue };
                let product = budget.mul(x, y)?;
                if p < q {
                    result.add_term(Unit::Pair(p, q), &product, budget)?;
                } else if q < p {
                    result.add_term(Unit::Pair(q, p), &-&product, budget)?;
                }
            }
        }
        Ok(result)
    }
}
