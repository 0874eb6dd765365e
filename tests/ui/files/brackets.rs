//! Brackets that do not balance, and brackets without end.
use basis_runtime::basis;

basis!("../specs/interval.basis");
basis!("../specs/unclosed.basis");
basis!("../specs/nested.basis");

fn main() {}
