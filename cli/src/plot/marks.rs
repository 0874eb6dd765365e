//! Counterexamples as marks in a picture.

use super::failures::Failure;
use super::settings::Setting;

/// A point to be marked in a picture.
pub(super) struct Mark {
    /// Which setting it belongs to.
    pub(super) setting: usize,
    /// What fails there.
    pub(super) failure: Failure,
}

/// Those failures whose shape values are drawn.
pub(super) fn at(failures: &[Failure], settings: &[Setting]) -> Vec<Mark> {
    let mark = |failure: &Failure| {
        let setting = settings.iter().position(|s| s.values == failure.shapes)?;
        Some(Mark { setting, failure: failure.clone() })
    };
    failures.iter().filter_map(mark).collect()
}
