//! Arithmetic in Q(θ) for a real algebraic number θ, with polynomials in θ as numbers.
//!
//! The polynomial m of θ need not be irreducible. When it turns out that a value has a common factor with m, one of the
//! two parts of m has the root θ, and takes the place of m: so a value is zero exactly if m divides it, and invertible
//! otherwise ("dynamic evaluation": J. Della Dora, C. Dicrescenzo, D. Duval 1985).

use super::algebraic::Algebraic;
use super::roots::isolate;
use crate::algebra::divisors::resultant::resultant;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::{ToPoly, Univariate};
use crate::algebra::work::Work;
use crate::collections::list::Mapped;

/// A number of the field: a polynomial in θ.
pub type Element = Univariate;

/// The field Q(θ).
#[derive(Clone, Debug)]
pub struct Field {
    root: Algebraic,
}

impl Field {
    /// The field of a number.
    pub const fn new(root: Algebraic) -> Self {
        Self { root }
    }

    /// The number θ.
    pub const fn root(&self) -> &Algebraic {
        &self.root
    }

    /// The element in the form with the lowest degree.
    pub fn reduce(&self, x: &Element, work: &mut Work) -> Option<Element> {
        x.modulo(self.root.polynomial(), work)
    }

    /// The product.
    pub fn mul(&self, x: &Element, y: &Element, work: &mut Work) -> Option<Element> {
        let bits = 1 + (x.max_bits() + y.max_bits()) / 64;
        work.spend((x.degree() + 1) as u64 * (y.degree() + 1) as u64 * bits)?;
        self.reduce(&x.mul(y), work)
    }

    /// Whether an element is zero; the polynomial of θ may lose a factor.
    pub fn is_zero(&mut self, x: &Element, work: &mut Work) -> Option<bool> {
        let x = self.reduce(x, work)?;
        if x.is_constant() {
            return Some(x.is_zero());
        }
        // Most values are seen not to be zero.
        let (low, high) = enclosure(&x, &self.root, work)?;
        if low.is_positive() || high.is_negative() {
            return Some(false);
        }
        self.split(&x, work)
    }

    /// Divides out of the polynomial of θ what it has in common with a value, or all else; whether the value is zero.
    fn split(&mut self, x: &Element, work: &mut Work) -> Option<bool> {
        let polynomial = self.root.polynomial();
        let common = x.gcd(polynomial, work)?;
        if common.is_constant() {
            return Some(false);
        }
        let (low, high) = (self.root.low().clone(), self.root.high().clone());
        let zero = common.sign_at(&low) * common.sign_at(&high) == -1;
        let part = if zero { common } else { polynomial.div_exact(&common)? };
        self.root = Algebraic::new(&part, low, high)?;
        Some(zero)
    }

    /// The inverse of an element that is not zero; the polynomial of θ may lose a factor.
    pub fn inverse(&mut self, x: &Element, work: &mut Work) -> Option<Element> {
        if let Some(inverse) = self.euclid(x, work)? {
            return Some(inverse);
        }
        // The value has a factor in common with the polynomial of θ, which does not vanish at θ.
        self.split(x, work)?;
        self.euclid(x, work)?
    }

    /// The inverse modulo the polynomial of θ, if there is one.
    #[expect(clippy::option_option, reason = "the work may be spent")]
    fn euclid(&self, x: &Element, work: &mut Work) -> Option<Option<Element>> {
        // r = s·x modulo m, for two neighbouring remainders r of Euclid's algorithm.
        let (mut r, mut s) = (self.root.polynomial().clone(), Univariate::default());
        let (mut next, mut factor) = (self.reduce(x, work)?, Univariate::integers(&[1]));
        while !next.is_constant() {
            let (quotient, rest) = divide(&r, &next, work)?;
            let product = self.mul(&quotient, &factor, work)?;
            let new = s.add(&product.scale(&Rational::from(-1)));
            (r, next) = (next, rest);
            (s, factor) = (factor, new);
        }
        Some(next.leading().recip().map(|inverse| factor.scale(&inverse)))
    }

