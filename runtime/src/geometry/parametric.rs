//! The trait of all curves.

use alloc::vec::Vec;
use core::ops::Range;

use super::continued::{JoinableCurve, touching};
use super::convert::{back, clamped, corners_of, floor, in_the_plane, sample};
use super::measure::{bounds, enclosed, flatten, length};
use super::meetings::{meeting, surface_meeting};
use super::{Closest, CurvePiece, Enclosed, Meeting, PlaneMeeting, SurfaceMeeting, closest, local, nearest};
use crate::curve::{curvature, frenet, inside, rotation_minimizing, same_length, torsion};
use crate::vector::{direction, distance, largest_component, recast};
use crate::{
    BoundedSurface, Contact, CurveError, Frame, Joint, Nearest, Offset, Path, Point, Point3, Scalar,
};

/// The scalar type of a curve: of its parameter and of the components of its points.
pub type CurveScalar<C> = <<C as ParametricCurve>::Point as Point>::Scalar;

/// The type of the derivatives, tangents and normals of a curve.
pub type CurveVector<C> = <<C as ParametricCurve>::Point as Point>::Vector;

/// A curve `C(t)`, `lo <= t <= hi`, of any type: [`Curve`](crate::Curve) over a family, Bézier curve,
/// [`RationalCurve`](crate::RationalCurve), [`RationalBezier`](crate::RationalBezier),
/// [`PiecewiseCurve`](crate::PiecewiseCurve), and with the feature `bspline` `BSplineCurve` and `NurbsCurve`.
///
/// Every question has one name and one signature for all of them. What a type answers faster by itself it has as a
/// method of its own, with the same name, arguments and meaning, so that the trait need not be imported there.
///
/// A type of your own provides five functions, among them its Bézier pieces, and gets all others. All that is not
/// marked `Self: Sized` can be asked of a `&dyn ParametricCurve<Point = P>` too:
///
/// ```
/// use basis_runtime::{Bezier, ParametricCurve};
///
/// let line = Bezier::from_points([[0.0, 0.0], [3.0, 4.0]]);
/// let arch = Bezier::from_points([[3.0, 4.0], [4.0, 6.0], [5.0, 4.0]]);
/// let path: [Box<dyn ParametricCurve<Point = [f64; 2]>>; 2] = [Box::new(line), Box::new(arch)];
/// let length: f64 = path.iter().map(|curve| curve.arclen(1e-9)).sum();
/// assert!((length - 7.957_885_715_089_195).abs() < 1e-9);
/// ```
///
/// Parameters outside of the domain continue the formula of the curve at that end; questions that say so refuse them.
/// A NaN parameter gives NaN.
pub trait ParametricCurve {
    /// The type of the points.
    type Point: Point;

    /// The type of a part of the curve.
    type Part: ParametricCurve<Point = Self::Point>
    where
        Self: Sized;

    /// The two ends `[lo, hi]` of the domain.
    fn domain(&self) -> [CurveScalar<Self>; 2];

    /// The point `C(t)`.
    fn eval(&self, t: CurveScalar<Self>) -> Self::Point;

    /// The derivatives `C⁽ᵏ⁾(t)`, `k = 0, 1, 2, …`, as many as the slice has places; the one of order 0 is the vector from
    /// the origin to the point. Where a derivative jumps, it is that of the later piece; at the end of the domain that of
    /// the last one.
    fn derivatives_into(&self, t: CurveScalar<Self>, derivatives: &mut [CurveVector<Self>]);

    /// The rational Bézier pieces of which the curve consists, in the order of their domains, which meet. Where a curve is
    /// rational in another parameter than its own, as one over a family with sines is, they are pieces in that one: see
    /// [`Chart`](crate::Chart).
    fn pieces(&self) -> Vec<CurvePiece>;

    /// The parts before and after `t`, over domains of their own.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `t` is outside of the domain or NaN, [`CurveError::AtEnd`] at an end of it, where
    /// one part would be a point.
    fn split(&self, t: CurveScalar<Self>) -> Result<[Self::Part; 2], CurveError>
    where
        Self: Sized;

