//! One segment of a uniform cubic B-spline curve; its ends are not control points.

/// `UniformCubic`: 4 basis functions of degree 3 on `0 <= t <= 1`.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq,
    ::core::default::Default,
)]
pub struct UniformCubic<S = f64>(::core::marker::PhantomData<S>);

impl<S: ::basis_runtime::Scalar> UniformCubic<S> {
    /// The family.
    pub fn new() -> Self {
        Self(::core::marker::PhantomData)
    }

    /// The values of all functions.
    #[inline]
    pub fn values(&self, t: S) -> [S; 4] {
        use ::basis_runtime::__private::{bernstein, unit};
        let [s, x] = unit(<Self as ::basis_runtime::Basis>::domain(), t);
        let sixth = S::of(0.166_666_666_666_666_66);
        let third = S::of(0.333_333_333_333_333_3);
        let two_thirds = S::of(0.666_666_666_666_666_6);
        [
            sixth * (s * s * s),
            bernstein([two_thirds, two_thirds, third, sixth], s, x),
            bernstein([sixth, third, two_thirds, two_thirds], s, x),
            sixth * (x * x * x),
        ]
    }
}

impl<S: ::basis_runtime::Scalar> ::basis_runtime::Basis for UniformCubic<S> {
    type Scalar = S;
    type Values = [S; 4];
    type Points<T: ::core::marker::Copy> = [T; 4];
    type Bernstein<T: ::core::marker::Copy> = [T; 4];
    type Form<P: ::basis_runtime::Point<Scalar = S>> = ::basis_runtime::EndpointForm<P, 2>;

    const NAME: &'static str = "UniformCubic";

    #[inline]
    fn domain() -> [S; 2] {
        [S::of(0.0), S::of(1.0)]
    }

    #[inline]
    fn values(&self, t: S) -> [S; 4] {
        Self::values(self, t)
    }

    #[inline]
    fn bernstein_weights(&self) -> [[S; 4]; 4] {
        let (zero, sixth) = (S::of(0.0), S::of(0.166_666_666_666_666_66));
        let third = S::of(0.333_333_333_333_333_3);
        let two_thirds = S::of(0.666_666_666_666_666_6);
        [
            [sixth, two_thirds, sixth, zero],
            [zero, two_thirds, third, zero],
            [zero, third, two_thirds, zero],
            [zero, sixth, two_thirds, sixth],
        ]
    }

    #[inline]
    fn bind<P: ::basis_runtime::Point<Scalar = S>>(&self, points: &[P; 4]) -> Self::Form<P> {
        use ::basis_runtime::__private::combine;
        let (zero, quarter) = (S::of(0.0), S::of(0.25));
        let twelfth = S::of(0.083_333_333_333_333_33);
        let sixth = S::of(0.166_666_666_666_666_66);
        let two_thirds = S::of(0.666_666_666_666_666_6);
        ::basis_runtime::EndpointForm::new(
            [
                combine(points, [sixth, two_thirds, sixth, zero]),
                combine(points, [zero, sixth, two_thirds, sixth]),
            ],
            [
                combine(points, [-quarter, quarter, quarter, -quarter]),
                combine(points, [twelfth, -quarter, quarter, -twelfth]),
            ],
        )
    }
}
