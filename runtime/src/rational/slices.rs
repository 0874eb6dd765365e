//! Curves over rational families at many parameters: loops that the compiler turns into vector instructions.

// All of it is compiled once for each set of vector instructions, inside of the functions that name them.
#![allow(clippy::inline_always)]

use super::{RationalBasis, RationalCurve};
use crate::form::MOST_COMPONENTS;
use crate::numeric::simd::Kernel;
use crate::{Point, Scalar};

/// The number of parameters that are carried through all steps together.
pub(crate) const TILE: usize = 64;

/// `out[i] = C(ts[i])`, both of the same length; for points of up to [`MOST_COMPONENTS`] components.
pub(crate) struct RationalPoints<'a, B: RationalBasis, P: Point<Scalar = B::Scalar>> {
    pub(crate) curve: &'a RationalCurve<B, P>,
    /// The Bernstein coefficients of numerator and denominator, times the binomial coefficients.
    pub(crate) numerator: &'a [P],
    pub(crate) denominator: &'a [B::Scalar],
    pub(crate) ts: &'a [B::Scalar],
    pub(crate) out: &'a mut [P],
}

impl<B: RationalBasis, P: Point<Scalar = B::Scalar>> Kernel for RationalPoints<'_, B, P> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { curve, numerator, denominator, ts, out } = self;
        let chart = curve.chart();
        let [lo, hi] = chart.domain();
        let zero = B::Scalar::ZERO;
        let (mut s, mut x, mut weight) = ([zero; TILE], [zero; TILE], [zero; TILE]);
        let mut sums = [[zero; TILE]; MOST_COMPONENTS];
        for (ts, out) in ts.chunks(TILE).zip(out.chunks_mut(TILE)) {
            let (mut inside, mut ends) = (true, false);
            for &t in ts {
                inside &= lo <= t && t <= hi;
                ends |= t == lo || t == hi;
            }
            if !inside {
                // The angle may be any there.
                for (out, &t) in out.iter_mut().zip(ts) {
                    *out = curve.eval(t);
                }
                continue;
            }
            let mut tile = [lo; TILE];
            tile[..ts.len()].copy_from_slice(ts);
            chart.coordinates_into::<FUSED>(&tile, &mut s, &mut x);
            component::<FUSED, B::Scalar>(denominator, 0, &s, &x, &mut weight);
            for weight in &mut weight {
                *weight = curve.side().keep(*weight);
            }
            for (d, sum) in sums.iter_mut().enumerate().take(P::DIM) {
                component::<FUSED, P>(numerator, d, &s, &x, sum);
                for (sum, weight) in sum.iter_mut().zip(&weight) {
                    *sum = *sum / *weight;
                }
            }
            for (i, point) in out.iter_mut().enumerate() {
                *point = P::from_components(
                    #[inline(always)]
                    |d| sums[d][i],
                );
            }
            if ends {
                for (point, &t) in out.iter_mut().zip(ts) {
                    if t == lo || t == hi {
                        *point = curve.eval(t);
                    }
                }
            }
        }
    }
}

/// `Σ_j c[j] s^(n-j) x^j` of one component, nested in `s`.
#[inline(always)]
fn component<const FUSED: bool, P: Point>(
    coefficients: &[P],
    d: usize,
    s: &[P::Scalar; TILE],
    x: &[P::Scalar; TILE],
    sum: &mut [P::Scalar; TILE],
) {
    let Some((first, rest)) = coefficients.split_first() else { return sum.fill(P::Scalar::ZERO) };
    sum.fill(first.component(d));
    let mut powers = [P::Scalar::ONE; TILE];
    for point in rest {
        let c = point.component(d);
        for i in 0..TILE {
            powers[i] = powers[i] * x[i];
            sum[i] = c.fma::<FUSED>(powers[i], sum[i] * s[i]);
        }
    }
}
