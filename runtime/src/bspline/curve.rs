//! B-spline curves.

use alloc::vec::Vec;

use super::rows::{self, Rows};
use core::ops::Range;

use super::functions::combine;
use super::{KnotError, KnotVector, SplineError, slices};
use crate::curve::{backwards, divisible, inside, nonempty, same_length};
use crate::geometry::{as_points, possible, replace_first};
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::vector::largest_component;
use crate::{CurveError, CurvePiece, JoinableCurve, ParametricCurve, Point, Scalar};

/// The curve `C(t) = Σ N[i,k](t) P[i]` over a knot vector.
///
/// Outside of the domain [`eval`](Self::eval) continues the first and the last polynomial piece; at a knot where the
/// curve or a derivative jumps it takes the piece on the right, at the end of the domain the last piece. If `t` is NaN
/// so is the point.
///
/// ```
/// use basis_runtime::bspline::{BSplineCurve, KnotVector};
///
/// let knots = KnotVector::clamped(2, &[0.0, 1.0, 3.0])?;
/// let curve = BSplineCurve::new(knots, [[0.0_f64, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]])?;
/// assert_eq!(curve.eval(3.0), [4.0, 0.0]);
///
/// let [point, velocity] = curve.eval_with_derivs(0.0);
/// assert_eq!((point, velocity), ([0.0, 0.0], [2.0, 4.0]));
///
/// let finer = curve.insert_knots(&[0.5, 2.0])?;
/// assert_eq!(finer.control_points().len(), 6);
/// assert!((finer.eval(0.7)[0] - curve.eval(0.7)[0]).abs() < 1e-15);
/// # Ok::<(), basis_runtime::bspline::SplineError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::bspline::Curve<P>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
pub struct BSplineCurve<P: Point> {
    knots: KnotVector<P::Scalar>,
    points: Vec<P>,
}

/// One polynomial piece of a curve.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
#[non_exhaustive]
pub struct BezierPiece<P: Point> {
    /// The ends of its span.
    pub domain: [P::Scalar; 2],
    /// Its control points as a Bézier curve, `k + 1` of them.
    pub points: Vec<P>,
}

impl<P: Point> BSplineCurve<P> {
    /// The curve with these control points, one for each basis function.
    ///
    /// # Errors
    /// [`SplineError::Count`] if their number is not that of the basis functions.
    pub fn new(knots: KnotVector<P::Scalar>, points: impl Into<Vec<P>>) -> Result<Self, SplineError> {
        let points = points.into();
        let (expected, found) = (knots.functions(), points.len());
        if expected != found {
            return Err(SplineError::Count { expected, found });
        }
        Ok(Self { knots, points })
    }

    /// The Bézier curve with these control points over `0 <= t <= 1`.
    ///
    /// # Errors
    /// [`SplineError::Count`] if there is no point, [`KnotError::Degree`] if there are too many.
    pub fn from_bezier(points: impl Into<Vec<P>>) -> Result<Self, SplineError> {
        let points = points.into();
        let degree = points.len().checked_sub(1).ok_or(SplineError::Count { expected: 1, found: 0 })?;
        Self::new(KnotVector::uniform(degree, 1)?, points)
    }

    /// The closed curve over [`KnotVector::periodic`] with one control point for each span between the breakpoints; the
    /// first ones are repeated at the end. It is as smooth where it closes as at any other breakpoint.
    ///
    /// ```
    /// use basis_runtime::ParametricCurve;
    /// use basis_runtime::bspline::BSplineCurve;
    ///
    /// let square = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
    /// let curve = BSplineCurve::periodic(3, &[0.0, 1.0, 2.0, 3.0, 4.0], &square)?;
    /// assert_eq!(curve.start(), curve.end());
    /// let [before, after] = [4.0, 0.0].map(|t| curve.eval_with_derivs::<3>(t));
    /// assert_eq!(before, after);
    /// # Ok::<(), basis_runtime::bspline::SplineError>(())
    /// ```
    ///
    /// # Errors
    /// [`SplineError::Count`] if there is not one point for each span, [`SplineError::Knots`] as for
    /// [`KnotVector::periodic`].
    pub fn periodic(degree: usize, breakpoints: &[P::Scalar], points: &[P]) -> Result<Self, SplineError> {
        let knots = KnotVector::periodic(degree, breakpoints)?;
        let expected = breakpoints.len() - 1;
        if points.len() != expected {
            return Err(SplineError::Count { expected, found: points.len() });
        }
        Ok(Self { knots, points: (0..expected + degree).map(|i| points[i % expected]).collect() })
    }

