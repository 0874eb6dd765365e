//! The kernel's polynomials, with what only a search needs of them.

pub use basis_kernel::algebra::poly::{Monomial, Poly, Var};

use super::rational::Rational;

/// What a checker does not do with a polynomial.
pub trait PolyExt {
    /// The exact value at a point that gives every variable that occurs; variables beyond the list are 0.
    fn eval(&self, point: &[Rational]) -> Rational;

    /// The polynomial with variables renamed, by their index; no two may get the same name.
    fn rename(&self, names: &[Var]) -> Self;
}

impl PolyExt for Poly {
    fn eval(&self, point: &[Rational]) -> Rational {
        let mut sum = Rational::ZERO;
        for (m, c) in self.terms() {
            let mut product = c.clone();
            for (i, e) in m.exponents().iter().enumerate() {
                if *e > 0 {
                    product = &product * &point.get(i).unwrap_or(&Rational::ZERO).pow(u32::from(*e));
                }
            }
            sum += &product;
        }
        sum
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
