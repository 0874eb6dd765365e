//! A small deterministic generator, so that every run tests the same numbers.

use basis_runtime::Scalar;

/// SplitMix64.
#[derive(Debug)]
pub struct Random(u64);

impl Random {
    /// The generator with that seed.
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A whole number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end.max(1) as u64) as usize
    }

    /// A number between `low` and `high`, rounded to the scalar type.
    pub fn between<S: Scalar>(&mut self, low: f64, high: f64) -> S {
        let unit = (self.bits() >> 11) as f64 / 2_f64.powi(53);
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
