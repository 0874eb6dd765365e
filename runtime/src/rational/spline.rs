//! Rational Bézier curves one after the other: what curves on several spans and their parts are.

use alloc::vec::Vec;
use core::ops::Range;

use super::{RationalBezier, SpannedBasis, SpannedCurve};
use crate::curve::{divisible, nonempty};
use crate::geometry::clamped;
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::{CurveError, CurvePiece, ParametricCurve, Point, Scalar};

/// Rational Bézier curves, each from where the one before it ends: the curve number `k` over `k <= t <= k + 1`.
///
/// ```
/// use basis_runtime::{ParametricCurve, RationalBezier, RationalSpline};
///
/// let [weight, one] = [0.5_f64.sqrt(), 1.0];
/// let quarter = RationalBezier::new([[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], [one, weight, one])?;
/// let next = RationalBezier::new([[0.0, 1.0], [-1.0, 1.0], [-1.0, 0.0]], [one, weight, one])?;
/// let half = RationalSpline::new([quarter, next])?;
/// assert!((half.arclen(1e-9) - core::f64::consts::PI).abs() < 1e-9);
/// let [x, y] = half.eval(1.5);
/// assert!((x.hypot(y) - 1.0_f64).abs() < 1e-15);
/// # Ok::<(), basis_runtime::CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::rational::bezier::Spline<P>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
pub struct RationalSpline<P: Point> {
    curves: Vec<RationalBezier<P>>,
}

impl<P: Point> RationalSpline<P> {
    /// These curves one after the other, whatever their own domains are. Whether they meet is not checked.
    ///
    /// # Errors
    /// [`CurveError::NoSegments`] if there is no curve.
    pub fn new(curves: impl Into<Vec<RationalBezier<P>>>) -> Result<Self, CurveError> {
        let unit = [P::Scalar::ZERO, P::Scalar::ONE];
        let curves: Vec<_> = curves.into().into_iter().map(|curve| curve.with_domain(unit)).collect();
        if curves.is_empty() { Err(CurveError::NoSegments) } else { Ok(Self { curves }) }
    }

    /// The curves of which it consists, each over `[0, 1]`.
    #[inline]
    pub fn curves(&self) -> &[RationalBezier<P>] {
        &self.curves
    }

    /// The image under an affine map: the images of all control points, with the same weights.
    #[must_use]
    pub fn map<Q: Point<Scalar = P::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> RationalSpline<Q> {
        RationalSpline { curves: self.curves.iter().map(|curve| curve.map(&mut image)).collect() }
    }

    crate::affine::transform!();

    /// The curve at a parameter, and the parameter of that curve.
    fn locate(&self, t: P::Scalar) -> (usize, P::Scalar) {
        let begun = |k: &usize| t >= P::Scalar::from_usize(*k);
        let index = (1..self.curves.len()).take_while(begun).count();
        (index, t - P::Scalar::from_usize(index))
    }

    /// The parts before and after a parameter inside of the domain.
    fn cut(&self, t: P::Scalar) -> Result<[Self; 2], CurveError> {
        let (index, x) = self.locate(t);
        let (mut before, mut after) = (self.curves[..index].to_vec(), self.curves[index..].to_vec());
        if x != P::Scalar::ZERO {
            let [left, right] = self.curves[index].split(x)?;
            before.push(left);
            after[0] = right;
        }
        Ok([Self { curves: before }, Self { curves: after }])
    }
}

impl<P: Point> ParametricCurve for RationalSpline<P> {
    type Point = P;
    type Part = Self;

    #[inline]
    fn domain(&self) -> [P::Scalar; 2] {
        [P::Scalar::ZERO, P::Scalar::from_usize(self.curves.len())]
    }

    fn eval(&self, t: P::Scalar) -> P {
        let (index, x) = self.locate(t);
        self.curves[index].eval(x)
    }

    fn derivatives_into(&self, t: P::Scalar, derivatives: &mut [P::Vector]) {
        let (index, x) = self.locate(t);
        self.curves[index].derivatives_into(x, derivatives);
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        let domain = |k: usize| [k, k + 1].map(P::Scalar::from_usize);
        let curves = self.curves.iter().enumerate();
        curves.flat_map(|(k, curve)| curve.with_domain(domain(k)).pieces()).collect()
    }

