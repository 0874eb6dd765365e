//! What a joint sees of a surface: the row of control points on the edge and the one next to it, in double precision.

use alloc::vec::Vec;

use super::SpliceError;
use crate::bspline::rows::{self, Rows};
use crate::bspline::{BSplineSurface, Direction, Edge, KnotError, KnotVector, Orientation};
use crate::{Point, Point3, Scalar};

pub(in crate::bspline) type Vector = [f64; 3];

/// The other direction than the one across the edge.
pub(in crate::bspline) fn along(edge: Edge) -> Direction {
    match edge.across() {
        Direction::U => Direction::V,
        Direction::V => Direction::U,
    }
}

/// The index of the row (or column) at that distance from the edge, and of the point at that place along it.
pub(in crate::bspline) fn place<P: Point>(
    surface: &BSplineSurface<P>,
    edge: Edge,
    layer: usize,
    along: usize,
) -> [usize; 2] {
    let across = surface.knots(edge.across()).functions();
    let layer = if edge.is_end() { across - 1 - layer } else { layer };
    match edge.across() {
        Direction::U => [layer, along],
        Direction::V => [along, layer],
    }
}

/// A parameter along one edge as one along another edge, both over their domains.
pub(in crate::bspline) fn mapped_parameter(
    t: f64,
    [a, b]: [f64; 2],
    [lo, hi]: [f64; 2],
    orientation: Orientation,
) -> f64 {
    let part = match orientation {
        Orientation::Same if [a, b] == [lo, hi] => return t.clamp(lo, hi),
        Orientation::Same => (t - a) / (b - a),
        Orientation::Opposite => 1.0 - (t - a) / (b - a),
    };
    if part <= 0.0 {
        lo
    } else if part >= 1.0 {
        hi
    } else {
        lo + (hi - lo) * part
    }
}

/// Clamped knots along an edge over the domain `[lo, hi]` of another one, run through backwards if the orientation is
/// opposite. Those that agree with one of `grid` up to rounding errors of the scalar type become equal to it; all are
/// made numbers of that type.
pub(in crate::bspline) fn mapped_knots<S: Scalar>(
    knots: &KnotVector<f64>,
    [lo, hi]: [f64; 2],
    orientation: Orientation,
    grid: &KnotVector<f64>,
) -> Result<KnotVector<f64>, KnotError> {
    let near = 16.0 * S::EPSILON.to_f64() * (hi - lo).max(lo.abs()).max(hi.abs());
    let breakpoints = grid.breakpoints();
    let map = |&t: &f64| {
        let mapped = mapped_parameter(t, knots.domain(), [lo, hi], orientation);
        let after = breakpoints.partition_point(|&knot| knot < mapped);
        let around = after.saturating_sub(1)..(after + 1).min(breakpoints.len());
        let nearest = breakpoints[around].iter().copied().find(|knot| (knot - mapped).abs() <= near);
        nearest.unwrap_or_else(|| S::of(mapped).to_f64().clamp(lo, hi))
    };
    let mut mapped: Vec<f64> = knots.as_slice().iter().map(map).collect();
    if orientation == Orientation::Opposite {
        mapped.reverse();
    }
    KnotVector::new(knots.degree(), mapped)
}

/// Two rows along an edge, over a clamped knot vector.
#[derive(Clone, Debug)]
pub(in crate::bspline) struct Strip {
    /// The knots along the edge.
    pub(in crate::bspline) knots: KnotVector<f64>,
    /// The row on the edge.
    pub(in crate::bspline) edge: Vec<Vector>,
    /// The row next to it.
    pub(in crate::bspline) inner: Vec<Vector>,
    /// The derivative across the edge, pointing into the surface, is `factor (inner - edge)`.
    pub(in crate::bspline) factor: f64,
}

/// A strip at one parameter.
#[derive(Clone, Copy, Debug)]
pub(in crate::bspline) struct Frame {
    pub(in crate::bspline) point: Vector,
    /// The derivative along the edge.
    pub(in crate::bspline) tangent: Vector,
    /// `inner - edge`.
    pub(in crate::bspline) across: Vector,
}

