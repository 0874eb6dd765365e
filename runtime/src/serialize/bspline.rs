//! B-splines as they are written; what is read goes through the constructors.

use alloc::vec::Vec;

use serde::Deserialize;

use crate::bspline::{
    BSplineCurve, BSplineSurface, Homogeneous, KnotError, KnotVector, Net, Network, NetworkError, NurbsCurve,
    NurbsSurface, Seam, SplineError,
};
use crate::{Point, Point3, Scalar};

#[derive(Deserialize)]
#[serde(rename = "KnotVector", expecting = "struct KnotVector")]
pub(crate) struct Knots<S> {
    degree: usize,
    knots: Vec<S>,
}

impl<S: Scalar> TryFrom<Knots<S>> for KnotVector<S> {
    type Error = KnotError;

    /// Readers that are quick with decimal numbers are off by some units of the last digit, and exchange neighbours that are
    /// as near to each other as that; these are put in order. Equal knots are written, and so read, alike.
    fn try_from(mut read: Knots<S>) -> Result<Self, KnotError> {
        for run in read.knots.chunk_by_mut(|before, after| before <= after || exchanged(*before, *after)) {
            if !run.is_sorted() {
                run.sort_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal));
            }
        }
        Self::new(read.degree, read.knots)
    }
}

/// Whether a knot is smaller than the one before it by no more than a few units of the last digit.
fn exchanged<S: Scalar>(before: S, after: S) -> bool {
    after < before && before - after <= S::of(8.0) * S::EPSILON * before.abs().max(after.abs())
}

#[derive(Deserialize)]
#[serde(rename = "Net", expecting = "struct Net")]
pub(crate) struct Points<P> {
    points: Vec<P>,
    columns: usize,
}

impl<P: Copy> TryFrom<Points<P>> for Net<P> {
    type Error = SplineError;

    fn try_from(read: Points<P>) -> Result<Self, SplineError> {
        if read.columns == 0 {
            return Err(SplineError::Ragged { row: 0 });
        }
        Self::from_rows(read.points.chunks(read.columns))
    }
}

#[derive(Deserialize)]
#[serde(rename = "BSplineCurve", expecting = "struct BSplineCurve")]
#[serde(bound(deserialize = "P: Deserialize<'de>, P::Scalar: Deserialize<'de>"))]
pub(crate) struct Curve<P: Point> {
    knots: KnotVector<P::Scalar>,
    points: Vec<P>,
}

impl<P: Point> TryFrom<Curve<P>> for BSplineCurve<P> {
    type Error = SplineError;

    fn try_from(read: Curve<P>) -> Result<Self, SplineError> {
        Self::new(read.knots, read.points)
    }
}

#[derive(Deserialize)]
#[serde(rename = "BSplineSurface", expecting = "struct BSplineSurface")]
#[serde(bound(deserialize = "P: Deserialize<'de>, P::Scalar: Deserialize<'de>"))]
pub(crate) struct Surface<P: Point> {
    u: KnotVector<P::Scalar>,
    v: KnotVector<P::Scalar>,
    net: Net<P>,
}

impl<P: Point> TryFrom<Surface<P>> for BSplineSurface<P> {
    type Error = SplineError;

    fn try_from(read: Surface<P>) -> Result<Self, SplineError> {
        Self::new(read.u, read.v, read.net)
    }
}

#[derive(Deserialize)]
#[serde(rename = "NurbsCurve", expecting = "struct NurbsCurve")]
#[serde(bound(deserialize = "P: Deserialize<'de>, P::Scalar: Deserialize<'de>"))]
pub(crate) struct RationalCurve<P: Point> {
    homogeneous: BSplineCurve<Homogeneous<P>>,
}

impl<P: Point> TryFrom<RationalCurve<P>> for NurbsCurve<P> {
    type Error = SplineError;

    fn try_from(read: RationalCurve<P>) -> Result<Self, SplineError> {
        Self::from_homogeneous(read.homogeneous)
    }
}

#[derive(Deserialize)]
#[serde(rename = "NurbsSurface", expecting = "struct NurbsSurface")]
#[serde(bound(deserialize = "P: Deserialize<'de>, P::Scalar: Deserialize<'de>"))]
pub(crate) struct RationalSurface<P: Point> {
    homogeneous: BSplineSurface<Homogeneous<P>>,
}

impl<P: Point> TryFrom<RationalSurface<P>> for NurbsSurface<P> {
    type Error = SplineError;

    fn try_from(read: RationalSurface<P>) -> Result<Self, SplineError> {
        Self::from_homogeneous(read.homogeneous)
    }
}

#[derive(Deserialize)]
#[serde(rename = "Network", expecting = "struct Network")]
#[serde(bound(deserialize = "P: Deserialize<'de>, P::Scalar: Deserialize<'de>"))]
pub(crate) struct Patches<P: Point> {
    patches: Vec<BSplineSurface<P>>,
    seams: Vec<Seam>,
}

impl<P: Point3> TryFrom<Patches<P>> for Network<P> {
    type Error = NetworkError;

    fn try_from(read: Patches<P>) -> Result<Self, NetworkError> {
        Self::new(read.patches, read.seams)
    }
}
