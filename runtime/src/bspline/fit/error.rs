//! Why points cannot be fitted.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

use crate::bspline::KnotError;

/// Points that no curve or surface of the wanted kind fits.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FitError {
    /// The knots.
    Knots(KnotError),
    /// There are too few points for the degree or the number of basis functions.
    TooFew {
        /// The number of points that are needed.
        needed: usize,
        /// The number of points.
        found: usize,
    },
    /// There are not as many points as basis functions, so that no curve over the knots, or more than one, passes
    /// through them.
    Functions {
        /// The number of basis functions.
        functions: usize,
        /// The number of points.
        points: usize,
    },
    /// There are not as many parameters, or weights, as points.
    Count {
        /// The number of points.
        expected: usize,
        /// The number of parameters or weights.
        found: usize,
    },
    /// A point, parameter or weight is NaN or infinite.
    NotFinite {
        /// Its index; that of a point of a grid counts row by row.
        index: usize,
    },
    /// A parameter is not larger than the one before it; with parameters from distances, two neighbouring points
    /// coincide.
    NotIncreasing {
        /// The index of the parameter.
        index: usize,
    },
    /// A basis function that the parameters do not determine: too few of them are in its support (the condition of
    /// Schoenberg and Whitney).
    Undetermined {
        /// The index of the basis function.
        function: usize,
    },
}

impl Display for FitError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Knots(error) => error.fmt(f),
            Self::TooFew { needed, found } => write!(f, "{found} points; at least {needed} are needed"),
            Self::Functions { functions, points } => write!(
                f,
                "{points} points; a curve over these knots passes through {functions}, one for each basis function"
            ),
            Self::Count { expected, found } => {
                write!(f, "{found} parameters or weights for {expected} points; each point has one")
            }
            Self::NotFinite { index } => {
                write!(f, "point {index}, its parameter or its weight is not a finite number")
            }
            Self::NotIncreasing { index } => write!(
                f,
                "parameter {index} is not larger than the one before it (do two neighbouring points coincide?)"
            ),
            Self::Undetermined { function } => write!(
                f,
                "basis function {function} is not determined: too few parameters lie in its support; \
                 use fewer knots there"
            ),
        }
    }
}

impl Error for FitError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Knots(error) => Some(error),
            _ => None,
        }
    }
}

impl From<KnotError> for FitError {
    fn from(error: KnotError) -> Self {
        Self::Knots(error)
    }
}
