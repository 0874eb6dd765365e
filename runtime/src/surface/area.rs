//! The area of rational Bézier patches, with a proved bound of its error.
//!
//! Of a patch `A / w` the vector `S_u ∧ S_v` is `M / w³` with a polynomial `M` in Bernstein form, and the area is the
//! integral of `|M| / w³` over the unit square. On a cell of the square, with `s` from -1 to 1 along one of its
//! directions, `M = Σ a_k sᵏ`, and control points bound `|a_k|` by `A_k` whatever the other parameter. In the ellipse around
//! the interval with the semi-axes `R` and `√(R² - 1)` the polynomial `M` is within `Σ A_k Rᵏ`, `k >= 1`, of `a_0`. While that
//! is at most `2/5` of the least `|a_0|`, the square `M·M` differs from `a_0·a_0` by less than `24/25` of it, so that its
//! root has no singularity there and is at most `7/5` of the largest `|a_0|`. The same holds for `w`, so that `w⁻³` is at most
//! `(3/5 w_0)⁻³`. A function that is at most `m` in the ellipse differs from a polynomial of degree `2n - 1` by at most
//! `2 m ρ¹⁻²ⁿ / (ρ - 1)` with `ρ = R + √(R² - 1)` (L. N. Trefethen, "Approximation Theory and Approximation Practice",
//! theorem 8.2), and the rule of Gauss with `n` nodes, exact for that polynomial, from its mean by at most twice as much. Cells
//! without such an ellipse, such as those at a pole, are bounded by the longest control point of `M`.

use alloc::vec;
use alloc::vec::Vec;

use super::SurfacePiece;
use super::nearest::Piece;
use crate::Scalar;
use crate::bernstein::centred_powers;
use crate::numeric::binomial::row;
use crate::numeric::gauss::jacobi;

/// The numbers of nodes of the rules, in increasing order.
const NODES: [usize; 6] = [2, 4, 6, 10, 16, 24];

/// At how many cells the work ends.
const CELLS: usize = 1 << 11;

/// The area of a surface, [`BoundedSurface::area`](crate::BoundedSurface::area).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Area<S> {
    /// The area, in the square of the unit of length.
    pub value: S,
    /// A bound of the error of the value, proved up to rounding errors: at most the accuracy that was asked for, or some
    /// 64 `ε` times the square of the size of the surface if that is more. Where a surface is folded along many curves
    /// the work may end earlier, with a larger bound.
    pub error: S,
}

/// The area of the patches together.
#[inline]
pub(super) fn of_pieces<S: Scalar>(pieces: &[SurfacePiece], accuracy: f64, epsilon: f64) -> Option<Area<S>> {
    let nets: Vec<&Piece> = pieces.iter().map(|piece| &piece.net).collect();
    let [value, error] = of_nets(&nets, accuracy, epsilon)?;
    Some(Area { value: S::of(value), error: S::of(error) })
}

/// The area and a bound of its error.
#[inline]
fn of_nets(nets: &[&Piece], accuracy: f64, epsilon: f64) -> Option<[f64; 2]> {
    // Seen from a point of the surface and in a unit of its size nothing overflows, and less is lost to rounding.
    let origin: Vec<f64> = nets.first()?.point(0, 0).iter().map(|x| x / nets[0].weight(0)).collect();
    let unit = nets.iter().map(|net| net.farthest(&origin)).fold(0.0, |a, b| if a >= b { a } else { b });
    if !unit.is_finite() {
        return None;
    }
    if unit == 0.0 {
        return Some([0.0, 0.0]);
    }
    let patches: Vec<Patch> = nets.iter().map(|net| Patch::new(&net.seen_from(&origin, unit))).collect();
    let mut cells: Vec<Cell> = patches.iter().enumerate().map(|(k, patch)| patch.whole(k)).collect();
    let accuracy = if accuracy > 0.0 { accuracy / unit / unit } else { 0.0 };
    // The other half is for rules with fewer nodes than the most.
    let target = 0.5 * accuracy.max(64.0 * epsilon);
    loop {
        let total: f64 = cells.iter().map(Cell::best).sum();
        if total <= target || cells.len() > CELLS {
            break;
        }
        let share = target / cells.len() as f64;
        let (few, many): (Vec<Cell>, Vec<Cell>) = cells.into_iter().partition(|cell| cell.best() <= share);
        cells = few;
        cells.extend(many.iter().flat_map(Cell::halves));
    }
    // Where the work has ended early, finer rules in some cells gain nothing.
    let target = cells.iter().map(Cell::best).sum::<f64>().max(target);
    let (mut value, mut error) = (0.0, 0.0);
    for cell in &cells {
        let enough = cell.best().max(target * cell.size / patches.len() as f64);
        let rule = (0..NODES.len()).find(|&rule| cell.error(rule) <= enough).unwrap_or(NODES.len() - 1);
        value += patches[cell.patch].integral(cell, rule);
        error += cell.error(rule);
    }
    let found = [value * unit * unit, error * unit * unit];
    found.iter().all(|x| x.is_finite()).then_some(found)
}