    /// Control points that are known to be as many as the basis functions.
    pub(super) fn trusted(knots: KnotVector<P::Scalar>, points: Vec<P>) -> Self {
        debug_assert_eq!(knots.functions(), points.len());
        Self { knots, points }
    }

    fn from_rows(rows: Rows<P::Scalar, P>) -> Self {
        Self { knots: rows.knots, points: rows.points }
    }

    fn to_rows(&self) -> Rows<P::Scalar, P> {
        Rows { knots: self.knots.clone(), points: self.points.clone(), lanes: 1 }
    }

    /// The image under an affine map: the curve over the same knots with the images of all control points.
    ///
    /// ```
    /// use basis_runtime::bspline::BSplineCurve;
    ///
    /// let arch = BSplineCurve::from_bezier([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]])?;
    /// let moved = arch.map(|[x, y]| [x + 3.0, -y]);
    /// assert_eq!(moved.eval(0.5), [4.0, -1.0]);
    /// # Ok::<(), basis_runtime::bspline::SplineError>(())
    /// ```
    pub fn map<Q: Point<Scalar = P::Scalar>>(&self, image: impl FnMut(P) -> Q) -> BSplineCurve<Q> {
        let points = self.points.iter().copied().map(image).collect();
        BSplineCurve { knots: self.knots.clone(), points }
    }

    crate::affine::transform!();

    /// The degree `k`.
    #[inline]
    pub fn degree(&self) -> usize {
        self.knots.degree()
    }

    /// The knots.
    #[inline]
    pub fn knots(&self) -> &KnotVector<P::Scalar> {
        &self.knots
    }

    /// The control points.
    #[inline]
    pub fn control_points(&self) -> &[P] {
        &self.points
    }

    /// The control points, to be changed in place.
    #[inline]
    pub fn control_points_mut(&mut self) -> &mut [P] {
        &mut self.points
    }

    /// The ends of the domain.
    #[inline]
    pub fn domain(&self) -> [P::Scalar; 2] {
        self.knots.domain()
    }

    /// The point at the lower end of the domain.
    pub fn start(&self) -> P {
        self.eval(self.domain()[0])
    }

    /// The point at the upper end of the domain.
    pub fn end(&self) -> P {
        self.eval(self.domain()[1])
    }

    /// The point `C(t)`.
    ///
    /// Exactly the first and last control point at the ends of a clamped curve.
    #[inline]
    pub fn eval(&self, t: P::Scalar) -> P {
        let span = self.knots.span(t);
        let k = self.degree();
        let points = &self.points[span - k..=span];
        if k == 3 {
            return combine(&self.knots.cubic_values_on(span, t), points);
        }
        combine(&self.knots.values_on(span, t), points)
    }

    /// The point `C(t)`, if `t` lies in the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `t` is outside of the domain or NaN.
    pub fn eval_checked(&self, t: P::Scalar) -> Result<P, CurveError> {
        inside(self.domain(), t)?;
        Ok(self.eval(t))
    }

    /// The point `C(t)`, or the nearer end of the curve if `t` is outside of the domain; if `t` is NaN so is the point.
    pub fn eval_clamped(&self, t: P::Scalar) -> P {
        self.eval(self.knots.clamp(t))
    }

