//! What a family of basis functions provides: the trait that generated types implement.

use core::fmt::Debug;

use crate::curve::{End, eliminate, touching};
use crate::domain::{inverse_width, unit};
use crate::form::{Form, bernstein_derivative};
use crate::matrices::{self, Kind};
use crate::{
    BernsteinBasis, Contact, Curve, CurveError, Point, Scalar, TriangularBasis, TriangularBernsteinBasis,
};

/// An array `[T; N]` of a length that a [`Basis`] has fixed.
///
/// Stable Rust has no `[T; B::LEN]` in generic code; associated types with this trait as their bound stand in for it.
/// [`AsRef`] and [`AsMut`] give the slice.
pub trait Array<T>: Copy + AsRef<[T]> + AsMut<[T]> + sealed::Sealed {
    /// The number of elements.
    const LEN: usize;

    /// The Bernstein basis with as many functions as the array has elements.
    type Basis<S: Scalar>: Basis<Scalar = S> + Default;

    /// The Bernstein basis on a triangle with as many functions as the array has elements, `N` of them on each edge.
    type Triangle<S: Scalar, const N: usize>: TriangularBasis<Scalar = S> + Default;

    /// The Bernstein basis on a triangle with as many functions on each edge as this array has elements, in all as many
    /// as the array `A`.
    type OnTriangle<S: Scalar, A: Array<()>>: TriangularBasis<Scalar = S> + Default;

    /// The array `[element(0), …, element(LEN - 1)]`.
    fn from_fn(element: impl FnMut(usize) -> T) -> Self;
}

impl<T: Copy, const N: usize> Array<T> for [T; N] {
    const LEN: usize = N;
    type Basis<S: Scalar> = BernsteinBasis<S, N>;
    type Triangle<S: Scalar, const M: usize> = TriangularBernsteinBasis<S, M, N>;
    type OnTriangle<S: Scalar, A: Array<()>> = A::Triangle<S, N>;

    #[inline]
    fn from_fn(element: impl FnMut(usize) -> T) -> Self {
        core::array::from_fn(element)
    }
}

mod sealed {
    pub trait Sealed {}
    impl<T, const N: usize> Sealed for [T; N] {}
}