/// What does not change when a patch is cut.
struct Patch {
    normal: Piece,
    weight: Option<Piece>,
    /// For each rule its nodes, each with its weight and the Bernstein polynomials there: those of `M` in `u` and in `v`, and
    /// those of `w`.
    rules: Vec<Vec<Node>>,
}

struct Node {
    weight: f64,
    normal: [Vec<f64>; 2],
    denominator: [Vec<f64>; 2],
}

/// A part of the unit square of a patch.
struct Cell {
    patch: usize,
    normal: Piece,
    weight: Option<Piece>,
    /// The area in the unit square.
    size: f64,
    /// A bound of `|M| / w³`.
    longest: f64,
    /// What the functions are at most in the ellipses around `u` and `v`, and the sums of the semi-axes of these.
    most: f64,
    axes: [f64; 2],
}

impl Cell {
    #[inline]
    fn new(patch: usize, normal: Piece, weight: Option<Piece>, size: f64) -> Self {
        let [rows, columns] = normal.degrees().map(|degree| degree + 1);
        let points: Vec<&[f64]> =
            (0..rows * columns).map(|n| normal.point(n / columns, n % columns)).collect();
        let centre: Vec<f64> = (0..normal.dim())
            .map(|c| points.iter().map(|point| point[c]).sum::<f64>() / points.len() as f64)
            .collect();
        let length = norm(centre.iter().copied());
        let forwards = |point: &[f64]| product(point, &centre) / length;
        let least = points.iter().map(|point| forwards(point)).fold(length, f64::min).max(0.0);
        let mut longest = points.iter().map(|point| norm(point.iter().copied())).fold(0.0, f64::max);
        let mut axes = [0, 1].map(|along| ellipse(&powers(&normal, along), least));
        let mut most = 1.4 * longest;
        if let Some(weight) = &weight {
            let [rows, columns] = weight.degrees().map(|degree| degree + 1);
            let weights = (0..rows * columns).map(|n| weight.point(n / columns, n % columns)[0]);
            let low = weights.fold(f64::INFINITY, f64::min);
            for (along, axis) in axes.iter_mut().enumerate() {
                *axis = axis.min(ellipse(&powers(weight, along), low));
            }
            most /= cube(0.6 * low);
            longest /= cube(low);
        }
        Self { patch, normal, weight, size, longest, most, axes }
    }

    /// A bound of the error of a rule.
    #[inline]
    fn error(&self, rule: usize) -> f64 {
        let along = |axis: f64| {
            if axis > 1.0 {
                4.0 * self.most / power(axis, 2 * NODES[rule] - 1) / (axis - 1.0)
            } else {
                f64::INFINITY
            }
        };
        self.size * (along(self.axes[0]) + along(self.axes[1])).min(self.longest)
    }

    #[inline]
    fn best(&self) -> f64 {
        self.error(NODES.len() - 1)
    }

    #[inline]
    fn halves(&self) -> [Self; 2] {
        let along = self.normal.longer();
        let [before, after] = self.normal.halved(along);
        let [weight_before, weight_after] =
            self.weight.as_ref().map_or([None, None], |weight| weight.halved(along).map(Some));
        [(before, weight_before), (after, weight_after)]
            .map(|(normal, weight)| Self::new(self.patch, normal, weight, 0.5 * self.size))
    }
}

