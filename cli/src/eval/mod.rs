//! `basis eval`: exact values of basis functions and their derivatives.

mod assign;
mod derivatives;
mod family;
mod point;
mod report;

use std::rc::Rc;

use basis_engine::{Diagnostic, Disk, Family, Library, Prover, Sources};

use crate::args::{EvalArguments, Format};
use crate::output::{self, Status, complain};
use crate::spec;
use report::Values;

pub(crate) use assign::inside;

/// Evaluates the family that the arguments name, and prints the values.
pub(crate) fn run(arguments: &EvalArguments) -> Status {
    let library = match spec::read(&arguments.file) {
        Ok(source) => Library::from_source(&Disk, &Prover, source),
        Err(error) => return refuse(&Sources::default(), &[error]),
    };
    match evaluate(arguments, &library) {
        Ok(values) => match arguments.format {
            Format::Text => output::print(&values.text(output::width())),
            Format::Json => output::print_json(&values.json()),
        },
        Err(errors) => refuse(library.sources(), &errors),
    }
}

/// The family that a text such as `Bernstein(n=3)` names.
pub(crate) fn find_family(library: &Library<'_>, text: &str) -> Result<Rc<Family>, Vec<Diagnostic>> {
    family::find(library, text)
}

fn refuse(sources: &Sources, errors: &[Diagnostic]) -> Status {
    for error in errors {
        complain(&(error.render(sources, true) + "\n\n"));
    }
    Status::Unusable
}

fn evaluate(arguments: &EvalArguments, library: &Library<'_>) -> Result<Values, Vec<Diagnostic>> {
    let family = family::find(library, &arguments.family)?;
    let family = point::on_span(&family, &arguments.at);
    let point = point::Point::new(&family, &arguments.shapes, &arguments.at)?;
    let functions = point.bind(&family).map_err(|e| vec![e])?;
    let derivatives = derivatives::up_to(&family, functions, arguments.order).map_err(|e| vec![e])?;
    Ok(Values::new(&family, &point, &derivatives))
}
