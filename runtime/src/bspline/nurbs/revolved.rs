//! Surfaces of revolution as rational B-spline surfaces.

use alloc::vec::Vec;

use crate::bspline::{BSplineSurface, Homogeneous, KnotVector, Net, NurbsCurve, NurbsSurface, SplineError};
use crate::revolution::Arcs;
use crate::vector::{cross, direction, dot};
use crate::{Basis, Point, Point3, Scalar, SurfaceOfRevolution};

impl<P: Point3> NurbsSurface<P> {
    /// The surface that a curve sweeps when it turns about an axis: exactly, for any angle.
    ///
    /// The axis passes through `origin` in the direction `axis`; the turn follows the right hand. The first parameter
    /// is that of the curve; the second one is the angle in radians at the ends of the arcs into which the turn is
    /// divided, `0 <= v <= angle`, and a rational function of it between them. Each arc of the angle `δ <= π/2` is a rational
    /// quadratic with the weights `1, cos(δ/2), 1`.
    ///
    /// # Errors
    /// [`SplineError::Angle`] if the angle is not in `0 < angle <= 2π`; [`SplineError::Axis`] if the axis is zero or
    /// not finite.
    pub fn revolved(
        curve: &NurbsCurve<P>,
        origin: P,
        axis: P::Vector,
        angle: P::Scalar,
    ) -> Result<Self, SplineError> {
        let zero = P::Scalar::ZERO;
        let turn = P::Scalar::PI + P::Scalar::PI;
        if !(angle > zero && angle <= turn) {
            return Err(SplineError::Angle { angle: angle.to_f64() });
        }
        let axis = direction(axis).ok_or(SplineError::Axis)?;
        let arcs = Arcs::new(angle);
        let rows = (0..=2 * arcs.count()).map(|halves| {
            let [cos, sin, weight] = arcs.control_point(halves);
            let turned = |point: &Homogeneous<P>| {
                // The components along the axis and away from it, and the direction of the turn.
                let from = point.project().minus(origin);
                let along = axis.scale(dot(axis, from));
                let away = from.minus(along);
                let centre = origin.add_scaled(along, P::Scalar::ONE).scale(weight);
                let scaled = centre.add_scaled(away, cos).add_scaled(cross(axis, away), sin);
                Homogeneous { scaled: scaled.scale(point.weight), weight: point.weight * weight }
            };
            curve.homogeneous().control_points().iter().map(turned).collect::<Vec<_>>()
        });
        let v = KnotVector::clamped(2, &arcs.breakpoints())?;
        let net = Net::from_rows(rows)?.transposed();
        Self::from_homogeneous(BSplineSurface::new(curve.knots().clone(), v, net)?)
    }
}

impl<B: Basis, P: Point3<Scalar = B::Scalar>> TryFrom<&SurfaceOfRevolution<B, P>> for NurbsSurface<P> {
    type Error = SplineError;

    /// The same surface, exactly: `u` is the parameter of the generatrix, as before; `v` is the angle at the ends of at
    /// most four arcs of equal angles, and a rational function of it between them.
    ///
    /// ```
    /// use basis_runtime::bspline::{Direction, NurbsSurface};
    /// use basis_runtime::{BernsteinBasis, Curve, Surface, SurfaceOfRevolution};
    ///
    /// let generatrix = Curve::new(BernsteinBasis::<f64, 3>::new(), [[0.0, 1.0], [1.0, 2.0], [2.0, 1.0]]);
    /// let vase = SurfaceOfRevolution::about_x(&generatrix, 3.0)?;
    /// let surface = NurbsSurface::try_from(&vase)?;
    /// assert_eq!(surface.degrees(), [2, 2]);
    /// let (here, there) = (vase.eval(0.3, 1.5), surface.eval(0.3, 1.5)); // a joint of two arcs
    /// assert!((0..3).all(|i| (here[i] - there[i]).abs() < 1e-15));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SplineError::Weight`] if the surface has control points that are not finite.
    fn try_from(surface: &SurfaceOfRevolution<B, P>) -> Result<Self, SplineError> {
        let arcs = surface.to_rational_patches();
        let count = arcs.len();
        let rows = arcs.first().map_or(0, |arc| arc.numerator().rows().len());
        let mut points = Vec::with_capacity(rows);
        for i in 0..rows {
            let mut row = Vec::with_capacity(2 * count + 1);
            for (index, arc) in arcs.iter().enumerate() {
                let (numerator, weight) = (&arc.numerator().rows()[i], &arc.weight().rows()[i]);
                let all = numerator.control_points().iter().zip(weight.control_points());
                // The end of an arc is the start of the next one.
                let shared = usize::from(index > 0);
                row.extend(all.skip(shared).map(|(&scaled, &weight)| Homogeneous { scaled, weight }));
            }
            points.push(row);
        }
        let u = KnotVector::clamped(rows.saturating_sub(1), &B::domain())?;
        let net = Net::from_rows(points)?;
        Self::from_homogeneous(BSplineSurface::new(
            u,
            KnotVector::clamped(2, &Arcs::new(surface.angle()).breakpoints())?,
            net,
        )?)
    }
}