impl Patch {
    /// From a net whose last component is the weight, if it has one.
    #[inline]
    fn new(net: &Piece) -> Self {
        let dim = net.dim();
        let degrees = net.degrees();
        let columns = degrees[1] + 1;
        let weights: Vec<f64> = (0..(degrees[0] + 1) * columns)
            .map(|n| net.weight((n % columns) * (degrees[0] + 1) + n / columns))
            .collect();
        let equal = weights.iter().all(|&weight| weight == weights[0]);
        let component = |c: usize| {
            let of = |n: usize| net.point(n / columns, n % columns)[c] / if equal { weights[0] } else { 1.0 };
            Polynomial { degrees, coefficients: (0..weights.len()).map(of).collect() }
        };
        let a: Vec<Polynomial> = (0..dim).map(component).collect();
        let [a_u, a_v] = [0, 1].map(|axis| a.iter().map(|a| a.derivative(axis)).collect::<Vec<_>>());
        let wedge = |p: &[Polynomial], q: &[Polynomial], [i, j]: [usize; 2]| {
            p[i].times(&q[j]).plus(&p[j].times(&q[i]), -1.0)
        };
        let w = Polynomial { degrees, coefficients: weights };
        let [w_u, w_v] = [w.derivative(0), w.derivative(1)];
        let mut minors: Vec<Polynomial> = Vec::new();
        for i in 0..dim {
            for j in i + 1..dim {
                let plain = wedge(&a_u, &a_v, [i, j]);
                minors.push(if equal {
                    plain
                } else {
                    // (A/w)_u ∧ (A/w)_v = (w A_u ∧ A_v - w_v A_u ∧ A - w_u A ∧ A_v) / w³
                    let moved = w.times(&plain).plus(&w_v.times(&wedge(&a_u, &a, [i, j])), -1.0);
                    moved.plus(&w_u.times(&wedge(&a, &a_v, [i, j])), -1.0)
                });
            }
        }
        let normal = piece(&minors);
        let weight = (!equal).then(|| piece(&[w]));
        let rules = NODES.iter().map(|&count| {
            let node = |[x, weight]: [f64; 2]| Node {
                weight,
                normal: normal.degrees().map(|degree| values(degree, x)),
                denominator: degrees.map(|degree| values(degree, x)),
            };
            jacobi(count, 0).into_iter().map(node).collect()
        });
        let rules = rules.collect();
        Self { normal, weight, rules }
    }

    #[inline]
    fn whole(&self, patch: usize) -> Cell {
        Cell::new(patch, self.normal.clone(), self.weight.clone(), 1.0)
    }

    /// The integral over a cell by a rule.
    #[inline]
    fn integral(&self, cell: &Cell, rule: usize) -> f64 {
        let nodes = &self.rules[rule];
        let mut sum = 0.0;
        for v in nodes {
            let normal = along_u(&cell.normal, &v.normal[1]);
            let denominator = cell.weight.as_ref().map(|weight| along_u(weight, &v.denominator[1]));
            for u in nodes {
                let components = normal.iter().map(|list| product(list, &u.normal[0]));
                let weight = denominator.as_ref().map_or(1.0, |lists| product(&lists[0], &u.denominator[0]));
                sum += u.weight * v.weight * norm(components) / cube(weight);
            }
        }
        sum * cell.size
    }
}

/// The Bernstein coefficients in `u` of each component, from the Bernstein polynomials in `v`.
#[inline]
fn along_u(net: &Piece, v: &[f64]) -> Vec<Vec<f64>> {
    let coefficient = |i: usize, c: usize| v.iter().enumerate().map(|(j, b)| b * net.point(i, j)[c]).sum();
    (0..net.dim()).map(|c| (0..=net.degrees()[0]).map(|i| coefficient(i, c)).collect()).collect()
}

#[inline]
fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[inline]
fn cube(x: f64) -> f64 {
    x * x * x
}

#[inline]
fn power(x: f64, exponent: usize) -> f64 {
    (0..exponent).fold(1.0, |power, _| power * x)
}

#[inline]
fn norm(components: impl Iterator<Item = f64>) -> f64 {
    Scalar::sqrt(components.map(|x| x * x).sum::<f64>())
}

/// Bounds `A_k` of the lengths of the coefficients of the powers along one direction, about the middle of the interval.
#[inline]
fn powers(net: &Piece, along: usize) -> Vec<f64> {
    let degrees = net.degrees();
    let mut bounds = vec![0.0_f64; degrees[along] + 1];
    let mut squares = bounds.clone();
    for other in 0..=degrees[1 - along] {
        squares.fill(0.0);
        for c in 0..net.dim() {
            let coefficient =
                |k: usize| if along == 0 { net.point(k, other)[c] } else { net.point(other, k)[c] };
            let mut list: Vec<f64> = (0..=degrees[along]).map(coefficient).collect();
            centred_powers(&mut list);
            for (square, x) in squares.iter_mut().zip(list) {
                *square += x * x;
            }
        }
        for (bound, &square) in bounds.iter_mut().zip(&squares) {
            *bound = bound.max(Scalar::sqrt(square));
        }
    }
    bounds
}

