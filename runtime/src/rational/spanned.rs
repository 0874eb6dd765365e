//! Families on several spans, and curves over them.

use core::fmt::{self, Debug, Formatter};

use super::{Chart, RationalBasis, RationalCurve};
use crate::curve::same_length;
use crate::{Array, CountError, CurveError, Point, Rounding, Scalar};

/// A family of basis functions `b[0], …, b[LEN - 1]` on several neighbouring spans, with its shape parameters set to
/// values: on each span quotients of polynomials as those of a [`RationalBasis`], polynomials where the denominator is 1.
///
/// [`basis!`](crate::basis!) implements it for families on several spans. Control points are bound in a
/// [`SpannedCurve`].
pub trait SpannedBasis: Copy + PartialEq + Debug {
    /// The type of parameters, values and shape parameters.
    type Scalar: Scalar;

    /// One value for each function: `[Self::Scalar; LEN]`.
    type Values: Array<Self::Scalar> + Point<Scalar = Self::Scalar>;

    /// One element, usually a control point, for each function: `[T; LEN]`.
    type Points<T: Copy>: Array<T>;

    /// One element for each function of the Bernstein basis of the same degree: `[T; DEGREE + 1]`.
    type Bernstein<T: Copy>: Array<T>;

    /// One element for each span: `[T; SPANS]`.
    type Spans<T: Copy>: Array<T>;

    /// The name of the family in its spec.
    const NAME: &'static str;

    /// The number of basis functions.
    const LEN: usize = <Self::Points<()> as Array<()>>::LEN;

    /// The highest degree of numerators and denominators on a span.
    const DEGREE: usize = <Self::Bernstein<()> as Array<()>>::LEN - 1;

    /// The number of spans.
    const SPANS: usize = <Self::Spans<()> as Array<()>>::LEN;

    /// How far each function's computed value can be from the exact one, on all spans, as long as nothing overflows or
    /// underflows. `basis!` proves these bounds with the feature `rounding`; empty where it finds none.
    const ROUNDING: &'static [Rounding] = &[];

    /// How far each component of a point that [`SpannedCurve::eval`](crate::SpannedCurve::eval) computes, binding
    /// included, can be from the exact one: this many ε times the largest absolute value of that component of a control
    /// point, as long as nothing overflows or underflows; `None` where no bound is known.
    const ROUNDING_POINT: Option<f64> = None;

    /// The maps from the spans to `0 <= x <= 1`, in the order of the spans; each ends where the next one begins.
    fn charts(&self) -> Self::Spans<Chart<Self::Scalar>>;

    /// The values of all functions by the formulas of a span.
    fn values_on(&self, span: usize, t: Self::Scalar) -> Self::Values;

    /// The Bernstein coefficients of the numerators on a span, one row for each; see [`RationalBasis::numerators`].
    fn numerators_on(&self, span: usize) -> Self::Bernstein<Self::Values>;

    /// The Bernstein coefficients of the denominator on a span.
    fn denominator_on(&self, span: usize) -> Self::Bernstein<Self::Scalar>;

    /// The two ends `[lo, hi]` of the domain, `lo < hi`.
    #[inline]
    fn domain(&self) -> [Self::Scalar; 2] {
        let charts = self.charts();
        let charts = charts.as_ref();
        [charts[0].domain()[0], charts[Self::SPANS - 1].domain()[1]]
    }

    /// The span in which `t` lies: at an inner knot the later one, below the domain the first, above it the last.
    #[inline]
    fn span_at(&self, t: Self::Scalar) -> usize {
        later(self.charts().as_ref(), t)
    }

    /// The functions on one span, as a family of their own.
    #[inline]
    fn span(&self, index: usize) -> SpanOf<Self> {
        SpanOf { basis: *self, index: index.min(Self::SPANS - 1) }
    }

    /// The values `b[i](t)` of all functions.
    #[inline]
    fn values(&self, t: Self::Scalar) -> Self::Values {
        self.values_on(self.span_at(t), t)
    }

    /// The derivatives `dᵏ b[i] / dtᵏ (t)` of all functions, `k = order`; where they jump those of the later span.
    #[cfg(feature = "alloc")]
    fn derivatives(&self, t: Self::Scalar, order: usize) -> Self::Values {
        self.span(self.span_at(t)).derivatives(t, order)
    }

    /// The curve over these control points, one for each function.
    #[inline]
    fn curve<P: Point<Scalar = Self::Scalar>>(&self, points: Self::Points<P>) -> SpannedCurve<Self, P> {
        SpannedCurve::new(*self, points)
    }
}

/// The last chart that has begun at `t`.
fn later<S: Scalar>(charts: &[Chart<S>], t: S) -> usize {
    charts.iter().skip(1).take_while(|chart| t >= chart.domain()[0]).count()
}

/// One span of a family on several spans, as a family.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SpanOf<B> {
    basis: B,
    index: usize,
}

impl<B: SpannedBasis> RationalBasis for SpanOf<B> {
    type Scalar = B::Scalar;
    type Values = B::Values;
    type Points<T: Copy> = B::Points<T>;
    type Bernstein<T: Copy> = B::Bernstein<T>;

    const NAME: &'static str = B::NAME;

