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

/// The row `n` of Pascal's triangle, from its start; zeros after its end.
#[cfg(feature = "alloc")]
pub(crate) struct Row {
    degree: usize,
    index: usize,
    value: f64,
}

#[cfg(feature = "alloc")]
impl Row {
    #[inline]
    pub(crate) fn new(degree: usize) -> Self {
        Self { degree, index: 0, value: 1.0 }
    }

    #[inline]
    pub(crate) fn next(&mut self) -> f64 {
        let value = self.value;
        self.value = value * (self.degree - self.index.min(self.degree)) as f64 / (self.index + 1) as f64;
        self.index += 1;
        value
    }
}

/// The number of ways to choose `k` of `n`.
#[inline]
pub(crate) fn binomial<S: Scalar>(n: usize, k: usize) -> S {
    (0..k).fold(S::ONE, |value, i| value * S::from_usize(n - i) / S::from_usize(i + 1))
}
