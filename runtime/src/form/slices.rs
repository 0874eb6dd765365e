//! Polynomials at many parameters: loops that the compiler turns into vector instructions.
//!
//! The coefficients are given as a slice after `SKIP` others, or as an array: its length is known when the loop is
//! compiled, which the vectoriser needs.

// All of it is compiled once for each set of vector instructions, inside of the functions that name them.
#![allow(clippy::inline_always)]

use super::tiles::MOST_COMPONENTS;
use crate::numeric::binomial::binomials;
use crate::numeric::simd::Kernel;
use crate::vector::difference;
use crate::{Point, Scalar, bernstein};

/// The number of points that are finished before the next derivative: more than about four streams of results that
/// start at equal offsets would push each other out of the nearest cache.
const TILE: usize = 512;

/// `out[i] = s E0 + x E1 + s x (R0 + R1 y + …)` at `x = xs[i]`, as in [`EndpointForm`](crate::EndpointForm).
pub(crate) struct EndpointPoints<'a, P: Point, A, const SKIP: usize> {
    pub(crate) ends: [P; 2],
    pub(crate) inner: A,
    pub(crate) xs: &'a [P::Scalar],
    pub(crate) out: &'a mut [P],
}

impl<P: Point, A: Copy + AsRef<[P]>, const SKIP: usize> Kernel for EndpointPoints<'_, P, A, SKIP> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { ends: [start, end], inner, xs, out } = self;
        let inner = inner.as_ref().get(SKIP..).unwrap_or_default();
        for (point, &x) in out.iter_mut().zip(xs) {
            let s = P::Scalar::ONE - x;
            let y = x - s;
            let w = s * x;
            *point = P::from_components(
                #[inline(always)]
                |d| {
                    let chord = end.component(d).fma::<FUSED>(x, start.component(d) * s);
                    match inner.split_last() {
                        None => chord,
                        Some((last, rest)) => horner::<FUSED, P>(*last, rest, y, d).fma::<FUSED>(w, chord),
                    }
                },
            );
        }
    }
}

/// `out[i] = Σ_k binomial(n, k) s^(n-k) x^k P[k]` at `x = xs[i]`, as in [`BernsteinForm`](crate::BernsteinForm).
pub(crate) struct NestedPoints<'a, P: Point, const N: usize> {
    pub(crate) points: [P; N],
    pub(crate) xs: &'a [P::Scalar],
    pub(crate) out: &'a mut [P],
}

impl<P: Point, const N: usize> Kernel for NestedPoints<'_, P, N> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { points, xs, out } = self;
        let binomials = const { binomials::<N>() };
        for (point, &x) in out.iter_mut().zip(xs) {
            let (s, mut power) = (P::Scalar::ONE - x, P::Scalar::ONE);
            let mut sums = [power; MOST_COMPONENTS];
            for (d, sum) in sums.iter_mut().enumerate().take(P::DIM) {
                *sum = points[0].component(d);
            }
            for k in 1..N {
                power = power * x;
                let factor = P::Scalar::of(binomials[k]) * power;
                for (d, sum) in sums.iter_mut().enumerate().take(P::DIM) {
                    *sum = points[k].component(d).fma::<FUSED>(factor, *sum * s);
                }
            }
            *point = P::from_components(
                #[inline(always)]
                |d| sums[d],
            );
        }
    }
}

/// `out[i] = D0 + D1 y + D2 y² + …` at `x = xs[i]`, `y = 2x - 1`.
pub(crate) struct CentredPoints<'a, P: Point, A, const SKIP: usize> {
    first: P,
    rest: A,
    xs: &'a [P::Scalar],
    out: &'a mut [P],
}

impl<P: Point, A: Copy + AsRef<[P]>, const SKIP: usize> Kernel for CentredPoints<'_, P, A, SKIP> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { first, rest, xs, out } = self;
        let rest = rest.as_ref().get(SKIP..).unwrap_or_default();
        for (point, &x) in out.iter_mut().zip(xs) {
            let y = x - (P::Scalar::ONE - x);
            *point = P::from_components(
                #[inline(always)]
                |d| match rest.split_last() {
                    None => first.component(d),
                    Some((last, rest)) => {
                        horner::<FUSED, P>(*last, rest, y, d).fma::<FUSED>(y, first.component(d))
                    }
                },
            );
        }
    }
}

#[inline(always)]
pub(crate) fn horner<const FUSED: bool, P: Point>(last: P, rest: &[P], y: P::Scalar, d: usize) -> P::Scalar {
    rest.iter().rev().fold(last.component(d), |sum, c| sum.fma::<FUSED>(y, c.component(d)))
}

