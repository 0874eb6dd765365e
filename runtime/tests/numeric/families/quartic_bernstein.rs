// Cubic Bernstein with one shape parameter, as `basis!` emits it. No inner documentation: the crate's examples include
// it.

/// `QuarticBernstein`: 4 basis functions of degree 4 on `0 <= t <= 1`.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
pub struct QuarticBernstein<S = f64> {
    lambda: S,
}

impl<S: ::basis_runtime::Scalar> QuarticBernstein<S> {
    /// The family at `λ = lambda`, declared for `-3 <= λ <= 1`.
    pub fn new(lambda: S) -> ::core::result::Result<Self, ::basis_runtime::ShapeError> {
        use ::basis_runtime::__private::{check_shape, core::ops::Bound};
        ::core::result::Result::Ok(Self {
            lambda: check_shape(
                "QuarticBernstein",
                "λ",
                lambda,
                Bound::Included(-3.0),
                Bound::Included(1.0),
                "-3 <= λ <= 1",
            )?,
        })
    }

    /// The shape parameter `λ`.
    #[inline]
    pub fn lambda(&self) -> S {
        self.lambda
    }

    /// The values of all functions.
    #[inline]
    pub fn values(&self, t: S) -> [S; 4] {
        use ::basis_runtime::__private::{bernstein, unit};
        let lambda = self.lambda;
        let [s, x] = unit(<Self as ::basis_runtime::Basis>::domain(), t);
        let (s2, x2) = (s * s, x * x);
        [
            bernstein([S::of(1.0), S::of(1.0) - lambda], s, x) * (s2 * s),
            bernstein([S::of(3.0) + lambda, S::of(3.0)], s, x) * (s2 * x),
            bernstein([S::of(3.0), S::of(3.0) + lambda], s, x) * (s * x2),
            bernstein([S::of(1.0) - lambda, S::of(1.0)], s, x) * (x2 * x),
        ]
    }

    /// The derivatives of that order of all functions.
    #[inline]
    pub fn derivatives(&self, t: S, order: usize) -> [S; 4] {
        ::basis_runtime::Basis::derivatives(self, t, order)
    }
}

impl<S: ::basis_runtime::Scalar> ::basis_runtime::Basis for QuarticBernstein<S> {
    type Scalar = S;
    type Values = [S; 4];
    type Points<T: ::core::marker::Copy> = [T; 4];
    type Bernstein<T: ::core::marker::Copy> = [T; 5];
    type Form<P: ::basis_runtime::Point<Scalar = S>> = ::basis_runtime::EndpointForm<P, 3>;

    const NAME: &'static str = "QuarticBernstein";

    #[inline]
    fn domain() -> [S; 2] {
        [S::of(0.0), S::of(1.0)]
    }

    #[inline]
    fn values(&self, t: S) -> [S; 4] {
        Self::values(self, t)
    }

    #[inline]
    fn bernstein_weights(&self) -> [[S; 4]; 5] {
        let lambda = self.lambda;
        let (zero, half, one) = (S::of(0.0), S::of(0.5), S::of(1.0));
        let inner = S::of(0.75) + S::of(0.25) * lambda;
        let outer = S::of(0.25) - S::of(0.25) * lambda;
        [
            [one, zero, zero, zero],
            [outer, inner, zero, zero],
            [zero, half, half, zero],
            [zero, zero, inner, outer],
            [zero, zero, zero, one],
        ]
    }

    #[inline]
    fn bind<P: ::basis_runtime::Point<Scalar = S>>(&self, points: &[P; 4]) -> Self::Form<P> {
        use ::basis_runtime::__private::combine;
        let lambda = self.lambda;
        let w0 = S::of(1.5) + S::of(0.25) * lambda;
        let w1 = S::of(0.5) + S::of(0.5) * lambda;
        let w2 = S::of(1.5) + S::of(0.5) * lambda;
        let w3 = S::of(0.25) * lambda;
        ::basis_runtime::EndpointForm::new(
            [points[0], points[3]],
            [
                combine(points, [-w0, w0, w0, -w0]),
                combine(points, [w1, -w2, w2, -w1]),
                combine(points, [-w3, w3, w3, -w3]),
            ],
        )
    }
}
