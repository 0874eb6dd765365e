//! The edges of surfaces: what lies along them, and surfaces that join there.

mod edge;
#[cfg(feature = "alloc")]
mod join;
mod join_error;

pub use edge::{Direction, Edge, EdgeContinuity, EdgePair, Orientation, edge_continuity};
pub use join_error::JoinError;
