//! Direction and bending of a curve: tangent, curvature, torsion, frames that move along it.

use crate::domain::{from_unit, inverse_width};
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::vector::{
    any_perpendicular, cross, direction, dot, largest_component, length, perpendicular, safe_unit, vectors,
    wedge,
};
use crate::{Basis, Curve, CurveError, Form, Point, Point3, Scalar};

/// Three perpendicular unit vectors at a point of a curve in space; `binormal = tangent × normal`.
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
pub struct Frame<P: Point> {
    /// The point of the curve.
    pub point: P,
    /// The direction in which the curve goes on.
    pub tangent: P::Vector,
    /// A unit vector perpendicular to the tangent.
    pub normal: P::Vector,
    /// The unit vector perpendicular to both.
    pub binormal: P::Vector,
}

impl<P: Point3> Frame<P> {
    fn new(point: P, tangent: P::Vector, normal: P::Vector) -> Self {
        Self { point, tangent, normal, binormal: cross(tangent, normal) }
    }

    /// What a slice of frames holds before it is filled.
    #[cfg(feature = "alloc")]
    pub(crate) fn empty() -> Self {
        let zero = P::Vector::zero();
        Self { point: P::zero(), tangent: zero, normal: zero, binormal: zero }
    }
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The unit vector in which the curve goes on at `t`.
    ///
    /// Where the velocity vanishes it is the limit: the direction of the first derivative that does not vanish up to
    /// rounding; at a cusp the direction of leaving, at the end of the domain that of arriving. `None` if the curve is
    /// a point, and if anything is not finite.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let slow = Bezier::from_points([[0.0, 0.0], [0.0, 0.0], [3.0, 4.0]]); // the velocity at 0 is zero
    /// assert_eq!(slow.tangent(0.0), Some([0.6, 0.8]));
    /// ```
    pub fn tangent(&self, t: B::Scalar) -> Option<P::Vector> {
        let [_, velocity] = self.eval_with_derivs(t);
        let points = self.to_bernstein();
        let largest = points.as_ref().iter().fold(B::Scalar::ZERO, |a, &p| a.max(largest_component(p)));
        // What is left of n (P[i+1] - P[i]) by rounding.
        let degree = B::Scalar::from_usize(B::DEGREE);
        let mut noise = B::Scalar::of(4.0) * B::Scalar::EPSILON * largest * degree;
        let inverse_width = inverse_width(B::domain());
        noise = noise * inverse_width;
        if length(velocity) > noise {
            return direction(velocity);
        }
        let mut derivatives: B::Bernstein<P::Vector> = vectors(points.as_ref());
        self.derivatives_into(t, derivatives.as_mut());
        let arriving = t == B::domain()[1];
        for (order, &derivative) in derivatives.as_ref().iter().enumerate().skip(1) {
            if length(derivative) > noise {
                let backwards = arriving && order % 2 == 0;
                return direction(if backwards { P::Vector::zero().minus(derivative) } else { derivative });
            }
            noise = noise * inverse_width * B::Scalar::from_usize(B::DEGREE - order) * B::Scalar::of(2.0);
        }
        None
    }

    /// The curvature at `t`: `|C' ∧ C''| / |C'|³`; in the plane with a sign, positive where the curve turns to the
    /// left, `(x' y'' - y' x'') / |C'|³`.
    ///
    /// Infinite or NaN where the velocity vanishes.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let parabola = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]); // y = x²
    /// assert_eq!(parabola.curvature(0.5), 2.0);
    /// assert_eq!(parabola.reversed().curvature(0.5), -2.0);
    /// ```
    pub fn curvature(&self, t: B::Scalar) -> B::Scalar {
        let [_, velocity, acceleration] = self.eval_with_derivs(t);
        curvature(velocity, acceleration)
    }

    /// The torsion at `t` of a curve in space: `det(C', C'', C''') / |C' × C''|²`, positive for a right-handed screw.
    ///
    /// Where the curvature vanishes, as everywhere on a straight line, the quotient has no meaning: NaN, infinite, or
    /// rounding errors alone.
    pub fn torsion(&self, t: B::Scalar) -> B::Scalar
    where
        P: Point3,
    {
        torsion(self.eval_with_derivs(t))
    }

