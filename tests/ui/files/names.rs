//! Names of a spec that cannot be names in Rust.
use basis_runtime::basis;

basis!("../specs/rust_names.basis");

fn main() {}