    #[inline]
    fn chart(&self) -> Chart<B::Scalar> {
        self.basis.charts().as_ref()[self.index.min(B::SPANS - 1)]
    }

    #[inline]
    fn values(&self, t: B::Scalar) -> B::Values {
        self.basis.values_on(self.index, t)
    }

    #[inline]
    fn numerators(&self) -> B::Bernstein<B::Values> {
        self.basis.numerators_on(self.index)
    }

    #[inline]
    fn denominator(&self) -> B::Bernstein<B::Scalar> {
        self.basis.denominator_on(self.index)
    }
}

/// The curve `C(t) = Σ b[i](t) P[i]` over control points `P[i]` and functions `b[i]` on several spans.
///
/// On each span it is a [`RationalCurve`]. At an inner knot it is that of the later span; the parameter is not clamped.
/// With the feature `geometry` it answers all that a [`Curve`](crate::Curve) does, and its parts are
/// [`RationalSpline`](crate::RationalSpline) curves.
#[derive(Clone, Copy)]
pub struct SpannedCurve<B: SpannedBasis, P: Point<Scalar = B::Scalar>> {
    basis: B,
    points: B::Points<P>,
    spans: B::Spans<RationalCurve<SpanOf<B>, P>>,
}

impl<B: SpannedBasis, P: Point<Scalar = B::Scalar>> SpannedCurve<B, P> {
    /// The curve of that basis over these control points, one for each basis function.
    pub fn new(basis: B, points: B::Points<P>) -> Self {
        let spans = B::Spans::from_fn(|index| RationalCurve::new(basis.span(index), points));
        Self { basis, points, spans }
    }

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

    /// The curve over the images of all control points: the image under an affine map if the functions sum to 1, and always
    /// under a linear one.
    #[must_use]
    pub fn map<Q: Point<Scalar = B::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> SpannedCurve<B, Q> {
        SpannedCurve::new(self.basis, B::Points::from_fn(|i| image(self.points.as_ref()[i])))
    }

    crate::affine::transform!();

    /// The curves of which it consists, in the order of their domains.
    #[inline]
    pub fn spans(&self) -> &[RationalCurve<SpanOf<B>, P>] {
        self.spans.as_ref()
    }

    /// The curve of the span in which `t` lies, at an inner knot the later one, and its index.
    #[inline]
    pub fn span_at(&self, t: B::Scalar) -> (usize, &RationalCurve<SpanOf<B>, P>) {
        let spans = self.spans();
        let index = spans.iter().skip(1).take_while(|span| t >= span.domain()[0]).count();
        (index, &spans[index])
    }

    /// The point `C(t)`.
    #[inline]
    pub fn eval(&self, t: B::Scalar) -> P {
        self.span_at(t).1.eval(t)
    }

    /// The point `C(t)`, if `t` lies in the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `t` is outside of the domain or NaN, or an end that does not belong to it.
    #[inline]
    pub fn eval_checked(&self, t: B::Scalar) -> Result<P, CurveError> {
        let (_, span) = self.span_at(t);
        span.check(t)?;
        Ok(span.eval(t))
    }

    /// The point and its derivatives with respect to `t`, `[C(t), C'(t), C''(t), …]`, `K` of them; where they jump those of
    /// the later span.
    #[inline]
    pub fn eval_with_derivs<const K: usize>(&self, t: B::Scalar) -> [P::Vector; K] {
        self.span_at(t).1.eval_with_derivs(t)
    }

    /// The points `out[i] = C(ts[i])`.
    ///
    /// Parameters of one span that stand beside each other are evaluated together, as [`RationalCurve::eval_into`] does it.
    ///
    /// # Errors
    /// [`CurveError::Length`] if the slices have different lengths.
    pub fn eval_into(&self, ts: &[B::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        same_length(ts, out)?;
        let len = ts.len();
        let mut done = 0;
        while done < len {
            let (index, span) = self.span_at(ts[done]);
            let same = |t: &B::Scalar| self.span_at(*t).0 == index;
            let count = ts[done..len].iter().take_while(|t| same(t)).count().max(1);
            span.eval_same_length(&ts[done..done + count], &mut out[done..done + count]);
            done += count;
        }
        Ok(())
    }

    /// The point at the lower end of the domain.
    #[inline]
    pub fn start(&self) -> P {
        self.spans()[0].start()
    }

    /// The point at the upper end of the domain.
    #[inline]
    pub fn end(&self) -> P {
        self.spans()[B::SPANS - 1].end()
    }

    /// The two ends `[lo, hi]` of the domain.
    #[inline]
    pub fn domain(&self) -> [B::Scalar; 2] {
        [self.spans()[0].domain()[0], self.spans()[B::SPANS - 1].domain()[1]]
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
}

// All else follows from the basis and the control points.

impl<B: SpannedBasis, P: Point<Scalar = B::Scalar>> PartialEq for SpannedCurve<B, P> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.basis == other.basis && self.control_points() == other.control_points()
    }
}

impl<B: SpannedBasis, P: Point<Scalar = B::Scalar>> Debug for SpannedCurve<B, P> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("SpannedCurve")
            .field("basis", &self.basis)
            .field("control_points", &self.control_points())
            .finish_non_exhaustive()
    }
}
