//! The point of a surface that is nearest to a given one, with a proof that none is nearer.

mod piece;

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::cmp::Ordering;

use piece::Piece;

use super::rows::{self, Rows};
use super::{BSplineSurface, Direction, KnotVector};
use crate::vector::length;
use crate::{Point, Scalar};

/// How much nearer a point may be than the one that is found, as a part of the extent of the net.
const TOLERANCE: f64 = 1e-10;

/// The most work, in products of two numbers: some ten thousand parts of a bicubic surface.
const WORK: usize = 8_000_000;

/// A point of a surface with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "P: serde::Serialize, P::Scalar: serde::Serialize",
        deserialize = "P: serde::Deserialize<'de>, P::Scalar: serde::Deserialize<'de>"
    ))
)]
pub struct Projection<P: Point> {
    /// The parameters `[u, v]`.
    pub parameters: [P::Scalar; 2],
    /// The point of the surface.
    pub point: P,
    /// Its distance from the given point.
    pub distance: P::Scalar,
    /// No point of the surface is nearer than this.
    pub at_least: P::Scalar,
}

impl<P: Point> BSplineSurface<P> {
    /// The point of the surface that is nearest to `point`.
    ///
    /// The surface is divided into Bézier patches, and these into halves. The control points of a part give a lower bound
    /// of its distance (their bounding box, and the Bernstein coefficients of the squared distance), and parts that cannot
    /// be nearer than the best point found so far are left out; that point is improved by Newton's method. So the distance
    /// is the smallest one of the whole surface, not of a neighbourhood: it exceeds [`at_least`](Projection::at_least),
    /// which is proved, by no more than 1e-10 of the extent of the net (1e-6 in single precision).
    ///
    /// Where very many points are almost equally near, such as around the centre of a sphere, the work ends earlier: the
    /// point is still a minimum, and `at_least` says how much is proved. At a knot where the surface jumps the point may
    /// be the limit from one side. Patches with control points that are not finite are left out.
    ///
    /// `None` if the point, or the surface everywhere, is not finite.
    ///
    /// ```
    /// use basis_runtime::bspline::{BSplineSurface, Net};
    ///
    /// // The saddle z = x y.
    /// let saddle = BSplineSurface::from_bezier(Net::from_rows([
    ///     [[-1.0_f64, -1.0, 1.0], [-1.0, 1.0, -1.0]],
    ///     [[1.0, -1.0, -1.0], [1.0, 1.0, 1.0]],
    /// ])?)?;
    /// let found = saddle.project([0.0, 0.0, 1.0]).unwrap();
    /// assert!((found.distance - 1.0).abs() < 1e-15);
    /// assert!(found.at_least > 1.0 - 1e-9);
    /// # Ok::<(), basis_runtime::bspline::SplineError>(())
    /// ```
    pub fn project(&self, point: P) -> Option<Projection<P>> {
        let spans = [Direction::U, Direction::V].map(|d| self.knots(d).spans().collect::<Vec<_>>());
        let differences = self.net().map(|p| p.minus(point));
        let unit = length_unit(differences.as_slice().iter().map(|&p| length(p)));
        let pieces = self.pieces(point, unit);
        let extent = (0..P::DIM).fold(0.0_f64, |extent, c| {
            let all = self.net().as_slice().iter().map(|p| p.component(c).to_f64()).filter(|x| x.is_finite());
            let (lo, hi) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)));
            extent.max((hi - lo) / unit)
        });
        let epsilon = P::Scalar::EPSILON.to_f64();
        let tolerance = TOLERANCE.max(8.0 * epsilon) * extent + 64.0 * epsilon;
        let (nearest, bound) = search(&pieces, tolerance)?;

        let place = [nearest.piece / spans[1].len(), nearest.piece % spans[1].len()];
        let place = [spans[0][place[0]], spans[1][place[1]]];
        let parameter = |i: usize, knots: &[P::Scalar]| {
            let (lo, hi, at) = (knots[place[i]], knots[place[i] + 1], nearest.at[i]);
            if at >= 1.0 {
                return hi;
            }
            let t = P::Scalar::of(lo.to_f64() + (hi.to_f64() - lo.to_f64()) * at);
            if t < lo {
                lo
            } else if t > hi {
                hi
            } else {
                t
            }
        };
        let [u, v] = [self.knots(Direction::U), self.knots(Direction::V)].map(KnotVector::as_slice);
        let at = [parameter(0, u), parameter(1, v)];
        // On one side of a knot or the other the point is the same, unless the surface jumps.
        let away = |p: P| length(p.minus(point));
        let (mut found, limit) = (self.eval(at[0], at[1]), self.partial_on(place, at, [0, 0]));
        let same = away(found).to_f64() <= away(limit).to_f64() + tolerance * unit;
        if !same {
            found = limit;
        }
        let distance = away(found);
        let at_least = P::Scalar::of((bound * unit * (1.0 - epsilon)).max(0.0)).min(distance);
        Some(Projection { parameters: at, point: found, distance, at_least })
    }

    /// The polynomial pieces as Bézier patches, those with the lowest `u` first; differences from `point` in that unit.
    fn pieces(&self, point: P, unit: f64) -> Vec<Piece> {
        let difference = |p: P, c: usize| (p.component(c).to_f64() - point.component(c).to_f64()) / unit;
        let net = self.net();
        let points =
            net.as_slice().iter().flat_map(|&p| (0..P::DIM).map(move |c| difference(p, c))).collect();
        let [ku, kv] = self.degrees();
        let columns = net.columns();
        let rows = Rows { knots: self.knots(Direction::U).to_f64(), points, lanes: columns * P::DIM };
        let knots = self.knots(Direction::V).to_f64();
        let bands = rows::bezier(&rows).into_iter();
        bands
            .flat_map(|(_, band)| {
                // Turned: a row for each function of v, with `ku + 1` points in it.
                let entry = |j: usize, i: usize| &band[(i * columns + j) * P::DIM..][..P::DIM];
                let turned =
                    (0..columns).flat_map(|j| (0..=ku).flat_map(move |i| entry(j, i).iter().copied()));
                let lanes = (ku + 1) * P::DIM;
                let rows = Rows { knots: knots.clone(), points: turned.collect::<Vec<f64>>(), lanes };
                let patches = rows::bezier(&rows).into_iter();
                patches.map(|(_, net)| Piece::new([ku, kv], P::DIM, net)).collect::<Vec<_>>()
            })
            .collect()
    }
}

