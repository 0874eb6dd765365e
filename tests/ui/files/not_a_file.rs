//! A folder, an empty file, and a file that is not UTF-8 in place of a spec.
use basis_runtime::basis;

basis!("../specs");
basis!("../specs/empty.basis");
basis!("../specs/latin1.basis");

fn main() {}
