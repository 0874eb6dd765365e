//! Claims of one statement together: an `at` block or a `for` makes many, and every order makes them again.

use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::sort::sort_by;

use super::verdict::Verdict;
use crate::claim::{Claim, ClaimKind, Expected};

/// The most claims of one statement in one order that are shown one by one.
pub const FEW: usize = 8;

/// A verdict seen beside what is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Standing {
    /// Proved, as declared.
    Proved,
    /// Refuted, as declared.
    Refuted,
    /// Refuted, but declared true.
    False,
    /// Proved, but declared false.
    True,
    /// Neither proved nor refuted.
    Undecided,
    /// Neither, as a conjecture may be.
    Open,
}

impl Standing {
    /// The verdict on a claim beside its declaration.
    pub const fn of(claim: &Claim, verdict: &Verdict) -> Self {
        match (claim.expected, verdict) {
            (Expected::Open, Verdict::Undecided(_)) => Self::Open,
            (Expected::True | Expected::Open, Verdict::Proved(_)) => Self::Proved,
            (Expected::False, Verdict::Refuted(_)) => Self::Refuted,
            (Expected::True | Expected::Open, Verdict::Refuted(_)) => Self::False,
            (Expected::False, Verdict::Proved(_)) => Self::True,
            (Expected::True | Expected::False, Verdict::Undecided(_)) => Self::Undecided,
        }
    }
}

/// The claims of one statement that stand alike.
#[derive(Clone, Debug)]
pub struct Part {
    /// How they stand.
    pub standing: Standing,
    /// The text that all claims of the statement share, or else the statement as it is written.
    pub text: String,
    /// What the index variables of the text run over, such as `for i in 0..=n`, if the text does not say so itself.
    pub range: String,
    /// The positions of the claims in the list that was divided.
    pub claims: Vec<usize>,
}

/// Divides the claims of an item, in one or in all of its orders, by statement in the order of the file, and those of a
/// statement by how they stand.
pub fn parts(claims: &[(&Claim, &Verdict)]) -> Vec<Part> {
    let keys = claims.mapped(|(claim, verdict)| (claim.statement.number, Standing::of(claim, verdict)));
    let mut positions: Vec<usize> = (0..claims.len()).listed();
    sort_by(&mut positions, |a, b| keys[*a].cmp(&keys[*b]));
    let mut parts = Vec::new();
    for statement in positions.chunk_by(|a, b| keys[*a].0 == keys[*b].0) {
        let (text, range) = common_text(&statement.mapped(|k| claims[*k].0));
        for alike in statement.chunk_by(|a, b| keys[*a].1 == keys[*b].1) {
            let standing = keys[alike[0]].1;
            parts.push(Part { standing, text: text.clone(), range: range.clone(), claims: alike.to_vec() });
        }
    }
    parts
}

/// The text that the claims of a statement share, or else the statement as it is written, and its range.
fn common_text(claims: &[&Claim]) -> (String, String) {
    let Some(first) = claims.first() else { return Default::default() };
    if claims.iter().all(|claim| claim.text == first.text) {
        return (first.text.clone(), String::new());
    }
    // An equation in an `at` block stands alone in the file.
    let at = |claim: &Claim| match &claim.kind {
        ClaimKind::Relation { at, .. } => at.clone(),
        _ => None,
    };
    let written = &first.statement.text;
    let text = match at(first) {
        Some(point) if claims.iter().all(|claim| at(claim).as_ref() == Some(&point)) => {
            format!("at {point}: {written}")
        }
        Some(_) => format!("at …: {written}"),
        None => written.to_string(),
    };
    (text, first.statement.range.to_string())
}
