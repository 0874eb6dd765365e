//! Bernstein nets on boxes, one coordinate at a time.

use crate::vector::difference;
use crate::{Point, Scalar};

/// `Σ c[α] ∏ s^(n-k) x^k`, the last index fastest: each coordinate by nested multiplication, from the last.
///
/// With all numbers nonnegative no step is negative. Binomial factors are part of the coefficients.
#[inline]
pub fn box_sum<S: Scalar, const M: usize, const K: usize>(
    mut coefficients: [S; M],
    degrees: [usize; K],
    units: [[S; 2]; K],
) -> S {
    let mut len = M;
    for axis in (0..K).rev() {
        let (width, [s, x]) = (degrees[axis] + 1, units[axis]);
        for fibre in 0..len / width {
            let terms = &coefficients[fibre * width..(fibre + 1) * width];
            let mut power = S::ONE;
            let sum = terms[1..].iter().fold(terms[0], |sum, &c| {
                power = power * x;
                sum * s + c * power
            });
            coefficients[fibre] = sum;
        }
        len /= width;
    }
    coefficients[0]
}

/// Differentiates a curve in Bernstein form on the unit interval, in place: `order` coefficients less.
pub(crate) fn differentiate<P: Point>(coefficients: &mut [P], order: usize) {
    for m in (coefficients.len() - order..coefficients.len()).rev() {
        let factor = P::Scalar::from_usize(m);
        for i in 0..m {
            coefficients[i] = difference(coefficients[i + 1], coefficients[i]).scale(factor);
        }
    }
}

/// De Casteljau's algorithm.
pub(crate) fn finish<P: Point>(coefficients: &mut [P], [s, x]: [P::Scalar; 2]) -> P {
    for m in (1..coefficients.len()).rev() {
        for i in 0..m {
            coefficients[i] = coefficients[i].scale(s).add_weighted(coefficients[i + 1], x);
        }
    }
    coefficients[0]
}
