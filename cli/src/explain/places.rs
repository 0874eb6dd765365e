//! Zeros and extrema as text: points, and lines, curves and so on that equations give.

use super::facts::{ExtremaFacts, Extremum, FamilyFacts, Locus};

/// The functions that are negative somewhere.
pub(super) fn section(text: &mut String, facts: &FamilyFacts) {
    if facts.extrema.is_empty() && facts.extrema_open.is_empty() {
        return;
    }
    *text += "\n  Functions that are negative somewhere\n";
    for f in &facts.extrema {
        if is_constant(f) {
            *text += &format!("    {}: constant, {}\n", f.name, f.minimum.value);
            continue;
        }
        let (zeros, least, greatest) =
            (zeros(f, &plain), taken(&f.minimum, &plain), taken(&f.maximum, &plain));
        *text += &format!("    {}: {zeros}; least value {least}; greatest value {greatest}", f.name);
        for note in notes(f) {
            *text += &format!("; {note}");
        }
        text.push('\n');
    }
    for open in &facts.extrema_open {
        *text += &format!("    {}: zeros and extrema are not stated: {}\n", open.name, open.why);
    }
}

/// Whether a function has one value: the least one is the greatest.
pub(super) fn is_constant(f: &ExtremaFacts) -> bool {
    !f.bounds && f.minimum.value == f.maximum.value && !f.minimum.value.starts_with("about")
}

fn plain(formula: &str) -> String {
    formula.to_string()
}

/// What is left open of a function.
pub(super) fn notes(f: &ExtremaFacts) -> Vec<&'static str> {
    let mut all = Vec::new();
    if f.bounds {
        all.push("the values are bounds, the exact ones were not found");
    }
    if f.extrema_open {
        all.push("there may be other points with these values");
    }
    if f.zeros_open {
        all.push("there may be other zeros");
    }
    all
}

/// Where a function is zero; a formula is written by `math`.
pub(super) fn zeros(f: &ExtremaFacts, math: &dyn Fn(&str) -> String) -> String {
    match places(&f.zeros, &f.zeros_on, math) {
        None if f.zeros_open => String::from("zeros not stated"),
        None => String::from("no zeros"),
        Some(places) => format!("zero {places}"),
    }
}

/// A value, and where it is taken.
pub(super) fn taken(e: &Extremum, math: &dyn Fn(&str) -> String) -> String {
    let value = match e.value.strip_prefix("between ").and_then(|ends| ends.split_once(" and ")) {
        Some((low, high)) => format!("between {} and {}", math(low), math(high)),
        None => math(&e.value),
    };
    match places(&e.at, &e.on, math) {
        None => value,
        Some(places) => format!("{value} {places}"),
    }
}

/// `on the lines u = 1/2 and v = 0 and at t = 1`; nothing for no places.
fn places(at: &[String], on: &[Locus], math: &dyn Fn(&str) -> String) -> Option<String> {
    if on.iter().any(|locus| locus.kind == "domain") {
        return Some(String::from("everywhere"));
    }
    let mut parts = Vec::new();
    for kind in ["line", "curve", "plane", "surface"] {
        let all: Vec<String> = on.iter().filter(|l| l.kind == kind).map(|l| math(&l.equation)).collect();
        let plural = if all.len() > 1 { "s" } else { "" };
        if !all.is_empty() {
            parts.push(format!("on the {kind}{plural} {}", listed(&all)));
        }
    }
    if !at.is_empty() {
        parts.push(format!("at {}", points(at, math)));
    }
    (!parts.is_empty()).then(|| parts.join(" and "))
}

/// `a, b and c`
fn listed(all: &[String]) -> String {
    match all {
        [others @ .., last] if !others.is_empty() => format!("{} and {last}", others.join(", ")),
        _ => all.join(", "),
    }
}

/// Points; those after the first in the same coordinates without the names of these.
fn points(at: &[String], math: &dyn Fn(&str) -> String) -> String {
    let names = |text: &str| text.split_once(") = (").map(|(names, _)| names.to_string());
    let shown = at.iter().enumerate().map(|(k, text)| {
        let is_known = k > 0 && names(text).is_some() && names(text) == names(&at[0]);
        let short = text.split_once(" = ").filter(|_| is_known).map_or(text.as_str(), |(_, values)| values);
        math(short)
    });
    shown.collect::<Vec<_>>().join(", ")
}
