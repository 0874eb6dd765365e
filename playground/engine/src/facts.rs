//! What follows from the formulas of a family or theorem, in LaTeX.

use basis_engine::explain;
use basis_engine::model::Factor;
use basis_engine::query::{self, latex};
use basis_engine::source::Source;
use basis_engine::{Family, Theorem};
use serde_json::{Value, json};

use crate::places::Places;
use crate::text::{NAME, NoFiles};

/// LaTeX, or the text itself where it is no formula.
fn math(text: &str) -> Value {
    json!({ "text": text, "latex": latex::math(text) })
}

fn equation((left, right): &(String, String)) -> Value {
    let latex = latex::math(left).zip(latex::math(right)).map(|(l, r)| format!("{l} = {r}"));
    json!({ "text": format!("{left} = {right}"), "latex": latex })
}

/// The functions in all their forms, and what follows from them.
pub(crate) fn family(family: &Family) -> Value {
    // On each span of the domain the functions have formulas of their own.
    let spans: Vec<Value> = family
        .pieces
        .iter()
        .map(|span| json!({ "domain": domain_of(span), "functions": functions_of(span) }))
        .collect();
    let shapes: Vec<Value> = family
        .shapes
        .iter()
        .map(|p| json!({ "declared": math(&family.declared(p)), "doc": p.doc }))
        .collect();
    let functions = if spans.is_empty() { functions_of(family) } else { Vec::new() };
    json!({
        "title": family.title(),
        "doc": family.doc,
        "domain": domain_of(family),
        "shapes": shapes,
        "conditions": family.assumed().map(|c| math(&c.text)).collect::<Vec<_>>(),
        "functions": functions,
        "spans": spans
    })
}

fn functions_of(family: &Family) -> Vec<Value> {
    let function = |f: query::FunctionFacts| {
        let between = f.between.map(|(low, high)| json!([math(&low), math(&high)]));
        json!({
            "label": math(&f.label),
            "factored": math(&f.factored),
            "expanded": math(&f.expanded),
            "bernstein": f.bernstein.iter().map(|c| math(c)).collect::<Vec<_>>(),
            "between": between
        })
    };
    query::function_facts(family).into_iter().map(function).collect()
}

fn domain_of(family: &Family) -> Vec<Value> {
    let factor = |factor: Factor<'_>| match factor {
        Factor::Interval(p) => math(&family.declared(p)),
        Factor::Simplex(..) => {
            let names: Vec<String> = factor.variables().map(|p| latex::name(&p.name)).collect();
            let text: Vec<String> = factor.variables().map(|p| p.name.clone()).collect();
            json!({
                "text": format!("{} = 1, all ≥ 0", text.join(" + ")),
                "latex": format!("{} = 1, \\quad {} \\ge 0", names.join(" + "), names.join(", "))
            })
        }
    };
    family.factors().into_iter().map(factor).collect()
}

/// The ends of a curve with its first two derivatives there; of quotients, which take longer, the first derivative, and
/// nothing where the functions contain angles: simplifying that takes many seconds.
pub(crate) fn ends(family: &Family) -> Value {
    let order = if family.is_rational() { 1 } else { 2 };
    let known = family.interval().is_some() && family.analytic.is_empty();
    let of = |family: &Family| if known { explain::end_derivatives(family, order) } else { Vec::new() };
    let ends = match (family.pieces.first(), family.pieces.last()) {
        // The start of the first span and the end of the last one.
        (Some(first), Some(last)) => {
            let (mut first, last) = (of(first), of(last));
            first.truncate(first.len() / 2);
            first.extend(last.into_iter().skip(first.len()));
            first
        }
        _ => of(family),
    };
    json!({ "ends": ends.iter().map(equation).collect::<Vec<_>>() })
}

/// The control points that a join determines.
pub(crate) fn theorem(theorem: &Theorem) -> Value {
    let patches: Vec<Value> =
        theorem.patches.iter().map(|p| json!({ "name": p.name, "written": p.written })).collect();
    json!({
        "title": theorem.title(),
        "doc": theorem.doc,
        "patches": patches,
        "points": explain::determined_points(theorem).iter().map(equation).collect::<Vec<_>>()
    })
}

/// Claims that hold of a family and that the text does not make, with the place at which they belong.
pub(crate) fn holds(text: &str, places: &Places, name: &str) -> Value {
    let source = Source::text(NAME, text);
    let found = query::claims_that_hold(&NoFiles, &source, name);
    let document = query::Document::new(text);
    let entry = document.entries.iter().find(|entry| {
        let symbol = entry.symbol.map(|s| &document.symbols[s]);
        entry.title == name && symbol.is_some_and(|s| s.kind == query::SymbolKind::Family)
    });
    let end = entry.and_then(|entry| entry.body.as_ref()).map(|body| places.at(body.end));
    json!({ "at": end, "statements": found.into_iter().map(|h| h.statement).collect::<Vec<_>>() })
}
