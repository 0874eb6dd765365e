//! Expressions in shape values and other scalars as Rust code: each distinct one is computed once.

use basis_prover::collections::list::Listed;
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::tokens::{number, site};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::model::{Family, Parameter};

/// A variable of the expressions, and the code of its value.
pub(in crate::generate) struct Variable {
    pub(in crate::generate) var: Var,
    pub(in crate::generate) range: Range,
    pub(in crate::generate) value: TokenStream,
}

/// Collects the `let` lines of a function body.
pub(in crate::generate) struct ScalarCode {
    variables: Vec<Variable>,
    /// The polynomials that have a name.
    named: Vec<(Poly, Ident)>,
    /// The denominators whose reciprocals have a name.
    reciprocals: Vec<(Poly, Ident)>,
    lets: TokenStream,
}

impl ScalarCode {
    /// The shape values of a type, as its methods see them.
    pub(in crate::generate) fn of_fields(family: &Family, fields: &[Ident]) -> Self {
        let variable = |(p, field): (&Parameter, &Ident)| Variable {
            var: p.var,
            range: p.range.clone(),
            value: quote_spanned!(site()=> self.#field),
        };
        Self::new(family.shapes.iter().zip(fields).map(variable).listed())
    }

    pub(in crate::generate) fn new(variables: Vec<Variable>) -> Self {
        Self { variables, named: Vec::new(), reciprocals: Vec::new(), lets: TokenStream::new() }
    }

    pub(in crate::generate) fn lets(self) -> TokenStream {
        self.lets
    }

    /// The value of a polynomial in the shape parameters.
    pub(in crate::generate) fn scalar(&mut self, poly: &Poly) -> TokenStream {
        if let Some(value) = poly.as_constant() {
            return number(&value);
        }
        if let Some((_, name)) = self.named.iter().find(|(p, _)| p == poly) {
            return name.to_token_stream();
        }
        let negative = -poly;
        if let Some((_, name)) = self.named.iter().find(|(p, _)| *p == negative) {
            return quote_spanned!(site()=> -#name);
        }
        let name = Ident::new(&format!("c{}", self.named.len()), site());
        let value = self.product(poly);
        self.lets.extend(quote_spanned!(site()=> let #name = #value;));
        self.named.push((poly.clone(), name.clone()));
        name.to_token_stream()
    }

    /// 1 divided by a denominator; `None` for 1.
    pub(in crate::generate) fn reciprocal(&mut self, denom: &Poly) -> Option<TokenStream> {
        if denom.is_one() {
            return None;
        }
        if let Some((_, name)) = self.reciprocals.iter().find(|(p, _)| p == denom) {
            return Some(name.to_token_stream());
        }
        let value = self.scalar(denom);
        let name = Ident::new(&format!("r{}", self.reciprocals.len()), site());
        self.lets.extend(quote_spanned!(site()=> let #name = S::of(1.0) / #value;));
        self.reciprocals.push((denom.clone(), name.clone()));
        Some(name.to_token_stream())
    }

    /// A quotient of polynomials, in lowest terms.
    pub(in crate::generate) fn quotient(&mut self, poly: &Poly, denom: &Poly) -> TokenStream {
        if denom.is_one() || poly.is_zero() {
            return self.scalar(poly);
        }
        // One entry of a row may have a simpler denominator than the row.
        let Some(value) = crate::algebra::fraction::Fraction::new(poly.clone(), denom.clone()) else {
            return self.scalar(poly);
        };
        match self.reciprocal(value.denom()) {
            None => self.scalar(value.numer()),
            Some(reciprocal) if value.numer().is_one() => reciprocal,
            Some(reciprocal) => {
                let numer = self.scalar(value.numer());
                quote_spanned!(site()=> #numer * #reciprocal)
            }
        }
    }

    /// Factors λ − low and high − λ are taken out, so that a coefficient that vanishes at the end of a range
    /// has a small relative error near it, and the sign of the exact value.
    fn product(&self, poly: &Poly) -> TokenStream {
        // With whole numbers for coefficients a difference such as 7 - λ is exact near its zero; 7/10 - λ/10 is not.
        let content = if poly.len() > 1 { poly.numeric_content() } else { Rational::ONE };
        let mut rest = content.recip().map_or_else(|| poly.clone(), |factor| poly.scale(&factor));
        let mut factors: Vec<TokenStream> = Vec::new();
        for shape in &self.variables {
            let value = &shape.value;
            for (end, from_low) in [(&shape.range.low, true), (&shape.range.high, false)] {
                let Some(end) = end.value() else { continue };
                let at_end = Poly::constant(end.clone());
                let factor =
                    if from_low { &Poly::var(shape.var) - &at_end } else { &at_end - &Poly::var(shape.var) };
                while let Some(quotient) = rest.div_exact(&factor).filter(|_| rest.total_degree() > 1) {
                    rest = quotient;
                    let (positive, magnitude) = (!end.is_negative(), number(&end.abs()));
                    factors.push(match (from_low, positive) {
                        _ if end.is_zero() && from_low => value.clone(),
                        _ if end.is_zero() => quote_spanned!(site()=> (-#value)),
                        (true, true) => quote_spanned!(site()=> (#value - #magnitude)),
                        (true, false) => quote_spanned!(site()=> (#value + #magnitude)),
                        (false, true) => quote_spanned!(site()=> (#magnitude - #value)),
                        (false, false) => quote_spanned!(site()=> (-#magnitude - #value)),
                    });
                }
            }
        }
        let rest_piece = self.sum(&rest);
        if factors.is_empty() && content.is_one() {
            return rest_piece.code();
        }
        if !rest.is_one() {
            let code = rest_piece.code();
            let simple = rest_piece.kind != Kind::Sum && !rest_piece.negative;
            factors.push(if simple { code } else { quote_spanned!(site()=> (#code)) });
        }
        if !content.is_one() {
            factors.push(number(&content));
        }
        product(factors)
    }

    /// A polynomial by Horner's scheme in its first variable, the coefficients likewise.
    fn sum(&self, poly: &Poly) -> Piece {
        let Some(var) = poly.variables().first().copied() else {
            return Piece::constant(&poly.as_constant().unwrap_or(Rational::ZERO));
        };
        let value = self.variables.iter().find(|v| v.var == var).map(|v| v.value.clone()).unwrap_or_default();
        let coefficients = poly.coefficients_in(var);
        let (last, rest) = coefficients.split_last().expect("a polynomial has a coefficient");
        rest.iter().rev().fold(self.sum(last), |inner, coefficient| {
            let product = inner.times(&value);
            if coefficient.is_zero() { product } else { self.sum(coefficient).plus(&product) }
        })
    }
}

/// A piece of an expression: a sign, and what it takes to multiply the rest.
struct Piece {
    negative: bool,
    code: TokenStream,
    kind: Kind,
}

#[derive(PartialEq)]
enum Kind {
    One,
    Product,
    Sum,
}

impl Piece {
    fn constant(value: &Rational) -> Self {
        let magnitude = value.abs();
        let kind = if magnitude.is_one() { Kind::One } else { Kind::Product };
        Self { negative: value.is_negative(), code: number(&magnitude), kind }
    }

    fn times(self, value: &TokenStream) -> Self {
        let Self { negative, code, kind } = self;
        let code = match kind {
            Kind::One => value.clone(),
            Kind::Product => quote_spanned!(site()=> #code * #value),
            Kind::Sum => quote_spanned!(site()=> (#code) * #value),
        };
        Self { negative, code, kind: Kind::Product }
    }

    fn plus(&self, other: &Self) -> Self {
        let (first, second) = (self.code(), &other.code);
        let second = if other.kind == Kind::Sum && other.negative {
            quote_spanned!(site()=> (#second))
        } else {
            second.clone()
        };
        let code = if other.negative {
            quote_spanned!(site()=> #first - #second)
        } else {
            quote_spanned!(site()=> #first + #second)
        };
        Self { negative: false, code, kind: Kind::Sum }
    }

    fn code(&self) -> TokenStream {
        let code = &self.code;
        match (self.negative, &self.kind) {
            (false, _) => code.clone(),
            (true, Kind::Sum) => quote_spanned!(site()=> -(#code)),
            (true, _) => quote_spanned!(site()=> -#code),
        }
    }
}

/// f * g * …
pub(in crate::generate) fn product(factors: Vec<TokenStream>) -> TokenStream {
    let mut factors = factors.into_iter();
    let first = factors.next().unwrap_or_else(|| number(&Rational::ONE));
    factors.fold(first, |product, factor| quote_spanned!(site()=> #product * #factor))
}
