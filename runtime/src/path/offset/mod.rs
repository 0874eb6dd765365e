//! Parallel curves and the outlines of strokes, in the plane.

mod outline;
mod parallel;
mod trim;

use alloc::vec::Vec;

use outline::{Inner, Joins, connect};
use parallel::{Parallel, Place, Stretch, V, length, plus};
use trim::{Raw, Trim};

use super::{Path, PathSegment};
use crate::{CurveError, CurvePiece, ParametricCurve, Point, Scalar};

/// What connects the sides of an outer corner, as `stroke-linejoin` of SVG.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum LineJoin<S> {
    /// An arc around the corner: the points at the distance from it.
    #[default]
    Round,
    /// Both sides, continued as straight lines until they meet, if the tip is no farther from the corner than `limit` times the
    /// distance; otherwise as [`Bevel`](Self::Bevel). SVG's `stroke-miterlimit`, 4 unless it says otherwise.
    Miter {
        /// The largest quotient of both distances; below 1 there is no tip.
        limit: S,
    },
    /// A straight line from one side to the other.
    Bevel,
}

/// What closes the end of a stroke, as `stroke-linecap` of SVG.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum LineCap {
    /// A straight line through the end.
    #[default]
    Butt,
    /// Half of a circle around the end.
    Round,
    /// Half of a square around the end.
    Square,
}

/// The curve beside a curve in the plane, at a distance: `O(t) = C(t) + d N(t)` with the unit vector `N` a quarter turn
/// to the left of the direction of the curve. A positive distance is to the left, which is inside of a curve that runs
/// anticlockwise.
///
/// The answer consists of cubic segments, of arcs and lines at corners, one path for each contour of the curve. Every point
/// of a cubic segment is within the tolerance of the point `O(t)` at its parameter, and reaches all of them; the bound comes from
/// Bernstein coefficients. Where the radius of curvature is the distance `O` has a cusp, and so has the answer, at the end of
/// a segment. It runs back from there, and forth again after the next cusp: what is nearer to the curve than the distance is
/// left out by [`trimmed`](Self::trimmed). Without that, the sides of an inner corner are connected by a straight line.
///
/// ```
/// use basis_runtime::{LineJoin, Offset, ParametricCurve, Path};
///
/// let square = Path::<[f64; 2]>::rectangle([[0.0, 0.0], [2.0, 2.0]]);
/// let [outside] = Offset::new(-1.0, 1e-6)?.of(&square)?.try_into().unwrap();
/// assert!((outside.enclosed()?.area - (4.0 + 8.0 + std::f64::consts::PI)).abs() < 1e-12);
///
/// let [tips] = Offset::new(-1.0, 1e-6)?.join(LineJoin::Miter { limit: 4.0 }).of(&square)?.try_into().unwrap();
/// assert!((tips.enclosed()?.area - 16.0).abs() < 1e-12);
///
/// let [inside] = Offset::new(0.5, 1e-6)?.trimmed().of(&square)?.try_into().unwrap();
/// assert!((inside.enclosed()?.area - 1.0).abs() < 1e-6);
/// assert!(Offset::new(1.5, 1e-6)?.trimmed().of(&square)?.is_empty());
/// # Ok::<(), basis_runtime::CurveError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Offset<S> {
    distance: S,
    tolerance: S,
    join: LineJoin<S>,
    trim: bool,
}

impl<S: Scalar> Offset<S> {
    /// With round joins, not trimmed. Distance and tolerance are lengths in the unit of the points.
    ///
    /// # Errors
    /// [`CurveError::Distance`] if the distance is not finite, [`CurveError::Tolerance`] if the tolerance is not positive and
    /// finite.
    pub fn new(distance: S, tolerance: S) -> Result<Self, CurveError> {
        if !distance.is_finite() {
            return Err(CurveError::Distance { value: distance.to_f64() });
        }
        if !(tolerance > S::ZERO && tolerance.is_finite()) {
            return Err(CurveError::Tolerance { value: tolerance.to_f64() });
        }
        Ok(Self { distance, tolerance, join: LineJoin::Round, trim: false })
    }

    /// With other joins at the outer corners of the curve.
    #[must_use]
    pub fn join(mut self, join: LineJoin<S>) -> Self {
        self.join = join;
        self
    }

    /// Without the points that are nearer to the curve than the distance, by more than about the tolerance: the
    /// parallel curve is cut where it meets itself, turns round, or is at the distance from an end of the curve, and
    /// the parts that are far enough are put together again.
    ///
    /// A distance as small as rounding errors of the curve, or a curve as small as those of the distance, leaves everything
    /// there. There can be several paths then, or none, if every point at the distance is nearer to another part of the curve.
    #[must_use]
    pub fn trimmed(mut self) -> Self {
        self.trim = true;
        self
    }

