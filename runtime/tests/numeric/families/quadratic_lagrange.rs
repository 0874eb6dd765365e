//! The quadratic Lagrange basis at the nodes -1, 0 and 1.

/// `QuadraticLagrange`: 3 basis functions of degree 2 on `-1 <= t <= 1`.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq,
    ::core::default::Default,
)]
pub struct QuadraticLagrange<S = f64>(::core::marker::PhantomData<S>);

impl<S: ::basis_runtime::Scalar> QuadraticLagrange<S> {
    /// The family.
    pub fn new() -> Self {
        Self(::core::marker::PhantomData)
    }

    /// The values of all functions.
    #[inline]
    pub fn values(&self, t: S) -> [S; 3] {
        use ::basis_runtime::__private::{bernstein, unit};
        let [s, x] = unit(<Self as ::basis_runtime::Basis>::domain(), t);
        [
            bernstein([S::of(1.0), S::of(-1.0)], s, x) * s,
            S::of(4.0) * (s * x),
            bernstein([S::of(-1.0), S::of(1.0)], s, x) * x,
        ]
    }
}

impl<S: ::basis_runtime::Scalar> ::basis_runtime::Basis for QuadraticLagrange<S> {
    type Scalar = S;
    type Values = [S; 3];
    type Points<T: ::core::marker::Copy> = [T; 3];
    type Bernstein<T: ::core::marker::Copy> = [T; 3];
    type Form<P: ::basis_runtime::Point<Scalar = S>> = ::basis_runtime::EndpointForm<P, 1>;

    const NAME: &'static str = "QuadraticLagrange";

    #[inline]
    fn domain() -> [S; 2] {
        [S::of(-1.0), S::of(1.0)]
    }

    #[inline]
    fn values(&self, t: S) -> [S; 3] {
        Self::values(self, t)
    }

    #[inline]
    fn bernstein_weights(&self) -> [[S; 3]; 3] {
        let (zero, half, one) = (S::of(0.0), S::of(0.5), S::of(1.0));
        [[one, zero, zero], [-half, S::of(2.0), -half], [zero, zero, one]]
    }

    #[inline]
    fn bind<P: ::basis_runtime::Point<Scalar = S>>(&self, points: &[P; 3]) -> Self::Form<P> {
        use ::basis_runtime::__private::combine;
        ::basis_runtime::EndpointForm::new(
            [points[0], points[2]],
            [combine(points, [S::of(-2.0), S::of(4.0), S::of(-2.0)])],
        )
    }
}
