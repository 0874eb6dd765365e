//! Paths of lower degree within a tolerance.

use alloc::vec::Vec;

use super::{Path, PathSegment};
use crate::bernstein;
use crate::bernstein::product::bilinear;
use crate::vector::{largest_component, length};
use crate::{CurveError, Point, Scalar};

/// More segments are refused.
const MOST: usize = 1 << 20;

impl<P: Point> Path<P> {
    /// The path with polynomial segments of degree 3 at most: `|C(u) - Q(u)| <= tolerance` at all parameters of each
    /// segment and its part of the result, so that neither is farther from the other anywhere.
    ///
    /// Segments that are polynomials of such a degree stay as they are; the others are replaced by cubic segments with
    /// the same ends and tangents. The bound comes from the Bernstein coefficients of the difference.
    ///
    /// ```
    /// use basis_runtime::Path;
    ///
    /// let circle = Path::<[f64; 2]>::circle([0.0, 0.0], 1.0).to_cubics(1e-3)?;
    /// assert_eq!(circle.segments().len(), 16);
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Tolerance`] if the tolerance is not positive and finite, [`CurveError::NotFinite`] if a control
    /// point is infinite or NaN, [`CurveError::TooManyPoints`] if more than 2²⁰ segments would be needed.
    pub fn to_cubics(&self, tolerance: P::Scalar) -> Result<Self, CurveError> {
        self.lowered(3, tolerance)
    }

    /// The path with polynomial segments of degree 2 at most, within the tolerance as in
    /// [`to_cubics`](Self::to_cubics); a cubic segment becomes as few quadratic ones over equal parts of its parameter as
    /// keep the bound, for fonts and renderers that know no others.
    ///
    /// # Errors
    /// As [`to_cubics`](Self::to_cubics).
    pub fn to_quadratics(&self, tolerance: P::Scalar) -> Result<Self, CurveError> {
        self.lowered(2, tolerance)
    }

    fn lowered(&self, degree: usize, tolerance: P::Scalar) -> Result<Self, CurveError> {
        if !(tolerance > P::Scalar::ZERO && tolerance.is_finite()) {
            return Err(CurveError::Tolerance { value: tolerance.to_f64() });
        }
        let mut segments = Vec::new();
        for segment in &self.segments {
            let points = segment.control_points().iter();
            let size = points.fold(P::Scalar::ZERO, |size, &p| {
                let component = largest_component(p);
                if component.is_finite() && size.is_finite() { size.max(component) } else { P::Scalar::NAN }
            });
            if !size.is_finite() {
                return Err(CurveError::NotFinite);
            }
            // No part is smaller than rounding errors.
            let noise = P::Scalar::of(16.0) * P::Scalar::EPSILON * size;
            let mut open = alloc::vec![segment.clone()];
            while let Some(part) = open.pop() {
                if part.weights().is_none() && part.degree() <= degree {
                    segments.push(part);
                    continue;
                }
                let candidate = candidate(&part, degree);
                let deviation = deviation(&part, &candidate).to_f64();
                let limit = tolerance.max(noise).to_f64();
                if deviation <= limit {
                    segments.push(PathSegment::trusted(candidate, Vec::new()));
                    continue;
                }
                if segments.len() + open.len() >= MOST {
                    return Err(CurveError::TooManyPoints { needed: 2.0 * MOST as f64 });
                }
                // The deviation of a part falls like the power degree + 1 of its length.
                let excess = deviation / limit;
                let count = (2..8_usize)
                    .find(|&n| (0..=degree).fold(1.0, |power, _| power * n as f64) >= excess)
                    .unwrap_or(8);
                let at = |i: usize| P::Scalar::from_usize(i) / P::Scalar::from_usize(count);
                open.extend((0..count).rev().map(|i| part.restricted(at(i), at(i + 1))));
            }
        }
        Ok(Self { segments })
    }
}

/// The polynomial of degree 3 with the same ends and derivatives there, or of degree 2 with the same ends and middle.
fn candidate<P: Point>(segment: &PathSegment<P>, degree: usize) -> Vec<P> {
    let (start, end) = (segment.start(), segment.end());
    if degree == 2 {
        let middle = segment.eval(P::Scalar::of(0.5));
        let half = P::Scalar::of(-0.5);
        let handle = middle.scale(P::Scalar::of(2.0)).add_weighted(start, half).add_weighted(end, half);
        return alloc::vec![start, handle, end];
    }
    let third = P::Scalar::ONE / P::Scalar::of(3.0);
    let slope = |x: P::Scalar| {
        let mut derivatives = [P::Vector::zero(); 2];
        segment.derivatives_into(x, &mut derivatives);
        derivatives[1]
    };
    let [first, last] = [P::Scalar::ZERO, P::Scalar::ONE].map(slope);
    alloc::vec![start, start.add_scaled(first, third), end.add_scaled(last, -third), end]
}

/// A bound of `|C(x) - Q(x)|`: with `C = N / w` the largest Bernstein coefficient of `N - Q w` over the smallest weight.
pub(super) fn deviation<P: Point>(segment: &PathSegment<P>, candidate: &[P]) -> P::Scalar {
    let zero = P::zero();
    let (numerators, product, smallest) = match segment.weights() {
        None => (segment.control_points().to_vec(), candidate.to_vec(), P::Scalar::ONE),
        Some(weights) => {
            let numerators =
                segment.control_points().iter().zip(weights).map(|(p, &w)| p.scale(w)).collect::<Vec<_>>();
            let mut product = alloc::vec![zero; candidate.len() + weights.len() - 1];
            let factors: Vec<P> = weights.iter().map(|&w| P::from_components(|_| w)).collect();
            bilinear(candidate, &factors, &mut product, |q, w| {
                P::from_components(|d| q.component(d) * w.component(d))
            });
            (numerators, product, weights.iter().fold(P::Scalar::INFINITY, |a, &b| a.min(b)))
        }
    };
    let len = numerators.len().max(product.len());
    let (mut a, mut b) = (alloc::vec![zero; len], alloc::vec![zero; len]);
    bernstein::elevate(&numerators, &mut a);
    bernstein::elevate(&product, &mut b);
    let differences = a.iter().zip(&b).map(|(&a, &b)| length(a.minus(b)));
    differences.fold(P::Scalar::ZERO, |largest, d| if d > largest || d.is_nan() { d } else { largest })
        * (P::Scalar::ONE / smallest)
}
