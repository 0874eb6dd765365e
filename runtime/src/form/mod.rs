//! Polynomial curves on the unit interval, in the two forms that are evaluated.

mod bernstein;
mod endpoint;

use core::fmt::Debug;

pub use bernstein::BernsteinForm;
pub(crate) use bernstein::{bernstein_derivative, binomials, nested};
pub use endpoint::EndpointForm;

use crate::Point;

/// A polynomial curve `C(x)`, `0 <= x <= 1`; what binding control points to a [`Basis`](crate::Basis) gives.
///
/// Outside of the unit interval the polynomial is continued. At both ends the value is exact:
/// `eval(0) == start()` and `eval(1) == end()`, bit for bit but for the sign of a zero, unless an intermediate sum overflows.
pub trait Form<P: Point>: Copy + PartialEq + Debug {
    /// The degree of the polynomial.
    const DEGREE: usize;

    /// The point `C(x)`.
    fn eval(&self, x: P::Scalar) -> P;

    /// The point and its derivatives `[C(x), C'(x), C''(x), …]`, `K` of them; zero above the degree.
    fn eval_with_derivs<const K: usize>(&self, x: P::Scalar) -> [P; K];

    /// The point `C(0)`.
    fn start(&self) -> P;

    /// The point `C(1)`.
    fn end(&self) -> P;
}
