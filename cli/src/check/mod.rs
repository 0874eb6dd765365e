//! `basis check`: proves the claims of spec files.

mod files;
mod messages;
mod orders;
mod prove;
mod published;
mod report;
mod rows;
mod statements;
mod text;

use std::time::Instant;

use crate::args::{CheckArguments, Format};
use crate::output::{self, Status};

/// Checks everything that the arguments name, and prints it.
pub(crate) fn run(arguments: &CheckArguments) -> Status {
    let entries = files::find(&arguments.paths);
    match arguments.format {
        Format::Text => as_text(entries),
        Format::Json => as_json(entries),
    }
}

/// Every file is printed when it is done.
fn as_text(entries: Vec<files::Entry>) -> Status {
    let start = Instant::now();
    let mut status = Status::Fine;
    let mut summary = text::Summary::default();
    let mut messages = messages::Printer::default();
    let mut statements = Vec::new();
    for entry in entries {
        let outcome = prove::file(entry);
        status = status.max(outcome.status());
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

fn as_json(entries: Vec<files::Entry>) -> Status {
    let mut status = Status::Fine;
    let mut files = Vec::new();
    let mut statements = Vec::new();
    for entry in entries {
        let outcome = prove::file(entry);
        status = status.max(outcome.status());
        published::collect(&outcome, &mut statements);
        files.push(report::File::new(&outcome));
    }
    status.max(output::print_json(&report::Report::new(files, statements)))
}
