//! The difference polynomial, and an exact point where it is not zero.
use basis_runtime::basis;

basis!("../specs/false_identity.basis");

fn main() {}
