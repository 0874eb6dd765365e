//! Sums of dot products of points, for all points of a space of any dimension.
//!
//! **Theorem.** c + Σ aᵢⱼ pᵢ·pⱼ ≥ 0 (> 0) for all points pᵢ if and only if c ≥ 0 (> 0) and the symmetric matrix A =
//! (aᵢⱼ) is positive semidefinite. That it is can be seen from a decomposition L D Lᵀ with D ≥ 0, or from e₁, …, eₙ ≥
//! 0, where eₖ is the sum of its principal minors of size k.
//!
//! *Proof.* The sum of the forms in each coordinate is c + Σ xᵀA x; far out c does not matter. det(λ + A) = Σ eₖ λⁿ⁻ᵏ
//! has no positive root if no eₖ is negative, so that A has no negative eigenvalue; and the eₖ are the elementary
//! symmetric functions of the eigenvalues.

use crate::algebra::poly::{Monomial, Poly};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::collections::sort::sort_unique;
use crate::refusal::{Refusal, fits};
use crate::statement::{Products, Relation};

/// More points are not looked at.
const MAX_POINTS: usize = 64;

/// c + Σ aᵢⱼ pᵢ·pⱼ.
#[derive(Clone, Debug)]
pub struct Gram {
    constant: Poly,
    matrix: Vec<Vec<Poly>>,
}

impl Gram {
    /// The matrix of the points that occur, in increasing order of their numbers.
    ///
    /// # Errors
    /// When the value is not of degree 1 in dot products, there are too many points, or the work is spent.
    pub fn of(value: &Poly, products: &Products, work: &mut Work) -> Result<Self, Refusal> {
        let mut points: Vec<usize> = products.iter().flat_map(|(_, (p, q))| [*p, *q]).collect();
        sort_unique(&mut points);
        fits(points.len() <= MAX_POINTS, "there are too many points")?;
        let place = |p: usize| points.binary_search(&p).unwrap_or(0);
        let mut matrix = vec![vec![Poly::zero(); points.len()]; points.len()];
        let mut constant = Poly::zero();
        let half = Rational::new(1, 2);
        for (monomial, coefficient) in value.terms() {
            work.spend(1 + products.len() as u64).ok_or(Refusal::Spent)?;
            let mut occurring = products.iter().filter(|(v, _)| monomial.exponent(*v) > 0);
            let term = |m: Monomial| Poly::term(m, coefficient.clone());
            match (occurring.next(), occurring.next()) {
                (None, _) => constant = &constant + &term(monomial.clone()),
                (Some((var, (p, q))), None) if monomial.exponent(*var) == 1 => {
                    let half = term(monomial.with_exponent(*var, 0)).scale(&half);
                    for (i, j) in [(place(*p), place(*q)), (place(*q), place(*p))] {
                        matrix[i][j] = &matrix[i][j] + &half;
                    }
                }
                _ => return Err(Refusal::Unfit("the value is not linear in the dot products")),
            }
        }
        Ok(Self { constant, matrix })
    }

    /// The constant and the matrix, if no variable is left in them.
    pub(super) fn numbers(&self) -> Option<(Rational, Vec<Vec<Rational>>)> {
        let row = |row: &Vec<Poly>| row.iter().map(Poly::as_constant).collect::<Option<Vec<_>>>();
        Some((self.constant.as_constant()?, self.matrix.iter().map(row).collect::<Option<_>>()?))
    }

    /// What must be ≥ 0 (> 0): the constant, and the sums of the principal minors of each size.
    ///
    /// By Faddeev and LeVerrier: with N₀ = I, eₖ = tr(A Nₖ₋₁)/k and Nₖ = eₖ I − A Nₖ₋₁.
    ///
    /// # Errors
    /// When the work is spent.
    pub fn signs(&self, relation: Relation, work: &mut Work) -> Result<Vec<(Poly, Relation)>, Refusal> {
        let a = &self.matrix;
        let mut all = vec![(self.constant.clone(), relation)];
        // A Nₖ₋₁
        let mut product = a.clone();
        for k in 1..=a.len() {
            let trace = (0..a.len()).fold(Poly::zero(), |sum, i| &sum + &product[i][i]);
            let sum = trace.scale(&Rational::new(1, k as i64));
            let mut next = vec![vec![Poly::zero(); a.len()]; a.len()];
            for (i, row) in next.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    work.spend_product(&a[i][j], &sum).ok_or(Refusal::Spent)?;
                    *entry = &a[i][j] * &sum;
                    for (x, y) in a[i].iter().zip(&product) {
                        work.spend_product(x, &y[j]).ok_or(Refusal::Spent)?;
                        *entry = &*entry - &(x * &y[j]);
                    }
                }
            }
            all.push((sum, Relation::NonNegative));
            product = next;
        }
        Ok(all)
    }
}

/// Whether a symmetric matrix is positive semidefinite, by a decomposition L D Lᵀ; `None` when the work is spent.
pub(super) fn is_semidefinite(mut rest: Vec<Vec<Rational>>, work: &mut Work) -> Option<bool> {
    while let Some(k) = (0..rest.len()).find(|k| rest[*k][*k].is_positive()) {
        let mut row = rest.swap_remove(k);
        let pivot = row.swap_remove(k);
        for other in &mut rest {
            let factor = &other.swap_remove(k) / &pivot;
            for (x, p) in other.iter_mut().zip(&row) {
                work.spend_fractions(factor.bits() + p.bits())?;
                *x -= &(&factor * p);
            }
        }
    }
    // Nothing positive is left on the diagonal: any entry that is not zero makes the form negative somewhere.
    Some(rest.iter().flatten().all(Rational::is_zero))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_is_semidefinite_if_no_vector_has_a_negative_square() {
        let decide = |rows: &[&[i64]]| {
            let rows = rows.iter().map(|row| row.iter().map(|x| Rational::from(*x)).collect()).collect();
            is_semidefinite(rows, &mut Work::unlimited())
        };
        assert_eq!(decide(&[&[2, 3], &[3, 5]]), Some(true));
        assert_eq!(decide(&[&[2, 3], &[3, 4]]), Some(false)); // 4·2 < 3·3
        assert_eq!(decide(&[&[4, 6], &[6, 9]]), Some(true));
        assert_eq!(decide(&[&[0, 1], &[1, 0]]), Some(false));
        assert_eq!(decide(&[&[0, 0], &[0, -1]]), Some(false));
        assert_eq!(decide(&[&[2, 1, 5], &[1, 3, 5], &[5, 5, 15]]), Some(true)); // of determinant 0
        assert_eq!(decide(&[&[2, 1, 5], &[1, 3, 5], &[5, 5, 14]]), Some(false));
        let one =
            || vec![vec![Rational::from(1), Rational::from(2)], vec![Rational::from(2), Rational::from(5)]];
        assert_eq!(is_semidefinite(one(), &mut Work::new(0)), None);
    }
}