    /// The Frenet frame at `t`: tangent, principal normal and binormal. The normal points to the centre of curvature.
    ///
    /// # Errors
    /// [`CurveError::NoTangent`] where [`tangent`](Self::tangent) is `None`, [`CurveError::NoNormal`] where the
    /// curvature vanishes up to rounding.
    pub fn frenet_frame(&self, t: B::Scalar) -> Result<Frame<P>, CurveError>
    where
        P: Point3,
    {
        let tangent = self.tangent(t).ok_or(CurveError::NoTangent)?;
        let largest =
            self.to_bernstein().as_ref().iter().fold(B::Scalar::ZERO, |a, &p| a.max(largest_component(p)));
        let inverse_width = inverse_width(B::domain());
        let factor =
            B::Scalar::from_usize(B::DEGREE * B::DEGREE.saturating_sub(1)) * inverse_width * inverse_width;
        frenet(self.eval_with_derivs(t), tangent, factor * largest, t)
    }

    /// `count` frames that do not turn around the curve, at equal distances of the parameter, both ends included. The
    /// first has the given normal, made perpendicular to the tangent, or without one an arbitrary normal.
    ///
    /// By double reflection (Wang, Jüttler, Zheng and Liu, *Computation of rotation minimizing frames*, ACM
    /// Transactions on Graphics 27, 2008): the angle between these and the exact frames falls with the fourth power of
    /// the distance of the points.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let arch = Bezier::from_points([[0.0, 0.0, 0.0], [1.0, 2.0, 0.0], [3.0, 2.0, 0.0], [4.0, 0.0, 0.0]]);
    /// let up = [0.0, 0.0, 1.0];
    /// let frames = arch.rotation_minimizing_frames(5, Some(up))?;
    /// assert!(frames.iter().all(|frame| frame.normal == up)); // along a curve in a plane its normal stays
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::NoTangent`] if the curve is a point, or not finite.
    #[cfg(feature = "alloc")]
    pub fn rotation_minimizing_frames(
        &self,
        count: usize,
        normal: Option<P::Vector>,
    ) -> Result<alloc::vec::Vec<Frame<P>>, CurveError>
    where
        P: Point3,
    {
        let mut frames = alloc::vec![Frame::empty(); count];
        self.rotation_minimizing_frames_into(normal, &mut frames)?;
        Ok(frames)
    }

    /// As many frames as the slice has places, as `rotation_minimizing_frames` gives them.
    ///
    /// # Errors
    /// [`CurveError::NoTangent`] if the curve is a point, or not finite; some of the frames may have been written.
    pub fn rotation_minimizing_frames_into(
        &self,
        normal: Option<P::Vector>,
        frames: &mut [Frame<P>],
    ) -> Result<(), CurveError>
    where
        P: Point3,
    {
        let steps = B::Scalar::from_usize(frames.len().saturating_sub(1).max(1));
        rotation_minimizing(normal, frames, &|i| {
            let x = B::Scalar::from_usize(i) / steps;
            Some((self.form.eval(x), self.tangent(from_unit(B::domain(), x))?))
        })
    }
}

/// The torsion from the point and three derivatives.
pub(crate) fn torsion<V: Point>([_, first, second, third]: [V; 4]) -> V::Scalar {
    // Of the product of two of them.
    let [first_unit, second_unit] = [first, second].map(|vector| safe_unit(largest_component(vector), 1));
    let scaled = |vector: V, unit: V::Scalar| V::from_components(|d| vector.component(d) / unit);
    let binormal = cross(scaled(first, first_unit), scaled(second, second_unit));
    let size = length(binormal);
    dot(scaled(binormal, size), third) / size / first_unit / second_unit
}

/// The Frenet frame from the point, two derivatives and the tangent. `bend` is the size of second derivatives of which
/// rounding leaves some `ε`: `n (n-1)` times the largest control point over the square of the width of the domain.
pub(crate) fn frenet<P: Point3>(
    [point, velocity, acceleration]: [P::Vector; 3],
    tangent: P::Vector,
    bend: P::Scalar,
    t: P::Scalar,
) -> Result<Frame<P>, CurveError> {
    let no_normal = CurveError::NoNormal { parameter: t.to_f64() };
    let across = acceleration.add_weighted(tangent, -dot(acceleration, tangent));
    // What is left of the second differences of the control points, and of the part along the tangent, by rounding.
    let noise = P::Scalar::of(16.0) * P::Scalar::EPSILON * (length(acceleration) + bend);
    if !(length(across) > noise && length(velocity) > P::Scalar::ZERO) {
        return Err(no_normal);
    }
    let normal = perpendicular(tangent, across).ok_or(no_normal)?;
    Ok(Frame::new(P::from_vector(point), tangent, normal))
}

/// Frames by double reflection at the points and tangents of `at`, of which there is one for each place of the slice.
pub(crate) fn rotation_minimizing<P: Point3>(
    normal: Option<P::Vector>,
    frames: &mut [Frame<P>],
    at: &dyn Fn(usize) -> Option<(P, P::Vector)>,
) -> Result<(), CurveError> {
    let mut last: Option<Frame<P>> = None;
    for (i, frame) in frames.iter_mut().enumerate() {
        let (point, tangent) = at(i).ok_or(CurveError::NoTangent)?;
        let normal = match last {
            None => normal.and_then(|normal| perpendicular(tangent, normal)),
            Some(last) => perpendicular(tangent, reflect_twice(&last, point, tangent)),
        };
        *frame = Frame::new(point, tangent, normal.unwrap_or_else(|| any_perpendicular(tangent)));
        last = Some(*frame);
    }
    Ok(())
}

/// `|v ∧ a| / |v|³`, in the plane with its sign.
pub(crate) fn curvature<P: Point>(velocity: P, acceleration: P) -> P::Scalar {
    let Bend { tangent, acceleration, unit, speed } = Bend::of(velocity, acceleration);
    let bend = if P::DIM == 2 {
        wedge(tangent, acceleration, 0, 1)
    } else {
        // Lagrange's identity by components: |v|² |a|² - (v·a)² would lose half of the digits.
        let mut sum = P::Scalar::ZERO;
        for i in 0..P::DIM {
            for j in 0..i {
                let w = wedge(tangent, acceleration, i, j);
                sum = sum + w * w;
            }
        }
        sum.sqrt()
    };
    bend * unit / speed / speed
}

/// `(a - (a·T) T) / |v|²` with the unit tangent `T`: the vector to the centre of curvature of the length of the curvature.
/// `None` where the velocity vanishes or is not finite.
pub(crate) fn curvature_vector<P: Point>(velocity: P, acceleration: P) -> Option<P> {
    let tangent = direction(velocity)?;
    let Bend { acceleration, unit, speed, .. } = Bend::of(velocity, acceleration);
    let across = acceleration.add_weighted(tangent, -dot(acceleration, tangent));
    Some(P::from_components(|d| across.component(d) * unit / speed / speed))
}

/// The first two derivatives of a curve in units in which products of them neither overflow nor vanish.
struct Bend<P: Point> {
    /// The velocity divided by the speed.
    tangent: P,
    /// The acceleration divided by the unit.
    acceleration: P,
    unit: P::Scalar,
    speed: P::Scalar,
}

impl<P: Point> Bend<P> {
    fn of(velocity: P, acceleration: P) -> Self {
        let speed = length(velocity);
        let unit = safe_unit(largest_component(acceleration), 1);
        Self {
            tangent: P::from_components(|d| velocity.component(d) / speed),
            acceleration: P::from_components(|d| acceleration.component(d) / unit),
            unit,
            speed,
        }
    }
}

/// The normal of a frame after two reflections: the first maps its point to the next one, the second its tangent,
/// reflected, to the next one.
fn reflect_twice<P: Point>(frame: &Frame<P>, point: P, tangent: P::Vector) -> P::Vector {
    let reflect = |mirror: P::Vector, vector: P::Vector| match direction(mirror) {
        Some(unit) => vector.add_weighted(unit, -P::Scalar::of(2.0) * dot(unit, vector)),
        None => vector,
    };
    let first = point.minus(frame.point);
    let second = tangent.minus(reflect(first, frame.tangent));
    reflect(second, reflect(first, frame.normal))
}
