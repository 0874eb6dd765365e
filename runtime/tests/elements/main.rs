//! Finite elements: quadrature, functions at many points, nodes, and what belongs to corners, edges and faces.
#![cfg(all(feature = "elements", feature = "macros"))]
#![allow(unreachable_pub)]

mod families;
mod quadrature;
#[allow(dead_code)] // shared with other tests
#[path = "../../../tests/src/random.rs"]
mod random;
