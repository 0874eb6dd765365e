//! The cutting of the parameter square of one surface into rectangles (`cells`), each of which its triangles (`facets`) follow
//! within what is asked for (`limits`): how far they are away is bounded in `flat` and `graph`, where to cut says `lines`, how
//! finely to begin `steps`.

pub(super) mod cells;
pub(super) mod facets;
mod flat;
mod graph;
pub(super) mod index;
pub(super) mod limits;
pub(super) mod lines;
mod steps;
