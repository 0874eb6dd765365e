//! Stands for the ends of domains in an angle where the feature `angles` is off: there are none.

use super::Angle;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;

pub(in crate::model) fn derivatives(
    _: &Family,
    _: &Angle,
    _: &Fraction,
    _: (&Rational, bool),
    _: u32,
    _: &mut Work,
) -> Option<Vec<Fraction>> {
    None
}

pub(in crate::model) fn reversed(
    _: (&Angle, &Angle),
    _: [&Rational; 2],
    _: [&Rational; 2],
    _: &Fraction,
    _: &mut Work,
) -> Option<Vec<(Var, Fraction)>> {
    None
}
