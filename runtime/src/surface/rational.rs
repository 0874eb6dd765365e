//! Rational tensor surfaces.

use core::ops::Range;

use super::{Direction, partials_by_number};
use crate::numeric::binomial::binomial;
use crate::{
    Array, Basis, BernsteinOf, Curve, CurveError, Point, Scalar, Surface, SurfaceDomain, TensorSurface,
};

/// The surface `S(u, v) = N(u, v) / w(u, v)`, a quotient of two tensor surfaces: one of points, one of numbers.
///
/// With control points `P[i][j]` of weights `w[i][j]`, `N` has the net `w[i][j] P[i][j]` and `w` the net `w[i][j]`. A
/// weight of zero stands for a control point at infinity, whose direction is then in `N`.
///
/// ```
/// use basis_runtime::{BernsteinBasis, RationalSurface, Surface};
///
/// // A quarter of the unit cylinder.
/// let half = 0.5_f64.sqrt();
/// let arc = |x: f64| [[x, 1.0, 0.0], [x, 1.0, 1.0], [x, 0.0, 1.0]];
/// let cylinder = RationalSurface::new(
///     BernsteinBasis::<_, 2>::new(),
///     BernsteinBasis::<_, 3>::new(),
///     [arc(0.0), arc(2.0)],
///     [[1.0, half, 1.0]; 2],
/// );
/// let [x, y, z] = cylinder.eval(0.5, 0.3);
/// assert!(x == 1.0 && (y * y + z * z - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "U: serde::Serialize, V: serde::Serialize, P: serde::Serialize, U::Scalar: serde::Serialize",
        deserialize = "U: serde::Deserialize<'de>, V: serde::Deserialize<'de>, P: serde::Deserialize<'de>, \
                   U::Scalar: serde::Deserialize<'de>"
    ))
)]
pub struct RationalSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    numerator: TensorSurface<U, V, P>,
    weight: TensorSurface<U, V, U::Scalar>,
}

/// A part of a rational surface, as a rational Bézier patch of the same degrees on the unit square.
pub type RationalPatchOf<U, V, P> = RationalSurface<BernsteinOf<U>, BernsteinOf<V>, P>;