    /// The paths beside a curve of any type, in the order of its contours. None of a contour that is a point.
    ///
    /// # Errors
    /// [`CurveError::Dimension`] if the points have not two components, [`CurveError::NotFinite`] if a control point is
    /// infinite or NaN, [`CurveError::TooManyPoints`] if more than 2¹⁶ segments of a piece of the curve would be needed.
    pub fn of<P: Point<Scalar = S>>(
        &self,
        curve: &(impl ParametricCurve<Point = P> + ?Sized),
    ) -> Result<Vec<Path<P>>, CurveError> {
        let pieces = plane_pieces(curve)?;
        let (distance, tolerance) = (self.distance.to_f64(), self.tolerance.to_f64());
        let paths = offset(&pieces, distance, tolerance, self.join.in_f64(), self.trim)?;
        Ok(paths.iter().map(in_type).collect())
    }
}

/// The outline of a line of some width along a curve in the plane: what SVG's `stroke` paints, by the rule `nonzero`.
///
/// It is the curve half of the width to the left and back half of the width to the right, as of [`Offset`], with caps
/// at the ends of open contours. A closed contour has two outlines, the second in the other direction. Where the radius
/// of curvature is smaller than half of the width, and at inner corners, the outline meets itself, inside of what is
/// painted.
///
/// ```
/// use basis_runtime::{LineCap, ParametricCurve, Path, Stroke};
///
/// let line = Path::<[f64; 2]>::polyline(&[[0.0, 0.0], [3.0, 4.0]])?;
/// let [outline] = Stroke::new(2.0, 1e-6)?.cap(LineCap::Round).of(&line)?.try_into().unwrap();
/// assert!((outline.enclosed()?.area.abs() - (10.0 + std::f64::consts::PI)).abs() < 1e-12);
/// # Ok::<(), basis_runtime::CurveError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke<S> {
    width: S,
    tolerance: S,
    join: LineJoin<S>,
    cap: LineCap,
}

impl<S: Scalar> Stroke<S> {
    /// With mitered corners, limit 4, and butt caps, as in SVG. Width and tolerance are lengths in the unit of the points.
    ///
    /// # Errors
    /// [`CurveError::Distance`] if the width is not positive and finite, [`CurveError::Tolerance`] if the tolerance is not.
    pub fn new(width: S, tolerance: S) -> Result<Self, CurveError> {
        if !(width > S::ZERO && width.is_finite()) {
            return Err(CurveError::Distance { value: width.to_f64() });
        }
        Offset::new(width, tolerance)?;
        Ok(Self { width, tolerance, join: LineJoin::Miter { limit: S::of(4.0) }, cap: LineCap::Butt })
    }

    /// With other joins at the outer corners.
    #[must_use]
    pub fn join(mut self, join: LineJoin<S>) -> Self {
        self.join = join;
        self
    }

    /// With other caps at both ends of open contours.
    #[must_use]
    pub fn cap(mut self, cap: LineCap) -> Self {
        self.cap = cap;
        self
    }

    /// The outlines along a curve of any type: one closed path for each open contour, two for each closed one. None of a
    /// contour that is a point.
    ///
    /// # Errors
    /// As [`Offset::of`].
    pub fn of<P: Point<Scalar = S>>(
        &self,
        curve: &(impl ParametricCurve<Point = P> + ?Sized),
    ) -> Result<Vec<Path<P>>, CurveError> {
        let pieces = plane_pieces(curve)?;
        let paths =
            stroke(&pieces, self.width.to_f64(), self.tolerance.to_f64(), self.join.in_f64(), self.cap)?;
        Ok(paths.iter().map(in_type).collect())
    }
}

impl<S: Scalar> LineJoin<S> {
    fn in_f64(self) -> LineJoin<f64> {
        match self {
            Self::Round => LineJoin::Round,
            Self::Miter { limit } => LineJoin::Miter { limit: limit.to_f64() },
            Self::Bevel => LineJoin::Bevel,
        }
    }
}

/// The pieces of a finite curve in the plane.
fn plane_pieces<P: Point>(
    curve: &(impl ParametricCurve<Point = P> + ?Sized),
) -> Result<Vec<CurvePiece>, CurveError> {
    if P::DIM != 2 {
        return Err(CurveError::Dimension { expected: 2, found: P::DIM });
    }
    let pieces = curve.pieces();
    if pieces.iter().all(CurvePiece::is_finite) { Ok(pieces) } else { Err(CurveError::NotFinite) }
}

/// A path over points of another type.
fn in_type<P: Point>(path: &Path<V>) -> Path<P> {
    let point = |p: &V| P::from_components(|d| P::Scalar::of(p[d.min(1)]));
    let segment = |segment: &PathSegment<V>| {
        let points = segment.control_points().iter().map(point).collect();
        let weights = segment.weights().unwrap_or_default().iter().map(|&w| P::Scalar::of(w)).collect();
        PathSegment::trusted(points, weights)
    };
    Path { segments: path.segments.iter().map(segment).collect() }
}

