//! What a family of rational basis functions provides: the trait that generated types implement.

use core::fmt::Debug;

use super::series::{Room, derivatives};
use super::{Chart, RationalCurve};
use crate::basis::combination;
use crate::{Array, Point, Rounding, Scalar};

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
}
