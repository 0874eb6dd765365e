//! Stands for power series of functions with variables beside their sines where the feature `angles` is off.

use crate::model::Family;

/// No function has one.
pub(super) fn is_mixed(_: &Family) -> bool {
    false
}

/// Nothing, of nothing.
pub(super) fn in_polynomials(_: &Family) -> Option<Family> {
    None
}

/// Of no family.
pub(super) fn longest(_: &Family) -> Option<(String, String)> {
    None
}
