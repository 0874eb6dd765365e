//! The papers: a file of figures for each, and the published claims with their verdicts.

mod bonnet;
mod bspline;
mod families;
mod quadratic;
mod quartic;
mod revolution;
mod triangular;

use basis_engine::published::{self, Published};
use basis_engine::source::{self, ReadError};
use basis_engine::{Disk, Library, Prover};

use crate::figure::Figure;

/// A paper: how the page names it; `papers/` and its identifier is the spec with its claims in the library.
pub(crate) struct Paper {
    pub(crate) id: &'static str,
    pub(crate) title: &'static str,
    figures: fn() -> Vec<Figure>,
}

/// All papers, in the order of the page.
pub(crate) const PAPERS: [Paper; 5] = [
    Paper {
        id: "quadratic",
        title: "Quadratic Bézier curves with one shape parameter",
        figures: quadratic::figures,
    },
    Paper {
        id: "quartic",
        title: "Quartic generalized Bézier surfaces and their joins",
        figures: quartic::figures,
    },
    Paper {
        id: "triangular",
        title: "Triangular quasi-Bézier surfaces with two shape parameters",
        figures: triangular::figures,
    },
    Paper {
        id: "revolution",
        title: "Surfaces of revolution from quartic generatrices",
        figures: revolution::figures,
    },
    Paper { id: "bspline", title: "Splicing of B-spline surfaces", figures: bspline::figures },
];

impl Paper {
    /// The figures of the paper.
    pub(crate) fn figures(&self) -> Vec<Figure> {
        (self.figures)()
    }

    /// The published statements, with their verdicts.
    ///
    /// # Errors
    /// When the library lacks the spec.
    pub(crate) fn statements(&self) -> Result<Vec<Published>, ReadError> {
        let spec = source::library(&Disk, &format!("papers/{}", self.id))?;
        Ok(published::statements(&Library::from_source(&Disk, &Prover, spec)))
    }
}
