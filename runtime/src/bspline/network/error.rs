//! Why a network of patches cannot follow.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

use crate::bspline::{JointBounds, KnotError, SpliceError};

/// A network that is not one, or whose patches cannot follow one of them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum NetworkError {
    /// There is no such patch.
    Patch {
        /// The index of the patch.
        patch: usize,
    },
    /// There is no such seam.
    NoSeam {
        /// The index of the seam.
        seam: usize,
    },
    /// The patches do not fill the rows of a grid.
    Grid {
        /// The number of patches.
        patches: usize,
        /// The number of columns.
        columns: usize,
    },
    /// A tolerance is not a positive number.
    Tolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// An edge belongs to two seams.
    EdgeTwice {
        /// The second of the seams.
        seam: usize,
    },
    /// The deformed patch has another domain than the one it replaces.
    Domain(KnotError),
    /// A seam near the deformed patch was not smooth before, so there is no contact that could be kept.
    NotSmooth {
        /// The seam.
        seam: usize,
        /// How its patches met.
        joint: JointBounds,
    },
    /// A seam cannot be read, or its equations not be solved.
    Seam {
        /// The seam.
        seam: usize,
        /// What is wrong.
        error: SpliceError,
    },
    /// Two seams that meet in a corner ask for different mixed derivatives of the patch between them, and over so few
    /// spans the mean of both is not good enough for either. That happens where the seams do not pass straight through
    /// the corner (see [`Network::follow`](super::Network::follow)); the error of the mean falls with the length of the
    /// spans.
    Twist {
        /// The patch in the corner.
        patch: usize,
        /// The two seams.
        seams: [usize; 2],
        /// How far the two control points next to the corner are apart.
        mismatch: f64,
        /// The seam that is not smooth for this reason.
        worst: usize,
        /// Its figures.
        achieved: JointBounds,
    },
    /// The deformed patch meets itself along a seam, and its two edges were not deformed alike.
    Ring {
        /// The seam.
        seam: usize,
        /// How its edges meet.
        achieved: JointBounds,
    },
    /// Two patches that both follow also meet each other, in a corner of three or of five and more patches, and their
    /// changes do not fit.
    Corner {
        /// The seam between them.
        seam: usize,
        /// How they would meet.
        achieved: JointBounds,
    },
    /// The tolerances were not reached with the number of spans that is allowed, or with the precision of the scalar
    /// type.
    NotReached {
        /// The worst seam.
        seam: usize,
        /// Its figures.
        achieved: JointBounds,
    },
}

impl Display for NetworkError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let figures = |f: &mut Formatter<'_>, m: &JointBounds| {
            write!(f, "gap {:.3e}, angle {:.3e} rad at the parameter {}", m.gap, m.angle, m.angle_at)
        };
        match self {
            Self::Patch { patch } => write!(f, "there is no patch {patch}"),
            Self::NoSeam { seam } => write!(f, "there is no seam {seam}"),
            Self::Grid { patches, columns } => {
                write!(f, "{patches} patches do not fill the rows of a grid with {columns} columns")
            }
            Self::Tolerance { tolerance } => {
                write!(f, "a tolerance of {tolerance}; tolerances are positive numbers")
            }
            Self::EdgeTwice { seam } => write!(f, "seam {seam} joins an edge that belongs to another seam"),
            Self::Domain(error) => write!(f, "the deformed patch: {error}"),
            Self::NotSmooth { seam, joint } => {
                write!(f, "seam {seam} was not smooth before: ")?;
                figures(f, joint)?;
                f.write_str("; join its patches first, by `continued_within`")
            }
            Self::Seam { seam, error } => write!(f, "seam {seam}: {error}"),
            Self::Twist { patch, seams: [a, b], mismatch, worst, achieved } => {
                write!(
                    f,
                    "in the corner of patch {patch} between the seams {a} and {b} the twists that they \
                     ask for put one control \
                     point at two places, {mismatch:.3e} apart; seam {worst} is then not smooth: "
                )?;
                figures(f, achieved)?;
                f.write_str(
                    "; allow more spans or a wider angle, or let the edges pass straight through the corner",
                )
            }
            Self::Ring { seam, achieved } => {
                write!(f, "the deformed patch meets itself along seam {seam}; deform both edges alike: ")?;
                figures(f, achieved)
            }
            Self::Corner { seam, achieved } => {
                write!(
                    f,
                    "both patches of seam {seam} follow, and meet in a corner that is not one of four patches: "
                )?;
                figures(f, achieved)
            }
            Self::NotReached { seam, achieved } => {
                write!(f, "seam {seam} does not reach the tolerances: ")?;
                figures(f, achieved)
            }
        }
    }
}

impl Error for NetworkError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Domain(error) => Some(error),
            Self::Seam { error, .. } => Some(error),
            _ => None,
        }
    }
}
