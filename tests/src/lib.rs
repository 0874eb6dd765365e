//! What the tests share: the shipped families as a downstream crate gets them, their exact values from the engine,
//! and a generator of test numbers.
//!
//! The crate depends on the project as any other crate would; everything that is tested goes through the public
//! interface.

pub mod exact;
pub mod families;
pub mod patches;
pub mod random;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use basis_engine::model::Family;
use basis_engine::{Disk, Library, Prover, Selected, Subject, source};

/// The file of that name in the library of specs.
pub fn spec(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs").join(name)
}

/// Reads all specs of the library and looks for families without a test.
///
/// # Panics
/// When a spec has errors, and when a family that is `meant` is not among those that are tested.
pub fn all_are_tested(tested: &BTreeSet<String>, meant: impl Fn(&Family) -> bool) {
    for entry in spec("").read_dir().expect("the library") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|e| e != "basis") {
            continue;
        }
        let source = source::read(&Disk, &path.to_string_lossy(), &[]).expect("readable");
        let library = Library::from_source(&Disk, &Prover, source);
        for item in library.items(Selected::EveryOrder) {
            let Subject::Family(family) = &item.subject else { continue };
            let fine = !meant(family) || tested.contains(&family.name);
            assert!(fine, "{} has a family {}", path.display(), family.name);
        }
        assert!(library.diagnostics().is_empty(), "{}", path.display());
    }
}
