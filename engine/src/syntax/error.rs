//! Syntax errors: a place, what is wrong, what to write instead.

use proc_macro2::Span;

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

/// Where a syntax error is.
#[derive(Clone, Debug)]
pub enum SyntaxPlace {
    /// Bytes of the text that was read.
    Bytes(core::ops::Range<usize>),
    /// A token.
    Token(Span),
}

/// An error with advice.
pub(super) fn error(span: Span, message: impl AsRef<str>, help: impl AsRef<str>) -> syn::Error {
    syn::Error::new(span, format!("{}{ADVICE}{}", message.as_ref(), help.as_ref()))
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
