//! What the tests share: the shipped families as a downstream crate gets them, their exact values from the engine,
//! and a generator of test numbers.
//!
//! The crate depends on the project as any other crate would; everything that is tested goes through the public
//! interface.

pub mod exact;
pub mod families;
pub mod patches;
pub mod random;

use std::path::{Path, PathBuf};

/// The file of that name in the library of specs.
pub fn spec(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs").join(name)
}
