//! How far two strips are from each other, and at which angle they meet.

use alloc::vec::Vec;

use super::bounds;
use super::strip::{Strip, Vector};
use super::{Continuity, SpliceError};
use crate::bspline::{BSplineSurface, EdgePair, KnotVector};
use crate::curve::leading_order;
use crate::vector::{cross, length};
use crate::{Point3, Scalar};

/// How two B-spline surfaces meet along an edge, by [`BSplineSurface::joint_bounds`]: upper bounds that are proved for all
/// parameters of the edge and not just for samples.
///
/// The gap bounds that of an [`EdgeJoint`](crate::EdgeJoint). The angle is the one between the normals, while an `EdgeJoint`
/// has the one between the directions in which the surfaces go on. Both are the same where the edges have the same tangent.
/// Where they do not, as in the presence of a gap, either may be larger: surfaces in one plane have equal normals, but do
/// not continue each other across edges that cross at an angle.
///
/// They follow from the Bernstein coefficients of the difference of the edges and of the products of the normals, and
/// are at most one percent above the largest value but for rounding errors: about a hundred of them are added, so an
/// angle of zero is some `1e-13`. For degrees above 250 along the edge nothing better than the angle π is proved.
///
/// Where a normal vanishes at a knot, as at a pole, its limit counts. Where one vanishes inside of a piece between two
/// knots, which needs a cusp of the edge or directions that become parallel, the nearest 1e-4 of the piece have no
/// angle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct JointBounds {
    /// No two points that belong together are farther from each other, in the unit of the points.
    pub gap: f64,
    /// Where that distance occurs, up to one percent: the parameter of the first surface along its edge.
    pub gap_at: f64,
    /// Nowhere is the angle between the normals larger, in radians, each normal being the product of the direction across
    /// the edge, out of the first surface and into the second, and the direction along the edge: 0 where the joint is
    /// smooth, π where one surface folds back on the other. A splice of [`Continuity::G0`](super::Continuity::G0) leaves out
    /// the pieces without tangent planes.
    pub angle: f64,
    /// Where that angle occurs, up to one percent: the parameter of the first surface along its edge.
    pub angle_at: f64,
}

impl JointBounds {
    /// The order of geometric continuity that is proved: 1 for G1, 0 for G0, or `None` if there may be a gap.
    /// Curvatures are not bounded: [`Surface::joint`](crate::Surface::joint) measures them.
    ///
    /// The tolerances are in the unit of length, and in radians.
    pub fn geometric_order(&self, gap: f64, angle: f64) -> Option<usize> {
        leading_order(self.gap <= gap, [self.angle <= angle])
    }

    /// How many times as large as a tolerance the worse of both figures is; at most 1 if both are met.
    pub(in crate::bspline) fn excess(&self, gap: f64, angle: f64) -> f64 {
        (self.gap / gap).max(self.angle / angle)
    }
}

impl<P: Point3> BSplineSurface<P> {
    /// Bounds of the gap and of the angle between this surface and `next` along an edge of each, for all parameters of
    /// the edge, which correspond by the affine map.
    ///
    /// ```
    /// use basis_runtime::bspline::{BSplineSurface, Direction, Edge, EdgePair, KnotVector, Net};
    ///
    /// let knots = KnotVector::uniform(3, 2)?;
    /// let net = Net::from_fn(5, 5, |i, j| [i as f64, j as f64, (i * j % 3) as f64])?;
    /// let [left, right] = BSplineSurface::new(knots.clone(), knots, net)?.split(Direction::U, 0.25)?;
    /// let joint = left.joint_bounds(EdgePair::along(Edge::UEnd, Edge::UStart), &right)?;
    /// assert_eq!(joint.geometric_order(1e-12, 1e-12), Some(1));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SpliceError::NotFinite`] if a control point near the edges is not finite, [`SpliceError::OneRow`] if a surface
    /// has one row of control points only, [`SpliceError::Degenerate`] if a tangent plane is missing,
    /// [`SpliceError::Knots`] if the knots come so near to each other that rounding makes them equal too often.
    pub fn joint_bounds(&self, edges: EdgePair, next: &Self) -> Result<JointBounds, SpliceError> {
        measured(self, next, edges, Continuity::G1)
    }
}

