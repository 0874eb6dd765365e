//! The Bernstein form: control points of a Bézier curve, for high degree.

use super::pointwise;
use super::slices::{EndpointDerivatives, EndpointPoints, NestedPoints, endpoint_coefficients};
use super::tiles::{BernsteinDerivatives, BernsteinPoints, MOST_COMPONENTS};
use crate::basis::combination;
use crate::numeric::binomial::binomials;
use crate::numeric::simd::{WORTHWHILE, dispatch};
use crate::vector::difference;
use crate::{Form, Point, Scalar};

/// The number of control points up to which a slice of parameters is evaluated in endpoint form, which is made on the
/// spot; from more of them it would lose digits.
const MOST_CENTRED: usize = 7;

/// The number of control points up to which each parameter of a slice is taken through all of them: more of them than
/// this are not unrolled reliably by compilers.
const MOST_NESTED: usize = 13;

/// The Bézier curve of degree `n = N - 1`, `N >= 1`, over its control points
///
/// ```text
/// C(x) = Σ_k binomial(n, k) s^(n-k) x^k P[k],   s = 1 - x
/// ```
///
/// evaluated in linear time by nesting in `s`: `(… (P[0] s + n x P[1]) s + binomial(n, 2) x² P[2]) s + …`. No term
/// cancels another, so the rounding error grows slowly with the degree: about 11 ε times the largest control point at
/// degree 30.
///
/// ```
/// use basis_runtime::{BernsteinForm, Form};
///
/// let parabola = BernsteinForm::new([0.0, 8.0, 4.0]);
/// assert_eq!(parabola.eval(0.5), 5.0);
/// assert_eq!(parabola.eval_with_derivs(0.0), [0.0, 16.0, -24.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BernsteinForm<P, const N: usize> {
    points: [P; N],
}

impl<P: Point, const N: usize> BernsteinForm<P, N> {
    /// The curve with these control points.
    #[inline]
    pub fn new(points: [P; N]) -> Self {
        const { assert!(N > 0, "a Bernstein form has at least one control point") };
        Self { points }
    }

    /// The control points.
    #[inline]
    pub fn points(&self) -> &[P; N] {
        &self.points
    }
}

impl<P: Point, const N: usize> Form<P> for BernsteinForm<P, N> {
    const DEGREE: usize = N - 1;

    #[inline]
    fn eval(&self, x: P::Scalar) -> P {
        nested(&self.points, &const { binomials::<N>() }, P::Scalar::ONE - x, x)
    }

    /// The k-th derivative is `n (n-1) … (n-k+1)` times the Bernstein form of degree `n - k` over the k-th differences
    /// of the control points.
    #[inline]
    fn eval_with_derivs<const K: usize>(&self, x: P::Scalar) -> [P; K] {
        let s = P::Scalar::ONE - x;
        let mut coefficients = self.points;
        let mut binomials = const { binomials::<N>() };
        let mut factor = P::Scalar::ONE;
        let mut derivatives = [P::zero(); K];
        for (k, derivative) in derivatives.iter_mut().enumerate().take(N) {
            let len = N - k;
            if k > 0 {
                factor = factor * P::Scalar::from_usize(len);
                differences(&mut coefficients[..=len]);
                // Pascal's rule backwards: binomial(m-1, i) = binomial(m, i) - binomial(m-1, i-1).
                for i in 1..len {
                    binomials[i] -= binomials[i - 1];
                }
            }
            *derivative = nested(&coefficients[..len], &binomials[..len], s, x).scale(factor);
        }
        derivatives
    }

    fn eval_into(&self, xs: &[P::Scalar], out: &mut [P]) {
        if xs.len() < WORTHWHILE || (N > MOST_CENTRED && P::DIM > MOST_COMPONENTS) {
            for (point, &x) in out.iter_mut().zip(xs) {
                *point = self.eval(x);
            }
        } else if N > MOST_CENTRED && N <= MOST_NESTED {
            dispatch(xs.len(), NestedPoints { points: self.points, xs, out });
        } else if N > MOST_CENTRED {
            dispatch(xs.len(), BernsteinPoints { points: &self.points, xs, out });
        } else {
            let (ends, inner) = endpoint_coefficients(&self.points);
            dispatch(xs.len(), EndpointPoints::<P, _, 2> { ends, inner, xs, out });
        }
    }

