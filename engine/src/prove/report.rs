//! Verdicts that contradict what a spec declares, as errors.

use super::{Verdict, as_declared};
use crate::diagnostic::Diagnostic;
use crate::model::{Claim, Expected, Family};

/// The error for a claim whose verdict is not the declared one; `None` when all is as declared.
pub fn diagnose(family: &Family, claim: &Claim, verdict: &Verdict) -> Option<Diagnostic> {
    if as_declared(claim.expected, verdict) {
        return None;
    }
    let title = family.title();
    let mut diagnostic = match verdict {
        Verdict::Refuted(witness) => {
            let message = format!("{title}: the claim `{}` is false", claim.text);
            let mut d = Diagnostic::error(claim.place.clone(), message).label("refuted");
            d.notes.clone_from(&witness.notes);
            d.help("correct the formulas or the claim; `refute` declares a claim false")
        }
        Verdict::Proved(evidence) => {
            let message = format!("{title}: the claim `{}` is declared false, but it is true", claim.text);
            Diagnostic::error(claim.place.clone(), message)
                .label("proved")
                .note(format!("proved by {}", evidence.method))
                .help("write `prove`")
        }
        Verdict::Undecided(left) => {
            let verb = if claim.expected == Expected::True { "proved" } else { "refuted" };
            let message = format!("{title}: the claim `{}` is neither proved nor refuted", claim.text);
            Diagnostic::error(claim.place.clone(), message)
                .label(format!("declared to be {verb}"))
                .note(left.clone())
                .help("raise the budget, such as `budget 10;`, or narrow the ranges")
        }
    };
    if !family.order.is_empty() {
        let values: Vec<String> =
            family.order.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        diagnostic.notes.push(format!("for {}", values.join(", ")));
    }
    Some(diagnostic)
}
