//! Expressions in shape values and other scalars: each distinct one is computed once.

use super::build::{Builder, Variable};
use super::corners::{Corners, by_distances};
use super::interval::form::MAX_CONTENT;
use super::{Input, Let, Node, Ref};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::model::angle::Kind;
use crate::model::{Family, Parameter};

/// A sum or product without its sign.
struct Piece {
    negative: bool,
    value: Ref,
}

impl Builder {
    /// A further variable, the shape value at a position.
    pub(super) fn variable(&mut self, position: usize, parameter: &Parameter) {
        let value = self.input(Input::Shape(position));
        self.add(parameter.var, parameter.range.clone(), value, true);
    }

    fn add(&mut self, var: Var, range: Range, value: Ref, is_given: bool) {
        self.variables.push(Variable { var, range, value, complement: None, rise: None, is_given });
    }

    /// The variables of a family with angles that stand for tangents of its shape parameters, for these themselves, and
    /// for π and exp(r).
    pub(super) fn tangents(&mut self, family: &Family) {
        let anywhere = || Range { low: End::Infinite, high: End::Infinite };
        let (shapes, angles) = (family.shapes.len(), family.analytic.angles.len());
        if angles > 0 {
            self.corners = Corners::of(family);
        }
        for (j, angle) in family.analytic.angles.iter().enumerate() {
            let Some(k) = self.variables.iter().position(|v| v.var == angle.var) else { continue };
            if angle.kind == Kind::Linear {
                let itself = self.variables[k].value;
                self.add(angle.itself, anywhere(), itself, false);
                continue;
            }
            let tangent = self.input(Input::Shape(shapes + j));
            // Not every function needs it.
            self.units.push(Let { names: vec![format!("_tangent{j}")], value: tangent });
            let itself = core::mem::replace(&mut self.variables[k].value, tangent);
            self.variables[k].is_given = false;
            self.add(angle.itself, anywhere(), itself, false);
            let to_one = self.variables[k].range.high.value().is_some_and(Rational::is_one);
            if angle.kind == Kind::Hyperbolic || to_one {
                let complement = self.input(Input::Shape(shapes + angles + j));
                self.units.push(Let { names: vec![format!("_complement{j}")], value: complement });
                self.variables[k].complement = Some(complement);
            }
            let from_minus_one = self.variables[k].range.low.value() == Some(&-Rational::ONE);
            if angle.kind == Kind::Hyperbolic && from_minus_one {
                let rise = self.input(Input::Shape(shapes + 2 * angles + j));
                self.units.push(Let { names: vec![format!("_rise{j}")], value: rise });
                self.variables[k].rise = Some(rise);
            }
        }
        for (var, number) in family.analytic.values() {
            let value = self.number(number);
            self.add(var, anywhere(), value, false);
        }
    }

    /// The value of a polynomial in the shape parameters.
    pub(super) fn scalar(&mut self, poly: &Poly) -> Ref {
        if let Some(value) = poly.as_constant() {
            return self.number(value);
        }
        if let Some(value) = self.known(poly) {
            return value;
        }
        if let Some(value) = self.known(&-poly) {
            return self.neg(value);
        }
        let value = self.factored(poly);
        // What a tangent lacks to 1 has a name.
        if self.units.iter().all(|unit| unit.value.position() != value.position()) {
            let name = format!("c{}", self.named.len());
            self.scalar_lets.push(Let { names: vec![name], value });
        }
        self.named.push((poly.clone(), value));
        value
    }

    /// The node of a variable, or of a polynomial that has a name.
    fn known(&self, poly: &Poly) -> Option<Ref> {
        if let (1, Some((monomial, c))) = (poly.len(), poly.leading_term())
            && c.is_one()
            && poly.total_degree() == 1
        {
            return self.variables.iter().find(|v| monomial.exponent(v.var) == 1).map(|v| v.value);
        }
        self.named.iter().find(|(p, _)| p == poly).map(|(_, value)| *value)
    }

    /// 1 divided by a denominator; `None` for 1.
    pub(super) fn reciprocal(&mut self, denom: &Poly) -> Option<Ref> {
        if denom.is_one() {
            return None;
        }
        if let Some((_, value)) = self.reciprocals.iter().find(|(p, _)| p == denom) {
            return Some(*value);
        }
        let value = self.scalar(denom);
        let value = self.push(Node::Reciprocal(value));
        let name = format!("r{}", self.reciprocals.len());
        self.scalar_lets.push(Let { names: vec![name], value });
        self.reciprocals.push((denom.clone(), value));
        Some(value)
    }

