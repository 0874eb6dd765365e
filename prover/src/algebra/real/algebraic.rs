//! Real algebraic numbers: irrational roots of polynomials with rational coefficients.

use core::cmp::Ordering;

use super::roots::{Root, linear, rational_roots};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::{ToPoly, Univariate};
use crate::algebra::work::Work;

/// The only root of a polynomial strictly between two rational numbers.
///
/// The polynomial has no multiple roots, whole coefficients without common factor, a positive leading one, and
/// is not zero at the two numbers. The number may happen to be rational.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Algebraic {
    polynomial: Univariate,
    low: Rational,
    high: Rational,
}

impl Algebraic {
    /// The root of `polynomial` that [`isolate`](super::roots::isolate) found between two numbers; `None` when the
    /// signs there are not opposite.
    pub fn new(polynomial: &Univariate, low: Rational, high: Rational) -> Option<Self> {
        let polynomial = polynomial.normalized();
        let opposite = polynomial.sign_at(&low) * polynomial.sign_at(&high) == -1;
        (opposite && low < high).then_some(Self { polynomial, low, high })
    }

    /// The polynomial whose root the number is.
    pub const fn polynomial(&self) -> &Univariate {
        &self.polynomial
    }

    /// A rational number below.
    pub const fn low(&self) -> &Rational {
        &self.low
    }

    /// A rational number above.
    pub const fn high(&self) -> &Rational {
        &self.high
    }

    /// Halves the interval. A middle that is the root itself is avoided by cutting off a quarter at either side.
    pub fn refine(&mut self) {
        let width = &self.high - &self.low;
        let middle = &self.low + &(&width * &Rational::new(1, 2));
        match self.polynomial.sign_at(&middle) {
            0 => {
                let quarter = &width * &Rational::new(1, 4);
                self.low += &quarter;
                self.high -= &quarter;
            }
            sign if sign == self.polynomial.sign_at(&self.low) => self.low = middle,
            _ => self.high = middle,
        }
    }

    /// Shortens the interval to less than a positive width; `None` when the work is spent.
    pub fn refine_below(&mut self, width: &Rational, work: &mut Work) -> Option<()> {
        while &(&self.high - &self.low) >= width {
            for x in [&self.low, &self.high] {
                work.spend_fractions(x.bits())?;
                self.polynomial.spend_sign(x, work)?;
            }
            self.refine();
        }
        Some(())
    }

    /// The same number as root of a polynomial without rational roots, if it is irrational, in an interval inside the
    /// old one whose ends are short decimals; `None` when the work is spent.
    pub fn tidy(&self, work: &mut Work) -> Option<Self> {
        let mut polynomial = self.polynomial.clone();
        for root in rational_roots(&polynomial, work)? {
            if self.compare(&root) != Ordering::Equal {
                polynomial = polynomial.div_exact(&linear(&root))?.normalized();
            }
        }
        Self { polynomial, low: self.low.clone(), high: self.high.clone() }.shortened(work)
    }

    fn shortened(&self, work: &mut Work) -> Option<Self> {
        for digits in [3, 6, 9, 12] {
            let scale = Rational::from(10_i64.pow(digits));
            let unit = scale.recip()?;
            let mut number = self.clone();
            number.refine_below(&unit, work)?;
            let mut low = &(number.low() * &scale).floor() * &unit;
            if number.compare(&(&low + &unit)) == Ordering::Greater {
                low += &unit;
            }
            let high = &low + &unit;
            if low >= self.low
                && high <= self.high
                && self.polynomial.sign_at(&low) * self.polynomial.sign_at(&high) == -1
            {
                return Some(Self { polynomial: self.polynomial.clone(), low, high });
            }
        }
        Some(self.clone())
    }

    /// The number a + b·x for this number x; `None` for b = 0.
    pub fn affine(&self, a: &Rational, b: &Rational) -> Option<Self> {
        // It is a root of p((y − a)/b).
        let inverse = b.recip()?;
        let back = &Poly::var(Var(0)).scale(&inverse) - &Poly::constant(a * &inverse);
        let polynomial = self.polynomial.to_poly(Var(0)).substitute(Var(0), &back);
        let ends = [&self.low, &self.high].map(|x| a + &(b * x));
        let [low, high] = if b.is_negative() { [ends[1].clone(), ends[0].clone()] } else { ends };
        Self::new(&Univariate::from_poly(&polynomial, Var(0))?, low, high)
    }

