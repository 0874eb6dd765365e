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

/// What is asked of an edge of a fitted surface: of the ends of the curves that cross it, as [`FitEnd`] does.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[non_exhaustive]
pub enum GridEnd<'a, P: Point> {
    /// Nothing: it is where the other points want it.
    #[default]
    Free,
    /// The boundary curve is fitted to the boundary of the grid alone. Where two such edges meet, the corner is that of the
    /// grid.
    Interpolated,
    /// The boundary curve is fitted to the boundary of the grid, and all along it the surface runs in this direction across
    /// the edge, whatever the length; at both ends the direction in which the parameter grows.
    Tangent(P::Vector),
    /// As [`Tangent`](Self::Tangent), with a direction for each point of the boundary. The derivatives across the edge are
    /// fitted to these, as points are: they have the directions where the functions along the edge allow it, and otherwise
    /// nearly so.
    Tangents(&'a [P::Vector]),
}

impl<P: Point> GridEnd<'_, P> {
    pub(super) fn has_tangents(&self) -> bool {
        matches!(self, Self::Tangent(_) | Self::Tangents(_))
    }

    /// The direction in which the line with that index crosses the edge.
    pub(super) fn tangent(&self, line: usize) -> Option<P::Vector> {
        match self {
            Self::Free | Self::Interpolated => None,
            Self::Tangent(tangent) => Some(*tangent),
            Self::Tangents(tangents) => tangents.get(line).copied(),
        }
    }
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
