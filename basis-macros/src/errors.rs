//! Messages of the engine as errors of the compiler.

use basis_engine::diagnostic::Place;
use basis_engine::{Diagnostic, Severity, Sources};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// One `compile_error!` for each error: on the token itself in a spec in place; for a file on the path in the
/// macro call, with the lines of the file in the text.
pub(crate) fn compile_errors(diagnostics: &[Diagnostic], sources: &Sources, file: Span) -> TokenStream {
    diagnostics
        .iter()
        .filter(|d| d.severity == Severity::Error)
        .map(|d| match d.labels.first() {
            Some((Place::Token(first, last), _)) => between(*first, *last, d.text()),
            _ => syn::Error::new(file, in_file(d, sources)),
        })
        .map(syn::Error::into_compile_error)
        .collect()
}

/// An error on everything from one token to another: on stable Rust the tokens of `compile_error!` can do that,
/// joined spans cannot.
fn between(first: Span, last: Span, message: String) -> syn::Error {
    let [first, last] = [first, last].map(|span| Ident::new("tokens", span));
    syn::Error::new_spanned(quote!(#first #last), message)
}

/// The message with the lines of the file; the compiler writes `error: ` before it.
fn in_file(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let text = diagnostic.render(sources, false);
    text.strip_prefix("error: ").unwrap_or(&text).to_string()
}
