//! A page with sliders for the shape values: one file that needs no other.

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::{Poly, Var};
use basis_engine::algebra::range::Range;
use basis_engine::algebra::rational::{Rational, ToFloat as _};
use basis_engine::model::angle::{Angle, Kind};
use basis_engine::{Diagnostic, Family};
use serde_json::{Value, json};

use super::Scene;
use super::values::pieces;
use crate::domain;
use crate::eval::inside_of as inside;
use crate::output::error;

const PAGE: &str = include_str!("page.html");

/// The page.
pub(super) fn page(scene: &Scene) -> Result<String, Diagnostic> {
    let data = data(scene)?;
    // In a script `</` would end it.
    let data = data.to_string().replace('<', "\\u003c");
    let title = scene.family.title().replace('&', "&amp;").replace('<', "&lt;");
    Ok(PAGE.replace("TITLE", &title).replace("\"DATA\"", &data))
}

fn data(scene: &Scene) -> Result<Value, Diagnostic> {
    let family = &scene.family;
    let pieces: Option<Vec<Value>> = pieces(family).into_iter().map(piece).collect();
    let Some(pieces) = pieces else { return Err(error("the domain has no ends")) };
    let kind = match (family.domain.len(), family.is_simplex()) {
        (1, _) => "interval",
        (_, true) => "triangle",
        (_, false) => "box",
    };
    let first = scene.settings.first().map_or(&[][..], |s| &s.values);
    let shape = |(k, p): (usize, &basis_engine::model::Parameter)| {
        let value = first.get(k).cloned().unwrap_or_else(|| inside(p));
        let [low, high] = slider(&p.range, &value);
        let excluded = [!p.range.low.is_included(), !p.range.high.is_included()];
        json!({ "name": p.name, "low": low, "high": high, "excluded": excluded, "value": value.to_f64() })
    };
    let number = |x: &Rational| x.to_f64();
    let failure = |f: &super::failures::Failure| {
        let at: Vec<Option<f64>> = f.at.iter().map(|x| x.as_ref().map(number)).collect();
        let shapes: Vec<Option<f64>> = f.shapes.iter().map(|x| x.as_ref().map(number)).collect();
        json!({
            "text": f.text, "declared": f.declared, "shapes": shapes, "piece": f.piece, "at": at, "function": f.function
        })
    };
    let cut = scene.cut.as_ref().map(|cut| format!(", cut at {}", cut.label)).unwrap_or_default();
    Ok(json!({
        "title": family.title(),
        "doc": family.doc.first(),
        "domain": domain::describe(family) + &cut,
        "kind": kind,
        "variables": family.domain_variables().map(|p| p.name.clone()).collect::<Vec<_>>(),
        "shapes": family.shapes.iter().enumerate().map(shape).collect::<Vec<_>>(),
        "functions": (0..family.functions.len()).map(|k| family.function_label(k)).collect::<Vec<_>>(),
        "pieces": pieces,
        "points": scene.points,
        "failures": scene.failures.iter().map(failure).collect::<Vec<_>>()
    }))
}

/// The functions on one span of the domain, or on the whole of it, with the variables of their formulas; nothing where
/// the span has no ends.
fn piece(family: &Family) -> Option<Value> {
    let ranges: Vec<[f64; 2]> = family
        .domain
        .iter()
        .map(|p| p.range.finite().map(|(a, b)| [a.to_f64(), b.to_f64()]))
        .collect::<Option<_>>()?;
    let fraction =
        |f: &Fraction| json!({ "numer": terms(family, f.numer()), "denom": terms(family, f.denom()) });
    let angle = |a: &Angle| {
        let pi = core::f64::consts::PI;
        let (rate, shift) = (a.rate.to_f64(), a.shift.to_f64());
        let (rate, shift) = if a.turns { (rate * pi, shift) } else { (rate, shift * pi) };
        let kind = match a.kind {
            Kind::Circular => "atan",
            Kind::Hyperbolic => "atanh",
            Kind::Linear => "",
        };
        let (low, width) = (fraction(&a.low), fraction(&a.width));
        let (var, itself) = (a.var.0, a.itself.0);
        json!({ "name": a.name, "kind": kind, "rate": rate, "shift": shift, "low": low, "width": width, "var": var, "itself": itself })
    };
    let analytic = &family.analytic;
    let numbers: Vec<(usize, f64)> = analytic.floats().iter().map(|(var, x)| (var.0, *x)).collect();
    Some(json!({
        "ranges": ranges,
        "width": variables(family),
        "angles": analytic.angles.iter().map(angle).collect::<Vec<_>>(),
        "numbers": numbers,
        "places": [
            family.shapes.iter().map(|p| p.var.0).collect::<Vec<_>>(),
            family.domain.iter().map(|p| p.var.0).collect::<Vec<_>>()
        ],
        "functions": family.functions.iter().map(|f| fraction(&f.value)).collect::<Vec<_>>()
    }))
}

/// How many variables there are, numbers and angles included.
fn variables(family: &Family) -> usize {
    let angles = family.analytic.angles.iter().flat_map(|a| [a.var.0, a.itself.0]);
    let numbers = family.analytic.numbers().into_iter().map(|var| var.0);
    angles.chain(numbers).map(|k| k + 1).chain([family.names.len()]).max().unwrap_or(0)
}

/// The coefficients of a polynomial with the exponents of all variables.
fn terms(family: &Family, poly: &Poly) -> Value {
    let term = |(monomial, coefficient): (&basis_engine::algebra::poly::Monomial, &Rational)| {
        let exponents: Vec<u16> = (0..variables(family)).map(|k| monomial.exponent(Var(k))).collect();
        json!([coefficient.to_f64(), exponents])
    };
    Value::from(poly.terms().map(term).collect::<Vec<_>>())
}

/// The ends of a slider: those of the range, and ten units further where it has none.
fn slider(range: &Range, value: &Rational) -> [f64; 2] {
    let (low, high) = (range.low.value().map(Rational::to_f64), range.high.value().map(Rational::to_f64));
    let value = value.to_f64();
    match (low, high) {
        (Some(low), Some(high)) => [low, high],
        (Some(low), None) => [low, low.max(value) + 10.0],
        (None, Some(high)) => [high.min(value) - 10.0, high],
        (None, None) => [value - 5.0, value + 5.0],
    }
}
