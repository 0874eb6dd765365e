//! The numbers at which laws are checked: always the same ones.

use crate::{Array, Scalar};

/// SplitMix64.
pub(super) struct Random(pub(super) u64);

impl Random {
    /// A number from 0 to 1.
    pub(super) fn unit<S: Scalar>(&mut self) -> S {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        S::of(((z ^ (z >> 31)) >> 11) as f64 / 9_007_199_254_740_992.0)
    }

    /// A number from -1 to 1.
    pub(super) fn between_ones<S: Scalar>(&mut self) -> S {
        S::of(2.0) * self.unit() - S::ONE
    }

    /// Numbers from -1 to 1.
    pub(super) fn numbers<S: Scalar, A: Array<S>>(&mut self) -> A {
        A::from_fn(|_| self.between_ones())
    }
}
