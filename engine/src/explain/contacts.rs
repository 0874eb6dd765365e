//! Joins as formulas: the control points that a contact of two curves of a family determines.

use super::shape_values;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use crate::continuation::{Side, continuation, outermost};
use crate::model::Family;
use crate::theorem::Unit;
use crate::weights::{combination, zero, zeros};
use basis_prover::collections::list::Listed;

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

/// What the contacts C1, G1, C2 and G2 at both ends of a curve P over a family on an interval say about another curve
/// Q, of several spans at both ends of the whole domain; a contact is left out where the derivatives at the end are dependent for all shape values.
pub fn contacts(family: &Family) -> Vec<Contact> {
    [Side::After, Side::Before].iter().flat_map(|side| at_end(family, *side)).collect()
}

fn at_end(family: &Family, side: Side) -> Vec<Contact> {
    let (first, last) = outermost(family);
    let (Some([low, _]), Some([_, high])) = (first.end_texts(), last.end_texts()) else { return Vec::new() };
    // The formulas are in the shape parameters alone.
    if [first, last].iter().any(|f| !f.analytic.ranges.is_empty() || !f.analytic.numbers().is_empty()) {
        return Vec::new();
    }
    let (words, here, there) = match side {
        Side::After => ("Q after P", &high, &low),
        Side::Before => ("Q before P", &low, &high),
    };
    let mut all = Vec::new();
    for order in [1, 2] {
        let Some(general) = continuation(family, order, side) else { continue };
        let region = Region { ranges: general.scalars.iter().map(|p| (p.var, p.range.clone())).collect() };
        let names = &general.names;
        let conditions: Vec<String> = zeros(&general.determinant, &region, family.budget)
            .iter()
            .filter(|factor| !is_ruled_out(family, factor))
            .map(|factor| zero(factor, names).replace(" = ", " != "))
            .collect();
        let name = |k: u32, curve: &str, end: &str| format!("{curve}{}({end})", "'".repeat(k as usize));
        let (p1, q1) = (name(1, "P", here), name(1, "Q", there));
        let (p2, q2) = (name(2, "P", here), name(2, "Q", there));
        let geometric = match order {
            1 => format!("f*{q1} = {p1}"),
            _ => format!("f*{q1} = {p1}, f^2*{q2} + c*{q1} = {p2}"),
        };
        let parametric =
            if order == 1 { format!("{q1} = {p1}") } else { format!("{q1} = {p1}, {q2} = {p2}") };
        let special = |weight: &Fraction| {
            let f = Var(2 * family.shapes.len());
            let weight = weight.substitute(f, &Fraction::constant(Rational::ONE))?;
            weight.substitute(Var(f.0 + 1), &Fraction::zero())
        };
        for (kind, equations, plain) in [("C", parametric, true), ("G", geometric, false)] {
            let points = general.determined.iter().map(|(k, form)| {
                let mut form = form.clone();
                if plain {
                    form.terms.retain(|_, weight| {
                        // A denominator is a product of the determinant and a power of f.
                        *weight = special(weight).unwrap_or_else(Fraction::zero);
                        !weight.is_zero()
                    });
                }
                let label = general.points[family.functions.len() + k].name.clone();
                let terms = form.terms.iter().filter_map(|(unit, weight)| match unit {
                    Unit::Point(p) => Some((general.points[*p].name.as_str(), weight)),
                    Unit::Pair(..) => None,
                });
                (label, combination(terms, names))
            });
            let title = format!("{kind}{order}, {words}: {equations}");
            all.push(Contact { title, points: points.collect(), conditions: conditions.clone() });
        }
    }
    all
}

/// Whether a polynomial in the shape parameters of Q vanishes nowhere where what is assumed holds.
fn is_ruled_out(family: &Family, factor: &Poly) -> bool {
    let shapes = family.shapes.len();
    if !factor.variables().iter().all(|v| (shapes..2 * shapes).contains(&v.0)) {
        return false;
    }
    let map = (0..2 * shapes).map(|k| Var(k.checked_sub(shapes).unwrap_or(k))).listed();
    shape_values::vanishes_nowhere(family, &factor.rename(&map))
}
