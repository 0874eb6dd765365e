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
