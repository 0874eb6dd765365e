//! Surfaces of revolution.

mod bounds;
mod circle;
mod error;
#[cfg(feature = "alloc")]
mod join;
#[cfg(feature = "alloc")]
mod rational;

use core::ops::Range;

use crate::curve::{divisible, nonempty};
use crate::surface::partials_by_number;
use crate::vector::{any_perpendicular, cross, direction, distance, dot, is_finite, length};
use crate::{
    Array, Basis, BernsteinOf, BezierOf, Curve, CurveError, Direction, Point, Point3, Scalar, Surface,
    SurfaceDomain,
};
#[cfg(feature = "bspline")]
pub(crate) use circle::Arcs;
pub use circle::half_turn_parameter;
pub use error::RevolutionError;
#[cfg(feature = "alloc")]
pub use rational::RevolutionPatch;

/// The surface that a curve, the generatrix `C`, sweeps while it turns about an axis.
///
/// With the axis through `O` in the unit direction `d`, and `C(u) = O + h(u) d + r(u)` with `r` perpendicular to `d`,
///
/// ```text
/// S(u, v) = O + h(u) d + cos v r(u) + sin v (d × r(u)),   0 <= v <= θ
/// ```
///
/// `u` is the parameter of the generatrix and `v` the angle in radians, so that equal steps in `v` are equal angles.
/// The turn is right-handed about `d`. A generatrix may be any curve in space, may touch the axis (the surface has a
/// pole there, with a normal by continuity) or cross it. After a full turn, `θ = 2π`, the surface closes exactly.
///
/// ```
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// use basis_runtime::{Curve, Surface, SurfaceOfRevolution};
///
/// let generatrix = Curve::new(QuarticBernstein::new(0.5)?, [[0.0, 1.0], [1.0, 2.0], [2.0, 2.0], [3.0, 1.0]]);
/// let vase = SurfaceOfRevolution::about_x(&generatrix, 2.0 * std::f64::consts::PI)?;
/// assert_eq!(vase.eval(1.0, 0.0), [3.0, 1.0, 0.0]);
/// let [x, y, z] = vase.eval(1.0, std::f64::consts::FRAC_PI_2);
/// assert!(x == 3.0 && y.abs() < 1e-15 && z == 1.0);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        into = "crate::serialize::revolution::Revolution<B, P>",
        try_from = "crate::serialize::revolution::Revolution<B, P>",
        bound(
            serialize = "B: serde::Serialize, P: serde::Serialize, P::Vector: serde::Serialize, B::Scalar: serde::Serialize",
            deserialize = "B: serde::Deserialize<'de>, P: serde::Deserialize<'de>, P::Vector: serde::Deserialize<'de>, B::Scalar: serde::Deserialize<'de>"
        )
    )
)]
pub struct SurfaceOfRevolution<B: Basis, P: Point3<Scalar = B::Scalar>> {
    generatrix: Curve<B, P>,
    /// `O`
    point: P,
    /// As given, not of length one.
    axis: P::Vector,
    /// `O + h d`, the centres of the circles.
    centres: Curve<B, P>,
    /// `r`, from the centre to the point at angle 0.
    radii: Curve<B, P::Vector>,
    /// `d × r`, from the centre to the point at a right angle.
    quarters: Curve<B, P::Vector>,
    angle: B::Scalar,
}