/// The pieces of each contour, and whether it is closed.
fn contours(pieces: &[CurvePiece]) -> Vec<(&[CurvePiece], bool)> {
    let largest = pieces.iter().map(CurvePiece::largest).fold(0.0, f64::max);
    let noise = 64.0 * f64::EPSILON * largest;
    let end = |piece: &CurvePiece, i: usize| [piece.control(i, 0), piece.control(i, 1)];
    let meet = |a: &CurvePiece, b: &CurvePiece| length(plus(end(a, a.degree()), end(b, 0), -1.0)) <= noise;
    let chunks = pieces.chunk_by(meet);
    chunks.map(|chunk| (chunk, meet(&chunk[chunk.len() - 1], &chunk[0]))).collect()
}

/// The stretches of a contour at that distance.
fn stretches(contour: &[CurvePiece], parallel: Parallel) -> Result<Vec<Stretch>, CurveError> {
    let mut all = Vec::new();
    for piece in contour {
        all.extend(parallel.of(piece)?);
    }
    Ok(all)
}

fn offset(
    pieces: &[CurvePiece],
    distance: f64,
    tolerance: f64,
    join: LineJoin<f64>,
    trim: bool,
) -> Result<Vec<Path<V>>, CurveError> {
    let contours = contours(pieces);
    if distance == 0.0 {
        let same = |(contour, _): &(&[CurvePiece], bool)| Path {
            segments: contour.iter().map(PathSegment::of_piece).collect(),
        };
        return Ok(contours.iter().map(same).collect());
    }
    let noise = noise(pieces, distance);
    // Where one is that small beside the other only rounding errors could be trimmed.
    let trim = trim && distance.abs().min(extent(pieces)) > 1e3 * noise;
    let joins = Joins { distance, join, inner: Inner::Straight, noise };
    let round = Joins { join: LineJoin::Round, ..joins };
    let parallel = Parallel { distance, tolerance, evolute: false };
    let mut raws = Vec::new();
    let (mut ends, mut barriers) = (Vec::new(), Vec::new());
    for (contour, closed) in contours {
        let stretches = self::stretches(contour, parallel)?;
        if trim {
            // What is nearer to the curve than the distance may be so on its other side, or next to a corner.
            let other = self::stretches(contour, Parallel { distance: -distance, ..parallel })?;
            barriers.push(Joins { distance: -distance, ..round }.outline(other, closed));
            if join != LineJoin::Round {
                barriers.push(round.outline(self::stretches(contour, parallel)?, closed));
            }
        }
        if !closed && let (Some(first), Some(last)) = (stretches.first(), stretches.last()) {
            ends.extend([first.ends[0].base, last.ends[1].base]);
        }
        raws.push(Raw { parts: joins.outline(stretches, closed), closed });
    }
    if trim {
        let trim = Trim { base: pieces, ends: &ends, barriers: &barriers, distance, tolerance };
        return Ok(trim.run(raws));
    }
    let segments = |raw: Raw| raw.parts.into_iter().map(|part| part.segment).collect();
    Ok(raws.into_iter().filter_map(|raw| Path::new(segments(raw)).ok()).collect())
}

fn stroke(
    pieces: &[CurvePiece],
    width: f64,
    tolerance: f64,
    join: LineJoin<f64>,
    cap: LineCap,
) -> Result<Vec<Path<V>>, CurveError> {
    let half = 0.5 * width;
    let joins = Joins { distance: half, join, inner: Inner::ByCorner, noise: noise(pieces, half) };
    let mut outlines = Vec::new();
    for (contour, closed) in contours(pieces) {
        let parallel = Parallel { distance: half, tolerance, evolute: true };
        let left = stretches(contour, parallel)?;
        let right = stretches(contour, Parallel { distance: -half, ..parallel })?;
        let (Some(first), Some(last)) = (left.first(), left.last()) else { continue };
        let [start, end] = [first.ends[0], last.ends[1]];
        let start = Place { tangent: start.tangent.map(|x| -x), ..start };
        let [at_end, at_start] = [end, start].map(|place| joins.cap(place, cap));
        let left = joins.outline(left, closed);
        let right = Joins { distance: -half, ..joins }.outline(right, closed);
        let right = Joins::reversed(right);
        if closed {
            outlines.extend([left, right]);
        } else {
            let mut outline = [left, at_end, right, at_start].concat();
            connect(&mut outline, true);
            outlines.push(outline);
        }
    }
    let segments = |parts: Vec<parallel::Part>| parts.into_iter().map(|part| part.segment).collect();
    Ok(outlines.into_iter().filter_map(|parts| Path::new(segments(parts)).ok()).collect())
}

/// The length of a side of a square that the curve fits into.
fn extent(pieces: &[CurvePiece]) -> f64 {
    let sides = crate::geometry::control_box(pieces);
    sides.iter().map(|[low, high]| high - low).fold(0.0, f64::max)
}

/// The size of rounding errors beside a curve.
fn noise(pieces: &[CurvePiece], distance: f64) -> f64 {
    let largest = pieces.iter().map(CurvePiece::largest).fold(distance.abs(), f64::max);
    256.0 * f64::EPSILON * largest
}
