//! Functions as text, in the factored form in which they are evaluated.

use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::plan::interval::form::{FunctionForm, IntervalForm};
use crate::plan::patch::form::{PatchForm, PatchFunction};
use basis_prover::collections::list::Listed;

/// A function on an interval as a product: number · polynomial · powers of the distances to both ends.
pub(crate) fn factored(family: &Family, form: &IntervalForm, function: &FunctionForm) -> String {
    let f = &function.factored;
    if f.inner.is_empty() {
        return String::from("0");
    }
    let mut whole = f.inner_monomial(form).scale(&f.content);
    let ends = distances(form.var, &form.low, &form.high);
    let square = f.square_monomial(form).map(|h| squared(&h, &mut whole, &family.names));
    let powers: Vec<(Poly, u32)> = ends.into_iter().zip([f.x_power, f.s_power]).chain(square).listed();
    product(&whole, &powers, &function.denom, &family.names)
}

/// Whether [`factored`] writes a sum that is no product.
pub(super) fn is_sum(form: &IntervalForm, function: &FunctionForm) -> bool {
    let f = &function.factored;
    let alone = f.x_power + f.s_power == 0 && f.square.is_empty() && function.denom.is_one();
    alone && f.inner_monomial(form).len() > 1
}

/// A function on a box as a product: number · polynomial · powers of the distances to the faces.
pub(crate) fn factored_on_box(family: &Family, form: &PatchForm, function: &PatchFunction) -> String {
    if function.inner.is_empty() {
        return String::from("0");
    }
    let (mut whole, mut powers) = (function.inner_polynomial(form), Vec::new());
    let square = function.square_polynomial(form).map(|h| squared(&h, &mut whole, &family.names));
    let mut rest = function.powers.as_slice();
    for group in &form.groups {
        let (exponents, others) = rest.split_at(group.vars.len() + 1);
        rest = others;
        let Some(var) = group.vars.first() else { continue };
        let Some((low, high)) = &group.range else {
            let last = family.simplices.iter().find(|s| family.domain[s.places.start].var == *var);
            let coordinates = group.vars.iter().copied().chain(last.map(|s| s.last.var));
            powers.extend(coordinates.map(Poly::var).zip(exponents.iter().copied()));
            continue;
        };
        // x^a s^b = (t − low)^a (high − t)^b / (high − low)^(a + b)
        let unit = (high - low).recip().unwrap_or(Rational::ONE);
        whole = whole.scale(&unit.pow(exponents.iter().sum()));
        powers.extend(distances(*var, low, high).into_iter().zip(exponents.iter().copied()));
    }
    powers.extend(square);
    product(&whole, &powers, &function.denom, &family.names)
}

/// h² with whole coefficients without a common divisor, the first one positive; the square of what h is divided by comes to what
/// stands before it.
fn squared(h: &Poly, whole: &mut Poly, names: &[String]) -> (Poly, u32) {
    let content = h.numeric_content();
    let content = if h.display(names).to_string().starts_with('-') { -content } else { content };
    let Some(factor) = content.recip() else { return (h.clone(), 2) };
    *whole = whole.scale(&content.pow(2));
    (h.scale(&factor), 2)
}

/// The distances t − low and high − t.
fn distances(var: Var, low: &Rational, high: &Rational) -> [Poly; 2] {
    let t = Poly::var(var);
    [&t - &Poly::constant(low.clone()), &Poly::constant(high.clone()) - &t]
}

/// A polynomial times powers, over a denominator; a number stands before the product where the polynomial would have
/// fractions.
fn product(whole: &Poly, powers: &[(Poly, u32)], denom: &Poly, names: &[String]) -> String {
    // As one writes it: without a minus sign in front of what stands below.
    if denom.display(names).to_string().starts_with('-') {
        return product(&-whole, powers, &-denom, names);
    }
    let content = whole.numeric_content();
    let alone = powers.iter().all(|(_, power)| *power == 0) && denom.is_one();
    let (number, inner) = if content.is_integer() || alone {
        (Rational::ONE, whole.clone())
    } else {
        let negative = whole.display(names).to_string().starts_with('-');
        let number = if negative { -content } else { content };
        let inner = whole.scale(&number.recip().unwrap_or(Rational::ONE));
        (number, inner)
    };
    let mut factors = Vec::new();
    if !number.is_one() {
        factors.push(number.to_string());
    }
    let power_count: u32 = powers.iter().map(|(_, power)| power).sum();
    if !inner.is_one() || (factors.is_empty() && power_count == 0) {
        let text = inner.display(names).to_string();
        factors.push(if inner.len() > 1 && !alone { format!("({text})") } else { text });
    }
    for (base, power) in powers {
        let text = base.display(names).to_string();
        let base = if base.len() > 1 { format!("({text})") } else { text };
        match power {
            0 => {}
            1 => factors.push(base),
            _ => factors.push(format!("{base}^{power}")),
        }
    }
    let negative = factors.len() > 1 && factors[0] == "-1";
    let text = if negative { format!("-{}", factors[1..].join("*")) } else { factors.join("*") };
    if denom.is_one() {
        return text;
    }
    let below = denom.display(names).to_string();
    if denom.len() > 1 || below.contains('*') {
        format!("{text}/({below})")
    } else {
        format!("{text}/{below}")
    }
}
