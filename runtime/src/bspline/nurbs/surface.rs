//! Rational B-spline surfaces.

use alloc::vec::Vec;
use core::ops::Range;

use super::curve::within;
use super::homogeneous::check_weights;
use crate::bspline::slices::Lines;
use crate::bspline::{
    BSplineSurface, BezierPatch, Direction, Edge, Homogeneous, KnotError, KnotVector, Net, NurbsCurve,
    SplineError,
};
use crate::numeric::binomial::binomial;
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::surface::{one_for_each, partials_by_number};
use crate::{BoundedSurface, CurveError, Point, Scalar, Surface, SurfaceDomain, SurfacePiece};

/// The rational surface `S(u, v) = Σ w[i,j] N[i](u) N[j](v) P[i,j] / Σ w[i,j] N[i](u) N[j](v)` with positive weights.
///
/// It is kept as a [`BSplineSurface`] of [`Homogeneous`] points.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::bspline::RationalSurface<P>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
pub struct NurbsSurface<P: Point> {
    homogeneous: BSplineSurface<Homogeneous<P>>,
}

impl<P: Point> NurbsSurface<P> {
    /// The surface with this net and these weights.
    ///
    /// # Errors
    /// If a size does not fit the knots, or a weight is not positive and finite.
    pub fn new(
        u: KnotVector<P::Scalar>,
        v: KnotVector<P::Scalar>,
        net: &Net<P>,
        weights: &Net<P::Scalar>,
    ) -> Result<Self, SplineError> {
        let (expected, found) = ([net.rows(), net.columns()], [weights.rows(), weights.columns()]);
        if expected != found {
            return Err(SplineError::Size { expected, found });
        }
        check_weights(weights.as_slice(), net.as_slice().len())?;
        let points = net.as_slice().iter().zip(weights.as_slice());
        let points = points.map(|(&point, &weight)| Homogeneous::new(point, weight)).collect();
        Ok(Self { homogeneous: BSplineSurface::new(u, v, Net::trusted(points, net.columns()))? })
    }

    /// The surface that this polynomial surface over homogeneous points stands for.
    ///
    /// # Errors
    /// [`SplineError::Weight`] if a weight is not positive and finite.
    pub fn from_homogeneous(homogeneous: BSplineSurface<Homogeneous<P>>) -> Result<Self, SplineError> {
        let weights: Vec<_> = homogeneous.net().as_slice().iter().map(|point| point.weight).collect();
        check_weights(&weights, weights.len())?;
        Ok(Self { homogeneous })
    }

    /// The image under an affine map: the surface with the images of all control points and the same weights.
    pub fn map<Q: Point<Scalar = P::Scalar>>(&self, mut image: impl FnMut(P) -> Q) -> NurbsSurface<Q> {
        let homogeneous = self.homogeneous.map(|p| Homogeneous::new(image(p.project()), p.weight));
        NurbsSurface { homogeneous }
    }

    crate::affine::transform!();

    /// The same surface over homogeneous points.
    #[inline]
    pub fn homogeneous(&self) -> &BSplineSurface<Homogeneous<P>> {
        &self.homogeneous
    }

    /// The degrees in both directions.
    #[inline]
    pub fn degrees(&self) -> [usize; 2] {
        self.homogeneous.degrees()
    }

    /// The knots in one direction.
    #[inline]
    pub fn knots(&self, direction: Direction) -> &KnotVector<P::Scalar> {
        self.homogeneous.knots(direction)
    }

    /// The control points, without their weights.
    pub fn net(&self) -> Net<P> {
        self.homogeneous.net().map(|point| point.project())
    }

    /// The weights.
    pub fn weights(&self) -> Net<P::Scalar> {
        self.homogeneous.net().map(|point| point.weight)
    }

    /// The rectangle of the parameters.
    #[inline]
    pub fn domain(&self) -> SurfaceDomain<P::Scalar> {
        self.homogeneous.domain()
    }

