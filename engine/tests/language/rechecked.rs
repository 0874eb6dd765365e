//! The verdicts of a run, each checked once more.

use crate::support::recheck;
use basis_engine::{Report, Source, Verdict, check};

/// The verdicts on all claims in their order; all of them check out again from the texts of their certificates.
pub(crate) fn rechecked(report: &Report) -> Vec<&Verdict> {
    let mut all = Vec::new();
    for item in &report.items {
        for (claim, verdict) in &item.claims {
            assert_eq!(recheck(&item.subject, claim, verdict), Ok(()), "{}", claim.text);
            all.push(verdict);
        }
    }
    all
}

/// Every claim of a spec is found to be as it is declared, and checks out again from the text of its certificate; the
/// counterexamples.
pub(crate) fn counterexamples(spec: &str) -> Vec<String> {
    let report = check(Source::text("claims.basis", spec));
    assert!(report.diagnostics.is_empty(), "{:?}", report.diagnostics);
    let mut all = Vec::new();
    for verdict in rechecked(&report) {
        if let Verdict::Refuted(witness) = verdict {
            all.push(format!("{} at {}", witness.value_text(), witness.point()));
        }
    }
    all
}
