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
mod watch;

use std::path::{Path, PathBuf};
use std::time::Instant;

use basis_engine::{Diagnostic, Sources};

use crate::args::{CheckArguments, Format};
use crate::certificates::{self, Manifest};
use crate::output::{self, Status};
use crate::spec::STDIN;

/// Checks everything that the arguments name, and prints it; with `--watch` again and again.
pub(crate) fn run(arguments: &CheckArguments) -> Status {
    let input = arguments.paths.iter().any(|path| path == Path::new(STDIN));
    if input && (arguments.watch || arguments.certificates.is_some()) {
        let (what, why) = if arguments.watch {
            ("--watch", "it does not change")
        } else {
            ("--certificates", "`basis verify` could not read it again")
        };
        let error = output::error(format!("standard input cannot be checked with `{what}`: {why}"));
        output::complain(&(error.help("name a file").render(&Sources::default(), true) + "\n"));
        return Status::Unusable;
    }
    if arguments.watch {
        return watch::run(arguments);
    }
    once(arguments, &mut Vec::new())
}

/// Checks everything that the arguments name, prints it, and notes the files that were read.
fn once(arguments: &CheckArguments, read: &mut Vec<PathBuf>) -> Status {
    let entries = files::find(&arguments.paths);
    let mut certificates = arguments.certificates.as_deref().map(|folder| Certificates {
        folder,
        manifest: Manifest::new(&arguments.paths),
        status: Status::Fine,
    });
    let status = match arguments.format {
        Format::Text => as_text(entries, arguments.quiet, &mut certificates, read),
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
fn as_text(
    entries: Vec<files::Entry>,
    quiet: bool,
    certificates: &mut Option<Certificates<'_>>,
    read: &mut Vec<PathBuf>,
) -> Status {
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
        read.extend(outcome.sources.iter().filter_map(|(_, source)| source.path.clone()));
        if outcome.readable && !quiet {
            status = status.max(output::print(&text::file(&outcome, output::width())));
        }
        output::complain(&messages.render(&outcome));
    }
    if quiet {
        return status;
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
