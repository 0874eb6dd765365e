//! The proved bounds of rounding errors in a generated type.

use proc_macro2::TokenStream;
use quote::quote_spanned;

use super::code::tokens::{float, site};
use crate::model::Family;
use crate::rounding::{Error, grouped};
use crate::state::value_errors;
use basis_prover::collections::list::{Listed, Mapped};

/// The proved bounds for the functions of the family that is `told` of; empty where there are none. Polynomials that are
/// evaluated in place of its functions differ from these by more than a bound of their own errors says.
pub(super) fn of_told(told: &Family, family: &Family) -> Vec<Option<Error>> {
    if told.pieces.len() == family.pieces.len() { errors(family) } else { Vec::new() }
}

/// The proved bounds for all functions; empty where there are none.
pub(super) fn errors(family: &Family) -> Vec<Option<Error>> {
    let errors = value_errors(family).into_iter().map(|known| known.map(|(error, _)| error)).listed();
    if errors.iter().all(Option::is_none) { Vec::new() } else { errors }
}

/// The constant `ROUNDING` of a trait.
pub(super) fn constant(errors: &[Option<Error>], runtime: &TokenStream) -> TokenStream {
    if errors.is_empty() {
        return TokenStream::new();
    }
    let bounds = errors.mapped(|error| match error {
        Some(Error::Relative(bound)) => {
            let bound = float(bound);
            quote_spanned!(site()=> #runtime::Rounding::Relative(#bound))
        }
        Some(Error::Absolute(bound)) => {
            let bound = float(bound);
            quote_spanned!(site()=> #runtime::Rounding::Absolute(#bound))
        }
        None => quote_spanned!(site()=> #runtime::Rounding::Unknown),
    });
    quote_spanned!(site()=> const ROUNDING: &'static [#runtime::Rounding] = &[#(#bounds),*];)
}

/// What the documentation says of the bounds. Functions with the same one stand together.
pub(super) fn lines(errors: &[Option<Error>], family: &Family) -> Vec<String> {
    if errors.is_empty() {
        return Vec::new();
    }
    let groups = grouped(errors, family, "unknown");
    let texts = groups.mapped(|(labels, bound)| format!("`{labels}`: {bound}"));
    let line = format!("Rounding errors of the values, proved to be at most: {}.", texts.join("; "));
    vec![String::new(), line]
}
