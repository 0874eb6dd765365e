//! The proved bounds of rounding errors in a generated type.

use proc_macro2::TokenStream;
use quote::quote_spanned;

use super::code::shell::Shell;
use super::code::tokens::{float, site};
use crate::rounding::Error;
use crate::state::value_errors;
use basis_prover::collections::list::Mapped;

/// The constant `ROUNDING` of a trait, and what the documentation says of it; nothing where no bound is found.
pub(super) fn constant(shell: &Shell<'_>) -> (TokenStream, Vec<String>) {
    let Shell { family, runtime, .. } = shell;
    let errors = value_errors(family);
    if errors.iter().all(Option::is_none) {
        return (TokenStream::new(), Vec::new());
    }
    let bounds = errors.mapped(|known| match known {
        Some((Error::Relative(bound), _)) => {
            let bound = float(bound);
            quote_spanned!(site()=> #runtime::Rounding::Relative(#bound))
        }
        Some((Error::Absolute(bound), _)) => {
            let bound = float(bound);
            quote_spanned!(site()=> #runtime::Rounding::Absolute(#bound))
        }
        None => quote_spanned!(site()=> #runtime::Rounding::Unknown),
    });
    let constant = quote_spanned! {site()=>
        const ROUNDING: &'static [#runtime::Rounding] = &[#(#bounds),*];
    };
    let mut lines: Vec<(String, String)> = Vec::new();
    for (k, known) in errors.iter().enumerate() {
        let bound = known.as_ref().map_or_else(|| String::from("unknown"), |(error, _)| error.to_string());
        let label = family.function_label(k);
        match lines.iter_mut().find(|(_, other)| *other == bound) {
            Some((labels, _)) => *labels += &format!(", {label}"),
            None => lines.push((label, bound)),
        }
    }
    let texts = lines.mapped(|(labels, bound)| format!("`{labels}`: {bound}"));
    let line = format!("Rounding errors of the values, proved to be at most: {}.", texts.join("; "));
    (constant, vec![String::new(), line])
}
