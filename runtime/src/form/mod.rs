//! Polynomial curves on the unit interval, in the two forms that are evaluated.

mod bernstein;
mod endpoint;
mod slices;
mod tiles;

use core::fmt::Debug;

pub use bernstein::BernsteinForm;
pub(crate) use bernstein::{affine_nested, bernstein_derivative, nested};
pub use endpoint::EndpointForm;
#[cfg(feature = "bspline")]
pub(crate) use slices::{EndpointPoints, endpoint_coefficients, horner};
pub(crate) use tiles::MOST_COMPONENTS;

use crate::{Point, Scalar};

/// A polynomial curve `C(x)`, `0 <= x <= 1`; what binding control points to a [`Basis`](crate::Basis) gives.
///
/// Outside of the unit interval the polynomial is continued. At both ends the value is exact: `eval(0) == start()` and
/// `eval(1) == end()`, bit for bit but for the sign of a zero, unless an intermediate sum overflows.
pub trait Form<P: Point>: Copy + PartialEq + Debug {
    /// The degree of the polynomial.
    const DEGREE: usize;

    /// The point `C(x)`.
    fn eval(&self, x: P::Scalar) -> P;

    /// The point and its derivatives `[C(x), C'(x), C''(x), …]`, `K` of them; zero above the degree.
    fn eval_with_derivs<const K: usize>(&self, x: P::Scalar) -> [P; K];

    /// The points `out[i] = C(xs[i])`; what has no partner in the other slice is left alone.
    #[inline]
    fn eval_into(&self, xs: &[P::Scalar], out: &mut [P]) {
        for (point, &x) in out.iter_mut().zip(xs) {
            *point = self.eval(x);
        }
    }

    /// The points and derivatives `out[k][i] = rateᵏ C⁽ᵏ⁾(xs[i])`; what has no partner in the other slices is left
    /// alone.
    ///
    /// `rate` is the derivative of `x` in another parameter.
    fn eval_with_derivs_into<const K: usize>(
        &self,
        xs: &[P::Scalar],
        rate: P::Scalar,
        mut out: [&mut [P]; K],
    ) {
        pointwise(self, xs, rate, &mut out);
    }

    /// The curve `Σ weight · curve`.
    fn combination(terms: impl Iterator<Item = (Self, P::Scalar)> + Clone) -> Self;

    /// The point `C(0)`.
    fn start(&self) -> P;

    /// The point `C(1)`.
    fn end(&self) -> P;
}

/// What [`Form::eval_with_derivs_into`] does, one parameter after the other.
fn pointwise<P: Point, F: Form<P>, const K: usize>(
    form: &F,
    xs: &[P::Scalar],
    rate: P::Scalar,
    out: &mut [&mut [P]; K],
) {
    for (i, &x) in xs.iter().enumerate() {
        let mut scale = P::Scalar::ONE;
        for (derivative, out) in form.eval_with_derivs::<K>(x).into_iter().zip(out.iter_mut()) {
            if let Some(out) = out.get_mut(i) {
                *out = derivative.scale(scale);
            }
            scale = scale * rate;
        }
    }
}
