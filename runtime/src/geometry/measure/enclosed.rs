//! What closed curves in the plane enclose: area, centre of mass, moments, and how often they go round a point.
//!
//! With `ω = x dy - y dx`, twice the area of the triangle between the origin and a piece of the curve, the integral of a
//! monomial of degree `k` over what is enclosed is `1/(k + 2) ∮ xᵃ yᵇ ω`: the triangle is the union of copies of its far
//! side, scaled by `s`, of area `s ds ω`. On a piece `(X, Y)/w` it is `ω = (X Y' - Y X') / w²`, because the derivatives of
//! `w` cancel.

use alloc::vec::Vec;

use crate::CurvePiece;
use crate::bernstein;
use crate::geometry::{derivative, product};
use crate::numeric::gauss::jacobi;
#[cfg(feature = "serde")]
use crate::serialize::{Read, Written};
use crate::vector::safe_unit;
use crate::{Point, Scalar};

/// What a closed curve in the plane encloses; parts around which it runs clockwise count negative, and twice where it
/// goes round twice. A figure that is too large for the scalar type is infinite, with its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(bound(serialize = "P: Written", deserialize = "P: Read<'de>")))]
#[non_exhaustive]
pub struct Enclosed<P: Point> {
    /// The area `∬ dx dy`, positive if the curve runs anticlockwise around it.
    pub area: P::Scalar,
    /// The centre of mass `∬ (x, y) dx dy / area`; `None` if the area vanishes up to rounding errors.
    pub centroid: Option<P>,
    /// The first moments `∬ x dx dy` and `∬ y dx dy`.
    pub first_moments: [P::Scalar; 2],
    /// The second moments `∬ x² dx dy`, `∬ x y dx dy` and `∬ y² dx dy` about the origin.
    pub second_moments: [P::Scalar; 3],
}

/// The pieces, closed by straight lines: each contour, which ends where the next piece does not begin up to rounding
/// errors, from its end to its start; `epsilon` is that of the points.
#[inline]
fn closed(pieces: &[CurvePiece], epsilon: f64) -> Vec<CurvePiece> {
    let largest = pieces.iter().map(CurvePiece::largest).fold(0.0, f64::max);
    let noise = 64.0 * epsilon * largest;
    let end = |piece: &CurvePiece, i: usize| [piece.control(i, 0), piece.control(i, 1)];
    let mut all: Vec<CurvePiece> = Vec::new();
    let line = |all: &mut Vec<CurvePiece>, a: [f64; 2], b: [f64; 2]| {
        if a != b {
            let ends = alloc::vec![a[0], b[0], a[1], b[1]];
            all.push(CurvePiece::of_numerators([0.0, 1.0], 2, ends, [1.0; 2].into_iter()));
        }
    };
    let mut open: Option<([f64; 2], [f64; 2])> = None;
    for piece in pieces {
        let [first, last] = [end(piece, 0), end(piece, piece.degree())];
        let start = match open {
            Some((start, here)) if (0..2).all(|d| (here[d] - first[d]).abs() <= noise) => {
                line(&mut all, here, first);
                start
            }
            Some((start, here)) => {
                line(&mut all, here, start);
                first
            }
            None => first,
        };
        all.push(piece.clone());
        open = Some((start, last));
    }
    if let Some((start, here)) = open {
        line(&mut all, here, start);
    }
    all
}

/// Area, centroid and moments.
pub(crate) fn of<P: Point>(pieces: &[CurvePiece]) -> Enclosed<P> {
    let (sums, centroid) = integrals(pieces, P::Scalar::EPSILON.to_f64());
    let [area, x, y, xx, xy, yy] = sums.map(P::Scalar::of);
    Enclosed {
        area,
        centroid: centroid.map(|c| P::from_components(|d| P::Scalar::of(c[d.min(1)]))),
        first_moments: [x, y],
        second_moments: [xx, xy, yy],
    }
}

/// The integrals of 1, x, y, x², x y, y², and the centroid.
#[inline]
fn integrals(pieces: &[CurvePiece], epsilon: f64) -> ([f64; 6], Option<[f64; 2]>) {
    // About the middle of the curve, so that few digits cancel.
    let mut origin = [0.0; 2];
    for (d, origin) in origin.iter_mut().enumerate() {
        let of = |piece: &CurvePiece| (0..=piece.degree()).map(|i| piece.control(i, d)).collect::<Vec<_>>();
        let all: Vec<f64> = pieces.iter().flat_map(of).collect();
        let [low, high] = bernstein::bounds(&all);
        *origin = f64::midpoint(low, high);
    }
    // Products of four coordinates are formed.
    let unit = safe_unit(pieces.iter().map(CurvePiece::largest).fold(0.0, f64::max), 2);
    let mut sums = [0.0; 6];
    let mut length = 0.0;
    for piece in closed(pieces, epsilon) {
        let seen = piece.seen_from(&origin, unit);
        length += seen.length_bounds()[1];
        let part = if seen.weights().is_some() { rational(&seen) } else { polynomial(&seen) };
        for (sum, part) in sums.iter_mut().zip(part) {
            *sum += part;
        }
    }
    for (sum, factor) in sums.iter_mut().zip([2.0, 3.0, 3.0, 4.0, 4.0, 4.0]) {
        *sum /= factor;
    }
    let [area, x, y, xx, xy, yy] = sums;
    let [ox, oy] = origin.map(|c| c / unit);
    let vanishes = area.is_nan() || area.abs() <= 16.0 * f64::EPSILON * length * length;
    let centroid = (!vanishes).then(|| [ox + x / area, oy + y / area].map(|c| c * unit));
    let mut moved = [
        area,
        x + ox * area,
        y + oy * area,
        xx + 2.0 * ox * x + ox * ox * area,
        xy + ox * y + oy * x + ox * oy * area,
        yy + 2.0 * oy * y + oy * oy * area,
    ];
    for (moment, power) in moved.iter_mut().zip([2, 3, 3, 4, 4, 4]) {
        // One factor after the other: a power could be infinite where the moment is zero.
        *moment = (0..power).fold(*moment, |moment, _| moment * unit);
    }
    (moved, centroid)
}

