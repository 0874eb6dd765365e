//! Splicing: one surface is adjusted along an edge so that it continues another one within tolerances.
//!
//! Two surfaces meet along an edge of each. The one that is continued, the *target*, stays; of the other one the row of
//! control points on the edge and, for tangent planes, the row next to it are changed, after knots have been inserted
//! along the edge. The knot vectors and degrees may differ; parameters of the edges correspond by the affine map of one
//! domain to the other.
//!
//! - **G0**: both edges are the same curve.
//! - **G1**: `α S_u + β T_w + γ T_t = 0` along the joint with `α` and `β` of opposite sign, where `u` leads out of the
//!   adjusted surface, `w` into the target and `t` along the edge: the tangent planes agree, and the surfaces continue
//!   each other instead of folding back.
//! - **G2**: the normal curvatures agree too, in all directions; a third row of control points is changed.

mod bounds;
mod correct;
pub(super) mod dense;
mod error;
mod exact;
pub(super) mod measure;
#[cfg(all(feature = "nalgebra", feature = "std"))]
mod midpoints;
pub(super) mod strip;
mod third;

use alloc::vec::Vec;

pub use error::SpliceError;
pub use measure::JointBounds;
use measure::{measure, measured};
use strip::{Strip, Vector, along, place};

use super::{BSplineSurface, Edge, EdgePair};
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::vector::length;
use crate::{Point, Point3, Scalar};

/// As long as a tolerance is not met, spans are divided whose figures are above this part of it: those just below would
/// be above it when their neighbours have changed.
pub(super) const AIM: f64 = 0.8;

/// The number of rounds without better figures after which rounding errors are reached, or a tolerance that cannot be
/// met.
const PATIENCE: usize = 3;

/// How smooth a joint is to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Continuity {
    /// The edges are the same curve.
    G0,
    /// The tangent planes are the same too.
    G1,
    /// The normal curvatures are the same too, in every direction, but for rounding errors: reflections have no kinks.
    /// Only [`Method::Exact`] makes such joints; what is bounded of them is gap and angle, and
    /// [`Surface::joint`](crate::Surface::joint) measures curvatures at samples.
    G2,
}

/// How the two rows are found.
///
/// [`Exact`](Method::Exact) is the default on the evidence below. [`LeastSquares`](Method::LeastSquares) is for joints
/// at which the shape must change as little as possible: it keeps the direction of the lines across the edge.
///
#[doc = include_str!("comparison.md")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Method {
    /// That of the paper: equations at the ends and the middle of every span; the rest by two quadratic programmes. Its systems
    /// are solved by nalgebra: without the features `nalgebra` and `std` it is [`SpliceError::NeedsNalgebra`].
    Midpoints,
    /// Least squares over at least six samples in every span.
    LeastSquares,
    /// The rows of the target over merged knots and equal degrees: no error but rounding, and the fewest spans.
    Exact,
}

/// What the second row of control points does before it is corrected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum SecondRow {
    /// It gets the same change as the edge.
    Carried,
    /// It stays as it is. The surface is then bent near its edge, and many more spans are needed.
    Kept,
}

/// The degree and the knots along the edge to which those for the sake of the tolerances are added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum EdgeKnots {
    /// The degree is raised to that of the target and its knots are inserted, so that the edge is met exactly.
    Merged,
    /// They are those of the surface.
    Own,
}

/// What a surface that continues another one is to reach, and how, [`BSplineSurface::continued_within`]: the defaults,
/// and what is set otherwise.
///
/// ```
/// use basis_runtime::bspline::{Method, SpliceOptions};
///
/// let options = SpliceOptions::default().method(Method::LeastSquares).gap(1e-6);
/// assert_eq!((options.gap, options.angle), (1e-6, 1e-4));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct SpliceOptions {
    /// The method.
    pub method: Method,
    /// The smoothness.
    pub continuity: Continuity,
    /// The largest gap, in the unit of the points.
    pub gap: f64,
    /// The largest angle between the tangent planes, in radians.
    pub angle: f64,
    /// The most spans along the edge to which knots are inserted for the sake of the tolerances. Those that merging
    /// needs are inserted in any case.
    pub spans: usize,
    /// What the second row of control points does before it is corrected.
    pub second_row: SecondRow,
    /// The degree and the knots along the edge to begin with; [`Method::Exact`] merges them in any case.
    pub edge_knots: EdgeKnots,
}

