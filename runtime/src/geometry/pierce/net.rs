//! A part of a curve or a surface as a Bézier net in space, and what its control points say about it.

use alloc::vec;
use alloc::vec::Vec;

use crate::Scalar;
use crate::geometry::CurvePiece;
use crate::surface::nearest::Piece;

pub(super) type Vector = [f64; 3];

/// A point times its weight, and the weight.
type Weighted = [f64; 4];

/// A rational Bézier net of `counts[1]` rows of `counts[0]` points with positive weights; that of a curve is one row.
#[derive(Clone)]
pub(super) struct Net {
    counts: [usize; 2],
    rational: bool,
    points: Vec<Weighted>,
}

/// A point and its derivatives in both directions.
pub(super) struct Local {
    pub(super) weight: f64,
    pub(super) point: Vector,
    pub(super) slopes: [Vector; 2],
}

impl Net {
    /// A curve, seen from a point and measured in a unit.
    #[inline]
    pub(super) fn of_curve(piece: &CurvePiece, origin: Vector, unit: f64) -> Self {
        let weight = |i: usize| piece.weights().map_or(1.0, |weights| weights[i]);
        let point = |i: usize| {
            let of = |d: usize| (piece.component(d)[i] - origin[d] * weight(i)) / unit;
            [of(0), of(1), of(2), weight(i)]
        };
        let points: Vec<Weighted> = (0..=piece.degree()).map(point).collect();
        Self { counts: [points.len(), 1], rational: piece.weights().is_some(), points }
    }

    /// A patch, seen from a point and measured in a unit.
    #[inline]
    pub(super) fn of_patch(piece: &Piece, origin: Vector, unit: f64) -> Self {
        let counts = piece.degrees().map(|degree| degree + 1);
        let point = |n: usize| {
            let (point, weight) = (piece.point(n % counts[0], n / counts[0]), piece.weight(n));
            let of = |d: usize| (point[d] - origin[d] * weight) / unit;
            [of(0), of(1), of(2), weight]
        };
        let points: Vec<Weighted> = (0..counts[0] * counts[1]).map(point).collect();
        let rational = points.iter().any(|p| p[3] != 1.0);
        Self { counts, rational, points }
    }

    /// The sum of both degrees.
    #[inline]
    pub(super) fn degree(&self) -> usize {
        self.counts[0] + self.counts[1] - 2
    }

    /// The point and its derivatives at a place of the unit square.
    #[inline]
    pub(super) fn local(&self, at: [f64; 2]) -> Local {
        let [columns, rows] = self.counts;
        let (mut values, mut slopes) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
        let mut row = vec![[0.0; 4]; columns];
        for points in self.points.chunks_exact(columns) {
            row.copy_from_slice(points);
            let [value, slope] = reduced(&mut row, at[0]);
            values.push(value);
            slopes.push(slope);
        }
        let [value, along_v] = reduced(&mut values, at[1]);
        let [along_u, _] = reduced(&mut slopes, at[1]);
        let w = value[3];
        let point = [value[0] / w, value[1] / w, value[2] / w];
        let quotient = |slope: Weighted| [0, 1, 2].map(|d| (slope[d] - slope[3] * point[d]) / w);
        Local { weight: w, point, slopes: [quotient(along_u), quotient(along_v)] }
    }

    /// The index of the point `k` of a row, or with `along == 1` of a column.
    #[inline]
    fn index(&self, along: usize, line: usize, k: usize) -> usize {
        if along == 0 { line * self.counts[0] + k } else { k * self.counts[0] + line }
    }

    /// The part between two places in one direction.
    #[inline]
    pub(super) fn restricted(&self, along: usize, [from, to]: [f64; 2]) -> Self {
        let mut part = self.clone();
        let mut list = vec![[0.0; 4]; self.counts[along]];
        for line in 0..self.counts[1 - along] {
            for (k, point) in list.iter_mut().enumerate() {
                *point = self.points[self.index(along, line, k)];
            }
            crate::bernstein::restrict(&mut list, from, to);
            for (k, &point) in list.iter().enumerate() {
                part.points[self.index(along, line, k)] = point;
            }
        }
        part
    }

    /// The control points.
    #[inline]
    fn controls(&self) -> impl Iterator<Item = Vector> {
        self.points.iter().map(|p| [p[0] / p[3], p[1] / p[3], p[2] / p[3]])
    }

    /// The box around the control points.
    #[inline]
    pub(super) fn bounds(&self) -> [[f64; 2]; 3] {
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for point in self.controls() {
            for (side, x) in bounds.iter_mut().zip(point) {
                *side = [side[0].min(x), side[1].max(x)];
            }
        }
        bounds
    }

    /// The range of `direction · (P - from)` over all points.
    #[inline]
    pub(super) fn range(&self, direction: Vector, from: Vector) -> [f64; 2] {
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for point in self.controls() {
            let x = dot(direction, minus(point, from));
            range = [range[0].min(x), range[1].max(x)];
        }
        range
    }

