//! Which families have evaluators, and in which form they are evaluated.

use std::borrow::Cow;
use std::rc::Rc;

use crate::model::angle::tangents::in_tangents;
use crate::model::{Family, Function, Truncations};
use crate::plan::interval::form::RationalForm;
use crate::plan::series;
use basis_prover::collections::list::Listed;

/// The family as it is evaluated: in polynomials where the domain variable stands beside its sine, in the tangents of
/// its shape parameters elsewhere; `None` where no such form is known.
pub(crate) fn form(family: &Family, truncations: Truncations) -> Option<Cow<'_, Family>> {
    if is_mixed(family) {
        return series::in_polynomials(family, truncations).map(Cow::Owned);
    }
    let evaluated = in_tangents(family)?;
    Some(if family.analytic.roots.is_empty() { evaluated } else { Cow::Owned(vanishing(&evaluated)) })
}

/// The family with numerators that vanish as polynomials at the ends of the domain wherever the functions do, although
/// these ends are made of tan(π/n).
fn vanishing(family: &Family) -> Family {
    let mut result = family.clone();
    for f in &mut result.functions {
        f.value = family.analytic.reduced(f.value.clone());
    }
    result.pieces = family.pieces.iter().map(|piece| Rc::new(vanishing(piece))).listed();
    result
}

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
