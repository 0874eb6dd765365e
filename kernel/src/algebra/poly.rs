//! Sparse polynomials in any number of variables over the rationals.

use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, Mul, Neg, Sub};

use super::done::did;
use super::fibre::{Change, Step};
pub use super::monomial::{Monomial, Var};
use super::rational::Rational;
use crate::collections::list::Mapped;
use crate::collections::sort::sort_by;

/// A monomial with its coefficient.
type Term = (Monomial, Rational);

/// A polynomial: monomials with their coefficients, none of them zero, in increasing order of monomials.
///
/// Multiplication by a monomial keeps that order, so nearly everything is merging of sorted lists.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Poly {
    terms: Vec<Term>,
}

/// A divisor with as many terms beside the first one takes them away one by one.
const FEW: usize = 6;

/// The sum of two polynomials.
fn merge(a: Vec<Term>, b: Vec<Term>) -> Vec<Term> {
    let is_before = |a: &[Term], b: &[Term]| a.last().zip(b.first()).is_none_or(|(x, y)| x.0 < y.0);
    let (mut low, mut high) = if is_before(&b, &a) { (b, a) } else { (a, b) };
    if is_before(&low, &high) {
        low.append(&mut high);
        return low;
    }
    combined(&low, &high, false)
}

/// The sum or the difference of two polynomials that are kept.
fn combined(a: &[Term], b: &[Term], minus: bool) -> Vec<Term> {
    did(5 + (a.len() + b.len()) as u64 / 2);
    let of_b = |(m, c): &Term| (m.clone(), if minus { -c } else { c.clone() });
    let mut sum = Vec::with_capacity(a.len() + b.len());
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        let ((m, c), (n, d)) = (&a[i], &b[j]);
        let order = m.cmp(n);
        match order {
            Ordering::Less => sum.push((m.clone(), c.clone())),
            Ordering::Greater => sum.push(of_b(&b[j])),
            Ordering::Equal => {
                let value = if minus { c - d } else { c + d };
                if !value.is_zero() {
                    sum.push((m.clone(), value));
                }
            }
        }
        i += usize::from(order.is_le());
        j += usize::from(order.is_ge());
    }
    sum.extend_from_slice(&a[i..]);
    sum.extend(b[j..].iter().map(of_b));
    sum
}

/// Adds a term to a polynomial.
fn add_term(sum: &mut Vec<Term>, (m, c): Term) {
    match sum.binary_search_by(|(n, _)| n.cmp(&m)) {
        Ok(k) => {
            sum[k].1 += &c;
            if sum[k].1.is_zero() {
                sum.remove(k);
            }
        }
        Err(k) => sum.insert(k, (m, c)),
    }
}

/// The sum of several polynomials, neighbours first.
fn merge_all(mut all: Vec<Vec<Term>>) -> Vec<Term> {
    while all.len() > 1 {
        let mut pairs = Vec::with_capacity(all.len().div_ceil(2));
        let mut rest = all.into_iter();
        while let Some(a) = rest.next() {
            pairs.push(merge(a, rest.next().unwrap_or_default()));
        }
        all = pairs;
    }
    all.pop().unwrap_or_default()
}

impl Poly {
    /// 0.
    pub const fn zero() -> Self {
        Self { terms: Vec::new() }
    }

    /// 1.
    pub fn one() -> Self {
        Self::constant(Rational::ONE)
    }

    /// A number.
    pub fn constant(value: Rational) -> Self {
        Self::term(Monomial::one(), value)
    }

    /// A whole number.
    pub fn integer(value: i64) -> Self {
        Self::constant(Rational::from(value))
    }

    /// A variable.
    pub fn var(var: Var) -> Self {
        Self::term(Monomial::one().with_exponent(var, 1), Rational::ONE)
    }

    /// One term.
    pub fn term(monomial: Monomial, coefficient: Rational) -> Self {
        if coefficient.is_zero() {
            return Self::zero();
        }
        Self { terms: vec![(monomial, coefficient)] }
    }

