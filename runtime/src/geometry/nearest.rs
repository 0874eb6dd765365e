//! The nearest point of pieces, by the search over Bézier patches that surfaces use: a curve is a patch of degree 0 in
//! the second parameter.

use alloc::vec::Vec;

use super::CurvePiece;
use crate::surface::nearest::{Piece, search};

/// The parameter at which the curve is nearest to a point, and a lower bound of its distance, up to that accuracy;
/// `epsilon` is that of the points. Pieces that are not finite make it `None`.
#[inline]
pub(crate) fn nearest(
    pieces: &[CurvePiece],
    point: &[f64],
    accuracy: f64,
    epsilon: f64,
) -> Option<(f64, f64)> {
    if !pieces.iter().all(CurvePiece::is_finite) || !point.iter().all(|c| c.is_finite()) {
        return None;
    }
    let seen: Vec<CurvePiece> = pieces.iter().map(|piece| piece.seen_from(point, 1.0)).collect();
    let farthest = seen.iter().map(CurvePiece::largest).fold(0.0, f64::max);
    if !farthest.is_finite() {
        return None;
    }
    let unit = if farthest > 0.0 { farthest } else { 1.0 };
    let patches: Vec<Piece> = seen
        .iter()
        .map(|piece| {
            let dim = piece.dimension();
            let mut net = Vec::new();
            for i in 0..=piece.degree() {
                net.extend((0..dim).map(|d| piece.component(d)[i] / unit));
                net.extend(piece.weights().map(|weights| weights[i]));
            }
            Piece::new([piece.degree(), 0], dim, net)
        })
        .collect();
    let tolerance = (0.5 * accuracy / unit).max(64.0 * epsilon);
    let (place, bound) = search(&patches, tolerance)?;
    let t = pieces[place.piece].parameter(place.at[0]);
    Some((t, (bound * unit * (1.0 - epsilon)).max(0.0)))
}