/// How far the computed value of a function may be from the exact one, in units of ε: the distance from 1 to the next
/// float, [`f32::EPSILON`] or [`f64::EPSILON`].
///
/// A bound holds for all parameters in the domain and all shape values in their ranges, with fused operations or
/// without, as long as nothing overflows or underflows. `basis!` proves it while a crate is compiled. Of families with
/// angles or exponentials it assumes that the sines, cosines and exponentials of [`Scalar`] are within one unit in the last
/// place, as those of the standard library are on common machines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rounding {
    /// At most this many ε times the value: a value that is 0 is computed as 0.
    Relative(f64),
    /// At most this many ε.
    Absolute(f64),
    /// Nothing is proved.
    Unknown,
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

    /// The proved bounds of the rounding errors of [`values`](Self::values), one for each function; of families that
    /// were written by hand, and without the feature `rounding`, there are none.
    const ROUNDING: &'static [Rounding] = &[];

    /// A proved bound of the rounding error of each component of a point of a curve, binding included, in ε times the
    /// largest absolute value of that component of a control point; `None` where none is known.
    const ROUNDING_POINT: Option<f64> = None;

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

    /// The values of all functions at many points, and their derivatives up to that order in the parameter: what
    /// [`values`](Self::values) and [`derivatives`](Self::derivatives) give, with everything that does not depend on the
    /// points computed once.
    #[cfg(feature = "elements")]
    fn tabulate(&self, at: &[Self::Scalar], order: usize) -> crate::Tabulation<Self::Scalar, [usize; 1]> {
        crate::elements::tabulate_interval(self, at, order)
    }

    /// Which functions belong to the lower end, the corner 0, to the upper end, the corner 1, or to the inside.
    #[cfg(feature = "elements")]
    fn entities(&self) -> crate::Entities {
        crate::elements::in_cell(
            self.bernstein_weights().as_ref(),
            &[crate::elements::Factor::interval(Self::DEGREE)],
        )
    }

    /// The nodes of the family, one point for each function, at which it has the value 1 and all others are 0, up to
    /// rounding errors: nodes on the boundary lie on it exactly. `None` if there are none, or if the functions do not span
    /// the parameter.
    #[cfg(feature = "elements")]
    fn nodes(&self) -> Option<Self::Points<Self::Scalar>> {
        crate::elements::interval_nodes(self)
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

    /// The mass matrix: the integrals `∫ b[i] b[j]` over the domain, row by row.
    ///
    /// Those of the Bernstein polynomials are fractions, and the matrix is `cᵀ G c` with the
    /// [`bernstein_weights`](Self::bernstein_weights) `c`.
    #[must_use]
    fn mass_matrix(&self) -> Self::Points<Self::Values> {
        matrices::interval(Kind::Mass, self.bernstein_weights().as_ref(), Self::domain())
    }

    /// The stiffness matrix: the integrals `∫ b'[i] b'[j]` over the domain, row by row.
    #[must_use]
    fn stiffness_matrix(&self) -> Self::Points<Self::Values> {
        matrices::interval(Kind::Stiffness, self.bernstein_weights().as_ref(), Self::domain())
    }

    /// The control points of a curve with the derivatives `[C, C', …]` at the start of the domain: the first points, as
    /// many as there are derivatives, are replaced by the solution of `Σ_i b[i]⁽ᵏ⁾(lo) points[i] = derivatives[k]`.
    ///
    /// A generated family has the solution up to the second derivative as formulas, in which other points than the
    /// first are replaced where those do not matter; all else is solved by elimination.
    ///
    /// # Errors
    /// [`CurveError::Join`] if these control points do not determine the derivatives: some families have shape values
    /// at which their derivative at the start is zero.
    #[inline]
    fn start_points<P: Point<Scalar = Self::Scalar>>(
        &self,
        derivatives: &[P],
        points: Self::Points<P>,
    ) -> Result<Self::Points<P>, CurveError> {
        eliminate(self, derivatives, points, End::Start)
    }

    /// As [`start_points`](Self::start_points) for the derivatives at the end of the domain and the last points.
    ///
    /// # Errors
    /// As [`start_points`](Self::start_points).
    #[inline]
    fn end_points<P: Point<Scalar = Self::Scalar>>(
        &self,
        derivatives: &[P],
        points: Self::Points<P>,
    ) -> Result<Self::Points<P>, CurveError> {
        eliminate(self, derivatives, points, End::Last)
    }

    /// The curve Q over this family that continues a curve P of any family where that ends: the first control points,
    /// one more than the order of the contact, are computed from the derivatives of P, the others are taken from
    /// `points`.
    ///
    /// ```
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
    /// # fn main() -> Result<(), Box<dyn core::error::Error>> {
    /// use basis_runtime::{Basis, Contact, Curve};
    ///
    /// let first = Curve::new(QuarticBernstein::new(0.5)?, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// let free = [[0.0, 0.0], [0.0, 0.0], [7.0, 0.0], [8.0, 1.0]]; // the first two will be replaced
    /// let next = QuarticBernstein::new(-1.0)?.curve_after(&first, Contact::Tangent { f: 1.0 }, free)?;
    /// assert_eq!(next.control_points(), [[4.0, 0.0], [5.75, -3.5], [7.0, 0.0], [8.0, 1.0]]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`CurveError::Factor`] if `f` is not positive or a factor not finite, [`CurveError::Contact`] if the order of
    /// the contact is not below the number of control points, [`CurveError::NotFinite`] if a computed point is not
    /// finite, [`CurveError::Join`] if the first control points do not determine the derivatives, see
    /// [`start_points`](Self::start_points).
    fn curve_after<B: Basis<Scalar = Self::Scalar>, P: Point<Scalar = Self::Scalar>>(
        &self,
        curve: &Curve<B, P>,
        contact: Contact<Self::Scalar>,
        points: Self::Points<P>,
    ) -> Result<Curve<Self, P>, CurveError> {
        Ok(Curve::new(*self, touching(self, curve, contact, points, End::Start)?))
    }

    /// The curve Q over this family that ends where a curve P of any family starts: the last control points, one more
    /// than the order of the contact, are computed from the derivatives of P, the others are taken from `points`.
    ///
    /// ```
    /// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/numeric/families/quartic_bernstein.rs"));
    /// # fn main() -> Result<(), Box<dyn core::error::Error>> {
    /// use basis_runtime::{Basis, Contact, Curve};
    ///
    /// let last = Curve::new(QuarticBernstein::new(0.5)?, [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]);
    /// let free = [[-4.0, 0.0], [-3.0, 1.0], [0.0, 0.0], [0.0, 0.0]]; // the last two will be replaced
    /// let first = QuarticBernstein::new(-1.0)?.curve_before(&last, Contact::Tangent { f: 1.0 }, free)?;
    /// assert_eq!(first.control_points(), [[-4.0, 0.0], [-3.0, 1.0], [-1.75, -3.5], [0.0, 0.0]]);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`curve_after`](Self::curve_after), for the last control points.
    fn curve_before<B: Basis<Scalar = Self::Scalar>, P: Point<Scalar = Self::Scalar>>(
        &self,
        curve: &Curve<B, P>,
        contact: Contact<Self::Scalar>,
        points: Self::Points<P>,
    ) -> Result<Curve<Self, P>, CurveError> {
        Ok(Curve::new(*self, touching(self, curve, contact, points, End::Last)?))
    }
}

/// `Σ weight · point`, from the first term to the last.
#[inline]
pub(crate) fn combination<P: Point>(mut terms: impl Iterator<Item = (P, P::Scalar)>) -> P {
    let Some((point, weight)) = terms.next() else { return P::zero() };
    terms.fold(point.scale(weight), |sum, (point, weight)| sum.add_weighted(point, weight))
}