    /// The point `S(u, v)`.
    #[inline]
    pub fn eval(&self, u: P::Scalar, v: P::Scalar) -> P {
        self.homogeneous.eval(u, v).project()
    }

    /// The same surface over the knots of one direction and all of `knots`.
    ///
    /// # Errors
    /// As [`BSplineSurface::insert_knots`].
    pub fn insert_knots(&self, direction: Direction, knots: &[P::Scalar]) -> Result<Self, KnotError> {
        Ok(Self { homogeneous: self.homogeneous.insert_knots(direction, knots)? })
    }

    /// The same surface with a degree that is higher by one in that direction.
    ///
    /// # Errors
    /// As [`BSplineSurface::elevate`].
    pub fn elevate(&self, direction: Direction) -> Result<Self, KnotError> {
        Ok(Self { homogeneous: self.homogeneous.elevate(direction)? })
    }

    /// The parts below and above a parameter of one direction, each over its part of the domain.
    ///
    /// # Errors
    /// As [`BSplineSurface::split`].
    pub fn split(&self, direction: Direction, at: P::Scalar) -> Result<[Self; 2], CurveError> {
        Ok(self.homogeneous.split(direction, at)?.map(|homogeneous| Self { homogeneous }))
    }

    /// The part over a rectangle of parameters, which is its domain; a range with `start > end` runs backwards, over the
    /// same part of the domain.
    ///
    /// # Errors
    /// As [`BSplineSurface::subpatch`].
    pub fn subpatch(&self, u: Range<P::Scalar>, v: Range<P::Scalar>) -> Result<Self, CurveError> {
        Ok(Self { homogeneous: self.homogeneous.subpatch(u, v)? })
    }

    /// Removes an inner knot up to `times` times while no point of the surface moves by more than `tolerance`; returns
    /// the surface and how often the knot was removed.
    ///
    /// # Errors
    /// [`KnotError::NoInnerKnot`].
    pub fn remove_knot(
        &self,
        direction: Direction,
        knot: P::Scalar,
        times: usize,
        tolerance: P::Scalar,
    ) -> Result<(Self, usize), KnotError> {
        let within = within(self.homogeneous.net().as_slice(), tolerance);
        let (homogeneous, removed) = self.homogeneous.remove_knot_if(direction, knot, times, within)?;
        Ok(Self::from_homogeneous(homogeneous).map_or((self.clone(), 0), |surface| (surface, removed)))
    }

    /// The pieces, one for each pair of spans, as rational Bézier surfaces; those with the lowest `u` first.
    pub fn to_bezier(&self) -> Vec<BezierPatch<Homogeneous<P>>> {
        self.homogeneous.to_bezier()
    }

    /// The curve on which one parameter is constant; `direction` is that of the constant parameter.
    pub fn isocurve(&self, direction: Direction, at: P::Scalar) -> NurbsCurve<P> {
        let homogeneous = self.homogeneous.isocurve(direction, at);
        NurbsCurve::trusted(homogeneous)
    }

    /// The boundary curve along an edge.
    pub fn boundary(&self, edge: Edge) -> NurbsCurve<P> {
        NurbsCurve::trusted(self.homogeneous.boundary(edge))
    }

    /// The same surface with the middle of each span of one direction as a new knot.
    pub fn refined(&self, direction: Direction) -> Self {
        Self { homogeneous: self.homogeneous.refined(direction) }
    }

    /// The same surface with clamped knots in both directions.
    pub fn clamped(&self) -> Self {
        Self { homogeneous: self.homogeneous.clamped() }
    }

    /// Two surfaces over the same clamped knot vectors: degrees are raised and knots inserted, no point changes.
    ///
    /// # Errors
    /// As [`BSplineSurface::merged`].
    pub fn merged(&self, other: &Self) -> Result<[Self; 2], KnotError> {
        Ok(self.homogeneous.merged(&other.homogeneous)?.map(|homogeneous| Self { homogeneous }))
    }

