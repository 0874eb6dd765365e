//! From a family and its verdicts to Rust code.
//!
//! The code is small: the shape values, the functions in factored form, the tables that bind control points.
//! Everything that does not depend on the family is in the runtime. What is computed, and in which order, is decided in
//! [`crate::plan`], which other targets share; `rust` prints it.

mod code;
mod ends;
mod formula;
mod interval;
#[cfg(feature = "joins")]
pub(crate) mod join;
mod nonnegative;
mod patch;
pub(crate) mod rational;
#[cfg(any(test, feature = "rounding"))]
mod rounding;
#[cfg(not(any(test, feature = "rounding")))]
#[path = "no_rounding.rs"]
mod rounding;
mod rust;

use std::borrow::Cow;

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote_spanned;

use crate::claim::Claim;
use crate::diagnostic::Diagnostic;
use crate::model::{Family, Truncations};
use crate::plan::interval::form::{IntervalForm, RationalForm};
use crate::plan::reach::{self, Reach};
use crate::plan::{evaluated, series};
use crate::state::Verdict;
use crate::subject::{Item, Subject};
#[cfg(any(test, feature = "tools"))]
pub(crate) use code::reach::{out_of_reach, within};
use code::shell::Shell;
use code::tokens::{doc, site};
use code::{floats, names};
#[cfg(any(test, feature = "tools"))]
pub(crate) use formula::{factored, factored_on_box};

/// How to emit a family or a join.
#[derive(Clone, Debug)]
pub struct Options {
    /// The path of the runtime crate, such as `::basis_runtime`.
    pub runtime: TokenStream,
    /// The name of the type or function; `None` for the family's own name.
    pub name: Option<Ident>,
    /// When the claims were decided, for the documentation.
    pub decided: &'static str,
}

impl Options {
    /// For the macro.
    pub fn for_macro(runtime: TokenStream, name: Option<Ident>) -> Self {
        Self { runtime, name, decided: "while this crate was compiled" }
    }
}

/// The type of a family, with its documentation and evaluators, in a module of its own.
///
/// # Errors
/// When names of the spec cannot become names of Rust, or the family is too large.
pub fn family(
    family: &Family,
    verdicts: &[(Claim, Verdict)],
    options: &Options,
) -> Result<TokenStream, Vec<Diagnostic>> {
    let name = type_name(family, options.name.as_ref()).map_err(|error| vec![error])?;
    Ok(in_module(&name, &definition(family, verdicts, name.clone(), options)?))
}

/// What there is in place of code.
const NO_CODE: &str =
    "its claims are proved, and `basis explain` and `basis eval` know it; for code, leave such functions out";

/// The family as it is evaluated: in polynomials where the domain variable stands beside its sine, in the tangents of its
/// shape parameters, and with the functions marked that its claims prove to be nonnegative.
///
/// # Errors
/// Why no code is generated for it.
pub fn evaluated<'a>(
    family: &'a Family,
    verdicts: &[(Claim, Verdict)],
) -> Result<Cow<'a, Family>, Diagnostic> {
    let Some(marked) = nonnegative::marked(family, verdicts) else { return in_evaluated_form(family) };
    let owned = match in_evaluated_form(&marked)? {
        Cow::Owned(evaluated) => Some(evaluated),
        Cow::Borrowed(_) => None,
    };
    Ok(Cow::Owned(owned.unwrap_or(marked)))
}

fn in_evaluated_form(family: &Family) -> Result<Cow<'_, Family>, Diagnostic> {
    let error = |message: &str| Diagnostic::error(family.place.clone(), message).help(NO_CODE);
    if let Some(reason) = evaluated::missing(family) {
        return Err(error(reason));
    }
    // Where bounds take too long nothing is found for them.
    let truncations =
        if cfg!(any(test, feature = "tools")) { Truncations::Found } else { Truncations::LeftOut };
    evaluated::form(family, truncations).ok_or_else(|| {
        if !evaluated::is_mixed(family) {
            return error(
                "no code is generated for parameters in `exp`, `sinh` or `cosh` with ranges that end in these numbers",
            );
        }
        if let Some((name, range)) = series::longest(family) {
            let message = format!(
                "no code is generated for `{}` with all values of `{name}` in its range: beside its sine or exponential the domain \
                 variable is computed from power series in `{name}`, which do not end for large values",
                family.title()
            );
            let error = Diagnostic::error(family.place.clone(), message);
            return error.help(format!("end the range of `{name}` earlier: `shape {range};`"));
        }
        error(
            "no code is generated yet for families with the domain variable beside its sine or exponential and sines of it in \
             a denominator, of too high a degree, or with an end of the domain that is not a multiple of one shape parameter",
        )
    })
}

/// The error for a family with too many coefficients.
pub(crate) fn too_large(family: &Family) -> Diagnostic {
    let message = format!("`{}` has too many coefficients to be generated", family.title());
    let error = Diagnostic::error(family.place.clone(), message);
    error.help("choose a lower order, or functions of lower degree")
}

/// The error for a family with numbers for which there is no float, in its formulas or in what is evaluated.
#[cfg(any(test, feature = "tools"))]
pub(crate) fn beyond_floats(family: &Family, steps: &crate::steps::FamilySteps<'_>) -> Option<Diagnostic> {
    if !floats::of_family(family) {
        return None;
    }
    let missing = |steps: &crate::steps::Steps| {
        steps.steps.iter().any(|step| match step {
            crate::steps::Step::Constant(value) => floats::nearest(&value.abs()).is_none(),
            _ => false,
        })
    };
    let on_span = |span: usize| {
        let steps = steps.on_span(span);
        [steps.values(), steps.bernstein_weights(), steps.bind()].iter().any(missing)
    };
    let missing = (0..steps.spans()).any(on_span);
    let direct = floats::direct(family);
    if missing && direct.is_none() { Some(floats::indirect(family)) } else { direct }
}

