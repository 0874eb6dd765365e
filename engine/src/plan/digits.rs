//! Numbers as sums of floats.

use crate::algebra::rational::Rational;

/// The nearest number with this number of bits, and what is missing to the number itself; with 53 bits, the nearest float.
pub(crate) fn split(value: &Rational, bits: u32) -> (Rational, Rational) {
    let mut unit = Rational::ONE;
    let (half, two) = (Rational::new(1, 2), Rational::from(2));
    // It is a multiple of the unit, by a number with `bits` bits.
    let (low, high) = (Rational::from(1 << (bits - 1)), Rational::from(1 << bits));
    let size = value.abs();
    while !size.is_zero() && &high * &unit <= size {
        unit = &unit * &two;
    }
    while !size.is_zero() && size < &low * &unit {
        unit = &unit * &half;
    }
    let steps = value.checked_div(&unit).unwrap_or(Rational::ZERO);
    let nearest = &(&steps + &half).floor() * &unit;
    let rest = value - &nearest;
    (nearest, rest)
}
