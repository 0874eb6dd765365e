//! Branch and bound over Bézier patches: the place nearest to the origin, with a proof that none is nearer.

use alloc::collections::BinaryHeap;
use core::cmp::Ordering;

use super::piece::Piece;
use crate::Scalar;

/// The most work, in products of two numbers: some ten thousand parts of a bicubic surface.
const WORK: usize = 8_000_000;

/// Lengths are measured in that of the longest difference, so that no square overflows.
#[inline]
pub(crate) fn length_unit<S: Scalar>(lengths: impl Iterator<Item = S>) -> f64 {
    let unit = lengths.map(S::to_f64).filter(|length| length.is_finite()).fold(0.0, f64::max);
    if unit > 0.0 { unit } else { 1.0 }
}

/// A place on one of the pieces.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) piece: usize,
    /// Its parameters on the piece, both from 0 to 1.
    pub(crate) at: [f64; 2],
    distance: f64,
}

/// A part of one of the pieces, over the rectangle from `from` to `to`.
struct Part {
    piece: usize,
    from: [f64; 2],
    to: [f64; 2],
    net: Piece,
    /// A lower bound of its distance.
    bound: f64,
    /// Whether the bound is the better one, from the squared distance.
    sharp: bool,
    /// Which part it is, so that equal bounds have an order.
    number: usize,
}

impl Ord for Part {
    /// The part with the lowest bound is the greatest.
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound).then(other.number.cmp(&self.number))
    }
}

impl PartialOrd for Part {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Part {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Part {}

/// The place of the pieces that is nearest to the origin, up to that tolerance, and a lower bound of all distances.
#[inline]
pub(crate) fn search(pieces: &[Piece], tolerance: f64) -> Option<(Place, f64)> {
    let mut heap = BinaryHeap::new();
    let mut best: Option<Place> = None;
    for (piece, net) in pieces.iter().enumerate() {
        if !net.is_finite() {
            continue;
        }
        for (at, distance) in net.corners() {
            if best.is_none_or(|best| distance < best.distance) {
                best = Some(Place { piece, at, distance });
            }
        }
        let bound = net.box_bound();
        let number = heap.len();
        heap.push(Part {
            piece,
            from: [0.0; 2],
            to: [1.0; 2],
            net: net.clone(),
            bound,
            sharp: false,
            number,
        });
    }
    let mut best = descend(pieces, best?);
    let (mut work, mut number) = (0, heap.len());
    while let Some(mut part) = heap.pop() {
        if part.bound >= best.distance - tolerance || work > WORK {
            let margin = part.net.rounding();
            return Some((best, part.bound.min(best.distance) - margin));
        }
        if !part.sharp {
            work += part.net.sharp_work();
            part.bound = part.bound.max(part.net.sharp_bound());
            part.sharp = true;
            heap.push(part);
            continue;
        }
        work += part.net.halving_work();
        let along = part.net.longer();
        let middle = 0.5 * (part.from[along] + part.to[along]);
        let halves = part.net.halved(along);
        for (half, net) in halves.into_iter().enumerate() {
            let (mut from, mut to) = (part.from, part.to);
            if half == 0 {
                to[along] = middle;
            } else {
                from[along] = middle;
            }
            for (corner, distance) in net.corners() {
                if distance < best.distance - 0.5 * tolerance {
                    let at = [0, 1].map(|i| if corner[i] == 0.0 { from[i] } else { to[i] });
                    best = descend(pieces, Place { piece: part.piece, at, distance });
                }
            }
            let bound = net.box_bound().max(part.bound);
            heap.push(Part { piece: part.piece, from, to, net, bound, sharp: false, number });
            number += 1;
        }
    }
    Some((best, best.distance)) // not reached: the best place is in a part
}

/// The nearest place that Newton's method finds from there.
#[inline]
fn descend(pieces: &[Piece], start: Place) -> Place {
    let (at, distance) = pieces[start.piece].descend(start.at);
    if distance < start.distance { Place { at, distance, ..start } } else { start }
}
