//! Reads the spec that was asked for, those that it uses, and the prelude.

use core::cell::RefCell;
use std::path::{Path, PathBuf};
use std::rc::Rc;

use proc_macro2::{Span, TokenStream};

use super::{Library, Unit};
use crate::diagnostic::{Diagnostic, Place};
use crate::model::budget::Run;
use crate::model::obligation::Judge;
use crate::model::words::BUILTINS;
use crate::source::{self, Files, ReadError, Source, SourceId, Sources};
use crate::syntax::{self, Home, Name, Spec, SyntaxErrors};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::sort::sort_by;

/// The most bytes of all specs of a run.
const MAX_TOTAL_BYTES: usize = 4 << 20;

impl<'f> Library<'f> {
    /// Reads a spec from a text, with everything that it uses.
    pub fn from_source(files: &'f dyn Files, judge: &'f dyn Judge, source: Source) -> Self {
        let mut library = Self::empty(files, judge);
        library.add_text(source, &mut Vec::new());
        library.finish()
    }

    /// Reads a spec from the tokens of a macro call in the file `path`, with everything that it uses.
    pub fn from_tokens(
        files: &'f dyn Files,
        judge: &'f dyn Judge,
        tokens: TokenStream,
        path: Option<PathBuf>,
    ) -> Self {
        let mut library = Self::empty(files, judge);
        let id = library.sources.add(Source::tokens(path));
        let (spec, errors) = syntax::parse_tokens(tokens);
        library.add_unit(id, spec, errors, &mut Vec::new());
        library.finish()
    }

    fn empty(files: &'f dyn Files, judge: &'f dyn Judge) -> Self {
        Self {
            files,
            judge,
            sources: Sources::default(),
            units: Vec::new(),
            expanded: RefCell::default(),
            active: RefCell::default(),
            diagnostics: RefCell::default(),
            run: Rc::new(Run::new()),
            calls: core::cell::Cell::new(0),
            is_too_long: false,
        }
    }

    /// The prelude is the last unit.
    fn finish(mut self) -> Self {
        let prelude = Source::text("prelude.basis", include_str!("../../prelude.basis"));
        self.add_text(prelude, &mut Vec::new());
        self
    }

    fn add_text(&mut self, source: Source, stack: &mut Vec<SourceId>) -> usize {
        let id = self.sources.add(source);
        let text = self.sources.get(id).text.clone().unwrap_or_default();
        let (spec, errors) = syntax::parse_text(&text);
        self.add_unit(id, spec, errors, stack)
    }

    fn add_unit(
        &mut self,
        source: SourceId,
        spec: Spec,
        errors: SyntaxErrors,
        stack: &mut Vec<SourceId>,
    ) -> usize {
        self.diagnostics.borrow_mut().leave_out(errors.unread());
        for error in errors.into_list() {
            let place = match error.place {
                syntax::SyntaxPlace::Bytes(range) => Place::Text(source, range),
                syntax::SyntaxPlace::Token(span) => self.place(source, span),
            };
            let mut diagnostic = Diagnostic::error(place, error.message);
            diagnostic.help = error.help;
            self.report(diagnostic);
        }
        let index = self.units.len();
        let requests: Vec<(Home, String, Span)> = spec
            .items
            .iter()
            .filter_map(|item| match item {
                syntax::Item::Use(u) => Some((u.home, u.path.clone(), u.span)),
                syntax::Item::Family(_) | syntax::Item::Theorem(_) => None,
            })
            .listed();
        let mut families: Vec<(String, usize)> = Vec::new();
        for (position, item) in spec.items.iter().enumerate() {
            if let syntax::Item::Family(family) = item {
                families.push((family.name.text.clone(), position));
            }
        }
        // Stable: of families of one name, which is an error, the first one stays.
        sort_by(&mut families, |a, b| a.0.cmp(&b.0));
        families.dedup_by(|later, first| later.0 == first.0);
        self.units.push(Unit { source, spec, families, uses: Vec::new(), lacks_a_use: false });
        self.check_doubled(index);
        stack.push(source);
        for (home, path, span) in requests {
            match self.load(source, home, &path, span, stack) {
                Some(unit) if self.units[index].uses.contains(&unit) => {}
                Some(unit) => self.units[index].uses.push(unit),
                None => self.units[index].lacks_a_use = true,
            }
        }
        stack.pop();
        index
    }

