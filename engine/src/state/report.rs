//! Verdicts that contradict what a spec declares, as errors.

use basis_prover::collections::list::Mapped;

use super::run::SPENT;
use super::verdict::{Verdict, as_declared};
use crate::claim::{Claim, ClaimKind, Comparison, Expected};
use crate::diagnostic::{Diagnostic, Place};
use crate::subject::Subject;
use crate::theorem::TheoremKind;

/// A budget of this size comes near to what a whole file may take.
const LARGEST: u32 = 10;

/// The error for a claim whose verdict is not the declared one; `None` when all is as declared.
pub fn diagnose(subject: &Subject, claim: &Claim, verdict: &Verdict) -> Option<Diagnostic> {
    let mut diagnostic = contradiction(&subject.title(), &claim.text, claim.expected, &claim.place, verdict)?;
    if !subject.order().is_empty() {
        let values: Vec<String> = subject.order().mapped(|(name, value)| format!("{name} = {value}"));
        diagnostic.notes.push(format!("for {}", values.join(", ")));
    }
    if matches!(claim.kind, ClaimKind::Rounding(_)) && matches!(verdict, Verdict::Undecided(_)) {
        return Some(diagnostic.help("claim a larger bound, or leave the claim out; `basis explain` shows the bounds that can be proved"));
    }
    let is_open = matches!(verdict, Verdict::Undecided(_));
    if is_open && matches!(claim.kind, ClaimKind::TotallyPositive) {
        diagnostic = diagnostic.help("narrow the ranges, or leave it open: `conjecture totally_positive;`");
    } else if is_open && subject.budget() >= LARGEST {
        diagnostic = diagnostic.help(
            "narrow the ranges, or state it in parts: what a whole file may take is the same with any budget",
        );
    }
    let Subject::Theorem(theorem) = subject else { return Some(diagnostic) };
    let is_equation = matches!(
        claim.kind,
        ClaimKind::Scalar { comparison: Comparison::Equal, .. } | ClaimKind::Vector { .. }
    );
    if is_open && is_equation && !theorem.relations.is_empty() {
        let help = "an equation between scalars is no assumption: solve it for one of them, `let c = …;`";
        diagnostic = diagnostic.help(help);
    }
    let of_products = theorem.products.iter().any(|(var, _)| claim.kind.depends_on(*var));
    Some(match verdict {
        Verdict::Undecided(_) if of_products => diagnostic.help(match theorem.kind {
            TheoremKind::Theorem => "state it for fewer points, or for points of the plane: `dimension 2;`",
            TheoremKind::Join => {
                "state it for fewer points, or in a `theorem` for points of the plane: `dimension 2;`"
            }
        }),
        _ => diagnostic,
    })
}

fn contradiction(
    title: &str,
    text: &str,
    expected: Expected,
    place: &Place,
    verdict: &Verdict,
) -> Option<Diagnostic> {
    let is_news = expected == Expected::Open && matches!(verdict, Verdict::Proved(_));
    if as_declared(expected, verdict) && !is_news {
        return None;
    }
    Some(match verdict {
        Verdict::Refuted(witness) => {
            let what = if expected == Expected::Open { "conjecture" } else { "claim" };
            let message = format!("{title}: the {what} `{text}` is false");
            let mut d = Diagnostic::error(place.clone(), message).label("refuted");
            d.notes.clone_from(&witness.notes);
            d.help("correct the formulas or the claim; `refute` declares a claim false")
        }
        Verdict::Proved(evidence) if expected == Expected::Open => {
            let message = format!("{title}: the conjecture `{text}` is true");
            let d = Diagnostic::error(place.clone(), message).label("proved").warning();
            d.note(format!("proved by {}", evidence.method())).help("write `prove`")
        }
        Verdict::Proved(evidence) => {
            let message = format!("{title}: the claim `{text}` is declared false, but it is true");
            Diagnostic::error(place.clone(), message)
                .label("proved")
                .note(format!("proved by {}", evidence.method()))
                .help("write `prove`")
        }
        Verdict::Undecided(left) => {
            let verb = if expected == Expected::True { "proved" } else { "refuted" };
            let message = format!("{title}: the claim `{text}` is neither proved nor refuted");
            Diagnostic::error(place.clone(), message)
                .label(format!("declared to be {verb}"))
                .note(left.clone())
                .help(if left == SPENT {
                    "move it to a file of its own"
                } else {
                    "raise the budget, such as `budget 10;`, or narrow the ranges"
                })
        }
    })
}
