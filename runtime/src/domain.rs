//! The map from a domain `[lo, hi]` to the unit interval.

use crate::Scalar;

/// The barycentric coordinates `[s, x] = [(hi - t) / (hi - lo), (t - lo) / (hi - lo)]` of `t` in the domain.
///
/// Both are exact at both ends, and each has a small relative error where it is small. On `[0, 1]` they are
/// `[1 - t, t]`.
#[inline]
pub fn unit<S: Scalar>([lo, hi]: [S; 2], t: S) -> [S; 2] {
    // Divided, not multiplied by the inverse: (hi - lo) · (1 / (hi - lo)) need not be 1.
    let width = hi - lo;
    [(hi - t) / width, (t - lo) / width]
}

/// `1 / (hi - lo)`, the derivative of `x` in `t`.
#[inline]
pub(crate) fn inverse_width<S: Scalar>([lo, hi]: [S; 2]) -> S {
    S::ONE / (hi - lo)
}

/// The parameter `lo (1 - x) + hi x`, exact at both ends.
#[inline]
pub(crate) fn from_unit<S: Scalar>([lo, hi]: [S; 2], x: S) -> S {
    if lo == S::ZERO && hi == S::ONE {
        return x;
    }
    lo * (S::ONE - x) + hi * x
}
