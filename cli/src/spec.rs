//! Reads a spec that a command names: a file, standard input, or one of the library.

use basis_kernel::collections::sort::sort;
use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use basis_engine::source::{self, LIBRARY};
use basis_engine::{Diagnostic, Disk, Files, Source};

use crate::name::closest;
use crate::output::error;

/// The end of the name of a spec file.
pub(crate) const EXTENSION: &str = "basis";

/// The name in the library that a path such as `library:quartic` has.
pub(crate) fn in_library(path: &Path) -> Option<&str> {
    path.to_str()?.strip_prefix(LIBRARY)
}

/// The paths of all specs of the library whose names are in the folder `name`; those of the whole library for the empty
/// name.
pub(crate) fn library_folder(name: &str) -> Vec<PathBuf> {
    let folder = name.trim_end_matches('/');
    let names = Disk.library().iter().map(|(known, _)| *known);
    let inside = |known: &&str| {
        folder.is_empty() || known.strip_prefix(folder).is_some_and(|rest| rest.starts_with('/'))
    };
    names.filter(inside).map(|known| PathBuf::from(format!("{LIBRARY}{known}"))).collect()
}

/// The path that stands for standard input.
pub(crate) const STDIN: &str = "-";

/// The spec on standard input; what it uses is looked for in the current folder.
fn read_input() -> Result<Source, Diagnostic> {
    let mut bytes = Vec::new();
    // Of a very long text only as much as is needed to refuse it.
    let read = std::io::stdin().lock().take(2 << 20).read_to_end(&mut bytes);
    read.map_err(|e| error(format!("cannot read standard input: {e}")))?;
    let path = std::env::current_dir().ok().map(|folder| folder.join("<stdin>"));
    source::decode("<stdin>", path, bytes).map_err(|problem| {
        let mut error = error(problem.message);
        error.help = problem.help;
        error
    })
}

/// The spec in a file or in the library, shown in messages by the path as the user wrote it.
///
/// # Errors
/// Why it cannot be read, and which one may be meant.
pub(crate) fn read(path: &Path) -> Result<Source, Diagnostic> {
    let Some(name) = path.to_str() else {
        return Err(error(format!("the path `{}` is not Unicode", path.display())).help("rename the file"));
    };
    if name == STDIN {
        return read_input();
    }
    if let Some(name) = in_library(path) {
        return source::library(&Disk, name).map_err(|problem| {
            let mut error = error(problem.message);
            error.notes = problem.notes;
            error.notes.push(format!(
                "`basis check {LIBRARY}` checks all of them, `basis table {LIBRARY}` lists their families"
            ));
            error.help = problem.help;
            error
        });
    }
    source::read(&Disk, name, &[]).map_err(|problem| {
        let mut error = error(problem.message);
        // The only place that was tried is the one in the message.
        error.notes = problem.notes.into_iter().filter(|note| *note != format!("tried {name}")).collect();
        error.help = problem.help;
        match neighbour(path) {
            Some(near) if !path.exists() => error.help(format!("did you mean `{near}`?")),
            _ => error,
        }
    })
}

/// The spec with the nearest name in the folder of a file that does not exist.
fn neighbour(path: &Path) -> Option<String> {
    let typed = path.file_stem()?.to_str()?;
    let folder = path.parent()?;
    let listed = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let files = fs::read_dir(listed).ok()?.flatten().map(|entry| entry.path());
    let specs = files.filter(|file| file.extension().is_some_and(|e| e == EXTENSION) && file.is_file());
    let mut stems: Vec<String> =
        specs.filter_map(|file| Some(file.file_stem()?.to_str()?.to_string())).collect();
    sort(&mut stems);
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    let near = closest(typed, &stems)?;
    Some(folder.join(format!("{near}.{EXTENSION}")).display().to_string())
}
