//! Rounding errors of computed values and points: claims about them, and bounds that are proved without a claim.

use super::super::proofs::{all, steps};
use super::super::verdict::{Evidence, Stated, Verdict};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::rounding::{self, Bound, Error, decimal};
use basis_prover::collections::list::Listed;

const METHOD: &str = "signs of the shares of all roundings";

/// The errors of the values of all functions with the evidence for them; nothing for one without a bound. The list is
/// empty when there is no code for the family, or it is too large, or has an end that is computed otherwise than as a sum of multiples
/// of shape parameters.
pub fn value_errors(family: &Family) -> Vec<Option<(Error, Evidence)>> {
    let bounds = rounding::values(family).unwrap_or_default();
    let label = |k: usize| family.function_label(k);
    bounds.iter().enumerate().map(|(k, bound)| proved(family, &label(k), bound.as_ref()?)).listed()
}

/// The error of each component of a point of a curve or patch relative to the largest one of a control point, with the
/// evidence; `None` where none is found.
pub fn point_error(family: &Family) -> Option<(Error, Evidence)> {
    proved(family, &point_name(family), &rounding::point(family)?)
}

/// What a point of a curve or patch is called, such as `C(t)` or `P(u, v, w)`.
pub fn point_name(family: &Family) -> String {
    let names = family.domain_variables().map(|p| family.name_of(p)).listed();
    format!("{}({})", if family.interval().is_some() { "C" } else { "P" }, names.join(", "))
}

fn proved(family: &Family, of: &str, bound: &Bound) -> Option<(Error, Evidence)> {
    let stated = stated(of, bound, bound.error.epsilons());
    let shown = all(stated, family.budget).ok()?;
    Some((bound.error.clone(), Evidence::new(String::from(METHOD), steps(shown))))
}

fn stated(of: &str, bound: &Bound, epsilons: &Rational) -> Vec<Stated> {
    let statements = bound.statements(epsilons).into_iter();
    statements.map(|statement| Stated::new(format!("rounding of {of}"), statement)).listed()
}

/// What has to be true so that the values of all functions are within this many ε; `None` when a function has no bound or a
/// larger one, or the work is spent.
pub(super) fn statements(family: &Family, epsilons: &Rational) -> Option<Vec<Stated>> {
    let mut all = Vec::new();
    for (k, bound) in rounding::values(family)?.iter().enumerate() {
        let bound = bound.as_ref().filter(|bound| bound.error.epsilons() <= epsilons)?;
        all.extend(stated(&family.function_label(k), bound, epsilons));
    }
    Some(all)
}

/// That there is no bound for a function, and why.
#[cfg(any(test, feature = "tools"))]
fn without(family: &Family, k: usize, label: &str) -> String {
    format!("of the rounding errors of `{label}` there is {}", rounding::advice(family, Some(k)))
}

#[cfg(not(any(test, feature = "tools")))]
fn without(_: &Family, _: usize, label: &str) -> String {
    format!("no bound of the rounding errors of `{label}` was found")
}

/// Decides that the values of all functions are within this many ε. It is never refuted: a bound says what errors are
/// impossible, and not which ones occur.
pub(super) fn decide(family: &Family, epsilons: &Rational) -> Verdict {
    let Some(bounds) = rounding::values(family) else {
        return Verdict::Undecided(String::from(
            "rounding errors are bounded for families with code that are not too large, with ends and knots that are numbers or sums of multiples of shape parameters",
        ));
    };
    let mut largest: Option<(String, &Bound)> = None;
    let mut statements = Vec::new();
    for (k, bound) in bounds.iter().enumerate() {
        let label = family.function_label(k);
        let Some(bound) = bound else {
            return Verdict::Undecided(without(family, k, &label));
        };
        statements.extend(stated(&label, bound, epsilons));
        if largest.as_ref().is_none_or(|(_, known)| bound.error.epsilons() > known.error.epsilons()) {
            largest = Some((label, bound));
        }
    }
    if let Some((label, bound)) = largest
        && bound.error.epsilons() > epsilons
    {
        let proved = decimal(bound.error.epsilons());
        return Verdict::Undecided(format!("what can be proved is `rounding <= {proved}`, for `{label}`"));
    }
    match all(statements, family.budget) {
        Ok(shown) => Verdict::Proved(Evidence::new(String::from(METHOD), steps(shown))),
        Err((of, _)) => Verdict::Undecided(format!("the signs for the {of} are not decided")),
    }
}
