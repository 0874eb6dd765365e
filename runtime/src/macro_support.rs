//! What the code that `basis!` emits calls, by absolute path. No part of the public interface.

use ::core::ops::Bound;

pub use ::core;
#[cfg(feature = "serde")]
pub use ::serde;

use crate::basis::combination;
pub use crate::boxes::box_sum;
use crate::curve::{End, eliminate};
pub use crate::domain::unit;
use crate::form::{affine_nested, nested};
use crate::numeric::binomial::binomials;
pub use crate::numeric::elementary::inverse_power_of_two;
#[cfg(feature = "serde")]
pub use crate::serialize::{read_shape, shape_error, write_shape};
use crate::simplex::SimplexIndex;
pub use crate::simplex::raise::raise_weights;
use crate::vector::is_finite;
use crate::{Basis, CurveError, Point, Scalar, ShapeError};

/// `value`, if it is finite and lies between the bounds; a bound that is no float stands for the nearest one.
///
/// # Errors
/// Otherwise, the error that names the family, the parameter as the spec writes it, and the range as the spec writes
/// it.
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

/// `value` if it is not above what this kind of floats reaches: `reaches` has the largest shape value with which
/// exponentials of it do not overflow, and the range with this end as text, for `f64` and for `f32`.
///
/// # Errors
/// Otherwise, the error that names the family, the parameter and that range.
#[inline]
pub fn check_reach<S: Scalar>(
    family: &'static str,
    parameter: &'static str,
    value: S,
    reaches: [(f64, &'static str); 2],
) -> Result<S, ShapeError> {
    reached(family, parameter, value, reaches, |value, largest| value <= largest)
}

/// `value` if it is not below what this kind of floats reaches: as [`check_reach`], with the smallest shape value.
///
/// # Errors
/// Otherwise, the error that names the family, the parameter and that range.
#[inline]
pub fn check_reach_below<S: Scalar>(
    family: &'static str,
    parameter: &'static str,
    value: S,
    reaches: [(f64, &'static str); 2],
) -> Result<S, ShapeError> {
    reached(family, parameter, value, reaches, |value, smallest| value >= smallest)
}

/// `value` if it lies on the right side of the end for this kind of floats.
#[inline]
fn reached<S: Scalar>(
    family: &'static str,
    parameter: &'static str,
    value: S,
    reaches: [(f64, &'static str); 2],
    is_within: fn(S, S) -> bool,
) -> Result<S, ShapeError> {
    let is_double = S::of(f64::MAX).is_finite();
    let (end, range) = reaches[usize::from(!is_double)];
    if is_within(value, S::of(end)) {
        Ok(value)
    } else {
        Err(ShapeError::new(family, parameter, value.to_f64(), range))
    }
}

/// `point`, which a join computes, if all its components are finite.
///
/// # Errors
/// [`CurveError::NotFinite`] otherwise.
#[inline]
pub fn check_point<P: Point>(point: P) -> Result<P, CurveError> {
    if is_finite(point) { Ok(point) } else { Err(CurveError::NotFinite) }
}

/// The error of [`Basis::start_points`](crate::Basis::start_points) if a divisor is zero, as it is `at` some shape
/// values.
///
/// # Errors
/// See above.
#[inline]
pub fn check_end<S: Scalar>(
    family: &'static str,
    conditions: usize,
    at: &'static str,
    divisor: S,
) -> Result<(), CurveError> {
    if divisor == S::ZERO { Err(CurveError::Join { family, conditions, at }) } else { Ok(()) }
}

/// [`Basis::start_points`](crate::Basis::start_points) and, `at_end`, [`Basis::end_points`](crate::Basis::end_points)
/// for any order, by elimination.
///
/// # Errors
/// As these.
pub fn end_points<B: Basis, P: Point<Scalar = B::Scalar>>(
    basis: &B,
    derivatives: &[P],
    points: B::Points<P>,
    at_end: bool,
) -> Result<B::Points<P>, CurveError> {
    eliminate(basis, derivatives, points, if at_end { End::Last } else { End::Start })
}

/// `Σ weights[i] points[i]`; a weight of zero is added like any other.
#[inline]
pub fn combine<P: Point, const N: usize>(points: &[P; N], weights: [P::Scalar; N]) -> P {
    combination(points.iter().copied().zip(weights))
}

/// `Σ_j binomial(m, j) coefficients[j] s^(m-j) x^j`, `m = M - 1`, of numbers or of lists of numbers.
///
/// With `s`, `x` and all coefficients nonnegative no step of the evaluation is negative.
#[inline]
pub fn bernstein<P: Point, const M: usize>(coefficients: [P; M], s: P::Scalar, x: P::Scalar) -> P {
    nested(&coefficients, &const { binomials::<M>() }, s, x)
}

/// [`bernstein`] for coordinates with the sum 1, with a third of its error: only the smaller one is used.
///
/// With `s`, `x` and all coefficients nonnegative no step that counts is negative: in `sum + (c - sum x)` the product
/// is at most half of the sum.
#[inline]
pub fn affine_bernstein<P: Point, const M: usize>(coefficients: [P; M], s: P::Scalar, x: P::Scalar) -> P {
    affine_nested(&coefficients, &const { binomials::<M>() }, s, x)
}

/// `x`, or 0 if it is negative; NaN stays NaN.
#[inline]
pub fn cut_off<S: Scalar>(x: S) -> S {
    if x < S::ZERO { S::ZERO } else { x }
}

/// The tangent of a multiple of a shape value.
#[inline]
pub fn tan<S: Scalar>(x: S) -> S {
    S::narrow(tangent(x.wide()))
}

/// 1 minus the tangent, without the difference: `tan(π/4 - x) (1 + tan x)`.
#[inline]
pub fn tan_complement<S: Scalar>(x: S) -> S {
    use core::f64::consts::FRAC_PI_4;
    // π/4 is the sum of a float and of what is missing to it.
    let (x, quarter) = (x.wide(), S::Wide::of(FRAC_PI_4));
    let rest = S::Wide::of(FRAC_PI_4 - quarter.to_f64() + 3.061_616_997_868_383e-17);
    S::narrow(tangent((quarter - x) + rest) * (S::Wide::ONE + tangent(x)))
}

#[inline]
fn tangent<S: Scalar>(x: S) -> S {
    let (sin, cos) = x.sin_cos();
    sin / cos
}

/// The hyperbolic tangent.
#[inline]
pub fn tanh<S: Scalar>(x: S) -> S {
    let (two, size) = (S::Wide::of(2.0), x.abs().wide());
    let grown = (-(two * size)).exp_m1();
    let size = S::narrow(-grown / (two + grown));
    if x < S::ZERO { -size } else { size }
}

/// 1 minus the hyperbolic tangent, without the difference.
#[inline]
pub fn tanh_complement<S: Scalar>(x: S) -> S {
    let two = S::Wide::of(2.0);
    S::narrow(two / (two + (two * x.wide()).exp_m1()))
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

/// `Σ c[α] u^α₁ v^α₂ w^α₃`, all `α` with the sum `degree` in lexicographic order; the same on a tetrahedron.
///
/// With all numbers nonnegative no step is negative.
#[inline]
pub fn simplex_sum<S: Scalar, const M: usize, const K: usize>(
    coefficients: &[S; M],
    at: [S; K],
    degree: usize,
) -> S {
    crate::simplex::simplex_sum(coefficients, &at, degree)
}

/// The multinomial coefficients `n!/(α₁! α₂! …)` of all `α` with the sum `n`, in lexicographic order.
pub const fn multinomials<const T: usize>(corners: usize, degree: usize) -> [f64; T] {
    let mut table = [1.0; T];
    let mut position = 0;
    while position < T {
        table[position] = match corners {
            3 => multinomial(SimplexIndex::<3>::at(degree, position)),
            _ => multinomial(SimplexIndex::<4>::at(degree, position)),
        };
        position += 1;
    }
    table
}

const fn multinomial<const K: usize>(index: Option<SimplexIndex<K>>) -> f64 {
    let Some(index) = index else { return 0.0 };
    let (mut result, mut sum, mut place) = (1.0, 0, 0);
    while place < K {
        // Times binomial(sum, part).
        let part = index.components()[place];
        let mut k = 1;
        while k <= part {
            sum += 1;
            result = result * sum as f64 / k as f64;
            k += 1;
        }
        place += 1;
    }
    result
}

/// A table from its different entries and the place of each: one byte for each place, or two, the lower one first.
#[inline]
pub fn table<S: Scalar, const N: usize, const T: usize, const L: usize>(
    entries: &[S],
    places: &[u8; L],
) -> [[S; N]; T] {
    let width = L / (N * T).max(1);
    ::core::array::from_fn(|row| {
        ::core::array::from_fn(|column| {
            let start = (row * N + column) * width;
            let place =
                places[start..start + width].iter().rev().fold(0, |place, &b| 256 * place + usize::from(b));
            entries[place]
        })
    })
}

/// What a generated type calls where serde is not asked for.
#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serialize_shape {
    ($($shape:tt)*) => {};
}

/// The items, where there is an allocator.
#[cfg(feature = "alloc")]
#[doc(hidden)]
#[macro_export]
macro_rules! __with_alloc {
    ($($item:tt)*) => { $($item)* };
}

/// Nothing, without an allocator.
#[cfg(not(feature = "alloc"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __with_alloc {
    ($($item:tt)*) => {};
}
