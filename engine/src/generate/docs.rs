//! The documentation of a generated type: formulas, ranges, claims with their verdicts.

use crate::model::{Claim, Family};
use crate::prove::Verdict;

/// The lines of the doc comment; one formula a line.
pub(super) fn family(family: &Family, formulas: &[String], verdicts: &[(Claim, Verdict)]) -> Vec<String> {
    let mut lines = family.doc.clone();
    if lines.is_empty() {
        lines.push(format!("The family of basis functions `{}`.", family.title()));
    }
    if !family.order.is_empty() {
        let values: Vec<String> = family.order.iter().map(|(n, v)| format!("{n} = {v}")).collect();
        lines.extend([String::new(), format!("Generated for {}.", values.join(", "))]);
    }
    lines.extend(["", "# Functions", "", "```text"].map(String::from));
    lines.extend(formulas.iter().cloned());
    lines.push(String::from("```"));
    lines.push(String::new());
    let mut ranges: Vec<String> = Vec::new();
    if family.is_simplex() {
        let names: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).collect();
        ranges.push(format!("`{} = 1`, all ≥ 0", names.join(" + ")));
    } else {
        ranges.extend(family.domain.iter().map(|p| format!("`{}`", p.range.display(&p.name))));
    }
    ranges.extend(family.shapes.iter().map(|p| format!("`{}`", p.range.display(&p.name))));
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
