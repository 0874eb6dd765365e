//! The kernel's rational numbers, how a user writes them, and the floats next to them.

pub use basis_kernel::algebra::rational::Rational;

/// Floats, which the kernel knows nothing of.
pub trait ToFloat {
    /// The nearest float, of two that are as near the one with an even last digit.
    fn to_f64(&self) -> f64;
}

impl ToFloat for Rational {
    fn to_f64(&self) -> f64 {
        let power = |e: i64| {
            let size = Self::from(2).pow(e.unsigned_abs() as u32);
            if e < 0 { &Self::ONE / &size } else { size }
        };
        let size = self.numer().bits() as i64 - self.denom().bits() as i64; // 2^(size − 1) < |x| < 2^(size + 1)
        if size > 1024 {
            return if self.is_negative() { f64::NEG_INFINITY } else { f64::INFINITY };
        }
        // x in units of 2^unit: at least two bits more than a float has, of which the last also stands for all below it. No
        // float has bits below 2^−1074.
        let unit = (size - 56).max(-1076);
        let scaled = &self.abs() * &power(-unit);
        let whole = scaled.floor().to_i64().map_or(0, i64::unsigned_abs);
        let bits = whole | u64::from(!scaled.is_integer());
        let extra = (11 - i64::from(bits.leading_zeros())).max(-1074 - unit).max(2);
        let (kept, half) = (bits >> extra, 1 << (extra - 1));
        let round_up = bits & (2 * half - 1) > half - (kept & 1);
        let exponent = unit + extra;
        let power = if exponent < -1022 { 1 << (exponent + 1074) } else { ((exponent + 1023) as u64) << 52 };
        let size = (kept + u64::from(round_up)) as f64 * f64::from_bits(power);
        if self.is_negative() { -size } else { size }
    }
}

/// The number that a decimal literal such as `12`, `0.62` or `1_000` denotes, exactly; `None` if it is not one.
pub fn from_decimal(text: &str) -> Option<Rational> {
    let digits: String = text.chars().filter(|c| *c != '_').collect();
    let (whole, fraction) = digits.split_once('.').unwrap_or((&digits, ""));
    let all = format!("{whole}{fraction}");
    if all.is_empty() || !all.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    Rational::parse(&format!("{all}/1{}", "0".repeat(fraction.len())))
}

/// The fraction or decimal that a text such as `-3/4`, `2` or `0.5` denotes; `None` if it is not one.
pub fn parse(text: &str) -> Option<Rational> {
    let text = text.trim();
    let (negative, text) = match text.strip_prefix(['-', '−']) {
        Some(rest) => (true, rest.trim_start()),
        None => (false, text),
    };
    let magnitude = match text.split_once('/') {
        Some((n, d)) => {
            let (n, d) = (from_decimal(n.trim())?, from_decimal(d.trim())?);
            n.checked_div(&d)?
        }
        None => from_decimal(text)?,
    };
    Some(if negative { -magnitude } else { magnitude })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact() {
        assert_eq!(from_decimal("0.62"), Some(Rational::new(31, 50)));
        assert_eq!(from_decimal("1_000.5"), Some(Rational::new(2001, 2)));
        assert_eq!(from_decimal("1e3"), None);
        assert_eq!(parse(" -3/6 "), Some(Rational::new(-1, 2)));
        assert_eq!(parse("1/0"), None);
        assert_eq!(parse(""), None);
    }

    #[test]
    fn the_nearest_float_is_that_of_the_decimal_number() {
        let halves = ["9007199254740993", "9007199254740995", "18014398509481988.0001"];
        let ends =
            ["1.7976931348623157e308", "1.7976931348623158e308", "1.7976931348623159e308", "1e309", "-1e400"];
        let denormal = [
            "4.9e-324",
            "2.5e-324",
            "2.4e-324",
            "7.4e-324",
            "-7.5e-324",
            "2.2250738585072011e-308",
            "1e-310",
        ];
        for text in ["0", "0.1", "-0.3", "123456789.123456789e-20"]
            .iter()
            .chain(&halves)
            .chain(&ends)
            .chain(&denormal)
        {
            let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
            let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
            let digits = Rational::parse(&format!("{whole}{fraction}")).expect("a number");
            let exponent = exponent.parse::<i32>().expect("a number") - fraction.len() as i32;
            let power = Rational::from(10).pow(exponent.unsigned_abs());
            let exact = if exponent < 0 { &digits / &power } else { &digits * &power };
            assert_eq!(exact.to_f64(), text.parse::<f64>().expect("a float"), "{text}");
        }
    }
}