    /// A quotient of polynomials, in lowest terms unless the denominator is long.
    pub(super) fn quotient(&mut self, poly: &Poly, denom: &Poly) -> Ref {
        /// More terms have no common divisor worth its search.
        const MOST: usize = 8;
        if denom.is_one() || poly.is_zero() {
            return self.scalar(poly);
        }
        if denom.len() > MOST
            && let Some(reciprocal) = self.reciprocal(denom)
        {
            let numer = self.scalar(poly);
            return self.push(Node::Product(numer, reciprocal));
        }
        // One entry of a row may have a simpler denominator than the row.
        let Some(value) = Fraction::new(poly.clone(), denom.clone()) else { return self.scalar(poly) };
        let Some(reciprocal) = self.reciprocal(value.denom()) else { return self.scalar(value.numer()) };
        if value.numer().is_one() {
            return reciprocal;
        }
        if (-value.numer()).is_one() {
            return self.neg(reciprocal);
        }
        let numer = self.scalar(value.numer());
        self.push(Node::Product(numer, reciprocal))
    }

    /// Factors λ − low and high − λ are taken out, so that a coefficient that vanishes at the end of a range
    /// has a small relative error near it, and the sign of the exact value.
    fn factored(&mut self, poly: &Poly) -> Ref {
        // With whole numbers for coefficients a difference such as 7 - λ is exact near its zero; 7/10 - λ/10 is not.
        let content = if poly.len() > 1 { poly.numeric_content() } else { Rational::ONE };
        let content = if content.bits() > MAX_CONTENT { Rational::ONE } else { content };
        let mut rest = content.recip().map_or_else(|| poly.clone(), |factor| poly.scale(&factor));
        let mut factors: Vec<Ref> = Vec::new();
        for k in 0..self.variables.len() {
            let Variable { var, range, value, complement, rise, .. } = &self.variables[k];
            let (var, value, complement, rise) = (*var, *value, *complement, *rise);
            let ends = [(range.low.value().cloned(), true), (range.high.value().cloned(), false)];
            for (end, from_low) in ends {
                let Some(end) = end else { continue };
                let at_end = Poly::constant(end.clone());
                let factor = if from_low { &Poly::var(var) - &at_end } else { &at_end - &Poly::var(var) };
                let known = if from_low {
                    rise.filter(|_| end == -Rational::ONE)
                } else {
                    complement.filter(|_| end.is_one())
                };
                let worthwhile = |rest: &Poly| known.is_some() || rest.total_degree() > 1;
                while let Some(quotient) = rest.div_exact(&factor).filter(|_| worthwhile(&rest)) {
                    if rest.is_zero() {
                        break;
                    }
                    rest = quotient;
                    factors.push(known.unwrap_or_else(|| self.distance(value, &end, from_low)));
                }
            }
        }
        let piece = match self.by_distances(&rest).or_else(|| self.beside_corner(&rest)) {
            Some(value) => Piece { negative: false, value },
            None => self.sum(&rest),
        };
        if factors.is_empty() && content.is_one() {
            return self.signed(&piece);
        }
        if !rest.is_one() {
            factors.push(self.signed(&piece));
        }
        if !content.is_one() {
            factors.push(self.number(content));
        }
        self.product(&factors)
    }

    /// A polynomial of degree 1 in several variables that is 0 where each of these is at an end of its range, and has
    /// one sign beside: by the distances from there, as 2 + m + n = (1 + m) + (1 + n) for m, n ≥ −1, which has digits
    /// there.
    fn beside_corner(&mut self, poly: &Poly) -> Option<Ref> {
        if poly.total_degree() != 1 || poly.variables().len() < 2 {
            return None;
        }
        let (is_positive, terms) =
            [true, false].into_iter().find_map(|sign| Some((sign, self.distances_of(poly, sign)?)))?;
        let mut sum: Option<Ref> = None;
        for (c, value, end, from_low) in terms {
            let (distance, factor) = (self.distance(value, &end, from_low), self.number(c));
            let term = self.times(factor, distance);
            sum = Some(sum.map_or(term, |sum| self.push(Node::Sum(sum, term))));
        }
        sum.map(|sum| if is_positive { sum } else { self.neg(sum) })
    }

