//! Families with a denominator in the domain variable: values, and the tables of numerators and denominator.

use super::form::RationalForm;
use super::interval::{table, value};
use super::{Builder, Input, Let, Node, Plan};
use crate::algebra::poly::Poly;
use crate::model::Family;
use basis_prover::collections::list::{Listed, Mapped};

/// The values of all functions: numerators in factored form, each divided by the common denominator.
pub fn values(family: &Family, form: &RationalForm) -> Plan {
    let mut builder = Builder::of(family);
    let t = builder.input(Input::Coordinate(0));
    let numerators = &form.numerators;
    let names = ["s", "x"].map(String::from);
    let [s, x] = builder.unit([&numerators.low, &numerators.high], t, &names);
    builder.coordinates = vec![(String::from("s"), s), (String::from("x"), x)];
    let denominator = value(&mut builder, &form.denominator.factored, &Poly::one());
    let values = numerators.functions.mapped(|f| {
        let numerator = value(&mut builder, &f.factored, &Poly::one());
        // Zero is no quotient.
        if f.factored.inner.is_empty() {
            return numerator;
        }
        builder.push(Node::Quotient(numerator, denominator))
    });
    let name = Let { names: vec![String::from("w")], value: denominator };
    builder.finish_with(vec![name], values)
}

/// The Bernstein coefficients of the numerators: for each place one of each function.
pub fn numerators(family: &Family, form: &RationalForm) -> Plan {
    let one = Poly::one();
    let row = |j: usize| form.numerators.functions.mapped(|f| (&f.bernstein[j], &one));
    table(family, (0..=form.numerators.degree as usize).map(row).listed())
}

/// The Bernstein coefficients of the denominator.
pub fn denominator(family: &Family, form: &RationalForm) -> Plan {
    let one = Poly::one();
    table(family, vec![form.denominator.bernstein.mapped(|p| (p, &one))])
}
