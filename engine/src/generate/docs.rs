//! The documentation of a generated type: formulas, ranges, claims with their verdicts.

use super::form::IntervalForm;
use super::formula::factored;
use crate::model::{Claim, Family};
use crate::prove::Verdict;

/// The lines of the doc comment.
pub(super) fn family(family: &Family, form: &IntervalForm, verdicts: &[(Claim, Verdict)]) -> Vec<String> {
    let mut lines = family.doc.clone();
    if lines.is_empty() {
        lines.push(format!("The family of basis functions `{}`.", family.title()));
    }
    if !family.order.is_empty() {
        let values: Vec<String> = family.order.iter().map(|(n, v)| format!("{n} = {v}")).collect();
        lines.extend([String::new(), format!("Generated for {}.", values.join(", "))]);
    }
    lines.extend(["", "# Functions", "", "```text"].map(String::from));
    for (k, function) in form.functions.iter().enumerate() {
        let formula = factored(family, form, function);
        lines.push(format!("{} = {formula}", family.function_label(k)));
    }
    lines.push(String::from("```"));
    lines.push(String::new());
    let ranges: Vec<String> = family
        .domain
        .iter()
        .chain(&family.shapes)
        .map(|p| format!("`{}`", p.range.display(&p.name)))
        .collect();
    lines.push(format!("for {}.", ranges.join(", ")));
    if !verdicts.is_empty() {
        lines.extend(
            ["", "# Claims", "", "Decided exactly, while this crate was compiled.", ""].map(String::from),
        );
        lines.push(String::from("| claim | verdict |"));
        lines.push(String::from("| --- | --- |"));
        for (claim, verdict) in verdicts {
            let verdict = match verdict {
                Verdict::Proved(evidence) => format!("proved by {}", evidence.method),
                Verdict::Refuted(witness) => {
                    format!("refuted: `{}` is {} at {}", witness.of, witness.value, witness.point())
                }
                Verdict::Undecided(left) => format!("undecided: {left}"),
            };
            lines.push(format!("| `{}` | {} |", claim.text.replace('|', "\\|"), verdict.replace('|', "\\|")));
        }
    }
    lines
}
