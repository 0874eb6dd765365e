//! Generated types of all kinds of families, beside exact values.

mod beside;
mod joins;
mod rational;
mod refuted_claims;
#[allow(mixed_script_confusables, confusable_idents)] // a family has α beside p and q
mod shapes;
mod spans;
