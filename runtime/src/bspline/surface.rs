//! B-spline surfaces.

use alloc::vec::Vec;
use core::ops::Range;

use super::curve::middles;
use super::functions::combine;
use super::rows::{self, Rows};
use super::slices::Lines;
use super::{BSplineCurve, Direction, KnotError, KnotVector, Net, SplineError};
use crate::curve::{divisible, nonempty};
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::surface::{one_for_each, partials_by_number};
use crate::{BoundedSurface, CurveError, Edge, Nearest, Point, Scalar, Surface, SurfaceDomain, SurfacePiece};

/// The tensor product surface `S(u, v) = Σ N[i](u) N[j](v) P[i, j]` over two knot vectors.
///
/// Outside of the domain, at jumps and for NaN it behaves as [`BSplineCurve`] does.
///
/// ```
/// use basis_runtime::bspline::{BSplineSurface, Direction, KnotVector, Net};
///
/// let u = KnotVector::uniform(2, 3)?;
/// let v = KnotVector::uniform(3, 2)?;
/// let net = Net::from_fn(5, 5, |i, j| [i as f64, j as f64, (i * j) as f64])?;
/// let surface = BSplineSurface::new(u, v, net)?;
/// assert_eq!(surface.eval(0.0, 1.0), [0.0, 4.0, 0.0]);
///
/// let finer = surface.insert_knots(Direction::V, &[0.25])?;
/// assert_eq!(finer.net().columns(), 6);
/// # Ok::<(), basis_runtime::bspline::SplineError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::bspline::Surface<P>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
pub struct BSplineSurface<P: Point> {
    u: KnotVector<P::Scalar>,
    v: KnotVector<P::Scalar>,
    net: Net<P>,
}

/// One polynomial piece of a surface.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
#[non_exhaustive]
pub struct BezierPatch<P: Point> {
    /// The ends of its spans, in `u` and in `v`.
    pub domain: [[P::Scalar; 2]; 2],
    /// Its net as a Bézier surface.
    pub net: Net<P>,
}

impl<P: Point> BSplineSurface<P> {
    /// The surface with this net: a row for each basis function of `u`, a column for each of `v`.
    ///
    /// # Errors
    /// [`SplineError::Size`] if the net has another size.
    pub fn new(u: KnotVector<P::Scalar>, v: KnotVector<P::Scalar>, net: Net<P>) -> Result<Self, SplineError> {
        let (expected, found) = ([u.functions(), v.functions()], [net.rows(), net.columns()]);
        if expected == found { Ok(Self { u, v, net }) } else { Err(SplineError::Size { expected, found }) }
    }

    /// The Bézier surface with this net over the unit square.
    ///
    /// # Errors
    /// [`KnotError::Degree`] if a side of the net has too many points.
    pub fn from_bezier(net: Net<P>) -> Result<Self, SplineError> {
        let u = KnotVector::uniform(net.rows() - 1, 1)?;
        let v = KnotVector::uniform(net.columns() - 1, 1)?;
        Self::new(u, v, net)
    }

    /// The image under an affine map: the surface over the same knots with the images of all control points.
    pub fn map<Q: Point<Scalar = P::Scalar>>(&self, image: impl FnMut(P) -> Q) -> BSplineSurface<Q> {
        BSplineSurface { u: self.u.clone(), v: self.v.clone(), net: self.net.map(image) }
    }

    crate::affine::transform!();

    /// The degrees in both directions.
    #[inline]
    pub fn degrees(&self) -> [usize; 2] {
        [self.u.degree(), self.v.degree()]
    }

    /// The knots in one direction.
    #[inline]
    pub fn knots(&self, direction: Direction) -> &KnotVector<P::Scalar> {
        match direction {
            Direction::U => &self.u,
            Direction::V => &self.v,
        }
    }

    /// The net of control points.
    #[inline]
    pub fn net(&self) -> &Net<P> {
        &self.net
    }

