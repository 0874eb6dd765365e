//! What can be wrong with knots, control points and weights.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// A knot vector, or a parameter, that does not define what was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum KnotError {
    /// A knot is NaN or infinite.
    NotFinite {
        /// The index of the knot.
        index: usize,
    },
    /// A knot is smaller than the one before it.
    Decreasing {
        /// The index of the smaller knot.
        index: usize,
    },
    /// A knot occurs more than degree + 1 times.
    Multiplicity {
        /// The knot.
        knot: f64,
        /// How often it occurs, or would occur.
        multiplicity: usize,
        /// The degree.
        degree: usize,
    },
    /// There are fewer than 2 (degree + 1) knots.
    TooFew {
        /// The number of knots.
        found: usize,
        /// The degree.
        degree: usize,
    },
    /// The degree is above [`MAX_DEGREE`](super::MAX_DEGREE).
    Degree {
        /// The degree.
        degree: usize,
    },
    /// There is no memory for the knots.
    Memory,
    /// The knots `t[k]` and `t[n]`, between which the curve is defined, are equal, or so near that their difference is
    /// 0.
    EmptyDomain {
        /// Their value.
        at: f64,
    },
    /// The knots are so far apart that their difference is infinite.
    Overflow,
    /// A parameter is NaN or outside of the domain.
    Outside {
        /// The parameter.
        parameter: f64,
        /// The ends of the domain.
        domain: [f64; 2],
    },
    /// Knots are divided at an end of the domain, where nothing would remain on one side. `split` of curves and surfaces
    /// returns [`CurveError::AtEnd`](crate::CurveError::AtEnd) there.
    AtEnd {
        /// The parameter.
        parameter: f64,
    },
    /// A knot that is to be removed is not an inner knot.
    NoInnerKnot {
        /// The parameter.
        parameter: f64,
    },
    /// Two knot vectors that should be merged have different domains.
    Domains {
        /// The ends of both domains.
        domains: [[f64; 2]; 2],
    },
}

impl Display for KnotError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { index } => write!(f, "knot {index} is not a finite number"),
            Self::Decreasing { index } => {
                write!(f, "knot {index} is smaller than the knot before it; knots must not decrease")
            }
            Self::Multiplicity { knot, multiplicity, degree } => write!(
                f,
                "the knot {knot} occurs {multiplicity} times; at degree {degree} at most {} are possible",
                degree.saturating_add(1)
            ),
            Self::TooFew { found, degree } => write!(
                f,
                "{found} knots; a curve of degree {degree} needs at least {}",
                degree.saturating_add(1).saturating_mul(2)
            ),
            Self::Degree { degree } => {
                write!(f, "the degree {degree} is above the highest possible, {}", super::MAX_DEGREE)
            }
            Self::Memory => f.write_str(
                "there is not enough memory for that many knots; use fewer spans or a lower degree",
            ),
            Self::EmptyDomain { at } => {
                write!(f, "the domain is the single number {at}; its two ends must be different knots")
            }
            Self::Overflow => write!(f, "the difference of two knots is infinite; scale the parameter"),
            Self::Outside { parameter, domain: [lo, hi] } => {
                write!(f, "the parameter {parameter} is outside of the domain {lo} <= t <= {hi}")
            }
            Self::AtEnd { parameter } => {
                write!(f, "a split at {parameter}, an end of the domain, leaves nothing on one side")
            }
            Self::NoInnerKnot { parameter } => write!(f, "{parameter} is not an inner knot"),
            Self::Domains { domains: [[a, b], [c, d]] } => write!(
                f,
                "the domains {a} <= t <= {b} and {c} <= t <= {d} differ; map one of them to the other first"
            ),
        }
    }
}

impl Error for KnotError {}

/// A curve or surface that cannot be made from what was given.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SplineError {
    /// The knots.
    Knots(KnotError),
    /// The number of control points is not the number of basis functions, `knots - degree - 1`.
    Count {
        /// The number of basis functions.
        expected: usize,
        /// The number of control points.
        found: usize,
    },
    /// The size of a net is not the number of basis functions in both directions.
    Size {
        /// Rows and columns that the knots ask for.
        expected: [usize; 2],
        /// Rows and columns of the net.
        found: [usize; 2],
    },
    /// There is no memory for the points of a net.
    Memory {
        /// The number of its rows.
        rows: usize,
        /// The number of its columns.
        columns: usize,
    },
    /// The rows of a net have different lengths, or there are none.
    Ragged {
        /// The first row whose length differs.
        row: usize,
    },
    /// The number of weights is not that of the control points.
    Weights {
        /// The number of control points.
        expected: usize,
        /// The number of weights.
        found: usize,
    },
    /// The angle of a turn is not in `0 < angle <= 2π`.
    Angle {
        /// The angle in radians.
        angle: f64,
    },
    /// The direction of an axis is zero or not finite.
    Axis,
    /// A weight is not a positive finite number.
    Weight {
        /// The index of the weight; in a net row by row.
        index: usize,
        /// The weight.
        weight: f64,
    },
}

impl Display for SplineError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Knots(error) => error.fmt(f),
            Self::Count { expected, found } => {
                write!(f, "{found} control points; the knots ask for {expected} (knots - degree - 1)")
            }
            Self::Size { expected: [rows, columns], found: [r, c] } => {
                write!(f, "a net of {r} x {c} control points; the knots ask for {rows} x {columns}")
            }
            Self::Memory { rows, columns } => {
                write!(
                    f,
                    "there is not enough memory for a net of {rows} rows and {columns} columns; use a smaller one"
                )
            }
            Self::Ragged { row } => {
                write!(f, "row {row} of the net is empty or has not as many points as the first")
            }
            Self::Weights { expected, found } => {
                write!(f, "{found} weights for {expected} control points; each point has one")
            }
            Self::Angle { angle } => {
                write!(f, "a turn by {angle}; the angle is in radians, above 0 and at most 2π")
            }
            Self::Axis => f.write_str("the direction of the axis is zero or not finite"),
            Self::Weight { index, weight } => {
                write!(f, "weight {index} is {weight}; weights are positive finite numbers")
            }
        }
    }
}

impl Error for SplineError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Knots(error) => Some(error),
            _ => None,
        }
    }
}

impl From<KnotError> for SplineError {
    fn from(error: KnotError) -> Self {
        Self::Knots(error)
    }
}
