//! Real numbers that are roots of polynomials, between rational ones.

pub mod algebraic;
pub mod field;
pub mod reading;
pub mod roots;
pub mod simplest;
