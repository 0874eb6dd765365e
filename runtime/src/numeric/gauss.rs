//! Gauss–Jacobi rules on the unit interval, in double precision.

use alloc::vec::Vec;

use crate::Scalar;

/// The nodes `0 < x < 1` and weights of the rule with `count` nodes for the weight `(1 - x)^power`, in increasing order:
/// `Σ w f(x)` is the integral of `(1 - x)^power f(x)` over `0 <= x <= 1` for polynomials of degree up to
/// `2 count - 1`.
///
/// The nodes are the eigenvalues of the tridiagonal matrix of the recurrence of Jacobi's polynomials, isolated by signs
/// of Sturm's sequence; the weights are `μ / Σ p_k(x)²` over the orthonormal polynomials, so that they are positive (G.
/// H. Golub, J. H. Welsch, "Calculation of Gauss quadrature rules", Mathematics of Computation 23, 1969).
#[inline]
pub(crate) fn jacobi(count: usize, power: usize) -> Vec<[f64; 2]> {
    let alpha = power as f64;
    // x p_k = √b[k+1] p_(k+1) + a[k] p_k + √b[k] p_(k-1) on -1 <= x <= 1, with the weight (1 - x)^α.
    let recurrence: Vec<[f64; 2]> = (0..count)
        .map(|k| {
            let k = k as f64;
            let middle = 2.0 * k + alpha;
            let a = if power == 0 { 0.0 } else { -alpha * alpha / (middle * (middle + 2.0)) };
            let side = 2.0 * k * (k + alpha) / middle;
            let b = if k == 0.0 { 0.0 } else { side * side / (middle * middle - 1.0) };
            [a, b]
        })
        .collect();
    let total = 1.0 / (alpha + 1.0);
    let rule = |x: f64| {
        let (mut before, mut current, mut sum) = (0.0, 1.0, 1.0);
        for pair in recurrence.windows(2) {
            let [[a, b], [_, next]] = [pair[0], pair[1]];
            let following = ((x - a) * current - Scalar::sqrt(b) * before) / Scalar::sqrt(next);
            (before, current) = (current, following);
            sum += current * current;
        }
        [f64::midpoint(1.0, x), total / sum]
    };
    if power > 0 {
        return (0..count).map(|i| rule(eigenvalue(&recurrence, i))).collect();
    }
    // Legendre's polynomials are even or odd, and so is the rule.
    let mut found: Vec<[f64; 2]> = (0..count / 2).map(|i| rule(eigenvalue(&recurrence, i))).collect();
    let mirrored: Vec<[f64; 2]> = found.iter().rev().map(|&[x, w]| [1.0 - x, w]).collect();
    found.extend((count % 2 == 1).then(|| rule(0.0)));
    found.extend(mirrored);
    found
}

/// The eigenvalue of that place in increasing order, by bisection of `-1 <= x <= 1` down to neighbouring numbers.
#[inline]
fn eigenvalue(recurrence: &[[f64; 2]], place: usize) -> f64 {
    let below = |x: f64| {
        let mut pivot = 1.0_f64;
        let mut count = 0;
        for &[a, b] in recurrence {
            pivot = a - x - b / pivot;
            if pivot == 0.0 {
                pivot = -f64::MIN_POSITIVE;
            }
            count += usize::from(pivot < 0.0);
        }
        count
    };
    let [mut low, mut high] = [-1.0, 1.0];
    loop {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high || high - low < 1e-17 {
            return middle;
        }
        if below(middle) <= place {
            low = middle;
        } else {
            high = middle;
        }
    }
}