    /// The distances whose sum with these positive factors a linear polynomial is, or the sum with the other sign: of each
    /// variable from the end, and whether that is the lower one.
    fn distances_of(&self, poly: &Poly, is_positive: bool) -> Option<Vec<(Rational, Ref, Rational, bool)>> {
        let (mut rest, mut terms) = (poly.clone(), Vec::new());
        for (monomial, c) in poly.terms().filter(|(monomial, _)| monomial.total_degree() == 1) {
            let own = |v: &&Variable| v.is_given && monomial.exponent(v.var) == 1;
            let Variable { var, range, value, .. } = self.variables.iter().find(own)?;
            let from_low = c.is_positive() == is_positive;
            let end = if from_low { range.low.value() } else { range.high.value() }?;
            rest = &rest - &(&Poly::var(*var) - &Poly::constant(end.clone())).scale(c);
            terms.push((c.abs(), *value, end.clone(), from_low));
        }
        rest.is_zero().then_some(terms)
    }

    /// A polynomial that is 0 at a corner of its tangents: by the distances from the ends of the range of one of these,
    /// see [`corners`](super::corners). `None` for others.
    fn by_distances(&mut self, poly: &Poly) -> Option<Ref> {
        if !self.corners.cancels(poly) || !self.corners.is_short(poly) {
            return None;
        }
        let (var, ends) = self.corners.tangent(poly)?;
        let coefficients = by_distances(poly, var, ends);
        let Variable { value, complement, rise, .. } = *self.variables.iter().find(|v| v.var == var)?;
        let [low, high] = ends.clone();
        let s = complement.filter(|_| high.is_one()).unwrap_or_else(|| self.distance(value, &high, false));
        let x = rise.filter(|_| low.is_negative()).unwrap_or_else(|| self.distance(value, &low, true));
        let (mut sum, mut power): (Option<Ref>, Option<Ref>) = (None, None);
        for (k, c) in coefficients.iter().enumerate() {
            if k > 0 {
                sum = sum.map(|sum| self.times(sum, s));
                power = Some(power.map_or(x, |power| self.push(Node::Product(power, x))));
            }
            if c.is_zero() {
                continue;
            }
            let coefficient = self.factored(c);
            let term = power.map_or(coefficient, |power| self.times(coefficient, power));
            sum = Some(sum.map_or(term, |sum| self.push(Node::Sum(sum, term))));
        }
        sum
    }

    /// a·b without a factor 1.
    fn times(&mut self, a: Ref, b: Ref) -> Ref {
        match self.node(a) {
            Node::Number(c) if c.is_one() => b,
            _ => self.push(Node::Product(a, b)),
        }
    }

    /// λ − end, or end − λ.
    fn distance(&mut self, value: Ref, end: &Rational, from_low: bool) -> Ref {
        if end.is_zero() {
            return if from_low { value } else { self.neg(value) };
        }
        if !from_low {
            let end = self.number(end.clone());
            return self.push(Node::Difference(end, value));
        }
        let magnitude = self.number(end.abs());
        self.push(if end.is_negative() {
            Node::Sum(value, magnitude)
        } else {
            Node::Difference(value, magnitude)
        })
    }

    /// A polynomial by Horner's scheme in its first variable, the coefficients likewise.
    fn sum(&mut self, poly: &Poly) -> Piece {
        let Some(var) = poly.variables().first().copied() else {
            let value = poly.as_constant().unwrap_or(Rational::ZERO);
            return Piece { negative: value.is_negative(), value: self.number(value.abs()) };
        };
        let variable = self.variables.iter().find(|v| v.var == var);
        let value = variable.expect("coefficients have no other variables").value;
        let coefficients = poly.coefficients_in(var);
        let mut sum = Piece { negative: false, value };
        for (k, coefficient) in coefficients.iter().enumerate().rev() {
            if k + 1 == coefficients.len() {
                sum = self.sum(coefficient);
                continue;
            }
            let one = matches!(self.node(sum.value), Node::Number(c) if c.is_one());
            let product = if one { value } else { self.push(Node::Product(sum.value, value)) };
            sum.value = product;
            if !coefficient.is_zero() {
                let first = self.sum(coefficient);
                let first = self.signed(&first);
                let node =
                    if sum.negative { Node::Difference(first, product) } else { Node::Sum(first, product) };
                sum = Piece { negative: false, value: self.push(node) };
            }
        }
        sum
    }

    fn signed(&mut self, piece: &Piece) -> Ref {
        if piece.negative { self.neg(piece.value) } else { piece.value }
    }
}
