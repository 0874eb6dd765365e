//! Bernstein bases of two orders, in the Bernstein form.

macro_rules! bernstein {
    ($family:ident, $name:literal, $degree:literal, $len:literal) => {
        #[derive(Clone, Copy, Debug, PartialEq, Default)]
        pub struct $family<S = f64>(core::marker::PhantomData<S>);

        impl<S: basis_runtime::Scalar> $family<S> {
            pub fn new() -> Self {
                Self(core::marker::PhantomData)
            }
        }

        impl<S: basis_runtime::Scalar> basis_runtime::Basis for $family<S> {
            type Scalar = S;
            type Values = [S; $len];
            type Points<T: Copy> = [T; $len];
            type Bernstein<T: Copy> = [T; $len];
            type Form<P: basis_runtime::Point<Scalar = S>> = basis_runtime::BernsteinForm<P, $len>;

            const NAME: &'static str = $name;

            fn domain() -> [S; 2] {
                [S::of(0.0), S::of(1.0)]
            }

            fn values(&self, t: S) -> [S; $len] {
                use basis_runtime::__private::{powers, unit};
                let [s, x] = unit(Self::domain(), t);
                let (s, x): ([S; $len], [S; $len]) = (powers(s), powers(x));
                let mut binomial = 1.0;
                core::array::from_fn(|k| {
                    let value = S::of(binomial) * s[$degree - k] * x[k];
                    binomial = binomial * ($degree - k) as f64 / (k + 1) as f64;
                    value
                })
            }

            fn bernstein_weights(&self) -> [[S; $len]; $len] {
                core::array::from_fn(|i| core::array::from_fn(|j| S::of(f64::from(u8::from(i == j)))))
            }

            fn bind<P: basis_runtime::Point<Scalar = S>>(&self, points: &[P; $len]) -> Self::Form<P> {
                basis_runtime::BernsteinForm::new(*points)
            }
        }
    };
}
bernstein!(Bernstein7, "Bernstein(7)", 7, 8);
bernstein!(Bernstein30, "Bernstein(30)", 30, 31);
