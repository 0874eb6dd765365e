//! The claims of the papers with their verdicts, decided while the gallery is made.

use crate::check::{self, Published};

/// A paper: how the gallery names it, and the spec with its claims.
pub(super) struct Paper {
    pub(super) id: &'static str,
    pub(super) title: &'static str,
    spec: (&'static str, &'static str),
}

macro_rules! paper {
    ($id:literal, $title:literal) => {
        Paper {
            id: $id,
            title: $title,
            spec: (
                concat!("specs/papers/", $id, ".basis"),
                include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/papers/", $id, ".basis")),
            ),
        }
    };
}

/// All papers, in the order of the gallery.
pub(super) const PAPERS: [Paper; 5] = [
    paper!("quadratic", "Quadratic Bézier curves with one shape parameter"),
    paper!("quartic", "Quartic generalized Bézier surfaces and their joins"),
    paper!("triangular", "Triangular quasi-Bézier surfaces with two shape parameters"),
    paper!("revolution", "Surfaces of revolution from quartic generatrices"),
    paper!("bspline", "Splicing of B-spline surfaces"),
];

impl Paper {
    /// The published statements, with what is known about them.
    pub(super) fn statements(&self) -> Vec<Published> {
        let (name, text) = self.spec;
        check::published(name, text)
    }
}