impl<B: Basis, P: Point3<Scalar = B::Scalar>> SurfaceOfRevolution<B, P> {
    /// The surface of a generatrix about the axis through a point in a direction, by an angle in radians,
    /// `0 < angle <= 2π`. A full turn is `2.0 * PI` in the scalar type.
    ///
    /// # Errors
    /// When the angle is not in that range, the direction is zero, or anything is infinite or NaN.
    pub fn new(
        generatrix: &Curve<B, P>,
        point: P,
        axis: P::Vector,
        angle: B::Scalar,
    ) -> Result<Self, RevolutionError> {
        // Written so that NaN is refused.
        if !(angle > B::Scalar::ZERO && angle <= B::Scalar::of(2.0) * B::Scalar::PI) {
            return Err(RevolutionError::Angle { value: angle.to_f64() });
        }
        let along_axis = direction(axis).filter(|_| is_finite(point)).ok_or(RevolutionError::Axis)?;
        let points = generatrix.control_points();
        if !points.iter().all(|&p| is_finite(p)) {
            return Err(RevolutionError::NotFinite);
        }
        let basis = generatrix.basis();
        let parts: B::Points<[P::Vector; 2]> = B::Points::from_fn(|i| {
            let offset = points[i].minus(point);
            let along = along_axis.scale(dot(offset, along_axis));
            [along, offset.minus(along)]
        });
        let parts = parts.as_ref();
        let centre = |i: usize| point.add_scaled(parts[i][0], B::Scalar::ONE);
        Ok(Self {
            generatrix: *generatrix,
            point,
            axis,
            centres: Curve::new(basis, B::Points::from_fn(centre)),
            radii: Curve::new(basis, B::Points::from_fn(|i| parts[i][1])),
            quarters: Curve::new(basis, B::Points::from_fn(|i| cross(along_axis, parts[i][1]))),
            angle,
        })
    }

    /// The angle `θ` in radians.
    #[inline]
    pub fn angle(&self) -> B::Scalar {
        self.angle
    }

    /// The generatrix, the meridian at the angle 0.
    #[inline]
    pub fn generatrix(&self) -> &Curve<B, P> {
        &self.generatrix
    }

    /// A point of the axis, and its direction, as they were given.
    #[inline]
    pub fn axis(&self) -> (P, P::Vector) {
        (self.point, self.axis)
    }

    /// Whether the surface is a full turn.
    #[inline]
    pub fn is_closed(&self) -> bool {
        self.angle == B::Scalar::of(2.0) * B::Scalar::PI
    }

    /// The image under a similarity: a motion, a reflection, a uniform scaling, or several of them.
    ///
    /// ```
    /// use basis_runtime::{Bezier, Surface, SurfaceOfRevolution};
    ///
    /// let cone = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 0.0], [2.0, 1.0]]), 3.0)?;
    /// let moved = cone.map(|[x, y, z]| [5.0 - y, 2.0 + x, z])?; // turned by a right angle, and moved
    /// let [x, y, z]: [f64; 3] = moved.eval(1.0, 1.5);
    /// assert!((x - 5.0).hypot(z) - 1.0 < 1e-14 && (y - 4.0).abs() < 1e-14); // on a circle about the line (5, y, 0)
    /// assert!(cone.map(|[x, y, z]| [x, y, 2.0 * z]).is_err()); // elliptic
    /// # Ok::<(), basis_runtime::RevolutionError>(())
    /// ```
    ///
    /// # Errors
    /// [`RevolutionError::NoSimilarity`] if the map distorts angles, because the image is no surface of revolution then; with the
    /// feature `bspline` the surface as a `NurbsSurface` has an image under every affine map. Otherwise as
    /// [`new`](Self::new).
    pub fn map<Q: Point3<Scalar = B::Scalar>>(
        &self,
        mut image: impl FnMut(P) -> Q,
    ) -> Result<SurfaceOfRevolution<B, Q>, RevolutionError> {
        let along = direction(self.axis).ok_or(RevolutionError::Axis)?;
        let across = any_perpendicular(along);
        // The images of a frame as large as the surface.
        let points = self.generatrix.control_points();
        let size = points.iter().fold(B::Scalar::ZERO, |size, &p| size.max(distance(p, self.point)));
        let size = if size > B::Scalar::ZERO { size } else { B::Scalar::ONE };
        let origin = image(self.point);
        let frame = [along, across, cross(along, across)]
            .map(|unit| image(self.point.add_scaled(unit, size)).minus(origin));
        let lengths = frame.map(length);
        let noise = B::Scalar::of(64.0) * B::Scalar::EPSILON * (lengths[0] + length(origin));
        let alike = |k: usize| {
            let next = frame[(k + 1) % 3];
            (lengths[k] - lengths[0]).abs() <= noise && dot(frame[k], next).abs() <= noise * lengths[0]
        };
        if !(0..3).all(alike) {
            return Err(RevolutionError::NoSimilarity);
        }
        // A reflection turns the other way about the image of the axis.
        let mirrored = dot(cross(frame[0], frame[1]), frame[2]) < B::Scalar::ZERO;
        let length_of_axis = length(self.axis) / lengths[0];
        let axis = frame[0].scale(if mirrored { -length_of_axis } else { length_of_axis });
        SurfaceOfRevolution::new(&self.generatrix.map(image), origin, axis, self.angle)
    }

