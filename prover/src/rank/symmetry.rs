//! Symmetric matrices of functions fall apart: bases of rows and columns that are adapted to a group of permutations.

use basis_kernel::{ChangeOfBasis, Combination};

use crate::algebra::matrix::vanishing_combinations;
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::collections::list::{Listed, Mapped};
use crate::collections::sort::sort_unique;

/// A permutation of the rows together with one of the columns under which a matrix does not change: the entry at
/// (`rows[i]`, `columns[j]`) is that at (i, j).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Symmetry {
    /// By row the row to which it moves.
    pub rows: Vec<usize>,
    /// By column the column to which it moves.
    pub columns: Vec<usize>,
}

/// Sums of symmetries of order 2, such that any two of the sums commute.
///
/// Of a reflection the reflection itself; of all permutations of m things the Jucys–Murphy elements: for each k the sum
/// of the exchanges of k with all that stand before it. Their eigenvalues are whole numbers, and their common
/// eigenspaces are small (A. Jucys 1974; A. Okounkov and A. Vershik, "A new approach to representation theory of
/// symmetric groups", 1996).
pub type Symmetries = Vec<Vec<Symmetry>>;

/// The bases of common eigenvectors, in which a symmetric matrix is zero wherever eigenvalues differ; `None` when the
/// permutations are no symmetries of the matrix, or when there are none.
pub(super) fn adapted(rows: &[Vec<Poly>], symmetries: &Symmetries) -> Option<ChangeOfBasis> {
    let width = rows.first().map_or(0, Vec::len);
    let all = symmetries.iter().flatten();
    if symmetries.is_empty() || !all.clone().all(|s| leaves_unchanged(rows, s)) {
        return None;
    }
    let by_rows: Vec<Vec<&[usize]>> = symmetries.mapped(|sum| sum.mapped(|s| &s.rows[..]));
    let by_columns: Vec<Vec<&[usize]>> = symmetries.mapped(|sum| sum.mapped(|s| &s.columns[..]));
    let (rows, columns) = (eigenvectors(rows.len(), &by_rows)?, eigenvectors(width, &by_columns)?);
    Some(ChangeOfBasis { rows, columns })
}

/// The matrix in the new bases.
pub(super) fn apply(change: &ChangeOfBasis, rows: &[Vec<Poly>]) -> Vec<Vec<Poly>> {
    let width = rows.first().map_or(0, Vec::len);
    let combined = change
        .rows
        .iter()
        .map(|combination| (0..width).map(|c| sum(combination, |r| &rows[r][c])).collect::<Vec<Poly>>());
    combined.map(|row| change.columns.mapped(|combination| sum(combination, |c| &row[c]))).listed()
}

fn sum<'a>(combination: &[(usize, Rational)], entry: impl Fn(usize) -> &'a Poly) -> Poly {
    let scaled = combination.iter().map(|(k, factor)| entry(*k).scale(factor));
    scaled.fold(Poly::zero(), |sum, p| &sum + &p)
}

fn leaves_unchanged(rows: &[Vec<Poly>], symmetry: &Symmetry) -> bool {
    let width = rows.first().map_or(0, Vec::len);
    is_involution(&symmetry.rows, rows.len())
        && is_involution(&symmetry.columns, width)
        && rows.iter().zip(&symmetry.rows).all(|(row, to)| {
            row.iter().zip(&symmetry.columns).all(|(entry, column)| *entry == rows[*to][*column])
        })
}

/// Whether numbers are a permutation of 0..len that is its own inverse.
fn is_involution(permutation: &[usize], len: usize) -> bool {
    permutation.len() == len
        && permutation.iter().enumerate().all(|(from, to)| permutation.get(*to) == Some(&from))
}

/// A basis of 0..len of common eigenvectors of sums of permutations; `None` when their eigenvalues are not whole.
fn eigenvectors(len: usize, sums: &[Vec<&[usize]>]) -> Option<Vec<Combination>> {
    let mut basis = Vec::with_capacity(len);
    let mut seen = vec![false; len];
    for start in 0..len {
        // What the permutations make of one index spans a space that they leave as it is.
        let mut orbit = Vec::new();
        let mut waiting = vec![start];
        while let Some(k) = waiting.pop() {
            if !core::mem::replace(&mut seen[k], true) {
                orbit.push(k);
                waiting.extend(sums.iter().flatten().map(|p| p[k]));
            }
        }
        sort_unique(&mut orbit);
        let unit =
            |i: usize| (0..orbit.len()).map(|k| if k == i { Rational::ONE } else { Rational::ZERO }).listed();
        let mut spaces: Vec<Vec<Vec<Rational>>> = vec![(0..orbit.len()).map(unit).listed()];
        for sum in sums {
            spaces = spaces.into_iter().flat_map(|space| split(&space, &orbit, sum)).listed();
        }
        if spaces.iter().map(Vec::len).sum::<usize>() != orbit.len() {
            return None;
        }
        for vector in spaces.into_iter().flatten() {
            let entries = orbit.iter().copied().zip(vector);
            basis.push(entries.filter(|(_, x)| !x.is_zero()).listed());
        }
    }
    Some(basis)
}