impl Default for SpliceOptions {
    /// The exact method, G1, gap 1e-5, angle 1e-4, at most 400 spans; for the other methods a carried second row and merged
    /// knots.
    fn default() -> Self {
        Self {
            method: Method::Exact,
            continuity: Continuity::G1,
            gap: 1e-5,
            angle: 1e-4,
            spans: 400,
            second_row: SecondRow::Carried,
            edge_knots: EdgeKnots::Merged,
        }
    }
}

crate::bspline::setters! {
    SpliceOptions;
    method: Method, "With that method.";
    continuity: Continuity, "With that smoothness.";
    gap: f64, "With that largest gap, in the unit of the points.";
    angle: f64, "With that largest angle between the tangent planes, in radians.";
    spans: usize, "With at most that number of spans along the edge.";
    second_row: SecondRow, "With a second row that does so before it is corrected.";
    edge_knots: EdgeKnots, "With that degree and those knots along the edge to begin with.";
}

/// A surface that continues another one, by [`BSplineSurface::continued_within`].
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
#[non_exhaustive]
pub struct Splice<P: Point> {
    /// The surface that was moved.
    pub surface: BSplineSurface<P>,
    /// Bounds of gap and angle, within the tolerances: the [`joint_bounds`](BSplineSurface::joint_bounds) of the
    /// surface that is continued and this one.
    pub joint: JointBounds,
    /// The number of spans along the edge.
    pub spans: usize,
    /// How often knots were inserted and the rows solved for.
    pub rounds: usize,
    /// How far the rows moved, and so no point of the surface moved further: the larger distance of the edge and the
    /// one of the second row.
    pub change: f64,
}

impl<P: Point3> BSplineSurface<P> {
    /// The surface `next`, moved so that it continues this one across an edge of each, within the tolerances of gap and
    /// angle: as [`continued`](Self::continued), with factors of the contact that are found, so that `next` changes
    /// little.
    ///
    /// Of `next` only the two rows of control points next to the edge are changed, three for [`Continuity::G2`], over a
    /// net that is refined along the edge (and across it, if it has so few rows that the opposite edge and its tangent
    /// planes would move). For [`Continuity::G2`] the degree across the edge is at least 2.
    ///
    /// ```
    /// use basis_runtime::bspline::{BSplineSurface, Continuity, KnotVector, Net, SpliceOptions};
    /// use basis_runtime::{Edge, EdgePair, Surface};
    ///
    /// let sheet = |from: f64, spans: usize| {
    ///     let (u, v) = (KnotVector::uniform(3, 2)?, KnotVector::uniform(3, spans)?);
    ///     let point = |i: usize, j: usize| [from + i as f64, j as f64 / (spans + 2) as f64, (i * j) as f64 / 8.0];
    ///     BSplineSurface::new(u, v, Net::from_fn(5, spans + 3, point)?)
    /// };
    /// let (first, draft) = (sheet(0.0, 3)?, sheet(-4.2, 2)?);
    /// let edges = EdgePair::along(Edge::UStart, Edge::UEnd);
    /// let next = first.continued_within(edges, &SpliceOptions::default().continuity(Continuity::G2), &draft)?.surface;
    /// assert_eq!(first.joint(edges, &next, 65).geometric_order(1e-9, 1e-9, 1e-9), Some(2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SpliceError::Curvatures`] for [`Continuity::G2`] by another method than [`Method::Exact`];
    /// [`SpliceError::NotReached`] with the achieved figures if the tolerances cannot be met; the other errors say what
    /// is wrong with the input.
    pub fn continued_within(
        &self,
        edges: EdgePair,
        options: &SpliceOptions,
        next: &Self,
    ) -> Result<Splice<P>, SpliceError> {
        let domain = |surface: &Self, edge| surface.knots(along(edge)).to_f64().domain();
        let domains = [domain(next, edges.second), domain(self, edges.first)];
        let place = |t| strip::mapped_parameter(t, domains[0], domains[1], edges.orientation);
        splice(next, self, edges.swapped(), options).map_err(|error| error.at(place))
    }
}

