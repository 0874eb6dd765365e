//! Bézier curves of any degree at many parameters: one loop over a tile of parameters for each control point.

// All of it is compiled once for each set of vector instructions, inside of the functions that name them.
#![allow(clippy::inline_always)]

use crate::numeric::binomial::after;
use crate::numeric::simd::Kernel;
use crate::{Point, Scalar, bernstein};

/// The number of parameters that are carried through all control points together; their powers stay in the nearest
/// cache.
const TILE: usize = 64;

/// Points of more components are evaluated one after the other.
pub(crate) const MOST_COMPONENTS: usize = 4;

/// `out[i] = Σ_k binomial(n, k) s^(n-k) x^k P[k]` at `x = xs[i]`, nested in `s` as in
/// [`BernsteinForm`](crate::BernsteinForm); for points of up to [`MOST_COMPONENTS`] components.
pub(crate) struct BernsteinPoints<'a, P: Point> {
    pub(crate) points: &'a [P],
    pub(crate) xs: &'a [P::Scalar],
    pub(crate) out: &'a mut [P],
}

impl<P: Point> Kernel for BernsteinPoints<'_, P> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { points, xs, out } = self;
        let zero = P::Scalar::ZERO;
        let mut sums = [[zero; TILE]; MOST_COMPONENTS];
        for (xs, out) in xs.chunks(TILE).zip(out.chunks_mut(TILE)) {
            let mut x = [zero; TILE];
            x[..xs.len()].copy_from_slice(xs);
            for (d, sum) in sums.iter_mut().enumerate().take(P::DIM) {
                component::<FUSED, P>(points, d, &x, sum);
            }
            for (i, point) in out.iter_mut().enumerate() {
                // A tile of the parameters can be shorter than that of the points.
                if i < xs.len() {
                    *point = P::from_components(
                        #[inline(always)]
                        |d| sums[d][i],
                    );
                }
            }
        }
    }
}

// The powers are formed again for each component: rows of powers for all components together were slower.
#[inline(always)]
fn component<const FUSED: bool, P: Point>(
    points: &[P],
    d: usize,
    x: &[P::Scalar; TILE],
    sum: &mut [P::Scalar; TILE],
) {
    let Some((first, rest)) = points.split_first() else { return sum.fill(P::Scalar::ZERO) };
    sum.fill(first.component(d));
    let mut powers = [P::Scalar::ONE; TILE];
    let mut binomial = 1.0;
    for (k, point) in rest.iter().enumerate() {
        binomial = after(binomial, rest.len(), k);
        let (binomial, c) = (P::Scalar::of(binomial), point.component(d));
        for i in 0..TILE {
            powers[i] = powers[i] * x[i];
            sum[i] = c.fma::<FUSED>(binomial * powers[i], sum[i] * (P::Scalar::ONE - x[i]));
        }
    }
}

/// Values and derivatives `out[k][i] = rateᵏ C⁽ᵏ⁾(xs[i])`; overwrites the control points.
pub(crate) struct BernsteinDerivatives<'a, P: Point, const K: usize> {
    pub(crate) points: &'a mut [P],
    pub(crate) rate: P::Scalar,
    pub(crate) xs: &'a [P::Scalar],
    pub(crate) out: [&'a mut [P]; K],
}

impl<P: Point, const K: usize> Kernel for BernsteinDerivatives<'_, P, K> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { mut points, rate, xs, out } = self;
        for (k, out) in out.into_iter().enumerate() {
            if k > 0 {
                points = bernstein::differentiate(points);
                for point in points.iter_mut() {
                    *point = point.scale(rate);
                }
            }
            BernsteinPoints { points, xs, out }.run::<FUSED>();
        }
    }
}
