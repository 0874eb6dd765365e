//! The documentation of a generated type: formulas, ranges, claims with their verdicts.

use crate::claim::Claim;
use crate::model::{Factor, Family};
use crate::plural::count;
use crate::state::{FEW, Verdict, parts};
use basis_prover::collections::list::{Listed, Mapped};

/// The lines of the doc comment; one formula a line. `decided` says when the claims were decided.
pub(in crate::generate) fn family(
    family: &Family,
    formulas: &[String],
    rounding: &[String],
    verdicts: &[(Claim, Verdict)],
    decided: &str,
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
    if !family.written.is_empty() {
        lines.extend(family.written.iter().cloned());
        lines.extend((!formulas.is_empty()).then(String::new));
    }
    lines.extend(formulas.iter().cloned());
    lines.push(String::from("```"));
    lines.push(String::new());
    let mut ranges: Vec<String> = Vec::new();
    ranges.extend(family.factors().mapped(|factor| match factor {
        Factor::Simplex(..) => {
            let names: Vec<&str> = factor.variables().map(|p| p.name.as_str()).listed();
            format!("`{} = 1`, all ≥ 0", names.join(" + "))
        }
        Factor::Interval(p) => format!("`{}`", family.declared(p)),
    }));
    ranges.extend(family.shapes.iter().map(|p| format!("`{}`", family.declared(p))));
    ranges.extend(family.assumed().map(|c| format!("`{}`", c.text)));
    lines.push(format!("for {}.", ranges.join(", ")));
    lines.extend(rounding.iter().cloned());
    if !verdicts.is_empty() {
        lines.extend(claims(verdicts, decided));
    }
    lines
}

/// The table of claims with its heading. Many claims of one statement that stand alike share a row.
pub(in crate::generate) fn claims(verdicts: &[(Claim, Verdict)], decided: &str) -> Vec<String> {
    let mut lines = ["", "# Claims", ""].map(String::from).to_vec();
    lines.extend([format!("Decided exactly, {decided}."), String::new()]);
    lines.extend(["| claim | verdict |", "| --- | --- |"].map(String::from));
    for part in parts(&verdicts.mapped(|(claim, verdict)| (claim, verdict))) {
        if part.claims.len() > FEW {
            let alike = part.claims.mapped(|k| &verdicts[*k].1);
            let many = format!(" ({})", count(alike.len(), "claim"));
            let text = format!("{} {}", part.text, part.range);
            lines.push(row(text.trim_end(), &many, &reasons(&alike)));
        } else {
            let alike = part.claims.iter().map(|k| &verdicts[*k]);
            lines.extend(alike.map(|(claim, verdict)| row(&claim.text, "", &reasons(&[verdict]))));
        }
    }
    lines
}

fn row(claim: &str, many: &str, verdict: &str) -> String {
    format!("| `{}`{many} | {} |", claim.replace('|', "\\|"), verdict.replace('|', "\\|"))
}

/// Verdicts of one kind in words: the methods of all proofs; of other verdicts the first.
fn reasons(alike: &[&Verdict]) -> String {
    let mut all: Vec<String> = Vec::new();
    for verdict in alike {
        let reason = match verdict {
            Verdict::Proved(evidence) => evidence.method().to_string(),
            Verdict::Refuted(witness) => {
                let point = witness.point();
                let place = if point.is_empty() { String::new() } else { format!(" at {point}") };
                format!("refuted: `{}` is {}{place}", witness.of, witness.value_text())
            }
            Verdict::Undecided(left) => format!("open: {left}"), // of a conjecture; others stop the build
        };
        if !all.contains(&reason) {
            all.push(reason);
        }
    }
    match (alike, all.as_slice()) {
        ([Verdict::Proved(_), ..], _) => format!("proved by {}", all.join("; ")),
        (_, [first, _, ..]) => format!("{first}, …"),
        _ => all.concat(),
    }
}
