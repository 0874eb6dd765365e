//! Certificates: how a statement is proved. They say what cannot be computed, such as where to cut a box; whatever the
//! checker computes anyway, such as a coefficient, does not stand in them. Nearly every statement has the empty one.

use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;

/// How a statement is proved.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Certificate {
    /// By computing alone: a value that expands to 0; numerator and denominator whose Bernstein coefficients have one
    /// sign each; a matrix of numbers that has full rank or is positive semidefinite.
    #[default]
    Direct,
    /// The sign of a quotient.
    Sign {
        /// Which sign the denominator has, and why; nothing for a denominator that is a number.
        denominator: Option<Signed>,
        /// Why the numerator, times −1 where the denominator is negative, has the sign that is claimed.
        numerator: SignProof,
    },
    /// The signs of what makes a sum of dot products nonnegative: first the value with all points at the origin, then
    /// the sums of the principal minors of sizes 1, 2, … of its matrix.
    Minors(Vec<SignProof>),
    /// Linear independence.
    Rank(Rank),
}

/// Which sign a polynomial f has, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Signed {
    /// f ≥ 0 (> 0).
    Positive(SignProof),
    /// −f ≥ 0 (> 0).
    Negative(SignProof),
}

/// Why p ≥ 0 or p > 0 on a box.
///
/// Variables that do not occur in p play no part, and a variable whose range is a single number is replaced by it, in p
/// and in all its parts. What is left of p when no variable is left, and anything on an empty box, needs no proof but
/// [`SignProof::direct`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SignProof {
    /// The box is cut into cells, and no Bernstein coefficient on a cell is negative; for p > 0 moreover a coefficient
    /// is positive on every face of a cell that belongs to the box.
    Cuts(Cuts),
    /// p has degree 1 in a variable, and so lies between its restrictions to the ends of the range; at an infinite
    /// end the coefficient of the variable takes the place of the restriction, with the sign of that end.
    Corners {
        /// The variable.
        var: Var,
        /// For the lower end: p ≥ 0; for p > 0 and an included end p > 0.
        low: Box<Self>,
        /// For the upper end.
        high: Box<Self>,
        /// When p > 0 is claimed and neither end included: p > 0 at a point of the range.
        middle: Option<(Rational, Box<Self>)>,
    },
    /// p is a product of powers of polynomials of known sign and of what is left after division by them.
    Factors {
        /// The polynomials, each to the power to which it divides p.
        factors: Vec<(Poly, FactorSign)>,
        /// The sign of what is left.
        rest: Box<Signed>,
    },
    /// p = Σ c·f² + r with numbers c > 0, and r ≥ 0 (> 0).
    Squares {
        /// The numbers c, each with its f.
        squares: Vec<(Rational, Poly)>,
        /// For r.
        rest: Box<Self>,
    },
    /// p > 0 on each of the relatively open faces of the box that belong to it.
    ///
    /// In the order that results from choosing for each variable that occurs, in increasing order and the first one
    /// slowest, first the open range, then the lower and the upper end where they are included.
    Faces(Vec<Self>),
    /// Cylindrical decomposition: p ≥ 0 at a point of every open cell on which p has one sign.
    Cells(Cells),
    /// p is not zero on an open box and positive at a point.
    Slices(Slices),
}

impl SignProof {
    /// The proof by the Bernstein coefficients on the whole box.
    pub const fn direct() -> Self {
        Self::Cuts(Cuts::None)
    }
}

/// The sign of a factor of a product.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FactorSign {
    /// Its power is even, and p ≥ 0 is claimed: the sign does not matter.
    Any,
    /// Its sign is this.
    Known(Box<Signed>),
}

/// How a box is cut: always in the middle of a side, which is the point 1 beyond the end of an infinite side and 0 on a
/// side without ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Cuts {
    /// Not at all, but for sides without ends, which are cut at 0.
    None,
    /// Into two parts.
    At {
        /// The variable whose range is cut.
        var: Var,
        /// The part with the lower values.
        low: Box<Self>,
        /// The part with the higher values.
        high: Box<Self>,
    },
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
    pub above: Vec<Self>,
}

/// The zeros of p in an open box, searched in slices.
///
/// If p had a zero, its coordinate in each variable would be in a slice, without a zero of p by a proof of its own, or
/// be one of the irrational sections; p has no zero in small boxes around the points with only such coordinates.
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
    /// A number in each of the intervals between them, with a proof of p > 0 in the slice.
    pub sectors: Vec<(Rational, SignProof)>,
}

/// A root of the polynomials of the lowest level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Section {
    /// A rational number, with a proof of p > 0 in the slice.
    Exact(Rational, Box<SignProof>),
    /// The only root between two numbers.
    Between(Rational, Rational),
}

/// Why the rows of a matrix are independent on a box but for some exceptions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rank {
    /// For each of the parts into which the exceptions cut the box, in the order of [`crate::pieces`].
    pub pieces: Vec<Piece>,
    /// For each exception polynomials cᵢ, not all zero, with Σ cᵢ·(row i) = 0 where the variables have its values.
    pub exceptions: Vec<Vec<Poly>>,
}

/// Why the rows of a matrix are independent on a box.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// The bases in which the matrix is cut into blocks, if they are not the given ones.
    pub change: Option<ChangeOfBasis>,
    /// The blocks, with all rows, each of them in one block: the rows of a block are zero in the columns of the minors
    /// of all later blocks.
    pub blocks: Vec<Minors>,
}

/// A linear combination of rows, or of columns: indices with their factors.
pub type Combination = Vec<(usize, Rational)>;

/// Other bases for the rows and the columns of a matrix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChangeOfBasis {
    /// The new rows as combinations of the old ones.
    pub rows: Vec<Combination>,
    /// The new columns as combinations of the old ones.
    pub columns: Vec<Combination>,
}

/// Rows of a matrix with minors that do not vanish together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Minors {
    /// The rows.
    pub rows: Vec<usize>,
    /// For each minor its columns, as many as there are rows.
    pub columns: Vec<Vec<usize>>,
    /// For a single minor that it or its negative is positive, for several that the sum of their squares is.
    pub sign: Signed,
}
