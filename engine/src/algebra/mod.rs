//! The kernel's numbers and polynomials, and quotients of polynomials.

pub use basis_kernel::algebra::{fibre, poly, range, rational, univariate, work};
pub use basis_prover::algebra::{algebraic, factor, gcd, simplest};

pub mod fraction;
