//! Numbers as decimals: rounded, for reading, and the shortest that programs read as a float.

use basis_prover::algebra::rational::{Rational, ToFloat as _};

/// A number rounded to a number of digits behind the point, one below a thousandth with a power of ten to another
/// number of them: with 6 and 3 `0.333333` and `3.333e-5`.
pub(crate) fn readable(x: &Rational, places: u32, small: u32) -> String {
    if x.is_zero() || x.abs() >= Rational::new(1, 1000) { fixed(x, places) } else { scientific(x, small) }
}

/// A number rounded to a number of digits behind the point: `0.333333`.
pub(crate) fn fixed(x: &Rational, places: u32) -> String {
    let places = places as usize;
    let all = format!("{:0>1$}", scaled(x, places as i64).to_string(), places + 1);
    let (whole, part) = all.split_at(all.len() - places);
    format!("{}{whole}.{part}", sign(x))
}

/// A number other than 0 with one digit before the point and a number of digits behind it: `3.333e-5`.
fn scientific(x: &Rational, places: u32) -> String {
    let (digits, exponent) = leading(x, i64::from(places) + 1);
    let digits = digits.to_string();
    let (whole, part) = digits.split_at(1);
    format!("{}{whole}.{part}e{exponent}", sign(x))
}

/// The first digits of a number other than 0, rounded, as a whole number, and the power of ten that the first of them
/// stands for.
fn leading(x: &Rational, count: i64) -> (Rational, i64) {
    // 2^(size − 1) < |x| < 2^(size + 1), and log₁₀ 2 is about 0.30103.
    let size = x.numer().bits() as i64 - x.denom().bits() as i64;
    let mut exponent = (size - 1) * 30_103 / 100_000 - 1;
    loop {
        let digits = scaled(x, count - 1 - exponent);
        if digits.to_string().len() as i64 == count {
            return (digits, exponent);
        }
        exponent += 1;
    }
}

fn sign(x: &Rational) -> &'static str {
    if x.is_negative() { "-" } else { "" }
}

/// The whole number nearest to |x| · 10^power, of two the larger one.
fn scaled(x: &Rational, power: i64) -> Rational {
    (&times_power(&x.abs(), 10, power) + &Rational::new(1, 2)).floor()
}

/// x · base^power
fn times_power(x: &Rational, base: i64, power: i64) -> Rational {
    let size = Rational::from(base).pow(power.unsigned_abs() as u32);
    let size = if power < 0 { &Rational::ONE / &size } else { size };
    x * &size
}

/// The shortest decimal that a program reads as a finite `f64`, with a decimal point and without an exponent: `-0.25`,
/// `3.0`.
pub(crate) fn of_float(x: f64) -> String {
    let (digits, exponent) = shortest(x.abs(), &|decimal| decimal.to_f64());
    format!("{}{}", minus(x), plain(&digits, exponent))
}

/// The same with an exponent where it is much shorter: `1e-30`.
#[cfg(any(test, feature = "tools"))]
pub(crate) fn of_f64(x: f64) -> String {
    with_exponent(x, shortest(x.abs(), &|decimal| decimal.to_f64()))
}

/// As [`of_f64`] for `f32`.
#[cfg(any(test, feature = "tools"))]
pub(crate) fn of_f32(x: f32) -> String {
    let x = f64::from(x);
    with_exponent(x, shortest(x.abs(), &|decimal| f64::from(decimal.to_f64() as f32)))
}

/// Numbers from 10⁻⁴ to 10¹⁶ are written without an exponent.
#[cfg(any(test, feature = "tools"))]
fn with_exponent(x: f64, (digits, exponent): (String, i64)) -> String {
    let minus = minus(x);
    if (-4..16).contains(&exponent) {
        return format!("{minus}{}", plain(&digits, exponent));
    }
    let (whole, part) = digits.split_at(1);
    let point = if part.is_empty() { "" } else { "." };
    format!("{minus}{whole}{point}{part}e{exponent}")
}

fn minus(x: f64) -> &'static str {
    if x < 0.0 { "-" } else { "" }
}

/// Digits of which the first stands for a multiple of 10^exponent.
fn plain(digits: &str, exponent: i64) -> String {
    let Ok(behind) = usize::try_from(exponent) else {
        return format!("0.{}{digits}", "0".repeat(exponent.unsigned_abs() as usize - 1));
    };
    let all = format!("{digits:0<0$}", behind + 2);
    let (whole, part) = all.split_at(behind + 1);
    format!("{whole}.{part}")
}