    /// The control points, row by row, to be changed in place.
    #[inline]
    pub fn control_points_mut(&mut self) -> &mut [P] {
        self.net.as_mut_slice()
    }

    pub(super) fn set_control_point(&mut self, index: [usize; 2], point: P) {
        self.net[index] = point;
    }

    /// The rectangle of the parameters.
    #[inline]
    pub fn domain(&self) -> SurfaceDomain<P::Scalar> {
        SurfaceDomain::Rectangle([self.u.domain(), self.v.domain()])
    }

    /// The point `S(u, v)`.
    #[inline]
    pub fn eval(&self, u: P::Scalar, v: P::Scalar) -> P {
        if self.degrees() == [3, 3] {
            let spans = [self.u.span(u), self.v.span(v)];
            let factors = [self.u.cubic_values_on(spans[0], u), self.v.cubic_values_on(spans[1], v)];
            return self.bicubic_point(spans, factors);
        }
        self.partial_on([self.u.span(u), self.v.span(v)], [u, v], [0, 0])
    }

    /// The sum of the sixteen control points of a bicubic piece, each times the factors of its row and of its column.
    ///
    /// Rows first: the numbers of four points, one after the other in memory, are taken two or four at a time.
    #[inline]
    fn bicubic_point(&self, spans: [usize; 2], [rows, columns]: [[P::Scalar; 4]; 2]) -> P {
        let mut line = [P::zero(); 4];
        for (i, &factor) in rows.iter().enumerate() {
            let &[a, b, c, d] = &self.net.row(spans[0] - 3 + i)[spans[1] - 3..=spans[1]] else { break };
            for (sum, point) in line.iter_mut().zip([a, b, c, d]) {
                *sum = if i == 0 { point.scale(factor) } else { sum.add_weighted(point, factor) };
            }
        }
        let ([a, b, c, d], [e, f, g, h]) = (line, columns);
        a.scale(e).add_weighted(b, f).add_weighted(c, g).add_weighted(d, h)
    }

    /// The same for several factors of each row and each column.
    #[inline]
    fn bicubic<const K: usize>(
        &self,
        spans: [usize; 2],
        [rows, columns]: [[[P::Scalar; 4]; 2]; 2],
    ) -> [[P::Vector; K]; K] {
        let mut sums = [[P::Vector::zero(); K]; K];
        for i in 0..4 {
            let &[a, b, c, d] = &self.net.row(spans[0] - 3 + i)[spans[1] - 3..=spans[1]] else { return sums };
            let [a, b, c, d] = [a, b, c, d].map(P::to_vector);
            let line: [P::Vector; K] = core::array::from_fn(|k| {
                let [e, f, g, h] = columns[k];
                a.scale(e).add_weighted(b, f).add_weighted(c, g).add_weighted(d, h)
            });
            for (sums, factors) in sums.iter_mut().zip(&rows) {
                for (sum, &point) in sums.iter_mut().zip(&line) {
                    *sum = sum.add_weighted(point, factors[i]);
                }
            }
        }
        sums
    }

    /// The partial derivative of these orders in `u` and `v`; for `[0, 0]` the vector from the origin to the
    /// point.
    #[inline]
    pub fn partial(&self, u: P::Scalar, v: P::Scalar, orders: [usize; 2]) -> P::Vector {
        self.partial_on([self.u.span(u), self.v.span(v)], [u, v], orders).to_vector()
    }

    /// The partial derivative of the polynomial piece over these spans.
    #[inline]
    pub(super) fn partial_on(&self, spans: [usize; 2], at: [P::Scalar; 2], orders: [usize; 2]) -> P {
        let rows = self.u.derivatives_on(spans[0], at[0], orders[0]);
        let columns = self.v.derivatives_on(spans[1], at[1], orders[1]);
        let first = [spans[0] - self.u.degree(), spans[1] - self.v.degree()];
        rows.iter().enumerate().fold(P::zero(), |sum, (i, &factor)| {
            let row = &self.net.row(first[0] + i)[first[1]..=spans[1]];
            sum.add_weighted(combine(&columns, row), factor)
        })
    }

