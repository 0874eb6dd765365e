//! Why a surface cannot continue another one.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

use crate::CurveError;

/// Why a surface cannot continue another one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum JoinError {
    /// A row of the first surface that counts at the edge has other shape values than the others, so that its
    /// derivatives across the edge are no curves of one family.
    FirstShape {
        /// The row.
        row: usize,
    },
    /// A row of the second surface that counts at the edge has other shape values than the others.
    SecondShape {
        /// The row.
        row: usize,
    },
    /// A factor of the [`Contact`](crate::Contact) is not finite, or `f`, a ratio of velocities, not positive.
    Factor {
        /// Which one, `f` or `c`.
        name: &'static str,
        /// The factor.
        value: f64,
    },
    /// The order of contact is too high: for the number of control points across the edge, or at all.
    Contact {
        /// The highest order that is possible.
        most: usize,
        /// The order asked for.
        found: usize,
    },
    /// An edge of a triangle is the corner `u = 1`, [`Edge::UEnd`](crate::Edge::UEnd), across which there is nothing to
    /// continue.
    Corner,
    /// The apex of a triangle that continues another one across an edge is not beyond the edge.
    Apex {
        /// Its barycentric coordinate that must be negative.
        value: f64,
    },
    /// A weight of a rational surface next to its edge would not be positive and finite; of a
    /// [`RationalSurface`](crate::RationalSurface), the mean of its weights along the edge vanishes.
    Weights,
    /// An edge of a surface of revolution is a meridian, beyond which the surface that continues it is itself, turned
    /// on.
    Meridian,
    /// The knots of two B-spline surfaces along their edges cannot be merged: some are so near one another that rounding
    /// makes them one.
    Knots,
    /// A control point that is computed is not finite.
    NotFinite,
    /// No control points of the family with these shape values give the second surface the derivatives of the first one.
    Unreachable,
    /// With these shape values the control points next to the edge do not determine the derivatives across it; in the
    /// quartic family at γ = -3.
    Undetermined,
}

impl Display for JoinError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::FirstShape { row } => write!(
                f,
                "row {row} of the first surface counts at the edge, but has other shape values than the \
                 rows beside it: give all of them the same"
            ),
            Self::SecondShape { row } => write!(
                f,
                "row {row} of the second surface counts at the edge, but has other shape values than the \
                 rows beside it: give all of them the same"
            ),
            Self::Factor { name, value } => CurveError::Factor { name, value: *value }.fmt(f),
            Self::Contact { most, found } => {
                write!(f, "contact of order {found} is not possible, at most of order {most}")
            }
            Self::Corner => f.write_str(
                "the edge UEnd of a triangle is its corner u = 1: the edges that can be joined are UStart, VStart and VEnd",
            ),
            Self::Apex { value } => write!(
                f,
                "the apex is not beyond the edge: its barycentric coordinate that belongs to the \
                 opposite corner is {value}, and must be negative"
            ),
            Self::Weights => write!(
                f,
                "weights next to the edge would not be positive and finite: give the contact a larger factor f or a \
                 lower order, or the first surface weights that change less across its edge"
            ),
            Self::Meridian => write!(
                f,
                "an edge of a surface of revolution is a meridian: its circles can be joined, and beyond a meridian it goes on \
                 by a larger angle"
            ),
            Self::Knots => f.write_str(
                "the knots of the surfaces along their edges cannot be merged: some are so near one another that rounding makes them one",
            ),
            Self::NotFinite => f.write_str("a computed control point is infinite or NaN"),
            Self::Unreachable => write!(
                f,
                "no control points of the second one continue the first one with these shape values: \
                 choose those of the first one along the edge, or a family with more functions of its degree, such as that of Bernstein"
            ),
            Self::Undetermined => write!(
                f,
                "with these shape values of the second surface its control points do not determine the \
                 derivatives across the edge: choose others"
            ),
        }
    }
}

impl Error for JoinError {}

#[cfg(feature = "bspline")]
impl From<crate::bspline::KnotError> for JoinError {
    fn from(_: crate::bspline::KnotError) -> Self {
        Self::Knots
    }
}
