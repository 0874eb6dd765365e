//! Polynomials and ranges from text, so that tests read like mathematics.

use basis_kernel::algebra::poly::{Poly, Var};
use basis_kernel::algebra::range::{End, Range, Region};
use basis_kernel::algebra::rational::Rational;

/// The names of the variables 0, 1, … of a test.
#[derive(Clone, Copy, Debug)]
pub struct Names(pub &'static [&'static str]);

impl Names {
    /// The variable of a name.
    ///
    /// # Panics
    /// When no variable has it.
    pub fn var(self, name: &str) -> Var {
        Var(self.0.iter().position(|n| *n == name).unwrap_or_else(|| panic!("no variable {name}")))
    }

    /// A polynomial such as `(3*t - 1)^2/4 + λ`.
    ///
    /// # Panics
    /// When the text is something else.
    pub fn poly(self, text: &str) -> Poly {
        let mut parser = Parser { names: self, rest: text };
        let result = parser.sum();
        assert_eq!(parser.peek(), None, "all of {text} is read");
        result
    }

    /// A box such as `0 <= t <= 1, 0 < λ`.
    ///
    /// # Panics
    /// When the text is something else.
    pub fn region(self, text: &str) -> Region {
        let parts = text.split(',').filter(|range| !range.trim().is_empty());
        let mut ranges: Vec<(Var, Range)> = parts.map(|range| self.range(range)).collect();
        ranges.sort_by_key(|(var, _)| *var);
        Region { ranges }
    }

    fn range(self, text: &str) -> (Var, Range) {
        let is_name = |part: &&str| self.0.contains(&part.trim_start_matches('=').trim());
        let parts: Vec<&str> = text.split('<').collect();
        let at = parts.iter().position(is_name).unwrap_or_else(|| panic!("no variable in {text}"));
        // What stands before `<`, or after it; a `=` belongs to the sign before it.
        let end = |number: &str, included: bool| {
            let x = Rational::parse(number.trim_start_matches('=').trim()).expect("a number");
            if included { End::Included(x) } else { End::Excluded(x) }
        };
        let low = if at == 1 { end(parts[0], parts[1].starts_with('=')) } else { End::Infinite };
        let high = parts.get(at + 1).map_or(End::Infinite, |part| end(part, part.starts_with('=')));
        (self.var(parts[at].trim_start_matches('=').trim()), Range { low, high })
    }
}

struct Parser<'t> {
    names: Names,
    rest: &'t str,
}

impl Parser<'_> {
    fn peek(&mut self) -> Option<char> {
        self.rest = self.rest.trim_start();
        self.rest.chars().next()
    }

    fn accept(&mut self, c: char) -> bool {
        let found = self.peek() == Some(c);
        if found {
            self.rest = &self.rest[c.len_utf8()..];
        }
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
            assert!(self.accept(')'), "a bracket is closed");
            return inner;
        }
        self.peek();
        let end = self.rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        if word.starts_with(char::is_alphabetic) {
            self.rest = rest;
            return Poly::var(self.names.var(word));
        }
        Poly::constant(self.number())
    }

    fn number(&mut self) -> Rational {
        self.peek();
        let end = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
        let (digits, rest) = self.rest.split_at(end);
        self.rest = rest;
        let whole = Rational::parse(digits).expect("a number");
        if !rest.starts_with('.') {
            return whole;
        }
        // After the point: its value is that of its digits over a power of ten.
        let rest = &rest[1..];
        let length = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        let tenth = Rational::new(1, 10).pow(length as u32);
        self.rest = rest;
        &whole + &(&self.number() * &tenth)
    }
}

#[cfg(test)]
mod tests {
    use super::{End, Names, Poly, Rational, Var};

    const NAMES: Names = Names(&["t", "λ", "x10"]);

    #[test]
    fn a_text_is_read_as_mathematics() {
        let (t, λ) = (Poly::var(Var(0)), Poly::var(Var(1)));
        assert_eq!(NAMES.poly("-t^2*λ + 1.50"), &-&(&(&t * &t) * &λ) + &Poly::constant(Rational::new(3, 2)));
        assert_eq!(
            NAMES.poly(" 2*(t - λ)*x10/4"),
            (&(&t - &λ) * &Poly::var(Var(2))).scale(&Rational::new(1, 2))
        );
        let region = NAMES.region("0 < λ, -1/2<=t<1");
        assert_eq!(region.ranges[0].0, Var(0));
        assert_eq!(region.ranges[0].1.low, End::Included(Rational::new(-1, 2)));
        assert_eq!(region.ranges[0].1.high, End::Excluded(Rational::ONE));
        assert_eq!(region.ranges[1].1.high, End::Infinite);
    }

    #[test]
    #[should_panic(expected = "no variable y")]
    fn another_name_is_refused() {
        NAMES.poly("t + y");
    }
}
