//! Sines and exponentials in loops that the compiler turns into vector instructions, and powers of two.
//!
//! The functions of the standard library are calls, one for each number. [`sine`] and [`decay`] are polynomials without
//! branches, for the arguments that maps of domains have; each is within 2 ε of the exact value, relative to it.

// All of it is compiled once for each set of vector instructions, inside of the functions that name them.
#![allow(clippy::inline_always)]

use crate::Scalar;

/// The sine of an angle between 0 and π, with a small relative error also next to these.
#[inline(always)]
pub(crate) fn sine<const FUSED: bool, S: Scalar>(angle: S) -> S {
    // sin(π - z) = sin z, and the difference of floats is exact where z lies between π/2 and π.
    let rest = (S::PI - angle) + S::PI_REST;
    let w = if angle + angle > S::PI { rest } else { angle };
    let square = w * w;
    nested::<FUSED, S>(S::SINE, square).fma::<FUSED>(w * square, w)
}

/// `exp(-2x) - 1` and `exp(-2x)` for `x >= 0`, both with a small relative error.
#[inline(always)]
pub(crate) fn decay<const FUSED: bool, S: Scalar>(x: S) -> [S; 2] {
    let z = -(x + x);
    let z = if z < S::LEAST_EXPONENT { S::LEAST_EXPONENT } else { z };
    // z = k ln 2 + r with |r| <= ln 2 / 2
    let shifted = z.fma::<FUSED>(S::LOG2_E, S::TO_WHOLE);
    let k = shifted - S::TO_WHOLE;
    let r = (-k).fma::<FUSED>(S::LN_2[0], z);
    let r = (-k).fma::<FUSED>(S::LN_2[1], r);
    let less = nested::<FUSED, S>(S::EXP, r).fma::<FUSED>(r * r, r);
    let power = shifted.power_of_two();
    [power.fma::<FUSED>(less, power - S::ONE), power.fma::<FUSED>(less, power)]
}

/// The power of two by which a positive number becomes one from 1 to 2, or the nearest to it that is a float: a product
/// with it rounds nothing.
#[inline]
pub fn inverse_power_of_two<S: Scalar>(x: S) -> S {
    x.inverse_power_of_two()
}

/// A polynomial, its coefficients from that of the lowest power on.
#[inline(always)]
fn nested<const FUSED: bool, S: Scalar>(coefficients: &[S], x: S) -> S {
    coefficients.iter().rev().fold(S::ZERO, |sum, c| sum.fma::<FUSED>(x, *c))
}
