//! A curve that was fitted, and what can be asked of its ends.

use alloc::vec::Vec;

#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::{CurveScalar, ParametricCurve, Point};

/// What is asked of an end of a fitted curve.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "P: Written, P::Vector: serde::Serialize",
        deserialize = "P: Read<'de>, P::Vector: serde::Deserialize<'de>"
    ))
)]
#[non_exhaustive]
pub enum FitEnd<P: Point> {
    /// Nothing: it is where the other points want it.
    #[default]
    Free,
    /// It is the first point, at the other end the last.
    Interpolated,
    /// It is that point, and the curve runs in this direction there, whatever its length; at both ends the direction in which
    /// the parameter grows.
    Tangent(P::Vector),
}

/// A curve near points, and how near.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "C: serde::Serialize, CurveScalar<C>: serde::Serialize",
        deserialize = "C: serde::Deserialize<'de>, CurveScalar<C>: serde::Deserialize<'de>"
    ))
)]
#[non_exhaustive]
pub struct Fitted<C: ParametricCurve> {
    /// The curve.
    pub curve: C,
    /// The parameter of each point.
    pub parameters: Vec<CurveScalar<C>>,
    /// The largest distance of a point from the point of the curve at its parameter; no point is farther from the curve.
    pub largest: CurveScalar<C>,
    /// The root of the mean square of these distances.
    pub root_mean_square: CurveScalar<C>,
    /// How often parameters and shape values were improved, in the last search.
    pub rounds: usize,
}
