//! Points at which something is evaluated exactly: with rational coordinates, or with coordinates in a field Q(θ) for a
//! real root θ of a polynomial.
//!
//! **Theorems.** A polynomial m with opposite signs at two numbers has a root θ between them. What m divides is zero at
//! θ. A value lies between what interval arithmetic makes of bounds for its parts.

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::refusal::{Refusal, fits, shown};
use crate::statement::{Domain, Quotient, Relation};

/// A root θ of a polynomial m between two numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Root {
    /// The polynomial m, of degree 1 at least.
    pub polynomial: Univariate,
    /// A number below θ.
    pub low: Rational,
    /// A number above θ.
    pub high: Rational,
}

/// A point.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Point {
    /// The number θ, if a coordinate is not rational.
    pub root: Option<Root>,
    /// A coordinate for each of some variables, a polynomial in θ; a number if it is rational.
    pub coordinates: Vec<(Var, Univariate)>,
}

impl Point {
    /// The coordinate of a variable.
    fn coordinate(&self, var: Var) -> Result<&Univariate, Refusal> {
        let found = self.coordinates.iter().find(|(v, _)| *v == var);
        found.map(|(_, x)| x).ok_or(Refusal::Unfit("a point lacks a coordinate"))
    }

    /// Checks that θ exists, and that coordinates are polynomials of lower degree than that of θ.
    pub(crate) fn check(&self, work: &mut Work) -> Result<(), Refusal> {
        let degree = match &self.root {
            None => 1,
            Some(Root { polynomial, low, high }) => {
                for x in [low, high] {
                    polynomial.spend_sign(x, work).ok_or(Refusal::Spent)?;
                }
                let opposite = low < high && polynomial.sign_at(low) * polynomial.sign_at(high) == -1;
                shown(opposite, "a polynomial is not seen to have a root in its interval")?;
                polynomial.degree()
            }
        };
        let reduced = self.coordinates.iter().all(|(_, x)| x.is_zero() || x.degree() < degree);
        fits(reduced, "a coordinate is not reduced")?;
        let twice = |k: usize| self.coordinates[..k].iter().any(|(v, _)| *v == self.coordinates[k].0);
        fits(!(0..self.coordinates.len()).any(twice), "a coordinate is given twice")
    }

    /// The value of a polynomial, reduced to a polynomial in θ of lower degree than that of θ.
    pub(crate) fn value(&self, poly: &Poly, work: &mut Work) -> Result<Univariate, Refusal> {
        // Horner's scheme, one variable after the other.
        let Some(var) = poly.variables().last().copied() else {
            return Ok(Univariate::new(vec![poly.as_constant().unwrap_or(Rational::ZERO)]));
        };
        let x = self.coordinate(var)?;
        if let (true, Some(number)) = (x.is_constant(), Some(x.leading())) {
            work.spend_at(poly, var, &number).ok_or(Refusal::Spent)?;
            return self.value(&poly.at(var, &number), work);
        }
        let mut value = Univariate::default();
        for coefficient in poly.coefficients_in(var).iter().rev() {
            let c = self.value(coefficient, work)?;
            value = self.product(&value, x, work)?.add(&c);
        }
        Ok(value)
    }

    /// The product of two values, reduced modulo the polynomial of θ.
    pub(crate) fn product(
        &self,
        a: &Univariate,
        b: &Univariate,
        work: &mut Work,
    ) -> Result<Univariate, Refusal> {
        let bits = a.max_bits() + b.max_bits();
        let count = (a.degree() as u64 + 1) * (b.degree() as u64 + 1);
        work.spend(count.saturating_mul(1 + bits / 64 + bits * bits / (1 << 16))).ok_or(Refusal::Spent)?;
        match &self.root {
            Some(root) => a.mul(b).modulo(&root.polynomial, work).ok_or(Refusal::Spent),
            None => Ok(a.mul(b)),
        }
    }

