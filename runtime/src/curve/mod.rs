//! Curves: control points bound to a basis.

#[cfg(feature = "alloc")]
mod bounds;
mod contact;
mod error;
#[cfg(feature = "alloc")]
mod flatten;
mod frame;
mod joint;
mod length;
#[cfg(feature = "alloc")]
mod nearest;
mod parts;
mod slices;

use core::fmt::{self, Debug, Formatter};

use crate::bernstein;
use crate::domain::{inverse_width, unit};
use crate::form::bernstein_derivative;
use crate::vector::vectors;
use crate::{Array, Basis, CountError, Form, Point, Scalar};

pub use contact::Contact;
#[cfg(feature = "alloc")]
pub(crate) use contact::backwards;
#[cfg(feature = "alloc")]
pub(crate) use contact::eliminate_in;
pub(crate) use contact::{End, eliminate, touching};
pub use error::CurveError;
pub use frame::Frame;
#[cfg(feature = "geometry")]
pub(crate) use frame::{curvature, frenet, rotation_minimizing, torsion};
pub use joint::Joint;
pub(crate) use joint::leading_order;
#[cfg(feature = "geometry")]
pub(crate) use length::{ELLIPSES, RULES, Rule};
pub use parts::{Bezier, BezierOf};
pub(crate) use parts::{divisible, inside, nonempty};
pub use slices::Samples;
pub(crate) use slices::same_length;

/// The curve `C(t) = Σ b[i](t) P[i]` over control points `P[i]`.
///
/// The basis functions are bound to the control points once, in [`Curve::new`]; a point then costs one short
/// polynomial. The parameter `t` is not clamped: outside of the domain the polynomial is continued. If `t` is NaN so is
/// the point.
///
/// ```
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
/// # fn main() -> Result<(), basis_runtime::ShapeError> {
/// use basis_runtime::Curve;
///
/// let curve = Curve::new(QuarticBernstein::new(0.5)?, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
/// assert_eq!(curve.eval(0.5), [2.0, 1.625]);
///
/// let [point, velocity] = curve.eval_with_derivs(1.0);
/// assert_eq!(point, curve.end());
/// assert_eq!(velocity, [3.5, -7.0]); // (3 + λ) (P[3] - P[2])
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy)]
pub struct Curve<B: Basis, P: Point<Scalar = B::Scalar>> {
    basis: B,
    points: B::Points<P>,
    form: B::Form<P>,
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The curve of that basis over these control points, one for each basis function.
    #[inline]
    pub fn new(basis: B, points: B::Points<P>) -> Self {
        Self { basis, points, form: basis.bind(&points) }
    }

    /// The curve over control points in a slice, one for each basis function.
    ///
    /// # Errors
    /// If the number of points is not the number of functions.
    pub fn from_slice(basis: B, points: &[P]) -> Result<Self, CountError> {
        Ok(Self::new(basis, CountError::one_each(B::NAME, points)?))
    }

