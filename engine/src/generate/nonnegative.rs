//! Which functions the claims of a family prove to be nonnegative, and what the documentation says of their values.

use std::rc::Rc;

use crate::claim::{Claim, ClaimKind, Comparison};
use crate::model::Family;
use crate::plan::denominator::Sign;
use crate::plan::interval::form::{IntervalForm, RationalForm};
use crate::plan::interval::{self, rational};
use crate::plan::patch::PatchPlans;
use crate::state::Verdict;
use basis_prover::collections::list::{Listed, Mapped};

/// The family with these functions marked; `None` where there are none.
pub(super) fn marked(family: &Family, verdicts: &[(Claim, Verdict)]) -> Option<Family> {
    let mut marked: Option<Family> = None;
    for (claim, verdict) in verdicts {
        if matches!(verdict, Verdict::Proved(_)) && says_something(&claim.kind) {
            mark(marked.get_or_insert_with(|| family.clone()), &claim.kind);
        }
    }
    marked.filter(|family| {
        family.pieces.iter().any(|p| p.nonnegative.contains(&true)) || family.nonnegative.contains(&true)
    })
}

/// Whether a claim may say of a function that it is nonnegative on the whole domain.
fn says_something(kind: &ClaimKind) -> bool {
    match kind {
        ClaimKind::Nonnegative => true,
        ClaimKind::Relation { differences, fixed, .. } => {
            fixed.is_empty()
                && differences.iter().any(|(c, _)| !matches!(c, Comparison::Equal | Comparison::NotEqual))
        }
        ClaimKind::Spans(parts) => parts.iter().any(|(_, kind)| says_something(kind)),
        _ => false,
    }
}

fn mark(family: &mut Family, kind: &ClaimKind) {
    if let ClaimKind::Spans(parts) = kind {
        for (span, kind) in parts {
            if let Some(piece) = family.pieces.get_mut(*span) {
                mark(Rc::make_mut(piece), kind);
            }
        }
        return;
    }
    family.nonnegative.resize(family.functions.len(), false);
    for (f, is_nonnegative) in family.functions.iter().zip(&mut family.nonnegative) {
        *is_nonnegative |= match kind {
            ClaimKind::Nonnegative => true,
            ClaimKind::Relation { differences, fixed, .. } if fixed.is_empty() => {
                differences.iter().any(|(comparison, difference)| match comparison {
                    Comparison::Greater | Comparison::GreaterEqual => difference.value == f.value,
                    Comparison::Less | Comparison::LessEqual => -&difference.value == f.value,
                    Comparison::Equal | Comparison::NotEqual => false,
                })
            }
            _ => false,
        };
    }
    if let ClaimKind::Nonnegative = kind {
        for piece in &mut family.pieces {
            mark(Rc::make_mut(piece), kind);
        }
    }
}

/// How the values of functions on an interval are kept from being negative.
pub(super) fn on_interval(family: &Family, form: &IntervalForm) -> Vec<String> {
    if !family.nonnegative.contains(&true) {
        return Vec::new();
    }
    let squares = form.functions.mapped(|f| !f.factored.square.is_empty());
    lines(family, &squares, &interval::values(family, form).cut_off())
}

/// How the values of functions on a simplex or a box are kept from being negative.
pub(super) fn on_patch(plans: &PatchPlans<'_>) -> Vec<String> {
    let family = plans.family;
    if !family.nonnegative.contains(&true) {
        return Vec::new();
    }
    let squares = match plans.steps {
        0 => plans.form.functions.mapped(|f| f.square.is_some()),
        _ => vec![false; family.functions.len()],
    };
    lines(family, &squares, &plans.values().cut_off())
}

/// How the values of quotients, span by span, are kept from being negative.
pub(super) fn of_quotients(family: &Family, forms: &[RationalForm]) -> Vec<String> {
    let count = family.functions.len();
    let (mut squares, mut cut_off) = (vec![false; count], vec![false; count]);
    for (k, form) in forms.iter().enumerate() {
        let piece = family.pieces.get(k).map_or(family, |piece| &**piece);
        if !piece.nonnegative.contains(&true) {
            continue;
        }
        let plan = (!form.is_tabulated).then(|| rational::values(piece, form).cut_off());
        for (k, cut_off) in cut_off.iter_mut().enumerate() {
            *cut_off |= plan.as_ref().map_or(piece.nonnegative[k], |plan| plan[k]);
            squares[k] |= plan.is_some()
                && piece.nonnegative[k]
                && !form.numerators.functions[k].factored.square.is_empty();
        }
    }
    let mut all = lines(family, &squares, &cut_off);
    all.extend(of_denominators(forms));
    all
}

/// What rounding could do to denominators, and what is done about it.
fn of_denominators(forms: &[RationalForm]) -> Vec<String> {
    let mut parts = Vec::new();
    if forms.iter().any(|form| form.completed.is_some()) {
        parts.push(
            "For values the denominator is computed as a square and what is added to it, which are not negative: it is 0 only where both underflow.",
        );
    }
    if forms.iter().any(|form| form.sign != Sign::Kept) {
        parts.push(
            "The Bernstein coefficients of the denominator have both signs: where it is smaller than its rounding error, it may be 0 in floats, and points and derivatives are infinite or NaN.",
        );
    }
    if forms.iter().any(|form| form.sign != Sign::Kept && form.completed.is_none()) {
        parts.push("So are values.");
    }
    if parts.is_empty() {
        return Vec::new();
    }
    vec![String::new(), parts.join(" ")]
}

fn lines(family: &Family, squares: &[bool], cut_off: &[bool]) -> Vec<String> {
    let labels = |which: &dyn Fn(usize) -> bool| {
        let all = (0..family.functions.len()).filter(|k| which(*k));
        all.map(|k| family.function_label(k)).listed().join(", ")
    };
    let squares = labels(&|k| squares[k] && !cut_off[k]);
    let cut_off = labels(&|k| cut_off[k]);
    let mut parts = Vec::new();
    if !squares.is_empty() {
        parts.push(format!("`{squares}`: never negative, computed with a square as a factor."));
    }
    if !cut_off.is_empty() {
        parts.push(format!(
            "`{cut_off}`: cut off at 0, below which only rounding could take what is proved nonnegative."
        ));
    }
    if parts.is_empty() {
        return Vec::new();
    }
    vec![String::new(), parts.join(" ")]
}
