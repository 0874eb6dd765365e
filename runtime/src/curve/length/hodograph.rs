//! The speed of a curve of high degree, from its Bernstein form: powers would cancel each other.

use super::quadrature::Rule;
use super::series::{Chebyshev, Rules, rule_of_hull};
use crate::vector::{dot, length};
use crate::{Array, Basis, Point, Scalar, bernstein};

/// The velocity `dC/dz` of a piece of a curve in Bernstein form, one control point less than the curve has;
/// `z = 2x - 1`.
pub(super) struct Hodograph<B: Basis, P: Point<Scalar = B::Scalar>> {
    points: B::Bernstein<P>,
}

impl<B: Basis, P: Point<Scalar = B::Scalar>> Hodograph<B, P> {
    /// Of the piece with these Bézier control points over `0 <= x <= 1`.
    pub(super) fn of(mut points: B::Bernstein<P>) -> Self {
        for velocity in bernstein::differentiate(points.as_mut()) {
            *velocity = velocity.scale(B::Scalar::of(0.5)); // dx/dz
        }
        Self { points }
    }

    fn velocity(&self) -> &[P] {
        &self.points.as_ref()[..B::DEGREE]
    }

    fn at(&self, z: B::Scalar) -> P {
        bernstein::eval(self.velocity(), (z + B::Scalar::ONE) * B::Scalar::of(0.5))
    }

    pub(super) fn speed(&self, z: B::Scalar) -> B::Scalar {
        length(self.at(z))
    }

    /// The smallest rule whose error for `∫ |dC/dz| dz` is proved to be at most `accuracy`.
    ///
    /// The Chebyshev series bounds the speed on ellipses more sharply, but its rounding errors grow with the power of
    /// the degree; those of the control points do not.
    pub(super) fn rule(&self, accuracy: B::Scalar) -> Option<&'static Rule> {
        self.squared().rule(accuracy, Rules::Smallest).or_else(|| {
            let middle = self.at(B::Scalar::ZERO);
            let spread = self.velocity().iter().fold(B::Scalar::ZERO, |a, &v| a.max(length(v.minus(middle))));
            rule_of_hull(B::DEGREE - 1, length(middle), spread, accuracy)
        })
    }

    /// The square of the speed, by interpolation at the zeros `z[k] = cos((2k + 1) π / 2N)` of `T_N`:
    /// `c[j] = 2/N Σ_k q(z[k]) cos(j (2k + 1) π / 2N)`, half of it for `j = 0`.
    fn squared(&self) -> Chebyshev<B> {
        let count = Chebyshev::<B>::LEN;
        // The cosines of a quarter turn, from which the others follow.
        let mut quarter = B::Bernstein::from_fn(|_| [B::Scalar::ZERO; 2]);
        let quarter = &mut quarter.as_mut().as_flattened_mut()[..=count];
        let step = B::Scalar::PI / B::Scalar::from_usize(2 * count);
        for (i, cosine) in quarter.iter_mut().enumerate() {
            *cosine = (step * B::Scalar::from_usize(i)).sin_cos().1;
        }
        let cosine = |i: usize| {
            let i = i % (4 * count);
            let i = i.min(4 * count - i);
            if i <= count { quarter[i] } else { -quarter[2 * count - i] }
        };
        let mut coefficients = B::Bernstein::from_fn(|_| [B::Scalar::ZERO; 2]);
        let c = &mut coefficients.as_mut().as_flattened_mut()[..count];
        for k in 0..count {
            let velocity = self.at(cosine(2 * k + 1));
            let square = dot(velocity, velocity);
            for (j, c) in c.iter_mut().enumerate() {
                *c = *c + square * cosine(j * (2 * k + 1));
            }
        }
        let inverse = B::Scalar::ONE / B::Scalar::from_usize(count);
        for (j, c) in c.iter_mut().enumerate() {
            *c = *c * if j == 0 { inverse } else { inverse + inverse };
        }
        // A velocity has an error of about 11 ε times the largest control point at degree 30.
        let largest = self.velocity().iter().fold(B::Scalar::ZERO, |a, &v| a.max(dot(v, v)));
        let noise = largest * B::Scalar::EPSILON * B::Scalar::from_usize(2 * B::DEGREE + 16);
        Chebyshev { coefficients, noise }
    }
}
