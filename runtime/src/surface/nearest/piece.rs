//! A Bézier patch of differences from a point: bounds of its distance from the origin, halves, and Newton's method.

use alloc::vec;
use alloc::vec::Vec;

use crate::numeric::binomial::row;

/// The most steps of Newton's method; it needs five or six unless the surface is singular there.
const STEPS: usize = 60;

/// The most control points of which the squared distance is expanded: their products are worth less on larger nets.
const SHARP: usize = 256;

/// Up to this degree the binomial coefficients of the squared distance are exact.
const EXACT: usize = 15;

/// A Bézier net of `(kv + 1)` rows of `(ku + 1)` points with `dim` components each; of a rational patch the components
/// are multiplied by the weight, which is one component more. Weights are positive.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    degrees: [usize; 2],
    dim: usize,
    /// The numbers of a point: `dim`, or one more if it has a weight.
    stride: usize,
    net: Vec<f64>,
}

impl Piece {
    #[inline]
    pub(crate) fn new(degrees: [usize; 2], dim: usize, net: Vec<f64>) -> Self {
        let stride = net.len() / ((degrees[0] + 1) * (degrees[1] + 1));
        Self { degrees, dim, stride, net }
    }

    #[cfg(feature = "geometry")]
    #[inline]
    pub(crate) fn degrees(&self) -> [usize; 2] {
        self.degrees
    }

    /// The number of components of a point.
    #[cfg(feature = "geometry")]
    #[inline]
    pub(crate) fn dim(&self) -> usize {
        self.dim
    }

    /// The largest value of a component of a control point times a sign; infinite if a weight is not positive.
    #[cfg(feature = "geometry")]
    #[inline]
    pub(crate) fn largest_of_points(&self, c: usize, sign: f64) -> f64 {
        (0..self.size()).fold(f64::NEG_INFINITY, |largest, n| {
            let (numerator, weight) = (sign * self.net[n * self.stride + c], self.weight(n));
            let value = if weight > 0.0 || weight.is_nan() || numerator.is_nan() {
                numerator / weight
            } else {
                f64::INFINITY
            };
            if value.is_nan() || largest.is_nan() { f64::NAN } else { largest.max(value) }
        })
    }

    /// The patch seen from a point and measured in a unit.
    #[cfg(feature = "geometry")]
    #[inline]
    pub(crate) fn seen_from(&self, origin: &[f64], unit: f64) -> Self {
        let mut net = self.net.clone();
        for (n, point) in net.chunks_exact_mut(self.stride).enumerate() {
            let weight = self.weight(n);
            for (x, origin) in point.iter_mut().zip(origin) {
                *x = (*x - origin * weight) / unit;
            }
        }
        Self { net, ..*self }
    }

    /// The largest difference of a component of a control point from that of a point; infinite if a weight is not
    /// positive, NaN if anything is not finite.
    #[cfg(feature = "geometry")]
    #[inline]
    pub(crate) fn farthest(&self, origin: &[f64]) -> f64 {
        let mut farthest = 0.0_f64;
        for (n, point) in self.net.chunks_exact(self.stride).enumerate() {
            let weight = self.weight(n);
            if !point.iter().all(|x| x.is_finite()) {
                return f64::NAN;
            }
            if weight <= 0.0 {
                return f64::INFINITY;
            }
            for (x, origin) in point.iter().zip(origin) {
                farthest = farthest.max((x / weight - origin).abs());
            }
        }
        farthest
    }

    #[inline]
    fn is_rational(&self) -> bool {
        self.stride > self.dim
    }

    #[inline]
    pub(super) fn is_finite(&self) -> bool {
        self.net.iter().all(|x| x.is_finite())
    }

    #[inline]
    fn size(&self) -> usize {
        (self.degrees[0] + 1) * (self.degrees[1] + 1)
    }

    #[inline]
    pub(crate) fn point(&self, i: usize, j: usize) -> &[f64] {
        &self.net[(j * (self.degrees[0] + 1) + i) * self.stride..][..self.dim]
    }

    /// The weight of a point.
    #[inline]
    pub(crate) fn weight(&self, n: usize) -> f64 {
        if self.is_rational() { self.net[n * self.stride + self.dim] } else { 1.0 }
    }

    /// The component `c` of all points, divided by their weights.
    #[inline]
    fn component(&self, c: usize) -> impl Iterator<Item = f64> {
        (0..self.size()).map(move |n| self.net[n * self.stride + c] / self.weight(n))
    }

