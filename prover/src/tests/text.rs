//! Polynomials and ranges from text, so that tests read like mathematics.

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::{self, Rational};

/// The names of the variables 0, 1, …
pub(super) const NAMES: [&str; 5] = ["t", "λ", "μ", "f", "w"];

/// The variable of a name.
pub(super) fn var(name: &str) -> Var {
    Var(NAMES.iter().position(|n| *n == name).unwrap_or_else(|| panic!("no variable {name}")))
}

/// A polynomial such as `(3*t - 1)^2 + 1/2*λ`.
pub(super) fn poly(text: &str) -> Poly {
    let chars: Vec<char> = text.chars().filter(|c| !c.is_whitespace()).collect();
    let mut parser = Parser { chars, at: 0 };
    let result = parser.sum();
    assert_eq!(parser.at, parser.chars.len(), "all of {text} is read");
    result
}

/// A box such as `0<=t<=1, 0<λ`.
pub(super) fn region(text: &str) -> Region {
    let mut ranges: Vec<(Var, Range)> = text.split(',').filter(|s| !s.trim().is_empty()).map(range).collect();
    ranges.sort_by_key(|(v, _)| *v);
    Region { ranges }
}

fn range(text: &str) -> (Var, Range) {
    let mut parts: Vec<(bool, &str)> = Vec::new();
    let mut strict = false;
    for piece in text.split('<') {
        let rest = piece.strip_prefix('=');
        if !parts.is_empty() {
            strict = rest.is_none();
        }
        parts.push((strict, rest.unwrap_or(piece).trim()));
    }
    let k = parts.iter().position(|(_, s)| NAMES.contains(s)).expect("a variable");
    let end = |strict: bool, s: &str| {
        let x = rational::parse(s).expect("a number");
        if strict { End::Excluded(x) } else { End::Included(x) }
    };
    let low = if k == 1 { end(parts[1].0, parts[0].1) } else { End::Infinite };
    let high = parts.get(k + 1).map_or(End::Infinite, |(strict, s)| end(*strict, s));
    (var(parts[k].1), Range { low, high })
}

struct Parser {
    chars: Vec<char>,
    at: usize,
}

impl Parser {
    fn accept(&mut self, c: char) -> bool {
        let found = self.chars.get(self.at) == Some(&c);
        self.at += usize::from(found);
        found
    }

    fn sum(&mut self) -> Poly {
        let mut result = if self.accept('-') { -&self.product() } else { self.product() };
        loop {
            if self.accept('+') {
                result = &result + &self.product();
            } else if self.accept('-') {
                result = &result - &self.product();
            } else {
                return result;
            }
        }
    }

    fn product(&mut self) -> Poly {
        let mut result = self.power();
        loop {
            if self.accept('*') {
                result = &result * &self.power();
            } else if self.accept('/') {
                let divisor = self.power().as_constant().and_then(|c| c.recip()).expect("a number");
                result = result.scale(&divisor);
            } else {
                return result;
            }
        }
    }

    fn power(&mut self) -> Poly {
        let base = self.atom();
        if self.accept('^') { base.pow(self.number().to_i64().expect("small") as u32) } else { base }
    }

    fn atom(&mut self) -> Poly {
        if self.accept('(') {
            let inner = self.sum();
            assert!(self.accept(')'));
            return inner;
        }
        let name = self.chars[self.at].to_string();
        if NAMES.contains(&name.as_str()) {
            self.at += 1;
            return Poly::var(var(&name));
        }
        Poly::constant(self.number())
    }

    fn number(&mut self) -> Rational {
        let start = self.at;
        while self.chars.get(self.at).is_some_and(|c| c.is_ascii_digit() || *c == '.') {
            self.at += 1;
        }
        rational::parse(&self.chars[start..self.at].iter().collect::<String>()).expect("a number")
    }
}
