//! Families of rational functions, and curves over them.

#[cfg(feature = "geometry")]
mod answers;
mod basis;
#[cfg(feature = "geometry")]
mod bezier;
mod chart;
mod curve;
mod series;

pub use basis::RationalBasis;
#[cfg(feature = "geometry")]
pub use bezier::RationalBezier;
pub use chart::Chart;
pub use curve::RationalCurve;
