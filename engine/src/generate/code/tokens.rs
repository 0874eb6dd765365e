//! Numbers and comments as tokens, and the span that all tokens have.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::floats;
use crate::algebra::rational::Rational;
use crate::decimals;

/// Locals of the emitted code do not see names of the caller.
pub(in crate::generate) fn site() -> Span {
    Span::mixed_site()
}

/// A number of the scalar type.
pub(in crate::generate) fn number(value: &Rational) -> TokenStream {
    let literal = float(value);
    if value.is_negative() {
        quote_spanned!(site()=> -S::of(#literal))
    } else {
        quote_spanned!(site()=> S::of(#literal))
    }
}

/// The magnitude of a number as a literal; a name without meaning where there is no such float, [`floats`].
pub(in crate::generate) fn float(value: &Rational) -> TokenStream {
    match floats::nearest(&value.abs()) {
        Some(value) => decimals::of_float(value).parse::<Literal>().expect("a decimal").to_token_stream(),
        None => Ident::new(floats::MISSING, site()).to_token_stream(),
    }
}

/// `/// line`
pub(in crate::generate) fn doc(line: &str) -> TokenStream {
    let line = if line.is_empty() { String::new() } else { format!(" {line}") };
    quote_spanned!(site()=> #[doc = #line])
}
