//! Boxes around surfaces of revolution.
//!
//! A component of the surface is `c(u) + cos v r(u) + sin v q(u)`. Its largest value over the angles is a convex
//! function of `(c, r, q)`, so that those at the Bézier control points bound it.

use super::{SurfaceOfRevolution, circle};
use crate::{Basis, Curve, Point, Point3, Scalar};

/// The number of parts of the generatrix that are looked at for each side of a box.
#[cfg(feature = "alloc")]
const PARTS: usize = 500;

/// The number of halvings after which a part is a point; the smallest numbers stay apart for ever.
#[cfg(feature = "alloc")]
const ROUNDS: usize = 64;

impl<B: Basis, P: Point3<Scalar = B::Scalar>> SurfaceOfRevolution<B, P> {
    /// The smallest axis-parallel box around what the Bézier control points of the generatrix sweep, as its two extreme
    /// corners: cheap, and never too small up to rounding errors.
    pub fn control_box(&self) -> [P; 2] {
        self.sides(|component| {
            let points = component.to_bernstein();
            let values = points.as_ref().iter().map(|&point| self.largest_of(point));
            values.fold(-B::Scalar::INFINITY, B::Scalar::max)
        })
    }

    /// The smallest axis-parallel box around the surface, as its two extreme corners, up to rounding errors.
    ///
    /// ```
    /// use basis_runtime::{Bezier, SurfaceOfRevolution};
    ///
    /// // Three quarters of a paraboloid about the x axis.
    /// let generatrix = Bezier::from_points([[0.0, 0.0], [0.0, 1.0], [1.0, 2.0]]);
    /// let bowl = SurfaceOfRevolution::about_x(&generatrix, 1.5 * std::f64::consts::PI)?;
    /// let [low, high] = bowl.bounding_box();
    /// assert!((low[1] + 2.0).abs() < 1e-15 && (low[2] + 2.0).abs() < 1e-15);
    /// assert_eq!((low[0], high), (0.0, [1.0, 2.0, 2.0]));
    /// # Ok::<(), basis_runtime::RevolutionError>(())
    /// ```
    #[cfg(feature = "alloc")]
    pub fn bounding_box(&self) -> [P; 2] {
        self.sides(|component| {
            let mut best = -B::Scalar::INFINITY;
            let of = |&point: &[B::Scalar; 3]| self.largest_of(point);
            let points = component.to_bernstein();
            let size = points.as_ref().iter().map(|p| of(p).abs()).fold(B::Scalar::ZERO, B::Scalar::max);
            let noise = B::Scalar::of(4.0) * B::Scalar::EPSILON * size;
            let mut parts = alloc::vec![points];
            // Every round halves what may hold a larger value; a part of the size of the noise holds none.
            for round in 0.. {
                let ends =
                    parts.iter().filter_map(|part| Some([part.as_ref().first()?, part.as_ref().last()?]));
                best = ends.flatten().map(of).fold(best, B::Scalar::max);
                let above = |part: &B::Bernstein<[B::Scalar; 3]>| {
                    part.as_ref().iter().map(of).fold(best, B::Scalar::max)
                };
                parts.retain(|part| above(part) > best + noise);
                if parts.is_empty() || parts.len() > PARTS || round > ROUNDS {
                    return parts.iter().map(above).fold(best, B::Scalar::max);
                }
                parts = parts.into_iter().flat_map(|part| halves::<B>(part)).collect();
            }
            best
        })
    }

    /// The least and the largest value of each component, which is given as the curve `(c, r, q)`; the least one is
    /// that of the opposites, with the sign -1.
    fn sides(&self, largest: impl Fn(Curve<B, [B::Scalar; 3]>) -> B::Scalar) -> [P; 2] {
        let centres = self.centres.control_points();
        let [radii, quarters] = [&self.radii, &self.quarters].map(Curve::control_points);
        [-B::Scalar::ONE, B::Scalar::ONE].map(|sign| {
            P::from_components(|d| {
                let point = |i: usize| {
                    [centres[i].component(d), radii[i].component(d), quarters[i].component(d)]
                        .map(|c| c * sign)
                };
                let component = Curve::new(self.centres.basis(), crate::Array::from_fn(point));
                largest(component) * sign
            })
        })
    }

    /// `c + max (r cos v + q sin v)` over the angles of the surface.
    fn largest_of(&self, [centre, radius, quarter]: [B::Scalar; 3]) -> B::Scalar {
        let full = B::Scalar::of(2.0) * B::Scalar::PI;
        let at = quarter.atan2(radius);
        let at = if at < B::Scalar::ZERO { at + full } else { at };
        let swing = if at <= self.angle {
            crate::vector::length([radius, quarter])
        } else {
            let [cos, sin] = circle::direction(self.angle);
            radius.max(radius * cos + quarter * sin)
        };
        centre + swing
    }
}

#[cfg(feature = "alloc")]
fn halves<B: Basis>(mut part: B::Bernstein<[B::Scalar; 3]>) -> [B::Bernstein<[B::Scalar; 3]>; 2] {
    let mut right = part;
    crate::bernstein::split(part.as_mut(), B::Scalar::of(0.5), right.as_mut());
    [part, right]
}