    /// The range of `direction · (P(x) - from) + 1/2 - x` over all points, where `x` is the parameter in a direction:
    /// of `Σ B (N - x W)` over `Σ B W`, with the degree raised by one.
    #[inline]
    pub(super) fn remainder(&self, along: usize, direction: Vector, from: Vector) -> [f64; 2] {
        let value = |n: usize| {
            let [x, y, z, w] = self.points[n];
            dot(direction, [x - w * from[0], y - w * from[1], z - w * from[2]]) + 0.5 * w
        };
        let count = self.counts[along];
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for line in 0..self.counts[1 - along] {
            let mut before = [0.0; 2];
            for k in 0..=count {
                let n = self.index(along, line, k);
                let here = if k < count { [value(n), self.points[n][3]] } else { [0.0; 2] };
                let x = k as f64 / count as f64;
                let numerator = x * (before[0] - before[1]) + (1.0 - x) * here[0];
                let quotient = numerator / (x * before[1] + (1.0 - x) * here[1]);
                range = [range[0].min(quotient), range[1].max(quotient)];
                before = here;
            }
        }
        range
    }

    /// The largest length of a row or column of control points.
    #[inline]
    pub(super) fn length(&self, along: usize) -> f64 {
        let points: Vec<Vector> = self.controls().collect();
        let mut longest = 0.0_f64;
        for line in 0..self.counts[1 - along] {
            let point = |k: usize| points[self.index(along, line, k)];
            let length = (1..self.counts[along]).map(|k| norm(minus(point(k), point(k - 1)))).sum();
            longest = longest.max(length);
        }
        longest
    }

    /// The last point minus the first one.
    #[inline]
    pub(super) fn chord(&self) -> Vector {
        let point = |p: &Weighted| [p[0] / p[3], p[1] / p[3], p[2] / p[3]];
        match &self.points[..] {
            [first, .., last] => minus(point(last), point(first)),
            _ => [0.0; 3],
        }
    }

    /// The coefficients of the derivative in one direction.
    #[inline]
    fn differences(&self, along: usize) -> Vec<Weighted> {
        let degree = self.counts[along] - 1;
        let mut differences = Vec::with_capacity(degree * self.counts[1 - along]);
        for line in 0..self.counts[1 - along] {
            for k in 0..degree {
                let [a, b] = [k, k + 1].map(|k| self.points[self.index(along, line, k)]);
                differences.push([0, 1, 2, 3].map(|c| degree as f64 * (b[c] - a[c])));
            }
        }
        differences
    }
}

/// For each row of a matrix the sum of the largest differences of its products with the derivatives of
/// `F = A(x) W(u, v) - S(u, v) w(x)` from the unit matrix.
#[inline]
pub(super) fn deviation(curve: &Net, surface: &Net, rows: &[Vector; 3]) -> Vector {
    let mut sums = [0.0; 3];
    let mut add = |column: usize, vectors: &mut dyn Iterator<Item = Vector>| {
        let mut largest = [0.0_f64; 3];
        for vector in vectors {
            for (k, row) in rows.iter().enumerate() {
                let one = if k == column { 1.0 } else { 0.0 };
                largest[k] = largest[k].max((dot(*row, vector) - one).abs());
            }
        }
        for (sum, largest) in sums.iter_mut().zip(largest) {
            *sum += largest;
        }
    };
    let forward = curve.differences(0);
    let across = [0, 1].map(|along| surface.differences(along));
    let xyz = |p: &Weighted| [p[0], p[1], p[2]];
    if !curve.rational && !surface.rational {
        add(0, &mut forward.iter().map(xyz));
        for (k, slopes) in across.iter().enumerate() {
            add(k + 1, &mut slopes.iter().map(|p| [-p[0], -p[1], -p[2]]));
        }
        return sums;
    }
    let mixed = |a: &Weighted, s: &Weighted| [0, 1, 2].map(|d| a[d] * s[3] - s[d] * a[3]);
    add(0, &mut forward.iter().flat_map(|a| surface.points.iter().map(move |s| mixed(a, s))));
    for (k, slopes) in across.iter().enumerate() {
        add(k + 1, &mut slopes.iter().flat_map(|s| curve.points.iter().map(move |a| mixed(a, s))));
    }
    sums
}

/// The value and the derivative of a polynomial, by de Casteljau's algorithm in place.
#[inline]
fn reduced(points: &mut [Weighted], x: f64) -> [Weighted; 2] {
    let degree = points.len() - 1;
    for last in (2..=degree).rev() {
        for i in 0..last {
            points[i] = [0, 1, 2, 3].map(|c| (1.0 - x) * points[i][c] + x * points[i + 1][c]);
        }
    }
    match *points {
        [a, b, ..] => [
            [0, 1, 2, 3].map(|c| (1.0 - x) * a[c] + x * b[c]),
            [0, 1, 2, 3].map(|c| degree as f64 * (b[c] - a[c])),
        ],
        [a] => [a, [0.0; 4]],
        [] => [[0.0; 4]; 2],
    }
}

#[inline]
pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(super) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline]
pub(super) fn times(a: Vector, factor: f64) -> Vector {
    a.map(|x| x * factor)
}

#[inline]
pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    crate::vector::cross(a, b)
}

#[inline]
pub(super) fn norm(a: Vector) -> f64 {
    Scalar::sqrt(dot(a, a))
}
