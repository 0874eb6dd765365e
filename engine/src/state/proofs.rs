//! Several statements decided together.

use basis_kernel::Proof;
use basis_prover::collections::list::Listed;
use basis_prover::{Failure, Shown, decide, within};

use super::verdict::Stated;

/// The work for a first look at each of several statements, so that a hard one leaves something for the easy ones.
const FIRST_LOOK: u64 = 60_000;

/// Proofs of all of some statements with the methods that they needed; or the first that is not proved, and what is
/// known about it, one that is refuted before one that is undecided.
pub(super) fn all(stated: Vec<Stated>, budget: u32) -> Result<Vec<(String, Shown)>, (String, Failure)> {
    let several = stated.len() > 1;
    let mut proofs: Vec<Option<(String, Shown)>> = Vec::new();
    let mut hard = Vec::new();
    for (k, Stated { of, statement, symmetries, .. }) in stated.into_iter().enumerate() {
        let mut first = || decide(statement.clone(), &symmetries, budget);
        proofs.push(None);
        match if several { within(FIRST_LOOK, &mut first) } else { first() } {
            Ok(shown) => proofs[k] = Some((of, shown)),
            Err(refuted @ Failure::Refuted(_)) => return Err((of, refuted)),
            Err(_) if several => hard.push((k, of, statement, symmetries)),
            Err(left) => return Err((of, left)),
        }
    }
    let mut undecided = None;
    for (k, of, statement, symmetries) in hard {
        match decide(statement, &symmetries, budget) {
            Ok(shown) => proofs[k] = Some((of, shown)),
            Err(refuted @ Failure::Refuted(_)) => return Err((of, refuted)),
            Err(left) => undecided = undecided.or(Some((of, left))),
        }
    }
    undecided.map_or_else(|| Ok(proofs.into_iter().flatten().listed()), Err)
}

/// The proofs without the methods.
pub(super) fn steps(shown: Vec<(String, Shown)>) -> Vec<(String, Proof)> {
    shown.into_iter().map(|(of, shown)| (of, shown.proof)).listed()
}
