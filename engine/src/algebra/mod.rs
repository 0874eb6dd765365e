//! The kernel's numbers and polynomials, and quotients of polynomials.

pub use basis_kernel::algebra::{bernstein, fibre};
pub use basis_prover::algebra::{divisors, number, poly, range, rational, real, univariate, work};

pub mod fraction;
