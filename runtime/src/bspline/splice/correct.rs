//! The change of the second row that a sample asks for, shared by the methods that work on samples.

use super::SpliceError;
use super::measure::normal;
use super::strip::{Frame, Strip, Vector};
use crate::Point;
use crate::vector::{direction, dot, length};

/// The way from the second row to the edge keeps at least this part of its length in the direction into the target.
const FORWARD: f64 = 0.02;

/// The change of `inner` that brings the strip's derivative across the edge into the tangent plane of the target.
///
/// With `e = edge - inner` and the unit normal `n` of the target it is `(e·n) n`, the smallest change that makes the
/// three tangents coplanar. Then the sign condition is enforced: in the plane, `e` must have a positive component in
/// the direction `d` into the target, normal to the edge; if it has not, it is given the length [`FORWARD`] in that
/// direction.
///
/// Where the edge of the target has a crease, its tangent plane jumps, and only the direction across the edge is in
/// both planes. For such a target `e` becomes a multiple of that direction everywhere.
pub(super) fn correction(strip: &Strip, target: &Strip, t: f64) -> Result<Vector, SpliceError> {
    let to = target.at(t);
    let Some((n, d)) = plane(&to).or_else(|| {
        // At a pole of the target: the plane next to it.
        let [lo, hi] = target.knots.domain();
        plane(&target.at(t + (lo + (hi - lo) * 0.5 - t) * 1e-5))
    }) else {
        return Err(SpliceError::Degenerate { parameter: t });
    };
    let out = strip.at(t).across.scale(-1.0);
    // Widths in space: the result does not depend on how the parameters across the edges are scaled.
    let least = FORWARD * length(out).max(FORWARD * length(to.across));
    if target.is_creased() {
        let across = direction(to.across).unwrap_or(d);
        return Ok(out.minus(across.scale(dot(out, across).max(least))));
    }
    let mut change = n.scale(dot(out, n));
    let wanted = out.minus(change);
    let forward = dot(wanted, d);
    if forward < least {
        change = change.add_weighted(d, forward - least);
    }
    Ok(change)
}

/// The unit normal of a frame, and the direction in its tangent plane that points across the edge, normal to it.
fn plane(frame: &Frame) -> Option<(Vector, Vector)> {
    let n = normal(frame.across, frame.tangent)?;
    let tangent = direction(frame.tangent)?;
    let d = direction(frame.across.add_weighted(tangent, -dot(frame.across, tangent)))?;
    Some((n, d))
}