    /// The points `out[i] = C(ts[i])`.
    ///
    /// Fastest for parameters in order: where sixteen or more after each other lie in one span, all of them are evaluated in
    /// vector instructions, and differ from [`eval`](Self::eval) by rounding errors.
    ///
    /// # Errors
    /// [`CurveError::Length`] if the slices have different lengths.
    pub fn eval_into(&self, ts: &[P::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        same_length(ts, out)?;
        slices::eval(&self.knots, &self.points, ts, out);
        Ok(())
    }

    /// The point and its derivatives with respect to `t`, `[C(t), C'(t), C''(t), …]`; zero above the degree.
    #[inline]
    pub fn eval_with_derivs<const K: usize>(&self, t: P::Scalar) -> [P::Vector; K] {
        let span = self.knots.span(t);
        core::array::from_fn(|order| self.derivative_on(span, t, order))
    }

    /// The derivative of that order at `t`; at order 0 the vector from the origin to the point.
    #[inline]
    pub fn derivative(&self, t: P::Scalar, order: usize) -> P::Vector {
        self.derivative_on(self.knots.span(t), t, order)
    }

    fn derivative_on(&self, span: usize, t: P::Scalar, order: usize) -> P::Vector {
        let k = self.degree();
        combine(&self.knots.derivatives_on(span, t, order), &self.points[span - k..=span]).to_vector()
    }

    /// The same curve over the knots and all of `knots`, in any order, repeated ones as often as they are listed.
    ///
    /// # Errors
    /// If a knot is outside of the domain, or would occur more than `degree + 1` times.
    pub fn insert_knots(&self, knots: &[P::Scalar]) -> Result<Self, KnotError> {
        rows::insert_into(&self.knots, &self.points, 1, knots).map(Self::from_rows)
    }

    /// The same curve with the middle of each span as a new knot.
    pub fn refined(&self) -> Self {
        rows::insert(&self.to_rows(), &middles(&self.knots)).map_or_else(|_| self.clone(), Self::from_rows)
    }

    /// Removes an inner knot up to `times` times while no point of the curve moves by more than `tolerance`; returns
    /// the curve and how often the knot was removed. A negative tolerance, or NaN, removes nothing.
    ///
    /// # Errors
    /// [`KnotError::NoInnerKnot`].
    pub fn remove_knot(
        &self,
        knot: P::Scalar,
        times: usize,
        tolerance: P::Scalar,
    ) -> Result<(Self, usize), KnotError> {
        self.remove_knot_if(knot, times, rows::within(tolerance))
    }

    /// As [`remove_knot`](Self::remove_knot), while each control point may become what it then is.
    pub(super) fn remove_knot_if(
        &self,
        knot: P::Scalar,
        times: usize,
        may_become: impl Fn(P, P) -> bool,
    ) -> Result<(Self, usize), KnotError> {
        let (rows, removed) = rows::remove(&self.to_rows(), knot, times, may_become)?;
        Ok((Self::from_rows(rows), removed))
    }

    /// The same curve as one of degree `k + 1`. It is clamped, and each of its knots occurs once more.
    ///
    /// # Errors
    /// [`KnotError::Degree`] above [`MAX_DEGREE`](super::MAX_DEGREE).
    pub fn elevate(&self) -> Result<Self, KnotError> {
        rows::elevate(&self.to_rows()).map(Self::from_rows)
    }

    /// The same curve with knots of multiplicity `k + 1` at both ends of the domain and none outside of it.
    pub fn clamped(&self) -> Self {
        Self::from_rows(rows::clamp(&self.to_rows()))
    }

    /// The parts before and after `t`, each over its part of the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `t` is outside of the domain or NaN, [`CurveError::AtEnd`] at an end of it, where
    /// one part would be a point.
    pub fn split(&self, t: P::Scalar) -> Result<[Self; 2], CurveError> {
        divisible(self.domain(), t)?;
        let at_end = |_| CurveError::AtEnd { parameter: t.to_f64() };
        Ok(rows::split(&self.to_rows(), t).map_err(at_end)?.map(Self::from_rows))
    }

    /// The part over a range of parameters, which is its domain; if `range.start > range.end` it runs backwards, over
    /// the same part of the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if an end of the range is outside of the domain or NaN, [`CurveError::EmptyRange`] if
    /// both ends are equal.
    pub fn subsegment(&self, range: Range<P::Scalar>) -> Result<Self, CurveError> {
        nonempty(self.domain(), &range)?;
        if range.start > range.end {
            return Ok(self.subsegment(range.end..range.start)?.reversed());
        }
        let [lo, hi] = self.domain();
        let head = if range.end < hi { self.split(range.end)?[0].clone() } else { self.clone() };
        if range.start > lo { Ok(head.split(range.start)?[1].clone()) } else { Ok(head) }
    }

    /// The polynomial pieces, one for each span, as Bézier curves.
    pub fn to_bezier(&self) -> Vec<BezierPiece<P>> {
        let pieces = rows::bezier(&self.to_rows()).into_iter();
        pieces.map(|(domain, points)| BezierPiece { domain, points }).collect()
    }

    /// Two curves over one clamped knot vector: degrees are raised and knots inserted, no point changes.
    ///
    /// # Errors
    /// [`KnotError::Domains`] if the domains differ.
    pub fn merged(&self, other: &Self) -> Result<[Self; 2], KnotError> {
        let mut pair = [rows::clamp(&self.to_rows()), rows::clamp(&other.to_rows())];
        rows::missing(&pair[0].knots, &pair[1].knots)?;
        let degree = self.degree().max(other.degree());
        for rows in &mut pair {
            while rows.knots.degree() < degree {
                *rows = rows::elevate(rows)?;
            }
        }
        let [a, b] = pair;
        let finer = rows::insert(&a, &rows::missing(&a.knots, &b.knots)?)?;
        let other = rows::insert(&b, &rows::missing(&b.knots, &a.knots)?)?;
        Ok([finer, other].map(Self::from_rows))
    }

    /// The same curve in the other direction, over the domain of [`KnotVector::reversed`].
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self { knots: self.knots.reversed(), points: self.points.iter().rev().copied().collect() }
    }
}