/// `∫ ω`, `∫ x ω`, …, `∫ y² ω` over a polynomial piece: the mean of Bernstein coefficients.
#[inline]
fn polynomial(piece: &CurvePiece) -> [f64; 6] {
    let [x, y] = [piece.component(0), piece.component(1)];
    let swept = swept(piece);
    let mean = |c: &[f64]| if c.is_empty() { 0.0 } else { c.iter().sum::<f64>() / c.len() as f64 };
    let [by_x, by_y] = [product(&swept, x), product(&swept, y)];
    [
        mean(&swept),
        mean(&by_x),
        mean(&by_y),
        mean(&product(&by_x, x)),
        mean(&product(&by_x, y)),
        mean(&product(&by_y, y)),
    ]
}

/// The Bernstein coefficients of `X Y' - Y X'`.
#[inline]
fn swept(piece: &CurvePiece) -> Vec<f64> {
    let [x, y] = [piece.component(0), piece.component(1)];
    let mut swept = product(x, &derivative(y));
    for (s, p) in swept.iter_mut().zip(product(y, &derivative(x))) {
        *s -= p;
    }
    swept
}

/// The same over a rational piece, by Gauss's rule to the last digit.
///
/// A part is halved until its weights `w[i]` lie within 2.5 % of their middle. Then `w` has the form `c (1 + e)` with
/// `|e| <= 1/40` on the interval, and by the inequality of Bernstein and Walsh `|e| <= ρ^m / 40` on the ellipse of the
/// parameter `ρ`, with the degree `m`: for `ρ^m = 10` at most 1/4, so that the integrand is analytic inside of it and at
/// most about `ρ^q` times its size on the interval, `q` the degree of its numerator. The error of the rule with `n` nodes
/// is some `ρ^(q - 2n)`, `10^-17` for `n = (17 m + q) / 2`.
#[inline]
fn rational(piece: &CurvePiece) -> [f64; 6] {
    let degree = piece.degree();
    // The numerators of the second moments have the degree q = 4 m - 1.
    let rule = jacobi(21 * degree / 2 + 1, 0);
    let mut sums = [0.0; 6];
    let mut open = alloc::vec![(piece.clone(), 0)];
    while let Some((part, depth)) = open.pop() {
        let weights = part.weights().unwrap_or_default();
        let [low, high] = bernstein::bounds(weights);
        if high > 1.05 * low && depth < 60 {
            open.extend(part.split(0.5).map(|half| (half, depth + 1)));
            continue;
        }
        let swept = swept(&part);
        for &[at, factor] in &rule {
            let w = bernstein::eval(weights, at);
            let [x, y] = [0, 1].map(|d| bernstein::eval(part.component(d), at) / w);
            let swept = factor * bernstein::eval(&swept, at) / (w * w);
            for (sum, monomial) in sums.iter_mut().zip([1.0, x, y, x * x, x * y, y * y]) {
                *sum += swept * monomial;
            }
        }
    }
    sums
}

/// How often the curve, closed by straight lines, goes round the point, anticlockwise; `None` if the point lies on it up
/// to rounding errors, or anything is not finite. `epsilon` is that of the points.
///
/// Crossings of the ray from the point to the right are counted: a part whose control points lie right of the point
/// crosses it as its ends do, and one that lies left, above or below does not. All by more than the rounding errors of a
/// point of the curve, so that no part next to the point is on either side.
#[inline]
pub(crate) fn winding(pieces: &[CurvePiece], point: &[f64], epsilon: f64) -> Option<i32> {
    if !pieces.iter().all(CurvePiece::is_finite) || !point.iter().all(|c| c.is_finite()) {
        return None;
    }
    let mut count = 0;
    for piece in closed(pieces, epsilon) {
        let noise = 8.0 * epsilon * (piece.degree() + 2) as f64 * piece.largest();
        let mut open = alloc::vec![piece.seen_from(point, 1.0)];
        while let Some(part) = open.pop() {
            let side = |d: usize| -> Vec<f64> { (0..=part.degree()).map(|i| part.control(i, d)).collect() };
            let [xs, ys] = [side(0), side(1)];
            let [[left, right], [low, high]] = [bernstein::bounds(&xs), bernstein::bounds(&ys)];
            if left > noise {
                let below = |y: Option<&f64>| y.is_some_and(|&y| y < 0.0);
                count += i32::from(below(ys.first())) - i32::from(below(ys.last()));
            } else if right >= -noise && low <= noise && high >= -noise {
                if (right - left).max(high - low) <= noise {
                    return None;
                }
                open.extend(part.split(0.5));
            }
        }
    }
    Some(count)
}
