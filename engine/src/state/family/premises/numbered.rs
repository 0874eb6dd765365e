//! Ways from what is assumed to statements that are enough, by their numbers: the first one, the one that is given, and the first one
//! that leads to a proof.

use basis_kernel::{Domain, Relation, Statement};
use basis_prover::{Proof, Symmetries, decide, within};
use std::rc::Rc;

use super::ways;
use crate::algebra::poly::Poly;

/// Ways after the first one that are tried, at most.
const MAX_TRIED: usize = 16;

/// The work for one of them.
const TRIED: u64 = 4_000_000;

/// The number of the first way; those of the others follow.
const AWAY: usize = 100;

/// The number of the first way to an equation by a square.
const BY_SQUARE: usize = 200;

/// The number of the way to an equation by two inequalities, of which the numbers follow.
const BY_BOTH: usize = 300;

/// Whether a statement about a sign has premises: then the way away from them has a number.
pub(in crate::state) fn is_assumed(statement: &Statement) -> bool {
    matches!(statement, Statement::Sign { domain, .. } if !domain.premises.is_empty())
}

/// What is enough for a statement about a sign to hold where its premises do, by the first way; `None` if it does not need
/// them, or seems to be false, or no multiple of a premise is found to help.
pub(in crate::state) fn without(statement: &Statement) -> Option<Vec<Statement>> {
    by(statement, 0)
}

/// The same by the way with a number.
pub(in crate::state) fn by(statement: &Statement, way: usize) -> Option<Vec<Statement>> {
    if way > MAX_TRIED {
        return None;
    }
    let mut found = None;
    ways(statement, &mut |number, enough| {
        if number == way {
            found = Some(enough);
        }
        number >= way
    });
    found
}

/// Whether these are the numbers of first ways alone.
pub(in crate::state) fn are_first(numbers: &[usize]) -> bool {
    numbers.iter().all(|number| *number == AWAY)
}

/// The same, and the number of the way is noted.
pub(in crate::state) fn by_first(statement: &Statement, noted: &mut Vec<usize>) -> Option<Vec<Statement>> {
    if is_assumed(statement) {
        noted.push(AWAY);
    }
    without(statement)
}

/// The same by the way that is the next one of some, if these have numbers of ways.
pub(in crate::state) fn by_next(
    statement: &Statement,
    given: &mut core::slice::Iter<'_, usize>,
) -> Option<Vec<Statement>> {
    let next = given.as_slice().first().copied();
    if let (Some(number @ BY_SQUARE..), Some(square)) = (next, no_square(statement)) {
        given.next();
        return match number.checked_sub(BY_BOTH) {
            None => by(&square, number - BY_SQUARE),
            Some(0) => {
                let [above, below] = both(statement)?.map(|sign| by_next(&sign, given));
                Some([above?, below?].concat())
            }
            Some(_) => None,
        };
    }
    let next = next.and_then(|number| number.checked_sub(AWAY));
    let Some(way) = next.filter(|_| is_assumed(statement)) else { return without(statement) };
    given.next();
    by(statement, way)
}

/// The same by the first way that leads to a proof, of which the number is noted; where none does, by the first of all.
pub(in crate::state) fn tried(statement: &Statement, noted: &mut Vec<usize>) -> Option<Vec<Statement>> {
    if let Some(square) = no_square(statement) {
        if let (_, Some((number, enough))) = first_proved(&square) {
            noted.push(BY_SQUARE + number);
            return Some(enough);
        }
        let [above, below] = both(statement)?.map(|sign| first_proved(&sign).1);
        let ((first, above), (second, below)) = (above?, below?);
        noted.extend([BY_BOTH, AWAY + first, AWAY + second]);
        return Some([above, below].concat());
    }
    let (first, found) = first_proved(statement);
    if is_assumed(statement) {
        noted.push(AWAY + found.as_ref().map_or(0, |(number, _)| *number));
    }
    found.map_or(first, |(_, enough)| Some(enough))
}

/// Statements that are enough, with the number of the way to them.
type Numbered = (usize, Vec<Statement>);

/// What is enough by the first way of all, and by the first one that leads to a proof, with its number.
fn first_proved(statement: &Statement) -> (Option<Vec<Statement>>, Option<Numbered>) {
    let is_proved = |s: &Statement| decide(s.clone(), &Symmetries::new(), 1).is_ok();
    let (mut first, mut found) = (None, None);
    ways(statement, &mut |number, enough| {
        if within(TRIED, &mut || enough.iter().all(is_proved)) {
            found = Some((number, enough));
            return true;
        }
        if number == 0 {
            first = Some(enough);
        }
        number == MAX_TRIED
    });
    (first, found)
}

/// Of an equation under premises: that the square of what is 0 is not positive.
pub(super) fn no_square(statement: &Statement) -> Option<Statement> {
    let (value, domain) = equation(statement)?;
    Some(nonnegative(-&value.pow(2), domain))
}

/// Of an equation under premises: that what is 0 is not negative, and not positive.
fn both(statement: &Statement) -> Option<[Statement; 2]> {
    let (value, domain) = equation(statement)?;
    Some([value.clone(), -value].map(|value| nonnegative(value, domain)))
}

/// What is 0 where premises hold; a denominator is 0 nowhere.
fn equation(statement: &Statement) -> Option<(&Poly, &Rc<Domain>)> {
    match statement {
        Statement::Zero { value, domain } if !domain.premises.is_empty() => Some((&value.numerator, domain)),
        _ => None,
    }
}

fn nonnegative(value: Poly, domain: &Rc<Domain>) -> Statement {
    Statement::Sign { value: value.into(), relation: Relation::NonNegative, domain: Rc::clone(domain) }
}

/// The first way that leads to proofs, with these.
pub(crate) fn proved(statement: &Statement, budget: u32) -> Option<(usize, Vec<Proof>)> {
    let mut found = None;
    ways(statement, &mut |number, enough| {
        let proof =
            |s: &Statement| decide(s.clone(), &Symmetries::new(), budget).ok().map(|shown| shown.proof);
        let proofs = within(TRIED, &mut || enough.iter().map(proof).collect::<Option<Vec<Proof>>>());
        found = proofs.map(|proofs| (number, proofs));
        found.is_some() || number == MAX_TRIED
    });
    found
}
