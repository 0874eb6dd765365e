//! The map from the domain of a rational family to the unit interval.

use crate::Scalar;
use crate::domain::{from_unit, inverse_width, unit};

/// The map from a domain `lo <= t <= hi` to the parameter `0 <= x <= 1` in which the functions of a
/// [`RationalBasis`](crate::RationalBasis) are quotients of polynomials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chart<S> {
    domain: [S; 2],
}

impl<S: Scalar> Chart<S> {
    /// The affine map, `x = (t - lo) / (hi - lo)`.
    #[inline]
    pub fn affine(domain: [S; 2]) -> Self {
        Self { domain }
    }

    /// The two ends `[lo, hi]` of the domain.
    #[inline]
    pub fn domain(&self) -> [S; 2] {
        self.domain
    }

    /// The coordinates `[s, x]` of `t`, `s = 1 - x`; each has a small relative error where it is small.
    #[inline]
    pub fn coordinates(&self, t: S) -> [S; 2] {
        unit(self.domain, t)
    }

    /// The parameter `t` at the place `x`, exact at both ends.
    #[inline]
    pub fn parameter(&self, x: S) -> S {
        from_unit(self.domain, x)
    }

    /// The Taylor coefficients of `x(t + h) - x(t)` in `h`, from that of `h⁰`, which is zero.
    #[inline]
    pub(crate) fn expansion(&self, _t: S, series: &mut [S]) {
        series.fill(S::ZERO);
        if let Some(first) = series.get_mut(1) {
            *first = inverse_width(self.domain);
        }
    }
}
