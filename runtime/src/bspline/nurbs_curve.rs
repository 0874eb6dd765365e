//! Rational B-spline curves.

use alloc::vec::Vec;

use super::homogeneous::{binomial, check_weights};
use super::{BSplineCurve, BezierPiece, Homogeneous, KnotError, KnotVector, SplineError};
use crate::{Point, Scalar};

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

    /// The point `C(t)` for `t` in the domain.
    ///
    /// # Errors
    /// [`KnotError::Outside`], also if `t` is NaN.
    pub fn eval_checked(&self, t: P::Scalar) -> Result<P, KnotError> {
        self.homogeneous.eval_checked(t).map(|point| point.project())
    }

    /// The point and its derivatives with respect to `t`, `[C(t), C'(t), C''(t), …]`.
    ///
    /// With the numerator `A` and the denominator `w`, from Leibniz' rule for `A = w C`:
    /// `C⁽ᵏ⁾ = (A⁽ᵏ⁾ - Σ (k over i) w⁽ⁱ⁾ C⁽ᵏ⁻ⁱ⁾) / w`, the sum over `i = 1, …, k`.
    pub fn eval_with_derivs<const K: usize>(&self, t: P::Scalar) -> [P; K] {
        let parts = self.homogeneous.eval_with_derivs::<K>(t);
        let mut derivatives = [P::zero(); K];
        for order in 0..K {
            let mut numerator = parts[order].scaled;
            for i in 1..=order {
                let factor = binomial::<P::Scalar>(order, i) * parts[i].weight;
                numerator = numerator.add_scaled(derivatives[order - i], -factor);
            }
            derivatives[order] = Homogeneous { scaled: numerator, weight: parts[0].weight }.project();
        }
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

    /// The parts below and above `t`.
    ///
    /// # Errors
    /// As [`BSplineCurve::split`].
    pub fn split(&self, t: P::Scalar) -> Result<[Self; 2], KnotError> {
        Ok(self.homogeneous.split(t)?.map(|homogeneous| Self { homogeneous }))
    }

    /// Removes an inner knot up to `times` times while no point of the curve moves by more than `tolerance`; returns the
    /// curve and how often the knot was removed.
    ///
    /// A homogeneous tolerance of `tolerance · w / (1 + m + tolerance)`, where `w` is the smallest weight and `m` the largest distance
    /// of a control point from the origin, guarantees that.
    ///
    /// # Errors
    /// [`KnotError::NoInnerKnot`].
    pub fn remove_knot(
        &self,
        knot: P::Scalar,
        times: usize,
        tolerance: P::Scalar,
    ) -> Result<(Self, usize), KnotError> {
        let tolerance = homogeneous_tolerance(self.homogeneous.control_points(), tolerance);
        let (homogeneous, removed) = self.homogeneous.remove_knot(knot, times, tolerance)?;
        // The bound keeps every weight positive unless the tolerance is as large as the curve.
        Ok(Self::from_homogeneous(homogeneous).map_or((self.clone(), 0), |curve| (curve, removed)))
    }

    /// The polynomial pieces, one for each span, as rational Bézier curves.
    pub fn to_bezier(&self) -> Vec<BezierPiece<Homogeneous<P>>> {
        self.homogeneous.to_bezier()
    }
}

/// How much homogeneous points may move so that no point of the curve moves by more than `tolerance`.
///
/// From `A/w - A'/w' = ((A - A') - C' (w - w')) / w`, where `C'` is at most `tolerance` outside of the hull of the control
/// points: `|C'| <= m + tolerance`.
pub(super) fn homogeneous_tolerance<P: Point>(points: &[Homogeneous<P>], tolerance: P::Scalar) -> P::Scalar {
    let (mut smallest, mut largest) = (None, P::Scalar::ZERO);
    for point in points {
        if smallest.is_none_or(|weight| point.weight < weight) {
            smallest = Some(point.weight);
        }
        let distance = crate::vector::length(point.project());
        if distance > largest {
            largest = distance;
        }
    }
    let smallest = smallest.unwrap_or(P::Scalar::ONE);
    tolerance * smallest / (P::Scalar::ONE + largest + tolerance)
}

impl<P: Point> From<BSplineCurve<P>> for NurbsCurve<P> {
    /// The same curve, with all weights 1.
    fn from(curve: BSplineCurve<P>) -> Self {
        let points: Vec<_> =
            curve.control_points().iter().map(|&p| Homogeneous::new(p, P::Scalar::ONE)).collect();
        Self { homogeneous: BSplineCurve::trusted(curve.knots().clone(), points) }
    }
}