    /// The part over a range of parameters, over a domain of its own; if `range.start > range.end` it runs backwards.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if an end of the range is outside of the domain or NaN, [`CurveError::EmptyRange`] if
    /// both ends are equal.
    fn subsegment(&self, range: Range<CurveScalar<Self>>) -> Result<Self::Part, CurveError>
    where
        Self: Sized;

    /// The same curve in the other direction.
    fn reversed(&self) -> Self::Part
    where
        Self: Sized;

    /// The parameter of the curve that belongs to one of its pieces, inside of the domain.
    #[doc(hidden)]
    fn parameter_of(&self, place: f64) -> CurveScalar<Self> {
        back(self.domain(), place)
    }

    /// The parameter of the pieces that belongs to one of the curve.
    #[doc(hidden)]
    fn place_of(&self, t: CurveScalar<Self>) -> f64 {
        t.to_f64()
    }

    /// The point at the lower end of the domain.
    fn start(&self) -> Self::Point {
        self.eval(self.domain()[0])
    }

    /// The point at the upper end of the domain.
    fn end(&self) -> Self::Point {
        self.eval(self.domain()[1])
    }

    /// The point `C(t)`, if `t` lies in the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `t` is outside of the domain or NaN.
    fn eval_checked(&self, t: CurveScalar<Self>) -> Result<Self::Point, CurveError> {
        inside(self.domain(), t)?;
        Ok(self.eval(t))
    }

    /// The point `C(t)`, or the nearer end of the curve if `t` is outside of the domain; if `t` is NaN so is the point.
    fn eval_clamped(&self, t: CurveScalar<Self>) -> Self::Point {
        self.eval(clamped(self.domain(), t))
    }

    /// The points `out[i] = C(ts[i])`.
    ///
    /// Curves over families and splines are evaluated in vector instructions: [`Curve`](crate::Curve),
    /// [`RationalCurve`](crate::RationalCurve), [`SpannedCurve`](crate::SpannedCurve), and with the feature `bspline`
    /// `BSplineCurve`. The results can differ from [`eval`](Self::eval) by rounding errors.
    ///
    /// # Errors
    /// [`CurveError::Length`] if the slices have different lengths.
    fn eval_into(&self, ts: &[CurveScalar<Self>], out: &mut [Self::Point]) -> Result<(), CurveError> {
        same_length(ts, out)?;
        for (point, &t) in out.iter_mut().zip(ts) {
            *point = self.eval(t);
        }
        Ok(())
    }

    /// The derivatives with respect to `t`, `[C(t), C'(t), C''(t), …]`, as vectors: the first one goes from the origin to
    /// the point, which [`Point::from_vector`] makes of it.
    fn eval_with_derivs<const K: usize>(&self, t: CurveScalar<Self>) -> [CurveVector<Self>; K]
    where
        Self: Sized,
    {
        let mut derivatives = [CurveVector::<Self>::zero(); K];
        self.derivatives_into(t, &mut derivatives);
        derivatives
    }

    /// The derivative of that order with respect to `t`; for order 0 the vector from the origin to the point.
    fn derivative(&self, t: CurveScalar<Self>, order: usize) -> CurveVector<Self> {
        let mut derivatives = alloc::vec![CurveVector::<Self>::zero(); order + 1];
        self.derivatives_into(t, &mut derivatives);
        derivatives[order]
    }

    /// `count` points at equal distances of the parameter, both ends included, exactly; for a count of 1, the start.
    fn samples(&self, count: usize) -> impl ExactSizeIterator<Item = Self::Point> + DoubleEndedIterator
    where
        Self: Sized,
    {
        (0..count).map(move |i| self.eval(sample(self.domain(), i, count)))
    }

    /// [`samples`](Self::samples) that fill a slice.
    fn samples_into(&self, out: &mut [Self::Point]) {
        let count = out.len();
        for (i, out) in out.iter_mut().enumerate() {
            *out = self.eval(sample(self.domain(), i, count));
        }
    }

