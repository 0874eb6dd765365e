// Rational quadratic Bernstein basis in standard form, as `basis!` emits it. No inner documentation: the crate's examples
// include it.

/// `RationalQuadratic`: 3 quotients of polynomials of degree 2 on `0 <= t <= 1`, with the weight `ω > 0`.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct RationalQuadratic<S = f64> {
    omega: S,
}

impl<S: ::basis_runtime::Scalar> RationalQuadratic<S> {
    /// The family with that weight.
    pub fn new(omega: S) -> ::core::result::Result<Self, ::basis_runtime::ShapeError> {
        use ::basis_runtime::__private::{check_shape, core::ops::Bound};
        let (low, high) = (Bound::Excluded(0.0), Bound::Unbounded);
        ::core::result::Result::Ok(Self {
            omega: check_shape("RationalQuadratic", "ω", omega, low, high, "0 < ω")?,
        })
    }
}

impl<S: ::basis_runtime::Scalar> ::basis_runtime::RationalBasis for RationalQuadratic<S> {
    type Scalar = S;
    type Values = [S; 3];
    type Points<T: ::core::marker::Copy> = [T; 3];
    type Bernstein<T: ::core::marker::Copy> = [T; 3];

    const NAME: &'static str = "RationalQuadratic";

    #[inline]
    fn chart(&self) -> ::basis_runtime::Chart<S> {
        ::basis_runtime::Chart::affine([S::of(0.0), S::of(1.0)])
    }

    #[inline]
    fn values(&self, t: S) -> [S; 3] {
        use ::basis_runtime::__private::{bernstein, unit};
        let [s, x] = unit([S::of(0.0), S::of(1.0)], t);
        let w = bernstein([S::of(1.0), self.omega, S::of(1.0)], s, x);
        [s * s / w, S::of(2.0) * self.omega * (s * x) / w, x * x / w]
    }

    #[inline]
    fn numerators(&self) -> [[S; 3]; 3] {
        let [zero, one] = [S::of(0.0), S::of(1.0)];
        [[one, zero, zero], [zero, self.omega, zero], [zero, zero, one]]
    }

    #[inline]
    fn denominator(&self) -> [S; 3] {
        [S::of(1.0), self.omega, S::of(1.0)]
    }
}
