//! Stands for power series of functions with variables beside their sines where the feature `angles` is off.

use crate::model::{Family, Truncations};

/// Nothing, of nothing.
pub(crate) fn in_polynomials(_: &Family, _: Truncations) -> Option<Family> {
    None
}

/// Of no family.
pub(crate) fn longest(_: &Family) -> Option<(String, String)> {
    None
}