/// The parameters, from 0 to 1, at which a Bézier patch of those degrees is nearest to `point`, up to that accuracy, and a lower
/// bound of its distance; a row of control points for each function of `v`.
pub(crate) fn nearest_of_patch<P: Point>(
    degrees: [usize; 2],
    net: impl Iterator<Item = P> + Clone,
    point: P,
    accuracy: P::Scalar,
) -> Option<([P::Scalar; 2], P::Scalar)> {
    let unit = length_unit(net.clone().map(|p| length(p.minus(point))));
    let difference = |p: P, c: usize| (p.component(c).to_f64() - point.component(c).to_f64()) / unit;
    let net = net.flat_map(|p| (0..P::DIM).map(move |c| difference(p, c))).collect();
    let epsilon = P::Scalar::EPSILON.to_f64();
    // The point that is returned is rounded, too.
    let tolerance = (0.5 * accuracy.to_f64() / unit).max(64.0 * epsilon);
    let (nearest, bound) = search(&[Piece::new(degrees, P::DIM, net)], tolerance)?;
    let at_least = P::Scalar::of((bound * unit * (1.0 - epsilon)).max(0.0));
    Some((nearest.at.map(P::Scalar::of), at_least))
}

/// Lengths are measured in that of the longest difference, so that no square overflows.
fn length_unit<S: Scalar>(lengths: impl Iterator<Item = S>) -> f64 {
    let unit = lengths.map(S::to_f64).filter(|length| length.is_finite()).fold(0.0, f64::max);
    if unit > 0.0 { unit } else { 1.0 }
}

/// A place on one of the pieces.
#[derive(Clone, Copy, Debug)]
struct Place {
    piece: usize,
    /// Its parameters on the piece, both from 0 to 1.
    at: [f64; 2],
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
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound).then(other.number.cmp(&self.number))
    }
}

impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Part {}

/// The place of the pieces that is nearest to the origin, up to that tolerance, and a lower bound of all distances.
fn search(pieces: &[Piece], tolerance: f64) -> Option<(Place, f64)> {
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
fn descend(pieces: &[Piece], start: Place) -> Place {
    let (at, distance) = pieces[start.piece].descend(start.at);
    if distance < start.distance { Place { at, distance, ..start } } else { start }
}
