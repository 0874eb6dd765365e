//! Certificates: plain data from which a claim can be checked without the search that found it.
//!
//! Every certificate speaks of a polynomial p, a relation (p ≥ 0 or p > 0) and a box; [`super::verify`] checks it
//! for given ones. Variables that do not occur in p play no part, and a variable whose range is a single number
//! is replaced by it, in the polynomial of a certificate and of its parts alike.

use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;

/// Why p ≥ 0 or p > 0 on a box.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Certificate {
    /// A range is empty: nothing is claimed.
    Empty,
    /// No variable is left, and the number is as claimed.
    Constant,
    /// The box is cut into cells, and no Bernstein coefficient on a cell is negative; for p > 0 moreover a coefficient
    /// is positive on every face of a cell that belongs to the box.
    Bernstein(Subdivision),
    /// p has degree 1 in a variable, and so lies between its restrictions to the ends of the range; at an infinite
    /// end the coefficient of the variable takes the place of the restriction, with the sign of that end.
    Corners {
        /// The variable.
        var: Var,
        /// For the lower end: p ≥ 0; for p > 0 and an included end p > 0.
        low: Box<Certificate>,
        /// For the upper end.
        high: Box<Certificate>,
        /// When p > 0 is claimed and neither end included: p > 0 at a point of the range.
        middle: Option<(Rational, Box<Certificate>)>,
    },
    /// p is a number times powers of polynomials of known sign.
    Factors {
        /// The number.
        number: Rational,
        /// The polynomials.
        factors: Vec<Factor>,
    },
    /// p > 0 on each of the relatively open faces of the box that belong to it.
    ///
    /// In the order that results from choosing for each variable that occurs, in increasing order and the first one
    /// slowest, first the open range, then the lower and the upper end where they are included.
    Faces(Vec<Certificate>),
    /// Cylindrical decomposition: p ≥ 0 at a point of every open cell on which p has one sign.
    Cells(Cells),
    /// p is not zero on an open box and positive at a point.
    Slices(Slices),
}

/// How a box is cut.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subdivision {
    /// Not at all.
    Leaf,
    /// Into two parts.
    Split {
        /// The variable whose range is cut.
        var: Var,
        /// Where.
        at: Rational,
        /// The part with the lower values.
        low: Box<Subdivision>,
        /// The part with the higher values.
        high: Box<Subdivision>,
    },
}

/// One polynomial of a product.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Factor {
    /// The polynomial f.
    pub base: Poly,
    /// Its exponent.
    pub exponent: u32,
    /// Whether −f instead of f is proved to be ≥ 0 (> 0), and how; nothing is needed for an even power ≥ 0.
    pub sign: Option<(bool, Box<Certificate>)>,
}

/// The projections and sample points of an open cylindrical decomposition.
///
/// The product of the polynomials of a level, with the samples of the lower levels put in, has one root between any
/// two neighbouring samples and none beyond the first and the last: the samples isolate the roots.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cells {
    /// The variables from the lowest level to the highest.
    pub order: Vec<Var>,
    /// By level polynomials in its variable and lower ones. They contain, up to numbers and powers, all factors of
    /// p, and of the leading coefficients, the discriminants, the resultants of pairs and the restrictions to the
    /// ends of the range of the polynomials of the next level.
    pub levels: Vec<Vec<Poly>>,
    /// The sample points.
    pub samples: Vec<Sample>,
}

/// A sample point of one level, with those above it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sample {
    /// The coordinate.
    pub value: Rational,
    /// The samples of the next level; none on the highest level.
    pub above: Vec<Sample>,
}

/// The zeros of p in an open box, searched in slices.
///
/// If p had a zero, its coordinate in each variable would be in a slice, without a zero of p by a certificate of its
/// own, or be one of the irrational sections; p has no zero in small boxes around the points with only such
/// coordinates.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Slices {
    /// One for each variable, or a single one without irrational sections.
    pub bases: Vec<Base>,
    /// For each combination of irrational sections, the first variable slowest, a box: the two ends by variable.
    pub boxes: Vec<Vec<(Rational, Rational)>>,
}

/// The values of one variable at which the zeros of p in the slice can change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Base {
    /// The variables from the lowest level, the one that is cut into slices, to the highest.
    pub order: Vec<Var>,
    /// By level polynomials as in [`Cells`], with three variables or more also for the trailing coefficients.
    pub levels: Vec<Vec<Poly>>,
    /// The roots of the polynomials of the lowest level in the open range, in increasing order.
    pub sections: Vec<Section>,
    /// A number in each of the intervals between them, with a certificate for p > 0 in the slice.
    pub sectors: Vec<(Rational, Certificate)>,
}

/// A root of the polynomials of the lowest level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Section {
    /// A rational number, with a certificate for p > 0 in the slice.
    Exact(Rational, Box<Certificate>),
    /// The only root between two numbers.
    Between(Rational, Rational),
}
