//! Exact numbers for which there is no float: beyond the largest, or so small that digits are lost.

use proc_macro2::{TokenStream, TokenTree};

use crate::algebra::rational::{Rational, ToFloat as _};
use crate::diagnostic::Diagnostic;
use crate::model::{Family, Parameter};

/// Stands in generated code for a number that is no float: nothing has this name.
pub(in crate::generate) const MISSING: &str = "__number_beyond_f64";

/// What the errors about such numbers begin with.
pub(in crate::generate) const ERROR: &str = "no code can be generated:";

/// What to do about them.
pub(in crate::generate) const HELP: &str =
    "the numbers of generated code lie between 2.2e-308 and 1.8e308: scale the functions or the parameters";

/// The nearest float of a number ≥ 0; `None` beyond the largest, and below the smallest with all its digits.
pub(in crate::generate) fn nearest(value: &Rational) -> Option<f64> {
    let float = value.to_f64();
    (value.is_zero() || float.is_normal()).then_some(float)
}

/// Whether numbers of the code of a family can be so large or small: a cheap bound, which nearly all families keep.
pub(in crate::generate) fn of_family(family: &Family) -> bool {
    let ends = |p: &Parameter| [&p.range.low, &p.range.high].map(|end| end.value().map_or(0, Rational::bits));
    let parameters = || family.shapes.iter().chain(&family.domain);
    let widest = parameters().flat_map(ends).max().unwrap_or(0);
    let functions = || family.functions.iter().map(|f| &f.value);
    let bits = functions().map(|f| f.numer().max_bits() + f.denom().max_bits()).max().unwrap_or(0);
    let degree = functions().map(|f| f.numer().total_degree() + f.denom().total_degree()).max().unwrap_or(0);
    // A number of a Bernstein form is a sum of coefficients times powers of the ends and binomial coefficients.
    bits + u64::from(degree) * (widest + 4) > 900
}

/// Whether a number is missing in generated code.
pub(in crate::generate) fn misses_a_number(code: &TokenStream) -> bool {
    code.clone().into_iter().any(|token| match token {
        TokenTree::Group(group) => misses_a_number(&group.stream()),
        TokenTree::Ident(ident) => ident == MISSING,
        TokenTree::Punct(_) | TokenTree::Literal(_) => false,
    })
}

/// The error for a family that is written with a number for which there is no float, at the range or function that
/// has it.
pub(in crate::generate) fn direct(family: &Family) -> Option<Diagnostic> {
    let has_no_float = |value: &Rational| nearest(&value.abs()).is_none();
    for parameter in family.shapes.iter().chain(&family.domain) {
        let ends = [&parameter.range.low, &parameter.range.high];
        if ends.into_iter().filter_map(|end| end.value()).any(has_no_float) {
            let message = format!("{ERROR} an end of the range of `{}` is beyond f64", parameter.name);
            return Some(Diagnostic::error(parameter.place.clone(), message).help(HELP));
        }
    }
    let of = |k: &usize| {
        let value = &family.functions[*k].value;
        let mut coefficients = value.numer().terms().chain(value.denom().terms());
        coefficients.any(|(_, c)| has_no_float(c))
    };
    let found = (0..family.functions.len()).find(of)?;
    let message = format!("{ERROR} a coefficient of `{}` is beyond f64", family.function_label(found));
    Some(Diagnostic::error(family.place.clone(), message).help(HELP))
}

/// The error for a family whose Bernstein form has such a number.
pub(in crate::generate) fn indirect(family: &Family) -> Diagnostic {
    let message = format!("{ERROR} coefficients of the Bernstein form of the functions are beyond f64");
    Diagnostic::error(family.place.clone(), message).help(HELP)
}