    /// The corners, each with its distance.
    #[inline]
    pub(super) fn corners(&self) -> [([f64; 2], f64); 4] {
        let [ku, kv] = self.degrees;
        [[0, 0], [0, kv], [ku, 0], [ku, kv]].map(|[i, j]| {
            let at = [(i, ku), (j, kv)]
                .map(|(index, degree)| if degree > 0 && index == degree { 1.0 } else { 0.0 });
            let (point, weight) = (self.point(i, j), self.weight(j * (ku + 1) + i));
            (at, crate::Scalar::sqrt(product(point, point)) / weight)
        })
    }

    /// The distance of the bounding box of the control points.
    #[inline]
    pub(super) fn box_bound(&self) -> f64 {
        let square = (0..self.dim).fold(0.0, |sum, c| {
            let (lo, hi) = self
                .component(c)
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)));
            let away = lo.max(-hi).max(0.0);
            sum + away * away
        });
        crate::Scalar::sqrt(square)
    }

    /// The smallest Bernstein coefficient of the squared distance, as a distance; its error falls with the square of
    /// the size of the patch.
    ///
    /// ```text
    /// |S|² = Σ B[a,2ku] B[b,2kv] c[a,b],
    /// c[a,b] = Σ_(i+i'=a, j+j'=b) C(ku,i) C(ku,i') C(kv,j) C(kv,j') P[i,j]·P[i',j'] / (C(2ku,a) C(2kv,b))
    /// ```
    ///
    /// Of a rational patch the smallest quotient of the coefficients of numerator and squared weight.
    #[inline]
    pub(super) fn sharp_bound(&self) -> f64 {
        let [ku, kv] = self.degrees;
        if self.size() > SHARP {
            return 0.0;
        }
        let binomials = |degree| row(degree).collect::<Vec<f64>>();
        let (single, double) = ([binomials(ku), binomials(kv)], [binomials(2 * ku), binomials(2 * kv)]);
        let factor = |n: usize| single[0][n % (ku + 1)] * single[1][n / (ku + 1)];
        let scaled: Vec<f64> =
            self.net.iter().enumerate().map(|(n, x)| x * factor(n / self.stride)).collect();
        let point = |n: usize| &scaled[n * self.stride..][..self.dim];
        let weight = |n: usize| if self.is_rational() { scaled[n * self.stride + self.dim] } else { 0.0 };
        let columns = 2 * ku + 1;
        let mut sums = vec![0.0; columns * (2 * kv + 1)];
        let mut weights = sums.clone();
        for n in 0..self.size() {
            let (i, j) = (n % (ku + 1), n / (ku + 1));
            sums[2 * j * columns + 2 * i] += product(point(n), point(n));
            weights[2 * j * columns + 2 * i] += weight(n) * weight(n);
            for other in n + 1..self.size() {
                let (a, b) = (i + other % (ku + 1), j + other / (ku + 1));
                sums[b * columns + a] += 2.0 * product(point(n), point(other));
                weights[b * columns + a] += 2.0 * weight(n) * weight(other);
            }
        }
        let coefficient = |(n, sum): (usize, &f64)| {
            let of =
                if self.is_rational() { weights[n] } else { double[0][n % columns] * double[1][n / columns] };
            sum / of
        };
        let smallest = sums.iter().enumerate().map(coefficient).fold(f64::INFINITY, f64::min);
        let mut largest = self.net.iter().fold(0.0_f64, |largest, x| largest.max(x * x)) * self.dim as f64;
        if self.is_rational() {
            let least = (0..self.size()).map(|n| self.weight(n)).fold(f64::INFINITY, f64::min);
            largest /= least * least;
        }
        // The terms of a coefficient have weights that sum to 1; each has a few rounding errors, and those of binomial
        // coefficients that are not exact: two for each step from one to the next.
        let inexact = if ku.max(kv) > EXACT { 4 * (ku + kv) } else { 0 };
        let error = 4.0 * f64::EPSILON * (self.size() + self.dim + inexact) as f64 * largest;
        crate::Scalar::sqrt((smallest - error).max(0.0))
    }

    #[inline]
    pub(super) fn sharp_work(&self) -> usize {
        if self.size() > SHARP { 1 } else { self.size() * self.size() * self.stride }
    }

    #[inline]
    pub(super) fn halving_work(&self) -> usize {
        self.size() * (self.degrees[0].max(self.degrees[1]) + 1) * self.stride
    }

    /// What rounding errors of all halvings amount to at most.
    #[inline]
    pub(crate) fn rounding(&self) -> f64 {
        32.0 * f64::EPSILON * (self.degrees[0] + self.degrees[1] + 2) as f64
    }

    /// The direction in which the patch is longer.
    #[inline]
    pub(crate) fn longer(&self) -> usize {
        let [ku, kv] = self.degrees;
        let mut lengths = [0.0_f64; 2];
        for j in 0..=kv {
            for i in 0..=ku {
                let from = self.point(i, j);
                let step = |to: &[f64]| from.iter().zip(to).map(|(a, b)| (b - a) * (b - a)).sum::<f64>();
                if i < ku {
                    lengths[0] = lengths[0].max(step(self.point(i + 1, j)) * (ku * ku) as f64);
                }
                if j < kv {
                    lengths[1] = lengths[1].max(step(self.point(i, j + 1)) * (kv * kv) as f64);
                }
            }
        }
        usize::from(lengths[1] > lengths[0])
    }

    /// Both halves in that direction.
    #[inline]
    pub(crate) fn halved(&self, along: usize) -> [Self; 2] {
        self.split(along, 0.5)
    }

    /// The parts below and above a place in that direction, by de Casteljau's algorithm.
    #[inline]
    pub(crate) fn split(&self, along: usize, at: f64) -> [Self; 2] {
        let (mut lower, mut upper) = (self.net.clone(), self.net.clone());
        self.divide(&mut upper, &mut lower, along, at);
        [lower, upper].map(|net| Self { net, ..*self })
    }

    /// Makes of a net as long as this one the part above a place in that direction, and of `lower` the part below it.
    #[inline]
    pub(crate) fn divide(&self, upper: &mut [f64], lower: &mut [f64], along: usize, at: f64) {
        let degree = self.degrees[along];
        // Control points of that direction are `count` numbers apart, and as many are carried through all steps together.
        let count = if along == 0 { self.stride } else { (self.degrees[0] + 1) * self.stride };
        let length = (degree + 1) * count;
        for (upper, lower) in upper.chunks_exact_mut(length).zip(lower.chunks_exact_mut(length)) {
            lower[..count].copy_from_slice(&upper[..count]);
            for step in 1..=degree {
                for i in 0..=degree - step {
                    let (here, next) = upper[i * count..(i + 2) * count].split_at_mut(count);
                    for (x, next) in here.iter_mut().zip(next) {
                        *x = (1.0 - at) * *x + at * *next;
                    }
                }
                lower[step * count..][..count].copy_from_slice(&upper[..count]);
            }
        }
    }

    /// All numbers of the net.
    #[cfg(feature = "mesh")]
    #[inline]
    pub(crate) fn numbers(&self) -> &[f64] {
        &self.net
    }

    /// `[S, S_u, S_v, S_uu, S_uv, S_vv]` at a place, one after the other.
    #[inline]
    fn derivatives(&self, at: [f64; 2]) -> Vec<f64> {
        let [u, v] = [0, 1].map(|i| [0, 1, 2].map(|order| bernstein(self.degrees[i], at[i], order)));
        let mut all = vec![0.0; 6 * self.stride];
        for (n, point) in self.net.chunks_exact(self.stride).enumerate() {
            let (i, j) = (n % (self.degrees[0] + 1), n / (self.degrees[0] + 1));
            let orders = [[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2]];
            for (sum, [a, b]) in all.chunks_exact_mut(self.stride).zip(orders) {
                let factor = u[a][i] * v[b][j];
                for (sum, x) in sum.iter_mut().zip(point) {
                    *sum += factor * x;
                }
            }
        }
        if self.is_rational() { self.quotients(&all) } else { all }
    }

    /// The derivatives of the quotient `S = A / w`, by Leibniz' rule for `A = w S`.
    #[inline]
    fn quotients(&self, parts: &[f64]) -> Vec<f64> {
        let (dim, stride) = (self.dim, self.stride);
        let w = [0, 1, 2, 3, 4, 5].map(|n| parts[n * stride + dim]);
        let mut all = vec![0.0; 6 * dim];
        for c in 0..dim {
            let a = [0, 1, 2, 3, 4, 5].map(|n| parts[n * stride + c]);
            let s = a[0] / w[0];
            let [s_u, s_v] = [(a[1] - w[1] * s) / w[0], (a[2] - w[2] * s) / w[0]];
            let values = [
                s,
                s_u,
                s_v,
                (a[3] - 2.0 * w[1] * s_u - w[3] * s) / w[0],
                (a[4] - w[1] * s_v - w[2] * s_u - w[4] * s) / w[0],
                (a[5] - 2.0 * w[2] * s_v - w[5] * s) / w[0],
            ];
            for (n, value) in values.into_iter().enumerate() {
                all[n * dim + c] = value;
            }
        }
        all
    }

    #[inline]
    fn square(&self, at: [f64; 2]) -> f64 {
        let (u, v) = (bernstein(self.degrees[0], at[0], 0), bernstein(self.degrees[1], at[1], 0));
        let columns = u.len();
        let value = |c: usize| -> f64 {
            let all = self.net[c..].iter().step_by(self.stride).enumerate();
            all.map(|(n, x)| u[n % columns] * v[n / columns] * x).sum()
        };
        let square = (0..self.dim).fold(0.0, |square, c| square + value(c) * value(c));
        if self.is_rational() {
            let weight = value(self.dim);
            square / (weight * weight)
        } else {
            square
        }
    }

    /// Newton's method for `S·S_u = S·S_v = 0` on the unit square, with steps halved until the distance falls; where it
    /// is no descent, that of Gauss and Newton, and where that has no solution, one direction by itself. Returns the
    /// place and its distance.
    #[inline]
    pub(super) fn descend(&self, start: [f64; 2]) -> ([f64; 2], f64) {
        let (mut at, mut square) = (start, self.square(start));
        for _ in 0..STEPS {
            let all = self.derivatives(at);
            let part = |n: usize| &all[n * self.dim..][..self.dim];
            let inner = |a: usize, b: usize| product(part(a), part(b));
            let gradient = [inner(0, 1), inner(0, 2)];
            // Directions in which the patch ends are left out.
            let free =
                [0, 1].map(|i| !(at[i] <= 0.0 && gradient[i] >= 0.0 || at[i] >= 1.0 && gradient[i] <= 0.0));
            let first = [inner(1, 1), inner(1, 2), inner(2, 2)];
            let second = [first[0] + inner(0, 3), first[1] + inner(0, 4), first[2] + inner(0, 5)];
            let alone = [first[0], 0.0, first[2]];
            let downhill = |step: &[f64; 2]| step[0] * gradient[0] + step[1] * gradient[1] < 0.0;
            let steps =
                [second, first, alone].into_iter().filter_map(|matrix| newton_step(matrix, gradient, free));
            let Some(step) = steps.into_iter().find(downhill) else { break };
            let (mut factor, mut moved) = (1.0, false);
            while factor > 1e-10 && !moved {
                let next = [0, 1].map(|i| (at[i] + factor * step[i]).clamp(0.0, 1.0));
                let candidate = self.square(next);
                moved = candidate < square && next != at;
                if moved {
                    (at, square) = (next, candidate);
                }
                factor *= 0.5;
            }
            if !moved {
                break;
            }
        }
        (at, crate::Scalar::sqrt(square))
    }
}

