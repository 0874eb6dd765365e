//! What a family of basis functions provides: the trait that generated types implement.

use core::fmt::Debug;

use crate::domain::{inverse_width, unit};
use crate::form::{Form, bernstein_derivative};
use crate::{BernsteinBasis, Point, Scalar};

/// An array `[T; N]` of a length that a [`Basis`] has fixed.
///
/// Stable Rust has no `[T; B::LEN]` in generic code; associated types with this trait as their bound stand in for it.
/// [`AsRef`] and [`AsMut`] give the slice.
pub trait Array<T>: Copy + AsRef<[T]> + AsMut<[T]> + sealed::Sealed {
    /// The number of elements.
    const LEN: usize;

    /// The Bernstein basis with as many functions as the array has elements.
    type Basis<S: Scalar>: Basis<Scalar = S> + Default;

    /// The array `[element(0), …, element(LEN - 1)]`.
    fn from_fn(element: impl FnMut(usize) -> T) -> Self;
}

impl<T: Copy, const N: usize> Array<T> for [T; N] {
    const LEN: usize = N;
    type Basis<S: Scalar> = BernsteinBasis<S, N>;

    #[inline]
    fn from_fn(element: impl FnMut(usize) -> T) -> Self {
        core::array::from_fn(element)
    }
}

mod sealed {
    pub trait Sealed {}
    impl<T, const N: usize> Sealed for [T; N] {}
}

/// A family of polynomial basis functions `b[0], …, b[LEN - 1]` with its shape parameters set to values.
///
/// [`basis!`](crate::basis!) implements it for the types that it generates, with the lengths filled in. To evaluate a
/// curve at many parameters, bind control points once with [`Curve::new`](crate::Curve::new).
pub trait Basis: Copy + PartialEq + Debug {
    /// The type of parameters, values and shape parameters.
    type Scalar: Scalar;

    /// One value for each function: `[Self::Scalar; LEN]`.
    type Values: Array<Self::Scalar> + Point<Scalar = Self::Scalar>;

    /// One element, usually a control point, for each function: `[T; LEN]`.
    type Points<T: Copy>: Array<T>;

    /// One element for each function of the Bernstein basis of the same degree: `[T; DEGREE + 1]`.
    type Bernstein<T: Copy>: Array<T>;

    /// The polynomial curve that control points and shape values make together.
    type Form<P: Point<Scalar = Self::Scalar>>: Form<P>;

    /// The name of the family in its spec.
    const NAME: &'static str;

    /// The number of basis functions.
    const LEN: usize = <Self::Points<()> as Array<()>>::LEN;

    /// The degree of the functions in the domain variable.
    const DEGREE: usize = <Self::Bernstein<()> as Array<()>>::LEN - 1;

    /// The two ends `[lo, hi]` of the domain, `lo < hi`.
    fn domain() -> [Self::Scalar; 2];

    /// The values `b[i](t)` of all functions.
    fn values(&self, t: Self::Scalar) -> Self::Values;

    /// The weights `c[j][i]` of the control points in the Bézier control points; by columns the Bernstein
    /// coefficients of the functions:
    /// `b[i](t) = Σ_j c[j][i] · binomial(n, j) (1-x)^(n-j) x^j` with `n = DEGREE` and `x = (t - lo) / (hi - lo)`.
    ///
    /// The rows are the Bézier control points of the curve `(b[0](t), b[1](t), …)`.
    fn bernstein_weights(&self) -> Self::Bernstein<Self::Values>;

    /// The curve `C(x) = Σ b[i](lo + (hi - lo) x) points[i]`, `0 <= x <= 1`, ready to be evaluated.
    fn bind<P: Point<Scalar = Self::Scalar>>(&self, points: &Self::Points<P>) -> Self::Form<P>;

    /// The derivatives `dᵏ b[i] / dtᵏ (t)` of all functions, `k = order`; zero above the degree.
    ///
    /// Computed from differences of the Bernstein coefficients, by de Casteljau's algorithm.
    #[inline]
    fn derivatives(&self, t: Self::Scalar, order: usize) -> Self::Values {
        if order == 0 {
            return self.values(t);
        }
        let [s, x] = unit(Self::domain(), t);
        let inverse_width = inverse_width(Self::domain());
        let scale = (0..order.min(Self::DEGREE)).fold(Self::Scalar::ONE, |scale, _| scale * inverse_width);
        bernstein_derivative(self.bernstein_weights().as_mut(), order, s, x).scale(scale)
    }

    /// The control points of the same curve in the Bernstein basis of the same degree: `Σ_i c[j][i] points[i]` with the
    /// [`bernstein_weights`](Self::bernstein_weights) `c`.
    #[inline]
    fn to_bernstein<P: Point<Scalar = Self::Scalar>>(&self, points: &Self::Points<P>) -> Self::Bernstein<P> {
        let coefficients = self.bernstein_weights();
        Self::Bernstein::from_fn(|j| {
            let weights = coefficients.as_ref()[j];
            combination(points.as_ref().iter().copied().zip(weights.as_ref().iter().copied()))
        })
    }
}

/// `Σ weight · point`, from the first term to the last.
#[inline]
pub(crate) fn combination<P: Point>(mut terms: impl Iterator<Item = (P, P::Scalar)>) -> P {
    let Some((point, weight)) = terms.next() else { return P::zero() };
    terms.fold(point.scale(weight), |sum, (point, weight)| sum.add_scaled(point, weight))
}
