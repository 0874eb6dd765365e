//! Curvatures of a surface at a point, from its first and second partial derivatives.

#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::vector::{cross, direction, dot, length};
use crate::{Point, Point3, Scalar};

/// How a surface bends at a point.
///
/// A curvature is positive where the surface bends towards its normal; reversing the normal changes the signs of the
/// principal and mean curvatures but not of the Gaussian.
///
/// ```
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
/// # fn main() -> Result<(), basis_runtime::ShapeError> {
/// use basis_runtime::{Surface, TensorSurface};
///
/// // The saddle z = x y.
/// let row = |i| core::array::from_fn(|j| [i as f64, j as f64, (i * j) as f64]);
/// let net: [[[f64; 3]; 4]; 4] = core::array::from_fn(row);
/// let saddle = TensorSurface::new(QuarticBernstein::new(0.0)?, QuarticBernstein::new(0.0)?, net);
/// let curvature = saddle.curvature(0.0, 0.0).unwrap();
/// assert_eq!(curvature.principal, [1.0, -1.0]);
/// assert_eq!((curvature.gaussian(), curvature.mean()), (-1.0, 0.0));
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "P: Written, P::Vector: serde::Serialize",
        deserialize = "P: Read<'de>, P::Vector: serde::Deserialize<'de>"
    ))
)]
#[non_exhaustive]
pub struct Curvature<P: Point3> {
    /// The unit normal `S_u × S_v / |S_u × S_v|`.
    pub normal: P::Vector,
    /// The principal curvatures, the larger one first, in the inverse of the unit of length.
    pub principal: [P::Scalar; 2],
    /// The unit tangents in whose directions the surface has the principal curvatures; they make a right angle. Where
    /// both curvatures are equal, at an umbilic, any pair of such directions.
    pub directions: [P::Vector; 2],
}

impl<P: Point3> Curvature<P> {
    /// The Gaussian curvature, the product of the principal curvatures.
    pub fn gaussian(&self) -> P::Scalar {
        self.principal[0] * self.principal[1]
    }

    /// The mean curvature, half of their sum.
    pub fn mean(&self) -> P::Scalar {
        (self.principal[0] + self.principal[1]) * P::Scalar::of(0.5)
    }

    /// The curvature of the section with the plane spanned by the normal and that tangent direction, by Euler's formula
    /// `κ1 cos² φ + κ2 sin² φ`; `None` if the vector has no tangential part or is not finite.
    pub fn along(&self, tangent: P::Vector) -> Option<P::Scalar> {
        let tangent = direction(tangent)?;
        let [c, s] = self.directions.map(|e| dot(e, tangent));
        let (c2, s2) = (c * c, s * s);
        let sum = c2 + s2;
        (sum > P::Scalar::EPSILON * P::Scalar::EPSILON)
            .then(|| (self.principal[0] * c2 + self.principal[1] * s2) / sum)
    }

    /// From the partial derivatives `[i][j]`; `None` where the first ones are parallel or anything is not finite.
    pub(crate) fn new(partials: &[[P::Vector; 3]; 3], normal: P::Vector) -> Option<Self> {
        let (along_u, along_v) = (partials[1][0], partials[0][1]);
        // In the orthonormal frame (e1, e2) of the tangent plane: S_u = (a, 0), S_v = (b, c).
        let e1 = direction(along_u)?;
        let e2 = direction(cross(normal, e1))?;
        let (a, b, c) = (dot(along_u, e1), dot(along_v, e1), dot(along_v, e2));
        let [l, m, n] = [partials[2][0], partials[1][1], partials[0][2]].map(|second| dot(second, normal));
        // The second fundamental form in that frame.
        let w11 = l / a / a;
        // Quotients first: products of large numbers overflow.
        let slope = b / a;
        let w12 = (m - l * slope) / a / c;
        let w22 = (n - P::Scalar::of(2.0) * m * slope + l * slope * slope) / c / c;
        let half = P::Scalar::of(0.5);
        let (middle, half_difference) = ((w11 + w22) * half, (w11 - w22) * half);
        let radius = length([half_difference, w12]);
        let principal = [middle + radius, middle - radius];
        if !principal[0].is_finite() || !principal[1].is_finite() {
            return None;
        }
        // The eigenvector of w11 - κ, w12; w12, w22 - κ for κ = middle + radius that has no cancellation.
        let (x, y) = if half_difference >= P::Scalar::ZERO {
            (half_difference + radius, w12)
        } else {
            (w12, radius - half_difference)
        };
        let along = direction([x, y]).unwrap_or([P::Scalar::ONE, P::Scalar::ZERO]);
        let first = e1.scale(along[0]).add_weighted(e2, along[1]);
        Some(Self { normal, principal, directions: [first, cross(normal, first)] })
    }
}