    /// Reads a spec that another one uses, unless it is read already.
    fn load(
        &mut self,
        from: SourceId,
        home: Home,
        path: &str,
        span: Span,
        stack: &mut Vec<SourceId>,
    ) -> Option<usize> {
        let mut source = None;
        let mut known = self.known(from, home, path);
        if known.is_none() {
            match self.read(from, home, path) {
                Ok(read) => {
                    known = self.sources.find(&read);
                    source = Some(read);
                }
                Err(e) => {
                    let mut diagnostic = Diagnostic::error(self.place(from, span), e.message);
                    diagnostic.notes = e.notes;
                    diagnostic.help = e.help;
                    self.report(diagnostic);
                    return None;
                }
            }
        }
        if let Some(id) = known {
            if let Some(start) = stack.iter().position(|s| *s == id) {
                let mut names: Vec<&str> = stack[start..].mapped(|s| self.sources.get(*s).name.as_str());
                names.push(self.sources.get(id).name.as_str());
                let message = format!("cyclic `use`: {}", names.join(" uses "));
                let place = self.place(from, span);
                self.report(
                    Diagnostic::error(place, message)
                        .help("move the families that both need into a third file"),
                );
                return None;
            }
            return self.units.iter().position(|u| u.source == id);
        }
        let mut source = source?;
        let read: usize = self.sources.iter().map(|(_, s)| s.text.as_deref().map_or(0, str::len)).sum();
        if read + source.text.as_deref().map_or(0, str::len) > MAX_TOTAL_BYTES {
            // The same is true of all that follow.
            if !core::mem::replace(&mut self.is_too_long, true) {
                let limit = MAX_TOTAL_BYTES >> 20;
                let message = format!("the spec and those that it uses are longer than {limit} MiB");
                let error = Diagnostic::error(self.place(from, span), message);
                self.report(error.help("use fewer files"));
            }
            return None;
        }
        // A file is shown relative to the file that uses it, as a reader would look for it.
        if source.library.is_none()
            && let Some(parent) =
                Path::new(&self.sources.get(from).name).parent().filter(|p| !p.as_os_str().is_empty())
        {
            source.name = parent.join(path).to_string_lossy().into_owned();
        }
        Some(self.add_text(source, stack))
    }

    /// The file that another one uses, if it is read already.
    fn known(&self, from: SourceId, home: Home, path: &str) -> Option<SourceId> {
        let from = self.sources.get(from);
        if home == Home::Library || from.library.is_some() {
            return None;
        }
        let folder = from.path.as_deref().and_then(Path::parent).map(Path::to_path_buf);
        let mut file = Source::default();
        file.path = Some(self.files.canonical(&folder.unwrap_or_default().join(path)));
        self.sources.find(&file)
    }

    /// A spec that another one uses; in a spec of the library a path stays in the library.
    fn read(&self, from: SourceId, home: Home, path: &str) -> Result<Source, ReadError> {
        let from = self.sources.get(from);
        match (home, &from.library) {
            (Home::Library, _) => source::library(self.files, path),
            (Home::Folder, Some(name)) => source::library(self.files, &source::beside(name, path)?),
            (Home::Folder, None) => {
                let folder = from.path.as_deref().and_then(Path::parent).map(Path::to_path_buf);
                let folders: Vec<PathBuf> = folder.into_iter().listed();
                source::read(self.files, path, &folders).map_err(|e| self.perhaps_of_library(e, path))
            }
        }
    }

    /// What to write for a path that may mean a spec of the library, or lacks the end of its name.
    fn perhaps_of_library(&self, problem: ReadError, path: &str) -> ReadError {
        let name = path.strip_suffix(".basis").unwrap_or(path);
        let help = if self.files.library().iter().any(|(known, _)| *known == name) {
            Some(format!("write `use library \"{name}\";` for the spec of the library"))
        } else if name == path {
            Some(format!("the names of spec files end with `.basis`: `use \"{path}.basis\";`"))
        } else {
            None
        };
        ReadError { help: problem.help.or(help), ..problem }
    }

    fn check_doubled(&self, unit: usize) {
        let source = self.units[unit].source;
        for (again, first) in repeated_names(self.theorems_of(unit).map(|t| &t.name)) {
            let message = format!("`{}` is stated twice", again.text);
            self.report(
                Diagnostic::error(self.place(source, again.span), message)
                    .label("stated again here")
                    .also(self.place(source, first.span), "first stated here"),
            );
        }
        for family in self.families_of(unit) {
            if BUILTINS.contains(&family.name.text.as_str()) {
                let place = self.place(source, family.name.span);
                let message = format!("`{}` is a function of the language", family.name.text);
                self.report(Diagnostic::error(place, message).help("choose another name for the family"));
            }
        }
        for (again, first) in repeated_names(self.families_of(unit).map(|f| &f.name)) {
            let message = format!("the family `{}` is defined twice", again.text);
            self.report(
                Diagnostic::error(self.place(source, again.span), message)
                    .label("defined again here")
                    .also(self.place(source, first.span), "first defined here"),
            );
        }
    }
}

/// The names that stand a second time in a list, each with the first one, in the order of the list.
fn repeated_names<'n>(names: impl Iterator<Item = &'n Name>) -> Vec<(&'n Name, &'n Name)> {
    let mut sorted: Vec<(usize, &Name)> = names.enumerate().listed();
    sort_by(&mut sorted, |a, b| a.1.text.cmp(&b.1.text));
    let mut repeated = Vec::new();
    let mut first = 0;
    for k in 0..sorted.len() {
        if sorted[k].1.text == sorted[first].1.text {
            if k > first {
                repeated.push((sorted[k].0, sorted[k].1, sorted[first].1));
            }
        } else {
            first = k;
        }
    }
    sort_by(&mut repeated, |a, b| a.0.cmp(&b.0));
    repeated.into_iter().map(|(_, again, first)| (again, first)).listed()
}
