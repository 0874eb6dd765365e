//! From a family as it is written to the family itself: its domain (`domain`, with angles `angles`, with several spans
//! `spans`), its shape parameters (`shapes`), its functions (`functions`, by loops and by recursion, `function` a single
//! one), all of them in any order (`names`), whether their indices leave a gap (`indices`), and what is claimed
//! (`claims`), at values that are fixed (`fixed`) or everywhere.
//! `build` puts one span together, `whole` all of them.

#[cfg(feature = "angles")]
mod angles;
#[cfg(not(feature = "angles"))]
#[path = "no_angles.rs"]
mod angles;
mod build;
mod claims;
mod domain;
mod fixed;
#[cfg(feature = "angles")]
mod fixed_angle;
#[cfg(not(feature = "angles"))]
#[path = "no_fixed_angle.rs"]
mod fixed_angle;
mod function;
mod functions;
mod indices;
pub(crate) mod names;
mod occurs;
pub(super) mod shapes;
pub(crate) mod spans;
pub(crate) mod whole;
