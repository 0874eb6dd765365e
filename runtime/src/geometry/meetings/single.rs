//! A test that two parts meet at most once, with the place, and one that a curve does not come back.

use alloc::vec;
use alloc::vec::Vec;

use super::beside::{dot, pseudo_inverse, state};
use crate::geometry::{derivative, product};
use crate::{CurvePiece, Scalar};

/// Two parts that may meet; of one curve the first one comes before the second one.
pub(super) struct Pair {
    pub(super) first: CurvePiece,
    pub(super) second: CurvePiece,
}

/// What is known of parts that meet at most once.
pub(super) enum Single {
    /// They do not meet.
    None,
    /// They meet at these parameters of the curves.
    At([f64; 2]),
}

/// Whether the parts meet, or come as near to each other as a distance, if they meet at most once.
#[inline]
pub(super) fn at_most_one(pair: &Pair, distance: f64) -> Option<Single> {
    let Pair { first, second } = pair;
    let dim = first.dimension();
    let (value, columns) = state(first, second, [0.5; 2]);
    let inverse = pseudo_inverse(&columns)?;
    let step: Vec<f64> = inverse.iter().map(|row| -dot(row, &value)).collect();
    // |M F' - 1| by rows, from the control points of both derivatives.
    let mut sums = [0.0_f64; 2];
    for (column, vectors) in derivatives(first, second).into_iter().enumerate() {
        for (r, row) in inverse.iter().enumerate() {
            let one = if r == column { 1.0 } else { 0.0 };
            sums[r] += vectors.iter().map(|v| (dot(row, v) - one).abs()).fold(0.0, f64::max);
        }
    }
    let q = sums[0].max(sums[1]);
    if q.is_nan() || q >= 0.9 {
        return None;
    }
    let margin = 1e-10;
    let reach = |k: usize| distance * Scalar::sqrt(dot(&inverse[k], &inverse[k]));
    let possible = (0..2).all(|k| (step[k]).abs() <= 0.5 + 0.5 * q + reach(k) + margin);
    if !possible {
        return Some(Single::None);
    }
    let mut at = [0.5 + step[0], 0.5 + step[1]];
    for _ in 0..12 {
        let (value, columns) = state(first, second, at);
        let inverse = pseudo_inverse(&columns)?;
        let step = [0, 1].map(|r| -dot(&inverse[r], &value));
        at = [at[0] + step[0], at[1] + step[1]];
        if !(at[0].abs() < 4.0 && at[1].abs() < 4.0) {
            return None;
        }
        if step[0].abs().max(step[1].abs()) < 1e-15 {
            break;
        }
    }
    let (value, _) = state(first, second, at);
    let noise = 64.0 * f64::EPSILON * (first.degree() + second.degree() + dim) as f64;
    if dot(&value, &value) > noise * noise || !at.iter().all(|&x| x >= -margin && x <= 1.0 + margin) {
        return None;
    }
    let at = at.map(|x| x.clamp(0.0, 1.0));
    Some(Single::At([first.parameter(at[0]), second.parameter(at[1])]))
}

/// The control vectors of the derivatives of `F` in `x` and in `y` over both parts.
#[inline]
fn derivatives(first: &CurvePiece, second: &CurvePiece) -> [Vec<Vec<f64>>; 2] {
    let dim = first.dimension();
    let one = |part: &CurvePiece| vec![1.0; part.degree() + 1];
    let weights = [first, second].map(|part| part.weights().map_or_else(|| one(part), <[f64]>::to_vec));
    let slopes = [0, 1].map(|k| derivative(&weights[k]));
    let rational = first.weights().is_some() || second.weights().is_some();
    let combine = |inner: &dyn Fn(usize, usize, usize) -> f64, sizes: [usize; 2]| -> Vec<Vec<f64>> {
        let pairs = (0..sizes[0]).flat_map(|i| (0..sizes[1]).map(move |j| (i, j)));
        pairs.map(|(i, j)| (0..dim).map(|d| inner(d, i, j)).collect()).collect()
    };
    let a: Vec<[Vec<f64>; 2]> =
        (0..dim).map(|d| [first.component(d).to_vec(), derivative(first.component(d))]).collect();
    let b: Vec<[Vec<f64>; 2]> =
        (0..dim).map(|d| [second.component(d).to_vec(), derivative(second.component(d))]).collect();
    let [m, n] = [first.degree(), second.degree()];
    if !rational {
        return [combine(&|d, i, _| a[d][1][i], [m, 1]), combine(&|d, _, j| -b[d][1][j], [1, n])];
    }
    [
        combine(&|d, i, j| a[d][1][i] * weights[1][j] - b[d][0][j] * slopes[0][i], [m, n + 1]),
        combine(&|d, i, j| a[d][0][i] * slopes[1][j] - b[d][1][j] * weights[0][i], [m + 1, n]),
    ]
}

/// The coefficients of each component of a curve in the direction of the velocity: the derivative, of a rational part
/// its numerator.
#[inline]
pub(super) fn velocity_lists(part: &CurvePiece) -> Vec<Vec<f64>> {
    (0..part.dimension())
        .map(|d| match part.weights() {
            None => derivative(part.component(d)),
            Some(weights) => {
                let mut slope = product(&derivative(part.component(d)), weights);
                for (s, p) in slope.iter_mut().zip(product(part.component(d), &derivative(weights))) {
                    *s -= p;
                }
                slope
            }
        })
        .collect()
}

/// The control vectors of a curve in the direction of the velocity.
#[inline]
fn velocities(part: &CurvePiece) -> Vec<Vec<f64>> {
    let lists = velocity_lists(part);
    let count = lists.first().map_or(0, Vec::len);
    (0..count).map(|i| lists.iter().map(|list| list[i]).collect()).collect()
}

/// Whether consecutive parts go on in one direction, from the control vectors of their derivatives: such a curve does not
/// come back.
#[inline]
pub(super) fn is_forward(parts: &[CurvePiece]) -> bool {
    let all: Vec<Vec<f64>> = parts.iter().flat_map(velocities).collect();
    let dim = all.first().map_or(0, Vec::len);
    let axis: Vec<f64> = (0..dim).map(|d| all.iter().map(|v| v[d]).sum()).collect();
    all.iter().all(|v| dot(v, &axis) > 0.0)
}
