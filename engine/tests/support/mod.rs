//! Checks verdicts once more, by the texts of their certificates.

use std::rc::Rc;

use basis_engine::algebra::work::Work;
use basis_engine::{Claim, Subject, Verdict, Witness, state};
use basis_kernel::{self as kernel, Proof, Refutation, Statement, text};

/// Whether a verdict is about the statements that the claim makes, and its certificates can be written, read and
/// checked again.
pub(crate) fn recheck(subject: &Subject, claim: &Claim, verdict: &Verdict) -> Result<(), String> {
    let work = &mut Work::usual(subject.budget());
    match verdict {
        Verdict::Proved(evidence) => {
            let stated = state::statements(subject, claim, evidence.ways()).ok_or("it cannot be expanded")?;
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
            let statement = match (stated, witness.everywhere()) {
                (Some(stated), None) => stated.statement,
                (None, Some(proof)) => beside(subject, claim, witness, proof, work)?,
                _ => return Err(String::from("the claim says nothing of what is refuted")),
            };
            let written = text::witness_text(witness.refutation().witness());
            let read = text::witness(&written).map_err(|e| format!("{written}: {e}"))?;
            let refutation = Refutation::new(Rc::new(statement), read, work);
            refutation.map(|_| ()).map_err(|e| format!("{written}: {e}"))
        }
        Verdict::Undecided(_) => Ok(()),
    }
}

/// What a claim says at the point of a witness, whatever π and the like are between their bounds: that it fails for all of them
/// is checked again.
fn beside(
    subject: &Subject,
    claim: &Claim,
    witness: &Witness,
    proof: &Proof,
    work: &mut Work,
) -> Result<Statement, String> {
    let kernel::Witness::At(point) = witness.refutation().witness() else {
        return Err(String::from("it is no point"));
    };
    let point: Vec<_> = point.coordinates.iter().map(|(var, x)| (*var, x.leading())).collect();
    let found = state::at_point(subject, claim, witness.of_statement(), &point);
    let [statement, negation] = found.ok_or("the claim says nothing at the point")?;
    let written = text::certificate_text(proof.certificate());
    let read = text::certificate(&written).map_err(|e| format!("{written}: {e}"))?;
    Proof::new(Rc::new(negation), read, work).map_err(|e| format!("{written}: {e}"))?;
    Ok(statement)
}
