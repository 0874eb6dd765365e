//! Errors and warnings about a spec: where, what is wrong, what to write instead.

mod render;

use core::ops::{Deref, DerefMut, Range};

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
    /// Tokens of a macro call, from the first to the last; of the compiler's own tokens stable Rust cannot join the
    /// spans.
    Token(Span, Span),
}

/// One message about a spec: its [`Message`] in one word, because nearly every function of the engine may return it,
/// and what moves it up is most of what such a function costs to compile.
#[derive(Clone, Debug)]
pub struct Diagnostic(Box<Message>);

impl Deref for Diagnostic {
    type Target = Message;

    fn deref(&self) -> &Message {
        &self.0
    }
}

impl DerefMut for Diagnostic {
    fn deref_mut(&mut self) -> &mut Message {
        &mut self.0
    }
}

/// What a [`Diagnostic`] says.
#[derive(Clone, Debug)]
pub struct Message {
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
    /// The number of errors that this message stands for and that are not shown; 0 for a message about one mistake.
    pub unshown: usize,
}

/// The most errors of a run that are shown.
pub const MAX_ERRORS: usize = 100;

/// The messages of a run: warnings, the first errors, and how many errors there are beyond those.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    all: Vec<Diagnostic>,
    errors: usize,
    unshown: usize,
}

impl Diagnostics {
    /// Adds a message; of an error beyond [`MAX_ERRORS`] only the number is kept.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        if diagnostic.unshown > 0 {
            self.unshown += diagnostic.unshown;
        } else if self.errors >= MAX_ERRORS {
            // Warnings are few, but there is no reason to keep more of them.
            self.unshown += usize::from(diagnostic.severity == Severity::Error);
        } else {
            self.errors += usize::from(diagnostic.severity == Severity::Error);
            self.all.push(diagnostic);
        }
    }

    /// Adds messages.
    pub fn extend(&mut self, diagnostics: impl IntoIterator<Item = Diagnostic>) {
        diagnostics.into_iter().for_each(|diagnostic| self.push(diagnostic));
    }

    /// Whether nothing was added.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty() && self.unshown == 0
    }

    /// How many errors were added.
    pub const fn errors(&self) -> usize {
        self.errors + self.unshown
    }

    /// Whether a further error is only counted: the words about it need not be found.
    pub const fn is_full(&self) -> bool {
        self.errors >= MAX_ERRORS
    }

    /// Counts errors of which nothing else is known.
    pub(crate) const fn leave_out(&mut self, errors: usize) {
        self.unshown += errors;
    }

    /// The messages that are kept.
    pub fn shown(&self) -> &[Diagnostic] {
        &self.all
    }

    /// The messages that are kept, to add to them.
    pub(crate) fn shown_mut(&mut self) -> &mut [Diagnostic] {
        &mut self.all
    }

    /// The messages, the last one being about the errors that are not shown.
    pub fn into_list(self) -> Vec<Diagnostic> {
        let Self { mut all, unshown, .. } = self;
        if unshown > 0 {
            let (errors, verb) = if unshown == 1 { ("error", "is") } else { ("errors", "are") };
            let error = Diagnostic::unplaced(format!("{} more {errors} {verb} not shown", grouped(unshown)));
            let mut error = error.help("correct the first ones; others may follow from them");
            error.unshown = unshown;
            all.push(error);
        }
        all
    }
}

impl FromIterator<Diagnostic> for Diagnostics {
    fn from_iter<I: IntoIterator<Item = Diagnostic>>(diagnostics: I) -> Self {
        let mut all = Self::default();
        all.extend(diagnostics);
        all
    }
}

/// A number with its thousands apart, `31 900`.
pub(crate) fn grouped(n: usize) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) && digits.len() > 4 {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

impl Diagnostic {
    /// An error at a place.
    pub fn error(place: Place, message: impl Into<String>) -> Self {
        let mut error = Self::unplaced(message);
        error.labels.push((place, String::new()));
        error
    }

    /// An error that is not about a place in a spec.
    pub fn unplaced(message: impl Into<String>) -> Self {
        Self(Box::new(Message {
            severity: Severity::Error,
            message: message.into(),
            labels: Vec::new(),
            notes: Vec::new(),
            help: None,
            unshown: 0,
        }))
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

    /// The error for what a feature of the runtime is needed for that is off: `theorems and joins need`, `joins`.
    #[cfg(not(all(feature = "angles", feature = "joins", feature = "rounding")))]
    pub(crate) fn needs_feature(place: Place, what: &str, feature: &str) -> Self {
        let error =
            Self::error(place, format!("{what} the feature `{feature}` of basis-runtime, which is off"));
        error.help(format!(
            "switch it on in `Cargo.toml`: `basis-runtime = {{ …, features = [\"{feature}\"] }}`"
        ))
    }

    /// Line and column of the main place, counted from one; `None` for tokens of a macro call.
    pub fn line_column(&self, sources: &Sources) -> Option<(usize, usize)> {
        match self.labels.first()? {
            (Place::Text(id, range), _) => Some(sources.get(*id).line_column(range.start)),
            (Place::Token(..), _) => None,
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
        render::render(self, sources, styled)
    }
}