/// The sum `ρ` of the semi-axes of an ellipse in which a polynomial with these bounds of its coefficients stays within `2/5`
/// of its value in the middle, which is at least `least`; 0 if there is none.
#[inline]
fn ellipse(bounds: &[f64], least: f64) -> f64 {
    let fits = |r: f64| bounds.iter().skip(1).rev().fold(0.0, |sum, bound| (sum + bound) * r) <= 0.4 * least;
    if least.is_nan() || least <= 0.0 || !fits(1.0) {
        return 0.0;
    }
    // Beyond this nothing is gained.
    let [mut low, mut high] = [1.0, 1e9];
    while high > 1.01 * low {
        let middle = Scalar::sqrt(low * high);
        if fits(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low + Scalar::sqrt(low * low - 1.0)
}

/// The Bernstein polynomials of that degree.
#[inline]
fn values(degree: usize, x: f64) -> Vec<f64> {
    row(degree).enumerate().map(|(k, binomial)| binomial * power(x, k) * power(1.0 - x, degree - k)).collect()
}

/// A net whose points have these components.
#[inline]
fn piece(components: &[Polynomial]) -> Piece {
    let degrees = components.first().map_or([0, 0], |first| first.degrees);
    let [rows, columns] = degrees.map(|degree| degree + 1);
    let mut net = Vec::with_capacity(rows * columns * components.len());
    for j in 0..columns {
        for i in 0..rows {
            net.extend(components.iter().map(|p| p.coefficients[i * columns + j]));
        }
    }
    Piece::new(degrees, components.len(), net)
}

/// A polynomial of two variables by its Bernstein coefficients, those of one function of `u` one after the other.
struct Polynomial {
    degrees: [usize; 2],
    coefficients: Vec<f64>,
}

impl Polynomial {
    #[inline]
    fn derivative(&self, axis: usize) -> Self {
        let columns = self.degrees[1] + 1;
        let degree = self.degrees[axis];
        let mut degrees = self.degrees;
        if degree == 0 {
            return Self { degrees, coefficients: vec![0.0; self.coefficients.len()] };
        }
        degrees[axis] -= 1;
        let [step, width] = [if axis == 0 { columns } else { 1 }, degrees[1] + 1];
        let of = |n: usize| {
            let place = (n / width) * columns + n % width;
            degree as f64 * (self.coefficients[place + step] - self.coefficients[place])
        };
        Self { degrees, coefficients: (0..(degrees[0] + 1) * width).map(of).collect() }
    }

    #[inline]
    fn plus(mut self, other: &Self, factor: f64) -> Self {
        for (a, b) in self.coefficients.iter_mut().zip(&other.coefficients) {
            *a += factor * b;
        }
        self
    }

    /// `Σ C(m,i) C(m',i') C(n,j) C(n',j') p[i,j] q[i',j'] / (C(m+m',a) C(n+n',b))` over `i + i' = a`, `j + j' = b`.
    #[inline]
    fn times(&self, other: &Self) -> Self {
        let degrees = [0, 1].map(|axis| self.degrees[axis] + other.degrees[axis]);
        let [mine, theirs, both] =
            [self.degrees, other.degrees, degrees].map(|d| d.map(|degree| row(degree).collect::<Vec<f64>>()));
        let [columns, other_columns, width] =
            [self.degrees[1], other.degrees[1], degrees[1]].map(|degree| degree + 1);
        let mut coefficients = vec![0.0; (degrees[0] + 1) * width];
        for (n, p) in self.coefficients.iter().enumerate() {
            let (i, j) = (n / columns, n % columns);
            for (m, q) in other.coefficients.iter().enumerate() {
                let (k, l) = (m / other_columns, m % other_columns);
                let ways = (mine[0][i] * theirs[0][k] / both[0][i + k])
                    * (mine[1][j] * theirs[1][l] / both[1][j + l]);
                coefficients[(i + k) * width + j + l] += ways * p * q;
            }
        }
        Self { degrees, coefficients }
    }
}
