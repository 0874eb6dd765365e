//! What `basis!` generates, as numbers: one file for each behaviour.

mod accuracy;
mod agreement;
mod continuations;
mod ends;
mod faithful;
mod laws;
mod matrices;
mod patches;
mod points;
mod related;
mod serialize;
mod squares;
mod triangular_patch;
mod values;
