//! Surfaces that are moved so that they continue another one across an edge, polynomial and rational.
//!
//! At a clamped edge the derivatives across it up to an order are splines along it, over one row of control points more
//! than the order. Over common knots along the edge, the conditions of contact hold on all of it if they hold for the
//! control points of these splines.

use alloc::vec::Vec;

use super::functions::combine;
use super::rows::{self, Rows};
use super::splice::strip::{along, mapped_knots, place};
use super::{BSplineSurface, Homogeneous, KnotVector, NurbsSurface};
use crate::geometry::replace_first;
use crate::numeric::leibniz;
use crate::surface::{beyond, factor_of_weights, possible};
use crate::{Contact, Direction, Edge, EdgePair, JoinError, Orientation, Point, Scalar};

impl<P: Point> BSplineSurface<P> {
    /// The surface `next`, moved so that it continues this one across an edge of each, with that contact.
    ///
    /// Edges and their directions, knots and degrees may be any. With P and Q the functions from the edge into this and
    /// into the other surface, each with the parameter of its surface across the edge, the derivatives agree as
    /// [`Contact`] says, on the whole edge: order 0 is a common edge, [`Contact::Tangent`] is G1,
    /// [`Contact::Curvature`] G2. The knots of `next` become clamped, and along the edge it gets the knots and at least
    /// the degree of this surface. Then one row of control points more than the order is replaced; all others stay.
    ///
    /// [`continued_within`](Self::continued_within) finds the factors, and changes less where a small error is allowed.
    ///
    /// ```
    /// use basis_runtime::bspline::{BSplineSurface, KnotVector, Net};
    /// use basis_runtime::{Contact, Edge, EdgePair, Surface};
    ///
    /// let sheet = |from: f64, spans: usize| {
    ///     let (u, v) = (KnotVector::uniform(3, 2)?, KnotVector::uniform(3, spans)?);
    ///     let point = |i: usize, j: usize| [from + i as f64, j as f64 / (spans + 2) as f64, (i * j) as f64 / 8.0];
    ///     BSplineSurface::new(u, v, Net::from_fn(5, spans + 3, point)?)
    /// };
    /// let (first, draft) = (sheet(0.0, 3)?, sheet(4.2, 2)?);
    /// let edges = EdgePair::along(Edge::UEnd, Edge::UStart);
    /// let next = first.continued(edges, Contact::Curvature { f: 1.0, c: 0.0 }, &draft)?;
    /// assert_eq!(first.joint(edges, &next, 65).geometric_order(1e-14, 1e-12, 1e-9), Some(2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`JoinError::Factor`] as for curves; [`JoinError::Contact`] if the order is above the degree of `next` across
    /// the edge; [`JoinError::Knots`] if knots along the edges come so near to each other that rounding makes them
    /// equal too often; [`JoinError::NotFinite`] if a computed control point is not finite.
    pub fn continued(
        &self,
        edges: EdgePair,
        contact: Contact<P::Scalar>,
        next: &Self,
    ) -> Result<Self, JoinError> {
        let order = possible(contact, next.knots(edges.second.across()).degree())?;
        let (derivatives, next) = merged(self, edges, order, next)?;
        let derivatives = derivatives.into_iter().map(|derivatives| beyond(edges, contact, derivatives));
        replaced(next, edges.second, &derivatives.collect::<Result<Vec<_>, _>>()?)
    }
}

impl<P: Point> NurbsSurface<P> {
    /// The surface `next`, moved so that it continues this one across an edge of each, with that contact: as
    /// [`BSplineSurface::continued`], over homogeneous points.
    ///
    /// Weights along an edge belong to the points of the edge, so those of the rows that are replaced are replaced,
    /// too. Numerator and denominator can be multiplied by any function of the parameter across the edge; the one is
    /// taken with which the weights of `next` keep their means along the edge. So none of them changes where those of
    /// neither surface change along the edge, as those of polynomial surfaces.
    ///
    /// ```
    /// use basis_runtime::bspline::{KnotVector, NurbsCurve, NurbsSurface};
    /// use basis_runtime::{Contact, Direction, Edge, EdgePair, Surface};
    ///
    /// // A tube around the x axis, and a wider one beyond it.
    /// let half_turn = [[0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0], [0.0, -1.0, 1.0], [0.0, -1.0, 0.0]];
    /// let half = 0.5_f64.sqrt();
    /// let knots = KnotVector::new(2, [0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0])?;
    /// let circle = NurbsCurve::new(knots, half_turn, [1.0, half, 1.0, half, 1.0])?;
    /// let tube = NurbsSurface::extruded(&circle, [2.0, 0.0, 0.0])?;
    /// let wider = NurbsSurface::extruded(&circle.map(|[_, y, z]| [3.0, 2.0 * y, 2.0 * z]), [2.0, 0.0, 0.0])?;
    /// let edges = EdgePair::along(Edge::VEnd, Edge::VStart);
    /// let next = tube.continued(edges, Contact::Tangent { f: 1.0 }, &wider.elevate(Direction::V)?)?;
    /// assert_eq!(tube.joint(edges, &next, 65).geometric_order(1e-14, 1e-7, 1e-9), Some(1));
    /// assert_eq!(next.boundary(Edge::VEnd), wider.boundary(Edge::VEnd));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`BSplineSurface::continued`], and [`JoinError::Weights`] if a weight would not be positive and finite.
    pub fn continued(
        &self,
        edges: EdgePair,
        contact: Contact<P::Scalar>,
        next: &Self,
    ) -> Result<Self, JoinError> {
        let order = possible(contact, next.knots(edges.second.across()).degree())?;
        let (derivatives, next) = merged(self.homogeneous(), edges, order, next.homogeneous())?;
        let mut derivatives = derivatives
            .into_iter()
            .map(|derivatives| beyond(edges, contact, derivatives))
            .collect::<Result<Vec<_>, _>>()?;
        let own: Vec<_> =
            across(&next, edges.second, order).points.chunks(order + 1).map(<[_]>::to_vec).collect();
        let knots = next.knots(along(edges.second));
        let factor = factor_of_weights(&means(knots, &own), &means(knots, &derivatives))?;
        for derivatives in &mut derivatives {
            *derivatives = leibniz::product(derivatives, &factor);
        }
        let homogeneous = replaced(next, edges.second, &derivatives)?;
        Self::from_homogeneous(homogeneous).map_err(|_| JoinError::Weights)
    }
}

