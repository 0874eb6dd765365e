//! What files and documentation say of how far floats reach in shape values with exponentials.

use basis_prover::collections::list::Listed;

use super::shell::shape_ends;
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::diagnostic::Diagnostic;
use crate::model::{Family, Parameter};
use crate::plan::reach::{FLOATS, Reach, decimal};

/// The range of a shape parameter as far as floats reach, which stand at that position in [`FLOATS`], and whether they do not reach
/// its ends.
pub(crate) fn within(
    family: &Family,
    parameter: &Parameter,
    reach: Option<&Reach>,
    floats: usize,
) -> (Range, [bool; 2]) {
    let [low, high] = shape_ends(family, parameter);
    let mut range = Range { low, high };
    let mut is_short = [false; 2];
    if let Some(own) = reach.and_then(|reach| reach.low.as_ref()).map(|all| &all[floats])
        && range.low.value().is_none_or(|low| own > low)
    {
        range.low = End::Included(own.clone());
        is_short[0] = true;
    }
    if let Some(own) = reach.and_then(|reach| reach.high.as_ref()).map(|all| &all[floats])
        && range.high.value().is_none_or(|high| own < high)
    {
        range.high = End::Included(own.clone());
        is_short[1] = true;
    }
    (range, is_short)
}

/// The error for a shape parameter with no value that these floats reach.
pub(crate) fn out_of_reach(family: &Family, reaches: &[Option<Reach>], floats: usize) -> Option<Diagnostic> {
    let is_empty =
        |p: &Parameter, reach: &Option<Reach>| within(family, p, reach.as_ref(), floats).0.is_empty();
    let (p, reach) = family.shapes.iter().zip(reaches).find(|(p, reach)| is_empty(p, reach))?;
    let of = |ends: &Option<[Rational; 2]>| ends.as_ref().map(|ends| ends[floats].clone());
    let ends = reach.as_ref().map(|reach| [of(&reach.low), of(&reach.high)])?;
    let message = format!(
        "exponentials of `{}` overflow in {} for all values in its range `{}`: it reaches `{}` only",
        family.name_of(p),
        FLOATS[floats].0,
        family.declared(p),
        text(family.name_of(p), &ends),
    );
    let error = Diagnostic::error(family.place.clone(), message);
    Some(error.help("scale the parameter in the formulas, or choose a lower order or wider floats"))
}

/// Such as `-10 <= k <= 353.25`, with the ends that there are.
fn text(name: &str, ends: &[Option<Rational>; 2]) -> String {
    let [low, high] = ends.each_ref().map(|end| end.as_ref().map(decimal));
    match (low, high) {
        (Some(low), Some(high)) => format!("{low} <= {name} <= {high}"),
        (Some(low), None) => format!("{name} >= {low}"),
        (None, high) => format!("{name} <= {}", high.unwrap_or_default()),
    }
}

/// How far floats reach in the shape parameters of a family; nothing where they reach everywhere.
pub(in crate::generate) fn lines(family: &Family, reaches: &[Option<Reach>]) -> Vec<String> {
    let each = |(k, (floats, ..)): (usize, &(&str, i64, i64))| {
        let short = |(p, reach): (&Parameter, &Option<Reach>)| {
            let (range, is_short) = within(family, p, reach.as_ref(), k);
            let end = |end: &End, is_short: bool| end.value().filter(|_| is_short).cloned();
            let ends = [end(&range.low, is_short[0]), end(&range.high, is_short[1])];
            is_short.contains(&true).then(|| format!("`{}`", text(family.name_of(p), &ends)))
        };
        let ends = family.shapes.iter().zip(reaches).filter_map(short).listed();
        (!ends.is_empty()).then(|| format!("{} in {floats}", ends.join(", ")))
    };
    let all = FLOATS.iter().enumerate().filter_map(each).listed().join(" and ");
    if all.is_empty() {
        return Vec::new();
    }
    let text = format!(
        "Floats reach {all}: beyond, exponentials in the values or in their first two derivatives could overflow, and such shape \
         values are refused."
    );
    vec![String::new(), text]
}
