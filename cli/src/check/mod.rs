//! `basis check`: proves the claims of spec files.

pub(crate) mod files;
mod messages;
pub(crate) mod orders;
pub(crate) mod prove;
mod published;
mod report;
mod rows;
mod statements;
mod text;

use std::path::Path;
use std::time::Instant;

use basis_engine::Sources;

use crate::args::{CheckArguments, Format};
use crate::certificates;
use crate::output::{self, Status};
pub(crate) use published::Published;

/// Checks everything that the arguments name, and prints it.
pub(crate) fn run(arguments: &CheckArguments) -> Status {
    let entries = files::find(&arguments.paths);
    match arguments.format {
        Format::Text => as_text(entries, arguments.certificates.as_deref()),
        Format::Json => as_json(entries, arguments.certificates.as_deref()),
    }
}

/// Writes the certificates of a file if that is wanted.
fn certify(folder: Option<&Path>, outcome: &prove::Outcome) -> Status {
    let problems = folder.map_or_else(Vec::new, |folder| certificates::write(folder, outcome));
    for problem in &problems {
        output::complain(&(problem.render(&Sources::default(), true) + "\n"));
    }
    if problems.is_empty() { Status::Fine } else { Status::Unusable }
}

/// Every file is printed when it is done.
fn as_text(entries: Vec<files::Entry>, folder: Option<&Path>) -> Status {
    let start = Instant::now();
    let mut status = Status::Fine;
    let mut summary = text::Summary::default();
    let mut messages = messages::Printer::default();
    let mut statements = Vec::new();
    for entry in entries {
        let outcome = prove::file(entry);
        status = status.max(outcome.status()).max(certify(folder, &outcome));
        summary.add(&outcome);
        published::collect(&outcome, &mut statements);
        if outcome.readable {
            status = status.max(output::print(&text::file(&outcome, output::width())));
        }
        output::complain(&messages.render(&outcome));
    }
    status = status.max(output::print(&published::text(&statements, output::width())));
    status.max(output::print(&summary.line(start.elapsed())))
}

fn as_json(entries: Vec<files::Entry>, folder: Option<&Path>) -> Status {
    let mut status = Status::Fine;
    let mut files = Vec::new();
    let mut statements = Vec::new();
    for entry in entries {
        let outcome = prove::file(entry);
        status = status.max(outcome.status()).max(certify(folder, &outcome));
        published::collect(&outcome, &mut statements);
        files.push(report::File::new(&outcome));
    }
    status.max(output::print_json(&report::Report::new(files, statements)))
}

/// The published statements of a spec given as text, with what is known about them.
pub(crate) fn published(name: &str, text: &str) -> Vec<Published> {
    let mut statements = Vec::new();
    published::collect(&prove::text(name, text), &mut statements);
    statements
}
