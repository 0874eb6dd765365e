//! Numbers, polynomials, ranges and coordinates as text, and back: only the one text that would be written is read.

use basis_engine::algebra::algebraic::Algebraic;
use basis_engine::algebra::poly::{Monomial, Poly, Var};
use basis_engine::algebra::range::{End, Range, Region};
use basis_engine::algebra::rational::Rational;
use basis_engine::algebra::univariate::Univariate;
use basis_engine::decide::Coordinate;

/// The longest number in a certificate; longer ones are refused before any arithmetic.
const MAX_DIGITS: usize = 20_000;

/// A number such as `-3/2`.
pub(super) fn number(text: &str) -> Result<Rational, String> {
    if text.len() > MAX_DIGITS {
        return Err(format!("a number has {} digits; the most is {MAX_DIGITS}", text.len()));
    }
    let number = Rational::parse(text).filter(|x| x.to_string() == text);
    number.ok_or_else(|| format!("`{}` is not a number in lowest terms", shortened(text)))
}

/// The beginning of a text, for messages.
fn shortened(text: &str) -> String {
    match text.char_indices().nth(100) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_string(),
    }
}

/// A polynomial such as `1 - 3*t + λ*t^2` in named variables.
pub(super) fn polynomial(text: &str, names: &[String]) -> Result<Poly, String> {
    let wrong = || format!("`{}` is not an expanded polynomial in {}", shortened(text), names.join(", "));
    let mut poly = Poly::zero();
    let (mut negative, mut rest) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text),
    };
    loop {
        let next = rest.find(" + ").into_iter().chain(rest.find(" - ")).min();
        let (monomial, coefficient) = term(&rest[..next.unwrap_or(rest.len())], names).ok_or_else(wrong)?;
        poly.add_term(monomial, &if negative { -coefficient } else { coefficient });
        let Some(at) = next else { break };
        negative = rest[at..].starts_with(" - ");
        rest = &rest[at + 3..];
    }
    if poly.display(names).to_string() == text { Ok(poly) } else { Err(wrong()) }
}

/// A product such as `3/2*λ*t^2`.
fn term(text: &str, names: &[String]) -> Option<(Monomial, Rational)> {
    let mut monomial = Monomial::one();
    let mut coefficient = Rational::ONE;
    for (k, factor) in text.split('*').enumerate() {
        if k == 0 && factor.starts_with(|c: char| c.is_ascii_digit()) {
            if factor.len() > MAX_DIGITS {
                return None;
            }
            coefficient = Rational::parse(factor)?;
            continue;
        }
        let (name, exponent) = match factor.split_once('^') {
            Some((name, exponent)) => (name, exponent.parse::<u16>().ok()?),
            None => (factor, 1),
        };
        let var = Var(names.iter().position(|n| n == name)?);
        if exponent == 0 || monomial.exponent(var) > 0 {
            return None;
        }
        monomial = monomial.with_exponent(var, exponent);
    }
    Some((monomial, coefficient))
}

/// The name at the place of a variable.
pub(super) fn name(names: &[String], var: Var) -> &str {
    names.get(var.0).map_or("?", String::as_str)
}

/// The variable of a name.
pub(super) fn variable(text: &str, names: &[String]) -> Result<Var, String> {
    names.iter().position(|n| n == text).map(Var).ok_or_else(|| format!("there is no variable `{text}`"))
}

/// A range such as `-3 <= λ < 1`, with its variable.
pub(super) fn range(text: &str, names: &[String]) -> Result<(Var, Range), String> {
    let wrong = || format!("`{text}` is not a range such as `0 <= t <= 1`");
    // Names may hold spaces, as `dot(P[0], P[1])` does.
    let (mut parts, mut rest) = (Vec::new(), text);
    while let Some((at, sign)) = [" <= ", " < "].iter().filter_map(|s| Some((rest.find(s)?, *s))).min() {
        parts.extend([&rest[..at], sign.trim()]);
        rest = &rest[at + sign.len()..];
    }
    parts.push(rest);
    let end = |sign: &str, x: &str| match sign {
        "<=" => number(x).map(End::Included),
        "<" => number(x).map(End::Excluded),
        _ => Err(wrong()),
    };
    let (name, low, high) = match parts[..] {
        [name] => (name, End::Infinite, End::Infinite),
        [name, sign, high] if names.iter().any(|n| n == name) => (name, End::Infinite, end(sign, high)?),
        [low, sign, name] => (name, end(sign, low)?, End::Infinite),
        [low, first, name, second, high] => (name, end(first, low)?, end(second, high)?),
        _ => return Err(wrong()),
    };
    let var = variable(name, names)?;
    let range = Range { low, high };
    if range.display(name).to_string() == text { Ok((var, range)) } else { Err(wrong()) }
}