/// [`BSplineSurface::joint_bounds`] for a joint that is to have that continuity.
pub(super) fn measured<P: Point3>(
    first: &BSplineSurface<P>,
    next: &BSplineSurface<P>,
    edges: EdgePair,
    continuity: Continuity,
) -> Result<JointBounds, SpliceError> {
    let strip = Strip::new(&first.clamped(), edges.first)?;
    let other = Strip::new(&next.clamped(), edges.second)?;
    let other = other.mapped::<P::Scalar>(strip.knots.domain(), edges.orientation, &strip.knots)?;
    Ok(measure(&strip, &other, continuity)?.0)
}

/// The same for one piece of the joint.
#[derive(Clone, Copy, Debug)]
pub(in crate::bspline) struct Piece {
    pub(in crate::bspline) ends: [f64; 2],
    pub(in crate::bspline) gap: f64,
    pub(in crate::bspline) angle: f64,
}

/// The largest gap and angle, and those of each piece, for strips over the same domain. Tangent planes must exist for
/// [`Continuity::G1`] only.
pub(in crate::bspline) fn measure(
    strip: &Strip,
    target: &Strip,
    continuity: Continuity,
) -> Result<(JointBounds, Vec<Piece>), SpliceError> {
    let mut breakpoints = strip.knots.breakpoints();
    breakpoints.extend(target.knots.breakpoints());
    breakpoints.sort_by(f64::total_cmp);
    breakpoints.dedup();
    let mut whole = JointBounds { gap: 0.0, gap_at: breakpoints[0], angle: 0.0, angle_at: breakpoints[0] };
    let mut pieces = Vec::with_capacity(breakpoints.len());
    for ends in breakpoints.windows(2) {
        let ends @ [lo, hi] = [ends[0], ends[1]];
        let middle = lo + (hi - lo) * 0.5;
        let strips = [strip, target];
        let spans = strips.map(|strip| strip.knots.span(middle));
        let gap = bounds::gap(strips, spans, ends);
        let angle = match (bounds::angle(strips, spans, ends), continuity) {
            (Some(angle), _) => angle,
            (None, Continuity::G0) => bounds::Bound { most: 0.0, at: 0.0 },
            (None, _) => return Err(SpliceError::Degenerate { parameter: lo }),
        };
        if gap.most > whole.gap {
            (whole.gap, whole.gap_at) = (gap.most, lo + (hi - lo) * gap.at);
        }
        if angle.most > whole.angle {
            (whole.angle, whole.angle_at) = (angle.most, lo + (hi - lo) * angle.at);
        }
        pieces.push(Piece { ends, gap: gap.most, angle: angle.most });
    }
    Ok((whole, pieces))
}

/// The unit normal of the plane of two vectors; `None` if they are parallel up to rounding errors.
pub(in crate::bspline) fn normal(across: Vector, tangent: Vector) -> Option<Vector> {
    let across = crate::vector::direction(across)?;
    let tangent = crate::vector::direction(tangent)?;
    let normal = cross(across, tangent);
    (length(normal) > 1e-12).then(|| crate::vector::direction(normal)).flatten()
}

/// The middle of each span of the strip in which a piece is over a tolerance, as a number of the scalar type.
///
/// Neighbours that are much wider are divided too: a spline couples them, and their error would stay.
pub(in crate::bspline) fn middles<S: Scalar>(
    knots: &KnotVector<f64>,
    pieces: &[Piece],
    gap: f64,
    angle: f64,
) -> Vec<f64> {
    let all = knots.as_slice();
    let spans: Vec<[f64; 2]> = knots.spans().map(|span| [all[span], all[span + 1]]).collect();
    let bad = |&[lo, hi]: &[f64; 2]| {
        let from = pieces.partition_point(|piece| piece.ends[0] < lo);
        let inside = pieces[from..].iter().take_while(|piece| piece.ends[1] <= hi);
        inside.into_iter().any(|piece| piece.gap > gap || piece.angle > angle)
    };
    let bad: Vec<bool> = spans.iter().map(bad).collect();
    let width = |i: usize| spans[i][1] - spans[i][0];
    let chosen = |&i: &usize| {
        let next_to = |j: usize| bad.get(j) == Some(&true) && width(i) > 1.5 * width(j);
        bad[i] || next_to(i + 1) || i > 0 && next_to(i - 1)
    };
    (0..spans.len())
        .filter(chosen)
        .filter_map(|i| {
            let [lo, hi] = spans[i];
            let middle = S::of(lo + (hi - lo) * 0.5).to_f64();
            // A span so short that its middle is one of its ends cannot be divided.
            (middle > lo && middle < hi).then_some(middle)
        })
        .collect()
}
