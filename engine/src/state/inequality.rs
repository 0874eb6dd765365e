//! Comparisons with zero: what they say of a value, and of which points.

use basis_prover::collections::list::Listed;
use std::rc::Rc;

use basis_kernel::{Domain, Relation, Simplex, Statement};

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::claim::Comparison;
use crate::model::chart::Piece;
use crate::model::{Family, Parameter};

/// What a comparison of x with zero says: of x, or if it is `negated` of −x.
pub(super) struct Said {
    pub(super) relation: Relation,
    pub(super) negated: bool,
}

/// What a comparison with zero says; `None` for equations.
pub(super) const fn said(comparison: Comparison) -> Option<Said> {
    let (relation, negated) = match comparison {
        Comparison::Equal | Comparison::NotEqual => return None,
        Comparison::Greater => (Relation::Positive, false),
        Comparison::GreaterEqual => (Relation::NonNegative, false),
        Comparison::Less => (Relation::Positive, true),
        Comparison::LessEqual => (Relation::NonNegative, true),
    };
    Some(Said { relation, negated })
}

/// Whether a comparison says something of −x rather than of x.
pub(super) fn is_negated(comparison: Comparison) -> bool {
    said(comparison).is_some_and(|said| said.negated)
}

/// The statement that a value compares with zero as stated, at all points of a domain.
pub(super) fn compared(value: &Fraction, comparison: Comparison, domain: &Rc<Domain>) -> Statement {
    let domain = Rc::clone(domain);
    match said(comparison) {
        None => Statement::Zero { value: value.quotient(), domain },
        Some(Said { relation, negated }) => {
            let value = if negated { (-value).quotient() } else { value.quotient() };
            Statement::Sign { value, relation, domain }
        }
    }
}

/// A value, in the variables of a part of the points, compares with zero as stated on that part; `None` when it has too
/// many terms in them.
pub(super) fn compared_on(
    value: &Fraction,
    comparison: Comparison,
    (piece, domain): &(Piece, Rc<Domain>),
) -> Option<Statement> {
    if piece.steps.is_empty() {
        return Some(compared(value, comparison, domain));
    }
    let domain = Rc::clone(domain);
    let value = if is_negated(comparison) { -value } else { value.clone() };
    let value = piece.pull_back_fraction(&value)?;
    Some(match said(comparison) {
        None => Statement::Zero { value, domain },
        Some(Said { relation, .. }) => Statement::Sign { value, relation, domain },
    })
}

/// The points that a claim is about, in parts: the values of the shape parameters and the domain, without the variables
/// that an `at` block fixes.
pub(crate) fn parts(family: &Family, fixed: &[(Var, Fraction)]) -> Vec<(Piece, Rc<Domain>)> {
    let whole = |piece: Piece| with_simplices(family, fixed, piece);
    family.pieces(fixed, &[], false).into_iter().map(whole).listed()
}

/// The same as one box, of whose points those count that satisfy the conditions on shape parameters as these are written.
pub(super) fn as_written(family: &Family, fixed: &[(Var, Fraction)]) -> Vec<(Piece, Rc<Domain>)> {
    vec![with_simplices(family, fixed, family.box_as_written(fixed))]
}

/// A part of the points, with the simplices of the domain.
fn with_simplices(family: &Family, fixed: &[(Var, Fraction)], piece: Piece) -> (Piece, Rc<Domain>) {
    let mut domain = piece.domain();
    let own = family.simplices.iter().filter_map(|s| simplex(&family.domain[s.places.clone()], fixed));
    domain.simplices.extend(own);
    (piece, Rc::new(domain))
}

/// What of a simplex is left when some coordinates are fixed.
fn simplex(own: &[Parameter], fixed: &[(Var, Fraction)]) -> Option<Simplex> {
    let free = |v: &Var| fixed.iter().all(|(f, _)| f != v);
    let variables: Vec<Var> = own.iter().map(|p| p.var).filter(free).listed();
    (!variables.is_empty()).then(|| Simplex { variables, sum: left_on_simplex(own, fixed) })
}

/// What fixed barycentric coordinates leave of 1 for the others; 1 where nothing is fixed.
///
/// A fixed last coordinate stands among the fixed ones as another coordinate that it expresses.
fn left_on_simplex(own: &[Parameter], fixed: &[(Var, Fraction)]) -> Rational {
    let mut left = Rational::ONE;
    let mut sum = Fraction::zero();
    let mut expressed = false;
    for parameter in own {
        let value = fixed.iter().find(|(v, _)| *v == parameter.var).map(|(_, f)| f);
        match value.map(|f| (f, f.as_constant())) {
            Some((_, Some(c))) => left -= &c,
            Some(_) => expressed = true,
            None => {}
        }
        sum = &sum + &value.cloned().unwrap_or_else(|| Fraction::var(parameter.var));
    }
    match sum.as_constant() {
        // The sum is 1 minus the last coordinate.
        Some(sum) if expressed => &left - &(&Rational::ONE - &sum),
        _ => left,
    }
}