/// A box as the texts of its ranges.
pub(super) fn region<'t>(texts: impl Iterator<Item = &'t str>, names: &[String]) -> Result<Region, String> {
    let ranges: Vec<(Var, Range)> = texts.map(|t| range(t, names)).collect::<Result<_, _>>()?;
    if ranges.windows(2).all(|w| w[0].0 < w[1].0) {
        Ok(Region { ranges })
    } else {
        Err(String::from("the ranges of a box are not in the order of the variables"))
    }
}

/// A coordinate as it is written in witnesses: a number, or `root of -2 + t^2 between 1.414 and 1.415`.
pub(crate) fn coordinate_text(coordinate: &Coordinate, name: &str) -> String {
    // A coordinate describes itself as `λ = 1/2`; only the value is wanted here.
    let text = coordinate.describe(name);
    text.strip_prefix(&format!("{name} = ")).unwrap_or(&text).to_string()
}

/// Reads a coordinate.
pub(super) fn coordinate(text: &str, name: &str) -> Result<Coordinate, String> {
    let Some(root) = text.strip_prefix("root of ") else { return number(text).map(Coordinate::Rational) };
    let wrong = || format!("`{}` is not a root of a polynomial between two numbers", shortened(text));
    let (poly, ends) = root.split_once(" between ").ok_or_else(wrong)?;
    let (low, high) = ends.split_once(" and ").ok_or_else(wrong)?;
    let poly = polynomial(poly, &[name.to_string()])?;
    if low.len().max(high.len()) > MAX_DIGITS {
        return Err(wrong());
    }
    let ends = Rational::parse(low).zip(Rational::parse(high));
    let found = Univariate::from_poly(&poly, Var(0)).zip(ends);
    let found = found.and_then(|(p, (low, high))| Algebraic::new(&p, low, high)).map(Coordinate::Algebraic);
    found.filter(|c| coordinate_text(c, name) == text).ok_or_else(wrong)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_canonical_texts_are_read() {
        let names = ["λ".to_string(), "t".to_string()];
        for text in ["0", "1", "-1/2", "1 - 3*t + λ*t^2", "-λ*t", "3/2*λ^2*t - 7"] {
            let read = polynomial(text, &names);
            let shown = read.as_ref().map(|p| p.display(&names).to_string());
            assert!(shown.is_err() || shown == Ok(text.to_string()), "{text}");
        }
        for text in ["1 - 3*t + λ*t^2", "-1/2", "0"] {
            assert!(polynomial(text, &names).is_ok(), "{text}");
        }
        for text in [
            "", "x", "2/4", "t*t", "t^0", "1 + 1", "t + λ", "1 -t", "1 - ", "--1", "1*2", "t^70000", "1/0",
            "+1",
        ] {
            assert!(polynomial(text, &names).is_err(), "{text}");
        }
        for text in ["0 <= t <= 1", "-3 < λ <= 1", "λ", "0 < λ", "λ <= 1/2"] {
            let (var, range) = range(text, &names).expect(text);
            assert_eq!(range.display(name(&names, var)).to_string(), text);
        }
        for text in ["0 <= t <= 2/2", "0 <= x <= 1", "0 >= t", "0 <= t <=", "", "0 <= t < 1 < 2"] {
            assert!(range(text, &names).is_err(), "{text}");
        }
        let text = "root of -2 + t^2 between 1.414 and 1.415";
        assert_eq!(coordinate_text(&coordinate(text, "t").expect("a root"), "t"), text);
        for text in ["root of -2 + t^2 between 1 and 1.4", "root of t", "1/0", "root of 2 between 0 and 1"] {
            assert!(coordinate(text, "t").is_err(), "{text}");
        }
    }
}
