//! The kernel's polynomials in one variable, with the way back to several.

pub use basis_kernel::algebra::univariate::Univariate;

use super::poly::{Monomial, Poly, Var};

/// A polynomial in one variable as one in several.
pub trait ToPoly {
    /// The same polynomial in the given variable.
    fn to_poly(&self, var: Var) -> Poly;
}

impl ToPoly for Univariate {
    fn to_poly(&self, var: Var) -> Poly {
        let monomial = |k: usize| Monomial::one().with_exponent(var, k as u16);
        Poly::from_terms(self.coefficients().iter().enumerate().map(|(k, c)| (monomial(k), c.clone())))
    }
}
