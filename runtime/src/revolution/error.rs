//! What can be wrong with a surface of revolution.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// A curve, axis or angle that makes no surface of revolution.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum RevolutionError {
    /// The angle is NaN or not in `0 < θ <= 2π`.
    Angle {
        /// The angle in radians.
        value: f64,
    },
    /// The direction of the axis is zero, or the axis is infinite or NaN.
    Axis,
    /// A control point of the generatrix is infinite or NaN.
    NotFinite,
    /// A map that is no similarity: the image is no surface of revolution.
    NoSimilarity,
}

impl Display for RevolutionError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Angle { value } => {
                write!(
                    f,
                    "the angle {value} is not in 0 < θ <= 2π; it is given in radians, a full turn is 2π"
                )
            }
            Self::Axis => write!(f, "the axis needs a finite point and a finite direction that is not zero"),
            Self::NotFinite => write!(f, "a control point of the generatrix is infinite or NaN"),
            Self::NoSimilarity => {
                write!(f, "the map distorts angles, so that the image is no surface of revolution")
            }
        }
    }
}

impl Error for RevolutionError {}