    fn split(&self, t: P::Scalar) -> Result<[Self; 2], CurveError> {
        divisible(self.domain(), t)?;
        self.cut(t)
    }

    fn subsegment(&self, range: Range<P::Scalar>) -> Result<Self, CurveError> {
        nonempty(self.domain(), &range)?;
        let (from, to) = (range.start, range.end);
        if from > to {
            return Ok(self.subsegment(to..from)?.reversed());
        }
        let [lo, hi] = self.domain();
        let (index, x) = self.locate(from);
        let (mut part, mut start) = (self.clone(), from);
        if to != hi {
            part = self.cut(to)?[0].clone();
            // Where both ends lie on one curve that is a part now.
            let (last, end) = self.locate(to);
            if last == index && end != P::Scalar::ZERO {
                start = P::Scalar::from_usize(index) + x / end;
            }
        }
        if from == lo { Ok(part) } else { Ok(part.cut(start)?[1].clone()) }
    }

    fn reversed(&self) -> Self {
        Self { curves: self.curves.iter().rev().map(RationalBezier::reversed).collect() }
    }
}

impl<B: SpannedBasis, P: Point<Scalar = B::Scalar>> SpannedCurve<B, P> {
    /// The same curve as rational Bézier curves, one for each span.
    pub fn to_rational_spline(&self) -> RationalSpline<P> {
        let curves = self.spans().iter().map(super::RationalCurve::to_rational_bezier);
        RationalSpline { curves: curves.collect() }
    }

    /// The parameter of the Bézier curves: the index of the span, and the place in it.
    fn place(&self, t: P::Scalar) -> P::Scalar {
        let (index, span) = self.span_at(t);
        P::Scalar::from_usize(index) + span.chart().place(t)
    }
}

impl<B: SpannedBasis, P: Point<Scalar = B::Scalar>> ParametricCurve for SpannedCurve<B, P> {
    type Point = P;
    type Part = RationalSpline<P>;

    #[inline]
    fn domain(&self) -> [P::Scalar; 2] {
        self.domain()
    }

    #[inline]
    fn eval(&self, t: P::Scalar) -> P {
        self.eval(t)
    }

    #[inline]
    fn start(&self) -> P {
        self.start()
    }

    #[inline]
    fn end(&self) -> P {
        self.end()
    }

    fn eval_checked(&self, t: P::Scalar) -> Result<P, CurveError> {
        self.eval_checked(t)
    }

    fn eval_into(&self, ts: &[P::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        self.eval_into(ts, out)
    }

    fn derivatives_into(&self, t: P::Scalar, derivatives: &mut [P::Vector]) {
        self.span_at(t).1.derivatives_into(t, derivatives);
    }

    #[inline]
    fn eval_with_derivs<const K: usize>(&self, t: P::Scalar) -> [P::Vector; K] {
        self.eval_with_derivs(t)
    }

    fn parameter_of(&self, place: f64) -> P::Scalar {
        let spans = self.spans();
        let index = (1..spans.len()).take_while(|k| place >= *k as f64).count();
        let x = P::Scalar::of(place - index as f64);
        clamped(self.domain(), spans[index].chart().parameter(x))
    }

    fn place_of(&self, t: P::Scalar) -> f64 {
        let (index, span) = self.span_at(t);
        index as f64 + span.chart().place(t).to_f64()
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        self.to_rational_spline().pieces()
    }

    fn split(&self, t: P::Scalar) -> Result<[RationalSpline<P>; 2], CurveError> {
        divisible(self.domain(), t)?;
        self.to_rational_spline().split(self.place(t))
    }

    fn subsegment(&self, range: Range<P::Scalar>) -> Result<RationalSpline<P>, CurveError> {
        nonempty(self.domain(), &range)?;
        self.to_rational_spline().subsegment(self.place(range.start)..self.place(range.end))
    }

    fn reversed(&self) -> RationalSpline<P> {
        self.to_rational_spline().reversed()
    }
}
