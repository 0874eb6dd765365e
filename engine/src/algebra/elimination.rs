//! Gaussian elimination on tables of polynomials: ranks that hold for all values of the variables.

use super::gcd::gcd_all;
use super::poly::Poly;
use super::rational::Rational;
use super::work::Work;

/// What elimination leaves of a table.
///
/// At every point at which the pivots are not zero, the rank of the table is the number of pivots plus the rank of the
/// rest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reduced {
    /// The pivots by row and column, with their values, in the order in which they were used.
    pub pivots: Vec<(usize, usize, Poly)>,
    /// What is left of the rows without a pivot, the columns of the pivots and zero columns left out.
    pub rest: Vec<Vec<Poly>>,
}

/// Eliminates with pivots that vanish nowhere, numbers first, as long as there are any; `nonzero` says of a polynomial
/// whether it is known to vanish nowhere where it matters. `None` when the work is spent.
pub fn reduce(
    mut table: Vec<Vec<Poly>>,
    nonzero: &mut dyn FnMut(&Poly) -> bool,
    work: &mut Work,
) -> Option<Reduced> {
    let width = table.first().map_or(0, Vec::len);
    let mut free_rows: Vec<usize> = (0..table.len()).collect();
    let mut free_columns: Vec<usize> = (0..width).collect();
    let mut pivots = Vec::new();
    while let Some((row, column)) = best_pivot(&table, &free_rows, &free_columns, nonzero) {
        let pivot = table[row][column].clone();
        free_rows.retain(|r| *r != row);
        free_columns.retain(|c| *c != column);
        for &other in &free_rows {
            let factor = core::mem::replace(&mut table[other][column], Poly::zero());
            if factor.is_zero() {
                continue;
            }
            for &c in &free_columns {
                let (a, b) = (&table[other][c], &table[row][c]);
                if a.is_zero() && b.is_zero() {
                    continue;
                }
                work.spend_product(&pivot, a)?;
                work.spend_product(&factor, b)?;
                table[other][c] = &(&pivot * a) - &(&factor * b);
            }
            shorten(&mut table[other], &free_columns, nonzero, work)?;
        }
        pivots.push((row, column, pivot));
    }
    free_columns.retain(|c| free_rows.iter().any(|r| !table[*r][*c].is_zero()));
    let rest =
        free_rows.iter().map(|r| free_columns.iter().map(|c| table[*r][*c].clone()).collect()).collect();
    Some(Reduced { pivots, rest })
}

/// Divides a row by numbers, and by a common divisor that vanishes nowhere.
fn shorten(
    row: &mut [Poly],
    columns: &[usize],
    nonzero: &mut dyn FnMut(&Poly) -> bool,
    work: &mut Work,
) -> Option<()> {
    let content = columns.iter().fold(Rational::ZERO, |g, c| g.gcd(&row[*c].numeric_content()));
    let Some(factor) = content.recip() else { return Some(()) };
    let common = gcd_all(columns.iter().map(|c| &row[*c]), work)?;
    let divide = common.as_constant().is_none() && nonzero(&common);
    for &c in columns {
        let entry = row[c].scale(&factor);
        row[c] = if divide { entry.div_exact(&common).unwrap_or(entry) } else { entry };
    }
    Some(())
}

/// The row and column of a pivot: the shortest entry that vanishes nowhere, in the row with the fewest terms.
fn best_pivot(
    table: &[Vec<Poly>],
    rows: &[usize],
    columns: &[usize],
    nonzero: &mut dyn FnMut(&Poly) -> bool,
) -> Option<(usize, usize)> {
    let size = |row: usize| columns.iter().map(|c| table[row][*c].len()).sum::<usize>();
    let mut ordered: Vec<(usize, usize)> = rows.iter().map(|r| (size(*r), *r)).collect();
    ordered.sort_unstable();
    let constant = |entry: &Poly| entry.as_constant().is_some_and(|c| !c.is_zero());
    for (_, row) in &ordered {
        if let Some(column) = columns.iter().find(|c| constant(&table[*row][**c])) {
            return Some((*row, *column));
        }
    }
    for (_, row) in &ordered {
        let mut entries: Vec<usize> =
            columns.iter().copied().filter(|c| !table[*row][*c].is_zero()).collect();
        entries.sort_by_key(|c| (table[*row][*c].len(), table[*row][*c].total_degree()));
        if let Some(column) = entries.into_iter().take(3).find(|c| nonzero(&table[*row][*c])) {
            return Some((*row, column));
        }
    }
    None
}

