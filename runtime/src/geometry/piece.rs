//! A rational Bézier curve in double precision, over a part of the domain of a curve.

use alloc::vec;
use alloc::vec::Vec;

use super::coefficients::Coefficients;
use crate::bernstein;
use crate::{CurveError, Point, Scalar};

/// One rational Bézier piece of a curve, in double precision: what [`ParametricCurve`](crate::ParametricCurve) asks of
/// a type of curves besides points and derivatives.
///
/// ```text
/// C(t) = Σ_i B[i,n](x) w[i] P[i] / Σ_i B[i,n](x) w[i],   x = (t - lo) / (hi - lo)
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePiece {
    domain: [f64; 2],
    /// The number of components of a point.
    dim: usize,
    /// The number of control points.
    len: usize,
    /// The Bernstein coefficients of each component of the numerator, one component after the other; the weights follow
    /// if there are any.
    coefficients: Coefficients,
}

impl CurvePiece {
    /// The polynomial piece over `domain` with these Bézier control points.
    #[inline]
    pub fn polynomial<P: Point>(domain: [P::Scalar; 2], points: &[P]) -> Self {
        let len = points.len();
        let mut coefficients = Coefficients::with_capacity(len * P::DIM);
        for d in 0..P::DIM {
            coefficients.extend(points.iter().map(|p| p.component(d).to_f64()));
        }
        Self { domain: domain.map(Scalar::to_f64), dim: P::DIM, len, coefficients }
    }

    /// The rational piece over `domain` with these Bézier control points and weights.
    ///
    /// # Errors
    /// [`CurveError::Length`] if there is not one weight for each point, [`CurveError::Weight`] if a weight is not
    /// positive and finite.
    #[inline]
    pub fn rational<P: Point>(
        domain: [P::Scalar; 2],
        points: &[P],
        weights: &[P::Scalar],
    ) -> Result<Self, CurveError> {
        if points.len() != weights.len() {
            return Err(CurveError::Length { expected: points.len(), found: weights.len() });
        }
        for (index, &weight) in weights.iter().enumerate() {
            if !(weight > P::Scalar::ZERO && weight.is_finite()) {
                return Err(CurveError::Weight { index, value: weight.to_f64() });
            }
        }
        let weight = |i: usize| weights[i].to_f64();
        let numerators: Vec<f64> = (0..P::DIM)
            .flat_map(|d| points.iter().enumerate().map(move |(i, p)| p.component(d).to_f64() * weight(i)))
            .collect();
        Ok(Self::of_numerators(domain, P::DIM, numerators, weights.iter().map(|w| w.to_f64())))
    }

    /// From coefficients of the numerators, one component after the other, and the weights.
    #[inline]
    pub(crate) fn of_numerators<S: Scalar>(
        domain: [S; 2],
        dim: usize,
        numerators: Vec<f64>,
        weights: impl Iterator<Item = f64>,
    ) -> Self {
        let before = numerators.len();
        let mut coefficients = Coefficients::from(numerators);
        coefficients.extend(weights);
        let len = coefficients.len() - before;
        // Equal weights cancel.
        let weights = &coefficients[before..];
        if let Some(&first) = weights.first()
            && weights.iter().all(|&w| w == first)
        {
            coefficients.truncate(before);
            for c in coefficients.iter_mut() {
                *c /= first;
            }
        }
        Self { domain: domain.map(Scalar::to_f64), dim, len, coefficients }
    }

    /// The ends of its part of the domain.
    #[inline]
    pub fn domain(&self) -> [f64; 2] {
        self.domain
    }

    /// The number of components of a point.
    #[inline]
    pub fn dimension(&self) -> usize {
        self.dim
    }

    /// The degree, one less than the number of control points.
    #[inline]
    pub fn degree(&self) -> usize {
        self.len.saturating_sub(1)
    }

    /// The Bernstein coefficients of a component; of a rational piece those of its numerator, `w[i] P[i]`.
    #[inline]
    pub(crate) fn component(&self, d: usize) -> &[f64] {
        &self.coefficients[d * self.len..][..self.len]
    }

    /// The weights; `None` of a polynomial.
    #[inline]
    pub fn weights(&self) -> Option<&[f64]> {
        let weights = &self.coefficients[self.dim * self.len..];
        (!weights.is_empty()).then_some(weights)
    }

    /// The component `d` of the control point `i`.
    #[inline]
    pub(crate) fn control(&self, i: usize, d: usize) -> f64 {
        let numerator = self.coefficients[d * self.len + i];
        self.weights().map_or(numerator, |weights| numerator / weights[i])
    }

    #[inline]
    pub(crate) fn is_finite(&self) -> bool {
        self.len > 0 && self.coefficients.iter().all(|c| c.is_finite())
    }

    /// The parameter of the curve at `0 <= x <= 1`, exact at both ends.
    #[inline]
    pub(crate) fn parameter(&self, x: f64) -> f64 {
        crate::domain::from_unit(self.domain, x)
    }

    /// The place of a parameter of the curve.
    #[inline]
    pub(crate) fn place(&self, t: f64) -> f64 {
        crate::domain::unit(self.domain, t)[1]
    }

