//! The shape values for which a picture is drawn.

use basis_engine::algebra::range::{DisplayRange as _, Range};
use basis_engine::algebra::rational::Rational;
use basis_engine::model::Parameter;
use basis_engine::{Diagnostic, Family};

use super::marks::Failure;
use crate::args::{ShapeArgument, ShapeValues};
use crate::eval::inside_of as inside;
use crate::name;
use crate::output::error;

/// How many values of a range are drawn.
const STEPS: i64 = 5;

/// A value for each shape parameter.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Setting {
    /// By variable.
    pub(super) values: Vec<Rational>,
    /// Such as `λ = 1/2`; what all settings have in common is left out where there are several.
    pub(super) label: String,
    /// What all settings have in common where there are several, such as `μ = 1/2`.
    pub(super) common: String,
}

/// The settings that the arguments name; a parameter that they do not name has the value at which a claim fails, if one
/// does, or else a simple one inside of its range.
///
/// # Errors
/// Every name that is unknown or doubled, and every value outside of its range.
pub(super) fn settings(
    family: &Family,
    arguments: &[ShapeArgument],
    failure: Option<&Failure>,
) -> Result<Vec<Setting>, Vec<Diagnostic>> {
    let names: Vec<&str> = family.shapes.iter().map(|p| p.name.as_str()).collect();
    let mut values: Vec<Option<Vec<Rational>>> = vec![None; family.shapes.len()];
    let mut errors = Vec::new();
    for argument in arguments {
        let Some(k) = name::position(&argument.name, &names) else {
            let message = format!("`{}` is not a shape parameter of `{}`", argument.name, family.title());
            let help = match names.as_slice() {
                [] => String::from("the family has no shape parameters"),
                all => format!("the shape parameters are {}", name::list(all)),
            };
            errors.push(error(message).help(help));
            continue;
        };
        let parameter = &family.shapes[k];
        if values[k].is_some() {
            errors.push(error(format!("the shape parameter `{}` is given twice", parameter.name)));
        }
        let wanted = match &argument.values {
            ShapeValues::One(value) => vec![value.clone()],
            ShapeValues::Between(low, high) => steps(&parameter.range, low, high),
        };
        if let Some(outside) = wanted.iter().find(|value| !parameter.range.contains(value)) {
            let range = parameter.range.display(&parameter.name);
            let message =
                format!("{} = {outside} is outside of the declared range `{range}`", parameter.name);
            let help = format!("choose a value inside: --shape {}={}", parameter.name, inside(parameter));
            errors.push(error(message).help(help));
        }
        values[k] = Some(wanted);
    }
    let ranged: Vec<&Parameter> = family
        .shapes
        .iter()
        .zip(&values)
        .filter(|(_, v)| v.as_ref().is_some_and(|v| v.len() > 1))
        .map(|(p, _)| p)
        .collect();
    if let [first, second, ..] = ranged.as_slice() {
        let message = format!("`{}` and `{}` are both given as ranges", first.name, second.name);
        errors.push(error(message).help("draw one range at a time, and give the other parameter a value"));
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    let fixed = |k: usize| {
        failure.and_then(|f| f.shapes.get(k).cloned()).unwrap_or_else(|| inside(&family.shapes[k]))
    };
    let all: Vec<Vec<Rational>> =
        values.into_iter().enumerate().map(|(k, v)| v.unwrap_or_else(|| vec![fixed(k)])).collect();
    let count = all.iter().map(Vec::len).max().unwrap_or(1);
    let setting = |step: usize| {
        let values: Vec<Rational> = all.iter().map(|v| v[step.min(v.len() - 1)].clone()).collect();
        let named = names.iter().zip(&values).zip(&all);
        let named = named.map(|((name, value), own)| (own.len() > 1, format!("{name} = {value}")));
        let (own, common): (Vec<_>, Vec<_>) = named.partition(|(differs, _)| count == 1 || *differs);
        let text = |parts: Vec<(bool, String)>| parts.into_iter().map(|p| p.1).collect::<Vec<_>>().join(", ");
        let (label, common) = (text(own), text(common));
        Setting { values, label, common }
    };
    Ok((0..count).map(setting).collect())
}

/// Values from one to another, without an end that the declared range leaves out.
fn steps(range: &Range, low: &Rational, high: &Rational) -> Vec<Rational> {
    let at = |k: i64, n: i64| low + &(&(high - low) * &Rational::new(k, n));
    let all = |n: i64, from: i64| (from..from + STEPS).map(|k| at(k, n)).collect::<Vec<_>>();
    match (range.contains(low), range.contains(high)) {
        (false, true) if range.low.value() == Some(low) => all(STEPS, 1),
        (true, false) if range.high.value() == Some(high) => all(STEPS, 0),
        (false, false) if range.low.value() == Some(low) && range.high.value() == Some(high) => {
            all(STEPS + 1, 1)
        }
        _ => all(STEPS - 1, 0),
    }
}
