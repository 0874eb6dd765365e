//! What the targets share: lines of code, conditions on shape values, and the constants of a file.

use super::{Assumption, Expressions, FamilyCode, JoinCode, Knot, Language, Shape};
use crate::algebra::range::End;
use crate::algebra::rational::Rational;
use crate::plan::Input;
use crate::rounding::{Error, decimal};
use crate::steps::{FamilySteps, Steps};

/// A line of a comment without what would end or continue it: control characters, line ends of Unicode, and a backslash
/// or a trigraph for one at its end.
pub(super) fn comment_line(line: &str) -> String {
    let control = |c: char| c.is_control() || ['\u{2028}', '\u{2029}'].contains(&c);
    let mut line: String = line.chars().map(|c| if control(c) { ' ' } else { c }).collect();
    line.truncate(line.trim_end().len());
    if line.ends_with('\\') || line.ends_with("??/") {
        line.push('.');
    }
    line
}

/// Lines behind `//`, as most languages have them.
pub(super) fn slashes(lines: &[String]) -> String {
    lines.iter().map(|line| format!("// {}", comment_line(line)).trim_end().to_string() + "\n").collect()
}

/// The lines of a text, further to the right; empty lines stay empty.
pub(super) fn indented(text: &str, by: &str) -> String {
    text.lines()
        .map(|line| if line.is_empty() { String::from("\n") } else { format!("{by}{line}\n") })
        .collect()
}

/// A name of a member in a language without scopes: `Bell_values`. No name has two `_` in a row.
pub(super) fn member(owner: &str, name: &str) -> String {
    if owner.ends_with('_') { format!("{owner}{name}") } else { format!("{owner}_{name}") }
}

/// The body of a function of a family.
pub(super) fn body(code: &FamilyCode<'_>, steps: &Steps, language: &dyn Language) -> Expressions {
    Expressions::new(steps, language, &|input| code.input(input), &code.taken())
}

/// The body of the function of a join.
pub(super) fn join_body(join: &JoinCode<'_>, language: &dyn Language) -> Expressions {
    Expressions::new(&join.steps.steps, language, &|input| join.input(input), &join.taken())
}

/// The sign that is assumed of something, and the expressions that compute it.
pub(super) fn join_assumption(
    join: &JoinCode<'_>,
    assumption: &Assumption<'_>,
    language: &dyn Language,
) -> (Expressions, String) {
    let expressions =
        Expressions::new(&assumption.steps, language, &|input| join.input(input), &join.taken());
    let condition = condition(assumption, &expressions, language);
    (expressions, condition)
}

/// What is assumed, as a comparison.
pub(super) fn condition(
    assumption: &Assumption<'_>,
    expressions: &Expressions,
    language: &dyn Language,
) -> String {
    let sign = if assumption.strict { ">" } else { ">=" };
    format!("{} {sign} {}", expressions.outputs[0].text, language.literal(&Rational::ZERO))
}

/// The components of given and of determined points of a join, as a loop over components has them: inputs with names, and
/// the places of the results. `element` is the component of a point in a list.
pub(super) fn join_components(
    join: &JoinCode<'_>,
    element: fn(&str, usize) -> String,
    place: fn(&str, usize) -> String,
) -> (Vec<(String, String)>, Vec<String>) {
    let mut inputs = Vec::new();
    for k in used(&join.steps.steps, point) {
        let (net, place) = join.given[k];
        inputs.push((join.input(Input::Point(k)), element(&join.points[net].name, place)));
    }
    let mut outputs = Vec::new();
    for net in &join.results {
        outputs.extend((0..net.labels.len()).map(|k| place(&net.name, k)));
    }
    (inputs, outputs)
}

