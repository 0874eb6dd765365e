//! Curves of several segments, of one type or of several.

mod any;
mod image;
mod joined;
mod queried;
mod queries;

use alloc::vec::Vec;
use core::ops::Range;

use crate::curve::{divisible, inside, nonempty};
use crate::domain::{from_unit, unit};
use crate::geometry::clamped;
use crate::{
    Basis, BezierOf, Curve, CurveError, CurveScalar, CurveVector, Joint, ParametricCurve, Point, Scalar,
};

pub use any::AnyCurve;

/// A curve of one or more segments, each with a domain of its own.
///
/// The segments are of one type `C`, which is what keeps points and derivatives as fast as those of a segment: curves of
/// one family with different shape values, splines, arcs. Where that type is [`AnyCurve`], they are of different families
/// and degrees, each evaluated by its own formula. A [`Path`](crate::Path) has segments of different degrees as well: it
/// turns curves of all types into their rational Bézier form.
///
/// Its parameter runs from 0 to the number of segments: segment `k` lies over `k <= u <= k + 1`, where its own
/// parameter runs through its domain. At a whole number the later segment counts, but for the end of the curve.
///
/// ```
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
/// # fn main() -> Result<(), Box<dyn core::error::Error>> {
/// use basis_runtime::{AnyCurve, Basis, Bezier, Contact, Curve, ParametricCurve, PiecewiseCurve};
///
/// // Two curves of one family, with different shape values.
/// let first = Curve::new(QuarticBernstein::new(0.5)?, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
/// let free = [[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [8.0, 1.0]]; // the first three will be replaced
/// let contact = Contact::Curvature { f: 1.0, c: 0.0 };
/// let next = QuarticBernstein::new(0.0)?.curve_after(&first, contact, free)?;
/// let curve = PiecewiseCurve::new(vec![first, next])?;
///
/// assert_eq!(curve.eval(1.0), [4.0, 0.0]);
/// let [joint] = curve.joints().try_into().unwrap();
/// assert_eq!(joint.geometric_order(1e-12, 1e-12, 1e-12), Some(2));
///
/// // Behind them a parabola.
/// let parabola = next.continued(Contact::Tangent { f: 2.0 }, &Bezier::from_points([[0.0; 2], [0.0; 2], [12.0, 0.0]]))?;
/// let mut curve = PiecewiseCurve::new(curve.segments().iter().map(|&segment| AnyCurve::new(segment)).collect())?;
/// curve.push(AnyCurve::new(parabola));
/// assert_eq!(curve.continuity(1e-12, 1e-12, 1e-12), [Some(2), Some(1)]);
/// assert_eq!(curve.eval(2.5), parabola.eval(0.5));
/// assert!(curve.eval_checked(3.5).is_err());
///
/// // At a joint nothing is cut: the segments keep their families.
/// let [_, after] = curve.split(2.0)?;
/// assert_eq!(after.segments()[0].downcast_ref(), Some(&parabola));
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PiecewiseCurve<C: ParametricCurve> {
    /// At least one.
    segments: Vec<C>,
}

impl<C: ParametricCurve> From<C> for PiecewiseCurve<C> {
    fn from(segment: C) -> Self {
        Self { segments: alloc::vec![segment] }
    }
}

impl<C: ParametricCurve> PiecewiseCurve<C> {
    /// The curve of these segments, one after the other. Nothing is asked of how they meet; [`joints`](Self::joints)
    /// says it.
    ///
    /// # Errors
    /// [`CurveError::NoSegments`] if there are none.
    pub fn new(segments: Vec<C>) -> Result<Self, CurveError> {
        if segments.is_empty() { Err(CurveError::NoSegments) } else { Ok(Self { segments }) }
    }

    /// Adds a segment to the end. If it does not begin where the curve ends, the curve jumps there.
    pub fn push(&mut self, segment: C) {
        self.segments.push(segment);
    }