    /// The image under a similarity of the library of the points, see [`AffineMap`](crate::AffineMap); as by
    /// [`map`](Self::map).
    ///
    /// # Errors
    /// As [`map`](Self::map).
    pub fn transform(&self, by: &impl crate::AffineMap<P>) -> Result<Self, RevolutionError> {
        self.map(|point| by.image(point))
    }

    /// The meridian at the angle `v`: the generatrix, turned by that angle.
    pub fn meridian(&self, v: B::Scalar) -> Curve<B, P> {
        let [cos, sin] = circle::direction(v);
        let centres = self.centres.control_points();
        let [radii, quarters] = [&self.radii, &self.quarters].map(Curve::control_points);
        let point = |i: usize| centres[i].add_scaled(radii[i], cos).add_scaled(quarters[i], sin);
        Curve::new(self.centres.basis(), B::Points::from_fn(point))
    }
}

impl<B: Basis, P: Point3<Scalar = B::Scalar>> SurfaceOfRevolution<B, P> {
    /// The parts below and above a parameter of one direction, each with a generatrix in Bézier form on the unit interval
    /// and an angle from 0 on: the generatrix is divided, or the turn.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if the parameter is outside of the domain or NaN, [`CurveError::AtEnd`] at an end of
    /// it, where one part would be a curve.
    pub fn split(
        &self,
        along: Direction,
        at: P::Scalar,
    ) -> Result<[SurfaceOfRevolution<BernsteinOf<B>, P>; 2], CurveError> {
        let [[u_lo, u_hi], [v_lo, v_hi]] = self.domain().ranges();
        match along {
            Direction::U => {
                divisible([u_lo, u_hi], at)?;
                Ok([self.subpatch(u_lo..at, v_lo..v_hi)?, self.subpatch(at..u_hi, v_lo..v_hi)?])
            }
            Direction::V => {
                divisible([v_lo, v_hi], at)?;
                Ok([self.subpatch(u_lo..u_hi, v_lo..at)?, self.subpatch(u_lo..u_hi, at..v_hi)?])
            }
        }
    }

    /// The part over a rectangle of parameters, with a generatrix in Bézier form on the unit interval and an angle from 0
    /// on; a range with `start > end` runs backwards, that of the angle about the opposite axis.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if an end of a range is outside of the domain or NaN, [`CurveError::EmptyRange`] if
    /// both ends of one are equal.
    pub fn subpatch(
        &self,
        u: Range<P::Scalar>,
        v: Range<P::Scalar>,
    ) -> Result<SurfaceOfRevolution<BernsteinOf<B>, P>, CurveError> {
        let [u_domain, v_domain] = self.domain().ranges();
        nonempty(u_domain, &u)?;
        nonempty(v_domain, &v)?;
        let part = |curve: &Curve<B, P>| curve.subsegment(u.clone());
        let radial = |curve: &Curve<B, P::Vector>| curve.subsegment(u.clone());
        let curves = [part(&self.generatrix)?, part(&self.centres)?];
        Ok(self.turned(curves, [radial(&self.radii)?, radial(&self.quarters)?], v))
    }

    /// The same surface with one parameter running the other way, with a generatrix in Bézier form on the unit interval;
    /// its normals turn to the other side.
    #[must_use]
    pub fn reversed(&self, along: Direction) -> SurfaceOfRevolution<BernsteinOf<B>, P> {
        let [_, [lo, hi]] = self.domain().ranges();
        let (curves, radial) = ([&self.generatrix, &self.centres], [&self.radii, &self.quarters]);
        match along {
            Direction::U => self.turned(curves.map(Curve::reversed), radial.map(Curve::reversed), lo..hi),
            Direction::V => self.turned(curves.map(Curve::to_bezier), radial.map(Curve::to_bezier), hi..lo),
        }
    }

