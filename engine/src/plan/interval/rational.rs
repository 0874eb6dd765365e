//! Families with a denominator in the domain variable, or in its tangent: values, the tables of numerators and
//! denominator, and the ends of the domain where these are shape parameters.

use super::form::RationalForm;
use super::{table, value};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::model::angle::Angle;
use crate::model::{Family, Parameter};
use crate::plan::digits::split;
use crate::plan::{Builder, Input, Let, Node, Plan};
use basis_prover::collections::list::{Listed, Mapped};

/// The values of all functions: numerators in factored form, each divided by the common denominator. Of a family without
/// angles the input is t, of one with angles it is the two coordinates s and x.
pub fn values(family: &Family, form: &RationalForm) -> Plan {
    let mut builder = Builder::of(family);
    let numerators = &form.numerators;
    let [s, x] = if family.analytic.is_empty() {
        let t = builder.input(Input::Coordinate(0));
        builder.unit([&numerators.low, &numerators.high], t, &["s", "x"].map(String::from))
    } else {
        [0, 1].map(|k| builder.input(Input::Coordinate(k)))
    };
    builder.coordinates = vec![(String::from("s"), s), (String::from("x"), x)];
    if let Some(ratio) = &form.ratio {
        builder.of_one_size(ratio);
    }
    let divides = form.divides(family);
    let mut names = Vec::new();
    let denominator = divides.then(|| match &form.completed {
        Some(completed) => {
            let t = builder.parameter_of(family, x);
            builder.completed(completed, t)
        }
        None => {
            let denominator = value(&mut builder, &form.denominator.factored, &Poly::one());
            builder.kept(denominator, &form.sign)
        }
    });
    let values = numerators.functions.mapped(|f| {
        let numerator = value(&mut builder, &f.factored, &f.denom);
        match denominator {
            // Zero is no quotient.
            Some(denominator) if !f.factored.inner.is_empty() => {
                builder.push(Node::Quotient(numerator, denominator))
            }
            _ => numerator,
        }
    });
    let values = builder.cut_off(values, &family.nonnegative);
    names.extend(denominator.map(|value| Let { names: vec![String::from("w")], value }));
    builder.finish_with(names, values)
}

impl Builder {
    /// Takes s and y = ratio·x as coordinates, both times the power of two that makes their sum a number from 1 to 2.
    fn of_one_size(&mut self, ratio: &Poly) {
        let [s, x] = [self.coordinates[0].1, self.coordinates[1].1];
        let ratio = self.scalar(ratio);
        let y = self.push(Node::Product(ratio, x));
        let sum = self.push(Node::Sum(s, y));
        let size = self.push(Node::InversePowerOfTwo(sum));
        let [u, v] = [s, y].map(|part| self.push(Node::Product(part, size)));
        self.coordinates = vec![(String::from("u"), u), (String::from("v"), v)];
        // They come before their powers.
        self.units.append(&mut self.scalar_lets);
        for (name, value) in [("y", y), ("size", size), ("u", u), ("v", v)] {
            self.units.push(Let { names: vec![String::from(name)], value });
        }
    }
}

/// The Bernstein coefficients of the numerators: for each place one of each function.
pub fn numerators(family: &Family, form: &RationalForm) -> Plan {
    let row = |j: usize| form.numerators.functions.mapped(|f| (&f.bernstein[j], &f.denom));
    table(family, (0..=form.numerators.degree as usize).map(row).listed())
}

/// The Bernstein coefficients of the denominator.
pub fn denominator(family: &Family, form: &RationalForm) -> Plan {
    table(family, vec![form.denominator.bernstein.mapped(|p| (p, &form.denominator.denom))])
}

/// A number times a shape parameter, which is given by its position, or the number alone.
pub(crate) type Term = (Rational, Option<usize>);

/// The terms of the ends of a domain that are sums of multiples of shape parameters, with factors that are floats; `None`
/// where both ends are floats themselves, or have other terms.
pub(crate) fn sums(family: &Family, angle: &Angle) -> Option<[Vec<Term>; 2]> {
    let terms = |end: &Fraction| {
        let mut all: Vec<Term> = Vec::new();
        for (monomial, c) in end.as_poly()?.terms() {
            let is_in = |p: &Parameter| {
                let itself = family.analytic.angle(p.var).map(|angle| angle.itself);
                monomial.exponent(p.var) > 0 || itself.is_some_and(|var| monomial.exponent(var) > 0)
            };
            let of = match monomial.total_degree() {
                0 => None,
                1 => Some(family.shapes.iter().position(is_in)?),
                _ => return None,
            };
            if !split(c, 24).1.is_zero() {
                return None;
            }
            all.push((c.clone(), of));
        }
        Some(all)
    };
    let all = [terms(&angle.limits[0])?, terms(&angle.limits[1])?];
    let is_float = |terms: &Vec<Term>| terms.len() < 2 && terms.iter().all(|(c, _)| split(c, 1).1.is_zero());
    (!all.iter().all(is_float)).then_some(all)
}

/// The two ends of the domain.
pub fn ends(family: &Family, angle: &Angle) -> Plan {
    table(family, vec![angle.limits.each_ref().map(|end| (end.numer(), end.denom())).into_iter().listed()])
}
