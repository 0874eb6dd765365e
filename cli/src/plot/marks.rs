//! Counterexamples as marks in a picture.

use super::failures::Failure;
use super::pictures::frame::{BAD, FAINT};
use super::settings::Setting;

/// A point to be marked in a picture.
pub(super) struct Mark {
    /// Which setting it belongs to.
    pub(super) setting: usize,
    /// What fails there.
    pub(super) failure: Failure,
}

impl Mark {
    /// Red is what is not as declared.
    pub(super) fn colour(&self) -> &'static str {
        if self.failure.declared { FAINT } else { BAD }
    }
}

/// Those failures whose shape values are drawn; of what is declared false only what has a place in the picture.
pub(super) fn at(failures: &[Failure], settings: &[Setting]) -> Vec<Mark> {
    let mark = |failure: &Failure| {
        let there = |s: &Setting| {
            let mut both = s.values.iter().zip(&failure.shapes);
            both.all(|(value, wanted)| wanted.as_ref().is_none_or(|wanted| wanted == value))
        };
        let setting = settings.iter().position(there)?;
        Some(Mark { setting, failure: failure.clone() })
    };
    failures.iter().filter(|failure| failure.is_shown()).filter_map(mark).collect()
}
