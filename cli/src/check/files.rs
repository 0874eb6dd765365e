//! Which spec files the paths of a command stand for.

use basis_kernel::collections::sort::{sort, sort_by};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use basis_engine::Diagnostic;

use crate::output::error;
use crate::spec::{self, EXTENSION};

/// A file to check, or what stands in the way.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    /// The path, beginning as the user wrote it.
    pub(crate) path: PathBuf,
    /// Why there is nothing to check.
    pub(crate) problem: Option<Problem>,
}

/// Why there is nothing to check.
#[derive(Clone, Debug)]
pub(crate) struct Problem {
    message: String,
    help: Option<String>,
}

impl From<Problem> for Diagnostic {
    fn from(problem: Problem) -> Self {
        let mut error = error(problem.message);
        error.help = problem.help;
        error
    }
}

/// The files in the order of the paths; those in a folder sorted by path, each once.
pub(crate) fn find(paths: &[PathBuf]) -> Vec<Entry> {
    let mut all: Vec<Entry> = Vec::new();
    for path in paths {
        let entries = match spec::in_library(path) {
            Some(name) => shelf(path, name),
            None if path.is_dir() => folder(path),
            None => vec![Entry { path: path.clone(), problem: None }],
        };
        for entry in entries {
            if all.iter().all(|other| other.path != entry.path) {
                all.push(entry);
            }
        }
    }
    all
}

/// One spec of the library, or all in one of its folders.
fn shelf(path: &Path, name: &str) -> Vec<Entry> {
    let mut paths = spec::library_folder(name);
    if paths.is_empty() {
        paths.push(path.to_path_buf());
    }
    paths.into_iter().map(|path| Entry { path, problem: None }).collect()
}

/// All spec files in a folder and the folders in it.
fn folder(root: &Path) -> Vec<Entry> {
    let mut found = Vec::new();
    let mut seen = BTreeSet::new();
    // Folders reached by a symbolic link come last, so that a file shows under its own path, and each folder is
    // read once, so that links that form a loop come to an end.
    let mut linked = vec![root.to_path_buf()];
    while !linked.is_empty() {
        sort(&mut linked);
        let mut next = Vec::new();
        for link in linked {
            walk(&link, &mut seen, &mut found, &mut next);
        }
        linked = next;
    }
    if found.is_empty() {
        let problem = Problem {
            message: format!("there is no spec in the folder `{}`", root.display()),
            help: Some(format!("the name of a spec file ends with `.{EXTENSION}`")),
        };
        found.push(Entry { path: root.to_path_buf(), problem: Some(problem) });
    }
    sort_by(&mut found, |a, b| a.path.cmp(&b.path));
    found
}

fn walk(folder: &Path, seen: &mut BTreeSet<PathBuf>, found: &mut Vec<Entry>, linked: &mut Vec<PathBuf>) {
    let fail = |e: std::io::Error| {
        let message = format!("cannot read the folder `{}`: {e}", folder.display());
        let problem = Problem { message, help: None };
        Entry { path: folder.to_path_buf(), problem: Some(problem) }
    };
    match folder.canonicalize().map(|real| seen.insert(real)) {
        Ok(true) => {}
        Ok(false) => return,
        Err(e) => return found.push(fail(e)),
    }
    let entries = match fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>) {
        Ok(entries) => entries,
        Err(e) => return found.push(fail(e)),
    };
    for entry in entries {
        let path = entry.path();
        let is_link = entry.file_type().is_ok_and(|t| t.is_symlink());
        if !path.is_dir() {
            if path.extension().is_some_and(|e| e == EXTENSION) {
                found.push(Entry { path, problem: None });
            }
        } else if is_link {
            linked.push(path);
        } else {
            walk(&path, seen, found, linked);
        }
    }
}
