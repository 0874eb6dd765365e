//! The Bernstein basis of any degree, as a family of basis functions.

use core::marker::PhantomData;

use crate::numeric::binomial::binomials;
use crate::{Array, Basis, BernsteinForm, Point, Scalar};

/// The Bernstein basis of degree `n = N - 1`: `b[k](t) = binomial(n, k) (1-t)^(n-k) t^k` on `0 <= t <= 1`.
///
/// Curves over it are Bézier curves, see [`Bezier`](crate::Bezier). Every polynomial curve has this form:
/// [`Curve::to_bezier`](crate::Curve::to_bezier), and the parts of curves that `split` and its like return.
///
/// ```
/// use basis_runtime::{Basis, BernsteinBasis};
///
/// let cubic = BernsteinBasis::<f64, 4>::new();
/// assert_eq!(cubic.values(0.5), [0.125, 0.375, 0.375, 0.125]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BernsteinBasis<S, const N: usize> {
    scalar: PhantomData<S>,
}

impl<S: Scalar, const N: usize> BernsteinBasis<S, N> {
    /// The basis with `N >= 1` functions.
    #[inline]
    pub const fn new() -> Self {
        const { assert!(N > 0, "a Bernstein basis has at least one function") };
        Self { scalar: PhantomData }
    }
}

impl<S: Scalar, const N: usize> Default for BernsteinBasis<S, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, const N: usize> Basis for BernsteinBasis<S, N> {
    type Scalar = S;
    type Values = [S; N];
    type Points<T: Copy> = [T; N];
    type Bernstein<T: Copy> = [T; N];
    type Form<P: Point<Scalar = S>> = BernsteinForm<P, N>;

    const NAME: &'static str = "Bernstein";

    #[inline]
    fn domain() -> [S; 2] {
        [S::ZERO, S::ONE]
    }

    #[inline]
    fn values(&self, t: S) -> [S; N] {
        let s = S::ONE - t;
        let binomials = const { binomials::<N>() };
        let mut values = binomials.map(S::of);
        let mut powers = [S::ONE; 2];
        for k in 0..N {
            values[k] = values[k] * powers[0];
            values[N - 1 - k] = values[N - 1 - k] * powers[1];
            powers = [powers[0] * t, powers[1] * s];
        }
        values
    }

    #[inline]
    fn bernstein_weights(&self) -> [[S; N]; N] {
        core::array::from_fn(|i| core::array::from_fn(|j| if i == j { S::ONE } else { S::ZERO }))
    }

    #[inline]
    fn bind<P: Point<Scalar = S>>(&self, points: &[P; N]) -> BernsteinForm<P, N> {
        BernsteinForm::new(*points)
    }

    #[inline]
    fn to_bernstein<P: Point<Scalar = S>>(&self, points: &[P; N]) -> [P; N] {
        *points
    }
}

/// The Bernstein basis of the same degree as the family `B`.
pub type BernsteinOf<B> = <<B as Basis>::Bernstein<()> as Array<()>>::Basis<<B as Basis>::Scalar>;
