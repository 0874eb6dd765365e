//! The names of the variables in the tests.

use basis_test_support::Names;

use crate::algebra::poly::Poly;
use crate::algebra::range::Region;

/// The names of the variables 0, 1, …
pub(super) const NAMES: [&str; 5] = ["t", "λ", "μ", "f", "w"];

/// A polynomial such as `(3*t - 1)^2 + 1/2*λ`.
pub(super) fn poly(text: &str) -> Poly {
    Names(&NAMES).poly(text)
}

/// A box such as `0<=t<=1, 0<λ`.
pub(super) fn region(text: &str) -> Region {
    Names(&NAMES).region(text)
}

/// The variable of a name.
#[cfg(feature = "ranges")]
pub(super) fn var(name: &str) -> crate::algebra::poly::Var {
    Names(&NAMES).var(name)
}
