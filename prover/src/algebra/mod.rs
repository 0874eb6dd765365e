//! The kernel's numbers and polynomials, and what only a search or a spec needs of algebra: common divisors, factors
//! and resultants, real algebraic numbers, matrices.

pub use basis_kernel::algebra::{bernstein, fibre};

pub mod divisors;
pub mod matrix;
pub mod number;
pub mod poly;
pub mod range;
pub mod rational;
pub mod real;
pub mod univariate;
pub mod work;