    /// The curve on which one parameter is constant; `direction` is that of the constant parameter.
    pub fn isocurve(&self, direction: Direction, at: P::Scalar) -> BSplineCurve<P> {
        let (constant, free) = match direction {
            Direction::U => (&self.u, &self.v),
            Direction::V => (&self.v, &self.u),
        };
        let span = constant.span(at);
        let first = span - constant.degree();
        let values = constant.values_on(span, at);
        let points: Vec<P> = (0..free.functions())
            .map(|j| {
                values.iter().enumerate().fold(P::zero(), |sum, (i, &factor)| {
                    let index = match direction {
                        Direction::U => [first + i, j],
                        Direction::V => [j, first + i],
                    };
                    sum.add_weighted(self.net[index], factor)
                })
            })
            .collect();
        BSplineCurve::trusted(free.clone(), points)
    }

    /// The boundary curve along an edge.
    pub fn boundary(&self, edge: Edge) -> BSplineCurve<P> {
        let [lo, hi] = self.knots(edge.across()).domain();
        self.isocurve(edge.across(), if edge.is_end() { hi } else { lo })
    }

    pub(super) fn to_rows(&self, direction: Direction) -> Rows<P::Scalar, P> {
        let net = match direction {
            Direction::U => self.net.clone(),
            Direction::V => self.net.transposed(),
        };
        let (lanes, knots) = (net.columns(), self.knots(direction).clone());
        Rows { knots, points: net.into_points(), lanes }
    }

    /// The surface with other rows in one direction.
    pub(super) fn with_rows(&self, direction: Direction, rows: Rows<P::Scalar, P>) -> Self {
        let Rows { knots, points, lanes } = rows;
        let net = Net::trusted(points, lanes);
        match direction {
            Direction::U => Self { u: knots, v: self.v.clone(), net },
            Direction::V => Self { u: self.u.clone(), v: knots, net: net.transposed() },
        }
    }

    /// The same surface over the knots of one direction and all of `knots`, in any order.
    ///
    /// # Errors
    /// If a knot is outside of the domain, or would occur more than `degree + 1` times.
    pub fn insert_knots(&self, direction: Direction, knots: &[P::Scalar]) -> Result<Self, KnotError> {
        Ok(self.with_rows(direction, rows::insert(&self.to_rows(direction), knots)?))
    }

    /// The same surface with the middle of each span of one direction as a new knot.
    pub fn refined(&self, direction: Direction) -> Self {
        let middles = middles(self.knots(direction));
        self.insert_knots(direction, &middles).unwrap_or_else(|_| self.clone())
    }

