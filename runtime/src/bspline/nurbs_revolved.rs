//! Surfaces of revolution as rational B-spline surfaces.

use alloc::vec::Vec;

use super::{BSplineSurface, Homogeneous, KnotVector, Net, NurbsCurve, NurbsSurface, SplineError};
use crate::vector::{cross, direction};
use crate::{Basis, Point3, Scalar, SurfaceOfRevolution};

impl<P: Point3> NurbsSurface<P> {
    /// The surface that a curve sweeps when it turns about an axis: exactly, for any angle.
    ///
    /// The axis passes through `origin` in the direction `axis`; the turn follows the right hand. The first parameter is
    /// the angle in radians at the ends of the arcs into which the turn is divided, `0 <= u <= angle` (between them a
    /// rational function of it); the second one is that of the curve. Each arc of the angle `δ <= π/2` is a rational
    /// quadratic with the weights `1, cos(δ/2), 1`.
    ///
    /// # Errors
    /// [`SplineError::Angle`] if the angle is not in `0 < angle <= 2π`; [`SplineError::Axis`] if the axis is zero or not
    /// finite.
    pub fn revolved(
        curve: &NurbsCurve<P>,
        origin: P,
        axis: P,
        angle: P::Scalar,
    ) -> Result<Self, SplineError> {
        let zero = P::Scalar::ZERO;
        let turn = P::Scalar::PI + P::Scalar::PI;
        if !(angle > zero && angle <= turn) {
            return Err(SplineError::Angle { angle: angle.to_f64() });
        }
        let axis = direction(axis).ok_or(SplineError::Axis)?;
        let mut arcs = 1;
        while P::Scalar::from_usize(arcs) * P::Scalar::PI * P::Scalar::of(0.5) < angle && arcs < 4 {
            arcs += 1;
        }
        let step = angle / P::Scalar::from_usize(arcs);
        let middle_weight = (step * P::Scalar::of(0.5)).sin_cos().1;
        let (mut breakpoints, mut rows) = (alloc::vec![zero], Vec::new());
        for half in 0..=2 * arcs {
            if half % 2 == 0 && half > 0 {
                let end = if half == 2 * arcs { angle } else { step * P::Scalar::from_usize(half / 2) };
                breakpoints.push(end);
                if half < 2 * arcs {
                    breakpoints.push(end);
                }
            }
            // A full turn ends exactly where it began.
            let closed = half == 2 * arcs && angle >= turn;
            let turned_by = step * P::Scalar::of(0.5) * P::Scalar::from_usize(half);
            let (sin, cos) = if closed { (zero, P::Scalar::ONE) } else { turned_by.sin_cos() };
            let (weight, stretch) = if half % 2 == 0 {
                (P::Scalar::ONE, P::Scalar::ONE)
            } else {
                (middle_weight, P::Scalar::ONE / middle_weight)
            };
            let row: Vec<_> = curve
                .homogeneous()
                .control_points()
                .iter()
                .map(|point| {
                    // The components along the axis, away from it, and in the direction of the turn.
                    let from = point.project().minus(origin);
                    let along = axis.scale(crate::vector::dot(axis, from));
                    let away = from.minus(along);
                    let turned = away.scale(cos).add_scaled(cross(axis, away), sin);
                    let place = origin.add_scaled(along, P::Scalar::ONE).add_scaled(turned, stretch);
                    Homogeneous::new(place, point.weight * weight)
                })
                .collect();
            rows.push(row);
        }
        let u = KnotVector::clamped(2, &breakpoints)?;
        let net = Net::from_rows(rows)?;
        Self::from_homogeneous(BSplineSurface::new(u, curve.knots().clone(), net)?)
    }
}

impl<B: Basis, P: Point3<Scalar = B::Scalar>> TryFrom<&SurfaceOfRevolution<B, P>> for NurbsSurface<P> {
    type Error = SplineError;

    /// The same surface, exactly: `u` is the parameter of the generatrix, as before; `v` is the angle at the ends of at most
    /// four arcs of equal angles, and a rational function of it between them.
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
        let mut ends = alloc::vec![B::Scalar::ZERO];
        for arc in 1..count {
            ends.extend([surface.angle() * B::Scalar::from_usize(arc) / B::Scalar::from_usize(count); 2]);
        }
        ends.push(surface.angle());
        let u = KnotVector::clamped(rows.saturating_sub(1), &B::domain())?;
        let net = Net::from_rows(points)?;
        Self::from_homogeneous(BSplineSurface::new(u, KnotVector::clamped(2, &ends)?, net)?)
    }
}
