//! The edges of surfaces: what lies along them, and surfaces that join there.

mod edge;
#[cfg(feature = "alloc")]
mod join;
mod join_error;
mod joint;

pub use edge::{Direction, Edge, EdgePair, Orientation};
#[cfg(feature = "bspline")]
pub(crate) use join::factor_of_weights;
#[cfg(feature = "alloc")]
pub(crate) use join::{beyond, possible, solved};
pub use join_error::JoinError;
pub use joint::EdgeJoint;
pub(super) use joint::measured;
