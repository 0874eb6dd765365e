//! Stands for claims in which a variable stands beside its sine or exponential where the feature `angles` is off: no family
//! has any.

use std::rc::Rc;

use basis_kernel::{Domain, Proof, Statement};
use basis_prover::{Coordinate, Counterexample};

use super::{ByWays, Enough, Said, Saying, Where};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Region;
use crate::algebra::rational::Rational;
use crate::claim::{Claim, Comparison};
use crate::model::Family;
use crate::model::chart::Piece;

pub(super) fn enough(
    _: &Family,
    _: (&str, &Fraction, Comparison),
    _: &(Piece, Rc<Domain>),
    _: &mut Option<()>,
    _: &mut Saying<'_>,
) -> Enough {
    Enough::Itself
}

pub(super) fn at_point(
    _: &Family,
    _: &Family,
    _: &Statement,
    _: &[(Var, Rational)],
) -> Option<[Statement; 2]> {
    None
}

pub(super) type Whatever = (Counterexample, Proof);

pub(super) fn refuted(_: &Family, _: &Claim, _: Vec<Said>, _: bool, _: Where) -> Option<(Said, Whatever)> {
    None
}

pub(super) fn refuted_whatever(
    _: &Family,
    _: &Claim,
    _: &Statement,
    _: &[(Var, Rational)],
) -> Option<Whatever> {
    None
}

pub(super) fn proved_at_once(_: &Family, _: &Claim) -> Option<ByWays> {
    None
}

pub(super) fn wider(_: &Family) -> Option<Family> {
    None
}

pub(super) fn rows_between_bounds(
    _: &Family,
    _: &[Vec<Poly>],
    _: &Region,
) -> Option<(Vec<Vec<Poly>>, Region)> {
    None
}

pub(super) fn genuine(_: &Family, found: Counterexample) -> Counterexample {
    found
}

pub(super) fn shown(
    _: &Family,
    _: &Family,
    _: &Counterexample,
    _: (&Rational, bool),
    _: Option<&Fraction>,
) -> Option<String> {
    None
}

pub(super) fn about_number(_: &Family, _: &Fraction, value: &Rational) -> Rational {
    value.clone()
}

pub(super) fn about(_: &Family, _: &Family, _: &[(Var, Rational)]) -> Vec<(String, Rational)> {
    Vec::new()
}

pub(super) fn value_at(_: &Family, found: &Counterexample, f: &Fraction) -> Option<Coordinate> {
    found.evaluate(&f.quotient())
}

pub(super) fn name_angles(
    _: &Family,
    _: &Counterexample,
    _: &[(Var, Fraction)],
    _: &mut [(String, Coordinate)],
) {
}

pub(super) fn places(
    _: &Family,
    _: &[(Var, Fraction)],
    _: &[(String, Coordinate)],
    _: &[(Var, Coordinate)],
) -> Vec<(String, String)> {
    Vec::new()
}
