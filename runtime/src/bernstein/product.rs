//! Products, and the bounds that coefficients give.

use crate::numeric::binomial::after;
use crate::{Point, Scalar, vector};

/// The product `p q`, of degree `m + n`:
/// `r[k] = Σ_{i+j=k} binomial(m, i) binomial(n, j) / binomial(m+n, k) p[i] q[j]`.
///
/// ```
/// use basis_runtime::bernstein;
///
/// let mut product = [0.0; 3];
/// bernstein::multiply(&[0.0, 1.0], &[1.0, 0.0], &mut product); // x (1 - x)
/// assert_eq!(product, [0.0, 0.5, 0.0]);
/// ```
///
/// # Panics
/// If `product.len() + 1 != p.len() + q.len()`, unless one factor is empty: then `product` becomes zero.
pub fn multiply<S: Scalar>(p: &[S], q: &[S], product: &mut [S]) {
    bilinear(p, q, product, |a, b| a * b);
}

/// The scalar product `p · q` of two curves, of degree `m + n`; the formula of [`multiply`].
///
/// # Panics
/// If `product.len() + 1 != p.len() + q.len()`, unless one factor is empty: then `product` becomes zero.
pub fn dot<P: Point>(p: &[P], q: &[P], product: &mut [P::Scalar]) {
    bilinear(p, q, product, vector::dot);
}

/// The Bernstein form of a product of two polynomials, for any bilinear product of their coefficients.
pub(crate) fn bilinear<P: Point, R: Point<Scalar = P::Scalar>>(
    p: &[P],
    q: &[P],
    product: &mut [R],
    of: impl Fn(P, P) -> R,
) {
    product.fill(R::zero());
    if p.is_empty() || q.is_empty() {
        return;
    }
    let (m, n) = (p.len() - 1, q.len() - 1);
    assert_eq!(product.len(), m + n + 1, "the degree of a product is the sum of the degrees");
    let (mut row, mut total) = (1.0, 1.0);
    for (k, entry) in product.iter_mut().enumerate() {
        // binomial(m, i) binomial(n, k - i), from the first i to the last.
        let first = k.saturating_sub(n);
        let mut weight = row;
        for (i, &a) in p.iter().enumerate().take(k + 1).skip(first) {
            let j = k - i;
            *entry = entry.add_weighted(of(a, q[j]), P::Scalar::of(weight / total));
            weight = weight * ((m - i) * j) as f64 / ((i + 1) * (n - j + 1)) as f64;
        }
        total = after(total, m + n, k);
        // The weight of the first i of the next row: binomial(n, k + 1), later binomial(m, k + 1 - n).
        row = if k < n { after(row, n, k) } else { row * (m + n - k) as f64 / (k + 1 - n) as f64 };
    }
}

/// The smallest and the largest coefficient: `min <= p(x) <= max` for `0 <= x <= 1`.
///
/// Both bounds are values of the polynomial where they stand at an end of the slice. `[0, 0]` for the empty slice;
/// `[NaN, NaN]` if a coefficient is NaN.
#[inline]
pub fn bounds<S: Scalar>(coefficients: &[S]) -> [S; 2] {
    let Some((&first, rest)) = coefficients.split_first() else { return [S::ZERO; 2] };
    rest.iter().fold([first; 2], |[min, max], &c| {
        if c.is_nan() || min.is_nan() {
            return [S::NAN; 2];
        }
        [if c < min { c } else { min }, if c > max { c } else { max }]
    })
}
