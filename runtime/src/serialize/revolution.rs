//! Surfaces of revolution as they are written: what they are made of.

use serde::{Deserialize, Serialize};

use crate::{Basis, Curve, Point3, RevolutionError, SurfaceOfRevolution};

#[derive(Serialize, Deserialize)]
#[serde(
    rename = "SurfaceOfRevolution",
    bound(
        serialize = "B: Serialize, P: Serialize, P::Vector: Serialize, B::Scalar: Serialize",
        deserialize = "B: Deserialize<'de>, P: Deserialize<'de>, P::Vector: Deserialize<'de>, B::Scalar: Deserialize<'de>"
    )
)]
pub(crate) struct Revolution<B: Basis, P: Point3<Scalar = B::Scalar>> {
    generatrix: Curve<B, P>,
    point: P,
    axis: P::Vector,
    angle: B::Scalar,
}

impl<B: Basis, P: Point3<Scalar = B::Scalar>> From<SurfaceOfRevolution<B, P>> for Revolution<B, P> {
    fn from(surface: SurfaceOfRevolution<B, P>) -> Self {
        let (point, axis) = surface.axis();
        Self { generatrix: *surface.generatrix(), point, axis, angle: surface.angle() }
    }
}

impl<B: Basis, P: Point3<Scalar = B::Scalar>> TryFrom<Revolution<B, P>> for SurfaceOfRevolution<B, P> {
    type Error = RevolutionError;

    fn try_from(read: Revolution<B, P>) -> Result<Self, RevolutionError> {
        Self::new(&read.generatrix, read.point, read.axis, read.angle)
    }
}
