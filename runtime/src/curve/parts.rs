//! Parts of curves and other directions: split, subsegment, reverse, Bézier form, degree elevation.

use core::ops::Range;

use crate::bernstein;
use crate::domain::unit;
use crate::vector::vectors;
use crate::{Array, Basis, BernsteinBasis, BernsteinOf, Curve, CurveError, Point, Scalar};

/// A Bézier curve with `N` control points, of degree `N - 1`, on `0 <= t <= 1`.
///
/// ```
/// use basis_runtime::Bezier;
///
/// let cubic = Bezier::from_points([[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
/// assert_eq!(cubic.eval(0.5), [2.0, 1.5]);
/// ```
pub type Bezier<P, const N: usize> = Curve<BernsteinBasis<<P as Point>::Scalar, N>, P>;

impl<P: Point, const N: usize> Bezier<P, N> {
    /// The Bézier curve over these control points, `N >= 1`.
    #[inline]
    pub fn from_points(points: [P; N]) -> Self {
        Self::new(BernsteinBasis::new(), points)
    }
}

/// A part of a curve of the family `B`, as a Bézier curve of the same degree.
///
/// Families with shape parameters are not closed under subdivision; all of them are parts of Bézier curves.
pub type BezierOf<B, P> = Curve<BernsteinOf<B>, P>;

impl<B: Basis, P: Point<Scalar = B::Scalar>> Curve<B, P> {
    /// The same curve as a Bézier curve of the same degree, on `0 <= x <= 1`: it is `C(lo + (hi - lo) x)`.
    ///
    /// ```
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
    /// # fn main() -> Result<(), basis_runtime::ShapeError> {
    /// use basis_runtime::{Bezier, Curve};
    ///
    /// let curve = Curve::new(QuarticBernstein::new(0.5)?, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// let bezier: Bezier<[f64; 2], 5> = curve.to_bezier();
    /// assert_eq!(bezier.eval(0.25), curve.eval(0.25));
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    #[inline]
    pub fn to_bezier(&self) -> BezierOf<B, P> {
        bezier::<B, P>(self.to_bernstein().as_ref())
    }

    /// The same curve as a Bézier curve with `N` control points, of degree `N - 1`.
    ///
    /// `N` must be greater than the degree of the family; this is checked when the call is compiled.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let parabola = Bezier::from_points([0.0, 6.0, 3.0]);
    /// assert_eq!(parabola.elevate::<4>().control_points(), [0.0, 4.0, 5.0, 3.0]);
    /// ```
    #[must_use]
    pub fn elevate<const N: usize>(&self) -> Bezier<P, N> {
        const { assert!(N > B::DEGREE, "degree elevation cannot lower the degree") };
        let mut points = [P::zero(); N];
        bernstein::elevate(self.to_bernstein().as_ref(), &mut points);
        Bezier::from_points(points)
    }

    /// The two parts of the curve before and after `t`, each on `0 <= x <= 1`.
    ///
    /// The end of the first is the start of the second, and both are `C(t)` up to rounding.
    ///
    /// ```
    /// use basis_runtime::Bezier;
    ///
    /// let [left, right] = Bezier::from_points([0.0, 8.0, 4.0]).split(0.5)?;
    /// assert_eq!(left.control_points(), [0.0, 4.0, 5.0]);
    /// assert_eq!(right.control_points(), [5.0, 6.0, 4.0]);
    /// # Ok::<(), basis_runtime::CurveError>(())
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if `t` is outside of the domain or NaN, [`CurveError::AtEnd`] at an end of it, where
    /// one part would be a point.
    pub fn split(&self, t: B::Scalar) -> Result<[BezierOf<B, P>; 2], CurveError> {
        divisible(B::domain(), t)?;
        let [_, x] = unit(B::domain(), t);
        let mut left = self.to_bernstein();
        let mut right = left;
        bernstein::split(left.as_mut(), x, right.as_mut());
        Ok([bezier::<B, P>(left.as_ref()), bezier::<B, P>(right.as_ref())])
    }

    /// The part of the curve over a range of parameters, on `0 <= x <= 1`: `C(start + (end - start) x)`.
    ///
    /// If `range.start > range.end` it runs backwards. Where the range ends at an end of the domain, so does the part,
    /// exactly.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if an end of the range is outside of the domain or NaN, [`CurveError::EmptyRange`] if
    /// both ends are equal.
    pub fn subsegment(&self, range: Range<B::Scalar>) -> Result<BezierOf<B, P>, CurveError> {
        nonempty(B::domain(), &range)?;
        let [_, from] = unit(B::domain(), range.start);
        let [_, to] = unit(B::domain(), range.end);
        let mut points = self.to_bernstein();
        bernstein::restrict(points.as_mut(), from, to);
        Ok(bezier::<B, P>(points.as_ref()))
    }

    /// The same curve in the other direction, on `0 <= x <= 1`: `C(hi - (hi - lo) x)`.
    #[must_use]
    pub fn reversed(&self) -> BezierOf<B, P> {
        let mut points = self.to_bernstein();
        points.as_mut().reverse();
        bezier::<B, P>(points.as_ref())
    }

    /// The derivative `C'(t)` as a curve over the domain scaled to `0 <= x <= 1`, written with the degree of `C`.
    #[must_use]
    pub fn hodograph(&self) -> BezierOf<B, P::Vector> {
        let mut points: B::Bernstein<P::Vector> = vectors(self.to_bernstein().as_ref());
        let scale = crate::domain::inverse_width(B::domain());
        let len = bernstein::differentiate(points.as_mut()).len();
        let derivative = points;
        bernstein::elevate(&derivative.as_ref()[..len], points.as_mut());
        for point in points.as_mut() {
            *point = point.scale(scale);
        }
        bezier::<B, P::Vector>(points.as_ref())
    }
}

/// The error of a parameter outside of a domain, or NaN.
pub(crate) fn inside<S: Scalar>([lo, hi]: [S; 2], t: S) -> Result<(), CurveError> {
    if t >= lo && t <= hi {
        Ok(())
    } else {
        Err(CurveError::Parameter { value: t.to_f64(), domain: [lo.to_f64(), hi.to_f64()] })
    }
}

/// The error of a parameter at which a curve over a domain has not two parts.
pub(crate) fn divisible<S: Scalar>(domain: [S; 2], t: S) -> Result<(), CurveError> {
    inside(domain, t)?;
    if domain.contains(&t) { Err(CurveError::AtEnd { parameter: t.to_f64() }) } else { Ok(()) }
}

/// The error of a range of parameters over which there is no part of a curve.
pub(crate) fn nonempty<S: Scalar>(domain: [S; 2], range: &Range<S>) -> Result<(), CurveError> {
    inside(domain, range.start)?;
    inside(domain, range.end)?;
    if range.start == range.end { Err(CurveError::EmptyRange { at: range.start.to_f64() }) } else { Ok(()) }
}

/// The Bézier curve over as many control points as the degree of the family asks for.
fn bezier<B: Basis, P: Point<Scalar = B::Scalar>>(points: &[P]) -> BezierOf<B, P> {
    Curve::new(BernsteinOf::<B>::default(), <BernsteinOf<B> as Basis>::Points::<P>::from_fn(|i| points[i]))
}
