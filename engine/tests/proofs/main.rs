//! Proofs and refutations, written, read, changed, and checked again: by the kernel and by a second checker.

mod explained;
mod independence_on_triangles;
mod mutation;
mod oracle;
mod rounding;
mod rounding_of_sines;
#[path = "../support/mod.rs"]
mod support;
mod theorems;
mod verdicts_check_out;
