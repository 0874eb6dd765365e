//! Inequalities that are linear in dot products of points without coordinates.
//!
//! c + Σ aᵢⱼ dot(Pᵢ, Pⱼ), with numbers for c and the symmetric aᵢⱼ, is ≥ 0 for all points of a space of any dimension if and only if
//! c ≥ 0 and the matrix (aᵢⱼ) is positive semidefinite. If it is, its decomposition L D Lᵀ writes the sum as Σ dₖ |vₖ|² with
//! dₖ > 0 and combinations vₖ of the points; if it is not, there are points on a line at which the sum is negative.

use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::collections::list::Mapped;
use crate::collections::sort::sort_unique;
use crate::decide::Relation;

/// More points are not looked at, nor longer numbers: the entries of the decomposition have as many bits as those of so
/// many rows together.
const MAX_POINTS: usize = 24;
const MAX_BITS: u64 = 1000;

/// The dot products of points that variables stand for.
pub(super) type Products = [(Var, (usize, usize))];

/// A multiple of the square of a vector, d·dot(v, v) with d > 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Square {
    /// The number d.
    pub factor: Rational,
    /// The vector v: for some points, by their numbers, how much of each.
    pub vector: Vec<(usize, Rational)>,
}

/// c + Σ aᵢⱼ dot(Pᵢ, Pⱼ).
pub(super) struct Gram {
    constant: Rational,
    /// The numbers of the points, in increasing order.
    points: Vec<usize>,
    /// aᵢⱼ = aⱼᵢ, by the places of the points in that list.
    matrix: Vec<Vec<Rational>>,
}

impl Gram {
    /// A constant, points, and the symmetric matrix of their dot products.
    pub(super) const fn new(constant: Rational, points: Vec<usize>, matrix: Vec<Vec<Rational>>) -> Self {
        Self { constant, points, matrix }
    }

    /// `None` if the polynomial is not linear in dot products, or contains none.
    pub(super) fn of(polynomial: &Poly, products: &Products) -> Option<Self> {
        let vars = polynomial.variables();
        let pair = |var: &Var| products.iter().find(|(v, _)| v == var).map(|(_, pair)| *pair);
        let pairs: Option<Vec<(usize, usize)>> = vars.iter().map(pair).collect();
        let pairs = pairs?;
        if pairs.is_empty() || polynomial.total_degree() > 1 {
            return None;
        }
        let mut points: Vec<usize> = pairs.iter().flat_map(|(p, q)| [*p, *q]).collect();
        sort_unique(&mut points);
        if points.len() > MAX_POINTS || polynomial.max_bits().saturating_mul(points.len() as u64) > MAX_BITS {
            return None;
        }
        let place = |p: usize| points.iter().position(|q| *q == p);
        let mut matrix = vec![vec![Rational::ZERO; points.len()]; points.len()];
        let mut rest = polynomial.clone();
        let half = Rational::new(1, 2);
        for (var, (p, q)) in vars.iter().zip(&pairs) {
            let coefficient = polynomial.derivative(*var).as_constant()?;
            rest = rest.at(*var, &Rational::ZERO);
            let (i, j) = (place(*p)?, place(*q)?);
            let each = &coefficient * &half;
            matrix[i][j] += &each;
            matrix[j][i] += &each;
        }
        Some(Self { constant: rest.as_constant()?, points, matrix })
    }

    /// The sum as squares, if it is nonnegative, or positive.
    ///
    /// # Errors
    /// Otherwise a place on a line for each of some points, all others at zero, where it is not.
    pub(super) fn decide(&self, relation: Relation) -> Result<Vec<Square>, Vec<(usize, Rational)>> {
        let mut direction = match self.decompose() {
            Ok(squares) if relation.holds(&self.constant) => return Ok(squares),
            // All points are zero.
            Ok(_) => return Err(Vec::new()),
            Err(direction) => direction,
        };
        let form = self.form(&direction);
        if self.constant.is_positive() {
            // m = c/|f| + 1 times as far out m²f outweighs the constant c.
            let far = &Rational::ONE - &(&self.constant / &form);
            direction = direction.mapped(|x| x * &far);
        }
        Err(self.points.iter().copied().zip(direction).collect())
    }