    /// The component `d` of the point at `x`.
    #[inline]
    pub(crate) fn value(&self, d: usize, x: f64) -> f64 {
        let numerator = bernstein::eval(self.component(d), x);
        self.weights().map_or(numerator, |weights| numerator / bernstein::eval(weights, x))
    }

    /// The numerators of all components and the weights, each as a list of coefficients to be changed.
    #[inline]
    fn lists(&mut self) -> impl Iterator<Item = &mut [f64]> {
        self.coefficients.chunks_exact_mut(self.len.max(1))
    }

    /// The parts below and above `x`.
    #[inline]
    pub(crate) fn split(&self, x: f64) -> [Self; 2] {
        let (mut left, mut right) = (self.clone(), self.clone());
        for (before, after) in left.lists().zip(right.lists()) {
            bernstein::split(before, x, after);
        }
        let t = self.parameter(x);
        left.domain[1] = t;
        right.domain[0] = t;
        [left, right]
    }

    /// The part from `from` to `to`, which runs backwards if `from > to`.
    #[inline]
    pub(crate) fn restricted(&self, from: f64, to: f64) -> Self {
        let mut part = self.clone();
        for list in part.lists() {
            bernstein::restrict(list, from, to);
        }
        part.domain = [self.parameter(from), self.parameter(to)];
        part
    }

    /// The piece with the degree raised to `degree`, which is not lower than its own.
    #[inline]
    pub(crate) fn elevated_to(&self, degree: usize) -> Self {
        let mut coefficients = Vec::with_capacity(self.coefficients.len() / self.len.max(1) * (degree + 1));
        let mut elevated = vec![0.0; degree + 1];
        for list in self.coefficients.chunks_exact(self.len.max(1)) {
            bernstein::elevate(list, &mut elevated);
            coefficients.extend_from_slice(&elevated);
        }
        Self { coefficients: Coefficients::from(coefficients), len: degree + 1, ..*self }
    }

    /// The piece over another domain.
    #[inline]
    pub(crate) fn over(self, domain: [f64; 2]) -> Self {
        Self { domain, ..self }
    }

    /// The piece seen from a point and measured in a unit.
    #[inline]
    pub(crate) fn seen_from(&self, origin: &[f64], unit: f64) -> Self {
        let mut seen = self.clone();
        for (d, &origin) in origin.iter().enumerate().take(self.dim) {
            for i in 0..self.len {
                let weight = self.weights().map_or(1.0, |weights| weights[i]);
                seen.coefficients[d * self.len + i] = (self.component(d)[i] - origin * weight) / unit;
            }
        }
        seen
    }

    /// The largest absolute value of a component of a control point.
    #[inline]
    pub(crate) fn largest(&self) -> f64 {
        let mut largest = 0.0_f64;
        for d in 0..self.dim {
            for i in 0..self.len {
                largest = largest.max(self.control(i, d).abs());
            }
        }
        largest
    }

    /// The distance of two control points.
    #[inline]
    pub(crate) fn distance(&self, i: usize, j: usize) -> f64 {
        let mut largest = 0.0_f64;
        for d in 0..self.dim {
            largest = largest.max((self.control(i, d) - self.control(j, d)).abs());
        }
        if largest == 0.0 || !largest.is_finite() {
            return largest;
        }
        let mut square = 0.0;
        for d in 0..self.dim {
            let difference = (self.control(i, d) - self.control(j, d)) / largest;
            square += difference * difference;
        }
        Scalar::sqrt(square) * largest
    }

    /// The lengths of the chord and of the control polygon, between which that of the piece lies.
    #[inline]
    pub(crate) fn length_bounds(&self) -> [f64; 2] {
        let polygon = (1..self.len).map(|i| self.distance(i - 1, i)).sum();
        [self.distance(0, self.degree()), polygon]
    }

    /// A polynomial with the sign of the derivative of a component: the derivative itself, or `N' w - N w'`.
    #[inline]
    pub(crate) fn slope(&self, d: usize) -> Vec<f64> {
        let numerator = self.component(d);
        let Some(weights) = self.weights() else { return derivative(numerator) };
        // About a value of the component, so that fewer digits cancel.
        let middle = self.value(d, 0.5);
        let moved: Vec<f64> = numerator.iter().zip(weights).map(|(n, w)| n - middle * w).collect();
        let mut slope = product(&derivative(&moved), weights);
        for (s, p) in slope.iter_mut().zip(product(&moved, &derivative(weights))) {
            *s -= p;
        }
        slope
    }
}

/// The Bernstein coefficients of the derivative, with the degree lowered by one.
#[inline]
pub(crate) fn derivative(coefficients: &[f64]) -> Vec<f64> {
    let mut derivative = coefficients.to_vec();
    let len = bernstein::differentiate(&mut derivative).len();
    derivative.truncate(len);
    derivative
}

/// The Bernstein coefficients of a product.
#[inline]
pub(crate) fn product(a: &[f64], b: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; (a.len() + b.len()).saturating_sub(1)];
    if !a.is_empty() && !b.is_empty() {
        bernstein::multiply(a, b, &mut product);
    } else {
        product.clear();
    }
    product
}
