//! Curves of rational Bézier segments of any degrees: what a drawing consists of.

mod approximate;
mod offset;
mod segment;
mod shapes;
#[cfg(feature = "bspline")]
mod simplify;
mod svg;

use alloc::vec::Vec;
use core::ops::Range;

pub use offset::{LineCap, LineJoin, Offset, Stroke};
pub use segment::PathSegment;
pub use svg::{SvgError, SvgMistake, to_svg};

use crate::curve::backwards;
use crate::curve::{divisible, nonempty};
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::{CurveError, CurvePiece, JoinableCurve, ParametricCurve, Point, Scalar};

/// A curve of one or more Bézier segments, polynomial or rational, each of a degree of its own.
///
/// It holds every curve of this crate exactly ([`Path::from_curve`]), several of them one after the other
/// ([`append`](Self::append)), lines, arcs, circles, ellipses and rectangles, and what the attribute `d` of an SVG path
/// says ([`from_svg`](Self::from_svg), [`to_svg`]). All that can be asked of a curve can be asked of it:
/// it is a [`ParametricCurve`].
///
/// Its parameter runs from 0 to the number of segments: segment `k` lies over `k <= u <= k + 1`. At a whole number the
/// later segment counts, but for the end of the curve.
///
/// ```
/// use basis_runtime::{Bezier, ParametricCurve, Path};
///
/// let mut outline = Path::<[f64; 2]>::circle_arc([0.0, 0.0], 1.0, 0.0, std::f64::consts::PI);
/// outline.append(&Bezier::from_points([[-1.0, 0.0], [0.0, -1.0], [1.0, 0.0]]));
/// assert!(outline.is_closed());
/// // Half of a disk, and the part of a parabola below it.
/// let area = outline.enclosed().unwrap().area;
/// assert!((area - (std::f64::consts::FRAC_PI_2 + 2.0 / 3.0)).abs() < 1e-14);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "crate::serialize::path::Segments<P>"))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
pub struct Path<P: Point> {
    /// At least one.
    segments: Vec<PathSegment<P>>,
}

impl<P: Point> From<PathSegment<P>> for Path<P> {
    fn from(segment: PathSegment<P>) -> Self {
        Self { segments: alloc::vec![segment] }
    }
}

impl<P: Point> Path<P> {
    /// The curve of these segments, one after the other. Nothing is asked of how they meet.
    ///
    /// # Errors
    /// [`CurveError::NoSegments`] if there are none.
    pub fn new(segments: Vec<PathSegment<P>>) -> Result<Self, CurveError> {
        if segments.is_empty() { Err(CurveError::NoSegments) } else { Ok(Self { segments }) }
    }

    /// Any curve, exactly but for rounding: one segment for each of its Bézier [`pieces`](ParametricCurve::pieces). Of a
    /// curve that is rational in another parameter than its own, see [`Chart`](crate::Chart), the points stay and the
    /// parameter changes.
    pub fn from_curve(curve: &(impl ParametricCurve<Point = P> + ?Sized)) -> Self {
        Self { segments: curve.pieces().iter().map(PathSegment::of_piece).collect() }
    }

    /// Adds a segment to the end.
    pub fn push(&mut self, segment: PathSegment<P>) {
        self.segments.push(segment);
    }

    /// Adds a curve of any type to the end. If it does not begin where this one ends, the path jumps there.
    pub fn append(&mut self, curve: &(impl ParametricCurve<Point = P> + ?Sized)) {
        self.segments.extend(curve.pieces().iter().map(PathSegment::of_piece));
    }

    /// Adds a straight line from the end to a point.
    pub fn line_to(&mut self, point: P) {
        self.segments.push(PathSegment::line(self.end(), point));
    }

    /// Adds a straight line from the end to the start, if these are different points.
    pub fn close(&mut self) {
        let start = self.start();
        if self.end() != start {
            self.line_to(start);
        }
    }

    /// Whether the end is the start, exactly.
    pub fn is_closed(&self) -> bool {
        self.start() == self.end()
    }

    /// The segments, at least one.
    pub fn segments(&self) -> &[PathSegment<P>] {
        &self.segments
    }