    /// Removes an inner knot up to `times` times while no point of the surface moves by more than `tolerance`; returns
    /// the surface and how often the knot was removed. A negative tolerance, or NaN, removes nothing.
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
        self.remove_knot_if(direction, knot, times, rows::within(tolerance))
    }

    /// As [`remove_knot`](Self::remove_knot), while each control point may become what it then is.
    pub(super) fn remove_knot_if(
        &self,
        direction: Direction,
        knot: P::Scalar,
        times: usize,
        may_become: impl Fn(P, P) -> bool,
    ) -> Result<(Self, usize), KnotError> {
        let (rows, removed) = rows::remove(&self.to_rows(direction), knot, times, may_become)?;
        Ok((self.with_rows(direction, rows), removed))
    }

    /// The same surface with a degree that is higher by one in that direction, in which it is then clamped.
    ///
    /// # Errors
    /// [`KnotError::Degree`] above [`MAX_DEGREE`](super::MAX_DEGREE).
    pub fn elevate(&self, direction: Direction) -> Result<Self, KnotError> {
        Ok(self.with_rows(direction, rows::elevate(&self.to_rows(direction))?))
    }

    /// The same surface with clamped knots in both directions.
    pub fn clamped(&self) -> Self {
        let clamp = |surface: &Self, direction| {
            if surface.knots(direction).is_clamped() {
                return surface.clone();
            }
            surface.with_rows(direction, rows::clamp(&surface.to_rows(direction)))
        };
        clamp(&clamp(self, Direction::U), Direction::V)
    }

    /// The parts below and above a parameter of one direction, each over its part of the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if the parameter is outside of the domain or NaN, [`CurveError::AtEnd`] at an end of
    /// it, where one part would be a curve.
    pub fn split(&self, direction: Direction, at: P::Scalar) -> Result<[Self; 2], CurveError> {
        divisible(self.knots(direction).domain(), at)?;
        let at_end = |_| CurveError::AtEnd { parameter: at.to_f64() };
        let parts = rows::split(&self.to_rows(direction), at).map_err(at_end)?;
        Ok(parts.map(|rows| self.with_rows(direction, rows)))
    }

    /// The part over a rectangle of parameters, which is its domain; a range with `start > end` runs backwards, over the
    /// same part of the domain.
    ///
    /// # Errors
    /// [`CurveError::Parameter`] if an end of a range is outside of the domain or NaN, [`CurveError::EmptyRange`] if
    /// both ends of one are equal.
    pub fn subpatch(&self, u: Range<P::Scalar>, v: Range<P::Scalar>) -> Result<Self, CurveError> {
        let mut part = self.clone();
        for (direction, Range { start, end }) in [(Direction::U, u), (Direction::V, v)] {
            let domain = self.knots(direction).domain();
            nonempty(domain, &(start..end))?;
            let (low, high) = if start < end { (start, end) } else { (end, start) };
            if high < domain[1] {
                [part, _] = part.split(direction, high)?;
            }
            if low > domain[0] {
                [_, part] = part.split(direction, low)?;
            }
            if start > end {
                part = part.reversed(direction);
            }
        }
        Ok(part)
    }

    /// The polynomial pieces, one for each pair of spans, as Bézier surfaces; those with the lowest `u` first.
    pub fn to_bezier(&self) -> Vec<BezierPatch<P>> {
        let mut patches = Vec::new();
        for (u, strip) in rows::bezier(&self.to_rows(Direction::U)) {
            let strip = Net::trusted(strip, self.net.columns()).transposed();
            let rows = Rows { knots: self.v.clone(), lanes: strip.columns(), points: strip.into_points() };
            for (v, points) in rows::bezier(&rows) {
                let net = Net::trusted(points, rows.lanes).transposed();
                patches.push(BezierPatch { domain: [u, v], net });
            }
        }
        patches
    }

    /// Two surfaces over the same clamped knot vectors: degrees are raised and knots inserted, no point changes.
    ///
    /// # Errors
    /// [`KnotError::Domains`] if the domains differ.
    pub fn merged(&self, other: &Self) -> Result<[Self; 2], KnotError> {
        let mut pair = [self.clamped(), other.clamped()];
        for direction in [Direction::U, Direction::V] {
            rows::missing(pair[0].knots(direction), pair[1].knots(direction))?;
            let degree = pair[0].knots(direction).degree().max(pair[1].knots(direction).degree());
            for surface in &mut pair {
                while surface.knots(direction).degree() < degree {
                    *surface = surface.elevate(direction)?;
                }
            }
            let missing = [
                rows::missing(pair[0].knots(direction), pair[1].knots(direction))?,
                rows::missing(pair[1].knots(direction), pair[0].knots(direction))?,
            ];
            for (surface, missing) in pair.iter_mut().zip(missing) {
                *surface = surface.insert_knots(direction, &missing)?;
            }
        }
        Ok(pair)
    }

    /// The same surface with the two parameters exchanged; its normals turn to the other side.
    pub fn transposed(&self) -> Self {
        Self { u: self.v.clone(), v: self.u.clone(), net: self.net.transposed() }
    }

    /// The same surface with one parameter running the other way; its normals turn to the other side.
    #[must_use]
    pub fn reversed(&self, direction: Direction) -> Self {
        let (rows, columns) = (self.net.rows(), self.net.columns());
        let point = |i: usize, j: usize| match direction {
            Direction::U => self.net[[rows - 1 - i, j]],
            Direction::V => self.net[[i, columns - 1 - j]],
        };
        let points = (0..rows).flat_map(|i| (0..columns).map(move |j| point(i, j))).collect();
        let net = Net::trusted(points, columns);
        match direction {
            Direction::U => Self { u: self.u.reversed(), v: self.v.clone(), net },
            Direction::V => Self { u: self.u.clone(), v: self.v.reversed(), net },
        }
    }
}

