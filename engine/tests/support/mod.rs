//! Checks verdicts once more, by the texts of their certificates.

use std::rc::Rc;

use basis_engine::algebra::work::Work;
use basis_engine::{Claim, Subject, Verdict, state};
use basis_kernel::{Proof, Refutation, text};

/// Whether a verdict is about the statements that the claim makes, and its certificates can be written, read and
/// checked again.
pub(crate) fn recheck(subject: &Subject, claim: &Claim, verdict: &Verdict) -> Result<(), String> {
    let work = &mut Work::usual(subject.budget());
    match verdict {
        Verdict::Proved(evidence) => {
            let stated = state::statements(subject, claim).ok_or("it cannot be expanded")?;
            if stated.is_empty() || stated.len() != evidence.steps().len() {
                return Err(format!("{} proofs for {} statements", evidence.steps().len(), stated.len()));
            }
            for (stated, (of, proof)) in stated.into_iter().zip(evidence.steps()) {
                if stated.of != *of || stated.statement != *proof.statement() {
                    return Err(format!("`{of}` is another statement"));
                }
                let written = text::certificate_text(proof.certificate());
                let read = text::certificate(&written).map_err(|e| format!("{written}: {e}"))?;
                Proof::new(Rc::new(stated.statement), read, work).map_err(|e| format!("{written}: {e}"))?;
            }
            Ok(())
        }
        Verdict::Refuted(witness) => {
            let instances = state::instances(subject, claim, &witness.given)?;
            let stated = instances.into_iter().find(|stated| stated.of == witness.of_statement());
            let stated = stated.ok_or("the claim says nothing of what is refuted")?;
            let written = text::witness_text(witness.refutation().witness());
            let read = text::witness(&written).map_err(|e| format!("{written}: {e}"))?;
            let refutation = Refutation::new(Rc::new(stated.statement), read, work);
            refutation.map(|_| ()).map_err(|e| format!("{written}: {e}"))
        }
        Verdict::Undecided(_) => Ok(()),
    }
}
