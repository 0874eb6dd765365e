//! What can be asked of every type of curve, under one name.
#![cfg(all(feature = "std", feature = "bspline"))]
#![allow(unreachable_pub)]

mod closest;
mod continued;
mod degenerate;
mod hostile;
mod intersections;
#[cfg(feature = "angles")]
mod mixed;
mod piercings;
mod queries;
#[allow(dead_code)] // shared with other tests
#[path = "../../../tests/src/random.rs"]
mod random;
mod surfaces;
mod triangles;
mod vocabulary;
