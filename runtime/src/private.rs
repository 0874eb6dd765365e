//! What the code that `basis!` emits calls, by absolute path. No part of the public interface.

use ::core::ops::Bound;

pub use ::core;

use crate::basis::combination;
pub use crate::domain::unit;
use crate::form::{binomials, nested};
use crate::{Point, Scalar, ShapeError};

/// `value`, if it is finite and lies between the bounds; a bound that is no float stands for the nearest one.
///
/// # Errors
/// Otherwise, the error that names the family, the parameter as the spec writes it, and the range as the spec writes it.
#[inline]
pub fn check_shape<S: Scalar>(
    family: &'static str,
    parameter: &'static str,
    value: S,
    lower: Bound<f64>,
    upper: Bound<f64>,
    range: &'static str,
) -> Result<S, ShapeError> {
    let above = match lower {
        Bound::Included(bound) => value >= S::of(bound),
        Bound::Excluded(bound) => value > S::of(bound),
        Bound::Unbounded => true,
    };
    let below = match upper {
        Bound::Included(bound) => value <= S::of(bound),
        Bound::Excluded(bound) => value < S::of(bound),
        Bound::Unbounded => true,
    };
    if above && below && value.is_finite() {
        Ok(value)
    } else {
        Err(ShapeError::new(family, parameter, value.to_f64(), range))
    }
}

/// `Σ weights[i] points[i]`; a weight of zero is added like any other.
#[inline]
pub fn combine<P: Point, const N: usize>(points: &[P; N], weights: [P::Scalar; N]) -> P {
    combination(points.iter().copied().zip(weights))
}

/// `Σ_j binomial(m, j) coefficients[j] s^(m-j) x^j`, `m = M - 1`.
///
/// With `s`, `x` and all coefficients nonnegative no step of the evaluation is negative.
#[inline]
pub fn bernstein<S: Scalar, const M: usize>(coefficients: [S; M], s: S, x: S) -> S {
    nested(&coefficients, &const { binomials::<M>() }, s, x)
}

/// The powers `[1, x, x², …, x^(M-1)]`.
#[inline]
pub fn powers<S: Scalar, const M: usize>(x: S) -> [S; M] {
    let mut power = S::ONE;
    ::core::array::from_fn(|k| {
        if k > 0 {
            power = power * x;
        }
        power
    })
}
