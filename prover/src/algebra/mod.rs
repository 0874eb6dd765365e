//! The kernel's numbers and polynomials, and what only a search needs of algebra: common divisors, factors, resultants,
//! roots, real algebraic numbers, matrices.

pub use basis_kernel::algebra::{bernstein, fibre, poly, rational, univariate, work};

pub mod algebraic;
pub mod factor;
pub mod field;
pub mod gcd;
pub mod matrix;
mod modular;
pub mod number;
pub mod range;
pub mod resultant;
pub mod roots;
pub mod simplest;