/// What the documentation of a generated type says: the formulas, the ranges, the claims with their verdicts; Markdown,
/// one string a line. `told` is the family as its spec has it, `family` as it is evaluated; `proved` are the bounds of its
/// rounding errors; `decided` says when the claims were decided. `None` when the family is too
/// large.
#[cfg(any(test, feature = "tools"))]
pub(crate) fn documentation(
    told: &Family,
    family: &Family,
    proved: &Bounds,
    verdicts: &[(Claim, Verdict)],
    decided: &str,
) -> Option<Vec<String>> {
    let forms = RationalForm::of_family(family);
    let reaches = reaches(family, forms.as_deref());
    let (formulas, signs) = match (forms, IntervalForm::new(family)) {
        (Some(forms), _) => {
            (rational::formulas(told, family, &forms), nonnegative::of_quotients(family, &forms))
        }
        (_, Some(form)) => (interval::formulas(family, &form), nonnegative::on_interval(family, &form)),
        _ => {
            let plans = crate::plan::patch::PatchPlans::new(family)?;
            (patch::formulas(&plans), nonnegative::on_patch(&plans))
        }
    };
    let bounds = [signs, code::reach::lines(family, &reaches), rounding::lines(proved, family)].concat();
    Some(code::docs::family(told, &formulas, &bounds, verdicts, decided))
}

#[cfg(any(test, feature = "tools"))]
pub(crate) use rounding::{Bounds, of_told as bounds_of_told};

/// How far floats reach in the shape parameters of a family that is evaluated as these quotients, or as none.
pub(crate) fn reaches(family: &Family, forms: Option<&[RationalForm]>) -> Vec<Option<Reach>> {
    forms.map_or_else(|| vec![None; family.shapes.len()], |forms| reach::reaches(family, forms))
}

/// The type of a family, with its documentation and evaluators.
///
/// # Errors
/// As [`family`].
pub(crate) fn definition(
    family: &Family,
    verdicts: &[(Claim, Verdict)],
    name: Ident,
    options: &Options,
) -> Result<TokenStream, Vec<Diagnostic>> {
    let fields = names::fields(family)?;
    let Options { runtime, decided, .. } = options;
    let told = family;
    let evaluated = evaluated(family, verdicts).map_err(|error| vec![error])?;
    let family = &*evaluated;
    let forms = RationalForm::of_family(family);
    let reaches = reaches(family, forms.as_deref());
    // A type is for both kinds of floats: at least the wide ones have to reach a value.
    if let Some(error) = code::reach::out_of_reach(family, &reaches, 0) {
        return Err(vec![error]);
    }
    let shell = Shell { family, name, fields, runtime, reaches, decided };
    let code = match (forms, IntervalForm::new(family)) {
        (Some(forms), _) => rational::emit(&shell, told, &forms, verdicts),
        (_, Some(form)) => interval::emit(&shell, &form, verdicts),
        _ => patch::emit(&shell, verdicts).map_err(|error| vec![error])?,
    };
    if floats::of_family(family) && floats::misses_a_number(&code) {
        return Err(vec![floats::direct(family).unwrap_or_else(|| floats::indirect(family))]);
    }
    Ok(code)
}

/// The name of the type of a family, for which a macro call may ask another one.
///
/// # Errors
/// When the name cannot be that of a type.
pub fn type_name(family: &Family, wanted: Option<&Ident>) -> Result<Ident, Diagnostic> {
    names::type_name(family, wanted)
}

/// The name of the module with the functions of the joins of a spec, which is named after its file.
pub fn module_name(file: &str) -> String {
    names::module(file).map_or_else(|| String::from("joins"), |name| name.to_string())
}

/// Warnings about families that are exact as they are, but have numbers beyond floats: no code can be generated for
/// them. One for each name.
pub fn no_floats(items: &[Item]) -> Vec<Diagnostic> {
    /// The most terms of families whose code is generated to find out; the macro looks at every family.
    const TERMS: usize = 1000;
    let mut warnings = Vec::new();
    let mut last = "";
    let mut left = TERMS;
    for item in items {
        let Subject::Family(family) = &item.subject else { continue };
        if family.name == last || RationalForm::is_of(family) || !floats::of_family(family) {
            continue;
        }
        let mut error = floats::direct(family);
        let terms: usize = family.functions.iter().map(|f| f.value.numer().len()).sum();
        if error.is_none() && terms <= left {
            left -= terms;
            let name = Some(Ident::new("Family", site()));
            let options = Options::for_macro(quote_spanned!(site()=> ::basis_runtime), name);
            let errors = self::family(family, &[], &options).err().unwrap_or_default();
            error = errors.into_iter().find(|error| error.message.starts_with(floats::ERROR));
        }
        if let Some(error) = error {
            last = &family.name;
            warnings.push(error.warning());
        }
    }
    warnings
}

/// The module with the functions of the joins of a spec, named after its file.
pub fn joins(file: &str, functions: &TokenStream) -> TokenStream {
    let mut module = names::module(file).unwrap_or_else(|| Ident::new("joins", site()));
    // The name is to be seen by the caller.
    module.set_span(Span::call_site());
    let about = doc("Control points of curves and surfaces that join, as the spec determines them.");
    quote_spanned! {site()=>
        #about
        #[allow(unreachable_pub)]
        pub mod #module {
            #functions
        }
    }
}

/// Puts the code of a type into a module of its own, in which no name of the caller has a meaning: a constant `t`, a
/// type `f64` or a macro-made `Result` of the caller would otherwise change what the code says.
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
