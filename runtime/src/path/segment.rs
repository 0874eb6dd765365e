//! One Bézier segment of a path, polynomial or rational.

use alloc::vec::Vec;

use crate::bernstein;
use crate::numeric::binomial::binomial;
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::{CurveError, CurvePiece, JoinableCurve, Point, RationalBezier, Scalar};

/// A Bézier segment over `0 <= x <= 1`, with the control points `P[i]` and, if it is rational, positive weights `w[i]`:
///
/// ```text
/// C(x) = Σ_i B[i,n](x) w[i] P[i] / Σ_i B[i,n](x) w[i]
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::path::Segment<P>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
pub struct PathSegment<P: Point> {
    /// At least one.
    points: Vec<P>,
    /// One for each point, or none of a polynomial.
    weights: Vec<P::Scalar>,
}

impl<P: Point> PathSegment<P> {
    /// The straight line from one point to another.
    pub fn line(from: P, to: P) -> Self {
        Self { points: alloc::vec![from, to], weights: Vec::new() }
    }

    /// The polynomial segment with these control points.
    ///
    /// # Errors
    /// [`CurveError::Length`] if there is no point.
    pub fn polynomial(points: impl Into<Vec<P>>) -> Result<Self, CurveError> {
        let points = points.into();
        if points.is_empty() {
            return Err(CurveError::Length { expected: 1, found: 0 });
        }
        Ok(Self { points, weights: Vec::new() })
    }

    /// The rational segment with these control points and weights.
    ///
    /// # Errors
    /// [`CurveError::Length`] if there is no point or not one weight for each, [`CurveError::Weight`] if a weight is not
    /// positive and finite.
    pub fn rational(
        points: impl Into<Vec<P>>,
        weights: impl Into<Vec<P::Scalar>>,
    ) -> Result<Self, CurveError> {
        let (points, weights) = (points.into(), weights.into());
        if points.is_empty() || points.len() != weights.len() {
            return Err(CurveError::Length { expected: points.len().max(1), found: weights.len() });
        }
        for (index, &weight) in weights.iter().enumerate() {
            if !(weight > P::Scalar::ZERO && weight.is_finite()) {
                return Err(CurveError::Weight { index, value: weight.to_f64() });
            }
        }
        Ok(Self { points, weights })
    }

    /// Control points and weights that are known to be right.
    pub(super) fn trusted(points: Vec<P>, weights: Vec<P::Scalar>) -> Self {
        debug_assert!(!points.is_empty() && (weights.is_empty() || weights.len() == points.len()));
        Self { points, weights }
    }

    /// A piece of a curve of any type.
    pub(super) fn of_piece(piece: &CurvePiece) -> Self {
        let point = |i: usize| P::from_components(|d| P::Scalar::of(piece.control(i, d)));
        let weights = piece.weights().unwrap_or_default().iter().map(|&w| P::Scalar::of(w));
        Self { points: (0..=piece.degree()).map(point).collect(), weights: weights.collect() }
    }

    pub(super) fn to_piece(&self, domain: [P::Scalar; 2]) -> CurvePiece {
        match CurvePiece::rational(domain, &self.points, &self.weights) {
            Ok(piece) if !self.weights.is_empty() => piece,
            _ => CurvePiece::polynomial(domain, &self.points),
        }
    }

    /// The control points.
    pub fn control_points(&self) -> &[P] {
        &self.points
    }

    /// The weights, one for each control point; `None` if the segment is polynomial.
    pub fn weights(&self) -> Option<&[P::Scalar]> {
        (!self.weights.is_empty()).then_some(&self.weights)
    }

    /// The degree, one less than the number of control points.
    pub fn degree(&self) -> usize {
        self.points.len() - 1
    }

    /// The first control point, where the segment begins.
    pub fn start(&self) -> P {
        self.points[0]
    }

    /// The last control point, where the segment ends.
    pub fn end(&self) -> P {
        self.points[self.points.len() - 1]
    }

    /// The point at `x`, exact at both ends; outside of `0 <= x <= 1` the formula is continued.
    pub fn eval(&self, x: P::Scalar) -> P {
        if x == P::Scalar::ZERO {
            self.start()
        } else if x == P::Scalar::ONE {
            self.end()
        } else if self.weights.is_empty() {
            bernstein::eval(&self.points, x)
        } else {
            let numerator = bernstein::eval(&self.numerators(), x);
            numerator.scale(P::Scalar::ONE / bernstein::eval(&self.weights, x))
        }
    }