    /// The same surface with the two parameters exchanged; its normals turn to the other side.
    pub fn transposed(&self) -> Self {
        Self { homogeneous: self.homogeneous.transposed() }
    }

    /// The same surface with one parameter running the other way; its normals turn to the other side.
    #[must_use]
    pub fn reversed(&self, direction: Direction) -> Self {
        Self { homogeneous: self.homogeneous.reversed(direction) }
    }
}

impl<P: Point> From<BSplineSurface<P>> for NurbsSurface<P> {
    /// The same surface, with all weights 1.
    fn from(surface: BSplineSurface<P>) -> Self {
        let homogeneous = surface.map(|point| Homogeneous::new(point, P::Scalar::ONE));
        Self { homogeneous }
    }
}

impl<P: Point> Surface for NurbsSurface<P> {
    type Point = P;

    fn domain(&self) -> SurfaceDomain<P::Scalar> {
        self.domain()
    }

    fn eval(&self, u: P::Scalar, v: P::Scalar) -> P {
        self.eval(u, v)
    }

    /// Leibniz' rule for the numerator `A = w S`, solved for the derivative of the highest order.
    fn partial(&self, u: P::Scalar, v: P::Scalar, [i, j]: [usize; 2]) -> P::Vector {
        let columns = j + 1;
        let part = |n: usize| self.homogeneous.partial(u, v, [n / columns, n % columns]);
        let parts: Vec<Homogeneous<P::Vector>> = (0..(i + 1) * columns).map(part).collect();
        let mut partials = alloc::vec![P::Vector::zero(); parts.len()];
        quotients(&parts, columns, &mut partials);
        partials[i * columns + j]
    }

    fn eval_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        one_for_each([us.len(), vs.len()], out)?;
        if vs.is_empty() {
            return Ok(());
        }
        let [u, v] = [Direction::U, Direction::V].map(|direction| self.knots(direction));
        let mut lines = Lines::new([u, v], self.homogeneous.net(), us, vs);
        let mut line = alloc::vec![Homogeneous::zero(); vs.len()];
        for (&u, out) in us.iter().zip(out.chunks_mut(vs.len())) {
            lines.eval(u, &mut line);
            for (out, point) in out.iter_mut().zip(&line) {
                *out = point.project();
            }
        }
        Ok(())
    }

    partials_by_number!();

    fn eval_with_partials<const K: usize>(&self, u: P::Scalar, v: P::Scalar) -> [[P::Vector; K]; K] {
        let parts = self.homogeneous.eval_with_partials::<K>(u, v);
        let mut partials = [[P::Vector::zero(); K]; K];
        quotients(parts.as_flattened(), K, partials.as_flattened_mut());
        partials
    }
}

/// The partial derivatives of the quotient from those of numerator and denominator, `columns` in a row.
#[inline]
fn quotients<P: Point>(parts: &[Homogeneous<P>], columns: usize, partials: &mut [P]) {
    for n in 0..partials.len() {
        let (r, c) = (n / columns, n % columns);
        let mut numerator = parts[n].scaled;
        for i in 0..=r {
            for j in 0..=c {
                if i + j > 0 {
                    let ways = binomial::<P::Scalar>(r, i) * binomial::<P::Scalar>(c, j);
                    let factor = ways * parts[i * columns + j].weight;
                    numerator = numerator.add_weighted(partials[(r - i) * columns + c - j], -factor);
                }
            }
        }
        partials[n] = Homogeneous { scaled: numerator, weight: parts[0].weight }.project();
    }
}

impl<P: Point> BoundedSurface for NurbsSurface<P> {
    fn pieces(&self) -> Vec<SurfacePiece> {
        let piece = |patch: BezierPatch<Homogeneous<P>>| {
            let of = |n: usize, c: usize| patch.net.as_slice()[n].component(c).to_f64();
            let size = [patch.net.rows(), patch.net.columns()];
            SurfacePiece::from_fn(patch.domain, size, P::DIM, P::DIM + 1, of)
        };
        self.to_bezier().into_iter().map(piece).collect()
    }
}
