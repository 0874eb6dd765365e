//! Stands for the bounds of rounding errors where the feature `rounding` is off.

use proc_macro2::TokenStream;

use crate::model::Family;

/// No bounds.
pub(super) fn bounds(_: &Family) {}

/// No bounds.
pub(super) fn of_told(_: &Family, _: &Family) {}

/// Nothing: the trait has constants for types without bounds.
pub(super) fn constants((): &(), _: &TokenStream) -> TokenStream {
    TokenStream::new()
}

/// Nothing.
pub(super) fn lines((): &(), _: &Family) -> Vec<String> {
    Vec::new()
}
