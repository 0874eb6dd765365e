//! Stands for the bounds of rounding errors where the feature `rounding` is off.

use proc_macro2::TokenStream;

use super::code::shell::Shell;

/// Nothing: the trait has a constant for types without bounds.
pub(super) fn constant(_: &Shell<'_>) -> (TokenStream, Vec<String>) {
    (TokenStream::new(), Vec::new())
}
