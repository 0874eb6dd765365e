//! What the targets share: lines of code, conditions on shape values, and the constants of a file.

use super::{Expressions, FamilyCode, JoinCode, Language, Shape};
use crate::algebra::range::End;
use crate::algebra::rational::Rational;
use crate::plan::Input;
use crate::rounding::{Error, decimal};
use crate::steps::Steps;

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
