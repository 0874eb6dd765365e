//! What a search for the nearest point finds.

use crate::Point;
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};

/// The point of a curve or surface that is nearest to a given one, and how near any other can be.
///
/// `T` is the type of the parameters: a scalar on a curve, `[u, v]` on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "P: Written, T: serde::Serialize",
        deserialize = "P: Read<'de>, T: serde::Deserialize<'de>"
    ))
)]
#[non_exhaustive]
pub struct Nearest<P: Point, T = <P as Point>::Scalar> {
    /// The parameter or the parameters of the point.
    pub at: T,
    /// The point.
    pub point: P,
    /// Its distance from the given point.
    pub distance: P::Scalar,
    /// A lower bound of the distance of all points: none is nearer than this.
    pub at_least: P::Scalar,
}
