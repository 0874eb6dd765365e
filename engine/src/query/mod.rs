//! What an editor, a page or a formatter asks about a spec: names with their places, what stands under a position, the
//! claims that hold of a family, formulas in LaTeX, the text in its standard layout.
//!
//! Names, words and layout are read from the text alone, so that there are answers while a spec is being typed and
//! cannot be read as a whole. Facts about families come from the same functions that `basis explain` prints, and a
//! claim is called true when the kernel has accepted a proof of it.

mod analysis;
mod complete;
mod document;
mod facts;
mod format;
pub mod latex;
mod lex;
mod prose;
mod reader;
mod vocabulary;

pub use crate::syntax::GREEK;
pub use analysis::{Analysed, Analysis, Statement};
pub use complete::{Around, Suggestion, SuggestionKind, suggestions};
pub use document::{Document, Entry, Import, Occurrence, Role, Symbol, SymbolKind};
pub use facts::{FunctionFacts, Holds, claims_that_hold, function_facts, function_of, independent_claim};
pub use format::{FormatError, format};
pub use lex::{Token, TokenKind, tokens};
pub use vocabulary::{WORDS, Word, WordKind, is_name, word};

/// Forgets the tokens of all texts that this thread has read. A program that reads for hours, as a language server does, would
/// otherwise keep every version of a text.
///
/// What an [`Analysis`] or a [`Document`] holds stays valid. A [`Library`](crate::Library) that was made on this thread before must
/// not be asked any more: where it looks for the place of a mistake it panics, or names one in another text. Not for macros.
pub fn forget_tokens() {
    proc_macro2::extra::invalidate_current_thread_spans();
}

/// The spec whose families every spec can name: `Bernstein(n)` and `TriangularBernstein(n)`.
pub const PRELUDE: &str = include_str!("../prelude.basis");