    fn eval_with_derivs_into<const K: usize>(
        &self,
        xs: &[P::Scalar],
        rate: P::Scalar,
        mut out: [&mut [P]; K],
    ) {
        if xs.len() < WORTHWHILE || (N > MOST_CENTRED && P::DIM > MOST_COMPONENTS) {
            pointwise(self, xs, rate, &mut out);
        } else if N > MOST_CENTRED {
            let points = &mut { self.points };
            dispatch(xs.len(), BernsteinDerivatives { points, rate, xs, out });
        } else {
            let (ends, inner) = endpoint_coefficients(&self.points);
            dispatch(xs.len(), EndpointDerivatives::<P, _, 2, K> { ends, inner, rate, xs, out });
        }
    }

    #[inline]
    fn combination(terms: impl Iterator<Item = (Self, P::Scalar)> + Clone) -> Self {
        Self::new(core::array::from_fn(|k| {
            combination(terms.clone().map(|(form, weight)| (form.points[k], weight)))
        }))
    }

    #[inline]
    fn start(&self) -> P {
        self.points[0]
    }

    #[inline]
    fn end(&self) -> P {
        self.points[N - 1]
    }
}

/// `Σ_k binomials[k] s^(n-k) x^k points[k]` with `n = points.len() - 1`, nested in `s`.
#[inline]
pub(crate) fn nested<P: Point>(points: &[P], binomials: &[f64], s: P::Scalar, x: P::Scalar) -> P {
    let Some((&first, rest)) = points.split_first() else { return P::zero() };
    let mut power = P::Scalar::ONE;
    rest.iter().zip(&binomials[1..]).fold(first, |sum, (&point, &binomial)| {
        power = power * x;
        sum.scale(s).add_weighted(point, power * P::Scalar::of(binomial))
    })
}

/// [`nested`] for `s + x = 1`, in the smaller of both: `sum s` is `sum - sum x`, of which the product is small. What the
/// sums lose by rounding is carried along, so that the error does not grow with the degree.
#[inline]
pub(crate) fn affine_nested<P: Point>(points: &[P], binomials: &[f64], s: P::Scalar, x: P::Scalar) -> P {
    if points.len() < 3 {
        nested(points, binomials, s, x)
    } else if x < s {
        stepwise(points.iter().copied(), binomials, x)
    } else {
        stepwise(points.iter().rev().copied(), binomials, s)
    }
}

#[inline]
fn stepwise<P: Point>(mut points: impl Iterator<Item = P>, binomials: &[f64], x: P::Scalar) -> P {
    let Some(first) = points.next() else { return P::zero() };
    let one = P::Scalar::ONE;
    let mut power = one;
    let (sum, lost) =
        points.zip(&binomials[1..]).fold((first, P::zero()), |(sum, lost), (point, &binomial)| {
            power = power * x;
            let step = difference(point.scale(power * P::Scalar::of(binomial)), sum.scale(x));
            let next = sum.add_weighted(step, one);
            let rounded = difference(sum, next).add_weighted(step, one);
            (next, difference(lost, lost.scale(x)).add_weighted(rounded, one))
        });
    sum.add_weighted(lost, one)
}

/// The derivative of that order, in `x`, of the polynomial with these Bernstein coefficients; overwrites them.
#[inline]
pub(crate) fn bernstein_derivative<P: Point>(
    coefficients: &mut [P],
    order: usize,
    s: P::Scalar,
    x: P::Scalar,
) -> P {
    let len = coefficients.len();
    if order >= len {
        return P::zero();
    }
    let mut factor = P::Scalar::ONE;
    for k in 0..order {
        factor = factor * P::Scalar::from_usize(len - 1 - k);
        differences(&mut coefficients[..len - k]);
    }
    // De Casteljau's algorithm.
    for end in (1..len - order).rev() {
        for i in 0..end {
            coefficients[i] = coefficients[i].scale(s).add_weighted(coefficients[i + 1], x);
        }
    }
    coefficients[0].scale(factor)
}

/// Replaces all but the last point by the difference to the next.
#[inline]
fn differences<P: Point>(points: &mut [P]) {
    for i in 1..points.len() {
        points[i - 1] = difference(points[i], points[i - 1]);
    }
}
