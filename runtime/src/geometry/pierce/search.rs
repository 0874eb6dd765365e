//! The search through parts of a curve and parts of a surface.

use alloc::vec::Vec;

use crate::Scalar;

use super::net::{Local, Net, Vector, cross, deviation, dot, minus, norm, times};

/// The most pairs of parts of one pair of pieces that are looked at, and of all; those that are left then are answers as
/// they are.
const WORK: [usize; 2] = [60_000, 300_000];

/// So much shorter must one step make the product of three intervals to be better than halving one of them.
const SHRUNK: f64 = 0.6;

/// Intervals of the parameters of a piece of the curve, and of both of a piece of the surface.
pub(super) type Ranges = [[f64; 2]; 3];

/// A place at which a piece of the curve and one of the surface cross.
pub(super) struct Crossing {
    /// The indices of the pieces.
    pub(super) pieces: [usize; 2],
    pub(super) at: Vector,
    /// How far rounding errors may have moved each parameter.
    pub(super) reach: Vector,
}

/// Parts of the curve and of the surface that are within the accuracy of each other.
pub(super) struct Near {
    pub(super) pieces: [usize; 2],
    pub(super) ranges: Ranges,
    /// The ends of the part of the curve.
    pub(super) ends: [Vector; 2],
}

/// Parts that may meet.
struct Cell {
    pieces: [usize; 2],
    ranges: Ranges,
    curve: Net,
    surface: Net,
}

pub(super) struct Search<'a> {
    pub(super) curves: &'a [Net],
    pub(super) surfaces: &'a [Net],
    pub(super) accuracy: f64,
    /// What rounding errors of points may amount to.
    pub(super) noise: f64,
    pub(super) crossings: Vec<Crossing>,
    pub(super) near: Vec<Near>,
}

