//! Why two surfaces cannot be joined.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

use super::JointBounds;
use crate::bspline::KnotError;

/// A joint that cannot be made, or not to the tolerances.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SpliceError {
    /// Knots that cannot be merged: they come so near to each other that rounding makes them equal too often.
    Knots(KnotError),
    /// A control point near the joint is not finite.
    NotFinite,
    /// A tolerance is not a positive number.
    Tolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// A surface has only one row of control points across its edge.
    OneRow,
    /// A surface has no tangent plane at this parameter of the joint: its edge shrinks to a point there, or the row
    /// next to it lies on the edge. Where a surface is moved it is the one that it continues.
    Degenerate {
        /// The parameter of the first surface along its edge.
        parameter: f64,
    },
    /// Curvatures are to agree, by a method that does not make them.
    Curvatures,
    /// [`Method::Midpoints`](crate::bspline::Method::Midpoints) without the features `nalgebra` and `std`.
    NeedsNalgebra,
    /// A linear system has no unique solution.
    Singular,
    /// The tolerances were not reached with the number of spans that is allowed, or with the precision of the scalar
    /// type.
    NotReached {
        /// The best figures that were achieved.
        achieved: JointBounds,
        /// The number of spans along the edge with which they were achieved.
        spans: usize,
        /// The tolerance of the gap.
        gap: f64,
        /// The tolerance of the angle in radians.
        angle: f64,
    },
}

impl SpliceError {
    /// The same with another parameter in place of each.
    pub(super) fn at(self, place: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::Degenerate { parameter } => Self::Degenerate { parameter: place(parameter) },
            Self::NotReached { achieved, spans, gap, angle } => {
                let (gap_at, angle_at) = (place(achieved.gap_at), place(achieved.angle_at));
                Self::NotReached { achieved: JointBounds { gap_at, angle_at, ..achieved }, spans, gap, angle }
            }
            other => other,
        }
    }
}

impl Display for SpliceError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Knots(error) => error.fmt(f),
            Self::NotFinite => f.write_str("a control point next to the joint is not finite"),
            Self::Tolerance { tolerance } => {
                write!(f, "a tolerance of {tolerance}; tolerances are positive numbers")
            }
            Self::OneRow => f.write_str("a surface with one row of control points has no edge to join at"),
            Self::Degenerate { parameter } => {
                write!(
                    f,
                    "a surface has no tangent plane at the parameter {parameter} of the joint, where \
                     its edge is a point or \
                     the row next to it lies on the edge; positions alone can be joined there"
                )
            }
            Self::Curvatures => {
                f.write_str("only the exact method makes joints with continuous curvatures, G2")
            }
            Self::NeedsNalgebra => {
                f.write_str("the method by midpoints needs the features `nalgebra` and `std`")
            }
            Self::Singular => f.write_str("the equations of the joint have no unique solution"),
            Self::NotReached { achieved, spans, gap, angle } => write!(
                f,
                "gap {:.3e} (wanted {gap:.3e}, worst at {}) and angle {:.3e} rad (wanted {angle:.3e}, \
                 worst at {}) with {spans} \
                 spans; allow more spans or wider tolerances. The exact method leaves nothing but rounding errors, which count \
                 where the surface it joins has hardly a tangent plane",
                achieved.gap, achieved.gap_at, achieved.angle, achieved.angle_at
            ),
        }
    }
}

impl Error for SpliceError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Knots(error) => Some(error),
            _ => None,
        }
    }
}

impl From<KnotError> for SpliceError {
    fn from(error: KnotError) -> Self {
        Self::Knots(error)
    }
}
