//! Counts the work of a computation, so that it ends on every input at the same point on every machine.

use super::poly::{Poly, Var};
use super::rational::Rational;

/// Work that may still be done, in units of about one product of two numbers of a machine word.
#[derive(Clone, Debug)]
pub struct Work {
    left: u64,
}

impl Work {
    /// The work that checking one proof may take, with `factor` times the usual budget: many times that of a search.
    pub fn usual(factor: u32) -> Self {
        Self::new(200_000_000_u64.saturating_mul(u64::from(factor)))
    }

    /// This number of units.
    pub const fn new(units: u64) -> Self {
        Self { left: units }
    }

    /// More than any computation takes that ends within a lifetime.
    pub const fn unlimited() -> Self {
        Self { left: u64::MAX }
    }

    /// Counts work that is about to be done; `None`, and nothing is left, when there is less.
    pub fn spend(&mut self, units: u64) -> Option<()> {
        let left = self.left.checked_sub(units);
        self.left = left.unwrap_or(0);
        left.map(|_| ())
    }

    /// Counts the work of a product of polynomials; there is never enough for degrees of 2¹⁴ and more.
    pub fn spend_product(&mut self, a: &Poly, b: &Poly) -> Option<()> {
        if a.total_degree().max(b.total_degree()) >= 1 << 14 {
            return self.spend(self.left).and(None);
        }
        // A product of terms costs about as much as six products of numbers.
        self.spend(6 * (a.len() * b.len()) as u64 * ((a.max_bits() + b.max_bits()) / 64 + 1) + 1)
    }

    /// Counts the work of putting a number in place of a variable.
    pub fn spend_at(&mut self, p: &Poly, var: Var, x: &Rational) -> Option<()> {
        let words = 1 + (p.max_bits() + u64::from(p.degree(var)) * x.bits()) / 64;
        self.spend((p.len() as u64).saturating_mul(words).saturating_mul(1 + words / 8))
    }

    /// Counts the work of a product and a difference of fractions of `bits` bits together.
    pub fn spend_fractions(&mut self, bits: u64) -> Option<()> {
        let common_divisors = if bits <= 128 { 0 } else { bits / 2 + bits * bits / 1024 }; // most of it
        self.spend(2 + common_divisors)
    }

    /// The units that are left.
    pub const fn left(&self) -> u64 {
        self.left
    }
}

#[cfg(test)]
mod tests {
    use super::super::done::done;
    use super::*;
    use crate::algebra::poly::Monomial;

    #[test]
    fn what_is_spent_is_not_left() {
        let mut work = Work::new(7);
        assert_eq!((work.spend(3), work.left()), (Some(()), 4));
        assert_eq!((work.spend(4), work.left()), (Some(()), 0));
        assert_eq!((work.spend(0), work.spend(1)), (Some(()), None));
        let mut work = Work::new(7);
        assert_eq!((work.spend(8), work.left(), work.spend(1)), (None, 0, None));
        assert_eq!(Work::usual(3).left(), 600_000_000);
        assert_eq!(Work::usual(u32::MAX).left(), 200_000_000 * u64::from(u32::MAX));
    }

    #[test]
    fn exponents_that_could_wrap_are_refused() {
        let power = |e: u16| Poly::term(Monomial::new(vec![e]), Rational::ONE);
        let mut work = Work::unlimited();
        assert!(work.spend_product(&power((1 << 14) - 1), &power(3)).is_some());
        assert!(work.spend_product(&power(3), &power(1 << 14)).is_none());
        assert!(Work::unlimited().spend_product(&power(1 << 14), &power(0)).is_none());
    }

    #[test]
    fn operations_are_noted() {
        let before = done();
        let sum = &Poly::integer(1) + &Poly::var(Var(0));
        assert!(done() > before && sum.len() == 2);
    }
}
