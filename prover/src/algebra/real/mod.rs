//! Real numbers that are roots of polynomials, between rational ones.

pub mod algebraic;
pub mod field;
pub mod roots;
pub mod simplest;
