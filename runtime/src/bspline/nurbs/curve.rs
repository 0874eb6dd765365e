//! Rational B-spline curves.

use alloc::vec::Vec;
use core::ops::Range;

use super::homogeneous::check_weights;
use crate::bspline::{BSplineCurve, BezierPiece, Homogeneous, KnotError, KnotVector, SplineError};
use crate::curve::backwards;
use crate::geometry::{as_points, possible, replace_first};
use crate::numeric::binomial::binomial;
use crate::numeric::leibniz;
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::vector::{largest_component, length};
use crate::{CurveError, CurvePiece, JoinableCurve, ParametricCurve, Point, RationalBezier, Scalar};

/// The rational curve `C(t) = Σ w[i] N[i](t) P[i] / Σ w[i] N[i](t)` with positive weights.
///
/// It is kept as a [`BSplineCurve`] of [`Homogeneous`] points; everything that does not need the point itself is found
/// there ([`homogeneous`](Self::homogeneous)), what changes only the representation is repeated here.
///
/// ```
/// use basis_runtime::bspline::{KnotVector, NurbsCurve};
///
/// // A quarter of the unit circle.
/// let weights = [1.0, 0.5_f64.sqrt(), 1.0];
/// let curve = NurbsCurve::new(KnotVector::uniform(2, 1)?, [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], weights)?;
/// let [x, y] = curve.eval(0.3);
/// assert!((x.hypot(y) - 1.0).abs() < 1e-15);
/// # Ok::<(), basis_runtime::bspline::SplineError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::bspline::RationalCurve<P>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
pub struct NurbsCurve<P: Point> {
    homogeneous: BSplineCurve<Homogeneous<P>>,
}

impl<P: Point> NurbsCurve<P> {
    /// The curve with these control points and weights, one for each basis function.
    ///
    /// # Errors
    /// If there are not as many points and weights as basis functions, or if a weight is not positive and finite.
    pub fn new(
        knots: KnotVector<P::Scalar>,
        points: impl AsRef<[P]>,
        weights: impl AsRef<[P::Scalar]>,
    ) -> Result<Self, SplineError> {
        let (points, weights) = (points.as_ref(), weights.as_ref());
        let (expected, found) = (knots.functions(), points.len());
        if expected != found {
            return Err(SplineError::Count { expected, found });
        }
        check_weights(weights, expected)?;
        let points: Vec<_> = points.iter().zip(weights).map(|(&p, &w)| Homogeneous::new(p, w)).collect();
        Ok(Self { homogeneous: BSplineCurve::trusted(knots, points) })
    }

    /// The curve that this polynomial curve over homogeneous points stands for.
    ///
    /// # Errors
    /// [`SplineError::Weight`] if a weight is not positive and finite.
    pub fn from_homogeneous(homogeneous: BSplineCurve<Homogeneous<P>>) -> Result<Self, SplineError> {
        let weights: Vec<_> = homogeneous.control_points().iter().map(|point| point.weight).collect();
        check_weights(&weights, weights.len())?;
        Ok(Self { homogeneous })
    }

    /// Homogeneous points whose weights are known to be positive.
    pub(super) fn trusted(homogeneous: BSplineCurve<Homogeneous<P>>) -> Self {
        Self { homogeneous }
    }

    /// The image under an affine map: the curve with the images of all control points and the same weights.
    pub fn map<Q: Point<Scalar = P::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> NurbsCurve<Q> {
        let homogeneous = self.homogeneous.map(|p| Homogeneous::new(image(p.project()), p.weight));
        NurbsCurve { homogeneous }
    }

    crate::affine::transform!();

    /// The same curve over homogeneous points.
    #[inline]
    pub fn homogeneous(&self) -> &BSplineCurve<Homogeneous<P>> {
        &self.homogeneous
    }

    /// The degree.
    #[inline]
    pub fn degree(&self) -> usize {
        self.homogeneous.degree()
    }

    /// The knots.
    #[inline]
    pub fn knots(&self) -> &KnotVector<P::Scalar> {
        self.homogeneous.knots()
    }

    /// The control points, without their weights.
    pub fn control_points(&self) -> Vec<P> {
        self.homogeneous.control_points().iter().map(Homogeneous::project).collect()
    }

    /// The weights.
    pub fn weights(&self) -> Vec<P::Scalar> {
        self.homogeneous.control_points().iter().map(|point| point.weight).collect()
    }

    /// The ends of the domain.
    #[inline]
    pub fn domain(&self) -> [P::Scalar; 2] {
        self.homogeneous.domain()
    }

    /// The point `C(t)`.
    #[inline]
    pub fn eval(&self, t: P::Scalar) -> P {
        self.homogeneous.eval(t).project()
    }

