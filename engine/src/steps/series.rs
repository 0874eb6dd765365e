//! Elementary functions of rational numbers, to more digits than any float has.

use super::Function;
use crate::algebra::rational::Rational;

/// Digits after the point that are kept.
const DIGITS: u32 = 90;

/// Arguments beyond this are left to the program: their exponentials are no floats.
const LARGEST: i64 = 800;

/// A number without the digits that do not count.
pub(super) fn rounded(value: &Rational) -> Rational {
    let unit = Rational::from(10).pow(DIGITS);
    let Some(scaled) = unit.recip().filter(|_| !value.is_integer()) else { return value.clone() };
    &(&(value * &unit) + &Rational::new(1, 2)).floor() * &scaled
}

/// A function of a number, with an error far below 10⁻⁶⁰ of the larger of it and 1; `None` for large arguments, and at
/// a pole.
pub(crate) fn value(function: Function, x: &Rational) -> Option<Rational> {
    if x.abs() > Rational::from(LARGEST) {
        return None;
    }
    let quotient = |a: Rational, b: &Rational| a.checked_div(b).map(|value| rounded(&value));
    let two = Rational::from(2);
    match function {
        Function::Sin => Some(zero_at_turns(sin_cos(x).0, x)),
        Function::Cos => Some(zero_at_turns(sin_cos(x).1, x)),
        Function::Tan => {
            let (sin, cos) = sin_cos(x);
            quotient(sin, &cos)
        }
        Function::Tanh => {
            let e = expm1(&(x * &two));
            let below = &e + &two;
            quotient(e, &below)
        }
        Function::Expm1 => Some(expm1(x)),
        Function::InversePowerOfTwo => inverse_power_of_two(x),
    }
}

/// A power of two with 1 ≤ x·2ᵏ < 2; `None` where x is not positive.
fn inverse_power_of_two(x: &Rational) -> Option<Rational> {
    let two = Rational::from(2);
    let bits = |n: Rational| u32::try_from(n.bits()).ok();
    let (above, below) = (bits(x.numer())?, bits(x.denom())?);
    let mut power = if above > below { two.pow(above - below).recip()? } else { two.pow(below - above) };
    if !x.is_positive() {
        return None;
    }
    while x * &power < Rational::ONE {
        power = &power * &two;
    }
    while x * &power >= two {
        power = &power * &Rational::new(1, 2);
    }
    Some(power)
}

/// A sine or cosine of x, which is 0 where that is as near to a multiple of π/2 as the digits of π that are known.
fn zero_at_turns(value: Rational, x: &Rational) -> Rational {
    let tiny = |y: &Rational, digits: u32| &y.abs() * &Rational::from(10).pow(digits) < Rational::ONE;
    if tiny(&value, 40) && !tiny(x, 3) { Rational::ZERO } else { value }
}

/// x − x³/6 + … and 1 − x²/2 + …
fn sin_cos(x: &Rational) -> (Rational, Rational) {
    // Of an argument that was halved until it is small, and then doubled.
    let (x, halvings) = small(x);
    let square = rounded(&(&x * &x));
    let series = |first: Rational, from: i64| {
        let (mut sum, mut term, mut k) = (first.clone(), first, from);
        while !term.is_zero() {
            term = rounded(&(&(-&(&term * &square)) * &Rational::new(1, k * (k + 1))));
            sum = &sum + &term;
            k += 2;
        }
        sum
    };
    let (mut sin, mut cos) = (series(x, 2), series(Rational::ONE, 1));
    for _ in 0..halvings {
        (sin, cos) =
            (rounded(&(&(&sin * &cos) * &Rational::from(2))), rounded(&(&(&cos * &cos) - &(&sin * &sin))));
    }
    (sin, cos)
}

/// x + x²/2 + …
fn expm1(x: &Rational) -> Rational {
    let (x, halvings) = small(x);
    let (mut sum, mut term, mut k) = (x.clone(), x.clone(), 2);
    while !term.is_zero() {
        term = rounded(&(&(&term * &x) * &Rational::new(1, k)));
        sum = &sum + &term;
        k += 1;
    }
    for _ in 0..halvings {
        // exp(2y) − 1 = e (e + 2)
        sum = rounded(&(&sum * &(&sum + &Rational::from(2))));
    }
    sum
}

/// A number below 1 in absolute value, and how often it is to be doubled.
fn small(x: &Rational) -> (Rational, u32) {
    let (mut x, mut halvings) = (rounded(x), 0);
    while x.abs() > Rational::ONE {
        x = rounded(&(&x * &Rational::new(1, 2)));
        halvings += 1;
    }
    (x, halvings)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The digits of these constants are from tables.
    #[test]
    fn known_digits() {
        let near = |found: Option<Rational>, digits: &str| {
            let unit = Rational::from(10).pow(36);
            let found = (&found.expect("a value") * &unit).floor().to_string();
            assert_eq!(found, digits);
        };
        let one = Rational::ONE;
        near(value(Function::Sin, &one), "841470984807896506652502321630298999");
        near(value(Function::Cos, &one), "540302305868139717400936607442976603");
        near(value(Function::Tan, &one), "1557407724654902230506974807458360173");
        near(value(Function::Expm1, &one), "1718281828459045235360287471352662497");
        near(value(Function::Tanh, &one), "761594155955764888119458282604793590");
        near(value(Function::Sin, &Rational::from(3)), "141120008059867222100744802808110279");
        near(value(Function::Expm1, &Rational::from(-3)), "-950212931632136057020657584349938224");
        assert_eq!(value(Function::Expm1, &Rational::from(1_000_000_000)), None);
    }
}
