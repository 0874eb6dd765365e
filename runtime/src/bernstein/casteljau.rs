//! De Casteljau's algorithm: values, and the polynomial on a part of the interval.

use crate::numeric::binomial::after;
use crate::vector::lerp;
use crate::{Point, Scalar};

/// The value `p(x)`, by nesting in `1 - x`; zero for the empty slice.
///
/// ```
/// use basis_runtime::bernstein;
///
/// assert_eq!(bernstein::eval(&[0.0, 8.0, 4.0], 0.5), 5.0);
/// ```
#[inline]
pub fn eval<P: Point>(points: &[P], x: P::Scalar) -> P {
    let Some((&first, rest)) = points.split_first() else { return P::zero() };
    let s = P::Scalar::ONE - x;
    let degree = rest.len();
    let (mut power, mut binomial) = (P::Scalar::ONE, 1.0);
    rest.iter().enumerate().fold(first, |sum, (k, &point)| {
        power = power * x;
        // Exact: each product and quotient is a whole number, below 2^53 up to degree 52.
        binomial = after(binomial, degree, k);
        sum.scale(s).add_weighted(point, power * P::Scalar::of(binomial))
    })
}

/// The value and the derivatives `[p(x), p'(x), p''(x), …]`, as many as `derivatives` has places; zero above the
/// degree.
///
/// `scratch` has the length of `points`; what it holds does not matter.
///
/// # Panics
/// If `scratch` is shorter than `points`.
pub fn eval_with_derivs<P: Point>(points: &[P], x: P::Scalar, scratch: &mut [P], derivatives: &mut [P]) {
    let mut rest = &mut scratch[..points.len()];
    rest.copy_from_slice(points);
    for derivative in derivatives {
        *derivative = eval(rest, x);
        let len = super::differentiate(rest).len();
        rest = &mut rest[..len];
    }
}

/// Replaces the control points of `[0, 1]` by those of `[0, x]`: `q(y) = p(x y)`.
#[inline]
pub fn keep_left<P: Point>(points: &mut [P], x: P::Scalar) {
    for step in 1..points.len() {
        for i in (step..points.len()).rev() {
            points[i] = lerp(points[i - 1], points[i], x);
        }
    }
}

/// Replaces the control points of `[0, 1]` by those of `[x, 1]`: `q(y) = p(x + (1 - x) y)`.
#[inline]
pub fn keep_right<P: Point>(points: &mut [P], x: P::Scalar) {
    for step in 1..points.len() {
        for i in 0..points.len() - step {
            points[i] = lerp(points[i], points[i + 1], x);
        }
    }
}

/// Splits at `x`: `points` become the control points of `[0, x]`, and `right` those of `[x, 1]`.
///
/// The last point of the one is the first point of the other.
///
/// ```
/// use basis_runtime::bernstein;
///
/// let (mut left, mut right) = ([0.0, 8.0, 4.0], [0.0; 3]);
/// bernstein::split(&mut left, 0.5, &mut right);
/// assert_eq!((left, right), ([0.0, 4.0, 5.0], [5.0, 6.0, 4.0]));
/// ```
///
/// # Panics
/// If the lengths differ.
#[inline]
pub fn split<P: Point>(points: &mut [P], x: P::Scalar, right: &mut [P]) {
    assert_eq!(points.len(), right.len(), "both halves have the degree of the whole");
    let len = points.len();
    for step in 0..len {
        // The last point of every step belongs to the right half.
        right[len - 1 - step] = points[len - 1];
        for i in (step + 1..len).rev() {
            points[i] = lerp(points[i - 1], points[i], x);
        }
    }
}

/// Replaces the control points of `[0, 1]` by those of `[from, to]`: `q(y) = p(from + (to - from) y)`.
///
/// With `from > to` the result runs backwards. Nothing is extrapolated for parameters in `[0, 1]`; outside of it the
/// polynomial is continued.
///
/// ```
/// use basis_runtime::bernstein;
///
/// let mut parabola = [0.0, 8.0, 4.0];
/// bernstein::restrict(&mut parabola, 1.0, 0.5);
/// assert_eq!(parabola, [4.0, 6.0, 5.0]);
/// ```
pub fn restrict<P: Point>(points: &mut [P], from: P::Scalar, to: P::Scalar) {
    if from > to {
        points.reverse();
        let one = P::Scalar::ONE;
        return restrict(points, one - from, one - to);
    }
    // The larger of the two parts comes first: the quotient is then well-defined, and between 0 and 1 inside.
    let rest = P::Scalar::ONE - from;
    if to >= rest {
        if to != P::Scalar::ONE {
            keep_left(points, to);
        }
        if from != P::Scalar::ZERO {
            keep_right(points, from / to);
        }
    } else {
        if from != P::Scalar::ZERO {
            keep_right(points, from);
        }
        keep_left(points, (to - from) / rest);
    }
}
