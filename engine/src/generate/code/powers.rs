//! Powers of local variables of the emitted code: each one is computed once.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote_spanned};

use super::scalar;
use super::tokens::site;
use basis_prover::collections::list::{Listed, Mapped};

/// The powers of the coordinates.
#[derive(Default)]
pub(in crate::generate) struct Powers {
    known: Vec<(String, u32)>,
    lets: TokenStream,
}

impl Powers {
    /// The power of a local variable; `None` for the exponent 0.
    pub(in crate::generate) fn get(&mut self, base: &str, exponent: u32) -> Option<Ident> {
        if exponent == 0 {
            return None;
        }
        if exponent == 1 {
            return Some(Ident::new(base, site()));
        }
        let joint = if base.ends_with(|c: char| c.is_ascii_digit()) { "_" } else { "" };
        let name = Ident::new(&format!("{base}{joint}{exponent}"), site());
        if !self.known.iter().any(|(b, e)| b == base && *e == exponent) {
            let (a, b) = (self.get(base, exponent / 2), self.get(base, exponent - exponent / 2));
            self.lets.extend(quote_spanned!(site()=> let #name = #a * #b;));
            self.known.push((base.to_string(), exponent));
        }
        Some(name)
    }

    /// The product of powers; `None` for 1.
    pub(in crate::generate) fn product(
        &mut self,
        bases: &[String],
        exponents: &[u32],
    ) -> Option<TokenStream> {
        let factors: Vec<Ident> =
            bases.iter().zip(exponents).filter_map(|(base, e)| self.get(base, *e)).listed();
        match factors.as_slice() {
            [] => None,
            [one] => Some(one.to_token_stream()),
            many => {
                let product = scalar::product(many.mapped(ToTokens::to_token_stream));
                Some(quote_spanned!(site()=> (#product)))
            }
        }
    }

    pub(in crate::generate) fn lets(self) -> TokenStream {
        self.lets
    }
}
