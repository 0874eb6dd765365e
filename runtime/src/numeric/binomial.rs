//! Binomial coefficients, exact as `f64` up to the row 57 of Pascal's triangle at least.

use crate::Scalar;

/// The row `N - 1` of Pascal's triangle.
pub(crate) const fn binomials<const N: usize>() -> [f64; N] {
    let mut row = [1.0; N];
    let mut n = 2;
    while n < N {
        let mut k = n - 1;
        while k > 0 {
            row[k] += row[k - 1];
            k -= 1;
        }
        n += 1;
    }
    row
}

/// `binomial(n, k + 1)` from `binomial(n, k)`.
#[inline]
pub(crate) fn after(binomial: f64, n: usize, k: usize) -> f64 {
    binomial * (n - k) as f64 / (k + 1) as f64
}

/// The row `n` of Pascal's triangle, `binomial(n, 0)` to `binomial(n, n)`.
#[inline]
pub(crate) fn row(n: usize) -> impl Iterator<Item = f64> {
    (0..=n).scan(1.0, move |next, k| {
        let binomial = *next;
        *next = after(binomial, n, k);
        Some(binomial)
    })
}

/// The number of ways to choose `k` of `n`.
#[inline]
pub(crate) fn binomial<S: Scalar>(n: usize, k: usize) -> S {
    (0..k).fold(S::ONE, |value, i| value * S::from_usize(n - i) / S::from_usize(i + 1))
}