/// Lines for each span of the domain, in a language with `if (…) {} else {}`; at a knot those of the later one. `of` stands
/// before a shape value that is a knot.
pub(super) fn on_spans(
    code: &FamilyCode<'_>,
    language: &dyn Language,
    of: &str,
    lines: &dyn Fn(&FamilySteps<'_>) -> String,
) -> String {
    let spans = code.steps.spans();
    if spans == 1 {
        return lines(&code.steps);
    }
    let (knots, t) = (code.knots(), &code.coordinates[0]);
    let knot = |knot: &Knot| {
        let of = if matches!(knot, Knot::Shape(_)) { of } else { "" };
        format!("{of}{}", knot_text(code, knot, language))
    };
    let mut text = String::new();
    for span in 0..spans {
        let own = indented(&lines(&code.steps.on_span(span)), "    ");
        text += &match span {
            _ if span + 1 == spans => format!("else {{\n{own}}}\n"),
            0 => format!("if ({t} < {}) {{\n{own}}}\n", knot(&knots[1])),
            _ => format!("else if ({t} < {}) {{\n{own}}}\n", knot(&knots[span + 1])),
        };
    }
    text
}

/// A knot as an expression.
pub(super) fn knot_text(code: &FamilyCode<'_>, knot: &Knot, language: &dyn Language) -> String {
    match knot {
        Knot::Number(value) if value.is_negative() => format!("-{}", language.literal(&value.abs())),
        Knot::Number(value) => language.literal(value),
        Knot::Shape(k) => code.input(Input::Shape(*k)),
    }
}

/// The shape values that the inner knots are, by position.
pub(super) fn inner_knots(code: &FamilyCode<'_>) -> Vec<usize> {
    let knots = code.knots();
    let inner = if code.is_curve() && knots.len() > 2 { &knots[1..knots.len() - 1] } else { &[] };
    let shape = |knot: &Knot| if let Knot::Shape(k) = knot { Some(*k) } else { None };
    let mut found = Vec::new();
    for k in inner.iter().filter_map(shape) {
        if !found.contains(&k) {
            found.push(k);
        }
    }
    found
}

/// The shape values that some steps use, by position.
pub(super) fn used_shapes(steps: &Steps) -> Vec<usize> {
    let shape = |input| if let Input::Shape(k) = input { Some(k) } else { None };
    steps.inputs().into_iter().filter_map(shape).collect()
}

/// The positions of the inputs of a kind that some steps use.
pub(super) fn used(steps: &Steps, kind: fn(Input) -> Option<usize>) -> Vec<usize> {
    steps.inputs().into_iter().filter_map(kind).collect()
}

/// For [`used`]: coordinates.
pub(super) fn coordinate(input: Input) -> Option<usize> {
    if let Input::Coordinate(k) = input { Some(k) } else { None }
}

/// For [`used`]: control points.
pub(super) fn point(input: Input) -> Option<usize> {
    if let Input::Point(k) = input { Some(k) } else { None }
}

/// For [`used`]: bound coefficients.
pub(super) fn bound(input: Input) -> Option<usize> {
    if let Input::Bound(k) = input { Some(k) } else { None }
}

/// For [`used`]: derivatives.
pub(super) fn derivative(input: Input) -> Option<usize> {
    if let Input::Derivative(k) = input { Some(k) } else { None }
}

/// The two comparisons that say that a value is in its range and finite, joined by `and`. `largest` is the largest finite
/// number of the type, or else what a finite number is below.
pub(super) fn inside(shape: &Shape<'_>, language: &dyn Language, and: &str, largest: (&str, &str)) -> String {
    let Shape { name, range, .. } = shape;
    let literal = |value: &Rational| {
        if value.is_negative() {
            format!("-{}", language.literal(&value.abs()))
        } else {
            language.literal(value)
        }
    };
    let (sign, largest) = largest;
    let low = match &range.low {
        End::Infinite => format!("{name} {} -{largest}", sign.replace('<', ">")),
        End::Included(value) => format!("{name} >= {}", literal(value)),
        End::Excluded(value) => format!("{name} > {}", literal(value)),
    };
    let high = match &range.high {
        End::Infinite => format!("{name} {sign} {largest}"),
        End::Included(value) => format!("{name} <= {}", literal(value)),
        End::Excluded(value) => format!("{name} < {}", literal(value)),
    };
    if and == "&" { format!("({low}) & ({high})") } else { format!("{low} {and} {high}") }
}

/// Whether an error is relative, and the number of ε, as text; `None` where none is proved.
pub(super) fn bound_text(error: Option<&Error>) -> Option<(bool, String)> {
    let error = error?;
    let text = decimal(error.epsilons());
    let text = if text.contains('.') { text } else { text + ".0" };
    Some((matches!(error, Error::Relative(_)), text))
}