/// The derivatives up to that order across an edge, for each function along it; a lane for each order.
fn across<P: Point>(surface: &BSplineSurface<P>, edge: Edge, order: usize) -> Rows<P::Scalar, P> {
    let knots = surface.knots(edge.across());
    let at = knots.domain()[usize::from(edge.is_end())];
    let span = knots.span(at);
    let factors: Vec<_> = (0..=order).map(|k| knots.derivatives_on(span, at, k)).collect();
    let along = surface.knots(along(edge)).clone();
    let points = (0..along.functions()).flat_map(|j| {
        let line: Vec<P> = (span - knots.degree()..=span)
            .map(|i| match edge.across() {
                Direction::U => surface.net()[[i, j]],
                Direction::V => surface.net()[[j, i]],
            })
            .collect();
        factors.iter().map(|factors| combine(factors, &line)).collect::<Vec<_>>()
    });
    Rows { points: points.collect(), knots: along, lanes: order + 1 }
}

/// The derivatives of a surface across its edge, and the other surface, over common knots along the edges.
#[allow(clippy::type_complexity)] // a list for each function along the edge, and a surface
fn merged<P: Point>(
    first: &BSplineSurface<P>,
    edges: EdgePair,
    order: usize,
    next: &BSplineSurface<P>,
) -> Result<(Vec<Vec<P>>, BSplineSurface<P>), JoinError> {
    let direction = along(edges.second);
    let mut next = next.clamped();
    let mut rows = rows::clamp(&across(first, edges.first, order));
    let knots = next.knots(direction).to_f64();
    let mapped = mapped_knots::<P::Scalar>(&rows.knots.to_f64(), knots.domain(), edges.orientation, &knots)?;
    let mapped: Vec<_> = mapped.as_slice().iter().map(|&knot| P::Scalar::of(knot)).collect();
    rows.knots = KnotVector::new(rows.knots.degree(), mapped)?;
    if edges.orientation == Orientation::Opposite {
        rows.points = rows.points.chunks(rows.lanes).rev().flatten().copied().collect();
    }
    while rows.knots.degree() < next.knots(direction).degree() {
        rows = rows::elevate(&rows)?;
    }
    while next.knots(direction).degree() < rows.knots.degree() {
        next = next.elevate(direction)?;
    }
    let missing = rows::missing(&rows.knots, next.knots(direction))?;
    rows = rows::insert(&rows, &missing)?;
    next = next.insert_knots(direction, &rows::missing(next.knots(direction), &rows.knots)?)?;
    Ok((rows.points.chunks(rows.lanes).map(<[P]>::to_vec).collect(), next))
}

/// A clamped surface with these derivatives across an edge, a list for each function along it.
fn replaced<P: Point>(
    mut surface: BSplineSurface<P>,
    edge: Edge,
    derivatives: &[Vec<P>],
) -> Result<BSplineSurface<P>, JoinError> {
    let knots = surface.knots(edge.across()).clone();
    let at = knots.domain()[usize::from(edge.is_end())];
    let span = knots.span(at);
    // The factors of the control points in each derivative, from the edge on.
    let count = derivatives.first().map_or(0, Vec::len);
    let factors: Vec<Vec<P::Scalar>> = (0..count)
        .map(|k| {
            let mut factors = knots.derivatives_on(span, at, k).to_vec();
            if edge.is_end() {
                factors.reverse();
            }
            factors
        })
        .collect();
    for (j, derivatives) in derivatives.iter().enumerate() {
        let places: Vec<_> = (0..count).map(|layer| place(&surface, edge, layer, j)).collect();
        let mut points: Vec<P> = places.iter().map(|&place| surface.net()[place]).collect();
        replace_first(&mut points, derivatives, |k| factors[k].clone()).map_err(|_| JoinError::NotFinite)?;
        for (place, point) in places.into_iter().zip(points) {
            surface.set_control_point(place, point);
        }
    }
    Ok(surface)
}

/// The means of the weights and of their derivatives along an edge, times a constant: of a spline `Σ c[i] N[i,k]` that
/// is `Σ c[i] (t[i+k+1] - t[i])`.
fn means<P: Point>(knots: &KnotVector<P::Scalar>, derivatives: &[Vec<Homogeneous<P>>]) -> Vec<P::Scalar> {
    let (t, k) = (knots.as_slice(), knots.degree());
    let order = derivatives.first().map_or(0, Vec::len);
    let of = |order: usize| {
        derivatives.iter().enumerate().fold(P::Scalar::ZERO, |sum, (i, derivatives)| {
            sum + (t[i + k + 1] - t[i]) * derivatives[order].weight
        })
    };
    (0..order).map(of).collect()
}
