//! The endpoint form: a chord and a centred correction, for low degree.

use super::slices::{EndpointDerivatives, EndpointPoints};
use crate::basis::combination;
use crate::numeric::simd::dispatch;
use crate::vector::difference;
use crate::{Form, Point, Scalar};

/// The curve of degree `R + 1`
///
/// ```text
/// C(x) = s E0 + x E1 + s x (R0 + R1 y + R2 y² + …),   s = 1 - x,   y = x - s
/// ```
///
/// with the ends `E0`, `E1` and `R` inner coefficients. `y` runs from -1 to 1, which keeps the inner coefficients and
/// their cancellation small, and the factor `s x` damps what is left of it: up to degree 12 the rounding error stays
/// below 4 ε times the largest Bézier control point. A constant curve has `E0 = E1` and `R = 0`.
///
/// ```
/// use basis_runtime::{EndpointForm, Form};
///
/// // The parabola through 0, 5 and 4: C(1/2) = (0 + 4)/2 + 12/4.
/// let parabola = EndpointForm::new([0.0, 4.0], [12.0]);
/// assert_eq!(parabola.eval(0.5), 5.0);
/// assert_eq!(parabola.eval_with_derivs(0.0), [0.0, 16.0, -24.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndpointForm<P, const R: usize> {
    ends: [P; 2],
    inner: [P; R],
}

impl<P: Point, const R: usize> EndpointForm<P, R> {
    /// The curve with the ends `[E0, E1]` and the inner coefficients `[R0, R1, …]`.
    #[inline]
    pub fn new(ends: [P; 2], inner: [P; R]) -> Self {
        Self { ends, inner }
    }

    /// The ends `[E0, E1]`.
    #[inline]
    pub fn ends(&self) -> &[P; 2] {
        &self.ends
    }

    /// The inner coefficients `[R0, R1, …]`.
    #[inline]
    pub fn inner(&self) -> &[P; R] {
        &self.inner
    }
}

impl<P: Point, const R: usize> Form<P> for EndpointForm<P, R> {
    const DEGREE: usize = R + 1;

    #[inline]
    fn eval(&self, x: P::Scalar) -> P {
        let s = P::Scalar::ONE - x;
        let y = x - s;
        let chord = self.ends[0].scale(s).add_weighted(self.ends[1], x);
        match self.inner.split_last() {
            None => chord,
            Some((&last, rest)) => {
                let inner =
                    rest.iter().rev().fold(last, |sum, &coefficient| coefficient.add_weighted(sum, y));
                chord.add_weighted(inner, s * x)
            }
        }
    }

    /// With `Tj = R⁽ʲ⁾(y) / j!` from the Taylor–Horner scheme and Leibniz' rule for the product with `w = s x`, whose
    /// derivatives are `-y` and `-2`, while `y' = 2`:
    ///
    /// ```text
    /// C⁽ᵏ⁾(x) = (4 w Tk - 2 y Tk₋₁ - Tk₋₂) · 2ᵏ⁻² k!,   and for k = 1 in addition E1 - E0
    /// ```
    // A result in memory costs more to hand over than to compute.
    #[allow(clippy::inline_always)]
    #[inline(always)]
    fn eval_with_derivs<const K: usize>(&self, x: P::Scalar) -> [P; K] {
        let mut derivatives = [P::zero(); K];
        if K == 0 {
            return derivatives;
        }
        derivatives[0] = self.eval(x);

        let (two, four) = (P::Scalar::of(2.0), P::Scalar::of(4.0));
        let s = P::Scalar::ONE - x;
        let y = x - s;
        let mut taylor = [P::zero(); K];
        for (step, &coefficient) in self.inner.iter().rev().enumerate() {
            // The higher ones are zero so far.
            for j in (1..K.min(step + 1)).rev() {
                taylor[j] = if j < step { taylor[j - 1].add_weighted(taylor[j], y) } else { taylor[j - 1] };
            }
            taylor[0] = if step > 0 { coefficient.add_weighted(taylor[0], y) } else { coefficient };
        }

        let chord = difference(self.ends[1], self.ends[0]);
        let mut factor = P::Scalar::of(0.25); // 2ᵏ⁻² k!
        for k in 1..K.min(R + 2) {
            factor = factor * two * P::Scalar::from_usize(k);
            let mut sum = if k == 1 { chord } else { taylor[k - 2].scale(-factor) };
            if k - 1 < R {
                sum = sum.add_weighted(taylor[k - 1], -(two * factor) * y);
            }
            if k < R {
                sum = sum.add_weighted(taylor[k], (four * factor) * (s * x));
            }
            derivatives[k] = sum;
        }
        derivatives
    }

    #[inline]
    fn eval_into(&self, xs: &[P::Scalar], out: &mut [P]) {
        dispatch(xs.len(), EndpointPoints::<P, _, 0> { ends: self.ends, inner: self.inner, xs, out });
    }

    fn eval_with_derivs_into<const K: usize>(&self, xs: &[P::Scalar], rate: P::Scalar, out: [&mut [P]; K]) {
        let Self { ends, inner } = *self;
        dispatch(xs.len(), EndpointDerivatives::<P, _, 0, K> { ends, inner, rate, xs, out });
    }

    #[inline]
    fn combination(terms: impl Iterator<Item = (Self, P::Scalar)> + Clone) -> Self {
        Self {
            ends: [0, 1].map(|k| combination(terms.clone().map(|(form, weight)| (form.ends[k], weight)))),
            inner: core::array::from_fn(|k| {
                combination(terms.clone().map(|(form, weight)| (form.inner[k], weight)))
            }),
        }
    }

    #[inline]
    fn start(&self) -> P {
        self.ends[0]
    }

    #[inline]
    fn end(&self) -> P {
        self.ends[1]
    }
}
