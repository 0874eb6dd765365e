//! How far two strips are from each other, and at which angle they meet.

use alloc::vec::Vec;

use super::bounds;
use super::strip::{Strip, Vector};
use super::{Continuity, SpliceError};
use crate::Scalar;
use crate::bspline::KnotVector;
use crate::vector::{cross, length};

/// The gap and the angle along a joint, proved for all of its parameters and not just for samples.
///
/// Both are upper bounds, from the Bernstein coefficients of the difference of the edges and of the products of the
/// normals, at most one percent above the largest value but for rounding errors: about a hundred of them are added, so
/// an angle of zero is some `1e-13`. For degrees above 250 along the edge nothing better than the angle π is proved.
///
/// Where a normal vanishes at a knot, as at a pole, its limit counts. Where one vanishes inside of a piece between two
/// knots, which needs a cusp of the edge or directions that become parallel, the nearest 1e-4 of the piece have no
/// angle.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct JointMeasure {
    /// The largest distance between points of the two edges with corresponding parameters, in the unit of the points.
    pub gap: f64,
    /// A parameter at which it occurs, up to one percent.
    pub gap_at: f64,
    /// The largest angle between the tangent planes, in radians from 0 to π; above π/2 one surface folds back over the
    /// other. A splice of [`Continuity::G0`](super::Continuity::G0) leaves out the pieces without tangent planes.
    pub angle: f64,
    /// A parameter at which it occurs, up to one percent.
    pub angle_at: f64,
}

impl JointMeasure {
    /// How many times as large as a tolerance the worse of both figures is; at most 1 if both are met.
    pub(in crate::bspline) fn excess(&self, gap: f64, angle: f64) -> f64 {
        (self.gap / gap).max(self.angle / angle)
    }
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
) -> Result<(JointMeasure, Vec<Piece>), SpliceError> {
    let mut breakpoints = strip.knots.breakpoints();
    breakpoints.extend(target.knots.breakpoints());
    breakpoints.sort_by(f64::total_cmp);
    breakpoints.dedup();
    let mut whole = JointMeasure { gap: 0.0, gap_at: breakpoints[0], angle: 0.0, angle_at: breakpoints[0] };
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
