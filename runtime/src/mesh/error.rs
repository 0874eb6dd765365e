//! What can keep surfaces from becoming a mesh.

use core::error::Error;
use core::fmt::{self, Display, Formatter};

/// Why surfaces cannot become a mesh, or a mesh no file.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum MeshError {
    /// The tolerance is not a positive, finite number.
    Tolerance {
        /// The tolerance.
        value: f64,
    },
    /// The longest edge or the largest angle is not a positive number.
    Limit {
        /// The limit.
        value: f64,
    },
    /// The largest quotient of sides is less than 2, or NaN.
    Aspect {
        /// The quotient.
        value: f64,
    },
    /// A surface is infinite or NaN.
    NotFinite {
        /// The number of the surface, in the order in which they were added.
        surface: usize,
    },
    /// A surface is a curve or a point, as a whole or in part.
    Collapsed {
        /// The number of the surface, in the order in which they were added.
        surface: usize,
    },
    /// The tolerance needs more pieces than a mesh can have, or is as small as rounding errors of the surface.
    TooFine {
        /// The number of the surface, in the order in which they were added.
        surface: usize,
        /// The highest number of pieces.
        most: usize,
    },
    /// A position is infinite or NaN in single precision, in which the file is written.
    Single {
        /// The position.
        position: usize,
    },
    /// An index of a mesh has no position or no vertex; the first ones.
    Index {
        /// The vertex whose position does not exist.
        vertex: Option<usize>,
        /// The triangle with a vertex that does not exist.
        triangle: Option<usize>,
    },
}

impl Display for MeshError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Tolerance { value } => {
                write!(f, "the tolerance {value} is not a positive, finite number in the unit of length")
            }
            Self::Limit { value } => {
                write!(f, "the limit {value} of the length of edges or of an angle is not a positive number")
            }
            Self::Aspect { value } => {
                write!(
                    f,
                    "sides that are no more than {value} times as long as others: 2 is the least that can be kept"
                )
            }
            Self::NotFinite { surface } => write!(f, "surface {surface} is infinite or NaN"),
            Self::Collapsed { surface } => write!(
                f,
                "surface {surface} is a curve or a point, as a whole or in part, for which no triangles can stand"
            ),
            Self::Single { position } => {
                write!(
                    f,
                    "position {position} is infinite or NaN in single precision: choose a larger unit of length"
                )
            }
            Self::Index { vertex: Some(vertex), .. } => {
                write!(f, "vertex {vertex} has the index of a position that does not exist")
            }
            Self::Index { triangle: Some(triangle), .. } => {
                write!(f, "triangle {triangle} has the index of a vertex that does not exist")
            }
            Self::Index { .. } => f.write_str("an index does not exist"),
            Self::TooFine { surface, most } => {
                write!(f, "surface {surface} would need more than {most} pieces: choose a larger tolerance")
            }
        }
    }
}

impl Error for MeshError {}
