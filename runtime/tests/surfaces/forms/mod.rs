//! What is made of surfaces: parts, joined surfaces, other forms of the same surface, meshes and files.

mod counts;
#[cfg(any(feature = "gltf", feature = "obj", feature = "stl"))]
mod exports;
mod joins;
mod meshes;
mod parts;
mod revolution;
#[cfg(feature = "serde")]
mod serialized;
mod triangles;
