//! All mistakes of a file are reported in one run, each with its line.
use basis_runtime::basis;

basis!("../specs/several_at_once.basis");

fn main() {}
