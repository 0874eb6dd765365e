//! The difference of two parts and its derivatives, where straight parts lie beside each other, and the places near a pair
//! of parameters at which curves are nearest.

use alloc::vec;
use alloc::vec::Vec;

use super::CurvePiece;
use super::local::piece_at;
use super::piece::derivative;
use crate::{Scalar, bernstein};

/// The parameters between which a part lies beside the chord of another one, not farther beyond its ends than the
/// accuracy, as far as control points tell; `None` if it nowhere does.
#[inline]
pub(super) fn beside(part: &CurvePiece, other: &CurvePiece, accuracy: f64) -> Option<[f64; 2]> {
    let (dim, last) = (other.dimension(), other.degree());
    let chord: Vec<f64> = (0..dim).map(|d| other.control(last, d) - other.control(0, d)).collect();
    let length = Scalar::sqrt(dot(&chord, &chord));
    if length == 0.0 {
        return Some(part.domain());
    }
    // How far the control points are inside of either end, times the weights.
    let inside = |sign: f64, end: usize| -> Vec<f64> {
        let height = |i: usize| {
            let along = |d: usize| sign * chord[d] / length * (part.control(i, d) - other.control(end, d));
            let weight = part.weights().map_or(1.0, |weights| weights[i]);
            weight * ((0..dim).map(along).sum::<f64>() + accuracy)
        };
        (0..=part.degree()).map(height).collect()
    };
    let [[from, to], [start, end]] =
        [inside(1.0, 0), inside(-1.0, last)].map(|heights| not_negative(&heights));
    let (from, to) = (from.max(start), to.min(end));
    (from <= to).then(|| [part.parameter(from), part.parameter(to)])
}

/// Whether a point of a part is not farther than a distance from the line through the ends of another one.
#[inline]
pub(super) fn is_beside(part: &CurvePiece, t: f64, other: &CurvePiece, distance: f64) -> bool {
    let x = part.place(t);
    let mut vectors = [Vec::new(), Vec::new()];
    for d in 0..part.dimension() {
        vectors[0].push(part.value(d, x) - other.control(0, d));
        vectors[1].push(other.control(other.degree(), d) - other.control(0, d));
    }
    let [from, chord] = &vectors;
    let square = dot(chord, chord);
    let along = if square > 0.0 { dot(from, chord) / square } else { 0.0 };
    let away: f64 = from.iter().zip(chord).map(|(f, c)| (f - along * c) * (f - along * c)).sum();
    away <= distance * distance
}

/// An interval outside of which a polynomial with these Bernstein coefficients is negative, from the hull of its
/// control polygon; `[1, 0]` if it is negative everywhere.
#[inline]
fn not_negative(coefficients: &[f64]) -> [f64; 2] {
    let degree = coefficients.len().saturating_sub(1).max(1) as f64;
    let mut interval = [1.0_f64, 0.0_f64];
    for (i, &a) in coefficients.iter().enumerate() {
        if a < 0.0 {
            continue;
        }
        let x = i as f64 / degree;
        interval = [interval[0].min(x), interval[1].max(x)];
        for (j, &b) in coefficients.iter().enumerate().filter(|(_, b)| **b < 0.0) {
            let zero = x + (j as f64 / degree - x) * a / (a - b);
            interval = [interval[0].min(zero), interval[1].max(zero)];
        }
    }
    if coefficients.first().is_some_and(|&c| c >= 0.0) {
        interval[0] = 0.0;
    }
    if coefficients.last().is_some_and(|&c| c >= 0.0) {
        interval[1] = 1.0;
    }
    interval
}

