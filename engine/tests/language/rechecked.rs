//! The verdicts of a run, each checked once more.

use crate::support::recheck;
use basis_engine::{Report, Verdict};

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
