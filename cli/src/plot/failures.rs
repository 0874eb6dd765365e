//! Points at which claims fail.

use basis_engine::algebra::rational::{self, Rational};
use basis_engine::model::Parameter;
use basis_engine::state::as_declared;
use basis_engine::{Checked, Family, Verdict, Witness};

/// A claim that is not as declared, with the point at which it fails.
#[derive(Clone, Debug)]
pub(super) struct Failure {
    /// The shape values there, by variable.
    pub(super) shapes: Vec<Rational>,
    /// The domain variables there; nothing for those on which it does not depend.
    pub(super) at: Vec<Option<Rational>>,
    /// The function that it is about, if it is one.
    pub(super) function: Option<usize>,
    /// What fails there, in words.
    pub(super) text: String,
}

/// The counterexamples of a family to claims that it declares true.
pub(super) fn failures(family: &Family, checked: &Checked) -> Vec<Failure> {
    let mut all = Vec::new();
    for (claim, verdict) in &checked.claims {
        let Verdict::Refuted(witness) = verdict else { continue };
        if as_declared(claim.expected, verdict) {
            continue;
        }
        let value = |p: &Parameter| coordinate(witness, &p.name);
        let Some(shapes) = family.shapes.iter().map(value).collect::<Option<Vec<_>>>() else { continue };
        let function = (0..family.functions.len()).find(|k| family.function_label(*k) == witness.of);
        let text = format!("{}: {}", claim.text, witness.notes.join("; ").replace('`', ""));
        all.push(Failure { shapes, at: family.domain.iter().map(value).collect(), function, text });
    }
    all
}

/// A rational coordinate of a counterexample.
fn coordinate(witness: &Witness, name: &str) -> Option<Rational> {
    if witness.idle.iter().any(|idle| idle == name) {
        return None;
    }
    let (_, coordinate) = witness.at.iter().find(|(known, _)| known == name)?;
    rational::parse(&coordinate.value(name))
}
