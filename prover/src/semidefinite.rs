//! Symmetric matrices: positive semidefinite, or a vector that shows that they are not.

use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::collections::list::Listed;

/// A positive number and a linear form, by its coefficients.
pub(crate) type Square = (Rational, Vec<Rational>);

/// The squares whose sum is the form of a symmetric matrix, each with a positive factor, by a decomposition L D Lᵀ; `None`
/// when the work is spent.
///
/// # Errors
/// If the matrix is not positive semidefinite, a vector x with xᵀA x < 0.
pub fn semidefinite(matrix: &[Vec<Rational>], work: &mut Work) -> Option<Result<Vec<Square>, Vec<Rational>>> {
    let count = matrix.len();
    let mut rest = matrix.to_vec();
    let mut left: Vec<usize> = (0..count).listed();
    // The places at which the rows of Lᵀ are 1 and all later ones are 0.
    let mut pivots: Vec<usize> = Vec::new();
    let mut squares: Vec<Square> = Vec::new();
    let negative = loop {
        let mut direction = vec![Rational::ZERO; count];
        if let Some(i) = left.iter().find(|i| rest[**i][**i].is_negative()) {
            direction[*i] = Rational::ONE;
            break direction;
        }
        let Some(at) = left.iter().position(|i| rest[*i][*i].is_positive()) else {
            // Nothing is left on the diagonal: any other entry makes the form negative somewhere.
            let mut entries = left.iter().flat_map(|i| left.iter().map(move |j| (*i, *j)));
            let Some((i, j)) = entries.find(|(i, j)| !rest[*i][*j].is_zero()) else {
                return Some(Ok(squares));
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
                work.spend_fractions(row[*i].bits() + row[*j].bits() + factor.bits())?;
                rest[*i][*j] -= &(&(&row[*i] * &row[*j]) * &factor);
            }
        }
        pivots.push(pivot);
        squares.push((factor, row));
    };
    // On the way back every earlier square is made zero.
    let mut direction = negative;
    for (pivot, (_, row)) in pivots.iter().zip(&squares).rev() {
        let sum = row.iter().zip(&direction).fold(Rational::ZERO, |sum, (a, x)| &sum + &(a * x));
        direction[*pivot] = -&sum;
    }
    Some(Err(direction))
}
