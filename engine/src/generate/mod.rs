//! From a family and its verdicts to Rust code.
//!
//! The code is small: the shape values, the functions in factored form, the tables that bind control points.
//! Everything that does not depend on the family is in the runtime. What kind of numbers stand in the code is
//! decided here; what the formulas are is decided in [`form`] for families on an interval and in [`patch_form`] for those on
//! simplices and boxes, which other targets can share.

mod docs;
mod ends;
pub mod form;
mod formula;
mod interval;
pub(crate) mod join;
mod names;
mod patch;
pub mod patch_form;
mod powers;
mod scalar;
mod shell;
mod weights;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote_spanned;

use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::claim::Claim;
use crate::model::Family;
use crate::state::Verdict;
use form::IntervalForm;
#[cfg(any(test, feature = "tools"))]
pub(crate) use formula::factored;
pub(crate) use formula::factored_on_box;
pub use names::ascii;
use shell::Shell;
#[cfg(any(test, feature = "tools"))]
pub(crate) use weights::{combination, zero, zeros};

/// How to emit a family.
#[derive(Clone, Debug)]
pub struct Options {
    /// The path of the runtime crate, such as `::basis_runtime`.
    pub runtime: TokenStream,
    /// The name of the type; `None` for the family's own name.
    pub name: Option<Ident>,
}

/// The type of a family, with its documentation and evaluators.
///
/// # Errors
/// When names of the spec cannot become names of Rust, or the family is too large.
pub fn family(
    family: &Family,
    verdicts: &[(Claim, Verdict)],
    options: &Options,
) -> Result<TokenStream, Vec<Diagnostic>> {
    let name = match &options.name {
        Some(name) => name.clone(),
        None => names::type_name(family).map_err(|error| vec![error])?,
    };
    let fields = names::fields(family)?;
    let shell = Shell { family, name: name.clone(), fields, runtime: &options.runtime };
    let code = match IntervalForm::new(family) {
        Some(form) => interval::emit(&shell, &form, verdicts),
        None => patch::emit(&shell, verdicts).map_err(|error| vec![error])?,
    };
    Ok(in_module(&name, &code))
}

/// The module with the functions of the joins of a spec, named after its file.
pub fn joins(file: &str, functions: &TokenStream) -> TokenStream {
    let module = names::module(file).unwrap_or_else(|| Ident::new("joins", site()));
    // The name is to be seen by the caller.
    let module = Ident::new(&module.to_string(), Span::call_site());
    let about = doc("Control points of curves and surfaces that join, as the spec determines them.");
    quote_spanned! {site()=>
        #about
        #[allow(unreachable_pub)]
        pub mod #module {
            #functions
        }
    }
}

/// Puts the code of a type into a module of its own, in which no name of the caller has a meaning: a constant `t`, a type
/// `f64` or a macro-made `Result` of the caller would otherwise change what the code says.
fn in_module(name: &Ident, code: &TokenStream) -> TokenStream {
    let module = Ident::new(&format!("__basis_{}", name.to_string().trim_start_matches("r#")), site());
    quote_spanned! {site()=>
        #[doc(hidden)]
        #[allow(non_snake_case, unreachable_pub)]
        mod #module {
            #code
        }
        #[doc(inline)]
        #[allow(unused_imports, unreachable_pub)]
        pub use #module::#name;
    }
}

/// Locals of the emitted code do not see names of the caller.
fn site() -> Span {
    Span::mixed_site()
}

/// A number of the scalar type.
fn number(value: &Rational) -> TokenStream {
    let literal = Literal::f64_unsuffixed(value.abs().to_f64());
    if value.is_negative() {
        quote_spanned!(site()=> -S::of(#literal))
    } else {
        quote_spanned!(site()=> S::of(#literal))
    }
}

/// `/// line`
fn doc(line: &str) -> TokenStream {
    let line = if line.is_empty() { String::new() } else { format!(" {line}") };
    quote_spanned!(site()=> #[doc = #line])
}
