//! Curves over rational families.

use core::fmt::{self, Debug, Formatter};

use super::series::{Room, Side, derivatives};
use super::slices::RationalPoints;
use super::{Chart, RationalBasis};
use crate::basis::combination;
use crate::curve::same_length;
use crate::form::MOST_COMPONENTS;
use crate::numeric::binomial::row;
use crate::numeric::simd::{WORTHWHILE, dispatch};
use crate::vector::vectors;
use crate::{Array, CountError, CurveError, Point, Scalar};

/// The curve `C(t) = Σ b[i](t) P[i]` over control points `P[i]` and rational functions `b[i]`.
///
/// The basis functions are bound to the control points once, in [`RationalCurve::new`]: a point is then the quotient of
/// two polynomials in Bernstein form, the one over points, the other over weights. The parameter is not clamped: outside
/// of the domain the formula is continued, up to the zeros of its denominator.
///
/// With the feature `geometry` it answers all that a [`Curve`](crate::Curve) does, by
/// [`ParametricCurve`](crate::ParametricCurve); its parts are [`RationalBezier`](crate::RationalBezier) curves.
///
/// ```
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/rational_quadratic.rs"));
/// # fn main() -> Result<(), basis_runtime::ShapeError> {
/// use basis_runtime::RationalCurve;
///
/// // A quarter of the unit circle: the weight of the middle point is the cosine of half of its angle.
/// let family = RationalQuadratic::new(0.5_f64.sqrt())?;
/// let circle = RationalCurve::new(family, [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
/// let [x, y] = circle.eval(0.3);
/// assert!((x.hypot(y) - 1.0_f64).abs() < 1e-15);
/// assert_eq!([circle.eval(0.0), circle.eval(1.0)], [[1.0, 0.0], [0.0, 1.0]]);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy)]
pub struct RationalCurve<B: RationalBasis, P: Point<Scalar = B::Scalar>> {
    basis: B,
    points: B::Points<P>,
    chart: Chart<B::Scalar>,
    /// The Bernstein coefficients, times the binomial coefficients, of the numerator and the denominator.
    numerator: B::Bernstein<P>,
    denominator: B::Bernstein<B::Scalar>,
    side: Side,
    ends: [P; 2],
}

impl<B: RationalBasis, P: Point<Scalar = B::Scalar>> RationalCurve<B, P> {
    /// The curve over control points in a slice, one for each basis function.
    ///
    /// # Errors
    /// If the number of points is not the number of functions.
    pub fn from_slice(basis: B, points: &[P]) -> Result<Self, CountError> {
        Ok(Self::new(basis, CountError::one_each(B::NAME, points)?))
    }

    /// The curve over the same control points with other shape values.
    #[must_use]
    pub fn with_basis(&self, basis: B) -> Self {
        Self::new(basis, self.points)
    }

    /// The curve over the images of all control points: the image under an affine map if the functions sum to 1, and
    /// always under a linear one.
    #[must_use]
    pub fn map<Q: Point<Scalar = B::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> RationalCurve<B, Q> {
        RationalCurve::new(self.basis, B::Points::from_fn(|i| image(self.points.as_ref()[i])))
    }

    crate::affine::transform!();

    /// The curve of that basis over these control points, one for each basis function.
    pub fn new(basis: B, points: B::Points<P>) -> Self {
        let chart = basis.chart();
        let (mut numerator, mut denominator) = (basis.to_bernstein(&points), basis.denominator());
        let side = Side::of(denominator.as_ref());
        let parts = numerator.as_mut().iter_mut().zip(denominator.as_mut());
        for ((point, weight), binomial) in parts.zip(row(B::DEGREE)) {
            let binomial = B::Scalar::of(binomial);
            *point = point.scale(binomial);
            *weight = *weight * binomial;
        }
        let ends = chart.domain().map(|end| {
            let weights = basis.values(end);
            combination(points.as_ref().iter().copied().zip(weights.as_ref().iter().copied()))
        });
        Self { basis, points, chart, numerator, denominator, side, ends }
    }

    /// The side of 0 on which the denominator is.
    pub(crate) const fn side(&self) -> Side {
        self.side
    }

    /// The point `C(t)`.
    ///
    /// At both ends of the domain it equals [`start`](Self::start) and [`end`](Self::end). Where the Bernstein coefficients
    /// of the denominator have both signs and it is smaller than its rounding error, the point may be infinite or NaN.
    #[inline]
    pub fn eval(&self, t: B::Scalar) -> P {
        let [s, x] = self.chart.coordinates(t);
        if x == B::Scalar::ZERO {
            return self.ends[0];
        }
        if s == B::Scalar::ZERO {
            return self.ends[1];
        }
        let weight = self.side.keep(nested(self.denominator.as_ref(), s, x));
        let point = nested(self.numerator.as_ref(), s, x);
        P::from_components(|d| point.component(d) / weight)
    }

