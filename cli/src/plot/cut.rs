//! Functions of three variables, cut at a value of one of them: what is left is a triangle or a box.

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::rational::Rational;
use basis_engine::model::Factor;
use basis_engine::{Diagnostic, Family};

use super::failures::Failure;
use crate::args::{ShapeArgument, ShapeValues};
use crate::name;
use crate::output::error;

/// Where the functions are cut.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    /// The place of the variable among those of the domain.
    place: usize,
    value: Rational,
    /// Such as `z = 1/2`.
    pub(super) label: String,
}

/// Where a family of three variables is cut: at the value that the argument names, else where a claim fails, else in the
/// middle of its last interval.
///
/// # Errors
/// When there is no interval to cut, and for a name or a value that the domain does not have.
pub(super) fn place(
    family: &Family,
    argument: Option<&ShapeArgument>,
    failure: Option<&Failure>,
) -> Result<Cut, Diagnostic> {
    let mut intervals: Vec<usize> = Vec::new();
    let mut at = 0;
    for factor in family.factors() {
        at += match factor {
            Factor::Interval(_) => {
                intervals.push(at);
                1
            }
            Factor::Simplex(independent, _) => independent.len(),
        };
    }
    let Some(last) = intervals.last().copied().filter(|_| family.domain.len() == 3) else {
        let count = family.domain.len();
        let message = format!("the functions of `{}` have {count} variables and no picture", family.title());
        return Err(error(message).help(
            "draw a family on an interval, a triangle or a box of two variables, or on one of three with an interval \
             at whose values it can be cut",
        ));
    };
    let names: Vec<&str> = intervals.iter().map(|k| family.domain[*k].name.as_str()).collect();
    let (place, value) = match argument {
        None => {
            let seen = failure.and_then(|f| f.at.get(last).cloned().flatten());
            let (low, high) =
                family.domain[last].range.finite().ok_or_else(|| error("the domain has no ends"))?;
            (last, seen.unwrap_or_else(|| &(low + high) * &Rational::new(1, 2)))
        }
        Some(argument) => {
            let Some(k) = name::position(&argument.name, &names) else {
                let message =
                    format!("`{}` is not an interval of the domain of `{}`", argument.name, family.title());
                return Err(
                    error(message).help(format!("the functions can be cut at {}", name::list(&names)))
                );
            };
            let ShapeValues::One(number) = &argument.values else {
                let message = format!("the functions are cut at one value of `{}`", argument.name);
                return Err(error(message).help(format!("write `--at {}=1/2`", argument.name)));
            };
            let parameter = &family.domain[intervals[k]];
            let value = number.value();
            if !parameter.range.contains(&value) {
                let declared = family.declared(parameter);
                let message = format!("{} = {number} is outside of the domain `{declared}`", parameter.name);
                return Err(error(message).help("cut at a value of the domain"));
            }
            (intervals[k], value)
        }
    };
    let label = format!("{} = {value}", family.domain[place].name);
    Ok(Cut { place, value, label })
}

/// The family on what is left of its domain.
///
/// # Errors
/// When a function has no value there.
pub(super) fn family(family: &Family, cut: &Cut) -> Result<Family, Diagnostic> {
    let mut left = family.clone();
    let variable = left.domain.remove(cut.place).var;
    for simplex in left.simplices.iter_mut().filter(|s| s.places.start > cut.place) {
        simplex.places = simplex.places.start - 1..simplex.places.end - 1;
    }
    let value = Fraction::constant(cut.value.clone());
    for f in &mut left.functions {
        f.value = f.value.substitute(variable, &value).ok_or_else(|| {
            error(format!("a function of `{}` has no value at {}", family.title(), cut.label))
        })?;
    }
    Ok(left)
}

/// The failures that lie on the cut, or do not depend on where it is.
pub(super) fn failures(all: Vec<Failure>, cut: &Cut) -> Vec<Failure> {
    let on = |mut failure: Failure| {
        let there = failure.at.get(cut.place)?.as_ref().is_none_or(|x| *x == cut.value);
        failure.at.remove(cut.place);
        there.then_some(failure)
    };
    all.into_iter().filter_map(on).collect()
}
