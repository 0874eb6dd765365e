//! How smoothly one curve continues another, measured.

use super::frame::curvature_vector;
use crate::vector::{distance, length};
use crate::{Basis, Curve, Point, Scalar};

/// How the start of one curve continues the end of another, measured by [`Curve::joint`]. Along the edge of two
/// surfaces the same figures are those of [`EdgeJoint`](crate::EdgeJoint).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Joint<S> {
    /// The distance of the end of the first from the start of the second curve, in the unit of the points.
    pub gap: S,
    /// The angle between the tangents in radians, from 0 to π; NaN if a curve is a point.
    pub angle: S,
    /// The length of the difference of the curvature vectors, which point to the centres of curvature, in the inverse
    /// of the unit of the points; NaN where a velocity vanishes.
    pub curvature: S,
    /// The lengths of the differences of the first, second and third derivatives, each with respect to the parameter of
    /// its own curve.
    pub derivatives: [S; 3],
}

impl<S: Scalar> Joint<S> {
    /// The order of geometric continuity that the measured numbers allow: 2 for G2, 1 for G1, 0 for G0, or `None` if
    /// there is a gap.
    ///
    /// The tolerances are in the unit of length, in radians, and in the inverse of the unit of length. A figure that is
    /// NaN is above its tolerance.
    pub fn geometric_order(&self, gap: S, angle: S, curvature: S) -> Option<usize> {
        leading_order(self.gap <= gap, [self.angle <= angle, self.curvature <= curvature])
    }

    /// The order of parametric continuity that the measured numbers allow, up to C3, or `None` if there is a gap.
    ///
    /// The tolerances are those of the gap and of the derivatives.
    pub fn parametric_order(&self, gap: S, derivatives: [S; 3]) -> Option<usize> {
        let small = |k: usize| self.derivatives[k] <= derivatives[k];
        leading_order(self.gap <= gap, [small(0), small(1), small(2)])
    }
}

/// The order of a joint without a gap whose figures of the orders 1, 2, … are small enough. They are compared with
/// `<=`, which is false of NaN.
pub(crate) fn leading_order<const N: usize>(is_closed: bool, are_small: [bool; N]) -> Option<usize> {
    is_closed.then(|| are_small.into_iter().take_while(|&is_small| is_small).count())
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// How smoothly the start of `next`, with the feature `geometry` a curve of any type, continues the end of this curve.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let first = Bezier::from_points([[0.0, 0.0], [1.0, 0.0], [2.0, 1.0]]);
    /// let second = Bezier::from_points([[2.0, 1.0], [4.0, 3.0], [5.0, 3.0]]);
    /// let joint = first.joint(&second);
    /// assert_eq!((joint.gap, joint.angle, joint.derivatives[0]), (0.0, 0.0, 8_f64.sqrt()));
    /// assert_eq!(joint.geometric_order(1e-9, 1e-9, 1e-9), Some(1));
    /// assert_eq!(joint.parametric_order(1e-9, [1e-9; 3]), Some(0));
    /// ```
    #[cfg(feature = "geometry")]
    pub fn joint(&self, next: &dyn crate::ParametricCurve<Point = P>) -> Joint<B::Scalar> {
        crate::ParametricCurve::joint(self, next)
    }

    /// How smoothly the start of `next` continues the end of this curve.
    #[cfg(not(feature = "geometry"))]
    pub fn joint<C: Basis<Scalar = B::Scalar>>(&self, next: &Curve<C, P>) -> Joint<B::Scalar> {
        Joint::between(
            self.eval_with_derivs(B::domain()[1]),
            next.eval_with_derivs(C::domain()[0]),
            [self.tangent(B::domain()[1]), next.tangent(C::domain()[0])],
        )
    }
}

impl<S: Scalar> Joint<S> {
    /// From the points with three derivatives and the tangents of both curves.
    pub(crate) fn between<P: Point<Scalar = S>>(
        end: [P; 4],
        start: [P; 4],
        tangents: [Option<P::Vector>; 2],
    ) -> Self {
        let angle = match tangents {
            [Some(a), Some(b)] => angle(a, b),
            _ => S::NAN,
        };
        let curvature = match (curvature_vector(end[1], end[2]), curvature_vector(start[1], start[2])) {
            (Some(a), Some(b)) => distance(a, b),
            _ => S::NAN,
        };
        let derivatives = [1, 2, 3].map(|k| distance(end[k], start[k]));
        Self { gap: distance(end[0], start[0]), angle, curvature, derivatives }
    }
}

/// The angle between two unit vectors, accurate for all angles: `2 atan(|a - b| / |a + b|)`.
fn angle<P: Point>(a: P, b: P) -> P::Scalar {
    let sum = a.add_weighted(b, P::Scalar::ONE);
    P::Scalar::of(2.0) * distance(a, b).atan2(length(sum))
}