    /// The unit vector in which the curve goes on at `t`.
    ///
    /// Where the velocity vanishes it is the limit: at a cusp the direction of leaving, at the end of the domain that
    /// of arriving. `None` if the curve is a point there, and if anything is not finite.
    fn tangent(&self, t: CurveScalar<Self>) -> Option<CurveVector<Self>> {
        let mut first = [CurveVector::<Self>::zero(); 2];
        self.derivatives_into(t, &mut first);
        let [lo, hi] = self.domain();
        let [size, speed] = [first[0], first[1].scale(hi - lo)].map(largest_component);
        // Far above the rounding errors the velocity has the direction.
        if speed > CurveScalar::<Self>::EPSILON.sqrt() * (size + self.extent()) {
            return direction(first[1]);
        }
        let heading = local::heading(&self.pieces(), self.place_of(t))?;
        direction(CurveVector::<Self>::from_components(|d| CurveScalar::<Self>::of(heading[d])))
    }

    /// The largest absolute value of a component of a Bézier control point: the size that rounding errors have.
    #[doc(hidden)]
    fn extent(&self) -> CurveScalar<Self> {
        let pieces = self.pieces();
        CurveScalar::<Self>::of(pieces.iter().map(CurvePiece::largest).fold(0.0, f64::max))
    }

    /// The curvature at `t`: `|C' ∧ C''| / |C'|³`; in the plane with a sign, positive where the curve turns to the
    /// left.
    ///
    /// Infinite or NaN where the velocity vanishes.
    fn curvature(&self, t: CurveScalar<Self>) -> CurveScalar<Self> {
        let mut derivatives = [CurveVector::<Self>::zero(); 3];
        self.derivatives_into(t, &mut derivatives);
        curvature(derivatives[1], derivatives[2])
    }

    /// The torsion at `t` of a curve in space: `det(C', C'', C''') / |C' × C''|²`, positive for a right-handed screw.
    ///
    /// Where the curvature vanishes, as everywhere on a straight line, the quotient has no meaning: NaN, infinite, or
    /// rounding errors alone.
    fn torsion(&self, t: CurveScalar<Self>) -> CurveScalar<Self>
    where
        Self::Point: Point3,
    {
        let mut derivatives = [CurveVector::<Self>::zero(); 4];
        self.derivatives_into(t, &mut derivatives);
        torsion(derivatives)
    }

    /// The Frenet frame at `t`: tangent, principal normal and binormal. The normal points to the centre of curvature.
    ///
    /// # Errors
    /// [`CurveError::NoTangent`] where [`tangent`](Self::tangent) is `None`, [`CurveError::NoNormal`] where the
    /// curvature vanishes up to rounding.
    fn frenet_frame(&self, t: CurveScalar<Self>) -> Result<Frame<Self::Point>, CurveError>
    where
        Self::Point: Point3,
    {
        let mut derivatives = [CurveVector::<Self>::zero(); 3];
        self.derivatives_into(t, &mut derivatives);
        let tangent = self.tangent(t).ok_or(CurveError::NoTangent)?;
        let bend = local::bend(&self.pieces(), self.place_of(t));
        frenet(derivatives, tangent, CurveScalar::<Self>::of(bend), t)
    }

    /// `count` frames that do not turn around the curve, at equal distances of the parameter, both ends included. The
    /// first has the given normal, made perpendicular to the tangent, or without one an arbitrary normal. By double
    /// reflection; see [`Curve::rotation_minimizing_frames`](crate::Curve::rotation_minimizing_frames).
    ///
    /// # Errors
    /// [`CurveError::NoTangent`] if the curve is a point, or not finite.
    fn rotation_minimizing_frames(
        &self,
        count: usize,
        normal: Option<CurveVector<Self>>,
    ) -> Result<Vec<Frame<Self::Point>>, CurveError>
    where
        Self::Point: Point3,
    {
        let mut frames = alloc::vec![Frame::empty(); count];
        rotation_minimizing(normal, &mut frames, &|i| {
            let t = sample(self.domain(), i, count);
            Some((self.eval(t), self.tangent(t)?))
        })?;
        Ok(frames)
    }

    /// The arc length `∫ |C'(t)| dt` over the domain; the error is at most `accuracy`.
    ///
    /// The bound of the error is proved, up to rounding: an `accuracy` below about `ε` times the length, also zero or
    /// NaN, asks for what the scalar type can give. Infinite or NaN control points have the length NaN; a length that is no
    /// number of the scalar type is infinite.
    fn arclen(&self, accuracy: CurveScalar<Self>) -> CurveScalar<Self> {
        CurveScalar::<Self>::of(length::length(&self.pieces(), floor(accuracy)))
    }