    /// The point and its derivatives with respect to `t`, `[C(t), C'(t), C''(t), …]`.
    ///
    /// With the numerator `A` and the denominator `w`, from Leibniz' rule for `A = w C`:
    /// `C⁽ᵏ⁾ = (A⁽ᵏ⁾ - Σ (k over i) w⁽ⁱ⁾ C⁽ᵏ⁻ⁱ⁾) / w`, the sum over `i = 1, …, k`.
    pub fn eval_with_derivs<const K: usize>(&self, t: P::Scalar) -> [P::Vector; K] {
        let parts = self.homogeneous.eval_with_derivs::<K>(t);
        let mut derivatives = [P::Vector::zero(); K];
        quotients(&parts, &mut derivatives);
        derivatives
    }

    /// The same curve over the knots and all of `knots`.
    ///
    /// # Errors
    /// As [`BSplineCurve::insert_knots`].
    pub fn insert_knots(&self, knots: &[P::Scalar]) -> Result<Self, KnotError> {
        Ok(Self { homogeneous: self.homogeneous.insert_knots(knots)? })
    }

    /// The same curve as one of the next degree.
    ///
    /// # Errors
    /// As [`BSplineCurve::elevate`].
    pub fn elevate(&self) -> Result<Self, KnotError> {
        Ok(Self { homogeneous: self.homogeneous.elevate()? })
    }

    /// Removes an inner knot up to `times` times while no point of the curve moves by more than `tolerance`; returns
    /// the curve and how often the knot was removed.
    ///
    /// # Errors
    /// [`KnotError::NoInnerKnot`].
    pub fn remove_knot(
        &self,
        knot: P::Scalar,
        times: usize,
        tolerance: P::Scalar,
    ) -> Result<(Self, usize), KnotError> {
        let within = within(self.homogeneous.control_points(), tolerance);
        let (homogeneous, removed) = self.homogeneous.remove_knot_if(knot, times, within)?;
        // The weights of the curve stay positive, but a control point that is removed may lie beyond them.
        Ok(Self::from_homogeneous(homogeneous).map_or((self.clone(), 0), |curve| (curve, removed)))
    }

    /// The same curve with the middle of each span as a new knot.
    pub fn refined(&self) -> Self {
        Self { homogeneous: self.homogeneous.refined() }
    }

    /// The same curve with knots of multiplicity `k + 1` at both ends of the domain and none outside of it.
    pub fn clamped(&self) -> Self {
        Self { homogeneous: self.homogeneous.clamped() }
    }

    /// Two curves over one clamped knot vector: degrees are raised and knots inserted, no point changes.
    ///
    /// # Errors
    /// As [`BSplineCurve::merged`].
    pub fn merged(&self, other: &Self) -> Result<[Self; 2], KnotError> {
        Ok(self.homogeneous.merged(&other.homogeneous)?.map(|homogeneous| Self { homogeneous }))
    }

    /// The polynomial pieces, one for each span, as rational Bézier curves.
    pub fn to_bezier(&self) -> Vec<BezierPiece<Homogeneous<P>>> {
        self.homogeneous.to_bezier()
    }

    /// The rational Bézier curves of which the curve consists, each over its span.
    pub fn to_rational_bezier(&self) -> Vec<RationalBezier<P>> {
        let curve = |piece: &BezierPiece<Homogeneous<P>>| {
            let numerator: Vec<P> = piece.points.iter().map(|p| p.scaled).collect();
            let weights: Vec<P::Scalar> = piece.points.iter().map(|p| p.weight).collect();
            RationalBezier::of_numerator(piece.domain, &numerator, &weights)
        };
        self.to_bezier().iter().map(curve).collect()
    }
}

/// The derivatives of the quotient from those of numerator and denominator, as many as there are places.
fn quotients<P: Point>(parts: &[Homogeneous<P>], derivatives: &mut [P]) {
    for order in 0..derivatives.len() {
        let mut numerator = parts[order].scaled;
        for i in 1..=order {
            let factor = binomial::<P::Scalar>(order, i) * parts[i].weight;
            numerator = numerator.add_weighted(derivatives[order - i], -factor);
        }
        derivatives[order] = Homogeneous { scaled: numerator, weight: parts[0].weight }.project();
    }
}

impl<P: Point> ParametricCurve for NurbsCurve<P> {
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

    fn derivatives_into(&self, t: P::Scalar, derivatives: &mut [P::Vector]) {
        let mut parts = alloc::vec![Homogeneous::zero(); derivatives.len()];
        self.homogeneous.derivatives_into(t, &mut parts);
        quotients(&parts, derivatives);
    }

    #[inline]
    fn eval_with_derivs<const K: usize>(&self, t: P::Scalar) -> [P::Vector; K] {
        self.eval_with_derivs(t)
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        let piece = |piece: &BezierPiece<Homogeneous<P>>| {
            let of = |d: usize| piece.points.iter().map(move |p| p.component(d).to_f64());
            let numerators = (0..P::DIM).flat_map(of).collect();
            CurvePiece::of_numerators(piece.domain, P::DIM, numerators, of(P::DIM))
        };
        self.to_bezier().iter().map(piece).collect()
    }

    fn split(&self, t: P::Scalar) -> Result<[Self; 2], CurveError> {
        Ok(self.homogeneous.split(t)?.map(|homogeneous| Self { homogeneous }))
    }

