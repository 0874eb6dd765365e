//! What the measurements share: the shipped specs and evenly spaced parameters.

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
