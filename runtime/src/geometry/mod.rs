//! What can be asked of every curve, whatever its type: the trait, and the answers from its Bézier pieces.
//!
//! A curve of any type is a list of rational Bézier pieces ([`CurvePiece`]). The functions in here work on these pieces
//! in double precision. They are not generic: a second type of curve costs no second compilation of them. They are
//! marked `#[inline]` so that they are compiled where a question is asked, and not with this crate for everybody.

mod closest;
mod coefficients;
mod continued;
mod convert;
mod curves;
mod local;
mod measure;
mod meetings;
mod nearest;
mod parametric;
mod piece;
mod pierce;

pub use closest::Closest;
pub use continued::JoinableCurve;
#[cfg(feature = "bspline")]
pub(crate) use continued::{as_points, possible, replace_first};
pub(crate) use convert::clamped;
pub(crate) use curves::forward;
pub(crate) use measure::bounds::control_box;
pub use measure::enclosed::Enclosed;
pub(crate) use meetings::of_line;
pub use meetings::{Meeting, MeetingKind, PlaneMeeting, SurfaceMeeting};
pub(crate) use meetings::{meetings, self_meetings};
pub(crate) use nearest::nearest as nearest_place;
pub use parametric::{CurveScalar, CurveVector, ParametricCurve};
pub use piece::CurvePiece;
pub(crate) use piece::{derivative, product};
