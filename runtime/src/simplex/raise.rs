//! The Bernstein weights of families that are raised from a lowest order, `b[I] = Σ_j x_j b[I - e_j]`.

use super::SimplexIndex;
use crate::Scalar;

/// The Bernstein weights of the functions `steps` orders higher than those of the given order and degree: column `I` of
/// the table belongs to the function `b[I]`, row `α` to the Bernstein coefficient `α`.
///
/// Multiplied by `x_j` a polynomial of degree `d` has the coefficients `α_j/(d + 1) c[α - e_j]`.
pub fn raise_weights<S: Scalar, const B: usize, const D: usize, const N: usize, const T: usize>(
    base: [[S; B]; D],
    corners: usize,
    [order, degree]: [usize; 2],
    steps: usize,
) -> [[S; N]; T] {
    let mut table = [[S::ZERO; N]; T];
    for (row, base) in table.iter_mut().zip(&base) {
        row[..B].copy_from_slice(base);
    }
    for step in 0..steps {
        table = match corners {
            3 => raised::<S, N, T, 3>(&table, order + step, degree + step),
            _ => raised::<S, N, T, 4>(&table, order + step, degree + step),
        };
    }
    table
}

fn raised<S: Scalar, const N: usize, const T: usize, const K: usize>(
    table: &[[S; N]; T],
    order: usize,
    degree: usize,
) -> [[S; N]; T] {
    let mut result = [[S::ZERO; N]; T];
    for (alpha, row) in SimplexIndex::<K>::all(degree).zip(table) {
        for place in 0..K {
            let factor = S::from_usize(alpha.components()[place] + 1) / S::from_usize(degree + 1);
            let to = alpha.up(place).position();
            for (index, &weight) in SimplexIndex::<K>::all(order).zip(row) {
                if weight != S::ZERO {
                    let column = index.up(place).position();
                    result[to][column] = result[to][column] + factor * weight;
                }
            }
        }
    }
    result
}
