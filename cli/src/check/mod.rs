//! `basis check`: proves the claims of spec files.

pub(crate) mod files;
mod messages;
pub(crate) mod orders;
mod parallel;
pub(crate) mod prove;
mod published;
mod report;
mod rows;
mod statements;
mod text;
mod watch;

use std::path::{Path, PathBuf};
use std::time::Instant;

use basis_engine::published::Published;
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

/// Every file is printed when it and those before it are done.
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
    let width = output::width();
    each(entries, exports, &|outcome| FileText::new(outcome, quiet, width), &mut |file| {
        status = status.max(file.status);
        summary.join(&file.summary);
        published::join(&mut statements, file.statements);
        read.extend(file.read);
        status = status.max(output::print(&file.table));
        output::complain(&messages.render(file.messages));
    });
    if quiet {
        return status;
    }
    status = status.max(output::print(&published::text(&statements, width)));
    status.max(output::print(&summary.line(start.elapsed())))
}

/// What is printed of one file, and counted.
struct FileText {
    status: Status,
    summary: text::Summary,
    statements: Vec<Published>,
    read: Vec<PathBuf>,
    table: String,
    messages: Vec<String>,
}

impl FileText {
    fn new(outcome: &prove::Outcome, quiet: bool, width: Option<u16>) -> Self {
        let mut summary = text::Summary::default();
        summary.add(outcome);
        let shown = outcome.readable && !quiet;
        Self {
            status: outcome.status(),
            summary,
            statements: published::collect(outcome),
            read: outcome.sources.iter().filter_map(|(_, source)| source.path.clone()).collect(),
            table: if shown { text::file(outcome, width) } else { String::new() },
            messages: messages::of(outcome),
        }
    }
}

fn as_json(entries: Vec<files::Entry>, exports: &mut Exports<'_>) -> Status {
    let mut status = Status::Fine;
    let mut files = Vec::new();
    let mut statements = Vec::new();
    let report = |outcome: &prove::Outcome| {
        (outcome.status(), published::collect(outcome), report::File::new(outcome))
    };
    each(entries, exports, &report, &mut |(of_file, named, file)| {
        status = status.max(of_file);
        published::join(&mut statements, named);
        files.push(file);
    });
    status.max(output::print_json(&report::Report::new(
        files,
        statements.into_iter().map(Into::into).collect(),
    )))
}

/// Checks files on all cores and hands over what is kept of each, in their order; one by one where something is exported.
fn each<T: Send>(
    entries: Vec<files::Entry>,
    exports: &mut Exports<'_>,
    keep: &(dyn Fn(&prove::Outcome) -> T + Sync),
    done: &mut dyn FnMut(T),
) {
    if exports.certificates.is_none() && exports.coq.is_none() {
        return parallel::each(entries, keep, done);
    }
    for entry in entries {
        let outcome = prove::file(entry, exports.formulas());
        exports.add(&outcome);
        done(keep(&outcome));
    }
}