/// Values and derivatives, tile by tile and one order after the other.
pub(crate) struct EndpointDerivatives<'a, P: Point, A, const SKIP: usize, const K: usize> {
    pub(crate) ends: [P; 2],
    pub(crate) inner: A,
    pub(crate) rate: P::Scalar,
    pub(crate) xs: &'a [P::Scalar],
    pub(crate) out: [&'a mut [P]; K],
}

impl<P: Point, A: Copy + AsRef<[P]> + AsMut<[P]>, const SKIP: usize, const K: usize> Kernel
    for EndpointDerivatives<'_, P, A, SKIP, K>
{
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { ends, inner, rate, xs, out } = self;
        let mut derivatives = [(P::zero(), inner); K];
        for k in 1..K {
            derivatives[k] = match k {
                1 => first_derivative::<P, A, SKIP>(ends, inner, rate),
                _ => next_derivative::<P, A, SKIP>(derivatives[k - 1], rate),
            };
        }
        let mut out = out.map(|points| points.chunks_mut(TILE));
        for xs in xs.chunks(TILE) {
            for (k, tiles) in out.iter_mut().enumerate() {
                let Some(out) = tiles.next() else { continue };
                if k == 0 {
                    EndpointPoints::<P, A, SKIP> { ends, inner, xs, out }.run::<FUSED>();
                } else {
                    let (first, rest) = derivatives[k];
                    CentredPoints::<P, A, SKIP> { first, rest, xs, out }.run::<FUSED>();
                }
            }
        }
    }
}

/// With `C = s E0 + x E1 + s x R(y)` and `4 s x = 1 - y²`:
/// `C'(x) = E1 - E0 + Σ_j (j+1)/2 (R[j+1] - R[j-1]) y^j`, times `rate`.
fn first_derivative<P: Point, A: Copy + AsRef<[P]> + AsMut<[P]>, const SKIP: usize>(
    [start, end]: [P; 2],
    inner: A,
    rate: P::Scalar,
) -> (P, A) {
    let half = P::Scalar::of(0.5) * rate;
    let mut coefficients = inner;
    let r = inner.as_ref().get(SKIP..).unwrap_or_default();
    let of = |j: usize| r.get(j).copied().unwrap_or_else(P::zero);
    for j in 1..=r.len() {
        let factor = half * P::Scalar::from_usize(j + 1);
        coefficients.as_mut()[SKIP + j - 1] = difference(of(j + 1), of(j - 1)).scale(factor);
    }
    (difference(end, start).scale(rate).add_weighted(of(1), half), coefficients)
}

/// The derivative of `D0 + D1 y + …` in `x`, times `rate`: `2 (j+1) D[j+1]`.
fn next_derivative<P: Point, A: Copy + AsRef<[P]> + AsMut<[P]>, const SKIP: usize>(
    (_, rest): (P, A),
    rate: P::Scalar,
) -> (P, A) {
    let twice = P::Scalar::of(2.0) * rate;
    let mut coefficients = rest;
    let d = rest.as_ref().get(SKIP..).unwrap_or_default();
    let of = |j: usize| d.get(j).copied().unwrap_or_else(P::zero);
    for j in 1..=d.len() {
        coefficients.as_mut()[SKIP + j - 1] = of(j).scale(twice * P::Scalar::from_usize(j + 1));
    }
    (of(0).scale(twice), coefficients)
}

/// The ends and, from the third place on, the inner coefficients of a curve with these Bézier control points.
///
/// The correction to the chord has the Bernstein coefficients `r[i] = n(n-1) / ((i+1)(n-1-i)) (P[i+1] - chord)`; they
/// are rewritten in powers of `y`.
pub(crate) fn endpoint_coefficients<P: Point, const N: usize>(points: &[P; N]) -> ([P; 2], [P; N]) {
    let ends = [points[0], points[N - 1]];
    let mut coefficients = *points;
    if N <= 2 {
        return (ends, coefficients);
    }
    let degree = N - 1;
    let number = P::Scalar::from_usize;
    let inner = &mut coefficients[2..];
    for (i, r) in inner.iter_mut().enumerate() {
        // From both ends, without the rounding of a chord: n (P - chord) = a (P - E0) + b (P - E1), a + b = n.
        let [a, b] = [number(degree - 1 - i), number(i + 1)];
        let p = points[i + 1];
        let gap = p.minus(ends[0]).scale(a).add_scaled(p.minus(ends[1]), b);
        *r = P::from_vector(gap.scale(number(degree - 1) / (a * b)));
    }
    bernstein::centred_powers(inner);
    (ends, coefficients)
}
