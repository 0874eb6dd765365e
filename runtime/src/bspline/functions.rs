//! The basis functions of a knot vector: the `k + 1` of them that do not vanish on a span, and their derivatives.
//!
//! Source: C. de Boor, *On calculating with B-splines*, Journal of Approximation Theory 6 (1972).

use super::buffer::Buffer;
use super::{KnotError, KnotVector};
use crate::{Point, Scalar};

impl<S: Scalar> KnotVector<S> {
    /// The first nonvanishing basis function at `t`, and the values of it and the `k` functions after it.
    ///
    /// They sum to 1 and inside of the domain none is negative. With the span `[t[μ], t[μ+1])` that contains `t` they
    /// are the functions `μ - k, …, μ`:
    ///
    /// ```text
    /// N[i,0](t) = 1 on the span t[i] <= t < t[i+1], 0 elsewhere
    /// N[i,k](t) = (t - t[i]) / (t[i+k] - t[i]) N[i,k-1](t) + (t[i+k+1] - t) / (t[i+k+1] - t[i+1]) N[i+1,k-1](t)
    /// ```
    ///
    /// # Errors
    /// [`KnotError::Outside`] if `t` is outside of the domain or NaN.
    pub fn values(&self, t: S) -> Result<(usize, alloc::vec::Vec<S>), KnotError> {
        let span = self.span(self.check(t)?);
        Ok((span - self.degree(), self.values_on(span, t).to_vec()))
    }

    /// The first nonvanishing basis function at `t`, and the derivatives of that order of it and the `k` functions
    /// after it.
    ///
    /// ```text
    /// N[i,k]' = k / (t[i+k] - t[i]) N[i,k-1] - k / (t[i+k+1] - t[i+1]) N[i+1,k-1]
    /// ```
    ///
    /// At a knot they are those of the span on its right, at the upper end of the domain those of the last span.
    ///
    /// # Errors
    /// [`KnotError::Outside`] if `t` is outside of the domain or NaN.
    pub fn derivatives(&self, t: S, order: usize) -> Result<(usize, alloc::vec::Vec<S>), KnotError> {
        let span = self.span(self.check(t)?);
        Ok((span - self.degree(), self.derivatives_on(span, t, order).to_vec()))
    }

    /// The values of the functions `span - k, …, span` as polynomials of that span, at any `t`.
    #[inline]
    pub(super) fn values_on(&self, span: usize, t: S) -> Buffer<S> {
        let mut values = Buffer::filled(S::ZERO, self.degree() + 1);
        // A constant length lets the compiler unroll both loops of `raise_values`.
        match self.degree() {
            1 => self.fill_values::<1>(span, t, &mut values),
            2 => self.fill_values::<2>(span, t, &mut values),
            3 => values.copy_from_slice(&self.cubic_values_on(span, t)),
            _ => self.raise_values(span, t, self.degree(), &mut values),
        }
        values
    }

    /// The same for `N = k + 1` functions.
    #[inline]
    pub(super) fn values_of<const N: usize>(&self, span: usize, t: S) -> [S; N] {
        let mut values = [S::ZERO; N];
        if N == 4 {
            values.copy_from_slice(&self.cubic_values_on(span, t));
        } else {
            self.raise_values(span, t, N - 1, &mut values);
        }
        values
    }

    /// The same at degree 3, the one that matters most, without loops or memory.
    #[inline]
    pub(super) fn cubic_values_on(&self, span: usize, t: S) -> [S; 4] {
        self.cubic_on(span, t)[0]
    }

    /// The values and first derivatives at degree 3.
    #[inline]
    pub(super) fn cubic_on(&self, span: usize, t: S) -> [[S; 4]; 2] {
        let &[a, b, c, d, e, f] = &self.as_slice()[span - 2..span + 4] else { return [[S::ZERO; 4]; 2] };
        // In one list, so that the compiler divides two or four at a time.
        let (from, to) = ([c, b, c, a, b, c], [d, d, e, d, e, f]);
        let [r, s0, s1, q0, q1, q2] = core::array::from_fn(|k| (t - from[k]) / (to[k] - from[k]));
        let (one, three) = (S::ONE, S::from_usize(3));
        let v = [(one - s0) * (one - r), s0 * (one - r) + (one - s1) * r, s1 * r];
        let w = [v[0] / (d - a), v[1] / (e - b), v[2] / (f - c)];
        [
            [(one - q0) * v[0], q0 * v[0] + (one - q1) * v[1], q1 * v[1] + (one - q2) * v[2], q2 * v[2]],
            [S::ZERO - w[0], w[0] - w[1], w[1] - w[2], w[2]].map(|slope| three * slope),
        ]
    }

    #[inline]
    fn fill_values<const K: usize>(&self, span: usize, t: S, values: &mut [S]) {
        self.raise_values(span, t, K, values);
    }

    /// The values of the functions of degree `degree`, at most that of the knot vector, into the front of `values`.
    #[inline(always)]
    #[allow(clippy::inline_always)] // only then does a constant degree unroll it
    fn raise_values(&self, span: usize, t: S, degree: usize, values: &mut [S]) {
        // knots[degree - 1] = t[span] and knots[degree] = t[span + 1]; the others are around them.
        let knots = &self.as_slice()[span + 1 - degree.max(1)..=span + degree.max(1)];
        let values = &mut values[..=degree];
        values[0] = S::ONE;
        for d in 1..=degree {
            let mut carried = S::ZERO;
            for j in 0..d {
                // The function of degree d - 1 with the index span - d + 1 + j lives on [lo, hi].
                let (lo, hi) = (knots[degree - d + j], knots[degree + j]);
                // A ratio, so that it is exactly 1 at hi and both ends of a clamped curve are exact.
                let right = (t - lo) / (hi - lo);
                let value = values[j];
                values[j] = carried + (S::ONE - right) * value;
                carried = right * value;
            }
            values[d] = carried;
        }
    }

    /// The derivatives of that order of the functions `span - k, …, span`, as polynomials of that span; zero above the
    /// degree.
    #[inline]
    pub(super) fn derivatives_on(&self, span: usize, t: S, order: usize) -> Buffer<S> {
        if order == 0 {
            return self.values_on(span, t);
        }
        let k = self.degree();
        let mut values = Buffer::filled(S::ZERO, k + 1);
        if order > k {
            return values;
        }
        self.raise_values(span, t, k - order, &mut values);
        let knots = self.as_slice();
        for d in k - order + 1..=k {
            for j in (0..=d).rev() {
                let i = span - d + j;
                let left = if j > 0 { values[j - 1] / (knots[i + d] - knots[i]) } else { S::ZERO };
                let right = if j < d { values[j] / (knots[i + d + 1] - knots[i + 1]) } else { S::ZERO };
                values[j] = S::from_usize(d) * (left - right);
            }
        }
        values
    }
}

/// `Σ factors[i] points[i]`.
#[inline]
pub(super) fn combine<P: Point>(factors: &[P::Scalar], points: &[P]) -> P {
    let sum = |sum: P, (&factor, &point): (&P::Scalar, &P)| sum.add_weighted(point, factor);
    factors.iter().zip(points).fold(P::zero(), sum)
}
