//! The shape values for which a picture is drawn.

use basis_engine::algebra::range::{DisplayRange as _, End};
use basis_engine::algebra::rational::Rational;
use basis_engine::model::Parameter;
use basis_engine::model::angle::{Analytic, Angle};
use basis_engine::{Diagnostic, Family};

use super::failures::Failure;
use crate::args::{ShapeArgument, ShapeValues};
use crate::eval::inside_of as inside;
use crate::eval::number::Number;
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
    let names: Vec<&str> = family.shapes.iter().map(|p| family.name_of(p)).collect();
    let mut values: Vec<Option<Vec<Value>>> = vec![None; family.shapes.len()];
    let mut errors = Vec::new();
    let words: Vec<&str> = arguments.iter().map(|argument| argument.name.as_str()).collect();
    for (argument, mut meant) in arguments.iter().zip(name::each_position(&words, &names)) {
        // Of an angle its own name, or that of its tangent.
        let tangent = meant.is_empty();
        if tangent {
            let tangents: Vec<&str> = family.shapes.iter().map(|p| p.name.as_str()).collect();
            meant.extend(name::position(&argument.name, &tangents));
        }
        if meant.is_empty() {
            let message = format!("`{}` is not a shape parameter of `{}`", argument.name, family.title());
            let help = match names.as_slice() {
                [] => String::from("the family has no shape parameters"),
                all => format!("the shape parameters are {}", name::list(all)),
            };
            errors.push(error(message).help(help));
        }
        for k in meant {
            let known = values[k].is_some();
            let own = Own::new(family, k, tangent);
            values[k] = Some(wanted(&own, argument, known, &mut errors));
        }
    }
    // Entries of a list change together.
    let ranged = arguments.iter().filter(|a| matches!(a.values, ShapeValues::Between(..)));
    if let [first, second, ..] = ranged.collect::<Vec<_>>().as_slice() {
        let message = format!("`{}` and `{}` are both given as ranges", first.name, second.name);
        errors.push(error(message).help("draw one range at a time, and give the other parameter a value"));
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    let fixed = |k: usize| {
        let parameter = &family.shapes[k];
        let value =
            failure.and_then(|f| f.shapes.get(k).cloned().flatten()).unwrap_or_else(|| inside(parameter));
        Value { shown: format!("{} = {value}", parameter.name), value }
    };
    let all: Vec<Vec<Value>> =
        values.into_iter().enumerate().map(|(k, v)| v.unwrap_or_else(|| vec![fixed(k)])).collect();
    let count = all.iter().map(Vec::len).max().unwrap_or(1);
    let setting = |step: usize| {
        let values: Vec<&Value> = all.iter().map(|v| &v[step.min(v.len() - 1)]).collect();
        let named = values.iter().zip(&all).map(|(value, own)| (own.len() > 1, value.shown.as_str()));
        let (own, common): (Vec<_>, Vec<_>) = named.partition(|(differs, _)| count == 1 || *differs);
        let text = |parts: Vec<(bool, &str)>| parts.into_iter().map(|p| p.1).collect::<Vec<_>>().join(", ");
        let (label, common) = (text(own), text(common));
        Setting { values: values.into_iter().map(|v| v.value.clone()).collect(), label, common }
    };
    Ok((0..count).map(setting).collect())
}

/// A value of a shape parameter.
#[derive(Clone, Debug)]
struct Value {
    /// Such as `α = pi/3`.
    shown: String,
    /// What its variable becomes: of an angle the tangent.
    value: Rational,
}

/// A shape parameter as it is named: an angle, or its tangent.
struct Own<'f> {
    parameter: &'f Parameter,
    name: &'f str,
    angle: Option<&'f Angle>,
    analytic: &'f Analytic,
    /// Such as `0 < α < pi`.
    declared: String,
}

impl<'f> Own<'f> {
    fn new(family: &'f Family, k: usize, tangent: bool) -> Self {
        let parameter = &family.shapes[k];
        if tangent {
            let declared = parameter.range.display(&parameter.name).to_string();
            return Self {
                parameter,
                name: &parameter.name,
                angle: None,
                analytic: &family.analytic,
                declared,
            };
        }
        let (name, angle) = (family.name_of(parameter), family.analytic.angle(parameter.var));
        Self { parameter, name, angle, analytic: &family.analytic, declared: family.declared(parameter) }
    }
}

/// The values of one shape parameter; `known` if it has some already.
fn wanted(own: &Own<'_>, argument: &ShapeArgument, known: bool, errors: &mut Vec<Diagnostic>) -> Vec<Value> {
    let Own { parameter, name, angle, analytic, declared } = own;
    let (parameter, angle) = (*parameter, *angle);
    if known {
        errors.push(error(format!("the shape parameter `{name}` is given twice")));
    }
    let value = |number: &Number| {
        number.of_parameter(angle, analytic).filter(|value| parameter.range.contains(value))
    };
    let numbers = match &argument.values {
        ShapeValues::One(number) => vec![number.clone()],
        ShapeValues::Between(low, high) => {
            // An end that the range leaves out; one without a tangent is one.
            let left_out = |number: &Number, end: &End| {
                let at_end = |value: Rational| end.value() == Some(&value) && !end.is_included();
                number.of_parameter(angle, analytic).is_none_or(at_end)
            };
            steps([low, high], [left_out(low, &parameter.range.low), left_out(high, &parameter.range.high)])
        }
    };
    let mut all = Vec::new();
    for number in numbers {
        match value(&number) {
            Some(value) => all.push(Value { shown: format!("{name} = {number}"), value }),
            None => {
                let message = format!("{name} = {number} is outside of the declared range `{declared}`");
                let help = match angle {
                    Some(_) => String::from("choose a value inside"),
                    None => format!("choose a value inside: --shape {name}={}", inside(parameter)),
                };
                errors.push(error(message).help(help));
                break;
            }
        }
    }
    all
}

/// Values from one to another, without the ends that are left out.
fn steps([low, high]: [&Number; 2], left_out: [bool; 2]) -> Vec<Number> {
    let all = |n: i64, from: i64| (from..from + STEPS).map(|k| Number::between(low, high, k, n)).collect();
    match left_out {
        [true, false] => all(STEPS, 1),
        [false, true] => all(STEPS, 0),
        [true, true] => all(STEPS + 1, 1),
        [false, false] => all(STEPS - 1, 0),
    }
}
