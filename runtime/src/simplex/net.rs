//! Bernstein nets on triangles and tetrahedra: sums, steps of de Casteljau's algorithm, and their transposes.
//!
//! A net of degree `n` holds one element for each index of the order `n`, in lexicographic order; see
//! [`SimplexIndex`](super::SimplexIndex).

use super::index::TriangleIndex;
#[cfg(feature = "elements")]
use super::index::lattice_size;
use crate::bernstein::elevate;
use crate::{Point, Scalar};

/// One step down: `c[β] = Σ_j a[j] c[β + e_j]` for all `β` of the order `n - 1`, in place.
///
/// With barycentric coordinates for `a` it is a step of de Casteljau's algorithm; with a direction, coordinates with
/// the sum zero, the derivative in that direction divided by `n`.
#[inline]
pub(crate) fn contract<P: Point>(net: &mut [P], n: usize, a: &[P::Scalar]) {
    match *a {
        [u, v, w] => {
            let (mut out, mut row) = (0, 0);
            for i in 0..n {
                let next = row + n - i + 1;
                for j in 0..n - i {
                    net[out] = net[row + j]
                        .scale(w)
                        .add_weighted(net[row + j + 1], v)
                        .add_weighted(net[next + j], u);
                    out += 1;
                }
                row = next;
            }
        }
        [u, v, w, x] => {
            let (mut out, mut layer) = (0, 0);
            for h in 0..n {
                // The layer is a triangle of the order m.
                let m = n - h;
                let (mut row, mut above) = (layer, layer + (m + 1) * (m + 2) / 2);
                layer = above;
                for i in 0..m {
                    let next = row + m - i + 1;
                    for j in 0..m - i {
                        let inner = net[row + j]
                            .scale(x)
                            .add_weighted(net[row + j + 1], w)
                            .add_weighted(net[next + j], v);
                        net[out] = inner.add_weighted(net[above], u);
                        out += 1;
                        above += 1;
                    }
                    row = next;
                }
            }
        }
        _ => {}
    }
}

/// Bernstein's functions of the degree `n + 1` from those of the degree `n`: the transpose of a step of [`contract`].
#[cfg(feature = "elements")]
pub(crate) fn raised<S: Scalar>(functions: &[S], n: usize, at: &[S]) -> alloc::vec::Vec<S> {
    let mut raised = alloc::vec![S::ZERO; lattice_size(at.len(), n + 1)];
    let mut add = |place: usize, value: S| raised[place] = raised[place] + value;
    let mut functions = functions.iter();
    match *at {
        [u, v, w] => {
            let mut row = 0;
            for i in 0..=n {
                let next = row + n + 2 - i;
                for (j, &c) in functions.by_ref().take(n + 1 - i).enumerate() {
                    add(row + j, c * w);
                    add(row + j + 1, c * v);
                    add(next + j, c * u);
                }
                row = next;
            }
        }
        [u, v, w, x] => {
            let mut layer = 0;
            for h in 0..=n {
                // The layer is a triangle of the order m.
                let m = n + 1 - h;
                let (mut row, mut above) = (layer, layer + (m + 1) * (m + 2) / 2);
                layer = above;
                for i in 0..m {
                    let next = row + m + 1 - i;
                    for (j, &c) in functions.by_ref().take(m - i).enumerate() {
                        add(row + j, c * x);
                        add(row + j + 1, c * w);
                        add(next + j, c * v);
                        add(above, c * u);
                        above += 1;
                    }
                    row = next;
                }
            }
        }
        _ => {}
    }
    raised
}

