//! Rational Bézier curves of any degree.

use alloc::vec::Vec;
use core::ops::Range;

use super::series::{derivative, derivatives_into};
use super::{Chart, RationalBasis, RationalCurve};
use crate::bernstein;
use crate::curve::{divisible, nonempty};
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::{CurveError, CurvePiece, ParametricCurve, Point, Scalar};

/// How often a piece is halved until all of its weights are positive.
const HALVINGS: u32 = 12;

/// The rational Bézier curve of degree `n`
///
/// ```text
/// C(t) = Σ_j B[j](x) w[j] P[j] / Σ_j B[j](x) w[j],   B[j](x) = binomial(n, j) (1-x)^(n-j) x^j,   x = (t - lo)/(hi - lo)
/// ```
///
/// What a [`RationalCurve`] is in its Bézier form, and what its parts are. It is kept as the Bernstein coefficients of
/// numerator and denominator. The weights of a part of a curve need not be positive, only the denominator is: a control
/// point may then lie anywhere, and is infinite where its weight is zero.
///
/// ```
/// use basis_runtime::{ParametricCurve, RationalBezier};
///
/// let quarter = RationalBezier::new(vec![[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], vec![1.0, 0.5_f64.sqrt(), 1.0])?;
/// assert!((quarter.arclen(1e-9) - core::f64::consts::FRAC_PI_2).abs() < 1e-9);
/// let [before, after] = quarter.split(0.5)?;
/// assert!((before.arclen(1e-9) - after.arclen(1e-9)).abs() < 1e-9);
/// # Ok::<(), basis_runtime::CurveError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::rational::bezier::Bezier<P>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
pub struct RationalBezier<P: Point> {
    domain: [P::Scalar; 2],
    numerator: Vec<P>,
    weights: Vec<P::Scalar>,
}

impl<P: Point> RationalBezier<P> {
    /// The curve with these control points and weights, one for each point, on `0 <= t <= 1`.
    ///
    /// # Errors
    /// [`CurveError::Length`] if there is not one weight for each point, or no point; [`CurveError::Weight`] if a weight
    /// is not positive and finite.
    pub fn new(points: impl AsRef<[P]>, weights: impl Into<Vec<P::Scalar>>) -> Result<Self, CurveError> {
        let (points, weights) = (points.as_ref(), weights.into());
        if points.len() != weights.len() || points.is_empty() {
            return Err(CurveError::Length { expected: points.len().max(1), found: weights.len() });
        }
        for (index, &weight) in weights.iter().enumerate() {
            if !(weight > P::Scalar::ZERO && weight.is_finite()) {
                return Err(CurveError::Weight { index, value: weight.to_f64() });
            }
        }
        let numerator = points.iter().zip(&weights).map(|(p, &w)| p.scale(w)).collect();
        Ok(Self { domain: [P::Scalar::ZERO, P::Scalar::ONE], numerator, weights })
    }

    /// From the Bernstein coefficients of numerator and denominator, as many of the one as of the other; a denominator
    /// that is negative at its start is turned, with the numerator.
    pub(crate) fn of_numerator(domain: [P::Scalar; 2], numerator: &[P], weights: &[P::Scalar]) -> Self {
        let mut curve = Self { domain, numerator: numerator.to_vec(), weights: weights.to_vec() };
        if curve.weights.first().is_some_and(|&w| w < P::Scalar::ZERO) {
            let turned = -P::Scalar::ONE;
            curve.weights.iter_mut().for_each(|w| *w = *w * turned);
            curve.numerator.iter_mut().for_each(|p| *p = p.scale(turned));
        }
        curve
    }

    /// The degree, one less than the number of control points.
    #[inline]
    pub fn degree(&self) -> usize {
        self.weights.len().saturating_sub(1)
    }

    /// The control points.
    pub fn control_points(&self) -> Vec<P> {
        let point = |(p, &w): (&P, &P::Scalar)| P::from_components(|d| p.component(d) / w);
        self.numerator.iter().zip(&self.weights).map(point).collect()
    }

    /// The image under an affine map, with the same weights; control points at infinity go to infinity in the image of
    /// their direction.
    #[must_use]
    pub fn map<Q: Point<Scalar = P::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> RationalBezier<Q> {
        // With f(x) = A x + b the numerator A N + w b is f(N) + (w - 1) f(0).
        let origin = image(P::zero());
        let all = self.numerator.iter().zip(&self.weights);
        let numerator = all.map(|(&n, &w)| image(n).add_weighted(origin, w - P::Scalar::ONE)).collect();
        RationalBezier { domain: self.domain, numerator, weights: self.weights.clone() }
    }

    crate::affine::transform!();

    /// The weights.
    #[inline]
    pub fn weights(&self) -> &[P::Scalar] {
        &self.weights
    }

    /// The control points times their weights: the Bernstein coefficients of the numerator.
    #[inline]
    pub fn numerator(&self) -> &[P] {
        &self.numerator
    }

