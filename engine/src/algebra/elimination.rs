//! Gaussian elimination on tables of polynomials: ranks that hold for all values of the variables.

use super::poly::Poly;
use super::rational::Rational;

/// What elimination with constant pivots leaves of a table.
///
/// At every point the rank of the table is the number of pivots plus the rank of the rest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reduced {
    /// The pivots by row and column, in the order in which they were used.
    pub pivots: Vec<(usize, usize)>,
    /// The rows without a pivot.
    pub rows: Vec<usize>,
    /// What is left of them, the columns of the pivots and zero columns left out.
    pub rest: Vec<Vec<Poly>>,
}

/// Eliminates with pivots that are numbers other than zero, as long as there are any; of several the one in the row with
/// the fewest entries.
pub fn reduce(mut table: Vec<Vec<Poly>>) -> Reduced {
    let width = table.first().map_or(0, Vec::len);
    let mut free_rows: Vec<usize> = (0..table.len()).collect();
    let mut free_columns: Vec<usize> = (0..width).collect();
    let mut pivots = Vec::new();
    while let Some((row, column, inverse)) = best_pivot(&table, &free_rows, &free_columns) {
        free_rows.retain(|r| *r != row);
        free_columns.retain(|c| *c != column);
        pivots.push((row, column));
        for &other in &free_rows {
            if table[other][column].is_zero() {
                continue;
            }
            let factor = table[other][column].scale(&inverse);
            for &c in &free_columns {
                if !table[row][c].is_zero() {
                    table[other][c] = &table[other][c] - &(&factor * &table[row][c]);
                }
            }
            table[other][column] = Poly::zero();
        }
    }
    free_columns.retain(|c| free_rows.iter().any(|r| !table[*r][*c].is_zero()));
    let rest =
        free_rows.iter().map(|r| free_columns.iter().map(|c| table[*r][*c].clone()).collect()).collect();
    Reduced { pivots, rows: free_rows, rest }
}

/// The row, the column, and the inverse of a pivot.
fn best_pivot(table: &[Vec<Poly>], rows: &[usize], columns: &[usize]) -> Option<(usize, usize, Rational)> {
    let size = |row: usize| columns.iter().map(|c| table[row][*c].len()).sum::<usize>();
    let mut ordered: Vec<(usize, usize)> = rows.iter().map(|r| (size(*r), *r)).collect();
    ordered.sort_unstable();
    ordered.into_iter().find_map(|(_, row)| {
        columns.iter().find_map(|c| {
            let inverse = table[row][*c].as_constant()?.recip()?;
            Some((row, *c, inverse))
        })
    })
}

/// The determinant of a square table, by fraction-free elimination (Bareiss); `None` when a step is not exact, which a
/// square table does not allow, or the entries become larger than `limit` terms.
pub fn determinant(mut table: Vec<Vec<Poly>>, limit: usize) -> Option<Poly> {
    let n = table.len();
    let mut previous = Poly::one();
    let mut negative = false;
    for k in 0..n {
        let pivot = (k..n).filter(|r| !table[*r][k].is_zero()).min_by_key(|r| table[*r][k].len());
        let Some(pivot) = pivot else { return Some(Poly::zero()) };
        if pivot != k {
            table.swap(pivot, k);
            negative = !negative;
        }
        for i in k + 1..n {
            for j in k + 1..n {
                let (a, b) = (table[k][k].len() * table[i][j].len(), table[i][k].len() * table[k][j].len());
                if a.max(b) > limit {
                    return None;
                }
                let minor = &(&table[k][k] * &table[i][j]) - &(&table[i][k] * &table[k][j]);
                table[i][j] = minor.div_exact(&previous)?;
            }
        }
        previous = table[k][k].clone();
    }
    Some(if negative { -&previous } else { previous })
}

