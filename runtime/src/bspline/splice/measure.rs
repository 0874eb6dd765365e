//! How far two strips are from each other, and at which angle they meet.

use alloc::vec::Vec;

use super::strip::{Frame, Strip, Vector};
use super::{Continuity, SpliceError};
use crate::bspline::KnotVector;
use crate::vector::{cross, dot, length};
use crate::{Point, Scalar};

/// Samples in each piece on which both strips are polynomial, its ends included.
pub(in crate::bspline) const SAMPLES: usize = 13;

/// The gap and the angle along a joint.
///
/// Measured at 13 parameters, ends included, of each piece between neighbouring knots of either surface.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct JointMeasure {
    /// The largest distance between points of the two edges with corresponding parameters.
    pub gap: f64,
    /// The parameter at which it occurs.
    pub gap_at: f64,
    /// The largest angle between the tangent planes, in radians from 0 to π; above π/2 one surface folds back over the
    /// other. A splice of [`Continuity::G0`](super::Continuity::G0) leaves out the parameters without tangent planes.
    pub angle: f64,
    /// The parameter at which it occurs.
    pub angle_at: f64,
    /// The number of samples.
    pub samples: usize,
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
    let mut whole =
        JointMeasure { gap: 0.0, gap_at: breakpoints[0], angle: 0.0, angle_at: breakpoints[0], samples: 0 };
    let mut pieces = Vec::with_capacity(breakpoints.len());
    for ends in breakpoints.windows(2) {
        let [lo, hi] = [ends[0], ends[1]];
        let middle = lo + (hi - lo) * 0.5;
        let spans = [strip.knots.span(middle), target.knots.span(middle)];
        let mut piece = Piece { ends: [lo, hi], gap: 0.0, angle: 0.0 };
        for i in 0..SAMPLES {
            let part = i as f64 / (SAMPLES - 1) as f64;
            let t = if i + 1 == SAMPLES { hi } else { lo + (hi - lo) * part };
            let frames = [strip.frame(spans[0], t), target.frame(spans[1], t)];
            let gap = length(frames[0].point.minus(frames[1].point));
            // At a pole there is no normal; the one next to it counts.
            let aside = t + (middle - t) * 1e-4;
            let angle = match angle(&frames[0], &frames[1]) {
                Some(angle) => angle,
                None => match (angle_aside(strip, target, spans, aside), continuity) {
                    (Some(angle), _) => angle,
                    (None, Continuity::G0) => 0.0,
                    (None, Continuity::G1) => return Err(SpliceError::Degenerate { parameter: t }),
                },
            };
            whole.samples += 1;
            if gap > whole.gap {
                (whole.gap, whole.gap_at) = (gap, t);
            }
            if angle > whole.angle {
                (whole.angle, whole.angle_at) = (angle, t);
            }
            piece.gap = piece.gap.max(gap);
            piece.angle = piece.angle.max(angle);
        }
        pieces.push(piece);
    }
    Ok((whole, pieces))
}

fn angle_aside(strip: &Strip, target: &Strip, spans: [usize; 2], t: f64) -> Option<f64> {
    angle(&strip.frame(spans[0], t), &target.frame(spans[1], t))
}

/// The angle between the normals, both oriented by the direction from the strip to the target and the one along the edge.
fn angle(strip: &Frame, target: &Frame) -> Option<f64> {
    // `across` points into each surface: out of the strip is the opposite direction.
    let a = normal(strip.across.scale(-1.0), strip.tangent)?;
    let b = normal(target.across, target.tangent)?;
    Some(Scalar::atan2(length(cross(a, b)), dot(a, b)))
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