/// `Σ c[α] x^α`, by nested multiplication; a Bernstein net has its multinomial factors in `c`.
///
/// With all numbers nonnegative no step is negative.
#[inline]
pub(crate) fn simplex_sum<S: Scalar>(coefficients: &[S], at: &[S], n: usize) -> S {
    match *at {
        [u, v, w] => triangle_sum(coefficients, [u, v, w], n),
        [u, v, w, x] => {
            // Layers from the highest power of u down.
            let mut end = coefficients.len();
            let mut sum = S::ZERO;
            for m in 0..=n {
                let start = end - (m + 1) * (m + 2) / 2;
                sum = sum * u + triangle_sum(&coefficients[start..end], [v, w, x], m);
                end = start;
            }
            sum
        }
        _ => S::ZERO,
    }
}

#[inline]
fn triangle_sum<S: Scalar>(coefficients: &[S], [u, v, w]: [S; 3], n: usize) -> S {
    let mut end = coefficients.len();
    let mut sum = S::ZERO;
    for m in 0..=n {
        // The row with the factor u^(n - m): Σ_j c[j] v^j w^(m - j).
        let row = &coefficients[end - m - 1..end];
        end -= m + 1;
        let mut power = S::ONE;
        let row = row[1..].iter().fold(row[0], |row, &c| {
            power = power * v;
            row * w + c * power
        });
        sum = sum * u + row;
    }
    sum
}

/// The point `Σ factors[α] x^α c[α]` on a triangle, by nested multiplication.
#[inline]
pub(crate) fn triangle_point<P: Point>(net: &[P], factors: &[f64], [u, v, w]: [P::Scalar; 3], n: usize) -> P {
    let mut end = net.len();
    let mut sum = P::zero();
    for m in 0..=n {
        let start = end - m - 1;
        let mut power = P::Scalar::ONE;
        let mut row = net[start].scale(P::Scalar::of(factors[start]));
        for place in start + 1..end {
            power = power * v;
            row = row.scale(w).add_weighted(net[place], power * P::Scalar::of(factors[place]));
        }
        sum = row.add_weighted(sum, u);
        end = start;
    }
    sum
}

/// The row `i` of the net of the same patch over the unit square, `u = x`, `v = (1 - x) y`: of its `n + 1` rows with as
/// many points, that row is the curve over `net[i, k, n - i - k]`, `k = 0, …, n - i`, with its degree raised to `n`.
#[inline]
pub(crate) fn square_row<P: Point>(net: &[P], n: usize, i: usize, row: &mut [P]) {
    let first = TriangleIndex::new([i, 0, n - i]).position();
    elevate(&net[first..=first + n - i], row);
}

/// The control points of the polynomial along a straight line in the triangle, from the barycentric coordinates of both ends.
#[cfg(feature = "geometry")]
#[inline]
pub(crate) fn triangle_line<P: Point>(
    net: &[P],
    n: usize,
    [from, to]: [[P::Scalar; 3]; 2],
) -> alloc::vec::Vec<P> {
    // The point k is the blossom with n - k arguments at the start and k at the end.
    let mut start = net.to_vec();
    let mut points = alloc::vec![P::zero(); n + 1];
    for i in 0..=n {
        let mut rest = start.clone();
        for m in (1..=n - i).rev() {
            contract(&mut rest, m, &to);
        }
        points[n - i] = rest[0];
        if i < n {
            contract(&mut start, n - i, &from);
        }
    }
    points
}

/// The net of the part of a triangular patch in a smaller triangle: the corner at `place` is moved to the point `at`.
pub(super) fn moved_corner<P: Point, N: AsRef<[P]> + AsMut<[P]> + Copy>(
    mut net: N,
    n: usize,
    place: usize,
    at: [P::Scalar; 3],
) -> N {
    // The blossom with m arguments at the new corner is the net after m steps of de Casteljau's algorithm.
    let mut steps = net;
    for m in 0..=n {
        if m > 0 {
            contract(steps.as_mut(), n - m + 1, &at);
        }
        for (position, index) in TriangleIndex::all(n).enumerate() {
            if index.components()[place] == m {
                let mut rest = index.components();
                rest[place] = 0;
                net.as_mut()[position] = steps.as_ref()[TriangleIndex::new(rest).position()];
            }
        }
    }
    net
}
