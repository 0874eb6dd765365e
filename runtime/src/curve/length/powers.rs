//! The square of the speed of a curve in powers of the parameter.

use super::quadrature::Rule;
use super::series::{Chebyshev, Rules};
use crate::vector::dot;
use crate::{Array, Basis, FUSED_HERE, Point, Scalar, bernstein};

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
        for (i, &v) in velocity.iter().enumerate() {
            q[2 * i] = q[2 * i] + dot(v, v) * quarter;
            for (j, &w) in velocity.iter().enumerate().take(i) {
                q[i + j] = q[i + j] + dot(v, w) * half;
            }
        }
        Self { coefficients }
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

    /// The sum of the rule, by even and odd powers.
    pub(super) fn length(&self, rule: &Rule) -> B::Scalar {
        let pairs = &self.coefficients.as_ref()[..B::DEGREE];
        rule.integrate_fours(|z: [B::Scalar; 4]| {
            let [mut even, mut odd] = [[B::Scalar::ZERO; 4]; 2];
            for &[a, b] in pairs.iter().rev() {
                for k in 0..4 {
                    let square = z[k] * z[k];
                    even[k] = even[k].fma::<FUSED_HERE>(square, a);
                    odd[k] = odd[k].fma::<FUSED_HERE>(square, b);
                }
            }
            let mut speeds = [[B::Scalar::ZERO; 4]; 2];
            for k in 0..4 {
                let odd = odd[k] * z[k];
                speeds[0][k] = (even[k] + odd).sqrt();
                speeds[1][k] = (even[k] - odd).sqrt();
            }
            speeds
        })
    }

    #[inline]
    pub(super) fn speed(&self, z: B::Scalar) -> B::Scalar {
        let q = self.coefficients.as_ref().as_flattened().iter().rev();
        q.fold(B::Scalar::ZERO, |sum, &c| sum * z + c).sqrt()
    }
}
