//! Surfaces of revolution as rational Bézier patches, exactly.

use alloc::vec::Vec;

use super::SurfaceOfRevolution;
use super::circle::Arcs;
use crate::bernstein::keep_left;
use crate::{
    Array, Basis, BernsteinBasis, BernsteinOf, Curve, Point3, RationalSurface, Scalar, TensorSurface,
    half_turn_parameter,
};

/// A part of a surface of revolution: of the degree of the generatrix in `u`, quadratic in `v`, on the unit square.
pub type RevolutionPatch<B, P> = RationalSurface<BernsteinOf<B>, BernsteinBasis<<B as Basis>::Scalar, 3>, P>;

impl<B: Basis, P: Point3<Scalar = B::Scalar>> SurfaceOfRevolution<B, P> {
    /// The surface as rational Bézier patches of equal angles of at most π/2, in order; all weights are positive.
    ///
    /// The circular arc from `α0` to `α1` has the weights 1, `cos((α1 - α0)/2)`, 1; the middle control point is where
    /// the tangents of its ends meet. The end of a patch is the start of the next one, bit for bit, and after a full
    /// turn that of the first.
    pub fn to_rational_patches(&self) -> Vec<RevolutionPatch<B, P>> {
        let arcs = Arcs::new(self.angle);
        (0..arcs.count())
            .map(|k| self.arc([2 * k, 2 * k + 1, 2 * k + 2].map(|halves| arcs.control_point(halves))))
            .collect()
    }

    /// The surface as one half-turn, or as two if the angle is greater than π, in the parameter of the paper "Surfaces
    /// of revolution with shape parameters from quartic λ-Bézier generatrices": the interpolation of three meridians by
    /// a vector-valued continued fraction,
    ///
    /// ```text
    /// cos α = (1 - 2t) / (1 - 2t + 2t²),   sin α = 2t (1 - t) / (1 - 2t + 2t²)
    /// ```
    ///
    /// restricted to `0 <= t <= t(θ)` with [`half_turn_parameter`], so that it ends at the angle asked for. The second
    /// half-turn is the first one turned by π, so that it begins where the first ends.
    ///
    /// A whole half-turn has the weight 0 in the middle: a control point at infinity.
    pub fn half_turns(&self) -> Vec<RevolutionPatch<B, P>> {
        let pi = B::Scalar::PI;
        let rest = self.angle - pi;
        let first = if rest > B::Scalar::ZERO { pi } else { self.angle };
        let mut patches = alloc::vec![self.half_turn(first, B::Scalar::ONE)];
        if rest > B::Scalar::ZERO {
            patches.push(self.half_turn(rest, -B::Scalar::ONE));
        }
        patches
    }

    /// The paper's half-turn up to an angle; from 0 on for the sign +1, from π on for -1.
    fn half_turn(&self, angle: B::Scalar, sign: B::Scalar) -> RevolutionPatch<B, P> {
        let (zero, one) = (B::Scalar::ZERO, B::Scalar::ONE);
        // Cosine, sine and weight in Bernstein form.
        let mut homogeneous = [[sign, zero, one], [zero, sign, zero], [-sign, zero, one]];
        keep_left(&mut homogeneous, half_turn_parameter(angle));
        self.arc(homogeneous)
    }

    /// The patch over a circular arc given by the Bernstein coefficients of `w cos α`, `w sin α` and `w`.
    fn arc(&self, coefficients: [[B::Scalar; 3]; 3]) -> RevolutionPatch<B, P> {
        let centres = self.centres.to_bezier();
        let [radii, quarters] = [&self.radii, &self.quarters].map(Curve::to_bezier);
        let (u_basis, v_basis) = (centres.basis(), BernsteinBasis::new());
        let net = <BernsteinOf<B> as Basis>::Points::from_fn(|i| {
            let centre = centres.control_points()[i];
            let [radius, quarter] = [&radii, &quarters].map(|c| c.control_points()[i]);
            coefficients.map(|[cos, sin, weight]| {
                centre.scale(weight).add_scaled(radius, cos).add_scaled(quarter, sin)
            })
        });
        let weight_net =
            <BernsteinOf<B> as Basis>::Points::from_fn(|_| coefficients.map(|[_, _, weight]| weight));
        RationalSurface::from_homogeneous(
            TensorSurface::new(u_basis, v_basis, net),
            TensorSurface::new(u_basis, v_basis, weight_net),
        )
    }
}