    /// Adds the segments of another curve to the end. If it does not begin where this one ends, the curve jumps there;
    /// `continued` (feature `geometry`) moves it so that it continues this one.
    pub fn append(&mut self, other: &Self)
    where
        C: Clone,
    {
        self.segments.extend_from_slice(&other.segments);
    }

    /// The segments.
    pub fn segments(&self) -> &[C] {
        &self.segments
    }

    /// The two ends `[0, n]` of the domain, with the number `n` of segments.
    pub fn domain(&self) -> [CurveScalar<C>; 2] {
        [CurveScalar::<C>::ZERO, CurveScalar::<C>::from_usize(self.segments.len())]
    }

    /// The segment of a parameter and the parameter of that segment. Parameters outside of the domain belong to the
    /// first and the last segment, which are continued; NaN belongs to the first.
    #[inline]
    pub fn locate(&self, u: CurveScalar<C>) -> (usize, CurveScalar<C>) {
        let last = self.segments.len() - 1;
        let u_f64 = u.to_f64();
        // The cast rounds down, and takes NaN and negative numbers to 0.
        let index = (u_f64 as usize).min(last);
        let x = u - CurveScalar::<C>::from_usize(index);
        (index, from_unit(self.segments[index].domain(), x))
    }

    /// The parameter of this curve that belongs to the parameter `t` of a segment.
    fn global(&self, index: usize, t: CurveScalar<C>) -> CurveScalar<C> {
        let [_, x] = unit(self.segments[index].domain(), t);
        CurveScalar::<C>::from_usize(index) + x
    }

    /// The point at `u`. Parameters outside of the domain continue the first and the last segment; if `u` is NaN so is
    /// the point.
    #[inline]
    pub fn eval(&self, u: CurveScalar<C>) -> C::Point {
        let (index, t) = self.locate(u);
        self.segments[index].eval(t)
    }

    /// The point at `u`, if it lies in the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `u` is outside of the domain or NaN.
    pub fn eval_checked(&self, u: CurveScalar<C>) -> Result<C::Point, CurveError> {
        inside(self.domain(), u)?;
        Ok(self.eval(u))
    }

    /// The point at `u`, or the nearer end of the curve if `u` is outside of the domain; if `u` is NaN so is the point.
    pub fn eval_clamped(&self, u: CurveScalar<C>) -> C::Point {
        self.eval(clamped(self.domain(), u))
    }

    /// The point and its derivatives with respect to `u`; at a joint those of the later segment.
    #[inline]
    pub fn eval_with_derivs<const K: usize>(&self, u: CurveScalar<C>) -> [CurveVector<C>; K] {
        let (index, t) = self.locate(u);
        let mut derivatives = self.segments[index].eval_with_derivs::<K>(t);
        self.in_own_parameter(index, &mut derivatives);
        derivatives
    }

    /// From the derivatives of a segment in its parameter to those in the parameter of this curve.
    #[inline]
    fn in_own_parameter(&self, index: usize, derivatives: &mut [CurveVector<C>]) {
        let [lo, hi] = self.segments[index].domain();
        let mut scale = CurveScalar::<C>::ONE;
        for derivative in derivatives {
            *derivative = derivative.scale(scale);
            scale = scale * (hi - lo);
        }
    }

    /// The start of the first segment.
    pub fn start(&self) -> C::Point {
        self.segments[0].start()
    }

    /// The end of the last segment.
    pub fn end(&self) -> C::Point {
        self.last().end()
    }

    fn last(&self) -> &C {
        &self.segments[self.segments.len() - 1]
    }

    /// How smoothly the segments continue each other, measured at each of the joints: one less than segments.
    /// Derivatives are compared with respect to the parameters of the segments.
    pub fn joints(&self) -> Vec<Joint<CurveScalar<C>>> {
        self.segments.windows(2).map(|pair| pair[0].joint(&pair[1])).collect()
    }

