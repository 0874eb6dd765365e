//! The runtime's numbers, on families written by hand as `basis!` emits them: one file for each behaviour.
// The families are written as the macro emits them.
#![allow(unreachable_pub, clippy::unused_self, clippy::trivially_copy_pass_by_ref)]

mod bernstein;
mod evaluation;
mod families;
mod geometry;
#[allow(dead_code)] // shared with other tests
#[path = "../../../tests/src/random.rs"]
mod random;
mod reference;
