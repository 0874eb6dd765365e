//! Extrema, inflections and boxes: zeros of polynomials that pieces define, and changes of sign where pieces meet.

use alloc::vec::Vec;

use crate::CurvePiece;
use crate::bernstein::{RootKind, roots};
use crate::geometry::{derivative, product};

/// A polynomial for each piece, whose changes of sign along the curve are asked for.
struct Signs<'a> {
    pieces: &'a [CurvePiece],
    polynomials: Vec<Vec<f64>>,
}

impl Signs<'_> {
    /// The parameters at which the sign changes, inside of the domain; coefficients as small as `noise` count as zero.
    #[inline]
    fn changes(&self, noise: &[f64], found: &mut Vec<f64>) {
        // The last sign that was met, and the end of the piece in which that was.
        let mut last: Option<(bool, f64)> = None;
        for ((piece, polynomial), &noise) in self.pieces.iter().zip(&self.polynomials).zip(noise) {
            let mut significant = polynomial.iter().filter(|c| c.abs() > noise);
            let Some(&first) = significant.next() else { continue };
            let end = significant.next_back().copied().unwrap_or(first);
            let [lo, hi] = piece.domain();
            if last.is_some_and(|(positive, _)| positive != (first > 0.0)) {
                found.push(lo);
            }
            let inside = roots(polynomial).into_iter().filter(|root| root.kind == RootKind::Crossing);
            let near = 64.0 * f64::EPSILON;
            found.extend(
                inside.filter(|r| r.x > near && r.x < 1.0 - near).map(|root| piece.parameter(root.x)),
            );
            last = Some((end > 0.0, hi));
        }
    }
}

/// The parameters inside of the domain at which a component has a maximum or minimum, in increasing order.
#[inline]
pub(crate) fn extrema(pieces: &[CurvePiece]) -> Vec<f64> {
    let mut found = Vec::new();
    if !pieces.iter().all(CurvePiece::is_finite) {
        return found;
    }
    let dimension = pieces.first().map_or(0, CurvePiece::dimension);
    for d in 0..dimension {
        let polynomials: Vec<Vec<f64>> = pieces.iter().map(|piece| piece.slope(d)).collect();
        let noise: Vec<f64> = pieces.iter().map(|piece| slope_noise(piece, d)).collect();
        Signs { pieces, polynomials }.changes(&noise, &mut found);
    }
    sorted(found)
}

#[inline]
fn sorted(mut found: Vec<f64>) -> Vec<f64> {
    found.sort_by(f64::total_cmp);
    found.dedup();
    found
}

/// What rounding errors of the coefficients leave of those of the slope of a component.
#[inline]
fn slope_noise(piece: &CurvePiece, d: usize) -> f64 {
    let largest = |list: &[f64]| list.iter().fold(0.0_f64, |a, c| a.max(c.abs()));
    let weight = piece.weights().map_or(1.0, largest);
    16.0 * f64::EPSILON * piece.degree() as f64 * largest(piece.component(d)) * weight
}

/// The smallest box around the curve, `[min, max]` for each component; NaN where a coefficient is not finite.
#[inline]
pub(crate) fn tight_box(pieces: &[CurvePiece]) -> Vec<[f64; 2]> {
    let dimension = pieces.first().map_or(0, CurvePiece::dimension);
    let side = |d: usize| {
        let mut side = [f64::INFINITY, f64::NEG_INFINITY];
        for piece in pieces {
            let weights_finite = piece.weights().is_none_or(|w| w.iter().all(|w| w.is_finite()));
            if !weights_finite || !piece.component(d).iter().all(|c| c.is_finite()) {
                return [f64::NAN; 2];
            }
            let last = piece.degree();
            let ends = [piece.control(0, d), piece.control(last, d)];
            let mut take = |value: f64| side = [side[0].min(value), side[1].max(value)];
            ends.into_iter().for_each(&mut take);
            let inside = (0..=last).all(|i| {
                let c = piece.control(i, d);
                c >= ends[0].min(ends[1]) && c <= ends[0].max(ends[1])
            });
            if !inside {
                for root in roots(&piece.slope(d)) {
                    take(piece.value(d, root.x));
                }
            }
        }
        side
    };
    (0..dimension).map(side).collect()
}

/// The box around the control points, `[min, max]` for each component; NaN where a coefficient is NaN.
#[inline]
pub(crate) fn control_box(pieces: &[CurvePiece]) -> Vec<[f64; 2]> {
    let dimension = pieces.first().map_or(0, CurvePiece::dimension);
    let side = |d: usize| {
        let all = pieces.iter().flat_map(|piece| (0..=piece.degree()).map(move |i| piece.control(i, d)));
        all.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], c| {
            if c.is_nan() || lo.is_nan() { [f64::NAN; 2] } else { [lo.min(c), hi.max(c)] }
        })
    };
    (0..dimension).map(side).collect()
}

/// The parameters inside of the domain at which a curve in the plane changes the side to which it turns, in increasing
/// order. With the numerators `X`, `Y` and the weight `W` it turns to the left where `det (A, A', A'')` is positive,
/// `A = (X, Y, W)`.
#[inline]
pub(crate) fn inflections(pieces: &[CurvePiece]) -> Vec<f64> {
    let mut found = Vec::new();
    if !pieces.iter().all(CurvePiece::is_finite) {
        return found;
    }
    let (mut polynomials, mut noise) = (Vec::new(), Vec::new());
    for piece in pieces {
        // Seen from one of its points, in its own size.
        let origin = [piece.control(0, 0), piece.control(0, 1)];
        let shifted = piece.seen_from(&origin, 1.0);
        let size = shifted.largest();
        let unit = if size > 0.0 { size } else { 1.0 };
        let shifted = piece.seen_from(&origin, unit);
        let one = alloc::vec![1.0; piece.degree() + 1];
        let rows = [shifted.component(0), shifted.component(1), piece.weights().unwrap_or(&one)];
        let first = rows.map(derivative);
        let second = [0, 1, 2].map(|k| derivative(&first[k]));
        let minor = |i: usize, j: usize| {
            let mut minor = product(&first[i], &second[j]);
            for (m, p) in minor.iter_mut().zip(product(&first[j], &second[i])) {
                *m -= p;
            }
            minor
        };
        let degree = piece.degree() as f64;
        let rounding = piece.largest() / unit + 1.0;
        if piece.weights().is_none() {
            polynomials.push(minor(0, 1));
        } else {
            let terms = [
                product(rows[0], &minor(1, 2)),
                product(rows[1], &minor(2, 0)),
                product(rows[2], &minor(0, 1)),
            ];
            let mut sum = terms[0].clone();
            for (k, s) in sum.iter_mut().enumerate() {
                *s += terms[1][k] + terms[2][k];
            }
            polynomials.push(sum);
        }
        noise.push(64.0 * f64::EPSILON * rounding * degree * degree * degree);
    }
    Signs { pieces, polynomials }.changes(&noise, &mut found);
    sorted(found)
}
