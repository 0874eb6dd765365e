//! Numbers: elementary functions without `std`, binomial coefficients, quadrature rules, vector instructions.

pub(crate) mod binomial;
pub(crate) mod elementary;
#[cfg(any(feature = "elements", feature = "geometry"))]
pub(crate) mod gauss;
#[cfg(feature = "alloc")]
pub(crate) mod leibniz;
#[cfg(feature = "alloc")]
pub(crate) mod linear;
pub(crate) mod simd;
