//! Statements from text, so that tests read like mathematics: variables x0, x1, …, simplices as `x0 + x1 + rest = 1`.

use std::rc::Rc;

use basis_kernel::algebra::poly::{Poly, Var};
use basis_kernel::algebra::range::{End, Range, Region};
use basis_kernel::algebra::rational::Rational;
use basis_kernel::{Domain, Quotient, Relation, Simplex, Statement};

/// A polynomial such as `(3*x0 - 1)^2/4 + x1`.
pub(crate) fn poly(text: &str) -> Poly {
    let mut parser = Parser { rest: text };
    let result = parser.sum();
    assert_eq!(parser.peek(), None, "all of {text} is read");
    result
}

/// A box such as `0 <= x0 <= 1, 0 < x1`.
pub(crate) fn region(text: &str) -> Region {
    let parts = text.split(',').map(str::trim).filter(|s| !s.is_empty());
    Region { ranges: parts.map(range).collect() }
}

fn range(text: &str) -> (Var, Range) {
    let words: Vec<&str> = text.split_whitespace().collect();
    let at = words.iter().position(|w| w.starts_with('x')).expect("a variable");
    let end = |relation: &str, x: &str| {
        let x = Rational::from_big(x.trim().parse().expect("a number"));
        if relation == "<" { End::Excluded(x) } else { End::Included(x) }
    };
    let low = if at == 2 { end(words[1], words[0]) } else { End::Infinite };
    let high = words.get(at + 1).map_or(End::Infinite, |relation| end(relation, words[at + 2]));
    (Var(words[at][1..].parse().expect("a number")), Range { low, high })
}

/// A domain: ranges, and simplices such as `simplex x0 x1`.
pub(crate) fn domain(text: &str) -> Domain {
    let (simplices, ranges): (Vec<&str>, Vec<&str>) =
        text.split(',').map(str::trim).partition(|s| s.starts_with("simplex"));
    let simplices = simplices.into_iter().map(|s| {
        let variables = s.split_whitespace().skip(1).map(|v| Var(v[1..].parse().expect("a number")));
        Simplex { variables: variables.collect(), sum: Rational::ONE }
    });
    Domain { region: region(&ranges.join(",")), simplices: simplices.collect(), premises: Vec::new() }
}

/// A claim such as `x0^2/(1 + x0) >= 0` on a domain.
pub(crate) fn sign(claim: &str, on: &str) -> Rc<Statement> {
    let (text, relation) = match claim.split_once(">=") {
        Some((text, _)) => (text, Relation::NonNegative),
        None => (claim.split_once('>').expect("a relation").0, Relation::Positive),
    };
    let (above, below) = text.split_once("//").unwrap_or((text, "1"));
    let value = Quotient { numerator: poly(above), denominator: poly(below) };
    Rc::new(Statement::Sign { value, relation, domain: Rc::new(domain(on)) })
}

struct Parser<'t> {
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
            self.rest = &self.rest[1..];
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
                let number = self.power().as_constant().and_then(|c| c.recip()).expect("a number");
                result = result.scale(&number);
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
        if self.accept('x') {
            return Poly::var(Var(self.number().to_i64().expect("small") as usize));
        }
        Poly::constant(self.number())
    }

    fn number(&mut self) -> Rational {
        self.peek();
        let end = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
        let (digits, rest) = self.rest.split_at(end);
        self.rest = rest;
        Rational::from_big(digits.trim().parse().expect("a number"))
    }
}
