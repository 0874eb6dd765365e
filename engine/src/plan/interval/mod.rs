//! Families on an interval: values, tables, and the binding to control points.

pub mod form;
pub mod rational;

use self::form::{Factored, IntervalForm, MAX_ENDPOINT_DEGREE};
use super::{Builder, Input, Let, Node, Plan, Ref};
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::model::Family;
use basis_prover::collections::list::{Listed, Mapped};

/// The values of all functions: x^a s^b h(s, x)² g(s, x) for each, powers shared; with g in Bernstein form no step is
/// negative where its coefficients are not.
pub fn values(family: &Family, form: &IntervalForm) -> Plan {
    let mut builder = Builder::of(family);
    let t = builder.input(Input::Coordinate(0));
    if form.degree > 0 {
        let names = ["s", "x"].map(String::from);
        let [s, x] = builder.unit([&form.low, &form.high], t, &names);
        builder.coordinates = vec![(String::from("s"), s), (String::from("x"), x)];
    }
    let values = form.functions.mapped(|f| value(&mut builder, &f.factored, &f.denom));
    let values = builder.cut_off(values, &family.nonnegative);
    builder.finish(values)
}

/// The value of one function.
pub(super) fn value(builder: &mut Builder, f: &Factored, denom: &Poly) -> Ref {
    let mut product: Vec<Ref> = Vec::new();
    if !f.content.is_one() {
        product.push(builder.number(f.content.clone()));
    }
    if !f.square.is_empty() {
        product.push(builder.square(&f.square));
    }
    match f.inner.as_slice() {
        [] => return builder.number(Rational::ZERO),
        [one] if one.is_one() => {}
        [one] => product.push(builder.scalar(one)),
        many => product.push(builder.bernstein(many)),
    }
    if f.s_power > 0 || f.x_power > 0 {
        product.extend(builder.monomial(&[f.s_power, f.x_power]));
    }
    product.extend(builder.reciprocal(denom));
    builder.product(&product)
}

impl Builder {
    /// Σ c_j binomial(n, j) s^(n−j) x^j.
    fn bernstein(&mut self, coefficients: &[Poly]) -> Ref {
        let coefficients = coefficients.mapped(|p| self.scalar(p));
        let [s, x] = [self.coordinates[0].1, self.coordinates[1].1];
        self.push(Node::Bernstein { coefficients, s, x })
    }

    /// h², where h is computed once.
    fn square(&mut self, coefficients: &[Poly]) -> Ref {
        let root = self.bernstein(coefficients);
        self.squared(root)
    }

    /// The square of what is computed once.
    pub(super) fn squared(&mut self, root: Ref) -> Ref {
        self.root_lets.push(Let { names: vec![format!("_root{}", self.root_lets.len())], value: root });
        self.push(Node::Product(root, root))
    }
}

/// The monomial coefficients: for each function those of t⁰, t¹, …
pub fn coefficients(family: &Family, form: &IntervalForm) -> Plan {
    table(family, form.functions.mapped(|f| f.monomial.mapped(|p| (p, &f.denom))))
}

/// The weights of the control points in the Bézier control points: for each of these one of each function.
pub fn bernstein_weights(family: &Family, form: &IntervalForm) -> Plan {
    let row = |j: usize| form.functions.mapped(|f| (&f.bernstein[j], &f.denom));
    table(family, (0..=form.degree as usize).map(row).listed())
}

/// A table of quotients in the shape values, row by row.
pub(crate) fn table(family: &Family, rows: Vec<Vec<(&Poly, &Poly)>>) -> Plan {
    let mut builder = Builder::of(family);
    let mut entries = Vec::new();
    for (poly, denom) in rows.into_iter().flatten() {
        entries.push(builder.quotient(poly, denom));
    }
    builder.finish(entries)
}

/// What binding control points gives: E0, E1, R0, R1, … of the endpoint form
/// C = s·E0 + x·E1 + s·x·(R0 + R1·y + …), y = x − s; `None` above [`MAX_ENDPOINT_DEGREE`], where a curve is bound to
/// its Bézier control points.
pub fn bind(family: &Family, form: &IntervalForm) -> Option<Plan> {
    if form.degree > MAX_ENDPOINT_DEGREE {
        return None;
    }
    let mut builder = Builder::of(family);
    let points = (0..form.len()).map(|k| builder.input(Input::Point(k))).listed();
    let inner = form.degree.saturating_sub(1) as usize;
    let mut outputs = Vec::new();
    for k in 0..inner + 2 {
        let weights = form.functions.mapped(|f| (&f.endpoint[k], &f.denom));
        let alone = weights.iter().filter(|(p, _)| !p.is_zero()).count() == 1;
        outputs.push(match weights.iter().position(|(p, denom)| p == denom) {
            Some(only) if alone => points[only],
            _ => {
                let weights = weights.into_iter().map(|(p, denom)| builder.quotient(p, denom)).listed();
                builder.push(Node::Combine { points: points.clone(), weights })
            }
        });
    }
    Some(builder.finish(outputs))
}