    /// The value of a polynomial of the field at another element.
    pub fn compose(&self, outer: &Univariate, inner: &Element, work: &mut Work) -> Option<Element> {
        let mut value = Univariate::default();
        for c in outer.coefficients().iter().rev() {
            value = self.mul(&value, inner, work)?.add(&Univariate::new(vec![c.clone()]));
        }
        Some(value)
    }

    /// The value of a polynomial whose variables have these values; others do not occur.
    pub fn eval(&self, poly: &Poly, at: &[(Var, Element)], work: &mut Work) -> Option<Element> {
        let Some(var) = poly.variables().last().copied() else {
            return Some(Univariate::new(vec![poly.as_constant().unwrap_or(Rational::ZERO)]));
        };
        let (_, x) = at.iter().find(|(v, _)| *v == var)?;
        let mut value = Univariate::default();
        for coefficient in poly.coefficients_in(var).iter().rev() {
            let c = self.eval(coefficient, at, work)?;
            value = self.mul(&value, x, work)?.add(&c);
        }
        Some(value)
    }

    /// An element as a number with a polynomial and an interval of its own, or as a rational one.
    pub fn number(&self, x: &Element, work: &mut Work) -> Option<Result<Rational, Algebraic>> {
        match x.coefficients() {
            [] => return Some(Ok(Rational::ZERO)),
            [c] => return Some(Ok(c.clone())),
            [a, b] => return Some(Err(self.root.affine(a, b)?.tidy(work)?)),
            _ => {}
        }
        // A root of res(m(x), y − g(x)).
        let (x_var, y) = (Var(0), Var(1));
        let difference = &Poly::var(y) - &x.to_poly(x_var);
        let values = resultant(&self.root.polynomial().to_poly(x_var), &difference, x_var, work)?;
        let values = Univariate::from_poly(&values, y)?.square_free_part(work)?;
        let mut root = self.root.clone();
        loop {
            let (low, high) = enclosure(x, &root, work)?;
            let apart = low < high && values.sign_at(&low) * values.sign_at(&high) == -1;
            if apart && isolate(&values, Some(&low), Some(&high), work)?.len() == 1 {
                return Some(Err(Algebraic::new(&values, low, high)?.tidy(work)?));
            }
            let width = &(root.high() - root.low()) * &Rational::new(1, 4);
            root.refine_below(&width, work)?;
        }
    }

    /// A field with the elements of this one and another number: the field, what θ is in it, and what the number is.
    fn adjoin(&self, other: &Algebraic, work: &mut Work) -> Option<(Self, Element, Element)> {
        let (x, z) = (Var(0), Var(1));
        let (own, others) = (self.root.polynomial(), other.polynomial());
        // For all but finitely many k the numbers x + k·y are different for all pairs of roots.
        for k in 1..=32_i64 {
            let step = Rational::from(k);
            // (z − x)/k in place of the other number.
            let line = (&Poly::var(z) - &Poly::var(x)).scale(&step.recip()?);
            let second = others.to_poly(x).substitute(x, &line);
            let sums = Univariate::from_poly(&resultant(&own.to_poly(x), &second, x, work)?, z)?;
            let sums = sums.square_free_part(work)?;
            if sums.degree() != own.degree() * others.degree() {
                continue;
            }
            let (mut a, mut b) = (self.root.clone(), other.clone());
            let sum = loop {
                let low = a.low() + &(b.low() * &step);
                let high = a.high() + &(b.high() * &step);
                let apart = sums.sign_at(&low) * sums.sign_at(&high) == -1;
                if apart && isolate(&sums, Some(&low), Some(&high), work)?.len() == 1 {
                    break Algebraic::new(&sums, low, high)?;
                }
                for number in [&mut a, &mut b] {
                    let width = &(number.high() - number.low()) * &Rational::new(1, 4);
                    number.refine_below(&width, work)?;
                }
            };
            let mut field = Self::new(sum);
            // θ is the only common root of its polynomial and of the other one at (z − x)/k.
            let constant = |c: &Rational| Univariate::new(vec![c.clone()]);
            let first: Vec<Element> = own.coefficients().mapped(constant);
            let mut of_second = Vec::new();
            for c in second.coefficients_in(x) {
                of_second.push(field.reduce(&Univariate::from_poly(&c, z)?, work)?);
            }
            let [c, d] = &field.common_divisor(first, of_second, work)?[..] else { return None };
            let inverse = field.inverse(d, work)?;
            let theta = field.mul(&c.scale(&Rational::from(-1)), &inverse, work)?;
            let difference = Univariate::integers(&[0, 1]).add(&theta.scale(&Rational::from(-1)));
            let number = field.reduce(&difference.scale(&step.recip()?), work)?;
            return Some((field, theta, number));
        }
        None
    }

