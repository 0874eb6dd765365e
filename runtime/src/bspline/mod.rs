//! B-spline curves and surfaces over arbitrary knot vectors, polynomial and rational.
//!
//! | | polynomial | rational |
//! | --- | --- | --- |
//! | curves | [`BSplineCurve`] | [`NurbsCurve`] |
//! | surfaces | [`BSplineSurface`] | [`NurbsSurface`] |
//!
//! All of them stand over [`KnotVector`]s, which are validated when they are made; after that nothing can fail for their
//! sake. A rational curve is a polynomial one of [`Homogeneous`] points. Insertion, removal, degree elevation, splitting,
//! Bézier extraction and merging are the same code for all four.
//!
//! The control points are any [`Point`](crate::Point); `f32` and `f64` both work.

mod bounds;
mod buffer;
mod constrain;
mod curve;
mod error;
mod fit;
mod functions;
mod homogeneous;
mod knots;
mod net;
mod network;
mod nurbs_curve;
mod nurbs_surface;
mod project;
mod rows;
mod splice;
mod surface;

pub use constrain::{Constrained, ConstraintError, PointConstraint};
pub use curve::{BSplineCurve, BezierPiece};
pub use error::{KnotError, SplineError};
pub use fit::{FitError, Spacing, parameters};
pub use homogeneous::Homogeneous;
pub use knots::{KnotVector, MAX_DEGREE};
pub use net::Net;
pub use network::{FollowOptions, Followed, Network, NetworkError, Seam};
pub use nurbs_curve::NurbsCurve;
pub use nurbs_surface::NurbsSurface;
pub use project::Projection;
pub use splice::{
    Continuity, Joint, JointMeasure, Method, Splice, SpliceError, SpliceOptions, measure_joint, splice,
};
pub use surface::{BSplineSurface, BezierPatch, Direction};

pub use crate::Edge;
