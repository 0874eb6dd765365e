//! `basis fmt`: the standard layout of spec files.

use std::fs;
use std::path::Path;

use basis_engine::diagnostic::Place;
use basis_engine::{Diagnostic, Source, Sources, query};

use crate::args::FmtArguments;
use crate::check::files;
use crate::output::{self, Status};
use crate::spec::{self, STDIN};

/// Formats everything that the arguments name, or says what is not formatted.
pub(crate) fn run(arguments: &FmtArguments) -> Status {
    let mut status = Status::Fine;
    for entry in files::find(&arguments.paths) {
        let done = match entry.problem {
            Some(problem) => Err(Diagnostic::from(problem).render(&Sources::default(), true)),
            None => file(&entry.path, arguments.check),
        };
        status = status.max(done.unwrap_or_else(|message| {
            output::complain(&(message + "\n\n"));
            Status::Unusable
        }));
    }
    status
}

/// Formats one file; the message when that fails.
fn file(path: &Path, check: bool) -> Result<Status, String> {
    let plain = |error: Diagnostic| error.render(&Sources::default(), true);
    if spec::in_library(path).is_some() {
        let error =
            output::error(format!("`{}` comes with the toolchain and is not changed", path.display()));
        return Err(plain(error.help("name a file, or a folder with files")));
    }
    let source = spec::read(path).map_err(plain)?;
    let text = source.text.clone().unwrap_or_default();
    let new = query::format(&text).map_err(|e| no_partner(source, e.offset))?;
    if path == Path::new(STDIN) && !check {
        return Ok(output::print(&new));
    }
    // What is read has other line ends than the file may have.
    let is_same =
        || new == text && (path == Path::new(STDIN) || fs::read(path).is_ok_and(|b| b == new.as_bytes()));
    if is_same() {
        return Ok(Status::Fine);
    }
    if check {
        return Ok(output::print(&format!("{}\n", path.display())).max(Status::Wrong));
    }
    let fail = |e| plain(output::error(format!("cannot write `{}`: {e}", path.display())));
    fs::write(path, new).map_err(fail)?;
    Ok(Status::Fine)
}

/// The error for a bracket without a partner.
fn no_partner(source: Source, offset: usize) -> String {
    let mut sources = Sources::default();
    let bracket =
        source.text.as_ref().and_then(|text| text.get(offset..=offset)).unwrap_or_default().to_string();
    let id = sources.add(source);
    let closes = matches!(bracket.as_str(), ")" | "]" | "}");
    let missing = if closes { "opened" } else { "closed" };
    let message = format!("`{bracket}` is not {missing}, so the spec has no layout");
    let error = Diagnostic::error(Place::Text(id, offset..offset + 1), message).label("it has no partner");
    error.help("write the other bracket; the file is as it was").render(&sources, true)
}
