//! Generated types of all kinds of families, beside exact values.

#![allow(mixed_script_confusables, confusable_idents)] // families have α and γ beside a and y

mod beside;
mod joins;
mod near_ends;
mod rational;
mod refuted_claims;
mod shapes;
mod single_precision;
mod spans;
