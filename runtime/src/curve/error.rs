//! What can be wrong with a question about a curve.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

use crate::ShapeError;

/// A question about a curve that has no answer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum CurveError {
    /// A parameter is NaN or outside of the domain.
    Parameter {
        /// The parameter.
        value: f64,
        /// The two ends of the domain.
        domain: [f64; 2],
    },
    /// A curve is to be divided at an end of its domain, where nothing would remain on one side.
    AtEnd {
        /// The parameter.
        parameter: f64,
    },
    /// Both ends of a range of parameters are equal.
    EmptyRange {
        /// Their value.
        at: f64,
    },
    /// A weight is not a positive, finite number.
    Weight {
        /// The index of the weight.
        index: usize,
        /// The weight.
        value: f64,
    },
    /// A tolerance is not a positive, finite number.
    Tolerance {
        /// The tolerance.
        value: f64,
    },
    /// A distance is not finite, or a width not positive and finite.
    Distance {
        /// The distance or width.
        value: f64,
    },
    /// A control point is infinite or NaN.
    NotFinite,
    /// Two slices that belong together have different lengths.
    Length {
        /// The length that is needed.
        expected: usize,
        /// The length that was given.
        found: usize,
    },
    /// The answer exists only for points with another number of components.
    Dimension {
        /// The number of components that is needed.
        expected: usize,
        /// The number of components of the points.
        found: usize,
    },
    /// The degree of the curve is too high to be written in that type.
    Degree {
        /// The highest degree that can be written.
        most: usize,
        /// The degree of the curve.
        found: usize,
    },
    /// The curve has no direction: all of its control points coincide.
    NoTangent,
    /// The curve is straight or has a cusp there, so that no normal is distinguished.
    NoNormal {
        /// The parameter.
        parameter: f64,
    },
    /// A curve of several segments needs at least one.
    NoSegments,
    /// The control points next to an end of a curve do not determine its derivatives there.
    Join {
        /// The family of the curve.
        family: &'static str,
        /// The number of derivatives that were to be met, the value included.
        conditions: usize,
        /// The shape values at which this is so, such as `λ = -3`; empty where no formula says it.
        at: &'static str,
    },
    /// The contact is of a higher order than the number of control points allows.
    Contact {
        /// The family of the curve that was to follow.
        family: &'static str,
        /// The highest order: one less than the number of control points.
        most: usize,
        /// The order asked for.
        found: usize,
    },
    /// A factor of a [`Contact`](crate::Contact) is not finite, or `f`, a ratio of velocities, not positive.
    Factor {
        /// Which one, `f` or `c`.
        name: &'static str,
        /// The factor.
        value: f64,
    },
    /// A shape value or another scalar of a join is outside of its range.
    Shape(ShapeError),
    /// The tolerance asks for more points than can be made.
    TooManyPoints {
        /// The number of points that would be needed.
        needed: f64,
    },
}

impl Display for CurveError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Parameter { value, domain: [lo, hi] } => {
                write!(f, "the parameter {value} is outside of the domain {lo} <= t <= {hi}")
            }
            Self::AtEnd { parameter } => {
                write!(f, "a split at {parameter}, an end of the domain, leaves nothing on one side")
            }
            Self::EmptyRange { at } => {
                write!(f, "the range from {at} to {at} is empty: its two ends must be different parameters")
            }
            Self::Weight { index, value } => {
                write!(f, "weight {index} is {value}; weights are positive finite numbers")
            }
            Self::Tolerance { value } => {
                write!(f, "the tolerance {value} is not a positive, finite number")
            }
            Self::Distance { value } => {
                write!(f, "{value} is no distance or width: a distance is finite, a width positive too")
            }
            Self::NotFinite => write!(f, "a control point is infinite or NaN"),
            Self::Length { expected, found } => {
                write!(f, "a slice of length {expected} is needed, this one has length {found}")
            }
            Self::Dimension { expected, found } => {
                write!(f, "points with {expected} components are needed, these have {found}")
            }
            Self::Degree { most, found } => {
                write!(f, "the degree of the curve is {found}, at most {most} can be written")
            }
            Self::NoTangent => write!(f, "all control points coincide: the curve has no tangent"),
            Self::NoNormal { parameter } => {
                write!(
                    f,
                    "the curve is straight or has a cusp at {parameter}: it has no principal normal there"
                )
            }
            Self::NoSegments => write!(f, "a curve needs at least one segment"),
            Self::Join { family, conditions, at } => {
                let separator = if at.is_empty() { "" } else { " at " };
                write!(
                    f,
                    "{family}{separator}{at}: the control points do not determine {conditions} derivatives at this \
                     end; choose other shape values or a lower order of contact"
                )
            }
            Self::Contact { family, most, found } => {
                let points = most + 1;
                write!(
                    f,
                    "contact of order {found} determines more control points than the {points} of \
                     {family}: at most order {most}"
                )
            }
            Self::Factor { name: "f", value } => {
                write!(
                    f,
                    "f = {value} in the contact f Q' = P': a ratio of velocities is positive and finite"
                )
            }
            Self::Factor { name, value } => {
                write!(f, "{name} = {value} in the contact is not a finite number")
            }
            Self::Shape(error) => error.fmt(f),
            Self::TooManyPoints { needed } => {
                write!(f, "the tolerance asks for {needed:.0} points: choose a larger one")
            }
        }
    }
}

impl Error for CurveError {}

impl From<ShapeError> for CurveError {
    fn from(error: ShapeError) -> Self {
        Self::Shape(error)
    }
}