    /// The point `C(t)`, if `t` lies in the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `t` is outside of the domain or NaN, or an end that does not belong to it.
    #[inline]
    pub fn eval_checked(&self, t: B::Scalar) -> Result<P, CurveError> {
        self.check(t)?;
        Ok(self.eval(t))
    }

    /// # Errors
    /// [`CurveError::Parameter`] if `t` does not lie in the domain.
    pub(crate) fn check(&self, t: B::Scalar) -> Result<(), CurveError> {
        if self.chart.contains(t) {
            return Ok(());
        }
        Err(CurveError::Parameter { value: t.to_f64(), domain: self.domain().map(Scalar::to_f64) })
    }

    /// The numerator as vectors, of which derivatives are computed.
    #[inline]
    pub(super) fn numerator_vectors(&self) -> B::Bernstein<P::Vector> {
        vectors(self.to_bernstein().as_ref())
    }

    /// The point and its derivatives with respect to `t`, `[C(t), C'(t), C''(t), …]`, `K` of them.
    #[inline]
    pub fn eval_with_derivs<const K: usize>(&self, t: B::Scalar) -> [P::Vector; K] {
        let (mut curve, mut out) = ([P::Vector::zero(); K], [P::Vector::zero(); K]);
        let (mut weight, mut map) = ([B::Scalar::ZERO; K], [B::Scalar::ZERO; K]);
        let room = Room { curve: &mut curve, weight: &mut weight, map: &mut map };
        let (mut numerator, mut denominator) = (self.numerator_vectors(), self.basis.denominator());
        derivatives(numerator.as_mut(), denominator.as_mut(), &self.chart, t, room, &mut out);
        if let Some(point) = out.first_mut() {
            *point = self.eval(t).to_vector();
        }
        out
    }

    /// The points `out[i] = C(ts[i])`.
    ///
    /// From 16 points on they are computed with the widest vector instructions of the processor, sines and exponentials
    /// included, for less than what one sine and cosine of the standard library costs. The ends stay exact. Results can differ
    /// from [`eval`](Self::eval) in the last digits.
    ///
    /// # Errors
    /// [`CurveError::Length`] if the slices have different lengths.
    pub fn eval_into(&self, ts: &[B::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        same_length(ts, out)?;
        self.eval_same_length(ts, out);
        Ok(())
    }

    /// The points `out[i] = C(ts[i])` of slices of one length.
    pub(super) fn eval_same_length(&self, ts: &[B::Scalar], out: &mut [P]) {
        let len = ts.len();
        if len < WORTHWHILE || P::DIM > MOST_COMPONENTS {
            for (out, &t) in out.iter_mut().zip(ts) {
                *out = self.eval(t);
            }
            return;
        }
        let (numerator, denominator) = (self.numerator.as_ref(), self.denominator.as_ref());
        dispatch(len, RationalPoints { curve: self, numerator, denominator, ts, out });
    }

    /// The point at the lower end of the domain.
    #[inline]
    pub fn start(&self) -> P {
        self.ends[0]
    }

    /// The point at the upper end of the domain.
    #[inline]
    pub fn end(&self) -> P {
        self.ends[1]
    }

    /// The two ends `[lo, hi]` of the domain.
    #[inline]
    pub fn domain(&self) -> [B::Scalar; 2] {
        self.chart.domain()
    }

    /// The map from the domain to the parameter `0 <= x <= 1` in which the curve is a rational Bézier curve.
    #[inline]
    pub fn chart(&self) -> Chart<B::Scalar> {
        self.chart
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

    /// The Bernstein coefficients of the numerator of the curve; those of the denominator are
    /// [`RationalBasis::denominator`].
    #[inline]
    pub fn to_bernstein(&self) -> B::Bernstein<P> {
        self.basis.to_bernstein(&self.points)
    }
}

/// `Σ_j c[j] s^(n-j) x^j`, nested in `s`.
#[inline]
fn nested<P: Point>(coefficients: &[P], s: P::Scalar, x: P::Scalar) -> P {
    let Some((&first, rest)) = coefficients.split_first() else { return P::zero() };
    let mut power = P::Scalar::ONE;
    rest.iter().fold(first, |sum, &c| {
        power = power * x;
        sum.scale(s).add_weighted(c, power)
    })
}

// All else follows from the basis and the control points.

impl<B: RationalBasis, P: Point<Scalar = B::Scalar>> PartialEq for RationalCurve<B, P> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.basis == other.basis && self.control_points() == other.control_points()
    }
}

impl<B: RationalBasis, P: Point<Scalar = B::Scalar>> Debug for RationalCurve<B, P> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("RationalCurve")
            .field("basis", &self.basis)
            .field("control_points", &self.control_points())
            .finish_non_exhaustive()
    }
}
