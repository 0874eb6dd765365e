//! Derivatives of quotients by power series: no rule for quotients is applied more than once.

use super::Chart;
use crate::vector::difference;
use crate::{Point, Scalar, bernstein};

/// Room for the power series of a curve, as many terms each as there are derivatives.
pub(crate) struct Room<'a, P: Point> {
    /// The curve.
    pub(crate) curve: &'a mut [P],
    /// The denominator.
    pub(crate) weight: &'a mut [P::Scalar],
    /// The map to the unit interval.
    pub(crate) map: &'a mut [P::Scalar],
}

/// On which side of 0 a denominator lies that has no zeros. Where its Bernstein coefficients have both signs, rounding
/// may take it to 0 or beyond, and what is divided by it then would have the wrong sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Side {
    /// The coefficients have one sign, and so have the floats.
    Kept,
    /// It is positive.
    Above,
    /// It is negative.
    Below,
}

impl Side {
    /// Of the Bernstein coefficients of a denominator: the first and the last one are its values at the ends.
    pub(crate) fn of<S: Scalar>(coefficients: &[S]) -> Self {
        let any = |is: fn(S) -> bool| coefficients.iter().any(|c| is(*c));
        if !(any(|c| c < S::ZERO) && any(|c| c > S::ZERO)) {
            return Self::Kept;
        }
        let [Some(first), Some(last)] = [coefficients.first(), coefficients.last()] else {
            return Self::Kept;
        };
        let end = if *first == S::ZERO { *last } else { *first };
        if end < S::ZERO { Self::Below } else { Self::Above }
    }

    /// The denominator, or 0 where it is on the other side; NaN stays NaN.
    #[inline]
    pub(crate) fn keep<S: Scalar>(self, weight: S) -> S {
        match self {
            Self::Above if weight < S::ZERO => S::ZERO,
            Self::Below if weight > S::ZERO => S::ZERO,
            _ => weight,
        }
    }
}

/// The value and derivatives in `t` of `N(x) / W(x)`, as many as there is room for, from the Bernstein coefficients of
/// `N` and `W`, which are overwritten.
///
/// They are taken by the [balanced](Chart::balanced) place `x`. From `N = W C` the Taylor coefficients of `C` in `x`
/// follow one after the other, `c[k] = (n[k] - Σ w[i] c[k - i]) / w[0]`, the sum over `i = 1, …, k`; Horner's scheme
/// puts the series of `x` in `t` into that of `C`.
pub(crate) fn derivatives<P: Point>(
    numerator: &mut [P],
    denominator: &mut [P::Scalar],
    chart: &Chart<P::Scalar>,
    t: P::Scalar,
    room: Room<'_, P>,
    out: &mut [P],
) {
    let Room { curve, weight, map } = room;
    let side = Side::of(denominator);
    let balance = chart.balance();
    if balance != P::Scalar::ONE {
        let mut power = P::Scalar::ONE;
        for (point, weight) in numerator.iter_mut().zip(&mut *denominator) {
            *point = point.scale(power);
            *weight = *weight * power;
            power = power * balance;
        }
    }
    let x = chart.balanced(t);
    taylor(numerator, x, curve);
    taylor(denominator, x, weight);
    if let Some(weight) = weight.first_mut() {
        *weight = side.keep(*weight);
    }
    for k in 0..curve.len() {
        let mut rest = curve[k];
        for i in 1..=k {
            rest = rest.add_weighted(curve[k - i], -weight[i]);
        }
        curve[k] = P::from_components(|d| rest.component(d) / weight[0]);
    }
    chart.expansion(t, map);
    let count = out.len();
    out.fill(P::zero());
    for k in (0..count).rev() {
        // out := out · map + curve[k]; map begins with a term in h.
        for i in (0..count).rev() {
            let mut sum = P::zero();
            for j in 0..i {
                sum = sum.add_weighted(out[j], map[i - j]);
            }
            out[i] = sum;
        }
        out[0] = curve[k];
    }
    let mut factorial = P::Scalar::ONE;
    for (k, out) in out.iter_mut().enumerate().skip(1) {
        factorial = factorial * P::Scalar::from_usize(k);
        *out = out.scale(factorial);
    }
}

/// The Taylor coefficients at `x`, as many as `out` has places: `binomial(n, k)` times the Bernstein form of degree
/// `n - k` over the k-th differences. Overwrites the coefficients.
fn taylor<P: Point>(coefficients: &mut [P], x: P::Scalar, out: &mut [P]) {
    let degree = coefficients.len().saturating_sub(1);
    let mut binomial = P::Scalar::ONE;
    for (k, out) in out.iter_mut().enumerate() {
        if k > degree {
            *out = P::zero();
            continue;
        }
        let len = degree + 1 - k;
        *out = bernstein::eval(&coefficients[..len], x).scale(binomial);
        for i in 1..len {
            coefficients[i - 1] = difference(coefficients[i], coefficients[i - 1]);
        }
        binomial = binomial * P::Scalar::from_usize(degree - k) / P::Scalar::from_usize(k + 1);
    }
}

/// The derivative of that order in `t`, as [`derivatives`] has it.
#[cfg(feature = "alloc")]
pub(crate) fn derivative<P: Point>(
    numerator: &mut [P],
    denominator: &mut [P::Scalar],
    chart: &Chart<P::Scalar>,
    t: P::Scalar,
    order: usize,
) -> P {
    let mut out = alloc::vec![P::zero(); order + 1];
    derivatives_into(numerator, denominator, chart, t, &mut out);
    out[order]
}

/// [`derivatives`] with room of its own.
#[cfg(feature = "alloc")]
pub(crate) fn derivatives_into<P: Point>(
    numerator: &mut [P],
    denominator: &mut [P::Scalar],
    chart: &Chart<P::Scalar>,
    t: P::Scalar,
    out: &mut [P],
) {
    let mut curve = alloc::vec![P::zero(); out.len()];
    let mut weight = alloc::vec![P::Scalar::ZERO; out.len()];
    let mut map = weight.clone();
    let room = Room { curve: &mut curve, weight: &mut weight, map: &mut map };
    derivatives(numerator, denominator, chart, t, room, out);
}
