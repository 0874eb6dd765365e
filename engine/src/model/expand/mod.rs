//! From a family as it is written to the family itself: its domain (`build`, with angles `angles`), its shape parameters
//! (`shapes`), its functions (`functions`, by loops and by recursion, `function` a single one), all of them in any order
//! (`names`), whether their indices leave a gap (`indices`), and what is claimed (`claims`).

pub(crate) mod angles;
pub(crate) mod build;
pub(crate) mod claims;
mod function;
mod functions;
mod indices;
pub(crate) mod names;
mod shapes;
pub(crate) mod spans;
