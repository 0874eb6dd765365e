//! Where curves meet surfaces: parts that cannot meet are put aside, the others are narrowed to where they can.
//!
//! For a linear function `f` of the difference `A(x) - S(u, v)` whose derivative at the middle of three intervals is 1
//! in one parameter and 0 in both others, control points bound how far `f` is from that parameter, minus its place in
//! the middle. Where the difference vanishes so does `f`, and so the parameter lies in an interval: the intervals become
//! the shorter the straighter the parts are. Three such functions come from the inverse of the derivative; where that has
//! none, as along a tangent, two come from the tangent plane of the surface and one from the tangent of the curve.
//!
//! With a matrix `M` near the inverse of the derivative of `F = A - S` and `max |M F' - 1| < 1` over all three intervals
//! `F` has at most one zero in them, and Newton's method finds it. What is left is halved: until the part of the curve
//! lies beside the part of the surface within the accuracy, or both are as short as that. So nothing is left out.

mod answers;
mod net;
mod search;

use alloc::vec::Vec;

use super::CurvePiece;
use super::MeetingKind;
use crate::SurfacePiece;
use net::{Net, Vector};
use search::Search;

/// Parameters between which a curve and a surface meet; of the surface those of a patch, with its index.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pierced {
    pub(crate) kind: MeetingKind,
    pub(crate) curve: [f64; 2],
    pub(crate) surface: [[f64; 2]; 2],
    pub(crate) at: Vector,
}

/// All places at which a curve meets a surface, in the order of the curve; `None` if anything is not finite or a weight
/// not positive.
#[inline]
pub(crate) fn piercings(
    curve: &[CurvePiece],
    surface: &[SurfacePiece],
    accuracy: f64,
    epsilon: f64,
) -> Option<Vec<Pierced>> {
    let weights_positive =
        |piece: &CurvePiece| piece.weights().is_none_or(|all| all.iter().all(|&w| w > 0.0));
    if !curve.iter().all(|piece| piece.is_finite() && piece.dimension() == 3 && weights_positive(piece)) {
        return None;
    }
    let origin = [0, 1, 2].map(|d| curve.first().map_or(0.0, |piece| piece.control(0, d)));
    let mut size = curve.iter().map(|piece| piece.seen_from(&origin, 1.0).largest()).fold(0.0, f64::max);
    for piece in surface {
        let farthest = piece.net.farthest(&origin);
        if !farthest.is_finite() {
            return None;
        }
        size = size.max(farthest);
    }
    if !size.is_finite() {
        return None;
    }
    let unit = if size > 0.0 { size } else { 1.0 };
    let curves: Vec<Net> = curve.iter().map(|piece| Net::of_curve(piece, origin, unit)).collect();
    let surfaces: Vec<Net> = surface.iter().map(|piece| Net::of_patch(&piece.net, origin, unit)).collect();
    let degree = |nets: &[Net]| nets.iter().map(Net::degree).max().unwrap_or(0);
    let noise = 16.0 * f64::EPSILON * (degree(&curves) + degree(&surfaces) + 3) as f64;
    let noise = noise.max(4.0 * epsilon);
    let accuracy = if accuracy > 0.0 { accuracy / unit } else { 0.0 };
    let mut search = Search {
        curves: &curves,
        surfaces: &surfaces,
        accuracy: accuracy.max(64.0 * epsilon).max(2.0 * noise),
        noise,
        crossings: Vec::new(),
        near: Vec::new(),
    };
    search.run();
    Some(answers::answers(&search, curve, surface))
}

/// The part of a line, `from <= t <= to`, that may meet a surface, as a curve: no longer than a box around the surface
/// with a margin, and nothing if the line misses that. `None` if anything is not finite, a weight not positive, or the
/// direction zero.
#[inline]
pub(crate) fn line_pieces(
    surface: &[SurfacePiece],
    start: Vector,
    direction: Vector,
    [mut from, mut to]: [f64; 2],
    accuracy: f64,
) -> Option<Vec<CurvePiece>> {
    let size = surface.iter().map(|piece| piece.net.farthest(&start)).fold(0.0, largest);
    let steep = direction.iter().map(|d| d.abs()).fold(0.0, largest);
    if !(size.is_finite() && steep.is_finite() && steep > 0.0 && start.iter().all(|x| x.is_finite())) {
        return None;
    }
    let extreme = |d: usize, sign: f64| {
        let sides = surface.iter().map(|piece| piece.net.largest_of_points(d, sign));
        sign * sides.fold(f64::NEG_INFINITY, f64::max)
    };
    let sides = [0, 1, 2].map(|d| [extreme(d, -1.0), extreme(d, 1.0)]);
    let span = sides.iter().map(|[lo, hi]| hi - lo).fold(0.0, f64::max);
    let margin = 1e-3 * span + 1e-9 * size + if accuracy > 0.0 && accuracy < size { accuracy } else { 0.0 };
    for (d, [low, high]) in sides.into_iter().enumerate() {
        let (low, high) = (low - margin - start[d], high + margin - start[d]);
        if direction[d] == 0.0 {
            if low > 0.0 || high < 0.0 {
                return Some(Vec::new());
            }
            continue;
        }
        let ends = [low / direction[d], high / direction[d]];
        from = from.max(ends[0].min(ends[1]));
        to = to.min(ends[0].max(ends[1]));
    }
    if from > to {
        return Some(Vec::new());
    }
    let point = |t: f64| [0, 1, 2].map(|d| start[d] + t * direction[d]);
    Some(alloc::vec![CurvePiece::polynomial([from, to], &[point(from), point(to)])])
}

/// The larger of two numbers; NaN if one of them is.
#[inline]
fn largest(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}
