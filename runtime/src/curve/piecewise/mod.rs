//! Curves of several segments.

mod queries;

use alloc::vec::Vec;

use core::ops::Range;

use super::{divisible, inside, nonempty};
use crate::{Basis, BernsteinOf, Curve, CurveError, Joint, Point, Scalar};

/// A curve of one or more segments of the family `B`, each with its own shape values.
///
/// One type for all segments is what keeps points and derivatives as fast as those of a [`Curve`]. Segments of different
/// families and degrees, and splines, make a `Path` (feature `geometry`), which answers the same questions:
/// `Path::from_curve(&first)`, then `append(&second)`.
///
/// Its parameter runs from 0 to the number of segments: segment `k` lies over `k <= u <= k + 1`, where its own
/// parameter runs through its domain. At a whole number the later segment counts, but for the end of the curve.
///
/// ```
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
/// # fn main() -> Result<(), Box<dyn core::error::Error>> {
/// use basis_runtime::{Basis, Contact, Curve, PiecewiseCurve};
///
/// let first = Curve::new(QuarticBernstein::new(0.5)?, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
/// let free = [[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [8.0, 1.0]]; // the first three will be replaced
/// let contact = Contact::Curvature { f: 1.0, c: 0.0 };
/// let next = QuarticBernstein::new(0.0)?.curve_after(&first, contact, free)?;
/// let curve = PiecewiseCurve::new(vec![first, next])?;
///
/// assert_eq!(curve.eval(1.0), [4.0, 0.0]);
/// let [joint] = curve.joints().try_into().unwrap();
/// assert_eq!(joint.geometric_order(1e-12, 1e-12, 1e-12), Some(2));
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PiecewiseCurve<B: Basis, P: Point<Scalar = B::Scalar>> {
    /// At least one.
    segments: Vec<Curve<B, P>>,
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> From<Curve<B, P>> for PiecewiseCurve<B, P> {
    fn from(segment: Curve<B, P>) -> Self {
        Self { segments: alloc::vec![segment] }
    }
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> PiecewiseCurve<B, P> {
    /// The curve of these segments, one after the other. Nothing is asked of how they meet; [`joints`](Self::joints)
    /// says it.
    ///
    /// # Errors
    /// [`CurveError::NoSegments`] if there are none.
    pub fn new(segments: Vec<Curve<B, P>>) -> Result<Self, CurveError> {
        if segments.is_empty() { Err(CurveError::NoSegments) } else { Ok(Self { segments }) }
    }

    /// Adds a segment to the end. If it does not begin where the curve ends, the curve jumps there.
    pub fn push(&mut self, segment: Curve<B, P>) {
        self.segments.push(segment);
    }

    /// Adds the segments of another curve to the end. If it does not begin where this one ends, the curve jumps there;
    /// `continued` (feature `geometry`) moves it so that it continues this one.
    pub fn append(&mut self, other: &Self) {
        self.segments.extend_from_slice(&other.segments);
    }

    /// The segments.
    pub fn segments(&self) -> &[Curve<B, P>] {
        &self.segments
    }

    /// The two ends `[0, n]` of the domain, with the number `n` of segments.
    pub fn domain(&self) -> [B::Scalar; 2] {
        [B::Scalar::ZERO, B::Scalar::from_usize(self.segments.len())]
    }

    /// The segment of a parameter and the parameter of that segment. Parameters outside of the domain belong to the
    /// first and the last segment, which are continued; NaN belongs to the first.
    pub fn locate(&self, u: B::Scalar) -> (usize, B::Scalar) {
        let last = self.segments.len() - 1;
        let u_f64 = u.to_f64();
        // The cast rounds down, and takes NaN and negative numbers to 0.
        let index = (u_f64 as usize).min(last);
        let [lo, hi] = B::domain();
        let x = u - B::Scalar::from_usize(index);
        (index, lo * (B::Scalar::ONE - x) + hi * x)
    }

    /// The parameter of this curve that belongs to the parameter `t` of a segment.
    pub(crate) fn global(index: usize, t: B::Scalar) -> B::Scalar {
        let [_, x] = crate::domain::unit(B::domain(), t);
        B::Scalar::from_usize(index) + x
    }

    /// The point at `u`. Parameters outside of the domain continue the first and the last segment; if `u` is NaN so is
    /// the point.
    pub fn eval(&self, u: B::Scalar) -> P {
        let (index, t) = self.locate(u);
        self.segments[index].eval(t)
    }

    /// The point at `u`, if it lies in the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `u` is outside of the domain or NaN.
    pub fn eval_checked(&self, u: B::Scalar) -> Result<P, CurveError> {
        inside(self.domain(), u)?;
        Ok(self.eval(u))
    }

    /// The point at `u`, or the nearer end of the curve if `u` is outside of the domain; if `u` is NaN so is the point.
    pub fn eval_clamped(&self, u: B::Scalar) -> P {
        let [lo, hi] = self.domain();
        self.eval(if u < lo {
            lo
        } else if u > hi {
            hi
        } else {
            u
        })
    }

    /// The point and its derivatives with respect to `u`; at a joint those of the later segment.
    pub fn eval_with_derivs<const K: usize>(&self, u: B::Scalar) -> [P; K] {
        let (index, t) = self.locate(u);
        let mut derivatives = self.segments[index].eval_with_derivs::<K>(t);
        let [lo, hi] = B::domain();
        let mut scale = B::Scalar::ONE;
        for derivative in &mut derivatives {
            *derivative = derivative.scale(scale);
            scale = scale * (hi - lo);
        }
        derivatives
    }

    /// The start of the first segment.
    pub fn start(&self) -> P {
        self.segments[0].start()
    }

    /// The end of the last segment.
    pub fn end(&self) -> P {
        self.last().end()
    }

    fn last(&self) -> &Curve<B, P> {
        &self.segments[self.segments.len() - 1]
    }

    /// How smoothly the segments continue each other, measured at each of the joints: one less than segments.
    pub fn joints(&self) -> Vec<Joint<B::Scalar>> {
        self.segments.windows(2).map(|pair| pair[0].joint(&pair[1])).collect()
    }

    /// How smoothly the start of the curve continues its end: for closed curves.
    pub fn closing_joint(&self) -> Joint<B::Scalar> {
        self.last().joint(&self.segments[0])
    }

    /// The orders of geometric continuity at the joints; see [`Joint::geometric_order`] for the tolerances.
    pub fn continuity(&self, gap: B::Scalar, angle: B::Scalar, curvature: B::Scalar) -> Vec<Option<usize>> {
        self.joints().iter().map(|joint| joint.geometric_order(gap, angle, curvature)).collect()
    }

    /// The curve over the images of all control points; see [`Curve::map`].
    #[must_use]
    pub fn map<Q: Point<Scalar = B::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> PiecewiseCurve<B, Q> {
        PiecewiseCurve { segments: self.segments.iter().map(|segment| segment.map(&mut image)).collect() }
    }

    crate::affine::transform!();

    /// The segments as Bézier curves of the same degree.
    #[must_use]
    pub fn to_bezier(&self) -> PiecewiseCurve<BernsteinOf<B>, P> {
        PiecewiseCurve { segments: self.segments.iter().map(Curve::to_bezier).collect() }
    }

    /// The curve in the other direction.
    #[must_use]
    pub fn reversed(&self) -> PiecewiseCurve<BernsteinOf<B>, P> {
        PiecewiseCurve { segments: self.segments.iter().rev().map(Curve::reversed).collect() }
    }

    /// The two parts before and after `u`, each over `0 <= u <= n` with its own number of segments. At a joint nothing
    /// is cut; elsewhere the segment of `u` becomes two.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `u` is outside of the domain or NaN, [`CurveError::AtEnd`] at an end of it.
    pub fn split(&self, u: B::Scalar) -> Result<[PiecewiseCurve<BernsteinOf<B>, P>; 2], CurveError> {
        divisible(self.domain(), u)?;
        let (index, t) = self.locate(u);
        let bezier = |segments: &[Curve<B, P>]| segments.iter().map(Curve::to_bezier).collect::<Vec<_>>();
        let (mut before, mut after) = (bezier(&self.segments[..index]), bezier(&self.segments[index..]));
        // So near to a joint that it rounds to the end of a segment is at the joint.
        if let Ok([left, right]) = self.segments[index].split(t) {
            before.push(left);
            after[0] = right;
        } else if t >= B::domain()[1] || before.is_empty() {
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
    pub fn subsegment(
        &self,
        range: Range<B::Scalar>,
    ) -> Result<PiecewiseCurve<BernsteinOf<B>, P>, CurveError> {
        nonempty(self.domain(), &range)?;
        let backwards = range.start > range.end;
        let range = if backwards { range.end..range.start } else { range };
        let [lo, hi] = B::domain();
        let mut segments = Vec::new();
        for (index, segment) in self.segments.iter().enumerate() {
            let [first, last] = [index, index + 1].map(B::Scalar::from_usize);
            if range.end <= first || range.start >= last {
                continue;
            }
            let at = |u: B::Scalar| lo * (B::Scalar::ONE - (u - first)) + hi * (u - first);
            let from = if range.start > first { at(range.start) } else { lo };
            let to = if range.end < last { at(range.end) } else { hi };
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
