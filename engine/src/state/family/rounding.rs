//! Claims about the rounding errors of computed values.

use super::super::proofs::{all, steps};
use super::super::verdict::{Evidence, Stated, Verdict};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::rounding::{self, Bound, decimal};

/// What has to be true so that the values of all functions are within this many ε; `None` when a function has no bound
/// or the work is spent.
pub(super) fn statements(family: &Family, epsilons: &Rational) -> Option<Vec<Stated>> {
    let bounds = rounding::values(family)?;
    let mut stated = Vec::new();
    for (k, bound) in bounds.iter().enumerate() {
        for statement in bound.as_ref()?.statements(epsilons) {
            stated.push(Stated::new(format!("rounding of {}", family.function_label(k)), statement));
        }
    }
    Some(stated)
}

/// Decides that the values of all functions are within this many ε. It is never refuted: a bound says what errors are
/// impossible, and not which ones occur.
pub(super) fn decide(family: &Family, epsilons: &Rational) -> Verdict {
    let Some(bounds) = rounding::values(family) else {
        return Verdict::Undecided(String::from("the budget is spent on the rounding errors of the values"));
    };
    let mut largest: Option<(usize, &Bound)> = None;
    for (k, bound) in bounds.iter().enumerate() {
        let Some(bound) = bound else {
            let label = family.function_label(k);
            return Verdict::Undecided(format!("no bound of the rounding errors of `{label}` was found"));
        };
        if largest.is_none_or(|(_, known)| bound.error.epsilons() > known.error.epsilons()) {
            largest = Some((k, bound));
        }
    }
    if let Some((k, bound)) = largest
        && bound.error.epsilons() > epsilons
    {
        let (label, proved) = (family.function_label(k), decimal(bound.error.epsilons()));
        return Verdict::Undecided(format!("what can be proved is `rounding <= {proved}`, for `{label}`"));
    }
    match statements(family, epsilons).map(|statements| all(statements, family.budget)) {
        Some(Ok(shown)) => {
            Verdict::Proved(Evidence::new(String::from("signs of the shares of all roundings"), steps(shown)))
        }
        _ => Verdict::Undecided(String::from("the signs of the shares of the roundings are not decided")),
    }
}