    /// The image under an affine map, exactly: control points are mapped, and weights stay.
    ///
    /// The maps of the libraries of points can be used: `path.map(|p| map * p)` with those of nalgebra,
    /// `path.map(|p| map.transform_point2(p))` with those of glam. Of a map that is not affine the result is the curve over the
    /// images of the control points, not the image of the curve.
    ///
    /// ```
    /// use basis_runtime::{ParametricCurve, Path};
    ///
    /// let circle = Path::<[f64; 2]>::circle([0.0, 0.0], 1.0);
    /// let ellipse = circle.map(|[x, y]| [3.0 * x + y + 5.0, y]);
    /// assert!((ellipse.enclosed().unwrap().area / circle.enclosed().unwrap().area - 3.0).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn map<Q: Point<Scalar = P::Scalar>>(&self, mut map: impl FnMut(P) -> Q) -> Path<Q> {
        Path { segments: self.segments.iter().map(|segment| segment.map(&mut map)).collect() }
    }

    crate::affine::transform!();

    /// The segment of a parameter, and the parameter `0 <= x <= 1` on it. Parameters outside of the domain belong to the
    /// first and the last segment, which are continued; NaN belongs to the first.
    pub fn locate(&self, u: P::Scalar) -> (usize, P::Scalar) {
        // The cast rounds down, and takes NaN and negative numbers to 0.
        let index = (u.to_f64() as usize).min(self.segments.len() - 1);
        (index, u - P::Scalar::from_usize(index))
    }
}

impl<P: Point> ParametricCurve for Path<P> {
    type Point = P;
    type Part = Self;

    fn domain(&self) -> [P::Scalar; 2] {
        [P::Scalar::ZERO, P::Scalar::from_usize(self.segments.len())]
    }

    fn eval(&self, u: P::Scalar) -> P {
        let (index, x) = self.locate(u);
        self.segments[index].eval(x)
    }

    fn derivatives_into(&self, u: P::Scalar, derivatives: &mut [P::Vector]) {
        let (index, x) = self.locate(u);
        self.segments[index].derivatives_into(x, derivatives);
    }

    fn pieces(&self) -> Vec<CurvePiece> {
        let numbered = self.segments.iter().enumerate();
        numbered.map(|(k, segment)| segment.to_piece([k, k + 1].map(P::Scalar::from_usize))).collect()
    }

    fn start(&self) -> P {
        self.segments[0].start()
    }

    fn end(&self) -> P {
        self.segments[self.segments.len() - 1].end()
    }

    fn split(&self, u: P::Scalar) -> Result<[Self; 2], CurveError> {
        divisible(self.domain(), u)?;
        let (index, x) = self.locate(u);
        let (mut before, mut after) = (self.segments[..index].to_vec(), self.segments[index..].to_vec());
        if x > P::Scalar::ZERO {
            let [left, right] = after[0].split(x);
            before.push(left);
            after[0] = right;
        }
        Ok([Self { segments: before }, Self { segments: after }])
    }

    fn subsegment(&self, range: Range<P::Scalar>) -> Result<Self, CurveError> {
        nonempty(self.domain(), &range)?;
        let backwards = range.start > range.end;
        let [low, high] = if backwards { [range.end, range.start] } else { [range.start, range.end] };
        let mut segments = Vec::new();
        for (k, segment) in self.segments.iter().enumerate() {
            let [first, last] = [k, k + 1].map(P::Scalar::from_usize);
            if high > first && low < last {
                let from = if low > first { low - first } else { P::Scalar::ZERO };
                let to = if high < last { high - first } else { P::Scalar::ONE };
                segments.push(segment.restricted(from, to));
            }
        }
        if backwards {
            segments.reverse();
            segments = segments.iter().map(PathSegment::reversed).collect();
        }
        Ok(Self { segments })
    }

    fn reversed(&self) -> Self {
        Self { segments: self.segments.iter().rev().map(PathSegment::reversed).collect() }
    }
}

/// Only the first or the last segment is changed.
impl<P: Point> JoinableCurve for Path<P> {
    fn highest_contact(&self) -> usize {
        let [first, .., last] = &self.segments[..] else { return self.segments[0].degree() };
        first.degree().min(last.degree())
    }

    fn with_start(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        let mut path = self.clone();
        path.segments[0] = path.segments[0].with_start(derivatives)?;
        Ok(path)
    }

    fn with_end(&self, derivatives: &[P::Vector]) -> Result<Self, CurveError> {
        Ok(self.reversed().with_start(&backwards(derivatives))?.reversed())
    }
}
