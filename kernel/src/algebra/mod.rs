//! Exact algebra: rational numbers, polynomials, and what is computed with them. No number is ever a float.

pub mod bernstein;
pub mod done;
pub mod fibre;
mod monomial;
pub mod poly;
pub mod range;
pub mod rational;
pub mod univariate;
pub mod work;