/// The determinant of a square table, by fraction-free elimination (Bareiss); `None` when a step is not exact, which a
/// square table does not allow, or the work is spent.
pub fn determinant(mut table: Vec<Vec<Poly>>, work: &mut Work) -> Option<Poly> {
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
                work.spend_product(&table[k][k], &table[i][j])?;
                work.spend_product(&table[i][k], &table[k][j])?;
                let minor = &(&table[k][k] * &table[i][j]) - &(&table[i][k] * &table[k][j]);
                table[i][j] = minor.div_exact(&previous)?;
            }
        }
        previous = table[k][k].clone();
    }
    Some(if negative { -&previous } else { previous })
}

/// det(S·Sᵀ), the sum of the squares of all maximal minors of S (Cauchy–Binet): zero exactly where the rows are dependent.
pub fn gram_determinant(rows: &[Vec<Poly>], work: &mut Work) -> Option<Poly> {
    let mut gram = Vec::new();
    for a in rows {
        let mut line = Vec::new();
        for b in rows {
            let mut sum = Poly::zero();
            for (x, y) in a.iter().zip(b) {
                work.spend_product(x, y)?;
                sum = &sum + &(x * y);
            }
            line.push(sum);
        }
        gram.push(line);
    }
    determinant(gram, work)
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
        let work = &mut Work::new(10_000);
        let x = Poly::var(Var(0));
        let t = vec![vec![x.clone(), Poly::one()], vec![Poly::one(), x.clone()]];
        assert_eq!(determinant(t, work), Some(&x.pow(2) - &Poly::one()));
        assert_eq!(determinant(table(&[&[0, 2, 1], &[1, 0, 3], &[2, 1, 0]]), work), Some(Poly::integer(13)));
        assert_eq!(determinant(table(&[&[1, 2], &[2, 4]]), work), Some(Poly::zero()));
        assert_eq!(determinant(table(&[&[1, 2], &[2, 5]]), &mut Work::new(0)), None);
    }

    #[test]
    fn pivots_that_vanish_nowhere_leave_what_matters() {
        let x = Poly::var(Var(0));
        let rows = vec![
            vec![Poly::one(), x.clone(), Poly::zero()],
            vec![Poly::integer(2), x.scale(&Rational::from(3)), Poly::zero()],
        ];
        let work = &mut Work::new(10_000);
        let reduced = reduce(rows.clone(), &mut |_| false, work).expect("little work");
        assert_eq!(reduced.pivots, [(0, 0, Poly::one())]);
        assert_eq!(reduced.rest, [[x.clone()]]);
        assert_eq!(gram_determinant(&reduced.rest, work), Some(x.pow(2)));
        let reduced = reduce(rows, &mut |p| *p == Poly::var(Var(0)), work).expect("little work");
        assert!(reduced.rest.is_empty());
    }

    #[test]
    fn dependencies_are_small_whole_numbers() {
        let r = |n: i64, d: i64| Rational::new(n, d);
        let rows = [vec![r(1, 2), r(1, 3)], vec![r(1, 1), r(1, 1)], vec![r(3, 2), r(4, 3)]];
        assert_eq!(dependency(&rows), Some(vec![r(1, 1), r(1, 1), r(-1, 1)]));
        assert_eq!(dependency(&rows[..2]), None);
    }
}