#[inline]
fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The derivatives of that order of the Bernstein polynomials of that degree.
#[inline]
fn bernstein(degree: usize, t: f64, order: usize) -> Vec<f64> {
    let mut values = vec![0.0; degree + 1];
    if order > degree {
        return values;
    }
    values[0] = 1.0;
    for d in 1..=degree {
        let differentiated = d > degree - order;
        for i in (0..=d).rev() {
            let (before, here) =
                (if i > 0 { values[i - 1] } else { 0.0 }, if i < d { values[i] } else { 0.0 });
            values[i] =
                if differentiated { d as f64 * (before - here) } else { t * before + (1.0 - t) * here };
        }
    }
    values
}

/// `-M⁻¹ gradient` in the free directions, for the symmetric matrix `[[a, b], [b, c]]` if it is positive definite
/// there.
#[inline]
fn newton_step([a, b, c]: [f64; 3], gradient: [f64; 2], free: [bool; 2]) -> Option<[f64; 2]> {
    let [x, y] = gradient;
    let alone = |a: f64, x: f64| if a > 0.0 { -x / a } else { 0.0 };
    match free {
        [true, true] if b != 0.0 => {
            let determinant = a * c - b * b;
            let definite = a > 0.0 && determinant > 1e-14 * a * c;
            definite.then(|| [(b * y - c * x) / determinant, (b * x - a * y) / determinant])
        }
        [true, true] => Some([alone(a, x), alone(c, y)]),
        [true, false] => Some([alone(a, x), 0.0]),
        [false, true] => Some([0.0, alone(c, y)]),
        [false, false] => None,
    }
}
