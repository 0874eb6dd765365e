//! The kernel's numbers and polynomials, and what only a search needs of algebra: common divisors, factors, resultants,
//! roots, real algebraic numbers, matrices.

pub use basis_kernel::algebra::{bernstein, fibre};

pub mod algebraic;
pub mod factor;
pub mod field;
pub mod gcd;
pub mod matrix;
mod modular;
pub mod number;
pub mod poly;
pub mod range;
pub mod rational;
pub mod resultant;
pub mod roots;
pub mod simplest;
pub mod univariate;
pub mod work;