/// [`BSplineSurface::continued_within`], with the surface that is adjusted first; places are parameters of that one.
fn splice<P: Point3>(
    surface: &BSplineSurface<P>,
    target: &BSplineSurface<P>,
    edges: EdgePair,
    options: &SpliceOptions,
) -> Result<Splice<P>, SpliceError> {
    for tolerance in [options.gap, options.angle] {
        if !(tolerance > 0.0 && tolerance.is_finite()) {
            return Err(SpliceError::Tolerance { tolerance });
        }
    }
    let exact = options.method == Method::Exact;
    let has_curvatures = options.continuity == Continuity::G2;
    if has_curvatures && !exact {
        return Err(SpliceError::Curvatures);
    }
    let surface = prepared(surface, edges.first, if has_curvatures { 3 } else { 2 })?;
    let original = Strip::new(&surface, edges.first)?;
    let clamped = target.clamped();
    let fixed = Strip::new(&clamped, edges.second)?;
    let mapped = |strip: &Strip| {
        strip.mapped::<P::Scalar>(original.knots.domain(), edges.orientation, &original.knots)
    };
    let seconds =
        if has_curvatures { Some(mapped(&third::seconds(&clamped, edges.second, &fixed)?)?) } else { None };
    let fixed = mapped(&fixed)?;

    let merge = exact || options.edge_knots == EdgeKnots::Merged;
    let least = if merge { fixed.knots.degree() } else { 0 };
    // Below degree 2 the paper has more equations than unknowns, and tangent planes jump from span to span.
    let degree = original.knots.degree().max(least).max(if exact { 1 } else { 2 });
    let mut base = original.elevated(degree)?;
    let (mut fixed, mut inserted) = (fixed, Vec::new());
    if merge {
        fixed = fixed.elevated(degree)?;
        inserted = super::rows::missing(&base.knots, &fixed.knots)?;
        base = base.inserted(&inserted)?;
    }
    if exact {
        fixed = fixed.inserted(&super::rows::missing(&fixed.knots, &base.knots)?)?;
    }
    // What the third row has to reach, and what it was.
    let curved = match (seconds, third::Across::new(&surface, edges.first)) {
        (Some(seconds), Some(across)) => {
            let seconds = seconds.elevated(degree)?;
            let missing = super::rows::missing(&seconds.knots, &base.knots)?;
            let before = third::row(&surface, edges.first, 2, &original)?;
            Some((across, seconds.inserted(&missing)?, before.elevated(degree)?.inserted(&inserted)?))
        }
        _ => None,
    };
    let angle = if options.continuity == Continuity::G0 { f64::INFINITY } else { options.angle };

    let mut best: Option<(JointBounds, usize)> = None;
    let (mut rounds, mut best_round) = (0, 0);
    loop {
        rounds += 1;
        let mut strip = base.clone();
        let factor = solve(&mut strip, &fixed, options)?;
        let (found, pieces) = measure(&strip, &fixed, options.continuity)?;
        let spans = strip.spans();
        let excess = |m: &JointBounds| m.excess(options.gap, angle);
        if best.is_none_or(|(other, _)| excess(&found) < excess(&other)) {
            best = Some((found, spans));
            best_round = rounds;
        }
        if excess(&found) <= 1.0 {
            let rate = factor * strip.factor / fixed.factor;
            let third = curved.as_ref().map(|(across, seconds, before)| {
                let row = third::solved(&strip, *across, seconds, rate);
                (Strip { edge: row.clone(), inner: row, ..before.clone() }, before)
            });
            let rows = [Some(&strip.edge), Some(&strip.inner), third.as_ref().map(|(row, _)| &row.edge)];
            let result = written(&surface, edges.first, degree, &inserted, rows)?;
            // The figures of what is handed back, in its own precision.
            let joint = measured(target, &result, edges.swapped(), options.continuity);
            let joint = joint.map_err(|error| {
                let domain = clamped.knots(along(edges.second)).to_f64().domain();
                error.at(|t| strip::mapped_parameter(t, domain, original.knots.domain(), edges.orientation))
            })?;
            if excess(&joint) > 1.0 {
                best = Some((measured(&result, target, edges, options.continuity)?, spans));
                break;
            }
            let of_third = third.as_ref().map_or(0.0, |(row, before)| change(before, row));
            let change = change(&base, &strip).max(of_third);
            return Ok(Splice { surface: result, joint, spans, rounds, change });
        }
        let middles = measure::middles::<P::Scalar>(&strip.knots, &pieces, AIM * options.gap, AIM * angle);
        let stalled = rounds - best_round >= PATIENCE;
        if exact || stalled || middles.is_empty() || spans + middles.len() > options.spans {
            break;
        }
        base = base.inserted(&middles)?;
        inserted.extend(middles);
    }
    let (achieved, spans) = best.ok_or(SpliceError::Singular)?;
    Err(SpliceError::NotReached { achieved, spans, gap: options.gap, angle: options.angle })
}

