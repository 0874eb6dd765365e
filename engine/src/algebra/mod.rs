//! The kernel's numbers and polynomials, and quotients of polynomials.

pub use basis_kernel::algebra::{bernstein, fibre};
pub use basis_prover::algebra::{
    algebraic, factor, gcd, number, poly, range, rational, simplest, univariate, work,
};

pub mod fraction;
