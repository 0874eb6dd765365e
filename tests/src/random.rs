//! Random numbers of the scalar types, from a deterministic generator: every run tests the same numbers.

use basis_runtime::Scalar;

/// A generator of the numbers that the tests evaluate at.
#[derive(Debug)]
pub struct Random(basis_test_support::Random);

impl Random {
    /// The generator with that seed.
    pub const fn new(seed: u64) -> Self {
        Self(basis_test_support::Random::new(seed))
    }

    /// A whole number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        self.0.below(end)
    }

    /// A number between `low` and `high`, rounded to the scalar type.
    pub fn between<S: Scalar>(&mut self, low: f64, high: f64) -> S {
        let unit = (self.0.bits() >> 11) as f64 / 2_f64.powi(53);
        S::of(low + (high - low) * unit)
    }

    /// A number of either sign whose magnitude varies over `2^-40 … 2^40`.
    pub fn wild<S: Scalar>(&mut self) -> S {
        let magnitude = 2_f64.powi(self.below(81) as i32 - 40);
        self.between(-magnitude, magnitude)
    }

    /// A number between 0 and 1, often at an end or very close to one.
    pub fn unit<S: Scalar>(&mut self) -> S {
        let near = 2_f64.powi(-(self.below(30) as i32));
        match self.below(8) {
            0 => S::ZERO,
            1 => S::ONE,
            2 => S::of(near),
            3 => S::ONE - S::of(near),
            _ => self.between(0.0, 1.0),
        }
    }
}
