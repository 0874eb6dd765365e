//! Numbers tan(π/n), which are irrational and algebraic, as variables.
//!
//! Functions are expanded as if they were free: sines and cosines of an angle whose domain ends there have denominators
//! 1 + x²y² with such a number x, and what these share is found in that form only. Before it is asked whether a value is 0
//! its numerator is divided by the minimal polynomial of the number. What is left has a smaller degree, and a number that
//! is the zero of no polynomial of a smaller degree makes it 0 only if all of its coefficients are 0.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::Algebraic;
use crate::algebra::real::field::Field;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;

/// The number tan(π/n).
#[derive(Clone, Debug)]
pub struct Root {
    /// The variable that stands for it.
    pub var: Var,
    /// n
    pub parts: i64,
    /// The number, as a zero of its minimal polynomial.
    pub number: Algebraic,
    /// Its value in terms of a number tan(π/m), n a divisor of m; `None` if there is no other one.
    pub finer: Option<Poly>,
}

/// The work for the reciprocal of a number.
const RECIPROCAL: u64 = 100_000;

impl Root {
    fn degree(&self) -> u32 {
        self.number.polynomial().degree() as u32
    }

    /// The polynomial of the least degree in the variable that has the same value.
    fn least(&self, p: &Poly) -> Poly {
        let minimal = self.number.polynomial();
        let degree = minimal.degree();
        let mut coefficients = p.coefficients_in(self.var);
        let (true, Some(per)) = (coefficients.len() > degree, minimal.leading().recip()) else {
            return p.clone();
        };
        while coefficients.len() > degree {
            let first = coefficients.pop().unwrap_or_else(Poly::zero).scale(&per);
            let from = coefficients.len() - degree;
            for (c, m) in coefficients[from..].iter_mut().zip(minimal.coefficients()) {
                *c = &*c - &first.scale(m);
            }
        }
        let x = Poly::var(self.var);
        coefficients.iter().rev().fold(Poly::zero(), |sum, c| &(&sum * &x) + c)
    }

    /// The polynomial in the variable whose value is the reciprocal; `None` of one that contains other variables.
    fn reciprocal(&self, p: &Poly) -> Option<Poly> {
        let x = Univariate::from_poly(p, self.var)?;
        let inverse = Field::new(self.number.clone()).inverse(&x, &mut Work::new(RECIPROCAL))?;
        let term = |(k, c): (usize, &Rational)| Poly::var(self.var).pow(k as u32).scale(c);
        Some(inverse.coefficients().iter().enumerate().map(term).fold(Poly::zero(), |sum, c| &sum + &c))
    }
}

/// Whether a quotient is a number made of these.
pub(crate) fn is_number(roots: &[Root], f: &Fraction) -> bool {
    let own = |v: Var| roots.iter().any(|root| root.var == v);
    [f.numer(), f.denom()].iter().all(|p| p.variables().into_iter().all(own))
}

/// A quotient with the same value whose numerator is 0 if that is; of a number nothing is left below the fraction line.
pub(crate) fn reduced(roots: &[Root], f: Fraction) -> Fraction {
    let Some(root) = roots.iter().rfind(|root| f.depends_on(root.var)) else { return f };
    // A number that is alone is left in its own terms.
    let others = || roots.iter().filter(|other| other.var != root.var);
    let in_one = |p: &Poly| {
        let put = |p: Poly, other: &Root| match &other.finer {
            Some(value) => p.substitute(other.var, value),
            None => p,
        };
        root.least(&others().fold(p.clone(), put))
    };
    let above = in_one(f.numer());
    let result = if f.denom().as_constant().is_none() && is_number(roots, &Fraction::from(f.denom().clone()))
    {
        let per = root.reciprocal(&in_one(f.denom()));
        per.map(|per| Fraction::from(root.least(&(&above * &per))))
    } else {
        over(&above, &f)
    };
    result.unwrap_or(f)
}

/// Another numerator over a denominator.
fn over(above: &Poly, f: &Fraction) -> Option<Fraction> {
    if above.is_zero() { Some(Fraction::zero()) } else { Fraction::normalized(above, f.denom()) }
}

/// A quotient with the same value, in which powers that come from products of numbers are replaced by lower ones. Those that
/// come from the tangent at an end of the domain stand below the fraction line, too.
pub(crate) fn lowered(roots: &[Root], f: Fraction) -> Fraction {
    let is_high = |root: &&Root| f.numer().degree(root.var) >= f.denom().degree(root.var) + root.degree();
    let high = roots.iter().filter(is_high).fold(None, |known: Option<Poly>, root| {
        Some(root.least(known.as_ref().unwrap_or_else(|| f.numer())))
    });
    high.and_then(|above| over(&above, &f)).unwrap_or(f)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// √2 − 1 = tan(π/8).
    fn eighth() -> Root {
        let minimal = Univariate::integers(&[-1, 2, 1]);
        let number = Algebraic::new(&minimal, Rational::ZERO, Rational::ONE).unwrap();
        Root { var: Var(0), parts: 8, number, finer: None }
    }

    #[test]
    fn values_that_are_zero_are_seen() {
        let (x, y) = (Fraction::var(Var(0)), Fraction::var(Var(1)));
        let one = Fraction::constant(Rational::ONE);
        let roots = [eighth()];
        // (x + 1)² = 2
        let two = reduced(&roots, (&x + &one).pow(2));
        assert_eq!(two, &one + &one);
        // 1/x = x + 2, also beside another variable.
        assert_eq!(reduced(&roots, one.checked_div(&x).unwrap()), &x + &two);
        let below = &one + &(&y * &y);
        let sum = (&(&x * &x) + &(&x + &x)).checked_div(&below).unwrap();
        let one_over = one.checked_div(&below).unwrap();
        assert_eq!(reduced(&roots, &sum - &one_over), Fraction::zero());
        assert_eq!(reduced(&roots, y.clone()), y);
    }

    /// Of tan(π/8) in terms of tan(π/16) nothing is lost.
    #[test]
    fn numbers_that_are_made_of_others() {
        let mut eighth = eighth();
        let z = Poly::var(Var(2));
        // tan(π/16) = z: 2z/(1 − z²), which is −1/2·(z³ + 4z² − 3z − 2) with z⁴ + 4z³ − 6z² − 4z + 1 = 0.
        let minimal = Univariate::integers(&[1, -4, -6, 4, 1]);
        let number = Algebraic::new(&minimal, Rational::ZERO, Rational::new(1, 4)).unwrap();
        let finest = Root { var: Var(2), parts: 16, number, finer: None };
        let quotient = Fraction::new(&z + &z, &Poly::one() - &(&z * &z)).unwrap();
        let value = reduced(std::slice::from_ref(&finest), quotient.clone());
        eighth.finer = value.as_poly().cloned();
        let roots = [eighth, finest];
        assert_eq!(reduced(&roots, &quotient - &Fraction::var(Var(0))), Fraction::zero());
        // Alone it stays what it is.
        assert_eq!(reduced(&roots, Fraction::var(Var(0))), Fraction::var(Var(0)));
    }
}
