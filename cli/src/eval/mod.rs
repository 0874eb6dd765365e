//! `basis eval`: exact values of basis functions and their derivatives.

mod assign;
mod control;
mod derivatives;
mod family;
pub(crate) mod number;
mod point;
mod report;

use std::rc::Rc;

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::poly::Poly;
use basis_engine::{Diagnostic, Disk, Family, Library, Prover, Sources};

use crate::args::{EvalArguments, EvalFormat};
use crate::output::{self, Status, complain, error};
use crate::spec;
use derivatives::Derivative;
use point::{Combination, Point};
use report::{Report, Values};

pub(crate) use assign::inside_of;

/// More values than this are not printed.
const MAX_VALUES: usize = 1_000_000;

/// Evaluates the family that the arguments name, and prints the values.
pub(crate) fn run(arguments: &EvalArguments) -> Status {
    let library = match spec::read(&arguments.file) {
        Ok(source) => Library::from_source(&Disk, &Prover, source),
        Err(error) => return refuse(&Sources::default(), &[error]),
    };
    match evaluate(arguments, &library) {
        Ok(report) => match arguments.format {
            EvalFormat::Text => output::print(&report.text(arguments.decimal, output::width())),
            EvalFormat::Json => output::print_json(&report.json()),
            EvalFormat::Csv => output::print(&report.csv(arguments.decimal)),
        },
        Err(errors) => refuse(library.sources(), &errors),
    }
}

/// The family that a text such as `Bernstein(n=3)` names.
pub(crate) fn find_family(library: &Library<'_>, text: &str) -> Result<Rc<Family>, Vec<Diagnostic>> {
    family::find(library, text)
}

/// The same, if this family can be expanded, whatever is wrong with others.
pub(crate) fn find_despite_errors(library: &Library<'_>, text: &str) -> Result<Rc<Family>, Vec<Diagnostic>> {
    family::despite_errors(library, text)
}

/// The only family of a spec, in its lowest order.
pub(crate) fn only_family(library: &Library<'_>) -> Result<Rc<Family>, Vec<Diagnostic>> {
    family::only(library)
}

fn refuse(sources: &Sources, errors: &[Diagnostic]) -> Status {
    for error in errors {
        complain(&(error.render(sources, true) + "\n\n"));
    }
    Status::Unusable
}

fn evaluate(arguments: &EvalArguments, library: &Library<'_>) -> Result<Report, Vec<Diagnostic>> {
    let family = match &arguments.family {
        Some(name) => family::find(library, name)?,
        None => family::only(library)?,
    };
    let one = |e: Diagnostic| vec![e];
    let control = match &arguments.points {
        Some(text) => control::points(text, &family).map_err(one)?,
        None => Vec::new(),
    };
    let names: Vec<&str> = family.domain_variables().map(|p| assign::written(&family, p)).collect();
    let settings = point::combinations(&arguments.shapes, &[], false).map_err(one)?;
    let places = point::combinations(&arguments.at, &names, true).map_err(one)?;
    let single = settings.len() == 1 && places.len() == 1 && !settings[0].stepped && !places[0].stepped;
    let mut rows = Vec::new();
    for setting in &settings {
        // The derivatives on each span at these shape values.
        let mut known: Vec<(Rc<Family>, Vec<Derivative>)> = Vec::new();
        for place in &places {
            let point = match Point::new(&family, &setting.given, &place.given, arguments.anyway) {
                Ok(point) => point,
                // Of a grid on a triangle half of the points are meant.
                Err(_) if skips(&family, setting, place, arguments.anyway) => continue,
                Err(errors) => return Err(errors),
            };
            let place = known.iter().position(|(piece, _)| Rc::ptr_eq(piece, &point.family));
            let place = match place {
                Some(place) => place,
                None => {
                    let functions = bound(&point).map_err(one)?;
                    let all = derivatives::up_to(&point.family, functions, arguments.order).map_err(one)?;
                    known.push((Rc::clone(&point.family), all));
                    known.len() - 1
                }
            };
            let (_, all) = &known[place];
            let values = all.iter().map(|d| d.functions.len()).sum::<usize>();
            if (rows.len() + 1).saturating_mul(values) > MAX_VALUES {
                let message = format!("there are more than {MAX_VALUES} values");
                return Err(one(error(message).help("choose a larger step, or fewer derivatives")));
            }
            let row = Values::new(&family, &point, all, &control);
            rows.push(row.ok_or_else(|| one(pole(&point)))?);
        }
    }
    if rows.is_empty() {
        return Err(one(error("no point lies in the domain").help("choose a smaller step")));
    }
    Ok(Report { title: family.title(), rows, single })
}

/// Whether a point of a grid is outside of a simplex although each coordinate is in its range.
fn skips(family: &Rc<Family>, setting: &Combination<'_>, place: &Combination<'_>, anyway: bool) -> bool {
    let variables: Vec<_> = family.domain_variables().collect();
    let names: Vec<&str> = variables.iter().map(|p| p.name.as_str()).collect();
    let inside = |given: &assign::Given<'_>| {
        crate::name::position(given.name, &names)
            .is_some_and(|k| variables[k].range.contains(&given.value.value()))
    };
    !family.simplices.is_empty()
        && place.stepped
        && !anyway
        && place.given.iter().all(inside)
        && Point::new(family, &setting.given, &place.given, true).is_ok()
}

/// The functions with the exact ones of the shape values put in.
fn bound(point: &Point) -> Result<Vec<Fraction>, Diagnostic> {
    let family = &point.family;
    let exact = family.shapes.iter().filter(|s| !point.is_rounded(&Fraction::var(s.var)));
    let exact: Vec<_> = exact.map(|s| (s.var, &point.values()[s.var.0])).collect();
    let put = |p: &Poly| exact.iter().fold(p.clone(), |p, (var, value)| p.at(*var, value));
    let functions = family.functions.iter().map(|function| {
        let value = Fraction::new(put(function.value.numer()), put(function.value.denom()));
        value.ok_or_else(|| pole(point))
    });
    functions.collect()
}

/// A denominator is zero at a point.
fn pole(point: &Point) -> Diagnostic {
    let family = &point.family;
    let zero =
        |f: &Fraction| Fraction::from(f.denom().clone()).eval(point.values()).is_some_and(|x| x.is_zero());
    let function = family.functions.iter().position(|f| zero(&f.value)).unwrap_or(0);
    let shown = family.functions[function].value.denom().display(&family.names).to_string();
    error(format!(
        "the denominator of `{}` is zero at {}",
        family.function_label(function),
        point.describe(family.shapes.iter().chain(family.domain_variables()))
    ))
    .note(format!("the denominator is `{shown}`"))
    .help("choose other values")
}
