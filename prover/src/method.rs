//! The methods of proof.

use core::fmt;

/// How a claim was proved, in increasing order of effort.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Method {
    /// The value of a number.
    Constant,
    /// Signs of Bernstein coefficients.
    Coefficients,
    /// Restrictions to the ends of ranges of variables of degree 1.
    Corners,
    /// Signs of the factors of a product.
    Factors,
    /// Descartes' rule of signs.
    Descartes,
    /// Bernstein coefficients on the cells of a subdivision.
    Subdivision,
    /// Each face of the box for itself.
    Faces,
    /// Open cylindrical decomposition.
    Cells,
    /// A decomposition of a sum of dot products into squares.
    Squares,
    /// Minors of a matrix that do not vanish together.
    Minors,
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Constant => "constant",
            Self::Coefficients => "Bernstein coefficients",
            Self::Corners => "corners",
            Self::Factors => "factors",
            Self::Descartes => "Descartes",
            Self::Subdivision => "subdivision",
            Self::Faces => "faces",
            Self::Cells => "cylindrical decomposition",
            Self::Squares => "a sum of squares",
            Self::Minors => "minors",
        })
    }
}