    /// The sum of the given terms.
    pub fn from_terms(terms: impl IntoIterator<Item = (Monomial, Rational)>) -> Self {
        // Terms often come in order, or in a few ordered runs.
        let mut runs: Vec<Vec<Term>> = vec![Vec::new()];
        for term in terms {
            did(4);
            if term.1.is_zero() {
                continue;
            }
            let last = runs.len() - 1;
            if runs[last].last().is_some_and(|(m, _)| *m >= term.0) {
                runs.push(vec![term]);
            } else {
                runs[last].push(term);
            }
        }
        Self { terms: merge_all(runs) }
    }

    /// The terms, in increasing order of monomials.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &Rational)> + ExactSizeIterator {
        self.terms.iter().map(|(m, c)| (m, c))
    }

    /// The number of terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether the polynomial is 0.
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether the polynomial is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether the polynomial is the number 1.
    pub fn is_one(&self) -> bool {
        matches!(self.terms.as_slice(), [(m, c)] if m.is_one() && c.is_one())
    }

    /// The number that the polynomial is, if no variable occurs.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.terms.len() {
            0 => Some(Rational::ZERO),
            1 if self.terms[0].0.is_one() => Some(self.terms[0].1.clone()),
            _ => None,
        }
    }

    /// The term with the greatest monomial.
    pub fn leading_term(&self) -> Option<(&Monomial, &Rational)> {
        self.terms.last().map(|(m, c)| (m, c))
    }

    /// The highest exponent of a variable; 0 for the zero polynomial.
    pub fn degree(&self, var: Var) -> u32 {
        let mut degree = 0;
        for (m, _) in &self.terms {
            degree = m.exponent(var).max(degree);
        }
        u32::from(degree)
    }

    /// The highest sum of exponents; 0 for the zero polynomial.
    pub fn total_degree(&self) -> u32 {
        self.terms.iter().map(|(m, _)| m.total_degree()).max().unwrap_or(0)
    }

    /// The variables that occur, in increasing order.
    pub fn variables(&self) -> Vec<Var> {
        let mut width = 0;
        for (m, _) in &self.terms {
            width = m.width().max(width);
        }
        (0..width).map(Var).filter(|v| self.depends_on(*v)).collect()
    }

    /// Whether a variable occurs.
    pub fn depends_on(&self, var: Var) -> bool {
        self.terms.iter().any(|(m, _)| m.exponent(var) > 0)
    }

    /// The size of the largest coefficient in bits: the work that arithmetic costs.
    pub fn max_bits(&self) -> u64 {
        let mut bits = 0;
        for (_, c) in &self.terms {
            bits = c.bits().max(bits);
        }
        bits
    }

    /// The polynomial times a number.
    pub fn scale(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Self::zero();
        }
        Self { terms: self.times(&Monomial::one(), factor) }
    }

    /// The power with a whole exponent.
    pub fn pow(&self, exponent: u32) -> Self {
        // Two terms are the common case (1 − t): xᵉ with their sum in place of x.
        if let ([a, b], Ok(e)) = (&self.terms[..], u16::try_from(exponent)) {
            let (x, one) = (Var(0), Monomial::one());
            return Self::term(one.with_exponent(x, e), Rational::ONE).substitute_binomial(x, a, b);
        }
        let (mut result, mut base, mut e) = (Self::one(), self.clone(), exponent);
        while e > 0 {
            if e & 1 == 1 {
                result = &result * &base;
            }
            e >>= 1;
            if e > 0 {
                base = &base * &base;
            }
        }
        result
    }

    /// The partial derivative in a variable.
    pub fn derivative(&self, var: Var) -> Self {
        let mut terms = Vec::new();
        for (m, c) in &self.terms {
            let e = m.exponent(var);
            if e > 0 {
                terms.push((m.with_exponent(var, e - 1), c * &Rational::from(i64::from(e))));
            }
        }
        Self { terms }
    }

    /// The polynomial with a number put in place of a variable.
    pub fn at(&self, var: Var, value: &Rational) -> Self {
        if value.is_zero() {
            let without = self.terms.iter().filter(|(m, _)| m.exponent(var) == 0);
            return Self { terms: without.cloned().collect() };
        }
        let mut powers = vec![Rational::ONE];
        Self::from_terms(self.terms.iter().map(|(m, c)| {
            let e = usize::from(m.exponent(var));
            while powers.len() <= e {
                powers.push(&powers[powers.len() - 1] * value);
            }
            if e == 0 { (m.clone(), c.clone()) } else { (m.with_exponent(var, 0), c * &powers[e]) }
        }))
    }

    /// The polynomial with another put in place of a variable.
    pub fn substitute(&self, var: Var, value: &Self) -> Self {
        if let Some(c) = value.as_constant() {
            return self.at(var, &c);
        }
        if !self.depends_on(var) {
            return self.clone();
        }
        let (mut terms, mut last) = (Vec::new(), Vec::new());
        for term in &value.terms {
            (if term.0.exponent(var) == 0 { &mut terms } else { &mut last }).push(term);
        }
        let own = last.len();
        terms.append(&mut last);
        match terms[..] {
            [only] => self.substitute_term(var, only),
            // One term after the other: x + c for x, and at last a + b.
            [.., a, b] if terms.len() <= 4 && own <= 1 => {
                let x = (Monomial::one().with_exponent(var, 1), Rational::ONE);
                let moved = terms[..terms.len() - 2]
                    .iter()
                    .fold(self.clone(), |moved, c| moved.substitute_binomial(var, c, &x));
                moved.substitute_binomial(var, a, b)
            }
            _ => {
                let mut result = Self::zero();
                for coefficient in self.coefficients_in(var).iter().rev() {
                    result = &(&result * value) + coefficient;
                }
                result
            }
        }
    }

    /// The polynomial with a·m + b·n, two numbers and two monomials, put in place of a variable.
    fn substitute_binomial(&self, var: Var, (m, a): &Term, (n, b): &Term) -> Self {
        let degree = self.degree(var) as usize;
        let powers = |m: &Monomial| {
            let mut all = vec![Monomial::one()];
            for k in 0..degree {
                all.push(all[k].mul(m));
            }
            all
        };
        let (of_m, of_n) = (powers(m), powers(n));
        // r·xᵉ becomes Σ binomial(e, k)·aᵉ⁻ᵏ·bᵏ·r·mᵉ⁻ᵏ·nᵏ: terms with the same r·mᵉ are a polynomial in one variable.
        let mut keyed: Vec<(Monomial, usize, &Rational)> = self.terms.mapped(|(monomial, c)| {
            let e = usize::from(monomial.exponent(var));
            (monomial.with_exponent(var, 0).mul(&of_m[e]), e, c)
        });
        sort_by(&mut keyed, |a, b| a.0.cmp(&b.0));
        let mut fibres: Vec<(Monomial, Vec<Rational>)> = Vec::new();
        for (key, e, c) in keyed {
            if fibres.last().is_none_or(|(last, _)| *last != key) {
                fibres.push((key, vec![Rational::ZERO; degree + 1]));
            }
            if let Some((_, fibre)) = fibres.last_mut() {
                fibre[e] = c.clone();
            }
        }
        let steps = [Step::Shift(a.clone()), Step::Powers(b.clone())];
        let mut change = Change::new(&steps, self.terms.iter().map(|(_, c)| c), degree + 1);
        let mut terms = Vec::with_capacity(self.len());
        for (key, mut fibre) in fibres {
            change.apply(&mut fibre);
            for (k, c) in fibre.into_iter().enumerate() {
                // The fibre has a term with r·mᵉ and e ≥ k.
                if let Some(rest) = key.checked_div(&of_m[k]) {
                    terms.push((rest.mul(&of_n[k]), c));
                }
            }
        }
        Self::from_terms(terms)
    }

    /// The polynomial with a number times a monomial put in place of a variable.
    fn substitute_term(&self, var: Var, (m, a): &Term) -> Self {
        let (mut monomials, mut numbers) = (vec![Monomial::one()], vec![Rational::ONE]);
        for k in 0..self.degree(var) as usize {
            monomials.push(monomials[k].mul(m));
            numbers.push(&numbers[k] * a);
        }
        Self::from_terms(self.terms.mapped(|(n, c)| {
            let e = usize::from(n.exponent(var));
            (n.with_exponent(var, 0).mul(&monomials[e]), c * &numbers[e])
        }))
    }

    /// The coefficients c₀, c₁, … as a polynomial in one variable; at least one, possibly zero.
    pub fn coefficients_in(&self, var: Var) -> Vec<Self> {
        let mut result = vec![Self::zero(); self.degree(var) as usize + 1];
        for (m, c) in &self.terms {
            let e = usize::from(m.exponent(var));
            let rest = if e == 0 { m.clone() } else { m.with_exponent(var, 0) };
            result[e].terms.push((rest, c.clone()));
        }
        result
    }

    /// The quotient, if `divisor` divides without remainder; `None` also for division by 0.
    pub fn div_exact(&self, divisor: &Self) -> Option<Self> {
        let (lead, lead_coefficient) = divisor.leading_term()?;
        if let Some(c) = divisor.as_constant() {
            return Some(self.scale(&c.recip()?));
        }
        // Terms that are few find their places one by one; many are merged with the rest.
        let others = &divisor.terms[..divisor.len() - 1];
        let few = others.len() <= FEW;
        let mut rest = self.terms.clone();
        let mut quotient = Vec::new();
        while let Some((m, c)) = rest.pop() {
            let factor = (m.checked_div(lead)?, &c / lead_coefficient);
            let product = others.mapped(|(n, d)| (n.mul(&factor.0), -&(d * &factor.1)));
            if few {
                product.into_iter().rev().for_each(|term| add_term(&mut rest, term));
            } else {
                rest = merge(rest, product);
            }
            quotient.push(factor);
        }
        quotient.reverse();
        Some(Self { terms: quotient })
    }

    /// The terms of the polynomial times a term.
    fn times(&self, monomial: &Monomial, coefficient: &Rational) -> Vec<Term> {
        did(5 + 3 * self.len() as u64);
        self.terms.mapped(|(m, c)| (m.mul(monomial), c * coefficient))
    }

    /// The positive number by which all coefficients can be divided to become whole without a common factor; 0 for 0.
    pub fn numeric_content(&self) -> Rational {
        self.terms.iter().fold(Rational::ZERO, |g, (_, c)| g.gcd(c))
    }

    /// The polynomial divided by its numeric content, with a positive leading coefficient.
    pub fn normalized(&self) -> Self {
        let Some((_, lead)) = self.leading_term() else { return Self::zero() };
        let content = self.numeric_content();
        let factor = if lead.is_negative() { -content } else { content };
        factor.recip().map_or_else(Self::zero, |f| self.scale(&f))
    }

    /// The polynomial for reading, with these names of the variables.
    pub fn display<'a>(&'a self, names: &'a [String]) -> impl fmt::Display + 'a {
        DisplayPoly { poly: self, names }
    }
}

