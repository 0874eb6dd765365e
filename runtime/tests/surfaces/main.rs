//! Surfaces over the shipped families: one file for each behaviour.
#![allow(unreachable_pub)]

mod evaluation;
mod families;
mod forms;
#[allow(dead_code)] // shared with other tests
#[path = "../../../tests/src/random.rs"]
mod random;
