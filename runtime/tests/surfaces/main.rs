//! Surfaces over the shipped families: one module for each behaviour.
#![allow(unreachable_pub)]

mod boxes;
mod curvature;
#[cfg(any(feature = "gltf", feature = "obj", feature = "stl"))]
mod exports;
mod families;
mod grids;
mod hostile;
mod joins;
mod meshes;
mod nearest;
mod normals;
mod partials;
mod parts;
#[allow(dead_code)] // shared with other tests
#[path = "../../../tests/src/random.rs"]
mod random;
mod revolution;
#[cfg(feature = "serde")]
mod serialized;
mod triangles;
mod values;
