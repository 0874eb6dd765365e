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
use crate::coq;
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
    let mut exports = Exports {
        certificates: arguments.certificates.as_deref().map(|dir| (dir, Manifest::new(&arguments.paths))),
        coq: arguments.coq.as_deref().map(|dir| (dir, coq::Export::default())),
        format: arguments.format,
        quiet: arguments.quiet,
        status: Status::Fine,
    };
    let status = match arguments.format {
        Format::Text => as_text(entries, arguments.quiet, &mut exports, read),
        Format::Json => as_json(entries, &mut exports),
    };
    status.max(exports.finish())
}

/// What is written into folders.
struct Exports<'a> {
    certificates: Option<(&'a Path, Manifest)>,
    coq: Option<(&'a Path, coq::Export)>,
    format: Format,
    /// Whether only errors are printed, and what is not exported.
    quiet: bool,
    status: Status,
}

impl Exports<'_> {
    /// What the files need that are written.
    const fn formulas(&self) -> prove::Formal {
        if self.coq.is_some() { prove::Formal::Kept } else { prove::Formal::Left }
    }

    /// Writes what belongs to one file.
    fn add(&mut self, outcome: &prove::Outcome) {
        let mut problems = Vec::new();
        if let Some((folder, manifest)) = &mut self.certificates {
            problems = certificates::write(folder, outcome);
            if outcome.readable {
                manifest.add(outcome);
            }
        }
        if let Some((folder, export)) = &mut self.coq {
            problems.extend(export.add(folder, outcome).err().map(output::error));
        }
        for problem in problems {
            self.complain(&problem);
        }
    }

    /// Writes what belongs to all of them.
    fn finish(mut self) -> Status {
        // Without a single certificate there is no folder.
        if let Some((folder, manifest)) = self.certificates.take()
            && folder.is_dir()
            && let Err(e) = manifest.write(folder)
        {
            self.complain(&output::error(e));
        }
        if let Some((folder, export)) = self.coq.take() {
            match export.finish(folder) {
                Ok(said) => {
                    match self.format {
                        Format::Text if self.quiet && export.is_complete() => {}
                        Format::Text => self.status = self.status.max(output::print(&said)),
                        Format::Json => output::complain(&said), // standard output has one value of JSON
                    }
                    if !export.is_complete() {
                        self.status = self.status.max(Status::Wrong);
                    }
                }
                Err(e) => self.complain(&output::error(e)),
            }
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
    exports: &mut Exports<'_>,
    read: &mut Vec<PathBuf>,
) -> Status {
    let start = Instant::now();
    let mut status = Status::Fine;
    let mut summary = text::Summary::default();
    let mut messages = messages::Printer::default();
    let mut statements = Vec::new();
    for entry in entries {
        let outcome = prove::file(entry, exports.formulas());
        status = status.max(outcome.status());
        exports.add(&outcome);
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

fn as_json(entries: Vec<files::Entry>, exports: &mut Exports<'_>) -> Status {
    let mut status = Status::Fine;
    let mut files = Vec::new();
    let mut statements = Vec::new();
    for entry in entries {
        let outcome = prove::file(entry, exports.formulas());
        status = status.max(outcome.status());
        exports.add(&outcome);
        published::collect(&outcome, &mut statements);
        files.push(report::File::new(&outcome));
    }
    status.max(output::print_json(&report::Report::new(
        files,
        statements.into_iter().map(Into::into).collect(),
    )))
}
