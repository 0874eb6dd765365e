//! The claims of the papers with their verdicts, decided while the figures are drawn.

use basis_engine::published::{self, Published};
use basis_engine::{Disk, Library, Source};

/// A paper: how the page names it, and the spec with its claims.
pub(crate) struct Paper {
    pub(crate) id: &'static str,
    pub(crate) title: &'static str,
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

/// All papers, in the order of the page.
pub(crate) const PAPERS: [Paper; 5] = [
    paper!("quadratic", "Quadratic Bézier curves with one shape parameter"),
    paper!("quartic", "Quartic generalized Bézier surfaces and their joins"),
    paper!("triangular", "Triangular quasi-Bézier surfaces with two shape parameters"),
    paper!("revolution", "Surfaces of revolution from quartic generatrices"),
    paper!("bspline", "Splicing of B-spline surfaces"),
];

impl Paper {
    /// The published statements, with what is known about them.
    pub(crate) fn statements(&self) -> Vec<Published> {
        let (name, text) = self.spec;
        published::statements(&Library::from_source(&Disk, Source::text(name, text)))
    }
}