    fn subsegment(&self, range: Range<P::Scalar>) -> Result<Self, CurveError> {
        Ok(Self { homogeneous: self.homogeneous.subsegment(range)? })
    }

    fn reversed(&self) -> Self {
        Self { homogeneous: self.homogeneous.reversed() }
    }

    fn extent(&self) -> P::Scalar {
        let points = self.homogeneous.control_points().iter();
        points.fold(P::Scalar::ZERO, |largest, p| largest.max(largest_component(p.project())))
    }
}

/// Whether homogeneous points change so little that no point of the curve or surface moves by more than `tolerance`.
///
/// With the numerators `A = w C` and `A' = w' C'` it is `C' - C = Σ N[i] (ΔA[i] - C' Δw[i]) / w`. The point `C` is in
/// the hull of the control points `P[i]`, whose box has a diagonal `d`, so `|C' - P[i]| <= d + tolerance` as long as
///
/// ```text
/// |ΔA[i] - P[i] Δw[i]| + (d + tolerance) |Δw[i]| <= tolerance · (the smallest weight)
/// ```
///
/// holds for all of them. It does not depend on where the origin lies.
pub(super) fn within<P: Point>(
    points: &[Homogeneous<P>],
    tolerance: P::Scalar,
) -> impl Fn(Homogeneous<P>, Homogeneous<P>) -> bool + use<P> {
    let mut smallest = P::Scalar::INFINITY;
    let (mut lower, mut upper) =
        (points.first().map(Homogeneous::project), points.first().map(Homogeneous::project));
    for point in points {
        if point.weight < smallest {
            smallest = point.weight;
        }
        let place = point.project();
        let extreme = |other: Option<P>, pick: fn(P::Scalar, P::Scalar) -> P::Scalar| {
            other.map(|other| P::from_components(|i| pick(other.component(i), place.component(i))))
        };
        lower = extreme(lower, |a, b| if b < a { b } else { a });
        upper = extreme(upper, |a, b| if b > a { b } else { a });
    }
    let diagonal = match (lower, upper) {
        (Some(lower), Some(upper)) => length(upper.minus(lower)),
        _ => P::Scalar::ZERO,
    };
    move |before, after| {
        let change = after.weight - before.weight;
        let moved = after.scaled.minus(before.scaled).add_scaled(before.project().to_vector(), -change);
        length(moved) + (diagonal + tolerance) * change.abs() <= tolerance * smallest
    }
}

impl<P: Point> From<BSplineCurve<P>> for NurbsCurve<P> {
    /// The same curve, with all weights 1.
    fn from(curve: BSplineCurve<P>) -> Self {
        let points: Vec<_> =
            curve.control_points().iter().map(|&p| Homogeneous::new(p, P::Scalar::ONE)).collect();
        Self { homogeneous: BSplineCurve::trusted(curve.knots().clone(), points) }
    }
}

impl<P: Point> TryFrom<&RationalBezier<P>> for NurbsCurve<P> {
    type Error = SplineError;

    /// The same curve, of one span.
    fn try_from(curve: &RationalBezier<P>) -> Result<Self, SplineError> {
        let [lo, hi] = curve.domain();
        let count = curve.degree() + 1;
        let mut knots = alloc::vec![lo; 2 * count];
        knots[count..].fill(hi);
        let knots = KnotVector::new(curve.degree(), knots)?;
        check_weights(curve.weights(), count)?;
        let parts = curve.numerator().iter().zip(curve.weights());
        let points: Vec<_> = parts.map(|(&scaled, &weight)| Homogeneous { scaled, weight }).collect();
        Ok(Self { homogeneous: BSplineCurve::trusted(knots, points) })
    }
}

impl<P: Point> JoinableCurve for NurbsCurve<P> {
    fn highest_contact(&self) -> usize {
        self.degree()
    }

    /// The knots of the result are clamped.
    fn with_start(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        possible(self, "the spline", derivatives)?;
        let clamped = self.homogeneous.clamped();
        let (knots, points) = (clamped.knots(), clamped.control_points());
        let row = |k: usize| knots.derivatives_on(knots.degree(), knots.domain()[0], k).to_vec();
        let weight = |k: usize| {
            row(k)
                .iter()
                .zip(points)
                .fold(P::Scalar::ZERO, |sum, (&factor, point)| sum + factor * point.weight)
        };
        let weights: Vec<P::Scalar> = (0..derivatives.len()).map(weight).collect();
        let mut scaled: Vec<P> = points.iter().map(|point| point.scaled).collect();
        replace_first(&mut scaled, &leibniz::product(&as_points(derivatives), &weights), row)?;
        let points: Vec<Homogeneous<P>> = scaled
            .into_iter()
            .zip(points)
            .map(|(scaled, point)| Homogeneous { scaled, weight: point.weight })
            .collect();
        Ok(Self::trusted(BSplineCurve::trusted(knots.clone(), points)))
    }

    /// The knots of the result are clamped.
    fn with_end(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        Ok(self.reversed().with_start(&backwards(derivatives))?.reversed())
    }
}