    /// The greatest common divisor of two polynomials with coefficients in the field, constant first.
    pub fn common_divisor(
        &mut self,
        mut a: Vec<Element>,
        mut b: Vec<Element>,
        work: &mut Work,
    ) -> Option<Vec<Element>> {
        self.trim(&mut a, work)?;
        self.trim(&mut b, work)?;
        while !b.is_empty() {
            let inverse = self.inverse(b.last()?, work)?;
            while a.len() >= b.len() {
                let top = a.pop()?;
                let factor = self.mul(&top, &inverse, work)?.scale(&Rational::from(-1));
                let shift = a.len() + 1 - b.len();
                for (k, c) in b.iter().take(b.len() - 1).enumerate() {
                    a[k + shift] = a[k + shift].add(&self.mul(c, &factor, work)?);
                }
                self.trim(&mut a, work)?;
            }
            (a, b) = (b, a);
        }
        Some(a)
    }

    /// Without leading coefficients that are zero.
    fn trim(&mut self, p: &mut Vec<Element>, work: &mut Work) -> Option<()> {
        while let Some(last) = p.last() {
            if !self.is_zero(last, work)? {
                break;
            }
            p.pop();
        }
        Some(())
    }

    /// Factors with which the sum of some rows of a matrix is zero: of the first row that depends on those before it,
    /// 1, and of these the others; nothing when all rows are independent. Rows are asked for one after the other.
    pub fn vanishing_combination(
        &mut self,
        count: usize,
        row: &RowOf<'_>,
        work: &mut Work,
    ) -> Option<Option<Vec<Element>>> {
        // Rows that are 1 in a column in which all later ones are made zero, each with what it is a combination of.
        let mut pivots: Vec<(usize, Vec<Element>, Vec<Element>)> = Vec::new();
        for k in 0..count {
            let mut entries = row(self, k, work)?;
            let mut own = vec![Univariate::default(); count];
            own[k] = Univariate::integers(&[1]);
            for (column, pivot, of) in &pivots {
                if entries[*column].is_zero() || self.is_zero(&entries[*column], work)? {
                    continue;
                }
                let factor = entries[*column].scale(&Rational::from(-1));
                let all = entries.iter_mut().chain(&mut own).zip(pivot.iter().chain(of));
                for (x, p) in all.filter(|(_, p)| !p.is_zero()) {
                    *x = x.add(&self.mul(p, &factor, work)?);
                }
            }
            let mut column = None;
            for (k, x) in entries.iter().enumerate() {
                if !self.is_zero(x, work)? {
                    column = Some(k);
                    break;
                }
            }
            let Some(column) = column else {
                return own.iter().map(|x| self.reduce(x, work)).collect::<Option<Vec<_>>>().map(Some);
            };
            let inverse = self.inverse(&entries[column], work)?;
            for x in entries.iter_mut().chain(&mut own).filter(|x| !x.is_zero()) {
                *x = self.mul(x, &inverse, work)?;
            }
            pivots.push((column, entries, own));
        }
        Some(None)
    }
}

/// A row of a matrix over a field, by its number; `None` when the work is spent.
pub type RowOf<'a> = dyn Fn(&Field, usize, &mut Work) -> Option<Vec<Element>> + 'a;

