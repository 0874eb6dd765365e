//! The direction in which pieces go on at a parameter, also where their velocity vanishes.

use alloc::vec::Vec;

use super::CurvePiece;

/// The piece of a parameter: the later one at a joint.
#[inline]
pub(crate) fn piece_at(pieces: &[CurvePiece], t: f64) -> Option<&CurvePiece> {
    if t.is_nan() {
        return None;
    }
    let after = pieces.partition_point(|piece| piece.domain()[0] <= t);
    pieces.get(after.saturating_sub(1))
}

/// A vector in the direction in which the curve goes on at `t`, at the end of the domain that in which it arrives;
/// `None` if the piece is a point.
///
/// Of the part of the piece behind the parameter it is the first difference from the first control point that does not
/// vanish up to rounding errors: so the limit of the tangent is found, whatever the number of derivatives that vanish.
#[inline]
pub(crate) fn heading(pieces: &[CurvePiece], t: f64) -> Option<Vec<f64>> {
    let piece = piece_at(pieces, t)?;
    if !piece.is_finite() {
        return None;
    }
    let x = piece.place(t);
    let arriving = x >= 1.0 && pieces.last().is_some_and(|last| t >= last.domain()[1]);
    let part = match (arriving, x) {
        (true, _) => piece.restricted(x, x - 1.0),
        (false, x) if x < 1.0 => piece.restricted(x, 1.0),
        (false, x) => piece.restricted(x, x + 1.0),
    };
    let noise = 16.0 * f64::EPSILON * (piece.degree() + 1) as f64 * piece.largest().max(part.largest());
    let sign = if arriving { -1.0 } else { 1.0 };
    (1..=part.degree())
        .find(|&i| part.distance(0, i) > noise)
        .map(|i| (0..part.dimension()).map(|d| sign * (part.control(i, d) - part.control(0, d))).collect())
}

/// The size of second derivatives at a parameter, of which rounding leaves some `ε`: `n (n - 1)` times the largest control
/// point over the square of the width of the domain.
#[inline]
pub(super) fn bend(pieces: &[CurvePiece], t: f64) -> f64 {
    piece_at(pieces, t).map_or(f64::NAN, |piece| {
        let [lo, hi] = piece.domain();
        let degree = piece.degree() as f64;
        degree * (degree - 1.0).max(0.0) / (hi - lo) / (hi - lo) * piece.largest()
    })
}
