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

use basis_engine::{Diagnostic, Sources};

use crate::args::{CheckArguments, Format};
use crate::certificates::{self, Manifest};
use crate::output::{self, Status};

/// Checks everything that the arguments name, and prints it.
pub(crate) fn run(arguments: &CheckArguments) -> Status {
    let entries = files::find(&arguments.paths);
    let mut certificates = arguments.certificates.as_deref().map(|folder| Certificates {
        folder,
        manifest: Manifest::new(&arguments.paths),
        status: Status::Fine,
    });
    let status = match arguments.format {
        Format::Text => as_text(entries, &mut certificates),
        Format::Json => as_json(entries, &mut certificates),
    };
    status.max(certificates.map_or(Status::Fine, Certificates::finish))
}

/// Where certificates are written.
struct Certificates<'a> {
    folder: &'a Path,
    manifest: Manifest,
    status: Status,
}

impl Certificates<'_> {
    /// Writes the certificates of a file.
    fn add(&mut self, outcome: &prove::Outcome) {
        for problem in certificates::write(self.folder, outcome) {
            self.complain(&problem);
        }
        if outcome.readable {
            self.manifest.add(outcome);
        }
    }

    /// Writes the list of what was added.
    fn finish(mut self) -> Status {
        let manifest = std::mem::take(&mut self.manifest);
        // Without a single certificate there is no folder.
        if self.folder.is_dir()
            && let Err(e) = manifest.write(self.folder)
        {
            self.complain(&output::error(e));
        }
        self.status
    }

    fn complain(&mut self, problem: &Diagnostic) {
        output::complain(&(problem.render(&Sources::default(), true) + "\n"));
        self.status = Status::Unusable;
    }
}

/// Every file is printed when it is done.
fn as_text(entries: Vec<files::Entry>, certificates: &mut Option<Certificates<'_>>) -> Status {
    let start = Instant::now();
    let mut status = Status::Fine;
    let mut summary = text::Summary::default();
    let mut messages = messages::Printer::default();
    let mut statements = Vec::new();
    for entry in entries {
        let outcome = prove::file(entry);
        status = status.max(outcome.status());
        if let Some(certificates) = certificates {
            certificates.add(&outcome);
        }
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

fn as_json(entries: Vec<files::Entry>, certificates: &mut Option<Certificates<'_>>) -> Status {
    let mut status = Status::Fine;
    let mut files = Vec::new();
    let mut statements = Vec::new();
    for entry in entries {
        let outcome = prove::file(entry);
        status = status.max(outcome.status());
        if let Some(certificates) = certificates {
            certificates.add(&outcome);
        }
        published::collect(&outcome, &mut statements);
        files.push(report::File::new(&outcome));
    }
    status.max(output::print_json(&report::Report::new(
        files,
        statements.into_iter().map(Into::into).collect(),
    )))
}
