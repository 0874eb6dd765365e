//! Stands for the ends of domains in an angle where the feature `angles` is off: there are none.

use super::Family;
use super::angle::Angle;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

pub(super) fn derivatives(
    _: &Family,
    _: &Angle,
    _: &Fraction,
    _: (&Rational, bool),
    _: u32,
    _: &mut Work,
) -> Option<Vec<Fraction>> {
    None
}

pub(super) fn reversed(
    _: (&Angle, &Angle),
    _: [&Rational; 2],
    _: [&Rational; 2],
    _: &Fraction,
    _: &mut Work,
) -> Option<Vec<(Var, Fraction)>> {
    None
}