    /// The surface between two angles, over these parts of the generatrix, the centres, the radii and the quarters.
    fn turned(
        &self,
        [generatrix, centres]: [BezierOf<B, P>; 2],
        radial: [BezierOf<B, P::Vector>; 2],
        v: Range<P::Scalar>,
    ) -> SurfaceOfRevolution<BernsteinOf<B>, P> {
        let [cos, sin] = circle::direction(v.start);
        let sign = if v.start > v.end { -P::Scalar::ONE } else { P::Scalar::ONE };
        let basis = BernsteinOf::<B>::default();
        let [r, q] = radial.each_ref().map(Curve::control_points);
        let radii = Curve::new(basis, Array::from_fn(|i| r[i].scale(cos).add_scaled(q[i], sin)));
        let quarter = |i: usize| q[i].scale(cos).add_scaled(r[i], -sin).scale(sign);
        let quarters = Curve::new(basis, Array::from_fn(quarter));
        let c = centres.control_points();
        let start = radii.control_points();
        SurfaceOfRevolution {
            // At the angle 0 as it was given.
            generatrix: if sin == P::Scalar::ZERO && cos == P::Scalar::ONE {
                generatrix
            } else {
                Curve::new(basis, Array::from_fn(|i| c[i].add_scaled(start[i], P::Scalar::ONE)))
            },
            point: self.point,
            axis: self.axis.scale(sign),
            centres,
            radii,
            quarters,
            angle: (v.end - v.start).abs(),
        }
    }
}

impl<B: Basis> SurfaceOfRevolution<B, [B::Scalar; 3]> {
    /// The surface `(x(u), y(u) cos v, y(u) sin v)` of a plane curve `(x, y)` about the x axis.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn about_x(generatrix: &Curve<B, [B::Scalar; 2]>, angle: B::Scalar) -> Result<Self, RevolutionError> {
        let (zero, one) = (B::Scalar::ZERO, B::Scalar::ONE);
        let [x, y] = [0, 1].map(|c| move |i: usize| generatrix.control_points()[i][c]);
        let in_space = Curve::new(generatrix.basis(), B::Points::from_fn(|i| [x(i), y(i), zero]));
        Self::new(&in_space, [zero; 3], [one, zero, zero], angle)
    }
}

impl<B: Basis, P: Point3<Scalar = B::Scalar>> Surface for SurfaceOfRevolution<B, P> {
    type Point = P;

    #[inline]
    fn domain(&self) -> SurfaceDomain<P::Scalar> {
        SurfaceDomain::Rectangle([B::domain(), [P::Scalar::ZERO, self.angle]])
    }

    #[inline]
    fn eval(&self, u: P::Scalar, v: P::Scalar) -> P {
        let [cos, sin] = circle::direction(v);
        self.centres.eval(u).add_scaled(self.radii.eval(u), cos).add_scaled(self.quarters.eval(u), sin)
    }

    fn partial(&self, u: P::Scalar, v: P::Scalar, [i, j]: [usize; 2]) -> P::Vector {
        let [cos, sin] = circle::direction(v);
        let [c, s] = [[cos, sin], [-sin, cos], [-cos, -sin], [sin, -cos]][j % 4];
        let centre = if j == 0 { self.centres.derivative(u, i) } else { P::Vector::zero() };
        centre.add_scaled(self.radii.derivative(u, i), c).add_scaled(self.quarters.derivative(u, i), s)
    }

    partials_by_number!();

    #[inline]
    fn eval_with_partials<const K: usize>(&self, u: P::Scalar, v: P::Scalar) -> [[P::Vector; K]; K] {
        let centres = self.centres.eval_with_derivs::<K>(u);
        let radii = self.radii.eval_with_derivs::<K>(u);
        let quarters = self.quarters.eval_with_derivs::<K>(u);
        let [cos, sin] = circle::direction(v);
        core::array::from_fn(|i| {
            core::array::from_fn(|j| {
                // Derivatives of cosine and sine go round.
                let [c, s] = [[cos, sin], [-sin, cos], [-cos, -sin], [sin, -cos]][j % 4];
                let centre = if j == 0 { centres[i] } else { P::Vector::zero() };
                centre.add_scaled(radii[i], c).add_scaled(quarters[i], s)
            })
        })
    }
}
