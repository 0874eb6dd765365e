//! The families of the papers, generated as in any other crate.
#![allow(missing_docs)]

use basis_runtime::basis;

basis!(library "quadratic");
basis!(library "quartic");
basis!(library "triangular", TriangularI(2), TriangularII(3));