    /// The image under an affine map; see [`Path::map`](super::Path::map).
    #[must_use]
    pub fn map<Q: Point<Scalar = P::Scalar>>(&self, map: impl FnMut(P) -> Q) -> PathSegment<Q> {
        PathSegment { points: self.points.iter().copied().map(map).collect(), weights: self.weights.clone() }
    }

    crate::affine::transform!();

    /// The point and its derivatives, from Leibniz' rule for numerator and denominator.
    pub(super) fn derivatives_into(&self, x: P::Scalar, derivatives: &mut [P::Vector]) {
        let numerators: Vec<P::Vector> = self.numerators().into_iter().map(P::to_vector).collect();
        let mut scratch = numerators.clone();
        if self.weights.is_empty() {
            bernstein::eval_with_derivs(&numerators, x, &mut scratch, derivatives);
        } else {
            bernstein::eval_with_derivs(&numerators, x, &mut scratch, derivatives);
            let mut weights = alloc::vec![P::Scalar::ZERO; derivatives.len()];
            bernstein::eval_with_derivs(&self.weights, x, &mut self.weights.clone(), &mut weights);
            for order in 0..derivatives.len() {
                for i in 1..=order {
                    let factor = binomial::<P::Scalar>(order, i) * weights[i];
                    derivatives[order] = derivatives[order].add_weighted(derivatives[order - i], -factor);
                }
                derivatives[order] = derivatives[order].scale(P::Scalar::ONE / weights[0]);
            }
        }
        if let Some(first) = derivatives.first_mut() {
            *first = self.eval(x).to_vector();
        }
    }

    /// The segment with this point and these derivatives at its start; its weights stay.
    pub(super) fn with_start(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        let weights = match self.weights() {
            Some(weights) => weights.to_vec(),
            None => alloc::vec![P::Scalar::ONE; self.points.len()],
        };
        let moved = RationalBezier::new(self.points.clone(), weights)?.with_start(derivatives)?;
        Ok(Self { points: moved.control_points(), weights: self.weights.clone() })
    }

    /// The parts below and above `x`; the end of the one is the start of the other, and the outer ends stay.
    pub(super) fn split(&self, x: P::Scalar) -> [Self; 2] {
        let (mut left, mut right) = (self.numerators(), self.points.clone());
        bernstein::split(&mut left, x, &mut right);
        let (mut left_weights, mut right_weights) = (self.weights.clone(), self.weights.clone());
        bernstein::split(&mut left_weights, x, &mut right_weights);
        let mut parts = [Self::of_numerators(left, left_weights), Self::of_numerators(right, right_weights)];
        parts[0].points[0] = self.start();
        let last = parts[1].points.len() - 1;
        parts[1].points[last] = self.end();
        parts
    }

    /// The part `0 <= from <= x <= to <= 1`.
    pub(super) fn restricted(&self, from: P::Scalar, to: P::Scalar) -> Self {
        let (mut points, mut weights) = (self.numerators(), self.weights.clone());
        bernstein::restrict(&mut points, from, to);
        bernstein::restrict(&mut weights, from, to);
        let mut part = Self::of_numerators(points, weights);
        part.points[0] = self.eval(from);
        let last = part.points.len() - 1;
        part.points[last] = self.eval(to);
        part
    }

    /// The same segment from another start, next to its own.
    pub(super) fn started(&self, start: P) -> Self {
        let mut started = self.clone();
        started.points[0] = start;
        started
    }

    /// The same segment in the other direction.
    pub(super) fn reversed(&self) -> Self {
        let mut reversed = self.clone();
        reversed.points.reverse();
        reversed.weights.reverse();
        reversed
    }

    /// `w[i] P[i]`, or the control points of a polynomial.
    fn numerators(&self) -> Vec<P> {
        if self.weights.is_empty() {
            return self.points.clone();
        }
        self.points.iter().zip(&self.weights).map(|(p, &w)| p.scale(w)).collect()
    }

    fn of_numerators(mut points: Vec<P>, weights: Vec<P::Scalar>) -> Self {
        for (point, &weight) in points.iter_mut().zip(&weights) {
            *point = point.scale(P::Scalar::ONE / weight);
        }
        Self { points, weights }
    }
}
