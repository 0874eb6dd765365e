//! Surfaces over the shipped families: one module for each behaviour.
#![allow(unreachable_pub)]

mod curvature;
mod families;
mod normals;
mod partials;
#[allow(dead_code)] // shared with other tests
#[path = "../numeric/random.rs"]
mod random;
mod revolution;
mod values;