/// A clamped surface with at least two rows beyond those that change, so that the opposite edge keeps its tangent planes.
fn prepared<P: Point3>(
    surface: &BSplineSurface<P>,
    edge: Edge,
    changed: usize,
) -> Result<BSplineSurface<P>, SpliceError> {
    let mut surface = surface.clamped();
    let across = edge.across();
    while surface.knots(across).degree() + 1 < changed {
        surface = surface.elevate(across)?;
    }
    while surface.knots(across).functions() < changed + 2 {
        let finer = surface.refined(across);
        if finer == surface {
            return Err(SpliceError::OneRow);
        }
        surface = finer;
    }
    Ok(surface)
}

/// One round: both rows over the knots that the strip has; the factor between them and those of the target, if there is one.
fn solve(strip: &mut Strip, target: &Strip, options: &SpliceOptions) -> Result<f64, SpliceError> {
    if options.method == Method::Exact && options.continuity != Continuity::G0 {
        return Ok(exact::rows(strip, target));
    }
    let change = match options.method {
        #[cfg(all(feature = "nalgebra", feature = "std"))]
        Method::Midpoints => midpoints::edge(strip, target)?,
        #[cfg(not(all(feature = "nalgebra", feature = "std")))]
        Method::Midpoints => return Err(SpliceError::NeedsNalgebra),
        Method::LeastSquares => dense::edge(strip, target)?,
        Method::Exact => {
            let change = target.edge.iter().zip(&strip.edge).map(|(to, from)| to.minus(*from)).collect();
            strip.edge.clone_from(&target.edge);
            change
        }
    };
    if options.second_row == SecondRow::Carried {
        for (point, change) in strip.inner.iter_mut().zip(&change) {
            *point = point.add_weighted(*change, 1.0);
        }
    }
    if options.continuity == Continuity::G1 {
        match options.method {
            #[cfg(all(feature = "nalgebra", feature = "std"))]
            Method::Midpoints => midpoints::inner(strip, target)?,
            _ => dense::inner(strip, target)?,
        }
    }
    Ok(0.0)
}

/// The surface with these rows, from the edge on.
fn written<P: Point3>(
    surface: &BSplineSurface<P>,
    edge: Edge,
    degree: usize,
    inserted: &[f64],
    rows: [Option<&Vec<Vector>>; 3],
) -> Result<BSplineSurface<P>, SpliceError> {
    let direction = along(edge);
    let mut surface = surface.clone();
    while surface.knots(direction).degree() < degree {
        surface = surface.elevate(direction)?;
    }
    let inserted: Vec<_> = inserted.iter().map(|&t| P::Scalar::of(t)).collect();
    let mut surface = surface.insert_knots(direction, &inserted)?;
    for (layer, row) in rows.into_iter().flatten().enumerate() {
        for (j, point) in row.iter().enumerate() {
            let index = place(&surface, edge, layer, j);
            surface.set_control_point(index, P::from_components(|i| P::Scalar::of(point[i])));
        }
    }
    Ok(surface)
}

/// The largest distance by which a point of either row, as a curve, moved.
fn change(before: &Strip, after: &Strip) -> f64 {
    let knots = before.knots.as_slice();
    let mut largest = 0.0_f64;
    for span in before.knots.spans() {
        for i in 0..=8 {
            let t = knots[span] + (knots[span + 1] - knots[span]) * f64::from(i) / 8.0;
            let (a, b) = (before.frame(span, t), after.frame(span, t));
            let edge = b.point.minus(a.point);
            let inner = edge.add_scaled(b.across.minus(a.across), 1.0);
            largest = largest.max(length(edge)).max(length(inner));
        }
    }
    largest
}
