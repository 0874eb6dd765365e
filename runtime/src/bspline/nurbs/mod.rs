//! Rational curves and surfaces: polynomial ones of homogeneous points.

mod curve;
mod homogeneous;
mod revolved;
mod surface;

pub use curve::NurbsCurve;
pub use homogeneous::Homogeneous;
pub use surface::NurbsSurface;
