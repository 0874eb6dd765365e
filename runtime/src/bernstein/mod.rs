//! Polynomials in Bernstein form, as slices of coefficients or control points.
//!
//! A slice `c` of length `n + 1` is the polynomial, or the Bézier curve, of degree `n`
//!
//! ```text
//! p(x) = Σ_i binomial(n, i) (1-x)^(n-i) x^i c[i],   0 <= x <= 1
//! ```
//!
//! Everything works on slices and in place, for any [`Point`](crate::Point); numbers are points of dimension one. These
//! are the tools of which curves, surfaces and patches are made; the empty slice is the polynomial 0.
//!
//! | | |
//! | --- | --- |
//! | [`eval`], [`eval_with_derivs`] | value and derivatives at `x` |
//! | [`split`], [`keep_left`], [`keep_right`], [`restrict`] | the same polynomial on a part of the interval |
//! | [`elevate`] | the same polynomial with more coefficients |
//! | [`differentiate`] | the derivative |
//! | [`centred_powers`] | the same polynomial in powers of `2x - 1` |
//! | [`multiply`], [`dot`] | products |
//! | [`bounds`] | the smallest and the largest coefficient, between which the polynomial stays |
//! | [`roots`] | the zeros on `[0, 1]`, isolated by sign changes |

mod basis;
mod casteljau;
mod degree;
pub(crate) mod product;
#[cfg(feature = "alloc")]
mod roots;

pub use basis::{BernsteinBasis, BernsteinOf};
pub use casteljau::{eval, eval_with_derivs, keep_left, keep_right, restrict, split};
pub use degree::{centred_powers, differentiate, elevate};
#[cfg(feature = "alloc")]
pub(crate) use product::bilinear;
pub use product::{bounds, dot, multiply};
#[cfg(feature = "alloc")]
pub use roots::{Root, RootKind, roots};
#[cfg(feature = "alloc")]
pub(crate) use roots::{bracketed_root, changes_of_sign};