    /// The same curve with the degree raised to `degree`; a curve of a higher degree stays as it is.
    #[must_use]
    pub fn elevate(&self, degree: usize) -> Self {
        let len = degree.max(self.degree()) + 1;
        let mut numerator = alloc::vec![P::zero(); len];
        let mut weights = alloc::vec![P::Scalar::ZERO; len];
        bernstein::elevate(&self.numerator, &mut numerator);
        bernstein::elevate(&self.weights, &mut weights);
        Self { domain: self.domain, numerator, weights }
    }

    /// The same curve over another domain `[lo, hi]`, `lo < hi`.
    #[must_use]
    pub fn with_domain(&self, domain: [P::Scalar; 2]) -> Self {
        Self { domain, ..self.clone() }
    }

    #[inline]
    fn chart(&self) -> Chart<P::Scalar> {
        Chart::affine(self.domain)
    }

    /// Every list of coefficients changed, the domain replaced by `[0, 1]`.
    fn changed(&self, points: impl Fn(&mut [P]), weights: impl Fn(&mut [P::Scalar])) -> Self {
        let mut part = self.with_domain([P::Scalar::ZERO, P::Scalar::ONE]);
        points(&mut part.numerator);
        weights(&mut part.weights);
        part
    }
}

impl<P: Point> ParametricCurve for RationalBezier<P> {
    type Point = P;
    type Part = Self;

    #[inline]
    fn domain(&self) -> [P::Scalar; 2] {
        self.domain
    }

    fn eval(&self, t: P::Scalar) -> P {
        let [_, x] = self.chart().coordinates(t);
        let weight = bernstein::eval(&self.weights, x);
        let point = bernstein::eval(&self.numerator, x);
        P::from_components(|d| point.component(d) / weight)
    }

    fn derivatives_into(&self, t: P::Scalar, derivatives: &mut [P::Vector]) {
        let mut numerator: Vec<P::Vector> = self.numerator.iter().map(|p| p.to_vector()).collect();
        derivatives_into(&mut numerator, &mut self.weights.clone(), &self.chart(), t, derivatives);
    }

    fn derivative(&self, t: P::Scalar, order: usize) -> P::Vector {
        let mut numerator: Vec<P::Vector> = self.numerator.iter().map(|p| p.to_vector()).collect();
        derivative(&mut numerator, &mut self.weights.clone(), &self.chart(), t, order)
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        let of = |d: usize| self.numerator.iter().map(move |p| p.component(d).to_f64());
        let numerators = (0..P::DIM).flat_map(of).collect();
        let weights = self.weights.iter().map(|w| w.to_f64());
        let whole = CurvePiece::of_numerators(self.domain, P::DIM, numerators, weights);
        let mut pieces = Vec::new();
        halved(whole, HALVINGS, &mut pieces);
        if !pieces.iter().all(is_positive) {
            // Without positive weights nothing bounds the curve: as if a point of it were not finite.
            let nothing = alloc::vec![f64::NAN; P::DIM * self.weights.len()];
            let weights = self.weights.iter().map(|_| f64::NAN);
            return alloc::vec![CurvePiece::of_numerators(self.domain, P::DIM, nothing, weights)];
        }
        pieces
    }

    fn split(&self, t: P::Scalar) -> Result<[Self; 2], CurveError> {
        divisible(self.domain, t)?;
        let [_, x] = self.chart().coordinates(t);
        let left = self.changed(|points| bernstein::keep_left(points, x), |w| bernstein::keep_left(w, x));
        let right = self.changed(|points| bernstein::keep_right(points, x), |w| bernstein::keep_right(w, x));
        Ok([left, right])
    }

    fn subsegment(&self, range: Range<P::Scalar>) -> Result<Self, CurveError> {
        nonempty(self.domain, &range)?;
        let [from, to] = [range.start, range.end].map(|t| self.chart().coordinates(t)[1]);
        Ok(self.changed(
            |points| bernstein::restrict(points, from, to),
            |weights| bernstein::restrict(weights, from, to),
        ))
    }

    fn reversed(&self) -> Self {
        self.changed(<[P]>::reverse, <[P::Scalar]>::reverse)
    }
}

/// Whether all weights are positive.
fn is_positive(piece: &CurvePiece) -> bool {
    piece.weights().is_none_or(|weights| weights.iter().all(|&w| w > 0.0))
}

/// The piece, or its halves and their halves, until all weights are positive, or nothing is left of `halvings`.
fn halved(piece: CurvePiece, halvings: u32, pieces: &mut Vec<CurvePiece>) {
    // What is not finite does not become better.
    if is_positive(&piece) || halvings == 0 || !piece.is_finite() {
        pieces.push(piece);
        return;
    }
    for half in piece.split(0.5) {
        halved(half, halvings - 1, pieces);
    }
}

impl<B: RationalBasis, P: Point<Scalar = B::Scalar>> RationalCurve<B, P> {
    /// The same curve as a rational Bézier curve of the same degree on `0 <= x <= 1`, `x` the place of `t` in the
    /// [`chart`](Self::chart).
    pub fn to_rational_bezier(&self) -> RationalBezier<P> {
        let (numerator, weights) = (self.to_bernstein(), self.basis().denominator());
        let domain = [P::Scalar::ZERO, P::Scalar::ONE];
        RationalBezier::of_numerator(domain, numerator.as_ref(), weights.as_ref())
    }
}
