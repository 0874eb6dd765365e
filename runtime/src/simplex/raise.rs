//! Families that are raised from a lowest order: `b[I] = Σ_j x_j b[I - e_j]`, from one order to the next.

use super::SimplexIndex;
use crate::Scalar;

/// The values of the functions `steps` orders higher than `order`. Sums of products of coordinates and values: where both are
/// nonnegative no step is negative, and each adds a relative error of at most `3/2 ε`.
#[inline]
pub fn raise_values<S: Scalar, const B: usize, const N: usize, const K: usize>(
    base: [S; B],
    at: [S; K],
    order: usize,
    steps: usize,
) -> [S; N] {
    let mut values = [S::ZERO; N];
    values[..B].copy_from_slice(&base);
    for order in order..order + steps {
        let before = values;
        values = [S::ZERO; N];
        scatter(&before, &mut values, order, &at);
    }
    values
}

/// `after[I + e_j] += x_j before[I]` for all `I` of the order `n` and all `j`.
#[inline]
fn scatter<S: Scalar>(before: &[S], after: &mut [S], n: usize, at: &[S]) {
    match *at {
        [u, v, w] => {
            let (mut from, mut row) = (0, 0);
            for i in 0..=n {
                let next = row + n - i + 2;
                for j in 0..=n - i {
                    let value = before[from];
                    after[row + j] = after[row + j] + w * value;
                    after[row + j + 1] = after[row + j + 1] + v * value;
                    after[next + j] = after[next + j] + u * value;
                    from += 1;
                }
                row = next;
            }
        }
        [_, _, _, _] => {
            for (index, &value) in SimplexIndex::<4>::all(n).zip(before) {
                for (place, &x) in at.iter().enumerate() {
                    let to = index.up(place).position();
                    after[to] = after[to] + x * value;
                }
            }
        }
        _ => {}
    }
}

/// The Bernstein weights of the functions `steps` orders higher than those of the given order and degree: column `I` of the table belongs to the function `b[I]`, row
/// `α` to the Bernstein coefficient `α`.
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