impl Search<'_> {
    #[inline]
    pub(super) fn run(&mut self) {
        let boxes = [self.curves, self.surfaces].map(|nets| nets.iter().map(Net::bounds).collect::<Vec<_>>());
        let mut work = 0;
        let mut open = Vec::new();
        for (i, a) in boxes[0].iter().enumerate() {
            for (j, b) in boxes[1].iter().enumerate() {
                if apart(a, b, self.accuracy) {
                    continue;
                }
                let (curve, surface) = (self.curves[i].clone(), self.surfaces[j].clone());
                open.push(Cell { pieces: [i, j], ranges: [[0.0, 1.0]; 3], curve, surface });
                let most = WORK[1].min(work + WORK[0]);
                while let Some(cell) = open.pop() {
                    work += 1;
                    self.look_at(&cell, work > most, &mut open);
                }
            }
        }
    }

    /// Puts a cell aside, answers it, or adds what of it is left.
    #[inline]
    fn look_at(&mut self, cell: &Cell, enough: bool, open: &mut Vec<Cell>) {
        if apart(&cell.curve.bounds(), &cell.surface.bounds(), self.accuracy) {
            return;
        }
        if enough {
            self.add_near(cell, [[0.0, 1.0]; 3]);
            return;
        }
        let (a, s) = (cell.curve.local([0.5, 0.0]), cell.surface.local([0.5; 2]));
        if self.is_aside(cell, &a, &s) {
            return;
        }
        let mut narrow = [[0.0, 1.0]; 3];
        if let Some(rows) = inverse(a.slopes[0], s.slopes) {
            let margins = rows.map(|row| self.noise * (row[0].abs() + row[1].abs() + row[2].abs()));
            if !narrow_by(&mut narrow, cell, [&a, &s], rows, margins) {
                return;
            }
            let shrinks = |k: usize| {
                let width = narrow[k][1] - narrow[k][0];
                let [lo, hi] = cell.ranges[k];
                // An interval as short as rounding errors does not; where these are large, next to a contact, that is
                // no reason.
                width < 0.8 || margins[k] * (hi - lo) < 1e-11 && width < 0.8 + 4.0 * margins[k]
            };
            if (0..3).all(shrinks)
                && let Some(crossing) = self.only_one(cell, &rows, [&a, &s])
            {
                self.crossings.push(crossing);
                return;
            }
        }
        let product = |narrow: &Ranges| narrow.iter().map(|[lo, hi]| hi - lo).product::<f64>();
        if product(&narrow) > SHRUNK {
            match self.along_tangents(cell, &a, &s, &mut narrow) {
                Tangent::Apart => return,
                Tangent::Beside => {
                    self.add_near(cell, narrow);
                    return;
                }
                Tangent::Unknown => {}
            }
        }
        let lengths = [cell.curve.length(0), cell.surface.length(0), cell.surface.length(1)];
        let longest = if lengths[0] >= lengths[1].max(lengths[2]) {
            0
        } else if lengths[1] >= lengths[2] {
            1
        } else {
            2
        };
        if lengths[longest] <= self.accuracy {
            self.add_near(cell, narrow);
        } else if product(&narrow) <= SHRUNK {
            self.push_part(cell, narrow, open);
        } else {
            for half in [[0.0, 0.5], [0.5, 1.0]] {
                let mut part = [[0.0, 1.0]; 3];
                part[longest] = half;
                self.push_part(cell, part, open);
            }
        }
    }

    /// Adds a part of a cell to those that are to be looked at; to the answers if floats cannot tell its ends apart.
    #[inline]
    fn push_part(&mut self, cell: &Cell, part: Ranges, open: &mut Vec<Cell>) {
        let ranges = within(&cell.ranges, &part);
        if ranges.iter().any(|[lo, hi]| hi - lo < 8.0 * f64::EPSILON) {
            self.add_near(cell, part);
            return;
        }
        let is_less = |[lo, hi]: [f64; 2]| lo > 0.0 || hi < 1.0;
        let mut next =
            Cell { pieces: cell.pieces, ranges, curve: cell.curve.clone(), surface: cell.surface.clone() };
        if is_less(part[0]) {
            next.curve = next.curve.restricted(0, part[0]);
        }
        for along in [0, 1] {
            if is_less(part[along + 1]) {
                next.surface = next.surface.restricted(along, part[along + 1]);
            }
        }
        open.push(next);
    }

    #[inline]
    fn add_near(&mut self, cell: &Cell, part: Ranges) {
        let ends = part[0].map(|x| cell.curve.local([x, 0.0]).point);
        self.near.push(Near { pieces: cell.pieces, ranges: within(&cell.ranges, &part), ends });
    }

    /// Whether the parts are farther apart than the accuracy along the normal of the surface, or across the chord of the
    /// curve.
    #[inline]
    fn is_aside(&self, cell: &Cell, a: &Local, s: &Local) -> bool {
        let between = minus(s.point, a.point);
        let chord = cell.curve.chord();
        let square = dot(chord, chord);
        let across =
            if square > 0.0 { minus(between, times(chord, dot(between, chord) / square)) } else { between };
        [cross(s.slopes[0], s.slopes[1]), across].into_iter().any(|direction| {
            let length = norm(direction);
            if !(length > f64::MIN_POSITIVE && length.is_finite()) {
                return false;
            }
            let direction = times(direction, 1.0 / length);
            let [a, b] = cell.curve.range(direction, s.point);
            let [c, d] = cell.surface.range(direction, s.point);
            (a - d).max(c - b) > self.accuracy
        })
    }

    /// The place at which the parts cross, if they meet at most once and Newton's method leads there.
    #[inline]
    fn only_one(&self, cell: &Cell, rows: &[Vector; 3], [a, s]: [&Local; 2]) -> Option<Crossing> {
        let weighted = rows.map(|row| times(row, 1.0 / (a.weight * s.weight)));
        let deviation = deviation(&cell.curve, &cell.surface, &weighted);
        if !deviation.iter().all(|&sum| sum < 0.9) {
            return None;
        }
        let (curve, surface) = (&self.curves[cell.pieces[0]], &self.surfaces[cell.pieces[1]]);
        let mut at = cell.ranges.map(|[lo, hi]| 0.5 * (lo + hi));
        let mut last = None;
        for _ in 0..16 {
            let (a, s) = (curve.local([at[0], 0.0]), surface.local([at[1], at[2]]));
            let rows = inverse(a.slopes[0], s.slopes)?;
            let difference = minus(a.point, s.point);
            let step = rows.map(|row| dot(row, difference));
            let speeds = [a.slopes[0], s.slopes[0], s.slopes[1]].map(norm);
            last = Some((norm(difference), rows, speeds));
            if norm(difference) == 0.0 {
                break;
            }
            at = minus(at, step);
            if !at.iter().all(|x| x.abs() < 8.0) {
                return None;
            }
            if step.iter().all(|step| step.abs() < 1e-15) {
                break;
            }
        }
        let (distance, rows, speeds) = last?;
        if distance.is_nan() || distance > self.noise {
            return None;
        }
        let mut reach = [0.0; 3];
        for (k, [lo, hi]) in cell.ranges.into_iter().enumerate() {
            let error = self.noise * rows[k].iter().map(|x| x.abs()).sum::<f64>();
            // Next to a contact rounding errors look like zeros, some roots of them apart.
            if error * speeds[k] > 0.1 * Scalar::sqrt(self.noise) {
                return None;
            }
            reach[k] = 1e-10 * (hi - lo) + error;
            if !(at[k] >= lo - reach[k] && at[k] <= hi + reach[k]) {
                return None;
            }
        }
        Some(Crossing { pieces: cell.pieces, at: at.map(|x| x.clamp(0.0, 1.0)), reach })
    }

    /// What the tangent plane of the surface and the tangent of the curve say; with half of the accuracy, so that of
    /// parts that are beside each other as far as that, all is within the whole of it.
    #[inline]
    fn along_tangents(&self, cell: &Cell, a: &Local, s: &Local, narrow: &mut Ranges) -> Tangent {
        let tangent = a.slopes[0];
        let square = dot(tangent, tangent);
        if square > 0.0 {
            let row = times(tangent, 1.0 / square);
            let around = cell.surface.range(row, a.point);
            if !take(&mut narrow[0], parameter(around, cell.curve.remainder(0, row, a.point)), {
                0.5 * self.accuracy * norm(row)
            }) {
                return Tangent::Apart;
            }
        }
        let [b, c] = s.slopes;
        let normal = cross(b, c);
        let square = dot(normal, normal);
        if square.is_nan() || square <= 1e-6 * dot(b, b) * dot(c, c) {
            return Tangent::Unknown;
        }
        let rows = [cross(c, normal), cross(normal, b)].map(|row| times(row, 1.0 / square));
        let mut beyond = 0.0;
        for (along, &row) in rows.iter().enumerate() {
            let around = cell.curve.range(row, s.point);
            let range = parameter(around, cell.surface.remainder(along, row, s.point));
            beyond += (-range[0]).max(range[1] - 1.0).max(0.0) * norm(s.slopes[along]);
            if !take(&mut narrow[along + 1], range, 0.5 * self.accuracy * norm(row)) {
                return Tangent::Apart;
            }
        }
        // Every point of the curve lies above one of the patch, not higher than the accuracy.
        let up = times(normal, 1.0 / norm(normal));
        let ([low, high], [under, over]) = (cell.curve.range(up, s.point), cell.surface.range(up, s.point));
        if beyond <= self.accuracy && (high - under).max(over - low) <= self.accuracy {
            Tangent::Beside
        } else {
            Tangent::Unknown
        }
    }
}

