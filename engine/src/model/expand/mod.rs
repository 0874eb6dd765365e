//! From a family as it is written to the family itself: its domain (`domain`, with angles `angles`, with several spans
//! `spans`), its shape parameters (`shapes`), its functions (`functions`), all names and functions in any order (`names`,
//! which of them `occurs` in others), and what is claimed (`claims`), at values that are fixed (`fixed`, with the
//! `bindings` of names to values) or everywhere. `build` puts one span together, `whole` all of them.

#[cfg(feature = "angles")]
mod angles;
#[cfg(not(feature = "angles"))]
#[path = "no_angles.rs"]
mod angles;
mod bindings;
mod build;
mod claims;
mod domain;
mod fixed;
mod functions;
pub(crate) mod names;
mod occurs;
pub(super) mod shapes;
pub(crate) mod spans;
pub(crate) mod whole;
