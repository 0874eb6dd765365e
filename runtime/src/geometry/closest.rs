//! Where two curves are nearest to each other, by branch and bound over pairs of pieces.
//!
//! With `A = X / w` and `B = Y / ω` the squared distance is `F / D`, `F = |X ω - Y w|²` and `D = w² ω²`. Both have Bernstein
//! coefficients in both parameters, those of `D` positive, so that no point of the pair is nearer than the root of the
//! smallest quotient of coefficients. Pieces are seen from a point of their own: so the coefficients are as small as the
//! pieces and their distance, and nothing cancels but what is small.

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::CurvePiece;
use super::piece::product;
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::{Point, Scalar};

/// The points of two curves that are nearest to each other, and how near any others can be.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
#[non_exhaustive]
pub struct Closest<P: Point> {
    /// The parameter of each curve.
    pub at: [P::Scalar; 2],
    /// The point of each curve.
    pub points: [P; 2],
    /// Their distance.
    pub distance: P::Scalar,
    /// A lower bound of the distance of all pairs of points: none are nearer than this.
    pub at_least: P::Scalar,
}

impl<P: Point> Closest<P> {
    pub(super) fn new(at: [P::Scalar; 2], points: [P; 2], distance: P::Scalar, at_least: f64) -> Self {
        let at_least = P::Scalar::of(at_least).min(distance);
        Self { at, points, distance, at_least }
    }
}

/// The most pairs that are looked at; the lower bound is then what has been shown.
const MOST: usize = 1 << 18;

/// A pair of pieces.
struct Pair {
    pieces: [CurvePiece; 2],
    /// No point of the one is nearer to the other.
    at_least: f64,
}

impl Pair {
    /// The pair with its bound, and the nearest of the four pairs of ends.
    #[inline]
    fn new(pieces: [CurvePiece; 2]) -> (Self, f64, [f64; 2]) {
        let [a, b] = &pieces;
        let dimension = a.dimension();
        let origin: Vec<f64> = (0..dimension).map(|d| a.control(0, d)).collect();
        let [one, two] = [a, b].map(|piece| Squares::new(&piece.seen_from(&origin, 1.0)));
        let [rows, columns] = [one.weight.len(), two.weight.len()];
        let mut least = f64::INFINITY;
        let mut nearest = (f64::INFINITY, [0, 0]);
        for i in 0..rows {
            for j in 0..columns {
                let mixed: f64 = one.mixed.iter().zip(&two.mixed).map(|(one, two)| one[i] * two[j]).sum();
                let numerator = one.square[i] * two.weight[j] - 2.0 * mixed + one.weight[i] * two.square[j];
                let quotient = numerator / (one.weight[i] * two.weight[j]);
                least = least.min(quotient);
                if (i == 0 || i + 1 == rows) && (j == 0 || j + 1 == columns) && quotient < nearest.0 {
                    nearest = (quotient, [usize::from(i > 0), usize::from(j > 0)]);
                }
            }
        }
        // The rounding errors of the three terms.
        let size =
            [&one, &two].map(|s| s.square.iter().zip(&s.weight).map(|(x, w)| x / w).fold(0.0, f64::max));
        let noise = 16.0 * f64::EPSILON * (rows + columns) as f64 * (size[0] + size[1]);
        let at_least = Scalar::sqrt((least - noise).max(0.0));
        let at = [a.domain()[nearest.1[0]], b.domain()[nearest.1[1]]];
        let distance = Scalar::sqrt(nearest.0.max(0.0));
        (Self { pieces, at_least }, distance, at)
    }
}

impl PartialEq for Pair {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Pair {}

impl PartialOrd for Pair {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Pair {
    /// The greatest has the smallest bound.
    fn cmp(&self, other: &Self) -> Ordering {
        other.at_least.total_cmp(&self.at_least)
    }
}

/// The Bernstein coefficients of `|X|²`, of `X w`, one list for each component, and of `w²`.
struct Squares {
    square: Vec<f64>,
    mixed: Vec<Vec<f64>>,
    weight: Vec<f64>,
}

impl Squares {
    #[inline]
    fn new(piece: &CurvePiece) -> Self {
        let weights = piece.weights().map_or_else(|| alloc::vec![1.0; piece.degree() + 1], <[f64]>::to_vec);
        let mut square = alloc::vec![0.0; 2 * piece.degree() + 1];
        for d in 0..piece.dimension() {
            let component = piece.component(d);
            for (sum, c) in square.iter_mut().zip(product(component, component)) {
                *sum += c;
            }
        }
        let mixed = (0..piece.dimension()).map(|d| product(piece.component(d), &weights)).collect();
        Self { square, mixed, weight: product(&weights, &weights) }
    }
}

/// The parameters at which two curves are nearest to each other, and a lower bound of their distance; `None` if a control
/// point is not finite.
#[inline]
pub(super) fn closest(
    first: &[CurvePiece],
    second: &[CurvePiece],
    accuracy: f64,
    epsilon: f64,
) -> Option<([f64; 2], f64)> {
    let all = || first.iter().chain(second);
    if !all().all(CurvePiece::is_finite) {
        return None;
    }
    // In a unit in which no square is too large.
    let unit = all().map(CurvePiece::largest).fold(0.0, f64::max);
    let unit = if unit > 0.0 { unit } else { 1.0 };
    let origin = alloc::vec![0.0; first.first()?.dimension()];
    let [first, second] = [first, second]
        .map(|pieces| pieces.iter().map(|piece| piece.seen_from(&origin, unit)).collect::<Vec<_>>());
    let tolerance = (accuracy / unit).max(16.0 * epsilon);
    let mut open = BinaryHeap::new();
    let (mut best, mut at) = (f64::INFINITY, [0.0; 2]);
    let mut add = |open: &mut BinaryHeap<Pair>, pieces: [CurvePiece; 2]| {
        let (pair, distance, places) = Pair::new(pieces);
        if distance < best {
            (best, at) = (distance, places);
        }
        if pair.at_least < best - tolerance {
            open.push(pair);
        }
        best
    };
    for a in &first {
        for b in &second {
            add(&mut open, [a.clone(), b.clone()]);
        }
    }
    let mut at_least = f64::INFINITY;
    for _ in 0..MOST {
        let Some(pair) = open.pop() else { break };
        let [a, b] = &pair.pieces;
        let [long, other] = [a, b].map(|piece| piece.length_bounds()[1]);
        let halves = if long >= other {
            a.split(0.5).map(|half| [half, b.clone()])
        } else {
            b.split(0.5).map(|half| [a.clone(), half])
        };
        let narrow = halves.iter().any(|pair| pair.iter().any(|p| p.domain()[0] >= p.domain()[1]));
        let mut best = f64::INFINITY;
        for half in halves {
            best = add(&mut open, half);
        }
        if narrow || pair.at_least >= best - tolerance {
            // Nothing that is open is nearer than this.
            at_least = pair.at_least;
            break;
        }
    }
    if let Some(next) = open.peek() {
        at_least = at_least.min(next.at_least);
    }
    // What was left out is not nearer than the best by more than the tolerance.
    Some((at, at_least.min(best - tolerance).max(0.0) * unit * (1.0 - epsilon)))
}
