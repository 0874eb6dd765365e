//! What is of second and higher order in u.
//!
//! A sum of products in which every product carries at most d factors 1 + δ, |δ| ≤ u, and in which the absolute values
//! of the products add up to A, differs from its exact value by its linear part in the δ and at most
//!
//! A·((1 + u)ᵈ − 1 − d u) ≤ A·(d u)² if d u ≤ 1.
//!
//! A product ∏ (1 + xᵢ)^mᵢ differs from 1 + Σ mᵢxᵢ by at most ∏ (1 − |xᵢ|)^−|mᵢ| − 1 − Σ |mᵢ||xᵢ|, because the series
//! of the latter has the absolute values of the coefficients of the former. With S = Σ |mᵢ||xᵢ| ≤ 1/4 this is at most
//! 3S²: −ln(1 − x) ≤ x + x² for 0 ≤ x ≤ 1/2, so that the logarithm of the product is at most z = S + S², and eᶻ ≤ 1 + z
//! + z² for 0 ≤ z ≤ 1.

use crate::algebra::rational::Rational;

/// 2⁻²⁴, the u of `f32`; that of `f64` is smaller.
pub(super) fn unit() -> Rational {
    Rational::new(1, 1 << 24)
}

/// (d u)²/u times A: in units of u, what a sum differs by from its linear part; `None` beyond d u ≤ 1/8.
pub(super) fn of_sum(depth: &Rational, absolute: &Rational) -> Option<Rational> {
    let small = depth * &unit();
    (small <= Rational::new(1, 8)).then(|| &(&(depth * &small) * absolute) * &Rational::ONE)
}

/// 3S²/u: in units of u, what a product differs by from its linear part; S in units of u.
pub(super) fn of_product(sum: &Rational) -> Option<Rational> {
    let small = sum * &unit();
    (small <= Rational::new(1, 4)).then(|| &(sum * &small) * &Rational::from(3))
}
