//! Why curves make no surface.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

use crate::CurveError;
use crate::bspline::{FitError, KnotError, SplineError};

/// Curves from which a surface cannot be made.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ConstructionError {
    /// The common knots.
    Knots(KnotError),
    /// The net.
    Spline(SplineError),
    /// The interpolation of sections.
    Fit(FitError),
    /// The path of a sweep; [`CurveError::NotFinite`] if a control point of the surface would not be finite.
    Curve(CurveError),
    /// Two boundary curves do not meet in a corner.
    Corner {
        /// The corner, 0 for the lower and 1 for the upper end of `u` and of `v`.
        corner: [usize; 2],
        /// The distance of the ends of both curves.
        gap: f64,
    },
}

impl Display for ConstructionError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Knots(error) => error.fmt(f),
            Self::Spline(error) => error.fmt(f),
            Self::Fit(error) => error.fmt(f),
            Self::Curve(error) => error.fmt(f),
            Self::Corner { corner: [u, v], gap } => write!(
                f,
                "the boundary curves at the corner u = {u}, v = {v} are {gap} apart: they should end in one point there"
            ),
        }
    }
}

impl Error for ConstructionError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Knots(error) => Some(error),
            Self::Spline(error) => Some(error),
            Self::Fit(error) => Some(error),
            Self::Curve(error) => Some(error),
            Self::Corner { .. } => None,
        }
    }
}

impl From<KnotError> for ConstructionError {
    fn from(error: KnotError) -> Self {
        Self::Knots(error)
    }
}

impl From<SplineError> for ConstructionError {
    fn from(error: SplineError) -> Self {
        match error {
            SplineError::Knots(error) => Self::Knots(error),
            error => Self::Spline(error),
        }
    }
}

impl From<FitError> for ConstructionError {
    fn from(error: FitError) -> Self {
        match error {
            FitError::Knots(error) => Self::Knots(error),
            error => Self::Fit(error),
        }
    }
}

impl From<CurveError> for ConstructionError {
    fn from(error: CurveError) -> Self {
        Self::Curve(error)
    }
}
