//! Boxes around tensor surfaces.

use super::TensorSurface;
#[cfg(feature = "alloc")]
use super::net::Net;
use crate::{Basis, Point, Scalar};

impl<U, V, P> TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The smallest axis-parallel box around the Bézier control points, as its two extreme corners: cheap, and never too
    /// small up to rounding errors. NaN in a component in which a control point is NaN.
    pub fn control_box(&self) -> [P; 2] {
        let net = self.bezier_net();
        let extreme = |of: fn(P::Scalar, P::Scalar) -> P::Scalar| {
            P::from_components(|c| {
                let mut extreme = net.as_ref()[0].as_ref()[0].component(c);
                for row in net.as_ref() {
                    for point in row.as_ref() {
                        let component = point.component(c);
                        let nan = extreme.is_nan() || component.is_nan();
                        extreme = if nan { P::Scalar::NAN } else { of(extreme, component) };
                    }
                }
                extreme
            })
        };
        [extreme(Scalar::min), extreme(Scalar::max)]
    }

    /// The smallest axis-parallel box around the surface, as its two extreme corners, up to rounding errors.
    ///
    /// Each side is found by subdivision: between the largest value that was met and the largest Bernstein coefficient of a
    /// part, until both agree. Where a side touches the surface along a curve, which would take too many parts, the box may
    /// be larger by a small part of its size; it is never smaller than the surface but for rounding errors. NaN in a component
    /// in which a control point is infinite or NaN.
    #[cfg(feature = "alloc")]
    pub fn bounding_box(&self) -> [P; 2] {
        let net = Net::of(self);
        [
            P::from_components(|c| -largest(net.map(|p| -p.component(c)))),
            P::from_components(|c| largest(net.map(|p| p.component(c)))),
        ]
    }
}

/// The number of parts of one size that are looked at for each side of a box.
#[cfg(feature = "alloc")]
const PARTS: usize = 500;

/// The largest value of a polynomial in two variables on the unit square, from its Bernstein coefficients.
#[cfg(feature = "alloc")]
fn largest<S: Scalar>(net: Net<S>) -> S {
    if !net.points().iter().all(|c| c.is_finite()) {
        return S::NAN;
    }
    let size = net.points().iter().fold(S::ZERO, |a, b| a.max(b.abs()));
    let noise = S::of(4.0) * S::EPSILON * size;
    let mut best = -S::INFINITY;
    let mut parts = alloc::vec![net];
    // Every round halves what may hold a larger value; a part of the size of the noise holds none.
    loop {
        best = parts.iter().flat_map(Net::corners).fold(best, S::max);
        let above = |part: &Net<S>| part.points().iter().fold(best, |a, &b| a.max(b));
        parts.retain(|part| above(part) > best + noise);
        if parts.is_empty() || parts.len() > PARTS {
            return parts.iter().map(above).fold(best, S::max);
        }
        parts = parts.iter().flat_map(Net::halves).collect();
    }
}
