//! What a family of rational basis functions provides: the trait that generated types implement.

use core::fmt::Debug;

use super::series::{Room, derivatives};
use super::{Chart, RationalCurve};
#[cfg(feature = "alloc")]
use crate::CurveError;
use crate::basis::combination;
#[cfg(feature = "alloc")]
use crate::curve::{End, eliminate_in};
#[cfg(feature = "geometry")]
use crate::vector::is_finite;
use crate::{Array, Point, Rounding, Scalar};
#[cfg(feature = "geometry")]
use crate::{Contact, ParametricCurve};

/// A family of rational basis functions `b[0], …, b[LEN - 1]` with its shape parameters set to values: quotients with
/// one denominator, which is zero nowhere on the domain.
///
/// ```text
/// b[i](t) = Σ_j c[j][i] B[j](x) / Σ_j w[j] B[j](x),   B[j](x) = binomial(n, j) (1-x)^(n-j) x^j,   n = DEGREE
/// ```
///
/// [`basis!`](crate::basis!) implements it for the families with denominators. Control points are bound in a
/// [`RationalCurve`].
pub trait RationalBasis: Copy + PartialEq + Debug {
    /// The type of parameters, values and shape parameters.
    type Scalar: Scalar;

    /// One value for each function: `[Self::Scalar; LEN]`.
    type Values: Array<Self::Scalar> + Point<Scalar = Self::Scalar>;

    /// One element, usually a control point, for each function: `[T; LEN]`.
    type Points<T: Copy>: Array<T>;

    /// One element for each function of the Bernstein basis of the same degree: `[T; DEGREE + 1]`.
    type Bernstein<T: Copy>: Array<T>;

    /// The name of the family in its spec.
    const NAME: &'static str;

    /// The number of basis functions.
    const LEN: usize = <Self::Points<()> as Array<()>>::LEN;

    /// The degree of numerators and denominator in `x`.
    const DEGREE: usize = <Self::Bernstein<()> as Array<()>>::LEN - 1;

    /// The proved bounds of the rounding errors of [`values`](Self::values), one for each function; empty where none are
    /// known.
    const ROUNDING: &'static [Rounding] = &[];

    /// How far each component of a point that [`RationalCurve::eval`](crate::RationalCurve::eval) computes, binding
    /// included, can be from the exact one: this many ε times the largest absolute value of that component of a control
    /// point, as long as nothing overflows or underflows; `None` where no bound is known.
    const ROUNDING_POINT: Option<f64> = None;

    /// The map from the domain to `0 <= x <= 1`.
    fn chart(&self) -> Chart<Self::Scalar>;

    /// The values `b[i](t)` of all functions.
    fn values(&self, t: Self::Scalar) -> Self::Values;

    /// The Bernstein coefficients `c[j][i]` of the numerators, one row for each `j`.
    fn numerators(&self) -> Self::Bernstein<Self::Values>;

    /// The Bernstein coefficients `w[j]` of the denominator.
    fn denominator(&self) -> Self::Bernstein<Self::Scalar>;

    /// The two ends `[lo, hi]` of the domain, `lo < hi`.
    #[inline]
    fn domain(&self) -> [Self::Scalar; 2] {
        self.chart().domain()
    }

    /// The values and derivatives in `t` of all functions, `[b, b', b'', …]`, `K` of them.
    ///
    /// Computed from the power series of numerators and denominator.
    #[inline]
    fn values_with_derivs<const K: usize>(&self, t: Self::Scalar) -> [Self::Values; K] {
        let zero = Self::Values::zero();
        let (mut curve, mut out) = ([zero; K], [zero; K]);
        let (mut weight, mut map) = ([Self::Scalar::ZERO; K], [Self::Scalar::ZERO; K]);
        let room = Room { curve: &mut curve, weight: &mut weight, map: &mut map };
        let (mut numerators, mut denominator) = (self.numerators(), self.denominator());
        derivatives(numerators.as_mut(), denominator.as_mut(), &self.chart(), t, room, &mut out);
        if let Some(values) = out.first_mut() {
            *values = self.values(t);
        }
        out
    }

    /// The derivatives `dᵏ b[i] / dtᵏ (t)` of all functions, `k = order`.
    ///
    /// They have no bound such as [`ROUNDING`](Self::ROUNDING). Of families with angles or exponentials on a domain of a
    /// small length α in the angle the error is about `ε/αᵏ`.
    #[cfg(feature = "alloc")]
    fn derivatives(&self, t: Self::Scalar, order: usize) -> Self::Values {
        if order == 0 {
            return self.values(t);
        }
        let (mut numerators, mut denominator) = (self.numerators(), self.denominator());
        super::series::derivative(numerators.as_mut(), denominator.as_mut(), &self.chart(), t, order)
    }

