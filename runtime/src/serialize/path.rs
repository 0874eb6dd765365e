//! Paths as they are written; what is read goes through the constructors.

use alloc::vec::Vec;

use serde::Deserialize;

use crate::{CurveError, Path, PathSegment, Point};

#[derive(Deserialize)]
#[serde(rename = "PathSegment", expecting = "struct PathSegment")]
#[serde(bound(deserialize = "P: Deserialize<'de>, P::Scalar: Deserialize<'de>"))]
pub(crate) struct Segment<P: Point> {
    points: Vec<P>,
    weights: Vec<P::Scalar>,
}

impl<P: Point> TryFrom<Segment<P>> for PathSegment<P> {
    type Error = CurveError;

    fn try_from(read: Segment<P>) -> Result<Self, CurveError> {
        if read.weights.is_empty() {
            Self::polynomial(read.points)
        } else {
            Self::rational(read.points, read.weights)
        }
    }
}

#[derive(Deserialize)]
#[serde(rename = "Path", expecting = "struct Path")]
#[serde(bound(deserialize = "P: Deserialize<'de>, P::Scalar: Deserialize<'de>"))]
pub(crate) struct Segments<P: Point> {
    segments: Vec<PathSegment<P>>,
}

impl<P: Point> TryFrom<Segments<P>> for Path<P> {
    type Error = CurveError;

    fn try_from(read: Segments<P>) -> Result<Self, CurveError> {
        Self::new(read.segments)
    }
}
