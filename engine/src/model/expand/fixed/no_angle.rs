//! Stands for the values that `at` blocks fix of angles where the feature `angles` is off: no family has any.

use crate::algebra::fraction::Fraction;
use crate::model::angle::{Angle, Given};
use crate::model::scope::{Fixed, Scope};
use crate::model::{Family, Library};
use crate::syntax::{self, Binding};

pub(in crate::model::expand) fn without_tangents(
    _: &Library<'_>,
    _: usize,
    _: &syntax::Family,
    _: &Family,
    _: &[Binding],
) -> Given {
    Given::new()
}

pub(super) fn fixed_angle(
    _: &mut Scope<'_>,
    _: &Family,
    _: &Angle,
    _: (Fraction, &Binding),
    _: &mut Fixed,
) -> Option<()> {
    None
}