    /// The curve over the same control points with other shape values.
    ///
    /// ```
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
    /// # fn main() -> Result<(), basis_runtime::ShapeError> {
    /// use basis_runtime::Curve;
    ///
    /// let curve = Curve::new(QuarticBernstein::new(0.5)?, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// let fuller = curve.with_basis(QuarticBernstein::new(1.0)?);
    /// assert_eq!(fuller.control_points(), curve.control_points());
    /// assert!(fuller.eval(0.5)[1] > curve.eval(0.5)[1]);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn with_basis(&self, basis: B) -> Self {
        Self::new(basis, self.points)
    }

    /// The curve over the images of all control points.
    ///
    /// It is the image of the curve under an affine map if the functions sum to 1, and always under a linear one. The maps
    /// of the libraries of points can be used: `curve.map(|p| map * p)` with those of nalgebra,
    /// `curve.map(|p| map.transform_point3(p))` with those of glam.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let arch = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [2.0, 0.0]]);
    /// assert_eq!(arch.map(|[x, y]| [y, x, 1.0]).eval(0.5), [1.0, 1.0, 1.0]);
    /// ```
    #[must_use]
    pub fn map<Q: Point<Scalar = B::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> Curve<B, Q> {
        Curve::new(self.basis, B::Points::from_fn(|i| image(self.points.as_ref()[i])))
    }

    crate::affine::transform!();

    /// The point `C(t)`.
    ///
    /// Exact at both ends of the domain: there it equals [`start`](Self::start) and [`end`](Self::end).
    #[inline]
    pub fn eval(&self, t: B::Scalar) -> P {
        let [_, x] = unit(B::domain(), t);
        self.form.eval(x)
    }

    /// The point `C(t)`, if `t` lies in the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `t` is outside of the domain or NaN.
    #[inline]
    pub fn eval_checked(&self, t: B::Scalar) -> Result<P, CurveError> {
        inside(B::domain(), t)?;
        Ok(self.eval(t))
    }

    /// The point `C(t)`, or the nearer end of the curve if `t` is outside of the domain; if `t` is NaN so is the point.
    #[inline]
    pub fn eval_clamped(&self, t: B::Scalar) -> P {
        let [lo, hi] = B::domain();
        // Comparisons that keep NaN.
        self.eval(if t < lo {
            lo
        } else if t > hi {
            hi
        } else {
            t
        })
    }

    /// The point and its derivatives with respect to `t`, `[C(t), C'(t), C''(t), …]`; zero above the degree.
    ///
    /// `K` is their number: `let [p, v, a] = curve.eval_with_derivs(t);` gives the point, its velocity and
    /// acceleration. All of them are vectors, the point as the one from the origin, [`Point::from_vector`].
    #[allow(clippy::inline_always)] // a result in memory costs more to hand over than to compute
    #[inline(always)]
    pub fn eval_with_derivs<const K: usize>(&self, t: B::Scalar) -> [P::Vector; K] {
        let [_, x] = unit(B::domain(), t);
        let inverse_width = inverse_width(B::domain());
        let mut derivatives: [P; K] = self.form.eval_with_derivs(x);
        let mut scale = B::Scalar::ONE;
        for derivative in derivatives.iter_mut().take(B::DEGREE + 1).skip(1) {
            scale = scale * inverse_width;
            *derivative = derivative.scale(scale);
        }
        derivatives.map(P::to_vector)
    }

    /// The derivative of that order with respect to `t`, `dᵏC/dtᵏ`, `k = order`; zero above the degree. For order 0 it
    /// is the vector from the origin to the point.
    ///
    /// All of them at once: [`eval_with_derivs`](Self::eval_with_derivs) for a number known to the compiler,
    /// [`derivatives_into`](Self::derivatives_into) for any.
    pub fn derivative(&self, t: B::Scalar, order: usize) -> P::Vector {
        if order == 0 {
            return self.eval(t).to_vector();
        }
        let [s, x] = unit(B::domain(), t);
        let inverse_width = inverse_width(B::domain());
        let scale = (0..order.min(B::DEGREE)).fold(B::Scalar::ONE, |scale, _| scale * inverse_width);
        bernstein_derivative(self.to_bernstein().as_mut(), order, s, x).scale(scale).to_vector()
    }

    /// The point, as the vector from the origin, and its derivatives with respect to `t`, as many as the slice has places;
    /// zero above the degree.
    pub fn derivatives_into(&self, t: B::Scalar, derivatives: &mut [P::Vector]) {
        let [_, x] = unit(B::domain(), t);
        let inverse_width = inverse_width(B::domain());
        let points: B::Bernstein<P::Vector> = vectors(self.to_bernstein().as_ref());
        let mut scratch = points;
        bernstein::eval_with_derivs(points.as_ref(), x, scratch.as_mut(), derivatives);
        let mut scale = B::Scalar::ONE;
        for (k, derivative) in derivatives.iter_mut().enumerate().take(B::DEGREE + 1) {
            *derivative = if k == 0 { self.eval(t).to_vector() } else { derivative.scale(scale) };
            scale = scale * inverse_width;
        }
    }

    /// The point at the lower end of the domain.
    #[inline]
    pub fn start(&self) -> P {
        self.form.start()
    }

    /// The point at the upper end of the domain.
    #[inline]
    pub fn end(&self) -> P {
        self.form.end()
    }

    /// The two ends `[lo, hi]` of the domain.
    #[inline]
    pub fn domain(&self) -> [B::Scalar; 2] {
        B::domain()
    }

    /// The basis, with its shape parameters.
    #[inline]
    pub fn basis(&self) -> B {
        self.basis
    }

    /// The control points, one for each basis function.
    #[inline]
    pub fn control_points(&self) -> &[P] {
        self.points.as_ref()
    }

    /// The control points of the same curve as a Bézier curve of the same degree.
    ///
    /// For `0 <= x <= 1` it is `C(lo + (hi - lo) x)`.
    #[inline]
    pub fn to_bernstein(&self) -> B::Bernstein<P> {
        self.basis.to_bernstein(&self.points)
    }

    /// The smallest axis-parallel box around the Bézier control points, as its two extreme corners `[min, max]`: cheap,
    /// and never too small but for rounding errors. NaN in a component in which a control point is NaN.
    pub fn control_box(&self) -> [P; 2] {
        crate::vector::box_of(self.to_bernstein().as_ref())
    }

    /// The polynomial in `x = (t - lo) / (hi - lo)` that is evaluated.
    #[inline]
    pub fn form(&self) -> &B::Form<P> {
        &self.form
    }
}

// The form follows from the basis and the control points, so neither of these looks at it.

impl<B: Basis, P: Point<Scalar = B::Scalar>> PartialEq for Curve<B, P> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.basis == other.basis && self.control_points() == other.control_points()
    }
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Debug for Curve<B, P> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Curve")
            .field("basis", &self.basis)
            .field("control_points", &self.control_points())
            .finish_non_exhaustive()
    }
}
