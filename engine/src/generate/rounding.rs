//! The proved bounds of rounding errors in a generated type.

use proc_macro2::TokenStream;
use quote::quote_spanned;

use super::code::tokens::{float, site};
use crate::model::Family;
use crate::plan::evaluated::is_mixed;
#[cfg(any(test, feature = "tools"))]
use crate::rounding::advice;
use crate::rounding::{BARYCENTRIC, Error, assumed, decimal, grouped};
use crate::state::{point_error, value_errors};
use basis_prover::collections::list::{Listed, Mapped};

/// The bounds that are proved for a family.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bounds {
    /// Those of the values, one for each function, `None` where none is proved; empty where there are none.
    pub(crate) values: Vec<Option<Error>>,
    /// That of each component of a point of a curve or patch, binding included, relative to the largest absolute value of
    /// that component of a control point.
    pub(crate) point: Option<Error>,
}

/// The bounds of the family that is `told` of, as it is evaluated. For polynomials in place of functions with a variable beside
/// its sine they take seconds without optimization, and are for files that are written once.
pub(crate) fn of_told(told: &Family, family: &Family) -> Bounds {
    let takes_long = is_mixed(told) && !cfg!(any(test, feature = "tools"));
    if takes_long { Bounds::default() } else { bounds(family) }
}

/// The proved bounds of a family.
pub(crate) fn bounds(family: &Family) -> Bounds {
    let values = value_errors(family).into_iter().map(|known| known.map(|(error, _)| error)).listed();
    let values = if values.iter().all(Option::is_none) { Vec::new() } else { values };
    Bounds { values, point: point_error(family).map(|(error, _)| error) }
}

/// The constants `ROUNDING` and `ROUNDING_POINT` of a trait.
pub(super) fn constants(bounds: &Bounds, runtime: &TokenStream) -> TokenStream {
    let mut constants = TokenStream::new();
    if !bounds.values.is_empty() {
        let values = bounds.values.mapped(|error| match error {
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
        constants = quote_spanned!(site()=> const ROUNDING: &'static [#runtime::Rounding] = &[#(#values),*];);
    }
    if let Some(point) = &bounds.point {
        let core = quote_spanned!(site()=> #runtime::__private::core);
        let point = float(point.epsilons());
        constants = quote_spanned! {site()=>
            #constants
            const ROUNDING_POINT: #core::option::Option<f64> = #core::option::Option::Some(#point);
        };
    }
    constants
}

/// What the documentation says of the bounds. Functions with the same one stand together.
pub(super) fn lines(bounds: &Bounds, family: &Family) -> Vec<String> {
    let mut lines = Vec::new();
    let says_why = cfg!(any(test, feature = "tools"));
    let none = vec![None; if says_why { family.functions.len() } else { 0 }];
    let values = if bounds.values.is_empty() { &none } else { &bounds.values };
    let groups = grouped(values, family, &|k| without(family, Some(k)));
    let texts = |is_bounded: bool| {
        let own = groups.iter().filter(|group| group.is_bounded == is_bounded);
        own.map(|group| format!("`{}`: {}", group.labels, group.text)).listed().join("; ")
    };
    let (bounded, others) = (texts(true), texts(false));
    if !bounded.is_empty() {
        let assumed = assumed(family).map_or_else(String::new, |text| format!(", {text}"));
        let line = format!("Rounding errors of the values, proved to be at most: {bounded}{assumed}.");
        lines.extend([String::new(), line]);
    }
    if !others.is_empty() {
        let of = if bounded.is_empty() { "the values" } else { "other values" };
        lines.extend([String::new(), format!("Rounding errors of {of}: {others}.")]);
    }
    if let Some(error) = &bounds.point {
        let epsilons = decimal(error.epsilons());
        let of = if family.interval().is_some() { "curve" } else { "patch" };
        let mut line = format!(
            "Rounding error of each component of a point of a {of}, binding included, proved to be at most: {epsilons} ε times the largest absolute value of that component of a control point"
        );
        if !family.simplices.is_empty() {
            line += &format!(", {BARYCENTRIC}");
        }
        lines.extend([String::new(), line + "."]);
    } else if says_why {
        let reason = without(family, None);
        lines.extend([String::new(), format!("Rounding error of a point, binding included: {reason}.")]);
    }
    lines
}

/// What is said where there is no bound; why there is none takes time, and is for files that are written once.
#[cfg(any(test, feature = "tools"))]
fn without(family: &Family, function: Option<usize>) -> String {
    advice(family, function)
}

#[cfg(not(any(test, feature = "tools")))]
fn without(_: &Family, _: Option<usize>) -> String {
    String::from("unknown")
}
