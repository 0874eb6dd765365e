//! Syntax errors: a place, what is wrong, what to write instead.

use proc_macro2::Span;

use crate::diagnostic::MAX_ERRORS;

/// Separates the message from the advice inside a [`syn::Error`], which has room for one text only.
const ADVICE: char = '\u{1f}';

/// One mistake in the writing of a spec.
#[derive(Clone, Debug)]
pub struct SyntaxError {
    /// Where.
    pub place: SyntaxPlace,
    /// What is wrong.
    pub message: String,
    /// What to write instead.
    pub help: Option<String>,
}

impl SyntaxError {
    /// Cuts what quotes a very long token.
    fn shorten(&mut self) {
        const LONGEST: usize = 1000;
        for text in [Some(&mut self.message), self.help.as_mut()].into_iter().flatten() {
            if let Some((end, _)) = text.char_indices().nth(LONGEST) {
                text.truncate(end);
                text.push('…');
            }
        }
    }
}

/// The first mistakes of a spec, as many as are ever shown, and the number of the others.
#[derive(Clone, Debug, Default)]
pub struct SyntaxErrors {
    list: Vec<SyntaxError>,
    unread: usize,
}

impl SyntaxErrors {
    /// Adds a mistake.
    pub(super) fn push(&mut self, error: impl Into<SyntaxError>) {
        if self.list.len() < MAX_ERRORS {
            let mut error: SyntaxError = error.into();
            error.shorten();
            self.list.push(error);
        } else {
            self.unread += 1;
        }
    }

    /// Leaves out mistakes that are not worth a message; those that are only counted stay.
    pub(super) fn retain(&mut self, keep: impl FnMut(&SyntaxError) -> bool) {
        self.list.retain(keep);
    }

    /// The mistakes that are shown.
    pub(super) fn shown_mut(&mut self) -> &mut [SyntaxError] {
        &mut self.list
    }

    /// Puts mistakes that were found earlier before these.
    pub(super) fn after(mut self, mut earlier: Vec<SyntaxError>) -> Self {
        earlier.append(&mut self.list);
        self.unread += earlier.len().saturating_sub(MAX_ERRORS);
        earlier.truncate(MAX_ERRORS);
        earlier.iter_mut().for_each(SyntaxError::shorten);
        self.list = earlier;
        self
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The mistakes of which nothing but the number is known.
    pub const fn unread(&self) -> usize {
        self.unread
    }

    /// The mistakes that are shown.
    pub fn into_list(self) -> Vec<SyntaxError> {
        self.list
    }
}

/// Where a syntax error is.
#[derive(Clone, Debug)]
pub enum SyntaxPlace {
    /// Bytes of the text that was read.
    Bytes(core::ops::Range<usize>),
    /// A token.
    Token(Span),
}

/// An error with advice.
///
/// A message with advice of its own, that of another error, loses it.
pub(super) fn error(span: Span, message: impl AsRef<str>, help: impl AsRef<str>) -> syn::Error {
    let message = message.as_ref().split(ADVICE).next().unwrap_or_default();
    syn::Error::new(span, format!("{message}{ADVICE}{}", help.as_ref()))
}

/// What the message about a missing end of a statement begins with.
const NO_SEMICOLON: &str = "`;` is missing after this";

/// The error for a statement without an end; what follows begins the next one.
pub(super) fn missing_semicolon(before: Span) -> syn::Error {
    error(before, NO_SEMICOLON, "a statement ends with `;`")
}

/// Whether the next statement begins where an error was met.
pub(super) fn is_missing_semicolon(error: &syn::Error) -> bool {
    error.to_string().starts_with(NO_SEMICOLON)
}

/// What the message about two factors side by side begins with.
pub(super) const NO_OPERATOR: &str = "an operator is missing before ";

/// Whether an error is about two factors side by side.
pub(super) fn is_missing_operator(error: &syn::Error) -> bool {
    error.to_string().starts_with(NO_OPERATOR)
}

impl From<syn::Error> for SyntaxError {
    fn from(error: syn::Error) -> Self {
        let text = error.to_string();
        let (message, help) = match text.split_once(ADVICE) {
            Some((message, help)) => (message.to_string(), Some(help.to_string())),
            None => (text, None),
        };
        Self { place: SyntaxPlace::Token(error.span()), message, help }
    }
}
