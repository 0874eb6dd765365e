//! Errors in files that another one uses, and files that use one another.
use basis_runtime::basis;

basis!("../specs/uses_missing.basis");
basis!("../specs/cycle_a.basis");

fn main() {}
