//! The runtime's numbers, on families written by hand as `basis!` emits them: one module for each behaviour.
// The families are written as the macro emits them.
#![allow(unreachable_pub, clippy::unused_self, clippy::trivially_copy_pass_by_ref)]

mod accuracy;
mod bernstein;
mod derivatives;
mod domain;
mod ends;
mod extents;
mod extrapolation;

mod families;
mod frames;
mod infer;
mod length;
mod nearest;
mod not_a_number;
mod parts;
mod piecewise;
mod points;
#[allow(dead_code)] // shared with other tests
#[path = "../../../tests/src/random.rs"]
mod random;
mod reference;
mod shape;
mod slices;
mod values;