/// The parts of a space that belong to the whole eigenvalues of a sum of permutations.
fn split(space: &[Vec<Rational>], orbit: &[usize], sum: &[&[usize]]) -> Vec<Vec<Vec<Rational>>> {
    // An orbit is sorted, and closed under the permutations.
    let place = |k: usize| orbit.binary_search(&k).unwrap_or(0);
    let largest = sum.len() as i64;
    let parts = (-largest..=largest).rev().map(|eigenvalue| {
        let moved = space.iter().map(|vector| {
            let mut image: Vec<Rational> = vector.mapped(|x| -&(x * &Rational::from(eigenvalue)));
            for permutation in sum {
                for (k, x) in orbit.iter().zip(vector) {
                    image[place(permutation[*k])] += x;
                }
            }
            image
        });
        // An orbit has at most as many elements as there are permutations: 24 on a tetrahedron.
        let combinations =
            vanishing_combinations(&moved.listed(), &mut Work::unlimited()).unwrap_or_default();
        let combine = |factors: Vec<Rational>| {
            let mut vector = vec![Rational::ZERO; orbit.len()];
            for (factor, of) in factors.iter().zip(space) {
                for (x, y) in vector.iter_mut().zip(of) {
                    *x += &(factor * y);
                }
            }
            vector
        };
        combinations.into_iter().map(combine).listed()
    });
    parts.filter(|part| !part.is_empty()).listed()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::poly::Var;

    #[test]
    fn a_reflection_splits_into_even_and_odd() {
        let x = Poly::var(Var(0));
        let n = Poly::integer;
        let rows = vec![vec![n(1), x.clone(), n(0)], vec![n(2), n(3), n(2)], vec![n(0), x.clone(), n(1)]];
        let reflection = Symmetry { rows: vec![2, 1, 0], columns: vec![2, 1, 0] };
        let change = adapted(&rows, &vec![vec![reflection]]).expect("symmetric");
        let one = |k: usize, c: i64| (k, Rational::from(c));
        assert_eq!(change.rows, [vec![one(0, 1), one(2, 1)], vec![one(0, 1), one(2, -1)], vec![one(1, 1)]]);
        let adapted = apply(&change, &rows);
        // Even: (row 0 + row 2, row 1) in (column 0 + column 2, column 1); odd: what is left.
        assert_eq!(adapted[0], [n(2), n(0), x.scale(&2.into())]);
        assert_eq!(adapted[1], [n(0), n(2), n(0)]);
        assert_eq!(adapted[2], [n(4), n(0), n(3)]);
        let wrong = Symmetry { rows: vec![1, 0, 2], columns: vec![2, 1, 0] };
        assert_eq!(super::adapted(&rows, &vec![vec![wrong]]), None);
    }

    #[test]
    fn all_permutations_of_three() {
        // The exchanges of three things as permutations of their six orders.
        let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
        let exchange = |a: usize, b: usize| -> Vec<usize> {
            let moved = orders.map(|o| {
                o.map(|x| {
                    if x == a {
                        b
                    } else if x == b {
                        a
                    } else {
                        x
                    }
                })
            });
            moved.iter().map(|m| orders.iter().position(|o| o == m).expect("an order")).collect()
        };
        let (p, q, r) = (exchange(0, 1), exchange(0, 2), exchange(1, 2));
        let basis = eigenvectors(6, &[vec![&p], vec![&q, &r]]).expect("whole eigenvalues");
        assert_eq!(basis.len(), 6);
        assert!(basis[0].iter().all(|(_, x)| x.is_one()) && basis[0].len() == 6);
        let dense: Vec<Vec<Rational>> = basis
            .iter()
            .map(|v| {
                let mut row = vec![Rational::ZERO; 6];
                for (k, x) in v {
                    row[*k] = x.clone();
                }
                row
            })
            .collect();
        assert_eq!(vanishing_combinations(&dense, &mut Work::unlimited()), Some(vec![]));
    }
}
