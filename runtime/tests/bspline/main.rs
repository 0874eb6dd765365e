//! B-splines: values, derivatives and algorithms against scipy, as laws on random input, and on hostile input.
#![cfg(feature = "std")]

mod closed;
mod constraints;
mod constructions;
mod continued;
mod fitting;
mod golden;
mod joints;
mod knots;
mod networks;
mod projections;
mod rational;
mod rational_constructions;
mod refinement;
mod splicing;
mod support;
mod surfaces;
