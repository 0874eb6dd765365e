//! Formulas copied from a paper.
use basis_runtime::basis;

basis!("../specs/glyphs.basis");

fn main() {}