/// The fewest digits that are read as a float ≥ 0, of those the ones nearest to it, and the power of ten that the first
/// stands for. Of powers of two it may be up to two digits more.
fn shortest(float: f64, read: &dyn Fn(&Rational) -> f64) -> (String, i64) {
    if float == 0.0 {
        return (String::from("0"), 0);
    }
    let exact = exact(float);
    let rounded = |count: i64| {
        let (digits, exponent) = leading(&exact, count);
        let is_read = read(&times_power(&digits, 10, exponent - count + 1)) == float;
        (digits, exponent, is_read)
    };
    // Most numbers in code are short; others have nearly all digits.
    let mut enough = (1..=4).find(|count| rounded(*count).2).unwrap_or(ENOUGH);
    let mut few = enough.min(5);
    while few < enough {
        let middle = i64::midpoint(few, enough);
        if rounded(middle).2 { enough = middle } else { few = middle + 1 }
    }
    let (digits, exponent, _) = rounded(enough);
    (digits.to_string().trim_end_matches('0').to_string(), exponent)
}

/// As many digits tell every two floats apart.
const ENOUGH: i64 = 17;

/// The number that a finite float ≥ 0 is.
fn exact(float: f64) -> Rational {
    let bits = float.to_bits();
    let exponent = (bits >> 52) as i64;
    let whole = bits & ((1 << 52) - 1) | u64::from(exponent > 0) << 52;
    times_power(&Rational::from(whole as i64), 2, exponent.max(1) - 1075)
}

#[cfg(test)]
mod tests {
    use basis_test_support::Random;

    use super::*;

    #[test]
    fn floats_are_read_as_they_were() {
        let mut random = Random::new(7);
        let halves = (-1074..1024).step_by(9).map(|k| 2_f64.powi(k));
        let short = (0..500).map(|k| f64::from(k) / 100.0);
        let any = (0..300).map(|_| f64::from_bits(random.bits() >> 1)).filter(|x| x.is_finite());
        let positive = halves.chain(short).chain(any.collect::<Vec<_>>());
        for x in positive.flat_map(|x| [x, -x]) {
            let texts = [of_float(x), of_f64(x)];
            assert_eq!(texts.clone().map(|text| text.parse::<f64>()), [Ok(x), Ok(x)], "{texts:?}");
            assert!(texts.iter().all(|text| text.contains(['.', 'e'])), "{texts:?}");
            // Below a power of two floats are nearer than above it, where there may be a shorter one that is not the
            // nearest.
            let more = 2 * usize::from(x.to_bits() << 12 == 0);
            let known = format!("{:?}", x + 0.0).len();
            assert!((known..=known + more).contains(&texts[1].len()), "{}", texts[1]);
            if (x as f32).is_finite() {
                assert_eq!(of_f32(x as f32).parse(), Ok(x as f32));
                assert!(of_f32(x as f32).len() <= format!("{:?}", x as f32).len() + more);
            }
        }
        assert_eq!(
            [of_float(0.0), of_float(1e-7), of_float(1e22)],
            ["0.0", "0.0000001", "10000000000000000000000.0"]
        );
        assert_eq!([of_f64(1e-30), of_f64(1.5e17), of_f64(0.1)], ["1e-30", "1.5e17", "0.1"]);
    }

    #[test]
    fn decimals_are_rounded() {
        let text = |n, d| readable(&Rational::new(n, d), 6, 3);
        assert_eq!([text(1, 3), text(-2, 3), text(7, 1)], ["0.333333", "-0.666667", "7.000000"]);
        assert_eq!([text(0, 1), text(1, 1000), text(1999, 2)], ["0.000000", "0.001000", "999.500000"]);
        assert_eq!([text(1, 30_000), text(-1, 3_000_000)], ["3.333e-5", "-3.333e-7"]);
        assert_eq!([text(99_999, 100_000_000), text(1, 10_000)], ["1.000e-3", "1.000e-4"]);
    }

    #[test]
    fn small_numbers_are_those_of_floats() {
        for k in 1..200 {
            let float = 0.7_f64.powi(k) / 1024.0;
            let mut x = Rational::new(1, 1024);
            for _ in 0..k {
                x = &x * &Rational::new(7, 10);
            }
            assert_eq!(scientific(&x, 5), format!("{float:.5e}"));
        }
    }
}
