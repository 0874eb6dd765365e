//! How large formulas may become, counted in work and never in time, so that one spec gives one result on
//! every machine.

use core::cell::{Cell, RefCell};

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::{Spent, Work};

/// The highest total degree of a polynomial.
pub(crate) const MAX_DEGREE: u32 = 100;
/// The most terms of a polynomial.
const MAX_TERMS: usize = 20_000;
/// The most bits of a coefficient.
const MAX_BITS: u64 = 20_000;
/// The most term products in the expansion of the functions of one family, and of each of its claims.
const MAX_WORK: u64 = 400_000;
/// The most work to bring quotients into lowest terms, for the functions of a family and for each of its claims.
const MAX_REDUCTION: u64 = 4_000_000;

/// The work that is left for the expansion of the functions of a family, or of a claim.
#[derive(Debug)]
pub(super) struct Budget {
    work: Cell<u64>,
    reduction: RefCell<Work>,
}

/// How much an operation on coefficients of so many bits costs, compared with one on machine words: mostly for common divisors.
const fn weight(bits: u64) -> u64 {
    if bits <= 128 { 1 } else { 6 + bits / 64 + (bits / 512) * (bits / 512) }
}

/// Why an expansion was stopped, in words that follow "the formula …".
pub(super) type TooLarge = String;

impl Budget {
    pub(super) const fn new() -> Self {
        Self { work: Cell::new(MAX_WORK), reduction: RefCell::new(Work::new(MAX_REDUCTION)) }
    }

    /// Starts to count anew.
    pub(super) fn refill(&self) {
        self.work.set(MAX_WORK);
        *self.reduction.borrow_mut() = Work::new(MAX_REDUCTION);
    }

    /// The result of an operation on quotients, which may need too much work for common divisors.
    fn reduce<T>(&self, operation: impl FnOnce(&mut Work) -> Result<T, Spent>) -> Result<T, TooLarge> {
        let too_large = |Spent| String::from("has denominators that take too much work to combine");
        operation(&mut self.reduction.borrow_mut()).map_err(too_large)
    }

    /// Counts work; an error when none is left.
    pub(super) fn spend(&self, amount: u64) -> Result<(), TooLarge> {
        match self.work.get().checked_sub(amount) {
            Some(left) => {
                self.work.set(left);
                Ok(())
            }
            None => {
                self.work.set(0);
                Err(format!("takes more than {MAX_WORK} products of terms to expand"))
            }
        }
    }

    /// Counts a product before it is computed.
    fn before_product(&self, a: &Poly, b: &Poly) -> Result<(), TooLarge> {
        if a.is_one() && b.is_one() {
            return self.spend(1);
        }
        let degree = a.total_degree() + b.total_degree();
        if degree > MAX_DEGREE {
            return Err(format!("has degree {degree}; the highest degree is {MAX_DEGREE}"));
        }
        let bits = a.max_bits() + b.max_bits();
        if bits > MAX_BITS {
            return Err(format!("has coefficients of {bits} bits; the most is {MAX_BITS}"));
        }
        self.spend(a.len() as u64 * b.len() as u64 * weight(bits))
    }

    fn checked(value: Fraction) -> Result<Fraction, TooLarge> {
        let terms = value.numer().len() + value.denom().len();
        if terms > MAX_TERMS {
            return Err(format!("has {terms} terms; the most is {MAX_TERMS}"));
        }
        Ok(value)
    }

    pub(super) fn add(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, TooLarge> {
        self.before_sum(a, b)?;
        Self::checked(self.reduce(|work| a.add_within(b, work).ok_or(Spent))?)
    }

    pub(super) fn sub(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, TooLarge> {
        self.before_sum(a, b)?;
        Self::checked(self.reduce(|work| a.sub_within(b, work).ok_or(Spent))?)
    }

    fn before_sum(&self, a: &Fraction, b: &Fraction) -> Result<(), TooLarge> {
        let bits = a.numer().max_bits().max(b.numer().max_bits());
        self.spend((a.numer().len() + b.numer().len()) as u64 * weight(bits))?;
        if a.denom() != b.denom() {
            self.before_product(a.numer(), b.denom())?;
            self.before_product(b.numer(), a.denom())?;
            self.before_product(a.denom(), b.denom())?;
        }
        Ok(())
    }

    pub(super) fn mul(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, TooLarge> {
        self.before_product(a.numer(), b.numer())?;
        self.before_product(a.denom(), b.denom())?;
        Self::checked(self.reduce(|work| a.mul_within(b, work).ok_or(Spent))?)
    }

    /// a / b, where b is not zero.
    pub(super) fn div(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, TooLarge> {
        self.before_product(a.numer(), b.denom())?;
        self.before_product(a.denom(), b.numer())?;
        let quotient = self.reduce(|work| a.div_within(b, work))?;
        quotient.ok_or_else(|| String::from("divides by zero")).and_then(Self::checked)
    }

    pub(super) fn pow(&self, base: &Fraction, exponent: u32) -> Result<Fraction, TooLarge> {
        let degree =
            u64::from(base.numer().total_degree().max(base.denom().total_degree())) * u64::from(exponent);
        if degree > u64::from(MAX_DEGREE) {
            return Err(format!("has degree {degree}; the highest degree is {MAX_DEGREE}"));
        }
        let bits = base.numer().max_bits().max(base.denom().max_bits()) * u64::from(exponent);
        let trivial = base.as_constant().is_some_and(|c| c.abs().is_one() || c.is_zero());
        if bits > MAX_BITS && !trivial {
            return Err(format!("has coefficients of {bits} bits; the most is {MAX_BITS}"));
        }
        if base.as_constant().is_some() {
            let small = if exponent == 0 { 0 } else { 2 - exponent % 2 };
            return Ok(base.pow(if trivial { small } else { exponent }));
        }
        // Repeated products with the base, so that every step is counted.
        let mut result = Fraction::constant(Rational::ONE);
        if base.numer().len() <= 2 && base.as_poly().is_some() {
            self.spend((u64::from(exponent) + 1) * weight(bits))?;
            return Ok(base.pow(exponent));
        }
        for _ in 0..exponent {
            result = self.mul(&result, base)?;
        }
        Ok(result)
    }

    /// The partial derivative in a variable.
    pub(super) fn derivative(&self, value: &Fraction, var: Var) -> Result<Fraction, TooLarge> {
        self.spend((value.numer().len() + value.denom().len()) as u64)?;
        self.reduce(|work| value.derivative_within(var, work).ok_or(Spent)).and_then(Self::checked)
    }

    /// The function with another put in place of a variable; `None` when its denominator becomes zero.
    pub(super) fn substitute(
        &self,
        value: &Fraction,
        var: Var,
        by: &Fraction,
    ) -> Result<Option<Fraction>, TooLarge> {
        let degree = value.numer().degree(var).max(value.denom().degree(var));
        let inner = by.numer().total_degree().max(by.denom().total_degree());
        let total = degree * inner + value.numer().total_degree();
        if total > 2 * MAX_DEGREE {
            return Err(format!(
                "has degree {total} after the substitution; the highest degree is {MAX_DEGREE}"
            ));
        }
        let terms = (by.numer().len() + by.denom().len()) as u64;
        let growth = if by.as_constant().is_some() { 1 } else { terms * u64::from(degree + 1) };
        let bits = value.numer().max_bits() + by.numer().max_bits();
        self.spend(growth * (value.numer().len() + value.denom().len()) as u64 * weight(bits))?;
        self.reduce(|work| value.substitute_within(var, by, work))
    }
}