    /// How the number compares with a rational one.
    pub fn compare(&self, x: &Rational) -> Ordering {
        if x <= &self.low {
            return Ordering::Greater;
        }
        if x >= &self.high {
            return Ordering::Less;
        }
        match self.polynomial.sign_at(x) {
            0 => Ordering::Equal,
            sign if sign == self.polynomial.sign_at(&self.low) => Ordering::Greater,
            _ => Ordering::Less,
        }
    }

    /// How the number compares with another one; `None` when the work is spent.
    ///
    /// Equal exactly when the common divisor of the polynomials has its root in both intervals.
    pub fn compare_with(&self, other: &Self, work: &mut Work) -> Option<Ordering> {
        let common = self.polynomial.gcd(&other.polynomial, work)?;
        let (mut a, mut b) = (self.clone(), other.clone());
        loop {
            if a.high <= b.low {
                return Some(Ordering::Less);
            }
            if b.high <= a.low {
                return Some(Ordering::Greater);
            }
            // The intervals overlap; each contains one root of its own polynomial.
            let (low, high) = ((&a.low).max(&b.low), (&a.high).min(&b.high));
            if common.sign_at(low) * common.sign_at(high) == -1 {
                return Some(Ordering::Equal);
            }
            for x in [&mut a, &mut b] {
                let width = &(&x.high - &x.low) * &Rational::new(2, 3);
                x.refine_below(&width, work)?;
            }
        }
    }
}

/// A real number as a root: rational when that is known, else algebraic.
///
/// `None` when the interval of the root does not isolate one of `polynomial`.
pub fn number(polynomial: &Univariate, root: &Root) -> Option<Result<Rational, Algebraic>> {
    match root {
        Root::Exact(x) => Some(Ok(x.clone())),
        Root::Between(a, b) => Algebraic::new(polynomial, a.clone(), b.clone()).map(Err),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(c: &[i64]) -> Univariate {
        Univariate::integers(c)
    }
    fn sqrt2() -> Algebraic {
        Algebraic::new(&p(&[2, 0, -1]), Rational::ONE, Rational::from(2)).expect("opposite signs")
    }

    #[test]
    fn compares_and_refines() {
        let mut x = sqrt2();
        assert_eq!(x.compare(&Rational::new(7, 5)), Ordering::Greater);
        assert_eq!(x.compare(&Rational::new(3, 2)), Ordering::Less);
        x.refine_below(&Rational::new(1, 100), &mut Work::unlimited());
        assert_eq!(x.to_string(), "root of -2 + x^2 between 1.4140625 and 1.421875");
        let tidy = sqrt2().tidy(&mut Work::unlimited()).expect("unlimited");
        assert_eq!(tidy.to_string(), "root of -2 + x^2 between 1.414 and 1.415");
        assert_eq!((tidy.low(), tidy.high()), (&Rational::new(707, 500), &Rational::new(283, 200)));
        // A rational number in disguise is never hit by an end.
        let mut half = Algebraic::new(&p(&[-1, 2]), Rational::ZERO, Rational::ONE).expect("opposite signs");
        half.refine();
        assert_eq!((half.low(), half.high()), (&Rational::new(1, 4), &Rational::new(3, 4)));
        assert_eq!(half.compare(&Rational::new(1, 2)), Ordering::Equal);
        assert_eq!(Algebraic::new(&p(&[-2, 0, 1]), Rational::from(2), Rational::from(3)), None);
    }

    #[test]
    fn compares_algebraic_numbers() {
        let work = &mut Work::unlimited();
        let root = |c: &[i64], a: i64, b: i64| {
            Algebraic::new(&p(c), Rational::from(a), Rational::from(b)).expect("opposite signs")
        };
        let fourth = root(&[-4, 0, 0, 0, 1], 0, 3); // x⁴ = 4
        assert_eq!(sqrt2().compare_with(&fourth, work), Some(Ordering::Equal));
        assert_eq!(sqrt2().compare_with(&root(&[-3, 0, 1], 1, 2), work), Some(Ordering::Less));
        assert_eq!(sqrt2().compare_with(&root(&[-1414, 1000, 0, 0], 1, 2), work), Some(Ordering::Greater));
        let other = p(&[-2, 0, 1]).mul(&p(&[-5, 0, 1]));
        let five = Algebraic::new(&other, Rational::from(2), Rational::from(3)).expect("opposite signs");
        assert_eq!(five.compare_with(&sqrt2(), work), Some(Ordering::Greater));
    }
}
