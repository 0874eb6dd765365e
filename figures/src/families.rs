//! The families of the papers, generated as in any other crate.
#![allow(missing_docs)]

use basis_runtime::basis;

basis!("../../specs/quadratic.basis");
basis!("../../specs/quartic.basis");
basis!("../../specs/triangular.basis", TriangularI(2), TriangularII(3));
