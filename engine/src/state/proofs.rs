//! Several statements decided together.

use basis_kernel::Proof;
use basis_prover::collections::list::Listed;
use basis_prover::{Failure, Shown, decide};

use super::verdict::Stated;

/// Proofs of all of some statements with the methods that they needed; or the first that is not proved, and what is
/// known about it, one that is refuted before one that is undecided.
pub(super) fn all(stated: Vec<Stated>, budget: u32) -> Result<Vec<(String, Shown)>, (String, Failure)> {
    let mut proofs = Vec::new();
    let mut undecided = None;
    for Stated { of, statement, symmetries, .. } in stated {
        match decide(statement, &symmetries, budget) {
            Ok(shown) => proofs.push((of, shown)),
            Err(refuted @ Failure::Refuted(_)) => return Err((of, refuted)),
            Err(left) => undecided = undecided.or(Some((of, left))),
        }
    }
    undecided.map_or(Ok(proofs), Err)
}

/// The proofs without the methods.
pub(super) fn steps(shown: Vec<(String, Shown)>) -> Vec<(String, Proof)> {
    shown.into_iter().map(|(of, shown)| (of, shown.proof)).listed()
}
