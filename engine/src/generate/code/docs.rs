//! The documentation of a generated type: formulas, ranges, claims with their verdicts.

use crate::algebra::range::DisplayRange as _;
use crate::claim::Claim;
use crate::model::Family;
use crate::state::Verdict;
use basis_prover::collections::list::{Listed, Mapped};

/// The lines of the doc comment; one formula a line.
pub(in crate::generate) fn family(
    family: &Family,
    formulas: &[String],
    verdicts: &[(Claim, Verdict)],
) -> Vec<String> {
    let mut lines = family.doc.clone();
    if lines.is_empty() {
        lines.push(format!("The family of basis functions `{}`.", family.title()));
    }
    if !family.order.is_empty() {
        let values: Vec<String> = family.order.mapped(|(n, v)| format!("{n} = {v}"));
        lines.extend([String::new(), format!("Generated for {}.", values.join(", "))]);
    }
    lines.extend(["", "# Functions", "", "```text"].map(String::from));
    lines.extend(formulas.iter().cloned());
    lines.push(String::from("```"));
    lines.push(String::new());
    let mut ranges: Vec<String> = Vec::new();
    if family.is_simplex() {
        let names: Vec<&str> = family.domain_variables().map(|p| p.name.as_str()).listed();
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
            lines.push(row(&claim.text, verdict));
        }
    }
    lines
}

/// A row of the table of claims.
pub(in crate::generate) fn row(claim: &str, verdict: &Verdict) -> String {
    let verdict = match verdict {
        Verdict::Proved(evidence) => format!("proved by {}", evidence.method()),
        Verdict::Refuted(witness) => {
            let point = witness.point();
            let place = if point.is_empty() { String::new() } else { format!(" at {point}") };
            format!("refuted: `{}` is {}{place}", witness.of, witness.value)
        }
        Verdict::Undecided(left) => format!("undecided: {left}"),
    };
    format!("| `{}` | {} |", claim.replace('|', "\\|"), verdict.replace('|', "\\|"))
}