    /// The parameter `t` for which the curve from its start to `C(t)` has that length; the length up to there differs
    /// from `length` by at most `accuracy`, as in [`arclen`](Self::arclen).
    ///
    /// A `length` below zero gives the start of the domain, one above the length of the curve its end, and NaN gives
    /// NaN.
    fn inv_arclen(&self, length: CurveScalar<Self>, accuracy: CurveScalar<Self>) -> CurveScalar<Self> {
        let found = length::parameters(&self.pieces(), &[length.to_f64()], floor(accuracy));
        self.parameter_of(found[0])
    }

    /// The parameters of `count` points at equal distances along the curve, both ends included; each as in
    /// [`inv_arclen`](Self::inv_arclen).
    fn arclen_parameters(&self, count: usize, accuracy: CurveScalar<Self>) -> Vec<CurveScalar<Self>> {
        let (total, found) = length::equal_distances(&self.pieces(), count, floor(accuracy));
        let mut found: Vec<CurveScalar<Self>> = found.into_iter().map(|t| self.parameter_of(t)).collect();
        if let [first, rest @ ..] = &mut found[..]
            && !total.is_nan()
        {
            *first = self.domain()[0];
            if let Some(last) = rest.last_mut() {
                *last = self.domain()[1];
            }
        }
        found
    }

    /// `count` points at equal distances along the curve, both ends included, exactly: the points at the
    /// [`arclen_parameters`](Self::arclen_parameters).
    fn samples_by_arclen(&self, count: usize, accuracy: CurveScalar<Self>) -> Vec<Self::Point> {
        self.arclen_parameters(count, accuracy).into_iter().map(|t| self.eval(t)).collect()
    }

    /// The corners of a polygon that follows the curve: no point of the one is farther than `tolerance` from the other,
    /// if the curve does not jump. Both ends of the curve are corners, exactly.
    ///
    /// # Errors
    /// [`CurveError::Tolerance`] if the tolerance is not positive and finite, [`CurveError::NotFinite`] if a control
    /// point is infinite or NaN, [`CurveError::TooManyPoints`] if more than 2²⁴ corners would be needed.
    fn flatten(&self, tolerance: CurveScalar<Self>) -> Result<Vec<Self::Point>, CurveError> {
        let corners = flatten::corners(&self.pieces(), tolerance.to_f64())?;
        Ok(corners.into_iter().map(|t| self.eval(self.parameter_of(t))).collect())
    }

    /// The smallest axis-parallel box around the Bézier control points, as its two extreme corners `[min, max]`: cheap,
    /// and never too small but for rounding errors. NaN in a component in which a control point is NaN.
    fn control_box(&self) -> [Self::Point; 2] {
        corners_of(&bounds::control_box(&self.pieces()))
    }

    /// The smallest axis-parallel box around the curve, as its two extreme corners `[min, max]`, up to rounding errors.
    ///
    /// NaN in a component in which a control point is infinite or NaN.
    fn bounding_box(&self) -> [Self::Point; 2] {
        corners_of(&bounds::tight_box(&self.pieces()))
    }

    /// The parameters inside of the domain at which a component has a maximum or minimum, in increasing order.
    ///
    /// A component that is constant up to rounding errors has none. None if a control point is infinite or NaN.
    fn extrema(&self) -> Vec<CurveScalar<Self>> {
        bounds::extrema(&self.pieces()).into_iter().map(|t| self.parameter_of(t)).collect()
    }

    /// The parameters inside of the domain at which a curve in the plane changes from turning left to turning right or
    /// the other way round, in increasing order.
    ///
    /// None on a straight line, and none if a control point is infinite or NaN.
    ///
    /// # Errors
    /// [`CurveError::Dimension`] if the points have not two components.
    fn inflections(&self) -> Result<Vec<CurveScalar<Self>>, CurveError> {
        if Self::Point::DIM != 2 {
            return Err(CurveError::Dimension { expected: 2, found: Self::Point::DIM });
        }
        Ok(bounds::inflections(&self.pieces()).into_iter().map(|t| self.parameter_of(t)).collect())
    }

