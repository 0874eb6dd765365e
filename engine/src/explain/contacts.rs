//! Joins as formulas: the control points that a contact of two curves of a family determines.

use crate::algebra::factor::factor;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use crate::decide::{self, Budget, Decision, Relation};
use crate::model::Family;
use crate::model::continuation::{Continuation, Side, continuation};
use crate::model::theorem::Unit;

/// A contact of two curves of a family and the control points that it determines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contact {
    /// What is asked for, such as `C1, Q after P: Q'(0) = P'(1)`.
    pub title: String,
    /// The determined points, such as `Q[0]` and `P[2]`.
    pub points: Vec<(String, String)>,
    /// Where the shape values of Q do not determine them, such as `λ_Q != -2`.
    pub conditions: Vec<String>,
}

/// What the contacts C1, G1, C2 and G2 at both ends of a curve P over a family on an interval say about another curve Q; a contact is left
/// out where the derivatives at the end are dependent for all shape values.
pub fn contacts(family: &Family) -> Vec<Contact> {
    let Some((_, low, high)) = family.interval() else { return Vec::new() };
    let mut all = Vec::new();
    for (side, words, here, there) in
        [(Side::After, "Q after P", high, low), (Side::Before, "Q before P", low, high)]
    {
        for order in [1, 2] {
            let Some(general) = continuation(family, order, side) else { continue };
            let conditions = conditions(family, &general);
            let name =
                |k: u32, curve: &str, end: &Rational| format!("{curve}{}({end})", "'".repeat(k as usize));
            let (p1, q1) = (name(1, "P", here), name(1, "Q", there));
            let (p2, q2) = (name(2, "P", here), name(2, "Q", there));
            let geometric = match order {
                1 => format!("f*{q1} = {p1}"),
                _ => format!("f*{q1} = {p1}, f^2*{q2} + c*{q1} = {p2}"),
            };
            let parametric =
                if order == 1 { format!("{q1} = {p1}") } else { format!("{q1} = {p1}, {q2} = {p2}") };
            let special = |p: &Fraction| {
                let f = Var(2 * family.shapes.len());
                let one = Fraction::constant(Rational::ONE);
                let p = p.substitute(f, &one)?;
                p.substitute(Var(f.0 + 1), &Fraction::zero())
            };
            for (kind, equations, plain) in [("C", parametric, true), ("G", geometric, false)] {
                let points = general.determined.iter().map(|(k, form)| {
                    let value = |w: &Fraction| if plain { special(w) } else { Some(w.clone()) };
                    let weights: Vec<(usize, Fraction)> = form
                        .terms
                        .iter()
                        .filter_map(|(unit, w)| match unit {
                            Unit::Point(p) => Some((*p, value(w)?)),
                            Unit::Pair(..) => None,
                        })
                        .filter(|(_, w)| !w.is_zero())
                        .collect();
                    let label = general.points[family.functions.len() + k].name.clone();
                    (label, weighted(&general, &weights))
                });
                let title = format!("{kind}{order}, {words}: {equations}");
                all.push(Contact { title, points: points.collect(), conditions: conditions.clone() });
            }
        }
    }
    all
}

/// The factors of the determinant that vanish somewhere on the declared ranges.
fn conditions(family: &Family, general: &Continuation) -> Vec<String> {
    let region = Region { ranges: general.scalars.iter().map(|p| (p.var, p.range.clone())).collect() };
    let mut found = Vec::new();
    for (factor, _) in factor(&general.determinant).1 {
        let positive = |p: &Poly| {
            let decision = decide::decide(p, Relation::Positive, &region, &mut Budget::scaled(family.budget));
            matches!(decision, Decision::Proved(_))
        };
        if factor.as_constant().is_some() || positive(&factor) || positive(&-&factor) {
            continue;
        }
        let root = match factor.variables().as_slice() {
            [only] if factor.degree(*only) == 1 => {
                let parts = factor.coefficients_in(*only);
                let value = |k: usize| parts.get(k).and_then(Poly::as_constant);
                value(0).zip(value(1)).and_then(|(a, b)| (-&a).checked_div(&b)).map(|root| (*only, root))
            }
            _ => None,
        };
        found.push(match root {
            Some((var, root)) => format!("{} != {root}", general.names[var.0]),
            None => format!("{} != 0", factor.display(&general.names)),
        });
    }
    found
}

/// Σ weight·point, every weight as a product.
fn weighted(general: &Continuation, weights: &[(usize, Fraction)]) -> String {
    let names = &general.names;
    let mut text = String::new();
    for (point, weight) in weights {
        let (content, numer) = product(weight.numer(), names);
        let (below, denom) = product(weight.denom(), names);
        // The content of a denominator is not zero.
        let number = content.checked_div(&below).unwrap_or(Rational::ONE);
        text += match (text.is_empty(), number.is_negative()) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let magnitude = number.abs();
        let mut factors: Vec<String> = Vec::new();
        if !magnitude.is_one() {
            factors.push(magnitude.to_string());
        }
        factors.extend(numer);
        let mut factor = factors.join("*");
        if !denom.is_empty() {
            let several = denom.len() > 1;
            let below = denom.join("*");
            let above = if factor.is_empty() { String::from("1") } else { factor };
            factor = if several { format!("{above}/({below})") } else { format!("{above}/{below}") };
        }
        let point = &general.points[*point].name;
        text += &if factor.is_empty() { point.clone() } else { format!("{factor}*{point}") };
    }
    if text.is_empty() { String::from("0") } else { text }
}

/// A polynomial as a number and factors for reading.
fn product(poly: &Poly, names: &[String]) -> (Rational, Vec<String>) {
    let (mut content, factors) = factor(poly);
    let mut texts = Vec::new();
    for (factor, power) in factors {
        if let Some(c) = factor.as_constant() {
            content *= &c.pow(power);
            continue;
        }
        // The sign that begins with the simplest term.
        let negative = factor.display(names).to_string().starts_with('-');
        let factor = if negative { -&factor } else { factor };
        if negative && power % 2 == 1 {
            content = -&content;
        }
        let text = factor.display(names).to_string();
        let text = if factor.len() > 1 { format!("({text})") } else { text };
        texts.push(if power > 1 { format!("{text}^{power}") } else { text });
    }
    (content, texts)
}