    /// How smoothly the start of the curve continues its end: for closed curves.
    pub fn closing_joint(&self) -> Joint<CurveScalar<C>> {
        self.last().joint(&self.segments[0])
    }

    /// The orders of geometric continuity at the joints; see [`Joint::geometric_order`] for the tolerances.
    pub fn continuity(
        &self,
        gap: CurveScalar<C>,
        angle: CurveScalar<C>,
        curvature: CurveScalar<C>,
    ) -> Vec<Option<usize>> {
        self.joints().iter().map(|joint| joint.geometric_order(gap, angle, curvature)).collect()
    }

    /// The curve in the other direction.
    #[must_use]
    pub fn reversed(&self) -> PiecewiseCurve<C::Part> {
        PiecewiseCurve { segments: self.segments.iter().rev().map(C::reversed).collect() }
    }

    /// The two parts before and after `u`, each over `0 <= u <= n` with its own number of segments. At a joint nothing
    /// is cut; elsewhere the segment of `u` becomes two.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `u` is outside of the domain or NaN, [`CurveError::AtEnd`] at an end of it.
    pub fn split(&self, u: CurveScalar<C>) -> Result<[PiecewiseCurve<C::Part>; 2], CurveError> {
        divisible(self.domain(), u)?;
        let (index, t) = self.locate(u);
        let whole = |segment: &C| {
            let [lo, hi] = segment.domain();
            segment.subsegment(lo..hi)
        };
        let whole = |segments: &[C]| segments.iter().map(whole).collect::<Result<Vec<_>, _>>();
        let (mut before, mut after) = (whole(&self.segments[..index])?, whole(&self.segments[index..])?);
        // So near to a joint that it rounds to the end of a segment is at the joint.
        if let Ok([left, right]) = self.segments[index].split(t) {
            before.push(left);
            after[0] = right;
        } else if t >= self.segments[index].domain()[1] || before.is_empty() {
            before.push(after.remove(0));
        }
        if after.is_empty() {
            return Err(CurveError::AtEnd { parameter: u.to_f64() });
        }
        Ok([PiecewiseCurve { segments: before }, PiecewiseCurve { segments: after }])
    }

    /// The part over a range of parameters, over `0 <= u <= n` with its own number of segments; if `range.start >
    /// range.end` it runs backwards.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if an end of the range is outside of the domain or NaN, [`CurveError::EmptyRange`] if
    /// both ends are equal.
    pub fn subsegment(&self, range: Range<CurveScalar<C>>) -> Result<PiecewiseCurve<C::Part>, CurveError> {
        nonempty(self.domain(), &range)?;
        let backwards = range.start > range.end;
        let range = if backwards { range.end..range.start } else { range };
        let mut segments = Vec::new();
        for (index, segment) in self.segments.iter().enumerate() {
            let [first, last] = [index, index + 1].map(CurveScalar::<C>::from_usize);
            if range.end <= first || range.start >= last {
                continue;
            }
            let [lo, hi] = segment.domain();
            let from = if range.start > first { from_unit([lo, hi], range.start - first) } else { lo };
            let to = if range.end < last { from_unit([lo, hi], range.end - first) } else { hi };
            // A part that rounds to a point is left out.
            if let Ok(part) = segment.subsegment(if backwards { to..from } else { from..to }) {
                segments.push(part);
            }
        }
        if backwards {
            segments.reverse();
        }
        if segments.is_empty() {
            return Err(CurveError::EmptyRange { at: range.start.to_f64() });
        }
        Ok(PiecewiseCurve { segments })
    }
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> PiecewiseCurve<Curve<B, P>> {
    /// The segments as Bézier curves of the same degree.
    #[must_use]
    pub fn to_bezier(&self) -> PiecewiseCurve<BezierOf<B, P>> {
        PiecewiseCurve { segments: self.segments.iter().map(Curve::to_bezier).collect() }
    }
}
