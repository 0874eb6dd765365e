//! The specs that certificates are about, read without any search: what has to hold is checked by the certificates.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use basis_engine::diagnostic::Place;
use basis_engine::model::obligation::Later;
use basis_engine::theorem::theorems;
use basis_engine::{Diagnostic, Disk, Item, Library, Selected, Severity};

use crate::check::files;
use crate::spec;

/// The specs that certificates are about, each read once.
pub(super) struct Specs {
    pub(super) folder: PathBuf,
    pub(super) known: BTreeMap<String, Result<Vec<Stated>, String>>,
}

/// A family of one order, a theorem or a join, with what the spec says of it.
#[derive(Debug)]
pub(super) struct Stated {
    pub(super) item: Item,
    /// The lines of the claims.
    pub(super) lines: Vec<Option<usize>>,
    /// Whether a certificate was found.
    pub(super) found: bool,
}

impl Specs {
    /// The folders in which the paths of specs may begin: where `check` was run, or around the certificates.
    fn bases(folder: &Path) -> Vec<PathBuf> {
        let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_path_buf());
        std::iter::once(PathBuf::new()).chain(folder.ancestors().map(Path::to_path_buf)).collect()
    }

    /// What a spec says.
    pub(super) fn items(&mut self, path: &str) -> Result<&mut Vec<Stated>, String> {
        let folder = &self.folder;
        let items = self.known.entry(path.to_string()).or_insert_with(|| {
            if spec::in_library(Path::new(path)).is_some() {
                return items(Path::new(path));
            }
            let places = Self::bases(folder).into_iter().map(|base| base.join(path));
            let place = places.into_iter().find(|p| p.is_file());
            let place = place.ok_or(format!("there is no spec `{path}` here or around the certificates"))?;
            items(&place)
        });
        items.as_mut().map_err(|e| e.clone())
    }

    /// The specs that a path of the command line stands for, as `check` names them.
    pub(super) fn under(&self, path: &Path) -> Vec<String> {
        if spec::in_library(path).is_some() {
            let entries = files::find(&[path.to_path_buf()]);
            return entries.iter().map(|entry| entry.path.display().to_string()).collect();
        }
        for base in Self::bases(&self.folder) {
            let place = base.join(path);
            if !place.exists() {
                continue;
            }
            let named = |file: &Path| match file.strip_prefix(&place) {
                Ok(rest) if !rest.as_os_str().is_empty() => path.join(rest),
                _ => path.to_path_buf(),
            };
            let found =
                files::find(std::slice::from_ref(&place)).into_iter().filter(|entry| entry.problem.is_none());
            let found: Vec<String> = found.map(|entry| named(&entry.path).display().to_string()).collect();
            // A folder of certificates can have the same name.
            if !found.is_empty() {
                return found;
            }
        }
        vec![path.display().to_string()]
    }

    /// The items without a certificate.
    pub(super) fn missing(&self) -> Vec<String> {
        let items = self.known.iter().filter_map(|(path, items)| Some((path, items.as_ref().ok()?)));
        let lost = items.flat_map(|(path, items)| items.iter().filter(|i| !i.found).map(move |i| (path, i)));
        lost.map(|(path, item)| format!("{path}: {}", item.item.subject.title())).collect()
    }
}

/// Everything that a spec says.
pub(super) fn items(path: &Path) -> Result<Vec<Stated>, String> {
    let source = spec::read(path).map_err(|e| e.text())?;
    let library = Library::from_source(&Disk, &Later, source);
    let line = |place: &Place| match place {
        Place::Text(id, range) => Some(library.sources().get(*id).line_column(range.start).0),
        Place::Token(..) => None,
    };
    let families = library.items(Selected::EveryOrder).into_iter();
    let all = families.chain(theorems(&library)).map(|item| {
        let lines = item.claims.iter().map(|claim| line(&claim.place)).collect();
        Stated { item, lines, found: false }
    });
    let all = all.collect();
    // Errors in claims are known once the claims are read.
    let diagnostics = library.diagnostics();
    if let Some(error) = diagnostics.iter().find(|d| d.severity == Severity::Error) {
        let line = error.line_column(library.sources());
        let line = line.map_or_else(String::new, |(line, _)| format!("line {line}: "));
        let text = Diagnostic::text(error);
        let message = text.lines().next().unwrap_or_default();
        return Err(format!("the spec `{}` has errors: {line}{message}", path.display()));
    }
    Ok(all)
}