/// A field that contains all of some numbers, and what they are in it; `None` for no numbers, or when the work is
/// spent.
pub fn field_of(numbers: &[Algebraic], work: &mut Work) -> Option<(Field, Vec<Element>)> {
    let (first, others) = numbers.split_first()?;
    let mut field = Field::new(first.clone());
    let mut elements = vec![Univariate::integers(&[0, 1])];
    for other in others {
        let (larger, theta, new) = field.adjoin(other, work)?;
        for element in &mut elements {
            *element = larger.compose(element, &theta, work)?;
        }
        elements.push(new);
        field = larger;
    }
    Some((field, elements))
}

/// Quotient and remainder.
fn divide(a: &Univariate, b: &Univariate, work: &mut Work) -> Option<(Univariate, Univariate)> {
    let rest = a.modulo(b, work)?;
    let quotient = a.add(&rest.scale(&Rational::from(-1))).div_exact(b)?;
    Some((quotient, rest))
}

/// Bounds for the value of a polynomial at a number.
pub fn enclosure(p: &Univariate, at: &Algebraic, work: &mut Work) -> Option<(Rational, Rational)> {
    let mut bounds = (Rational::ZERO, Rational::ZERO);
    for c in p.coefficients().iter().rev() {
        work.spend(8 * (1 + (bounds.0.bits() + at.low().bits()) / 64))?;
        let products = [&bounds.0, &bounds.1].map(|a| [a * at.low(), a * at.high()]).concat();
        bounds = (products.iter().min()? + c, products.iter().max()? + c);
    }
    Some(bounds)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sqrt(n: i64, low: i64) -> Algebraic {
        let p = Univariate::integers(&[-n, 0, 1]);
        Algebraic::new(&p, Rational::from(low), Rational::from(low + 1)).expect("opposite signs")
    }

    #[test]
    fn a_field_of_two_numbers() {
        let work = &mut Work::unlimited();
        let (mut field, numbers) = field_of(&[sqrt(2, 1), sqrt(3, 1)], work).expect("a field");
        assert_eq!(field.root().polynomial().degree(), 4);
        let [a, b] = &numbers[..] else { panic!("two numbers") };
        for (x, n) in [(a, 2), (b, 3)] {
            let square = field.mul(x, x, work).expect("unlimited");
            assert_eq!(square, Univariate::integers(&[n]));
        }
        // √2·√3 is √6.
        let product = field.mul(a, b, work).expect("unlimited");
        let six = field.number(&product, work).expect("unlimited").expect_err("irrational");
        assert_eq!(six.to_string(), "root of -6 + x^2 between 2.449 and 2.45");
        // √8 is in the field of √2: the polynomial of degree 4 of their sum falls apart.
        let (mut small, numbers) = field_of(&[sqrt(2, 1), sqrt(8, 2)], work).expect("a field");
        let difference = numbers[1].add(&numbers[0].scale(&Rational::from(-2)));
        assert_eq!(small.is_zero(&difference, work), Some(true));
        assert_eq!(small.root().polynomial().degree(), 2);
        let inverse = field.inverse(a, work).expect("not zero");
        assert_eq!(field.mul(a, &inverse, work), Some(Univariate::integers(&[1])));
        assert_eq!(field.is_zero(&inverse, work), Some(false));
    }

    #[test]
    fn combinations_over_a_field() {
        let work = &mut Work::unlimited();
        let mut field = Field::new(sqrt(2, 1));
        let n = |c: &[i64]| Univariate::integers(c);
        // (1, √2) and (√2, 2) are multiples of each other, (1, √2) and (√2, 1) are not.
        let rows = [vec![n(&[1]), n(&[0, 1])], vec![n(&[0, 1]), n(&[2])]];
        let row = |_: &Field, k: usize, _: &mut Work| Some(rows[k].clone());
        let found = field.vanishing_combination(2, &row, work).expect("unlimited");
        assert_eq!(found, Some(vec![n(&[0, -1]), n(&[1])]));
        let rows = [vec![n(&[1]), n(&[0, 1])], vec![n(&[0, 1]), n(&[1])]];
        let row = |_: &Field, k: usize, _: &mut Work| Some(rows[k].clone());
        assert_eq!(field.vanishing_combination(2, &row, work), Some(None));
    }
}
