//! Scalars that are related to one another: their values are the images of boxes, and a claim is decided on each of these.

use basis_kernel::Statement;
use basis_prover::collections::list::Listed;

use crate::algebra::fraction::Fraction;
use crate::claim::{Claim, ClaimKind, Difference, Side};
use crate::model::chart::Piece;
use crate::state::verdict::Stated;
use crate::theorem::{Form, Theorem};

/// A theorem and one of its claims on a part of the values of the scalars.
pub(super) struct Part {
    pub(super) theorem: Theorem,
    pub(super) claim: Claim,
}

/// The parts of a claim; `None` where one of its values has too many terms in the variables of a box.
pub(super) fn parts(theorem: &Theorem, claim: &Claim) -> Option<Vec<Part>> {
    theorem.parts.iter().map(|piece| part(theorem, claim, piece)).collect()
}

fn part(theorem: &Theorem, claim: &Claim, piece: &Piece) -> Option<Part> {
    let mut own = theorem.clone();
    for scalar in &mut own.scalars {
        if let Some((_, range)) = piece.ranges.iter().find(|(var, _)| *var == scalar.var) {
            scalar.range = range.clone();
        }
    }
    own.relations = Vec::new();
    own.parts = Vec::new();
    own.part = piece.clone();
    let put = |f: &Fraction| {
        let quotient = piece.pull_back_fraction(f)?;
        Fraction::new(quotient.numerator, quotient.denominator)
    };
    let kind = mapped(&claim.kind, &put)?;
    Some(Part { theorem: own, claim: Claim { kind, ..claim.clone() } })
}

/// What is claimed, with other values in place of all scalars.
fn mapped(kind: &ClaimKind, put: &dyn Fn(&Fraction) -> Option<Fraction>) -> Option<ClaimKind> {
    let form = |form: &Form| form.map(&mut |f| put(f).ok_or(())).ok();
    let side = |side: &Side| Some(Side { text: side.text.clone(), value: form(&side.value)? });
    Some(match kind {
        ClaimKind::Scalar { comparison, difference } => ClaimKind::Scalar {
            comparison: *comparison,
            difference: Difference { value: put(&difference.value)?, ..difference.clone() },
        },
        ClaimKind::Vector { text, value } => ClaimKind::Vector { text: text.clone(), value: form(value)? },
        ClaimKind::Parallel { left, right } => ClaimKind::Parallel { left: side(left)?, right: side(right)? },
        other => other.clone(),
    })
}

/// What is claimed, with a number in place of every scalar whose range is a single number.
pub(super) fn settled(theorem: &Theorem, kind: &ClaimKind) -> ClaimKind {
    let single = theorem.scalars.iter().any(|p| p.range.finite().is_some_and(|(low, high)| low == high));
    if !single {
        return kind.clone();
    }
    let put = |f: &Fraction| {
        theorem.scalars.iter().fold(f.clone(), |f, scalar| match scalar.range.finite() {
            // No denominator vanishes on the ranges.
            Some((low, high)) if low == high => {
                f.substitute(scalar.var, &Fraction::constant(low.clone())).unwrap_or(f)
            }
            _ => f,
        })
    };
    mapped(kind, &|f| Some(put(f))).unwrap_or_else(|| kind.clone())
}

/// Statements by what is enough for them without premises, where that is found by the way `away` from these.
pub(super) fn enough(
    stated: Vec<Stated>,
    away: &mut dyn FnMut(&Statement) -> Option<Vec<Statement>>,
) -> Vec<Stated> {
    let one = |stated: Stated| match away(&stated.statement) {
        Some(all) => all.into_iter().map(|s| Stated::new(stated.of.clone(), s)).listed(),
        None => vec![stated],
    };
    stated.into_iter().flat_map(one).listed()
}

/// Whether premises are left that are no part of a box.
pub(super) fn has_premises(stated: &Stated) -> bool {
    match &stated.statement {
        Statement::Sign { domain, .. }
        | Statement::Zero { domain, .. }
        | Statement::Products { domain, .. } => !domain.premises.is_empty(),
        Statement::Independent { .. } => false,
    }
}
