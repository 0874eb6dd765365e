//! A small deterministic generator (SplitMix64), so that every run tests the same numbers.

use basis_runtime::Scalar;

pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number between `lo` and `hi`, rounded to the scalar type.
    pub fn between<S: Scalar>(&mut self, lo: f64, hi: f64) -> S {
        let unit = (self.bits() >> 11) as f64 / 2_f64.powi(53);
        S::of(lo + (hi - lo) * unit)
    }

    /// A number of either sign whose magnitude varies over `2^-40 … 2^40`.
    pub fn wild<S: Scalar>(&mut self) -> S {
        let magnitude = 2_f64.powi((self.bits() % 81) as i32 - 40);
        self.between(-magnitude, magnitude)
    }
}
