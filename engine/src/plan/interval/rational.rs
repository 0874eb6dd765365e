//! Families with a denominator in the domain variable, or in its tangent: values, the tables of numerators and
//! denominator, and the ends of the domain where these are shape parameters.

use super::form::RationalForm;
use super::{table, value};
use crate::algebra::poly::Poly;
use crate::model::Family;
use crate::model::angle::Angle;
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

/// The two ends of the domain.
pub fn ends(family: &Family, angle: &Angle) -> Plan {
    table(family, vec![angle.limits.each_ref().map(|end| (end.numer(), end.denom())).into_iter().listed()])
}
