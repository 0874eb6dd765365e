//! What the measurements share: the shipped specs, evenly spaced parameters and random numbers.

use std::path::PathBuf;

use basis_engine::Source;

/// The folder of the shipped specs.
pub fn specs() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../specs")
}

/// A shipped spec.
///
/// # Panics
/// When it cannot be read.
pub fn spec(name: &str) -> Source {
    let path = specs().join(name);
    let path = path.to_str().expect("the path of the repository is UTF-8");
    basis_engine::source::read(&basis_engine::Disk, path, &[]).expect("a shipped spec can be read")
}

/// `count` parameters from 0 to 1, both ends included.
pub fn parameters(count: u32) -> Vec<f64> {
    (0..count).map(|i| f64::from(i) / f64::from(count - 1)).collect()
}

/// `count` points of the triangle, spread by the golden ratio.
pub fn barycentric(count: usize) -> Vec<[f64; 3]> {
    (0..count)
        .map(|i| {
            let a = (i as f64 * 0.618_033_988_749_895).fract();
            let b = (i as f64 * 0.414_213_562_373_095).fract();
            let (a, b) = if a + b > 1.0 { (1.0 - a, 1.0 - b) } else { (a, b) };
            [a, b, 1.0 - a - b]
        })
        .collect()
}

/// Random numbers that are the same in every run.
#[derive(Debug)]
pub struct Random(u64);

impl Default for Random {
    fn default() -> Self {
        Self(0x2545_F491_4F6C_DD1D)
    }
}

impl Random {
    /// A number from 0 to 1.
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// The control points of a cubic, in a square.
    pub fn cubic(&mut self) -> [[f64; 2]; 4] {
        [(); 4].map(|()| [self.unit(), self.unit()])
    }
}
