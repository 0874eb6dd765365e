//! Boxes around tensor surfaces, polynomial and rational.

#[cfg(feature = "alloc")]
use super::net::Net;
use super::{RationalSurface, TensorSurface};
use crate::{Basis, Point, Scalar};

impl<U, V, P> TensorSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The smallest axis-parallel box around the Bézier control points, as its two extreme corners: cheap, and never
    /// too small up to rounding errors. NaN in a component in which a control point is NaN.
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
    /// Each side is found by subdivision: between the largest value that was met and the largest Bernstein coefficient
    /// of a part, until both agree. Where a side touches the surface along a curve, which would take too many parts,
    /// the box may be larger by a small part of its size; it is never smaller than the surface but for rounding errors.
    /// NaN in a component in which a control point is infinite or NaN.
    #[cfg(feature = "alloc")]
    pub fn bounding_box(&self) -> [P; 2] {
        let net = Net::of(self);
        [
            P::from_components(|c| -largest(net.map(|p| -p.component(c)), |c| c)),
            P::from_components(|c| largest(net.map(|p| p.component(c)), |c| c)),
        ]
    }
}

impl<U, V, P> RationalSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The smallest axis-parallel box around the Bézier control points, as its two extreme corners: cheap, and never
    /// too small up to rounding errors. Infinite if a weight of the Bézier form is not positive: the surface may then
    /// leave the hull of its control points. NaN in a component in which a control point is NaN.
    pub fn control_box(&self) -> [P; 2] {
        let (points, weights) = (self.numerator().bezier_net(), self.weight().bezier_net());
        let extreme = |sign: P::Scalar| {
            P::from_components(|c| {
                let mut extreme = -P::Scalar::INFINITY;
                for (points, weights) in points.as_ref().iter().zip(weights.as_ref()) {
                    for (point, &weight) in points.as_ref().iter().zip(weights.as_ref()) {
                        let quotient = quotient([sign * point.component(c), weight]);
                        let nan = extreme.is_nan() || quotient.is_nan();
                        extreme = if nan { P::Scalar::NAN } else { extreme.max(quotient) };
                    }
                }
                sign * extreme
            })
        };
        [extreme(-P::Scalar::ONE), extreme(P::Scalar::ONE)]
    }

    /// The smallest axis-parallel box around the surface, as its two extreme corners, up to rounding errors; found by
    /// subdivision as [`TensorSurface::bounding_box`].
    ///
    /// Where the weight vanishes or is negative the surface counts as infinite; a whole surface of negative weights is
    /// that of their opposites. NaN in a component in which a control point is infinite or NaN.
    #[cfg(feature = "alloc")]
    pub fn bounding_box(&self) -> [P; 2] {
        let (points, weights) = (Net::of(self.numerator()), Net::of(self.weight()));
        let turned = weights.corners()[0] < P::Scalar::ZERO;
        let one = if turned { -P::Scalar::ONE } else { P::Scalar::ONE };
        let side = |sign: P::Scalar, c: usize| {
            largest(points.zip(&weights, |p, w| [sign * one * p.component(c), one * w]), quotient)
        };
        [P::from_components(|c| -side(-P::Scalar::ONE, c)), P::from_components(|c| side(P::Scalar::ONE, c))]
    }
}

/// A point of the line from its homogeneous coordinates; infinite if the weight is not positive.
fn quotient<S: Scalar>([point, weight]: [S; 2]) -> S {
    if point.is_nan() || weight.is_nan() {
        S::NAN
    } else if weight > S::ZERO {
        point / weight
    } else {
        S::INFINITY
    }
}

/// The largest quotient of two components on the unit square; infinite where the second one is not positive.
#[cfg(feature = "alloc")]
pub(crate) fn largest_quotient<S: Scalar>(net: Net<[S; 2]>) -> S {
    largest(net, quotient)
}

/// The number of parts of one size that are looked at for each side of a box.
#[cfg(feature = "alloc")]
const PARTS: usize = 500;

/// The number of halvings after which a part is a point; the smallest numbers stay apart for ever.
#[cfg(feature = "alloc")]
const ROUNDS: usize = 128;

/// The largest value of a function of two variables on the unit square, from Bernstein coefficients; `value` of the
/// point itself, which is at most the largest of those of the coefficients. Infinite values are looked at again in
/// smaller parts.
#[cfg(feature = "alloc")]
fn largest<P: Point>(net: Net<P>, value: impl Fn(P) -> P::Scalar) -> P::Scalar {
    if !net.points().iter().all(|&c| crate::vector::is_finite(c)) {
        return P::Scalar::NAN;
    }
    let finite = net.points().iter().map(|&c| value(c).abs()).filter(|c| c.is_finite());
    let noise = P::Scalar::of(4.0) * P::Scalar::EPSILON * finite.fold(P::Scalar::ZERO, P::Scalar::max);
    let mut best = -P::Scalar::INFINITY;
    let mut parts = alloc::vec![net];
    // Every round halves what may hold a larger value; a part of the size of the noise holds none.
    for round in 0.. {
        best = parts.iter().flat_map(Net::corners).map(&value).fold(best, P::Scalar::max);
        let above = |part: &Net<P>| part.points().iter().map(|&c| value(c)).fold(best, P::Scalar::max);
        parts.retain(|part| above(part) > best + noise);
        if parts.is_empty() || parts.len() > PARTS || round > ROUNDS {
            return parts.iter().map(above).fold(best, P::Scalar::max);
        }
        parts = parts.iter().flat_map(Net::halves).collect();
    }
    best
}