/// What tangents say of two parts.
enum Tangent {
    /// They do not meet.
    Apart,
    /// All of the curve is within the accuracy of the surface.
    Beside,
    Unknown,
}

/// Narrows the intervals by the functions with these gradients; `false` if one of them becomes empty.
#[inline]
fn narrow_by(
    narrow: &mut Ranges,
    cell: &Cell,
    [a, s]: [&Local; 2],
    rows: [Vector; 3],
    margins: Vector,
) -> bool {
    let around = cell.surface.range(rows[0], a.point);
    let range = parameter(around, cell.curve.remainder(0, rows[0], a.point));
    if !take(&mut narrow[0], range, margins[0]) {
        return false;
    }
    for along in [0, 1] {
        let row = times(rows[along + 1], -1.0);
        let around = cell.curve.range(row, s.point);
        let range = parameter(around, cell.surface.remainder(along, row, s.point));
        if !take(&mut narrow[along + 1], range, margins[along + 1]) {
            return false;
        }
    }
    true
}

/// The parameter of one part at which a linear function has a value in the range that it has on the other part.
#[inline]
fn parameter([low, high]: [f64; 2], remainder: [f64; 2]) -> [f64; 2] {
    [low + 0.5 - remainder[1], high + 0.5 - remainder[0]]
}

/// Narrows an interval to what it has in common with another one and its margin; `false` if that is nothing.
#[inline]
fn take(interval: &mut [f64; 2], [low, high]: [f64; 2], margin: f64) -> bool {
    let margin = margin + 1e-12;
    *interval = [interval[0].max(low - margin), interval[1].min(high + margin)];
    interval[0] <= interval[1]
}

/// The rows of the inverse of the matrix with the columns `a`, `-b`, `-c`; `None` if it is singular.
#[inline]
pub(super) fn inverse(a: Vector, [b, c]: [Vector; 2]) -> Option<[Vector; 3]> {
    let normal = cross(b, c);
    let determinant = dot(a, normal);
    let regular = determinant.abs() > 1e-10 * norm(a) * norm(b) * norm(c) && determinant.is_finite();
    let rows = [normal, cross(a, c), cross(b, a)];
    regular.then(|| rows.map(|row| times(row, 1.0 / determinant)))
}

/// Whether boxes are farther apart than a distance.
#[inline]
fn apart(a: &Ranges, b: &Ranges, distance: f64) -> bool {
    a.iter().zip(b).any(|([a, b], [c, d])| (a - d).max(c - b) > distance)
}

/// Parts of intervals, in the unit of the whole.
#[inline]
fn within(whole: &Ranges, part: &Ranges) -> Ranges {
    let place = |k: usize, x: f64| crate::domain::from_unit(whole[k], x);
    [0, 1, 2].map(|k| part[k].map(|x| place(k, x)))
}
