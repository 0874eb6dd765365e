//! The third row, for continuous curvatures.
//!
//! Where the derivatives across the edge, into both surfaces, are `S_n = -c T_n` with a constant `c`, and the second ones
//! `S_nn = c² T_nn`, the surface continues the target as if it were a part of it, over parameters that are `c` times as long:
//! all second derivatives agree, and so all normal curvatures. With the first two rows that [`exact`](super::exact) finds the
//! first equation holds; this one sets the third row so that the second does. At an end with the first spans `h1` and `h2`, the
//! second one from the end on,
//!
//! ```text
//! S_nn = k (k - 1) / h1 ((P[2] - P[1]) / h2 - (P[1] - P[0]) / h1)
//! ```

use alloc::vec::Vec;

use super::SpliceError;
use super::strip::{Strip, Vector, along, place};
use crate::bspline::{BSplineSurface, Edge};
use crate::{Point, Point3, Scalar};

/// What the second derivative across a clamped edge depends on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Across {
    degree: f64,
    /// From the edge to the end of the first span, and of the second one.
    widths: [f64; 2],
}

impl Across {
    /// `None` below degree 2, where the second derivative is zero.
    pub(super) fn new<P: Point3>(surface: &BSplineSurface<P>, edge: Edge) -> Option<Self> {
        let knots = surface.knots(edge.across()).to_f64();
        let (k, n, t) = (knots.degree(), knots.functions(), knots.as_slice());
        let width = |spans: usize| if edge.is_end() { t[n] - t[n - spans] } else { t[k + spans] - t[k] };
        (k >= 2).then(|| Self { degree: k as f64, widths: [width(1), width(2)] })
    }

    /// The second derivative from three rows.
    fn second(self, [p0, p1, p2]: [Vector; 3]) -> Vector {
        let [h1, h2] = self.widths;
        let [step, next] = [p1.minus(p0).scale(1.0 / h1), p2.minus(p1).scale(1.0 / h2)];
        next.minus(step).scale(self.degree * (self.degree - 1.0) / h1)
    }

    /// The third row for a second derivative.
    fn third(self, [p0, p1]: [Vector; 2], second: Vector) -> Vector {
        let [h1, h2] = self.widths;
        let step = p1.minus(p0).scale(1.0 / h1);
        p1.add_weighted(step.add_weighted(second, h1 / (self.degree * (self.degree - 1.0))), h2)
    }
}

/// A strip whose rows are both `row`: what a strip is turned, raised and refined by serves any row along an edge.
fn along_edge(strip: &Strip, row: Vec<Vector>) -> Result<Strip, SpliceError> {
    if !row.iter().flatten().all(|x| x.is_finite()) {
        return Err(SpliceError::NotFinite);
    }
    Ok(Strip { knots: strip.knots.clone(), inner: row.clone(), edge: row, factor: strip.factor })
}

/// A row of control points of a clamped surface.
pub(super) fn row<P: Point3>(
    surface: &BSplineSurface<P>,
    edge: Edge,
    layer: usize,
    strip: &Strip,
) -> Result<Strip, SpliceError> {
    let point = |j| {
        let point = surface.net()[place(surface, edge, layer, j)];
        [0, 1, 2].map(|i| point.component(i).to_f64())
    };
    along_edge(strip, (0..surface.knots(along(edge)).functions()).map(point).collect())
}

/// The second derivatives of a clamped surface across an edge, as the control points of a curve along it.
pub(super) fn seconds<P: Point3>(
    surface: &BSplineSurface<P>,
    edge: Edge,
    strip: &Strip,
) -> Result<Strip, SpliceError> {
    let Some(across) = Across::new(surface, edge) else {
        return along_edge(strip, alloc::vec![[0.0; 3]; strip.edge.len()]);
    };
    let third = row(surface, edge, 2, strip)?;
    let rows = strip.edge.iter().zip(&strip.inner).zip(&third.edge);
    along_edge(strip, rows.map(|((&p0, &p1), &p2)| across.second([p0, p1, p2])).collect())
}

/// The third row of a strip with the second derivatives `rate²` times those of the target.
pub(super) fn solved(strip: &Strip, across: Across, seconds: &Strip, rate: f64) -> Vec<Vector> {
    let rows = strip.edge.iter().zip(&strip.inner).zip(&seconds.edge);
    rows.map(|((&p0, &p1), second)| across.third([p0, p1], second.scale(rate * rate))).collect()
}
