//! What is open in the editor, and the specs around it.

use basis_kernel::collections::sort::sort_unique;
use std::path::PathBuf;
use std::time::Instant;

use basis_engine::query::Document;
use basis_engine::{Files, Source};
use core::ops::Range;
use lsp_types::{Position, Uri};

use super::files::{self, Other, Overlay};
use super::position::Lines;
use basis_engine::query::Analysis;

/// A text that is open in the editor.
pub(super) struct Text {
    pub(super) uri: Uri,
    /// Its file; nothing for a text that has none yet.
    pub(super) path: Option<PathBuf>,
    pub(super) document: Document,
    pub(super) version: Option<i32>,
    lines: Lines,
    /// The verdicts, perhaps not all; nothing before they are asked for.
    pub(super) analysis: Option<Analysis>,
    /// Since when this version is there.
    pub(super) since: Instant,
    /// Whether its errors are with the editor: none, those so far, or all.
    pub(super) shown: Shown,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Shown {
    No,
    Interim,
    All,
}

impl Text {
    pub(super) fn new(uri: Uri, text: &str, version: Option<i32>) -> Self {
        // As the engine reads it: lines end with `\n`.
        let text = Source::text("", text).text.unwrap_or_default();
        let lines = Lines::new(&text);
        let (path, document) = (files::path(&uri), Document::new(text));
        Self { uri, path, document, version, lines, analysis: None, since: Instant::now(), shown: Shown::No }
    }

    pub(super) fn position(&self, offset: usize) -> Position {
        self.lines.position(&self.document.text, offset)
    }

    pub(super) fn span(&self, range: &Range<usize>) -> lsp_types::Range {
        self.lines.span(&self.document.text, range)
    }

    pub(super) fn offset(&self, position: Position) -> usize {
        self.lines.offset(&self.document.text, position)
    }

    pub(super) fn bytes(&self, range: lsp_types::Range) -> Range<usize> {
        self.lines.bytes(&self.document.text, range)
    }

    /// The text for the engine.
    pub(super) fn source(&self) -> Source {
        let name = self.path.as_ref().and_then(|p| p.file_name()).map(|n| n.to_string_lossy().into_owned());
        let source = Source::text(name.unwrap_or_else(|| String::from("spec.basis")), &self.document.text);
        match &self.path {
            Some(path) => source.at(path.clone()),
            None => source,
        }
    }

    pub(super) fn is_done(&self) -> bool {
        self.analysis.as_ref().is_some_and(Analysis::is_done)
    }
}

/// The open texts and the folders of the editor.
pub(super) struct Workspace {
    /// The open texts, the one that was edited last at the end.
    pub(super) texts: Vec<Text>,
    pub(super) files: Overlay,
    pub(super) roots: Vec<PathBuf>,
    /// Whether the editor asks for the edit of an action that is chosen.
    pub(super) resolves: bool,
}

impl Workspace {
    /// The text at an address.
    pub(super) fn text(&self, uri: &str) -> Option<&Text> {
        self.texts.iter().find(|t| t.uri.as_str() == uri)
    }

    /// The specs whose families a text can name.
    pub(super) fn others(&self, text: &Text) -> Vec<Other> {
        files::visible(&self.files, text.path.as_deref(), &text.document.imports)
    }

    /// The specs of the workspace, and those that are open.
    pub(super) fn specs(&self) -> Vec<PathBuf> {
        let mut all = files::specs(&self.roots);
        all.extend(self.texts.iter().filter_map(|t| t.path.clone()));
        sort_unique(&mut all);
        all
    }

    /// The names of a spec of the workspace.
    pub(super) fn document(&self, path: &std::path::Path) -> Option<Document> {
        if let Some(text) = self.texts.iter().find(|t| t.path.as_deref() == Some(path)) {
            return Some(text.document.clone());
        }
        let text = String::from_utf8(self.files.read(path).ok()?).ok()?;
        Some(Document::new(Source::text("", &text).text.unwrap_or_default()))
    }
}