impl Neg for &Poly {
    type Output = Poly;
    fn neg(self) -> Poly {
        Poly { terms: self.terms.mapped(|(m, c)| (m.clone(), -c)) }
    }
}

impl Add for &Poly {
    type Output = Poly;
    fn add(self, other: &Poly) -> Poly {
        Poly { terms: combined(&self.terms, &other.terms, false) }
    }
}

impl Sub for &Poly {
    type Output = Poly;
    fn sub(self, other: &Poly) -> Poly {
        Poly { terms: combined(&self.terms, &other.terms, true) }
    }
}

impl Mul for &Poly {
    type Output = Poly;
    fn mul(self, other: &Poly) -> Poly {
        let (few, many) = if self.len() < other.len() { (self, other) } else { (other, self) };
        if few.is_one() {
            return many.clone();
        }
        Poly { terms: merge_all(few.terms.mapped(|(m, c)| many.times(m, c))) }
    }
}

struct DisplayPoly<'a> {
    poly: &'a Poly,
    names: &'a [String],
}

impl fmt::Display for DisplayPoly<'_> {
    /// Terms by increasing total degree, as in `1 + λ*t^2`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut terms: Vec<_> = self.poly.terms().collect();
        sort_by(&mut terms, |(m, _), (n, _)| m.total_degree().cmp(&n.total_degree()).then_with(|| n.cmp(m)));
        if terms.is_empty() {
            return write!(f, "0");
        }
        for (k, (m, c)) in terms.into_iter().enumerate() {
            let sign = [["", "-"], [" + ", " - "]][k.min(1)][usize::from(c.is_negative())];
            let mut factors = Vec::new();
            let magnitude = c.abs();
            if !magnitude.is_one() || m.is_one() {
                factors.push(magnitude.to_string());
            }
            for (i, e) in m.exponents().iter().enumerate().filter(|(_, e)| **e > 0) {
                let name = self.names.get(i).map_or_else(|| format!("x{i}"), Clone::clone);
                factors.push(if *e == 1 { name } else { format!("{name}^{e}") });
            }
            write!(f, "{sign}{}", factors.join("*"))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn x() -> Poly {
        Poly::var(Var(0))
    }
    fn y() -> Poly {
        Poly::var(Var(1))
    }
    fn z() -> Poly {
        Poly::var(Var(2))
    }
    fn w() -> Poly {
        Poly::var(Var(3))
    }
    fn names() -> Vec<String> {
        vec!["x".into(), "y".into()]
    }

    #[test]
    fn expands_and_prints() {
        let p = &(&x() + &y()).pow(2) - &Poly::integer(3);
        assert_eq!(p.display(&names()).to_string(), "-3 + x^2 + 2*x*y + y^2");
        assert_eq!((&p - &p).display(&names()).to_string(), "0");
    }

    #[test]
    fn divides_exactly_or_not() {
        let a = &x() - &y();
        let b = &x().pow(2) - &y().pow(2);
        assert_eq!(b.div_exact(&a), Some(&x() + &y()));
        assert_eq!(a.div_exact(&b), None);
        assert_eq!(a.div_exact(&Poly::zero()), None);
    }

    #[test]
    fn substitutes_and_differentiates() {
        let p = &x().pow(3) * &y();
        assert_eq!(p.derivative(Var(0)), (&x().pow(2) * &y()).scale(&Rational::from(3)));
        let q = p.substitute(Var(0), &(&Poly::one() - &y()));
        let at = q.at(Var(0), &Rational::ZERO).at(Var(1), &Rational::new(1, 2));
        assert_eq!(at, Poly::constant(Rational::new(1, 16)));
        // Values of every shape, against the sum of the powers with their coefficients.
        let p = &(&x().pow(3) * &y()) + &(&x().pow(2) - &(&y().pow(2) * &z()));
        let values = [
            &Poly::integer(2) - &x(),
            &(&z() * &x()) - &x(),
            &y() + &Poly::one(),
            &Poly::integer(3) - &(&z() * &w()),
            w().scale(&Rational::new(1, 2)),
            &Poly::one() - &w().pow(2),
            &(&Poly::one() - &y()).scale(&Rational::new(2, 3)) - &z(),
            Poly::integer(-2),
            Poly::zero(),
        ];
        for value in values {
            let powers = p.coefficients_in(Var(0)).into_iter().enumerate();
            let expected = powers.fold(Poly::zero(), |sum, (k, c)| &sum + &(&c * &value.pow(k as u32)));
            assert_eq!(p.substitute(Var(0), &value), expected, "{p:?}");
            assert_eq!(p.substitute(Var(3), &w()), p);
        }
    }

    #[test]
    fn content_makes_coefficients_whole() {
        let p = Poly::from_terms([
            (Monomial::new(vec![1]), Rational::new(-2, 3)),
            (Monomial::one(), Rational::new(4, 9)),
        ]);
        assert_eq!(p.numeric_content(), Rational::new(2, 9));
        assert_eq!(p.normalized().display(&names()).to_string(), "-2 + 3*x");
    }
}
