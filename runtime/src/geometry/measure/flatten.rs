//! Polygons that follow pieces within a tolerance.

use alloc::vec::Vec;

use crate::CurvePiece;
use crate::{CurveError, Scalar};

/// More points are refused.
const MOST: f64 = 16_777_216.0;

/// The parameters of the corners of a polygon that follows the curve: no point of the one is farther than `tolerance`
/// from the other, if the pieces meet. Of a piece that does not start where the one before it ends (`jumps`) both ends
/// are corners; then the flag is set.
#[inline]
pub(crate) fn corners(pieces: &[CurvePiece], tolerance: f64) -> Result<Vec<f64>, CurveError> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(CurveError::Tolerance { value: tolerance });
    }
    if !pieces.iter().all(CurvePiece::is_finite) {
        return Err(CurveError::NotFinite);
    }
    let needed: f64 =
        pieces.iter().map(|piece| Scalar::sqrt((bend(piece) / tolerance).max(0.25)) * 2.0).sum();
    if needed.is_nan() || needed > MOST {
        return Err(CurveError::TooManyPoints { needed });
    }
    let mut corners: Vec<f64> = pieces.first().map(|piece| piece.domain()[0]).into_iter().collect();
    for piece in pieces {
        // No part is smaller than rounding errors.
        let noise = 8.0 * f64::EPSILON * piece.largest();
        let limit = tolerance.max(noise);
        let mut open = alloc::vec![piece.clone()];
        while let Some(part) = open.pop() {
            if deviation(&part) <= limit {
                corners.push(part.domain()[1]);
                if corners.len() as f64 > MOST {
                    return Err(CurveError::TooManyPoints { needed: 2.0 * MOST });
                }
                continue;
            }
            let [before, after] = part.split(0.5);
            if before.domain()[1] <= before.domain()[0] || after.domain()[1] <= after.domain()[0] {
                corners.push(part.domain()[1]);
                continue;
            }
            open.push(after);
            open.push(before);
        }
    }
    Ok(corners)
}

/// About the distance of the piece from its chord: `n (n-1)/8` times the largest second difference of the control
/// points, a bound for polynomial pieces.
#[inline]
fn bend(piece: &CurvePiece) -> f64 {
    let degree = piece.degree() as f64;
    let mut largest = 0.0_f64;
    for i in 2..=piece.degree() {
        let square: f64 = (0..piece.dimension())
            .map(|d| {
                let second = piece.control(i, d) - 2.0 * piece.control(i - 1, d) + piece.control(i - 2, d);
                second * second
            })
            .sum();
        largest = largest.max(Scalar::sqrt(square));
    }
    largest * degree * (degree - 1.0) / 8.0
}

/// How far the piece and its chord are at most from each other: the distance of the control points from the chord,
/// whose hull the piece does not leave.
#[inline]
fn deviation(piece: &CurvePiece) -> f64 {
    let from_chord = (1..piece.degree()).map(|i| distance_to_chord(piece, i)).fold(0.0, f64::max);
    if piece.weights().is_some() { from_chord } else { from_chord.min(bend(piece)) }
}

#[inline]
fn distance_to_chord(piece: &CurvePiece, i: usize) -> f64 {
    let last = piece.degree();
    let chord = piece.distance(0, last);
    let mut foot = 0.0;
    for d in 0..piece.dimension() {
        let along = (piece.control(last, d) - piece.control(0, d)) / chord;
        foot += along * ((piece.control(i, d) - piece.control(0, d)) / chord);
    }
    if !(foot > 0.0 && foot < 1.0) {
        return piece.distance(i, 0).min(piece.distance(i, last));
    }
    let square: f64 = (0..piece.dimension())
        .map(|d| {
            let away = piece.control(i, d)
                - piece.control(0, d)
                - foot * (piece.control(last, d) - piece.control(0, d));
            away * away
        })
        .sum();
    Scalar::sqrt(square)
}