    /// The point of the curve nearest to `point`, among those with a parameter in the domain.
    ///
    /// It is a global minimum: its distance exceeds [`at_least`](Nearest::at_least), which no point of the curve is
    /// nearer than, by no more than `accuracy`. This bound is proved up to rounding: an `accuracy` below some 64 `ε`
    /// times the greatest distance of a Bézier control point, also zero or NaN, asks for what the scalar type can give.
    /// Where very many points are almost equally near, such as around the centre of a circle, the work ends earlier:
    /// `at_least` says how much is proved. `None` if the point, the curve or the distance is not finite.
    fn nearest(&self, point: Self::Point, accuracy: CurveScalar<Self>) -> Option<Nearest<Self::Point>> {
        let components: Vec<f64> = (0..Self::Point::DIM).map(|d| point.component(d).to_f64()).collect();
        let epsilon = CurveScalar::<Self>::EPSILON.to_f64();
        let (t, bound) = nearest::nearest(&self.pieces(), &components, accuracy.to_f64(), epsilon)?;
        let at = self.parameter_of(t);
        let found = self.eval(at);
        let distance = distance(found, point);
        let at_least = CurveScalar::<Self>::of(bound).min(distance);
        distance.is_finite().then_some(Nearest { at, point: found, distance, at_least })
    }

    /// The first point whose component of that index has that value; `None` if there is none, no such component, or
    /// anything is not finite.
    ///
    /// ```
    /// use basis_runtime::{Bezier, ParametricCurve};
    ///
    /// // `cubic-bezier(0.25, 0.1, 0.25, 1)` of CSS: how far a motion is after 30 % of its time.
    /// let ease = Bezier::from_points([[0.0_f64, 0.0], [0.25, 0.1], [0.25, 1.0], [1.0, 1.0]]);
    /// let [_, progress] = ease.first_where(0, 0.3).unwrap();
    /// assert!((progress - 0.513_3).abs() < 1e-4);
    /// ```
    fn first_where(&self, component: usize, value: CurveScalar<Self>) -> Option<Self::Point> {
        let of = |x: CurveScalar<Self>| {
            Self::Point::from_components(|d| if d == component { x } else { CurveScalar::<Self>::ZERO })
        };
        let found = meeting::of_plane(self, of(value), recast(of(CurveScalar::<Self>::ONE)))?;
        found.first().map(|meeting| meeting.point)
    }

