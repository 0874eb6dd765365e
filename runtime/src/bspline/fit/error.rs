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
    /// There are not as many parameters, weights or directions at an edge as points.
    Count {
        /// The number of points.
        expected: usize,
        /// The number of parameters, weights or directions.
        found: usize,
    },
    /// A point, parameter or weight is NaN or infinite.
    NotFinite {
        /// Its index; that of a point of a grid counts row by row.
        index: usize,
    },
    /// A parameter is not larger than the one before it.
    NotIncreasing {
        /// The index of the parameter.
        index: usize,
    },
    /// A point coincides with the one before it, so that parameters do not follow from their distance.
    Coincide {
        /// The index of the point; of a grid, in its row or column. Of a closed curve the number of points stands for the
        /// first one, after the last.
        index: usize,
    },
    /// A basis function that the parameters do not determine: too few of them are in its support (the condition of
    /// Schoenberg and Whitney).
    Undetermined {
        /// The index of the basis function.
        function: usize,
    },
    /// There are fewer control points than the degree and one.
    TooFewFunctions {
        /// The number that is needed.
        needed: usize,
        /// The number that was asked for.
        found: usize,
    },
    /// A parameter is outside of the domain of the curve.
    Outside {
        /// Its index.
        index: usize,
        /// The parameter.
        parameter: f64,
        /// The two ends of the domain.
        domain: [f64; 2],
    },
    /// The domain is not bounded, so that parameters must be given.
    Domain,
    /// No curve or surface over these functions has the ends that were asked for, or only one that arrives in the opposite
    /// direction.
    Ends,
    /// The direction at an end is zero, infinite or NaN.
    Tangent {
        /// 0 for the start, 1 for the end.
        end: usize,
    },
    /// The factor of the smoothing is negative, infinite or NaN.
    Smoothing {
        /// The factor.
        value: f64,
    },
    /// The range of a shape value is empty, or not finite.
    Range {
        /// The index of the shape value.
        index: usize,
        /// The two ends of the range.
        range: [f64; 2],
    },
    /// Nowhere in the ranges of the shape values is there a family.
    Shapes,
    /// The tolerance is not a positive, finite number.
    Tolerance {
        /// The tolerance.
        value: f64,
    },
    /// The angle from which on a polygon has a corner is negative or NaN.
    Corner {
        /// The angle.
        value: f64,
    },
    /// No curve that was tried is within the tolerance.
    NotReached {
        /// The tolerance.
        tolerance: f64,
        /// The largest distance of a point from the last curve.
        reached: f64,
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
                write!(f, "{found} parameters, weights or directions for {expected} points; each point has one")
            }
            Self::NotFinite { index } => {
                write!(f, "point {index}, its parameter or its weight is not a finite number")
            }
            Self::NotIncreasing { index } => {
                write!(f, "parameter {index} is not larger than the one before it")
            }
            Self::Coincide { index } => write!(
                f,
                "point {index} coincides with the one before it, so that their distance gives no parameter: leave points \
                 out that repeat, or give parameters"
            ),
            Self::Undetermined { function } => write!(
                f,
                "basis function {function} is not determined: too few parameters lie in its support; \
                 use fewer knots there"
            ),
            Self::TooFewFunctions { needed, found } => {
                write!(f, "{found} control points; a curve of that degree has at least {needed}")
            }
            Self::Outside { index, parameter, domain: [lo, hi] } => {
                write!(f, "parameter {index}, {parameter}, is outside of the domain {lo} <= t <= {hi}")
            }
            Self::Domain => f.write_str("the domain is not bounded; give the parameters of the points"),
            Self::Ends => f.write_str(
                "no curve or surface over these functions has the ends that were asked for; use more functions or freer \
                 ends",
            ),
            Self::Tangent { end } => write!(
                f,
                "the direction at the {} is zero or not finite",
                if end == 0 { "start" } else { "end" }
            ),
            Self::Smoothing { value } => {
                write!(f, "the factor of the smoothing is {value}; it is a finite number, at least 0")
            }
            Self::Range { index, range: [lo, hi] } => {
                write!(f, "the range of shape value {index}, from {lo} to {hi}, is empty or not finite")
            }
            Self::Shapes => f.write_str("nowhere in the ranges of the shape values is there a family"),
            Self::Tolerance { value } => write!(f, "the tolerance {value} is not a positive, finite number"),
            Self::Corner { value } => {
                write!(f, "the angle of a corner is {value}; it is a number of radians, at least 0")
            }
            Self::NotReached { tolerance, reached } => write!(
                f,
                "the points are up to {reached} from the curve, more than the tolerance {tolerance}; use a larger one, \
                 less smoothing or freer ends"
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
