//! The kernel's rational numbers, and how a user writes them.

pub use basis_kernel::algebra::rational::Rational;

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
}
