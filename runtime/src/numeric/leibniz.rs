//! Derivatives of products and quotients, by Leibniz' rule.

use alloc::vec::Vec;

use super::binomial::binomial;
use crate::{Point, Scalar};

/// The derivatives of `f C` from those of a function of points and of a factor, as many as there are of both.
pub(crate) fn product<P: Point>(derivatives: &[P], factor: &[P::Scalar]) -> Vec<P> {
    let of = |k: usize| {
        (0..=k).fold(P::zero(), |sum, i| {
            sum.add_weighted(derivatives[k - i], binomial::<P::Scalar>(k, i) * factor[i])
        })
    };
    (0..derivatives.len().min(factor.len())).map(of).collect()
}

/// The derivatives of `a / b`, as many as there are of both; NaN or infinite where `b` vanishes.
pub(crate) fn quotient<S: Scalar>(numerator: &[S], denominator: &[S]) -> Vec<S> {
    let mut quotient: Vec<S> = Vec::with_capacity(numerator.len());
    for (k, &value) in numerator.iter().enumerate().take(denominator.len()) {
        let known = quotient.iter().enumerate();
        let rest = known.fold(value, |rest, (i, &q)| rest - binomial::<S>(k, i) * q * denominator[k - i]);
        quotient.push(rest / denominator[0]);
    }
    quotient
}