    /// Area, centre of mass and moments of what a closed curve in the plane encloses. An open curve is closed by a
    /// straight line, each contour of a curve that jumps by one of its own.
    ///
    /// Exact for polynomial pieces, and to about the last digits for rational ones, both up to rounding errors. Parts
    /// around which the curve runs clockwise count negative, so that a contour in the other direction is a hole.
    ///
    /// ```
    /// use basis_runtime::{Bezier, ParametricCurve};
    ///
    /// let arch = Bezier::from_points([[1.0_f64, 0.0], [0.0, 2.0], [-1.0, 0.0]]); // y = 1 - x²
    /// let enclosed = arch.enclosed()?;
    /// assert!((enclosed.area - 4.0 / 3.0).abs() < 1e-15);
    /// assert!((enclosed.centroid.unwrap()[1] - 0.4).abs() < 1e-15);
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Dimension`] if the points have not two components, [`CurveError::NotFinite`] if a control point is
    /// infinite or NaN.
    fn enclosed(&self) -> Result<Enclosed<Self::Point>, CurveError> {
        let pieces = in_the_plane::<Self::Point>(self.pieces())?;
        if pieces.iter().all(CurvePiece::is_finite) {
            Ok(enclosed::of(&pieces))
        } else {
            Err(CurveError::NotFinite)
        }
    }

    /// How often the curve, closed as by [`enclosed`](Self::enclosed), goes round a point, anticlockwise; 0 outside.
    /// `None` if the point lies on it up to rounding errors, or anything is not finite.
    ///
    /// ```
    /// use basis_runtime::{ParametricCurve, Path};
    ///
    /// let circle = Path::<[f64; 2]>::circle([0.0, 0.0], 1.0);
    /// assert_eq!(circle.winding([0.5, 0.5])?, Some(1));
    /// assert_eq!(circle.reversed().winding([0.5, 0.5])?, Some(-1));
    /// assert_eq!(circle.winding([0.8, 0.8])?, Some(0));
    /// assert_eq!(circle.winding([0.6, 0.8])?, None);
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Dimension`] if the points have not two components.
    fn winding(&self, point: Self::Point) -> Result<Option<i32>, CurveError> {
        let pieces = in_the_plane::<Self::Point>(self.pieces())?;
        let epsilon = CurveScalar::<Self>::EPSILON.to_f64();
        Ok(enclosed::winding(&pieces, &[0, 1].map(|d| point.component(d).to_f64()), epsilon))
    }

    /// The curves at a distance beside this curve in the plane, to the left of its direction if the distance is positive, one
    /// for each contour: each within the tolerance of the exact one, with arcs around outer corners, cusps where the radius
    /// of curvature is the distance, and not trimmed. Other joins and trimming: [`Offset`](crate::Offset).
    ///
    /// ```
    /// use basis_runtime::{Bezier, ParametricCurve};
    ///
    /// let parabola = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0_f64, 1.0]]); // y = x²
    /// let [beside] = parabola.offset(0.1, 1e-6)?.try_into().unwrap();
    /// let found = beside.nearest([0.0, 0.0], 1e-9).unwrap();
    /// assert!((found.distance - 0.1).abs() <= 1e-6);
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Offset::new`](crate::Offset::new) and [`Offset::of`](crate::Offset::of).
    fn offset(
        &self,
        distance: CurveScalar<Self>,
        tolerance: CurveScalar<Self>,
    ) -> Result<Vec<Path<Self::Point>>, CurveError> {
        Offset::new(distance, tolerance)?.of(self)
    }

    /// The points of this curve and another one that are nearest to each other, with a lower bound of the distance of all
    /// pairs: `distance - at_least` is at most about `accuracy`, or some 64 `ε` times the size of the curves. `None` if a
    /// control point is not finite.
    ///
    /// ```
    /// use basis_runtime::{Bezier, ParametricCurve};
    ///
    /// let parabola = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]); // y = x²
    /// let line = Bezier::from_points([[0.0, -1.0], [2.0_f64, 1.0]]); // y = x - 1
    /// let found = parabola.closest(&line, 1e-9).unwrap();
    /// assert!((found.distance - 0.75 / 2.0_f64.sqrt()).abs() < 1e-9); // from (1/2, 1/4)
    /// assert!(found.distance - found.at_least <= 2e-9);
    /// ```
    fn closest(
        &self,
        other: &dyn ParametricCurve<Point = Self::Point>,
        accuracy: CurveScalar<Self>,
    ) -> Option<Closest<Self::Point>> {
        let epsilon = CurveScalar::<Self>::EPSILON.to_f64();
        let (at, bound) = closest::closest(&self.pieces(), &other.pieces(), floor(accuracy), epsilon)?;
        let at = [self.parameter_of(at[0]), other.parameter_of(at[1])];
        let points = [self.eval(at[0]), other.eval(at[1])];
        let distance = distance(points[0], points[1]);
        distance.is_finite().then(|| Closest::new(at, points, distance, bound))
    }

    /// How smoothly the start of `next`, a curve of any type, continues the end of this one.
    ///
    /// ```
    /// use basis_runtime::{Bezier, ParametricCurve, Path};
    ///
    /// let arch = Path::circle_arc([0.0, 0.0], 1.0, 0.0, std::f64::consts::PI);
    /// let line = Bezier::from_points([[-1.0, 0.0], [-1.0_f64, -2.0]]);
    /// let joint = arch.joint(&line);
    /// assert_eq!(joint.geometric_order(1e-12, 1e-12, 1e-12), Some(1));
    /// assert!((joint.curvature - 1.0).abs() < 1e-12);
    /// ```
    fn joint(&self, next: &dyn ParametricCurve<Point = Self::Point>) -> Joint<CurveScalar<Self>> {
        let (t, s) = (self.domain()[1], next.domain()[0]);
        let [mut end, mut start] = [[CurveVector::<Self>::zero(); 4]; 2];
        self.derivatives_into(t, &mut end);
        next.derivatives_into(s, &mut start);
        Joint::between(end, start, [self.tangent(t), next.tangent(s)])
    }