    /// The Bernstein coefficients of the numerator of the curve over these control points, `Σ_i c[j][i] points[i]`; its
    /// denominator is [`denominator`](Self::denominator).
    #[inline]
    fn to_bernstein<P: Point<Scalar = Self::Scalar>>(&self, points: &Self::Points<P>) -> Self::Bernstein<P> {
        let coefficients = self.numerators();
        Self::Bernstein::from_fn(|j| {
            let weights = coefficients.as_ref()[j];
            combination(points.as_ref().iter().copied().zip(weights.as_ref().iter().copied()))
        })
    }

    /// The curve over these control points, one for each function.
    #[inline]
    fn curve<P: Point<Scalar = Self::Scalar>>(&self, points: Self::Points<P>) -> RationalCurve<Self, P> {
        RationalCurve::new(*self, points)
    }

    /// The control points of a curve with the derivatives `[C, C', …]` at the start of the domain: the first points, as
    /// many as there are derivatives, are replaced by the solution of `Σ_i b[i]⁽ᵏ⁾(lo) points[i] = derivatives[k]`.
    ///
    /// # Errors
    /// [`CurveError::Join`] if these control points do not determine the derivatives.
    #[cfg(feature = "alloc")]
    fn start_points<P: Point<Scalar = Self::Scalar>>(
        &self,
        derivatives: &[P],
        points: Self::Points<P>,
    ) -> Result<Self::Points<P>, CurveError> {
        let at = self.domain()[0];
        let rows = Self::Points::<Self::Values>::from_fn(|k| self.derivatives(at, k));
        eliminate_in(Self::NAME, rows, derivatives, points, End::Start)
    }

    /// As [`start_points`](Self::start_points) for the derivatives at the end of the domain and the last points.
    ///
    /// # Errors
    /// As [`start_points`](Self::start_points).
    #[cfg(feature = "alloc")]
    fn end_points<P: Point<Scalar = Self::Scalar>>(
        &self,
        derivatives: &[P],
        points: Self::Points<P>,
    ) -> Result<Self::Points<P>, CurveError> {
        let at = self.domain()[1];
        let rows = Self::Points::<Self::Values>::from_fn(|k| self.derivatives(at, k));
        eliminate_in(Self::NAME, rows, derivatives, points, End::Last)
    }

    /// The curve Q over this family that continues a curve P of any type where that ends: the first control points, one
    /// more than the order of the contact, are computed from the derivatives of P, the others are taken from `points`.
    ///
    /// # Errors
    /// As [`Basis::curve_after`](crate::Basis::curve_after).
    #[cfg(feature = "geometry")]
    fn curve_after<P: Point<Scalar = Self::Scalar>>(
        &self,
        curve: &dyn ParametricCurve<Point = P>,
        contact: Contact<Self::Scalar>,
        points: Self::Points<P>,
    ) -> Result<RationalCurve<Self, P>, CurveError> {
        let derivatives = contact_of(curve, curve.domain()[1], contact, Self::NAME, Self::LEN)?;
        finite(RationalCurve::new(*self, self.start_points(&derivatives, points)?))
    }

    /// The curve Q over this family that ends where a curve P of any type starts: the last control points, one more than
    /// the order of the contact, are computed from the derivatives of P, the others are taken from `points`.
    ///
    /// # Errors
    /// As [`Basis::curve_after`](crate::Basis::curve_after).
    #[cfg(feature = "geometry")]
    fn curve_before<P: Point<Scalar = Self::Scalar>>(
        &self,
        curve: &dyn ParametricCurve<Point = P>,
        contact: Contact<Self::Scalar>,
        points: Self::Points<P>,
    ) -> Result<RationalCurve<Self, P>, CurveError> {
        let derivatives = contact_of(curve, curve.domain()[0], contact, Self::NAME, Self::LEN)?;
        finite(RationalCurve::new(*self, self.end_points(&derivatives, points)?))
    }
}

/// The derivatives of a curve that touches another one at a parameter of that one.
#[cfg(feature = "geometry")]
fn contact_of<P: Point>(
    curve: &dyn ParametricCurve<Point = P>,
    t: P::Scalar,
    contact: Contact<P::Scalar>,
    family: &'static str,
    len: usize,
) -> Result<alloc::vec::Vec<P>, CurveError> {
    if contact.order() >= len {
        return Err(CurveError::Contact { family, most: len.saturating_sub(1), found: contact.order() });
    }
    let mut derivatives = alloc::vec![P::Vector::zero(); contact.order() + 1];
    curve.derivatives_into(t, &mut derivatives);
    contact.transform(&mut derivatives)?;
    Ok(derivatives.into_iter().map(P::from_vector).collect())
}

/// The curve, if its control points are finite.
#[cfg(feature = "geometry")]
fn finite<B: RationalBasis, P: Point<Scalar = B::Scalar>>(
    curve: RationalCurve<B, P>,
) -> Result<RationalCurve<B, P>, CurveError> {
    if curve.control_points().iter().all(|&p| is_finite(p)) { Ok(curve) } else { Err(CurveError::NotFinite) }
}
