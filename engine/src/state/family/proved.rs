//! Verdicts from proofs.

use basis_kernel::Statement;
use basis_prover::{Method, Shown};

use super::by_wronskians;
use super::positivity::{chebyshev, wronskian};
use crate::claim::{Claim, ClaimKind, Comparison};
use crate::model::Family;
use crate::state::proofs::steps;
use crate::state::verdict::{Evidence, Verdict};

/// That a claim is true by the proofs of what is enough for it, to which some ways lead.
pub(super) fn proved(
    family: &Family,
    claim: &Claim,
    shown: Vec<(String, Shown)>,
    ways: Vec<usize>,
) -> Verdict {
    let method = if by_wronskians(&claim.kind, &ways) {
        String::from(wronskian::METHOD)
    } else {
        method(family, &claim.kind, &shown)
    };
    Verdict::Proved(Evidence::new(method, steps(shown)).by(ways))
}

/// How a claim was proved, in a few words.
fn method(family: &Family, kind: &ClaimKind, shown: &[(String, Shown)]) -> String {
    // An equation may follow from an inequality that is assumed.
    let equation = matches!(kind, ClaimKind::Relation { differences, .. }
        if differences.iter().all(|(comparison, _)| *comparison == Comparison::Equal))
        && shown.iter().all(|(_, shown)| matches!(shown.proof.statement(), Statement::Zero { .. }));
    String::from(match kind {
        ClaimKind::PartitionOfUnity => "expansion of the sum",
        ClaimKind::Symmetric => "expansion of the moved functions",
        ClaimKind::Continuity(_) => "expansion of the derivatives at the ends",
        ClaimKind::Smooth(_) => "expansion of the derivatives at the knots",
        ClaimKind::Independent(_) => "minors",
        ClaimKind::TotallyPositive if chebyshev::is_mixed(family) => {
            "zeros at both ends in a Chebyshev space"
        }
        ClaimKind::TotallyPositive => "totally nonnegative conversion to a Bernstein basis",
        _ if equation => "expansion of both sides",
        _ => {
            let hardest = shown.iter().map(|(_, shown)| shown.method).max();
            return hardest.unwrap_or(Method::Constant).to_string();
        }
    })
}
