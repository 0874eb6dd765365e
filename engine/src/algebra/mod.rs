//! Exact algebra: rational numbers, polynomials, rational functions, and what is computed with them.
//!
//! Nothing here knows of specs, and no number is ever a float.

pub mod algebraic;
pub mod bernstein;
pub mod factor;
pub mod fibre;
pub mod fraction;
pub mod gcd;
pub mod matrix;
pub mod modular;
mod monomial;
pub mod poly;
pub mod range;
pub mod rational;
pub mod resultant;
pub mod roots;
pub mod simplest;
pub mod univariate;
pub mod work;
