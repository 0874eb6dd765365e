//! Degree elevation and differentiation.

use crate::numeric::binomial::row;
use crate::vector::{difference, lerp};
use crate::{Point, Scalar};

/// The control points of the same polynomial with the degree raised to `elevated.len() - 1`:
/// `q[j] = j/m p[j-1] + (1 - j/m) p[j]` once for each degree `m`.
///
/// Every new point lies between old ones; both ends stay as they are.
///
/// ```
/// use basis_runtime::bernstein;
///
/// let mut cubic = [0.0; 4];
/// bernstein::elevate(&[0.0, 6.0, 3.0], &mut cubic);
/// assert_eq!(cubic, [0.0, 4.0, 5.0, 3.0]);
/// ```
///
/// # Panics
/// If `elevated` is shorter than `points`.
pub fn elevate<P: Point>(points: &[P], elevated: &mut [P]) {
    elevated[..points.len()].copy_from_slice(points);
    if points.is_empty() {
        elevated.fill(P::zero());
        return;
    }
    for degree in points.len()..elevated.len() {
        elevated[degree] = elevated[degree - 1];
        for j in (1..degree).rev() {
            let weight = P::Scalar::from_usize(j) / P::Scalar::from_usize(degree);
            elevated[j] = lerp(elevated[j], elevated[j - 1], weight);
        }
    }
}

/// Replaces the Bernstein coefficients by those of the powers of `y = 2x - 1`, which runs from -1 to 1:
/// `p = q[0] + q[1] y + q[2] y² + …`.
///
/// They are the backward differences at the end of the left half. The result loses about as many binary digits as the
/// degree has units.
///
/// ```
/// use basis_runtime::bernstein;
///
/// let mut parabola = [0.0, 8.0, 4.0];
/// bernstein::centred_powers(&mut parabola);
/// assert_eq!(parabola, [5.0, 2.0, -3.0]);
/// ```
#[inline]
pub fn centred_powers<P: Point>(points: &mut [P]) {
    super::keep_left(points, P::Scalar::of(0.5));
    points.reverse();
    let len = points.len();
    let degree = len.saturating_sub(1);
    for order in 1..len {
        // A half-open range, which the compiler unrolls.
        for i in (order..len).rev() {
            points[i] = difference(points[i - 1], points[i]);
        }
    }
    for (point, binomial) in points.iter_mut().zip(row(degree)) {
        *point = point.scale(P::Scalar::of(binomial));
    }
}

/// Replaces the control points by those of the derivative, `n (p[i+1] - p[i])`, and returns them; there is one less.
///
/// The derivative of a constant is the empty slice.
#[inline]
pub fn differentiate<P: Point>(points: &mut [P]) -> &mut [P] {
    let degree = points.len().saturating_sub(1);
    let factor = P::Scalar::from_usize(degree);
    for i in 0..degree {
        points[i] = difference(points[i + 1], points[i]).scale(factor);
    }
    &mut points[..degree]
}