impl Strip {
    /// The strip of a clamped surface.
    pub(in crate::bspline) fn new<P: Point3>(
        surface: &BSplineSurface<P>,
        edge: Edge,
    ) -> Result<Self, SpliceError> {
        let knots = surface.knots(along(edge)).to_f64();
        let row = |layer| {
            let point = |j| {
                let point = surface.net()[place(surface, edge, layer, j)];
                [0, 1, 2].map(|i| point.component(i).to_f64())
            };
            (0..knots.functions()).map(point).collect::<Vec<_>>()
        };
        let across = surface.knots(edge.across()).to_f64();
        let (k, n) = (across.degree(), across.functions());
        if n < 2 {
            return Err(SpliceError::OneRow);
        }
        let t = across.as_slice();
        let width = if edge.is_end() { t[n] - t[n - 1] } else { t[k + 1] - t[k] };
        // With a jump right at the edge (degree 0) there is no derivative across it.
        let factor = if width > 0.0 { k.max(1) as f64 / width } else { 1.0 };
        let (edge, inner) = (row(0), row(1));
        let finite = |row: &[Vector]| row.iter().flatten().all(|x| x.is_finite());
        if !finite(&edge) || !finite(&inner) {
            return Err(SpliceError::NotFinite);
        }
        Ok(Self { knots, edge, inner, factor })
    }

    /// The strip over another domain, run through backwards if the orientation is opposite: see [`mapped_knots`].
    pub(in crate::bspline) fn mapped<S: Scalar>(
        &self,
        domain: [f64; 2],
        orientation: Orientation,
        grid: &KnotVector<f64>,
    ) -> Result<Self, SpliceError> {
        let knots = mapped_knots::<S>(&self.knots, domain, orientation, grid)?;
        let (mut edge, mut inner) = (self.edge.clone(), self.inner.clone());
        if orientation == Orientation::Opposite {
            edge.reverse();
            inner.reverse();
        }
        Ok(Self { knots, edge, inner, factor: self.factor })
    }

    fn rows(&self) -> Rows<f64, Vector> {
        let points = self.edge.iter().zip(&self.inner).flat_map(|(&a, &b)| [a, b]).collect();
        Rows { knots: self.knots.clone(), points, lanes: 2 }
    }

    fn with_rows(&self, rows: &Rows<f64, Vector>) -> Self {
        let row = |lane: usize| rows.points.iter().skip(lane).step_by(2).copied().collect();
        Self { knots: rows.knots.clone(), edge: row(0), inner: row(1), factor: self.factor }
    }

    /// The same strip over more knots.
    pub(in crate::bspline) fn inserted(&self, knots: &[f64]) -> Result<Self, SpliceError> {
        Ok(self.with_rows(&rows::insert(&self.rows(), knots)?))
    }

    /// The same strip, of at least that degree.
    pub(in crate::bspline) fn elevated(&self, degree: usize) -> Result<Self, SpliceError> {
        let mut rows = self.rows();
        while rows.knots.degree() < degree {
            rows = rows::elevate(&rows)?;
        }
        Ok(self.with_rows(&rows))
    }

    /// The same strip with the second row at another distance: the derivative across the edge stays, its factor
    /// changes.
    pub(in crate::bspline) fn with_factor(&self, factor: f64) -> Self {
        if factor == self.factor {
            return self.clone();
        }
        let ratio = self.factor / factor;
        let rows = self.edge.iter().zip(&self.inner);
        let inner = rows.map(|(edge, inner)| edge.add_scaled(inner.minus(*edge), ratio)).collect();
        Self { knots: self.knots.clone(), edge: self.edge.clone(), inner, factor }
    }

    /// The points of the edge on which a span depends.
    pub(in crate::bspline) fn local_points(&self, span: usize) -> impl Iterator<Item = Vector> + '_ {
        self.edge[span - self.knots.degree()..=span].iter().copied()
    }

    /// The polynomial piece of that span at any parameter.
    pub(in crate::bspline) fn frame(&self, span: usize, t: f64) -> Frame {
        let first = span - self.knots.degree();
        let mut frame = Frame { point: [0.0; 3], tangent: [0.0; 3], across: [0.0; 3] };
        let values = self.knots.values_on(span, t);
        let slopes = self.knots.derivatives_on(span, t, 1);
        for (j, (&value, &slope)) in values.iter().zip(slopes.iter()).enumerate() {
            let (edge, inner) = (self.edge[first + j], self.inner[first + j]);
            frame.point = frame.point.add_weighted(edge, value);
            frame.tangent = frame.tangent.add_weighted(edge, slope);
            frame.across = frame.across.add_scaled(inner.minus(edge), value);
        }
        frame
    }

    pub(in crate::bspline) fn at(&self, t: f64) -> Frame {
        self.frame(self.knots.span(t), t)
    }

    /// Whether the tangent along the edge may jump.
    pub(in crate::bspline) fn is_creased(&self) -> bool {
        let [lo, hi] = self.knots.domain();
        let inner =
            self.knots.as_slice().chunk_by(|a, b| a == b).filter(|group| group[0] > lo && group[0] < hi);
        inner.into_iter().any(|group| group.len() >= self.knots.degree())
    }

    pub(in crate::bspline) fn spans(&self) -> usize {
        self.knots.spans().count()
    }
}