/// The parameters near a pair at which the curves are nearest to each other, by steps of Gauss and Newton.
#[inline]
pub(super) fn approach(a: &[CurvePiece], b: &[CurvePiece], start: [f64; 2]) -> [f64; 2] {
    let distance = |at: [f64; 2]| -> f64 {
        let (p, q) = (point(a, at[0]), point(b, at[1]));
        p.iter().zip(&q).map(|(p, q)| (p - q) * (p - q)).sum()
    };
    let mut at = start;
    for _ in 0..40 {
        let [Some(first), Some(second)] = [(a, at[0]), (b, at[1])].map(|(pieces, t)| piece_at(pieces, t))
        else {
            break;
        };
        let (value, columns) = state(first, second, [first.place(at[0]), second.place(at[1])]);
        let widths = [first, second].map(|part| part.domain()[1] - part.domain()[0]);
        let ends = [a, b].map(|pieces| {
            let end = |piece: Option<&CurvePiece>, k: usize| piece.map_or(0.0, |piece| piece.domain()[k]);
            [end(pieces.first(), 0), end(pieces.last(), 1)]
        });
        let moved = |steps: [f64; 2]| {
            let mut next = at;
            for (k, t) in next.iter_mut().enumerate() {
                *t = (*t - steps[k] * widths[k]).clamp(ends[k][0], ends[k][1]);
            }
            next
        };
        // Both at once, or where they are parallel, or one of them stands still or ends, one by one.
        let both = pseudo_inverse(&columns).map(|rows| [dot(&rows[0], &value), dot(&rows[1], &value)]);
        let one = |k: usize| {
            let square = dot(&columns[k], &columns[k]);
            if square > 0.0 { dot(&columns[k], &value) / square } else { 0.0 }
        };
        let steps = [both.unwrap_or([0.0; 2]), [one(0), 0.0], [0.0, one(1)]];
        let so_far = distance(at);
        let Some(next) = steps.into_iter().map(moved).find(|&next| distance(next) < so_far) else { break };
        at = next;
    }
    at
}

#[inline]
pub(super) fn point(pieces: &[CurvePiece], t: f64) -> Vec<f64> {
    piece_at(pieces, t).map_or_else(Vec::new, |piece| {
        let x = piece.place(t);
        (0..piece.dimension()).map(|d| piece.value(d, x)).collect()
    })
}

/// `F = A(x) - B(y)` and its derivatives in `x` and in `y`; of rational parts both are multiplied by the weights.
#[inline]
pub(super) fn state(first: &CurvePiece, second: &CurvePiece, at: [f64; 2]) -> (Vec<f64>, [Vec<f64>; 2]) {
    let dim = first.dimension();
    let weight = |part: &CurvePiece, x: f64| match part.weights() {
        None => [1.0, 0.0],
        Some(weights) => [bernstein::eval(weights, x), bernstein::eval(&derivative(weights), x)],
    };
    let ([w, w1], [v, v1]) = (weight(first, at[0]), weight(second, at[1]));
    let mut value = vec![0.0; dim];
    let mut columns = [vec![0.0; dim], vec![0.0; dim]];
    for d in 0..dim {
        let [a, b] = [(first, at[0]), (second, at[1])].map(|(part, x)| {
            let numerator = part.component(d);
            [bernstein::eval(numerator, x), bernstein::eval(&derivative(numerator), x)]
        });
        value[d] = a[0] * v - b[0] * w;
        columns[0][d] = a[1] * v - b[0] * w1;
        columns[1][d] = a[0] * v1 - b[1] * w;
    }
    (value, columns)
}

/// The rows of `(JᵀJ)⁻¹ Jᵀ`; `None` if the columns are parallel, or one is zero.
#[inline]
pub(super) fn pseudo_inverse(columns: &[Vec<f64>; 2]) -> Option<[Vec<f64>; 2]> {
    let [a, b] = columns;
    let (aa, ab, bb) = (dot(a, a), dot(a, b), dot(b, b));
    let determinant = aa * bb - ab * ab;
    if determinant <= 1e-12 * aa * bb || determinant.is_nan() {
        return None;
    }
    let row = |p: f64, q: f64| a.iter().zip(b).map(|(a, b)| (p * a - q * b) / determinant).collect();
    let other = |p: f64, q: f64| a.iter().zip(b).map(|(a, b)| (p * b - q * a) / determinant).collect();
    Some([row(bb, ab), other(aa, ab)])
}

#[inline]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
