//! The square of the speed of a curve in powers of the parameter.

// What is marked so is compiled once for each set of vector instructions.
#![allow(clippy::inline_always)]

use super::quadrature::Rule;
use super::series::{Chebyshev, Rules};
use crate::numeric::simd::{Kernel, WORTHWHILE, dispatch};
use crate::vector::dot;
use crate::{Array, Basis, Point, Scalar, bernstein};

/// The square of the speed `|dC/dz|` of a piece in powers of `z`: pairs of coefficients `[q[2k], q[2k+1]]`, of which
/// the last ones are zero. The degree is `2n - 2` on a curve of degree `n`, and there are `n + 1` pairs.
pub(super) struct SquaredSpeed<B: Basis> {
    coefficients: B::Bernstein<[B::Scalar; 2]>,
}

impl<B: Basis> SquaredSpeed<B> {
    /// Of the piece with these Bézier control points over `0 <= x <= 1`, with `z = 2x - 1`.
    pub(super) fn of<P: Point<Scalar = B::Scalar>>(mut points: B::Bernstein<P>) -> Self {
        let velocity = bernstein::differentiate(points.as_mut());
        bernstein::centred_powers(velocity);
        let quarter = B::Scalar::of(0.25); // of (dx/dz)²
        let half = B::Scalar::of(0.5);
        let mut coefficients = B::Bernstein::from_fn(|_| [B::Scalar::ZERO; 2]);
        let q = coefficients.as_mut().as_flattened_mut();
        // Loops of one length each, which the compiler unrolls for low degrees.
        let velocity = &velocity[..B::DEGREE];
        for (i, &v) in velocity.iter().enumerate() {
            for (j, &w) in velocity.iter().enumerate() {
                if j < i {
                    q[i + j] = q[i + j] + dot(v, w) * half;
                } else if j == i {
                    q[i + j] = q[i + j] + dot(v, w) * quarter;
                }
            }
        }
        Self { coefficients }
    }

    /// As [`Chebyshev::single`]; `None` also where the powers cancel each other.
    #[inline(always)]
    fn single(&self, accuracy: B::Scalar) -> Option<&'static Rule> {
        let powers = self.coefficients.as_ref().as_flattened();
        let sum = Chebyshev::<B>::of_powers(powers);
        let absolute = powers.iter().fold(B::Scalar::ZERO, |sum, c| sum + c.abs());
        if absolute <= B::Scalar::of(4.0) * sum.mean()? { sum.single(accuracy) } else { None }
    }

    /// As [`Chebyshev::rule`]; `None` also where the powers cancel each other.
    #[inline]
    pub(super) fn rule(&self, accuracy: B::Scalar, rules: Rules) -> Option<&'static Rule> {
        let powers = self.coefficients.as_ref().as_flattened();
        let sum = Chebyshev::<B>::of_powers(powers);
        let absolute = powers.iter().fold(B::Scalar::ZERO, |sum, c| sum + c.abs());
        let stable = absolute <= B::Scalar::of(4.0) * sum.mean()?;
        if stable { sum.rule(accuracy, rules) } else { None }
    }

    /// The sum of the rule.
    #[inline]
    pub(super) fn length(&self, rule: &Rule) -> B::Scalar {
        let mut parts = [B::Scalar::ZERO; 4];
        dispatch(2 * rule.len(), Sum { square: self, rule: Ok(rule), parts: &mut parts });
        let [a, b, c, d] = parts;
        (a + b) + (c + d)
    }

    /// The length, if a single ellipse for one of the first rules proves that its error is at most `accuracy`.
    #[inline]
    pub(super) fn length_by_single(&self, accuracy: B::Scalar) -> Option<B::Scalar> {
        let mut parts = [B::Scalar::NAN; 4];
        dispatch(WORTHWHILE, Sum { square: self, rule: Err(accuracy), parts: &mut parts });
        let [a, b, c, d] = parts;
        (!a.is_nan()).then(|| (a + b) + (c + d))
    }

    #[inline]
    pub(super) fn speed(&self, z: B::Scalar) -> B::Scalar {
        let q = self.coefficients.as_ref().as_flattened().iter().rev();
        q.fold(B::Scalar::ZERO, |sum, &c| sum * z + c).sqrt()
    }
}

/// The sum of a rule over the square root of a polynomial, by its even and odd powers.
struct Sum<'a, B: Basis> {
    square: &'a SquaredSpeed<B>,
    /// Or the accuracy for which one is looked for.
    rule: Result<&'a Rule, B::Scalar>,
    parts: &'a mut [B::Scalar; 4],
}

impl<B: Basis> Kernel for Sum<'_, B> {
    #[inline(always)]
    fn run<const FUSED: bool>(self) {
        let Self { square, rule, parts } = self;
        // Its length is known when this is compiled.
        let pairs = &square.coefficients.as_ref()[..B::DEGREE];
        let rule = match rule {
            Ok(rule) => rule,
            Err(accuracy) => match square.single(accuracy) {
                Some(rule) => rule,
                None => return,
            },
        };
        *parts = rule.parts(
            #[inline(always)]
            |z: [B::Scalar; 4]| {
                let [mut even, mut odd] = [[B::Scalar::ZERO; 4]; 2];
                for &[a, b] in pairs.iter().rev() {
                    for k in 0..4 {
                        let square = z[k] * z[k];
                        even[k] = even[k].fma::<FUSED>(square, a);
                        odd[k] = odd[k].fma::<FUSED>(square, b);
                    }
                }
                let mut speeds = [[B::Scalar::ZERO; 4]; 2];
                for k in 0..4 {
                    let odd = odd[k] * z[k];
                    speeds[0][k] = (even[k] + odd).sqrt();
                    speeds[1][k] = (even[k] - odd).sqrt();
                }
                speeds
            },
        );
    }
}