    /// The sign of a value that is reduced: 0 only if it is zero whichever root θ is.
    pub(crate) fn sign(&self, value: &Univariate, work: &mut Work) -> Result<i32, Refusal> {
        if value.is_constant() {
            return Ok(value.leading().signum());
        }
        let root =
            self.root.as_ref().ok_or(Refusal::Unfit("a coordinate contains a root that is not given"))?;
        let n = value.degree() as u64 + 1;
        let words = 1 + (value.max_bits() + n * (root.low.bits() + root.high.bits())) / 64;
        work.spend(8 * n * words * words).ok_or(Refusal::Spent)?;
        let (low, high) = enclosure(value, &root.low, &root.high);
        match (low.is_positive(), high.is_negative()) {
            (true, _) => Ok(1),
            (_, true) => Ok(-1),
            _ => Err(Refusal::Vague),
        }
    }

    /// The sign of a polynomial at the point.
    pub(crate) fn sign_of(&self, poly: &Poly, work: &mut Work) -> Result<i32, Refusal> {
        let value = self.value(poly, work)?;
        self.sign(&value, work)
    }

    /// The sign of a quotient at the point.
    pub(crate) fn sign_of_fraction(&self, value: &Quotient, work: &mut Work) -> Result<i32, Refusal> {
        let below = self.sign_of(&value.denominator, work)?;
        shown(below != 0, "a denominator vanishes at the point")?;
        Ok(self.sign_of(&value.numerator, work)? * below)
    }

    /// The exact value of a quotient, if it is rational; 0 where it is zero.
    pub(crate) fn rational_value(
        &self,
        value: &Quotient,
        work: &mut Work,
    ) -> Result<Option<Rational>, Refusal> {
        let above = self.value(&value.numerator, work)?;
        if above.is_zero() {
            return Ok(Some(Rational::ZERO));
        }
        let below = self.value(&value.denominator, work)?;
        let both = above.is_constant() && below.is_constant();
        Ok(if both { above.leading().checked_div(&below.leading()) } else { None })
    }

    /// Checks that the point lies in a domain, or can be completed to one that does: a variable without a coordinate
    /// has any value of its range, and is 0 on a simplex.
    pub(crate) fn lies_in(&self, domain: &Domain, work: &mut Work) -> Result<(), Refusal> {
        for (var, range) in &domain.region.ranges {
            if self.coordinate(*var).is_ok() {
                self.is_in_range(*var, range, work)?;
            } else {
                let once = domain.region.ranges.iter().filter(|(v, _)| v == var).count() == 1;
                shown(once && !range.is_empty(), "a range is empty")?;
            }
        }
        for simplex in &domain.simplices {
            let mut rest = Poly::constant(simplex.sum.clone());
            for var in simplex.variables.iter().filter(|v| self.coordinate(**v).is_ok()) {
                shown(self.sign(self.coordinate(*var)?, work)? >= 0, "a point lies outside of its simplex")?;
                rest = &rest - &Poly::var(*var);
            }
            shown(self.sign_of(&rest, work)? >= 0, "a point lies outside of its simplex")?;
        }
        for (poly, relation) in &domain.premises {
            shown(relation.allows(self.sign_of(poly, work)?), "a premise does not hold at the point")?;
        }
        Ok(())
    }

    /// Checks that a coordinate lies in a range.
    pub(crate) fn is_in_range(&self, var: Var, range: &Range, work: &mut Work) -> Result<(), Refusal> {
        for (end, upper) in [(&range.low, false), (&range.high, true)] {
            let (limit, relation) = match end {
                End::Infinite => continue,
                End::Included(limit) => (limit, Relation::NonNegative),
                End::Excluded(limit) => (limit, Relation::Positive),
            };
            let distance = &Poly::var(var) - &Poly::constant(limit.clone());
            let sign = self.sign_of(&distance, work)?;
            shown(relation.allows(if upper { -sign } else { sign }), "a point lies outside of its ranges")?;
        }
        Ok(())
    }
}

/// Bounds for the values of a polynomial between two numbers, by Horner's scheme with intervals.
fn enclosure(p: &Univariate, low: &Rational, high: &Rational) -> (Rational, Rational) {
    let mut bounds = (Rational::ZERO, Rational::ZERO);
    for c in p.coefficients().iter().rev() {
        let products = [&bounds.0 * low, &bounds.0 * high, &bounds.1 * low, &bounds.1 * high];
        let least = products.iter().min().unwrap_or(&Rational::ZERO);
        let most = products.iter().max().unwrap_or(&Rational::ZERO);
        bounds = (least + c, most + c);
    }
    bounds
}
