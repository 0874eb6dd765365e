//! The claims of the papers with their verdicts, decided while the figures are drawn.

use basis_engine::published::{self, Published};
use basis_engine::source::{self, ReadError};
use basis_engine::{Disk, Library, Prover};

/// A paper: how the page names it; `papers/` and its identifier is the spec with its claims in the library.
pub(crate) struct Paper {
    pub(crate) id: &'static str,
    pub(crate) title: &'static str,
}

/// All papers, in the order of the page.
pub(crate) const PAPERS: [Paper; 5] = [
    Paper { id: "quadratic", title: "Quadratic Bézier curves with one shape parameter" },
    Paper { id: "quartic", title: "Quartic generalized Bézier surfaces and their joins" },
    Paper { id: "triangular", title: "Triangular quasi-Bézier surfaces with two shape parameters" },
    Paper { id: "revolution", title: "Surfaces of revolution from quartic generatrices" },
    Paper { id: "bspline", title: "Splicing of B-spline surfaces" },
];

impl Paper {
    /// The published statements, with what is known about them.
    ///
    /// # Errors
    /// When the library lacks the spec.
    pub(crate) fn statements(&self) -> Result<Vec<Published>, ReadError> {
        let spec = source::library(&Disk, &format!("papers/{}", self.id))?;
        Ok(published::statements(&Library::from_source(&Disk, &Prover, spec)))
    }
}