    /// The curve `next`, moved at its start so that it continues this one with that contact: as many of its control points
    /// as the order of the contact and one more are replaced, the others, weights and knots stay. Both curves may be of
    /// any type.
    ///
    /// ```
    /// use basis_runtime::{Bezier, Contact, ParametricCurve, RationalBezier};
    ///
    /// let half = 0.5_f64.sqrt();
    /// let arc = RationalBezier::new([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [1.0, half, 1.0])?;
    /// let draft = Bezier::from_points([[0.0; 2], [0.0; 2], [0.0; 2], [-3.0, 1.0], [-4.0, 0.0]]);
    /// let next = arc.continued(Contact::Curvature { f: 2.0, c: 0.0 }, &draft)?;
    /// assert_eq!(next.control_points()[3..], [[-3.0, 1.0], [-4.0, 0.0]]);
    /// assert_eq!(arc.joint(&next).geometric_order(1e-12, 1e-12, 1e-12), Some(2));
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Factor`] if `f` is not positive or a factor not finite, [`CurveError::Contact`] if the order is above
    /// the [`highest_contact`](JoinableCurve::highest_contact) of `next`, [`CurveError::NotFinite`] if a computed point
    /// is not finite, [`CurveError::Join`] if the control points do not determine the derivatives.
    fn continued<C>(&self, contact: Contact<CurveScalar<Self>>, next: &C) -> Result<C, CurveError>
    where
        Self: Sized,
        C: JoinableCurve<Point = Self::Point>,
    {
        next.with_start(&touching(self, self.domain()[1], contact, next.highest_contact())?)
    }

    /// The curve `before`, moved at its end so that this one continues it: as [`continued`](Self::continued), with the
    /// contact in which this curve is P and the other one Q.
    ///
    /// # Errors
    /// As [`continued`](Self::continued).
    fn preceded<C>(&self, contact: Contact<CurveScalar<Self>>, before: &C) -> Result<C, CurveError>
    where
        Self: Sized,
        C: JoinableCurve<Point = Self::Point>,
    {
        before.with_end(&touching(self, self.domain()[0], contact, before.highest_contact())?)
    }

    /// All places at which the curve meets another one, in the order of its own parameter.
    ///
    /// None is missed: every pair of parameters at which the curves have a point in common lies in one of the answers,
    /// up to rounding errors; so does an end of one curve that is no farther than `accuracy` from the other one. An
    /// answer is a pair of parameters, or an interval of each curve in which they are nearer to each other than about
    /// `accuracy`, also where they touch or run along each other; in space the curves need not meet exactly to be an
    /// answer. A place at the end of a closed curve is one answer, whose interval runs through the end: from a larger
    /// parameter to a smaller one. An `accuracy` below some 64 `ε` times the size of the curves, also zero or NaN, asks
    /// for what the scalar type can give; curves that run along each other take the longer the smaller it is. Where a
    /// search becomes too long all the same, because the curves are about as near as `accuracy` in many places, the
    /// intervals that are left are contacts or overlaps too, also where the curves are farther than `accuracy` from each
    /// other: [`Meeting::distance`] says how near they are found to be. `None` if a control point is not finite.
    ///
    /// ```
    /// use basis_runtime::{Bezier, MeetingKind, ParametricCurve};
    ///
    /// let parabola = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]); // y = x²
    /// let line = Bezier::from_points([[-1.0_f64, 0.25], [1.0, 0.25]]);
    /// let found = parabola.intersections(&line, 1e-9).unwrap();
    /// assert!(found.iter().all(|meeting| meeting.kind == MeetingKind::Crossing));
    /// let [left, right] = found.try_into().unwrap();
    /// assert!((left.point[0] + 0.5).abs() < 1e-15 && (right.point[0] - 0.5).abs() < 1e-15);
    /// ```
    fn intersections(
        &self,
        other: &dyn ParametricCurve<Point = Self::Point>,
        accuracy: CurveScalar<Self>,
    ) -> Option<Vec<Meeting<Self::Point>>> {
        meeting::of_two(self, other, accuracy)
    }

