//! Stands for the claims of theorems and joins where the feature `joins` is off: there is no value of the type
//! [`Theorem`].

use super::verdict::{Stated, Verdict};
use crate::algebra::rational::Rational;
use crate::claim::Claim;
use crate::theorem::Theorem;

pub(super) fn statements(theorem: &Theorem, _: &Claim, _: &[usize]) -> Option<Vec<Stated>> {
    match theorem.never {}
}

pub(super) fn instances(
    theorem: &Theorem,
    _: &Claim,
    _: &[Vec<Rational>],
) -> Result<Vec<Stated>, &'static str> {
    match theorem.never {}
}

pub(super) fn decide(theorem: &Theorem, _: &Claim) -> Verdict {
    match theorem.never {}
}
