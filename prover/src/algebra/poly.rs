//! The kernel's polynomials, with what only a search needs of them.

pub use basis_kernel::algebra::poly::{Monomial, Poly, Var};

use super::rational::Rational;
use crate::collections::list::{Listed, Mapped};

/// What a checker does not do with a polynomial.
pub trait PolyExt {
    /// The exact value at a point that gives every variable that occurs; variables beyond the list are 0.
    fn eval(&self, point: &[Rational]) -> Rational;

    /// The polynomial with variables renamed, by their index; no two may get the same name.
    fn rename(&self, names: &[Var]) -> Self;
}

impl PolyExt for Poly {
    /// Over the denominator that all terms have in common: at aᵢ/bᵢ the power e of a variable of degree d is aᵢᵉ·bᵢᵈ⁻ᵉ/bᵢᵈ,
    /// and sums and products of whole numbers look for no common divisors.
    fn eval(&self, point: &[Rational]) -> Rational {
        let coordinate = |i: usize| point.get(i).unwrap_or(&Rational::ZERO);
        let degrees: Vec<(usize, u32)> = self.variables().into_iter().map(|v| (v.0, self.degree(v))).listed();
        let mut powers: Vec<Vec<(u32, Rational)>> = degrees.mapped(|_| Vec::new());
        let mut sum = Rational::ZERO;
        for (m, c) in self.terms() {
            let mut product = c.clone();
            for ((i, degree), known) in degrees.iter().zip(&mut powers) {
                let e = u32::from(m.exponent(Var(*i)));
                let place = match known.binary_search_by_key(&e, |(e, _)| *e) {
                    Ok(place) => place,
                    Err(place) => {
                        let x = coordinate(*i);
                        known.insert(place, (e, &x.numer().pow(e) * &x.denom().pow(degree - e)));
                        place
                    }
                };
                product *= &known[place].1;
            }
            sum += &product;
        }
        let denominators = degrees.iter().map(|(i, degree)| coordinate(*i).denom().pow(*degree));
        let common = denominators.fold(Rational::ONE, |product, power| &product * &power);
        &sum / &common
    }

    fn rename(&self, names: &[Var]) -> Self {
        if names.iter().enumerate().all(|(i, v)| i == v.0) {
            return self.clone();
        }
        let width = names.iter().map(|v| v.0 + 1).max().unwrap_or(0);
        let rename = |m: &Monomial| {
            let mut exponents = vec![0; width];
            for (i, e) in m.exponents().into_iter().enumerate() {
                exponents[names[i].0] = e;
            }
            Monomial::new(exponents)
        };
        Self::from_terms(self.terms().map(|(m, c)| (rename(m), c.clone())))
    }
}
