//! The kernel's numbers and polynomials, and quotients of polynomials.

pub use basis_kernel::algebra::{fibre, poly, rational, univariate, work};
pub use basis_prover::algebra::{algebraic, factor, gcd, number, range, simplest};

pub mod fraction;
