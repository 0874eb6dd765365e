//! Errors and warnings about a spec: where, what is wrong, what to write instead.

use core::ops::Range;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use proc_macro2::Span;

use crate::source::{SourceId, Sources};

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The spec cannot be used.
    Error,
    /// The spec can be used, but probably says something else than meant.
    Warning,
}

/// A place in a spec.
#[derive(Clone, Debug)]
pub enum Place {
    /// Bytes of a text.
    Text(SourceId, Range<usize>),
    /// A token of a macro call.
    Token(Span),
}

/// One message about a spec.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong, in one line.
    pub message: String,
    /// Where, the main place first, each with a word about it; empty when there is no place to show.
    pub labels: Vec<(Place, String)>,
    /// Facts that explain the message, such as a difference or a counterexample.
    pub notes: Vec<String>,
    /// What to write instead.
    pub help: Option<String>,
}

impl Diagnostic {
    /// An error at a place.
    pub fn error(place: Place, message: impl Into<String>) -> Self {
        Self {
            severity: Severity::Error,
            message: message.into(),
            labels: vec![(place, String::new())],
            notes: Vec::new(),
            help: None,
        }
    }

    /// Makes it a warning.
    pub fn warning(mut self) -> Self {
        self.severity = Severity::Warning;
        self
    }

    /// Says something about the main place.
    pub fn label(mut self, text: impl Into<String>) -> Self {
        if let Some(first) = self.labels.first_mut() {
            first.1 = text.into();
        }
        self
    }

    /// Shows another place.
    pub fn also(mut self, place: Place, text: impl Into<String>) -> Self {
        self.labels.push((place, text.into()));
        self
    }

    /// Adds a fact.
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(text.into());
        self
    }

    /// Says what to write instead.
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }

    /// Line and column of the main place, counted from one; `None` for tokens of a macro call.
    pub fn line_column(&self, sources: &Sources) -> Option<(usize, usize)> {
        match self.labels.first()? {
            (Place::Text(id, range), _) => Some(sources.get(*id).line_column(range.start)),
            (Place::Token(_), _) => None,
        }
    }

    /// The message with notes and help but without the place: what a compiler shows at the place itself.
    pub fn text(&self) -> String {
        let mut text = self.message.clone();
        if let Some((_, label)) = self.labels.first().filter(|(_, label)| !label.is_empty()) {
            text.push_str(": ");
            text.push_str(label);
        }
        for note in &self.notes {
            text.push_str("\n  = note: ");
            text.push_str(note);
        }
        if let Some(help) = &self.help {
            text.push_str("\n  = help: ");
            text.push_str(help);
        }
        text
    }

    /// The message as rustc would print it, with the lines concerned; `styled` adds colours.
    pub fn render(&self, sources: &Sources, styled: bool) -> String {
        let level = match self.severity {
            Severity::Error => Level::ERROR,
            Severity::Warning => Level::WARNING,
        };
        let mut group = Group::with_title(level.primary_title(self.message.as_str()));
        let mut seen: Vec<SourceId> = Vec::new();
        for (place, _) in &self.labels {
            let Place::Text(id, _) = place else { continue };
            let source = sources.get(*id);
            let (false, Some(text)) = (seen.contains(id), source.text.as_deref()) else { continue };
            seen.push(*id);
            let annotations = self.labels.iter().enumerate().filter_map(|(k, (place, label))| {
                let Place::Text(other, range) = place else { return None };
                let kind = if k == 0 { AnnotationKind::Primary } else { AnnotationKind::Context };
                (other == id).then(|| kind.span(visible(text, range)).label(label.as_str()))
            });
            group = group.element(Snippet::source(text).path(source.name.as_str()).annotations(annotations));
        }
        for note in &self.notes {
            group = group.element(Level::NOTE.message(note.as_str()));
        }
        if let Some(help) = &self.help {
            group = group.element(Level::HELP.message(help.as_str()));
        }
        let renderer = if styled { Renderer::styled() } else { Renderer::plain() };
        renderer.render(&[group])
    }
}

/// The range cut to the text and widened to whole characters; at the end of the text at least an empty range on its
/// last line.
///
/// A token that stands in for a character of several bytes ends inside of it.
fn visible(text: &str, range: &Range<usize>) -> Range<usize> {
    let end = text.trim_end().len();
    let (mut start, mut stop) = (range.start.min(end), range.end.min(text.len()));
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    while !text.is_char_boundary(stop) {
        stop += 1;
    }
    start..stop.max(start)
}
