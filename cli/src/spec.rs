//! Reads a spec file that a command names.

use std::fs;
use std::path::Path;

use basis_engine::{Diagnostic, Disk, Source, source};

use crate::name::closest;
use crate::output::error;

/// The end of the name of a spec file.
pub(crate) const EXTENSION: &str = "basis";

/// The spec in a file, shown in messages by the path as the user wrote it.
///
/// # Errors
/// Why the file cannot be read, and which file may be meant.
pub(crate) fn read(path: &Path) -> Result<Source, Diagnostic> {
    let Some(name) = path.to_str() else {
        return Err(error(format!("the path `{}` is not Unicode", path.display())).help("rename the file"));
    };
    source::read(&Disk, name, &[]).map_err(|problem| {
        let mut error = error(problem.message);
        // The only place that was tried is the one in the message.
        error.notes = problem.notes.into_iter().filter(|note| *note != format!("tried {name}")).collect();
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
    stems.sort();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    let near = closest(typed, &stems)?;
    Some(folder.join(format!("{near}.{EXTENSION}")).display().to_string())
}
