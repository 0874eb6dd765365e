//! Families of rational functions, and curves over them.

#[cfg(feature = "geometry")]
mod answers;
mod basis;
#[cfg(feature = "geometry")]
mod bezier;
mod chart;
mod curve;
mod series;
mod slices;
mod spanned;
#[cfg(feature = "geometry")]
mod spline;

pub use basis::RationalBasis;
#[cfg(feature = "geometry")]
pub use bezier::RationalBezier;
pub use chart::Chart;
pub use curve::RationalCurve;
pub use spanned::{SpanOf, SpannedBasis, SpannedCurve};
#[cfg(feature = "geometry")]
pub use spline::RationalSpline;