impl<U, V, P> RationalSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    /// The surface over these control points with these weights.
    pub fn new(
        u_basis: U,
        v_basis: V,
        net: U::Points<V::Points<P>>,
        weights: U::Points<V::Points<P::Scalar>>,
    ) -> Self {
        let scaled = U::Points::from_fn(|i| {
            V::Points::from_fn(|j| net.as_ref()[i].as_ref()[j].scale(weights.as_ref()[i].as_ref()[j]))
        });
        Self::from_homogeneous(
            TensorSurface::new(u_basis, v_basis, scaled),
            TensorSurface::new(u_basis, v_basis, weights),
        )
    }

    /// The surface `numerator / weight`.
    pub fn from_homogeneous(
        numerator: TensorSurface<U, V, P>,
        weight: TensorSurface<U, V, P::Scalar>,
    ) -> Self {
        Self { numerator, weight }
    }

    /// The surface over the same control points and weights with other shape values, the same in all rows.
    #[must_use]
    pub fn with_bases(&self, u_basis: U, v_basis: V) -> Self {
        let (numerator, weight) = (&self.numerator, &self.weight);
        Self::from_homogeneous(numerator.with_bases(u_basis, v_basis), weight.with_bases(u_basis, v_basis))
    }

    /// The image under an affine map, with the same weights; control points at infinity go to infinity in the image of their
    /// direction.
    #[must_use]
    pub fn map<Q: Point<Scalar = U::Scalar>>(
        &self,
        mut image: impl FnMut(P) -> Q,
    ) -> RationalSurface<U, V, Q> {
        // With f(x) = A x + b the numerator A N + w b is f(N) + (w - 1) f(0).
        let origin = image(P::zero());
        let row = |i: usize| {
            let (numerator, weights) = (&self.numerator.rows()[i], &self.weight.rows()[i]);
            let point = |j: usize| {
                let weight = weights.control_points()[j];
                image(numerator.control_points()[j]).add_weighted(origin, weight - P::Scalar::ONE)
            };
            Curve::new(numerator.basis(), V::Points::from_fn(point))
        };
        RationalSurface {
            numerator: TensorSurface::from_rows(self.numerator.u_basis(), U::Points::from_fn(row)),
            weight: self.weight,
        }
    }

    crate::affine::transform!();

    /// The numerator `N`, whose control points are `w[i][j] P[i][j]`.
    pub fn numerator(&self) -> &TensorSurface<U, V, P> {
        &self.numerator
    }

    /// The denominator `w`, whose control points are the weights.
    pub fn weight(&self) -> &TensorSurface<U, V, P::Scalar> {
        &self.weight
    }

    /// The same surface as a rational Bézier patch of the same degrees, on the unit square.
    #[must_use]
    pub fn to_bezier(&self) -> RationalPatchOf<U, V, P> {
        RationalSurface { numerator: self.numerator.to_bezier(), weight: self.weight.to_bezier() }
    }

    /// The parts below and above a parameter of one direction, each as a rational Bézier patch on the unit square. They
    /// share an edge exactly.
    ///
    /// # Errors
    /// As [`TensorSurface::split`].
    pub fn split(
        &self,
        direction: Direction,
        at: P::Scalar,
    ) -> Result<[RationalPatchOf<U, V, P>; 2], CurveError> {
        let [before, after] = self.numerator.split(direction, at)?;
        let [weight_before, weight_after] = self.weight.split(direction, at)?;
        Ok([
            RationalSurface::from_homogeneous(before, weight_before),
            RationalSurface::from_homogeneous(after, weight_after),
        ])
    }

    /// The part over a rectangle of parameters, as a rational Bézier patch on the unit square; a range with
    /// `start > end` runs backwards.
    ///
    /// # Errors
    /// As [`TensorSurface::subpatch`].
    pub fn subpatch(
        &self,
        u: Range<P::Scalar>,
        v: Range<P::Scalar>,
    ) -> Result<RationalPatchOf<U, V, P>, CurveError> {
        let numerator = self.numerator.subpatch(u.clone(), v.clone())?;
        Ok(RationalSurface { numerator, weight: self.weight.subpatch(u, v)? })
    }

    /// The same surface with one parameter running the other way, as a rational Bézier patch on the unit square; its
    /// normals turn to the other side.
    #[must_use]
    pub fn reversed(&self, direction: Direction) -> RationalPatchOf<U, V, P> {
        RationalSurface {
            numerator: self.numerator.reversed(direction),
            weight: self.weight.reversed(direction),
        }
    }

    #[cfg(not(feature = "alloc"))]
    fn high_partial(&self, _: P::Scalar, _: P::Scalar, _: [usize; 2]) -> P::Vector {
        P::Vector::from_components(|_| P::Scalar::NAN)
    }

    /// A partial derivative of any order.
    #[cfg(feature = "alloc")]
    fn high_partial(&self, u: P::Scalar, v: P::Scalar, [i, j]: [usize; 2]) -> P::Vector {
        let columns = j + 1;
        let mut partials = alloc::vec![P::Vector::zero(); (i + 1) * columns];
        let weights: alloc::vec::Vec<P::Scalar> =
            (0..(i + 1) * columns).map(|n| self.weight.partial(u, v, [n / columns, n % columns])).collect();
        for n in 0..partials.len() {
            let (r, c) = (n / columns, n % columns);
            let mut sum = self.numerator.partial(u, v, [r, c]);
            for a in 0..=r {
                for b in 0..=c {
                    if a + b > 0 {
                        let ways = binomial::<P::Scalar>(r, a) * binomial::<P::Scalar>(c, b);
                        let factor = ways * weights[a * columns + b];
                        sum = sum.add_weighted(partials[(r - a) * columns + c - b], -factor);
                    }
                }
            }
            partials[n] = P::Vector::from_components(|c| sum.component(c) / weights[0]);
        }
        partials[i * columns + j]
    }

    /// The control point `P[i][j]` with its weight; `None` outside of the net, and for a point at infinity.
    pub fn control_point(&self, i: usize, j: usize) -> Option<(P, P::Scalar)> {
        let (point, weight) = (self.numerator.control_point(i, j)?, self.weight.control_point(i, j)?);
        (weight != P::Scalar::ZERO).then(|| (P::from_components(|c| point.component(c) / weight), weight))
    }
}

impl<U, V, P> Surface for RationalSurface<U, V, P>
where
    U: Basis,
    V: Basis<Scalar = U::Scalar>,
    P: Point<Scalar = U::Scalar>,
{
    type Point = P;

    #[inline]
    fn domain(&self) -> SurfaceDomain<P::Scalar> {
        self.numerator.domain()
    }

    #[inline]
    fn eval(&self, u: P::Scalar, v: P::Scalar) -> P {
        let (point, weight) = (self.numerator.eval(u, v), self.weight.eval(u, v));
        P::from_components(|c| point.component(c) / weight)
    }

    /// Orders above 7 need the feature `alloc`; without it they are NaN.
    fn partial(&self, u: P::Scalar, v: P::Scalar, [i, j]: [usize; 2]) -> P::Vector {
        match i.max(j) {
            0 => self.eval(u, v).to_vector(),
            1 => self.eval_with_partials::<2>(u, v)[i][j],
            2..4 => self.eval_with_partials::<4>(u, v)[i][j],
            4..8 => self.eval_with_partials::<8>(u, v)[i][j],
            _ => self.high_partial(u, v, [i, j]),
        }
    }

    partials_by_number!();

    /// By Leibniz' rule for `N = w S`, solved for the highest derivative of `S`.
    fn eval_with_partials<const K: usize>(&self, u: P::Scalar, v: P::Scalar) -> [[P::Vector; K]; K] {
        let mut partials = self.numerator.eval_with_partials::<K>(u, v);
        let weights = self.weight.eval_with_partials::<K>(u, v);
        for i in 0..K {
            for j in 0..K {
                let mut sum = partials[i][j];
                for a in 0..=i {
                    for b in 0..=j {
                        if a + b > 0 {
                            let ways = binomial::<P::Scalar>(i, a) * binomial::<P::Scalar>(j, b);
                            let factor = ways * weights[a][b];
                            sum = sum.add_weighted(partials[i - a][j - b], -factor);
                        }
                    }
                }
                partials[i][j] = P::Vector::from_components(|c| sum.component(c) / weights[0][0]);
            }
        }
        partials
    }
}