    /// All places at which the curve meets itself, the smaller parameter first; see
    /// [`intersections`](Self::intersections). That a closed curve ends where it begins is no answer.
    ///
    /// ```
    /// use basis_runtime::{Bezier, ParametricCurve};
    ///
    /// let loop_ = Bezier::from_points([[0.0, 0.0], [3.0, 2.0], [-2.0, 2.0], [1.0, 0.0]]);
    /// let [meeting] = loop_.self_intersections(1e-9).unwrap().try_into().unwrap();
    /// let [s, t] = meeting.at;
    /// assert!((s + t - 1.0_f64).abs() < 1e-9 && meeting.distance < 1e-12);
    /// ```
    fn self_intersections(&self, accuracy: CurveScalar<Self>) -> Option<Vec<Meeting<Self::Point>>> {
        meeting::of_one(self, accuracy)
    }

    /// All places at which a curve in space meets a surface, in the order of its own parameter.
    ///
    /// None is missed: all parameters at which curve and surface have a point in common lie in one of the answers, up to
    /// rounding errors. An answer is a parameter of the curve and two of the surface, or intervals of them between which
    /// both are nearer to each other than about `accuracy`: where they touch, where the curve runs along the surface, and
    /// where it meets a pole, which has many parameters. A point on an edge between patches is one answer; where a surface
    /// is closed, a point of the seam has two pairs of parameters, and each of them is an answer. An `accuracy` below some
    /// 500 `ε` times the size of both, also zero or NaN, asks for what the scalar type can give; a curve that runs along
    /// a surface takes the longer the smaller it is. `None` if a control point is not finite or a weight not positive.
    ///
    /// [`BoundedSurface::ray_intersections`] and [`BoundedSurface::line_intersections`] are for rays and lines.
    ///
    /// ```
    /// use basis_runtime::{Bezier, MeetingKind, ParametricCurve, SurfaceOfRevolution};
    ///
    /// // The cone x² = y² + z², and a parabola through it.
    /// let cone = SurfaceOfRevolution::about_x(&Bezier::from_points([[0.0, 0.0], [2.0, 2.0]]), 6.0)?;
    /// let arch = Bezier::from_points([[1.0, -2.0, 0.0], [1.0, 0.0, 1.0], [1.0, 2.0_f64, 0.0]]);
    /// let found = arch.surface_intersections(&cone, 1e-9).unwrap();
    /// assert_eq!(found.len(), 2);
    /// for meeting in found {
    ///     let [x, y, z] = meeting.point;
    ///     assert!(meeting.kind == MeetingKind::Crossing && (x * x - y * y - z * z).abs() < 1e-12);
    /// }
    /// # Ok::<(), basis_runtime::RevolutionError>(())
    /// ```
    fn surface_intersections(
        &self,
        surface: &dyn BoundedSurface<Point = Self::Point>,
        accuracy: CurveScalar<Self>,
    ) -> Option<Vec<SurfaceMeeting<Self::Point>>>
    where
        Self::Point: Point3,
    {
        surface_meeting::of_curve(self, surface, accuracy)
    }

    /// All places at which the curve meets the plane through `point` with that normal, in the plane the line, in the
    /// order of the parameter: zeros of a polynomial, isolated by changes of sign, so that none is missed. `None` if
    /// the normal is zero or anything is not finite.
    ///
    /// ```
    /// use basis_runtime::{Bezier, MeetingKind, ParametricCurve};
    ///
    /// let parabola = Bezier::from_points([[-1.0, 1.0], [0.0, -1.0], [1.0, 1.0]]); // y = x²
    /// let [touch] = parabola.plane_intersections([0.0, 0.0], [0.0, 1.0]).unwrap().try_into().unwrap();
    /// assert_eq!((touch.kind, touch.interval, touch.point), (MeetingKind::Contact, [0.5; 2], [0.0, 0.0]));
    /// ```
    fn plane_intersections(
        &self,
        point: Self::Point,
        normal: CurveVector<Self>,
    ) -> Option<Vec<PlaneMeeting<Self::Point>>> {
        meeting::of_plane(self, point, normal)
    }
}