    /// Whether these squares are the sum, and its constant is as claimed.
    #[cfg(any(test, feature = "tools"))]
    pub(super) fn check(&self, relation: Relation, squares: &[Square]) -> Result<(), String> {
        if !relation.holds(&self.constant) {
            return Err(String::from("without the dot products it is not so"));
        }
        let mut rest = self.matrix.clone();
        for Square { factor, vector } in squares {
            if !factor.is_positive() {
                return Err(format!("the factor {factor} of a square is not positive"));
            }
            let place = |p: usize| self.points.iter().position(|q| *q == p);
            let places: Option<Vec<usize>> = vector.iter().map(|(p, _)| place(*p)).collect();
            let places = places.ok_or("a square contains a point that does not occur")?;
            for (i, (_, x)) in places.iter().zip(vector) {
                for (j, (_, y)) in places.iter().zip(vector) {
                    rest[*i][*j] -= &(factor * &(x * y));
                }
            }
        }
        let zero = rest.iter().flatten().all(Rational::is_zero);
        if zero { Ok(()) } else { Err(String::from("the squares are not the sum of the dot products")) }
    }

    /// Σ aᵢⱼ xᵢ xⱼ
    fn form(&self, at: &[Rational]) -> Rational {
        let mut sum = Rational::ZERO;
        for (row, x) in self.matrix.iter().zip(at) {
            for (a, y) in row.iter().zip(at) {
                sum += &(&(a * x) * y);
            }
        }
        sum
    }

    /// The quadratic form of the matrix as a sum of squares.
    ///
    /// # Errors
    /// If it is not positive semidefinite, a vector at which the form is negative.
    fn decompose(&self) -> Result<Vec<Square>, Vec<Rational>> {
        let count = self.points.len();
        let mut rest = self.matrix.clone();
        let mut left: Vec<usize> = (0..count).collect();
        // The rows vₖ, each with the place at which it is 1 and all later ones are 0.
        let mut rows: Vec<(usize, Vec<Rational>)> = Vec::new();
        let mut squares = Vec::new();
        let negative = loop {
            let mut direction = vec![Rational::ZERO; count];
            if let Some(i) = left.iter().find(|i| rest[**i][**i].is_negative()) {
                direction[*i] = Rational::ONE;
                break direction;
            }
            let Some(at) = left.iter().position(|i| rest[*i][*i].is_positive()) else {
                // Nothing is left on the diagonal: any other entry makes the form negative somewhere.
                let entry = left.iter().flat_map(|i| left.iter().map(move |j| (*i, *j)));
                let Some((i, j)) = entry.into_iter().find(|(i, j)| !rest[*i][*j].is_zero()) else {
                    return Ok(squares);
                };
                direction[i] = if rest[i][j].is_negative() { Rational::ONE } else { -&Rational::ONE };
                direction[j] = Rational::ONE;
                break direction;
            };
            let pivot = left.remove(at);
            let factor = rest[pivot][pivot].clone();
            let mut row = vec![Rational::ZERO; count];
            row[pivot] = Rational::ONE;
            for i in &left {
                row[*i] = &rest[pivot][*i] / &factor;
            }
            for i in &left {
                for j in &left {
                    let product = &(&row[*i] * &row[*j]) * &factor;
                    rest[*i][*j] -= &product;
                }
            }
            let vector = self.points.iter().copied().zip(row.iter().cloned());
            squares.push(Square { factor, vector: vector.filter(|(_, x)| !x.is_zero()).collect() });
            rows.push((pivot, row));
        };
        // On the way back every earlier square is made zero.
        let mut direction = negative;
        for (pivot, row) in rows.iter().rev() {
            let sum = row.iter().zip(&direction).fold(Rational::ZERO, |sum, (a, x)| &sum + &(a * x));
            direction[*pivot] = -&sum;
        }
        Err(direction)
    }
}

/// The method of proof in a few words.
pub(super) fn method(squares: &[Square]) -> String {
    format!("a sum of {}", crate::plural::count(squares.len(), "square"))
}