/// det(S·Sᵀ), the sum of the squares of all maximal minors of S (Cauchy–Binet): zero exactly where the rows are dependent.
pub fn gram_determinant(rows: &[Vec<Poly>], limit: usize) -> Option<Poly> {
    let product = |a: &[Poly], b: &[Poly]| a.iter().zip(b).fold(Poly::zero(), |sum, (x, y)| &sum + &(x * y));
    let gram = rows.iter().map(|a| rows.iter().map(|b| product(a, b)).collect()).collect();
    determinant(gram, limit)
}

/// Whole numbers without a common factor, not all zero, with which the rows of a table of numbers sum to zero; `None`
/// when the rows are independent.
pub fn dependency(table: &[Vec<Rational>]) -> Option<Vec<Rational>> {
    let n = table.len();
    let width = table.first().map_or(0, Vec::len);
    // Each row carries along how it was combined.
    let mut rows: Vec<Vec<Rational>> = table
        .iter()
        .enumerate()
        .map(|(k, row)| {
            let unit = (0..n).map(|i| if i == k { Rational::ONE } else { Rational::ZERO });
            row.iter().cloned().chain(unit).collect()
        })
        .collect();
    let mut done = 0;
    for column in 0..width {
        let Some(pivot) = (done..n).find(|r| !rows[*r][column].is_zero()) else { continue };
        rows.swap(done, pivot);
        let pivot_row = rows[done].clone();
        for row in &mut rows[done + 1..] {
            let Some(factor) = row[column].checked_div(&pivot_row[column]).filter(|f| !f.is_zero()) else {
                continue;
            };
            for (x, p) in row.iter_mut().zip(&pivot_row) {
                if !p.is_zero() {
                    *x -= &(&factor * p);
                }
            }
        }
        done += 1;
    }
    let combination = rows.get(done)?[width..].to_vec();
    let content = combination.iter().fold(Rational::ZERO, |g, x| g.gcd(x));
    let first = combination.iter().find(|x| !x.is_zero())?;
    let factor = if first.is_negative() { -content } else { content };
    combination.iter().map(|x| x.checked_div(&factor)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::poly::Var;

    fn table(rows: &[&[i64]]) -> Vec<Vec<Poly>> {
        rows.iter().map(|r| r.iter().map(|x| Poly::integer(*x)).collect()).collect()
    }

    #[test]
    fn determinants_are_exact() {
        let x = Poly::var(Var(0));
        let t = vec![vec![x.clone(), Poly::one()], vec![Poly::one(), x.clone()]];
        assert_eq!(determinant(t, 1000), Some(&x.pow(2) - &Poly::one()));
        assert_eq!(determinant(table(&[&[0, 2, 1], &[1, 0, 3], &[2, 1, 0]]), 1000), Some(Poly::integer(13)));
        assert_eq!(determinant(table(&[&[1, 2], &[2, 4]]), 1000), Some(Poly::zero()));
    }

    #[test]
    fn constant_pivots_leave_what_depends_on_variables() {
        let x = Poly::var(Var(0));
        let reduced = reduce(vec![
            vec![Poly::one(), x.clone(), Poly::zero()],
            vec![Poly::integer(2), &x.scale(&Rational::from(2)) + &x, Poly::zero()],
        ]);
        assert_eq!(reduced.pivots, [(0, 0)]);
        assert_eq!(reduced.rest, [[x.clone()]]);
        assert_eq!(gram_determinant(&reduced.rest, 1000), Some(x.pow(2)));
    }

    #[test]
    fn dependencies_are_small_whole_numbers() {
        let r = |n: i64, d: i64| Rational::new(n, d);
        let rows = [vec![r(1, 2), r(1, 3)], vec![r(1, 1), r(1, 1)], vec![r(3, 2), r(4, 3)]];
        assert_eq!(dependency(&rows), Some(vec![r(1, 1), r(1, 1), r(-1, 1)]));
        assert_eq!(dependency(&rows[..2]), None);
    }
}