impl<P: Point> ParametricCurve for BSplineCurve<P> {
    type Point = P;
    type Part = Self;

    #[inline]
    fn domain(&self) -> [P::Scalar; 2] {
        self.domain()
    }

    #[inline]
    fn eval(&self, t: P::Scalar) -> P {
        self.eval(t)
    }

    fn eval_into(&self, ts: &[P::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        self.eval_into(ts, out)
    }

    fn derivatives_into(&self, t: P::Scalar, derivatives: &mut [P::Vector]) {
        let span = self.knots.span(t);
        for (order, derivative) in derivatives.iter_mut().enumerate() {
            *derivative = self.derivative_on(span, t, order);
        }
    }

    #[inline]
    fn eval_with_derivs<const K: usize>(&self, t: P::Scalar) -> [P::Vector; K] {
        self.eval_with_derivs(t)
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        self.to_bezier().iter().map(|piece| CurvePiece::polynomial(piece.domain, &piece.points)).collect()
    }

    fn split(&self, t: P::Scalar) -> Result<[Self; 2], CurveError> {
        self.split(t)
    }

    fn subsegment(&self, range: Range<P::Scalar>) -> Result<Self, CurveError> {
        self.subsegment(range)
    }

    fn reversed(&self) -> Self {
        self.reversed()
    }

    fn extent(&self) -> P::Scalar {
        self.points.iter().fold(P::Scalar::ZERO, |largest, &p| largest.max(largest_component(p)))
    }
}

/// The middle of each span; none where it would coincide with an end of the span.
pub(super) fn middles<S: Scalar>(knots: &KnotVector<S>) -> Vec<S> {
    let all = knots.as_slice();
    let middle = |span: usize| {
        let (lo, hi) = (all[span], all[span + 1]);
        let middle = lo + (hi - lo) * S::of(0.5);
        (middle > lo && middle < hi).then_some(middle)
    };
    knots.spans().filter_map(middle).collect()
}

impl<P: Point> JoinableCurve for BSplineCurve<P> {
    fn highest_contact(&self) -> usize {
        self.degree()
    }

    /// The knots of the result are clamped.
    fn with_start(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        possible(self, "the spline", derivatives)?;
        let mut curve = self.clamped();
        let knots = &curve.knots;
        replace_first(&mut curve.points, &as_points(derivatives), |k| {
            knots.derivatives_on(knots.degree(), knots.domain()[0], k).to_vec()
        })?;
        Ok(curve)
    }

    /// The knots of the result are clamped.
    fn with_end(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        Ok(self.reversed().with_start(&backwards(derivatives))?.reversed())
    }
}
