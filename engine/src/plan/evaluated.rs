//! Which families have evaluators.

use crate::model::{Family, Function};
use crate::plan::interval::form::RationalForm;

/// Whether the steps of the evaluators of a family are known, if it is small enough.
#[cfg(any(test, feature = "rounding"))]
pub(crate) fn is_evaluated(family: &Family) -> bool {
    missing(family).is_none() && !is_mixed(family)
}

/// Why there are no evaluators for a family of any size; `None` where there are.
pub(crate) fn missing(family: &Family) -> Option<&'static str> {
    if is_mixed(family) || family.interval().is_some() {
        return None;
    }
    if RationalForm::is_of(family) {
        Some(
            "no code is generated yet for families with denominators, angles or exponentials in several domain variables",
        )
    } else {
        family.leaves_an_end_out().then_some(
            "no code is generated for families on a domain of several variables without its ends yet",
        )
    }
}

/// Whether the domain variable stands beside its sine or exponential in a function.
pub(crate) fn is_mixed(family: &Family) -> bool {
    let of = |f: &Function| family.domain.iter().any(|p| family.analytic.mixes(&f.value, p.var));
    family.functions.iter().any(of) || family.pieces.iter().any(|piece| is_mixed(piece))
}
