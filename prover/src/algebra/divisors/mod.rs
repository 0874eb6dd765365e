//! What polynomials have in common: divisors, factors and resultants.

pub mod factor;
pub mod gcd;
pub(super) mod modular;
pub mod resultant;
