//! The edges of surfaces: what lies along them, and surfaces that join there.

mod edge;
mod join;

pub use edge::{Direction, Edge, EdgeContinuity, EdgePair, edge_continuity};
pub use join::JoinError;