impl<P: Point> Surface for BSplineSurface<P> {
    type Point = P;

    fn domain(&self) -> SurfaceDomain<P::Scalar> {
        self.domain()
    }

    #[inline]
    fn eval(&self, u: P::Scalar, v: P::Scalar) -> P {
        self.eval(u, v)
    }

    #[inline]
    fn partial(&self, u: P::Scalar, v: P::Scalar, orders: [usize; 2]) -> P::Vector {
        self.partial(u, v, orders)
    }

    /// The curve `v ↦ S(u, v)` is found once for each `u`; where the `u` are dense and in order, the curves over the rows of the
    /// net once for all of them.
    fn eval_grid(&self, us: &[P::Scalar], vs: &[P::Scalar], out: &mut [P]) -> Result<(), CurveError> {
        one_for_each([us.len(), vs.len()], out)?;
        if vs.is_empty() {
            return Ok(());
        }
        let mut lines = Lines::new([&self.u, &self.v], &self.net, us, vs);
        for (&u, line) in us.iter().zip(out.chunks_mut(vs.len())) {
            lines.eval(u, line);
        }
        Ok(())
    }

    partials_by_number!();

    /// The functions and their derivatives once for all partial derivatives.
    fn eval_with_partials<const K: usize>(&self, u: P::Scalar, v: P::Scalar) -> [[P::Vector; K]; K] {
        if K == 1 {
            return [[self.eval(u, v).to_vector(); K]; K];
        }
        let spans = [self.u.span(u), self.v.span(v)];
        if K <= 2 && self.degrees() == [3, 3] {
            return self.bicubic(spans, [self.u.cubic_on(spans[0], u), self.v.cubic_on(spans[1], v)]);
        }
        let first = [spans[0] - self.u.degree(), spans[1] - self.v.degree()];
        let rows: [_; K] = core::array::from_fn(|order| self.u.derivatives_on(spans[0], u, order));
        let columns: [_; K] = core::array::from_fn(|order| self.v.derivatives_on(spans[1], v, order));
        let mut sums = [[P::Vector::zero(); K]; K];
        for i in 0..=self.u.degree() {
            let row = &self.net.row(first[0] + i)[first[1]..=spans[1]];
            let line: [_; K] = core::array::from_fn(|k| combine(&columns[k], row).to_vector());
            for (sums, factors) in sums.iter_mut().zip(&rows) {
                for (sum, &point) in sums.iter_mut().zip(&line) {
                    *sum = sum.add_weighted(point, factors[i]);
                }
            }
        }
        sums
    }
}

impl<P: Point> BoundedSurface for BSplineSurface<P> {
    fn pieces(&self) -> Vec<SurfacePiece> {
        let piece = |patch: BezierPatch<P>| {
            let of = |n: usize, c: usize| patch.net.as_slice()[n].component(c).to_f64();
            let size = [patch.net.rows(), patch.net.columns()];
            SurfacePiece::from_fn(patch.domain, size, P::DIM, P::DIM, of)
        };
        self.to_bezier().into_iter().map(piece).collect()
    }

    fn nearest(&self, point: P, accuracy: P::Scalar) -> Option<Nearest<P, [P::Scalar; 2]>> {
        self.nearest(point, accuracy)
    }
}
