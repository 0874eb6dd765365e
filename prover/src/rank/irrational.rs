//! Ranks at points with irrational coordinates.

use super::table::at;
use crate::algebra::matrix::minor;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::algebraic::Algebraic;
use crate::algebra::work::Work;
use crate::collections::list::{Listed, Mapped};
use crate::collections::sort::sort_unique;
use crate::coordinate::Coordinate;
use crate::sign::decomposition::zeros::is_zero;

/// The rank at a point with irrational coordinates.
pub(super) enum Irrational {
    /// The minor of these columns is not zero.
    Independent(Vec<usize>),
    /// All minors are zero.
    Dependent,
}

/// Whether the rows are independent at a point with irrational coordinates; `None` when the work is spent.
pub(super) fn irrational(
    rows: &[Vec<Poly>],
    point: &[(Var, Coordinate)],
    work: &mut Work,
) -> Option<Irrational> {
    let mut near = Vec::new();
    let mut exact = rows.to_vec();
    let mut algebraic: Vec<(Var, Algebraic)> = Vec::new();
    for (var, c) in point {
        match c {
            Coordinate::Rational(x) => {
                near.push((*var, x.clone()));
                for p in exact.iter_mut().flatten() {
                    *p = p.at(*var, x);
                }
            }
            Coordinate::Algebraic(x) => {
                let mut x = x.clone();
                x.refine_below(&Rational::new(1, 1 << 40), work)?;
                near.push((*var, x.low().clone()));
                algebraic.push((*var, x));
            }
        }
    }
    // Near to the point the largest pivots are those that do not vanish at the point itself.
    let columns = largest_pivots(at(rows, &near), work)?;
    let candidate = minor(&exact, &columns, work)?;
    if !is_zero(&candidate, &algebraic, work)? {
        return Some(Irrational::Independent(columns));
    }
    if rows.first().is_some_and(|r| r.len() == rows.len()) {
        // There is no other minor.
        return Some(Irrational::Dependent);
    }
    // The sum of the squares of all minors is the determinant of the matrix times its transpose (Cauchy–Binet).
    let product =
        |a: &Vec<Poly>, b: &Vec<Poly>| a.iter().zip(b).fold(Poly::zero(), |s, (x, y)| &s + &(x * y));
    let gram: Vec<Vec<Poly>> = exact.mapped(|a| exact.mapped(|b| product(a, b)));
    let all: Vec<usize> = (0..rows.len()).listed();
    let determinant = minor(&gram, &all, work)?;
    is_zero(&determinant, &algebraic, work)?.then_some(Irrational::Dependent)
}

/// The columns of the pivots when always the entry with the greatest absolute value is taken; `None` when the work is
/// spent.
fn largest_pivots(mut rows: Vec<Vec<Rational>>, work: &mut Work) -> Option<Vec<usize>> {
    let mut columns = Vec::new();
    while !rows.is_empty() {
        let entries =
            rows.iter().enumerate().flat_map(|(i, row)| row.iter().enumerate().map(move |(j, x)| (i, j, x)));
        let free = entries.filter(|(_, j, x)| !x.is_zero() && !columns.contains(j));
        let Some((i, j, _)) = free.max_by_key(|(_, _, x)| x.abs()) else { break };
        let pivot = rows.swap_remove(i);
        for row in &mut rows {
            let factor = &row[j] / &pivot[j];
            for (x, p) in row.iter_mut().zip(&pivot) {
                work.spend_fractions(p.bits().max(x.bits()) + factor.bits())?;
                *x -= &(p * &factor);
            }
        }
        columns.push(j);
    }
    sort_unique(&mut columns);
    Some(columns)
}
