//! Generated types of all kinds of families, beside exact values.

mod beside;
mod joins;
mod rational;
mod refuted_claims;
mod shapes;
mod spans;
