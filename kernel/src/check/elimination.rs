//! Resultants.
//!
//! **Theorem.** The resultant of a and b in x is the determinant of their Sylvester matrix. It is a polynomial in the
//! other variables whose degree in y is at most deg_y a · deg_x b + deg_y b · deg_x a; so its values on a grid with one
//! more point for each variable determine it.

use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::collections::sort::sort;
use crate::refusal::{Refusal, fits};

/// The largest matrix.
const MAX_SIZE: u32 = 120;
/// The most points of a grid.
const MAX_POINTS: u32 = 40_000;

/// The determinant of the Sylvester matrix of two polynomials of positive degree in a variable, up to its sign.
pub(super) fn resultant(a: &Poly, b: &Poly, var: Var, work: &mut Work) -> Result<Poly, Refusal> {
    let size = a.degree(var) + b.degree(var);
    fits(size <= MAX_SIZE, "a resultant is too large")?;
    let others: Vec<Var> = a.variables().into_iter().chain(b.variables()).filter(|v| *v != var).collect();
    let bound = |v: Var| a.degree(v) * b.degree(var) + b.degree(v) * a.degree(var);
    let mut grid: Vec<(Var, u32)> = others.into_iter().map(|v| (v, bound(v) + 1)).collect();
    sort(&mut grid);
    grid.dedup();
    let points = grid.iter().try_fold(1_u32, |n, (_, c)| n.checked_mul(*c).filter(|n| *n <= MAX_POINTS));
    let points = u64::from(points.ok_or(Refusal::Unfit("a resultant is too large"))?);
    work.spend(cost(a, b, size, points)).ok_or(Refusal::Spent)?;
    // A factor of the rows does not matter: whole numbers are fast.
    Ok(on_grid(&a.normalized(), &b.normalized(), var, &grid, (a.degree(var), b.degree(var))))
}

/// Of elimination, and of the interpolation of polynomials with as many terms as there are points.
fn cost(a: &Poly, b: &Poly, size: u32, points: u64) -> u64 {
    // A number up to 40 000 in place of a variable has 16 bits.
    let nodes = 16 * (u64::from(a.total_degree()) + u64::from(b.total_degree()));
    let words = 1 + u64::from(size) * (a.max_bits() + b.max_bits() + nodes) / 64;
    points.saturating_mul(u64::from(size).pow(3) / 3 + points).saturating_mul(words)
}

fn on_grid(a: &Poly, b: &Poly, var: Var, grid: &[(Var, u32)], degrees: (u32, u32)) -> Poly {
    let Some(((other, count), rest)) = grid.split_first() else {
        return Poly::constant(sylvester(a, b, var, degrees));
    };
    // Lagrange: Σ value(k) ∏ (x − j)/(k − j) at x = 0, 1, …
    let mut sum = Poly::zero();
    let x = Poly::var(*other);
    let all = (0..*count).fold(Poly::one(), |p, j| &p * &(&x - &Poly::integer(i64::from(j))));
    for k in 0..*count {
        let node = Rational::from(i64::from(k));
        let value = on_grid(&a.at(*other, &node), &b.at(*other, &node), var, rest, degrees);
        let Some(without) = all.div_exact(&(&x - &Poly::integer(i64::from(k)))) else { continue };
        let scale = without.at(*other, &node).as_constant().and_then(|c| c.recip());
        let Some(scale) = scale else { continue };
        sum = &sum + &(&value * &without.scale(&scale));
    }
    sum
}

/// The determinant for polynomials in one variable of formal degrees m and n.
fn sylvester(a: &Poly, b: &Poly, var: Var, (m, n): (u32, u32)) -> Rational {
    let (m, n) = (m as usize, n as usize);
    let row = |p: &Poly, degree: usize, shift: usize| {
        let mut row = vec![Rational::ZERO; m + n];
        for (k, c) in p.coefficients_in(var).iter().enumerate() {
            row[shift + degree - k] = c.as_constant().unwrap_or(Rational::ZERO);
        }
        row
    };
    let mut rows: Vec<Vec<Rational>> = (0..n).map(|k| row(a, m, k)).collect();
    rows.extend((0..m).map(|k| row(b, n, k)));
    // Elimination with exact division by the pivot before (Bareiss); the last pivot is the determinant.
    let mut last = Rational::ONE;
    let mut swapped = false;
    for k in 0..m + n {
        let Some(pivot) = (k..m + n).find(|i| !rows[*i][k].is_zero()) else { return Rational::ZERO };
        rows.swap(k, pivot);
        swapped ^= k != pivot;
        let (upper, lower) = rows.split_at_mut(k + 1);
        let top = &upper[k];
        for row in lower {
            for j in k + 1..m + n {
                row[j] = &(&(&row[j] * &top[k]) - &(&row[k] * &top[j])) / &last;
            }
            row[k] = Rational::ZERO;
        }
        last = top[k].clone();
    }
    if swapped { -last } else { last }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn discriminants_and_common_roots() {
        let (x, y) = (Poly::var(Var(0)), Poly::var(Var(1)));
        let work = &mut Work::unlimited();
        // x² + y x + 3 and its derivative: 12 − y², up to a number.
        let p = &(&x.pow(2) + &(&x * &y)) + &Poly::integer(3);
        let found = resultant(&p, &p.derivative(Var(0)), Var(0), work).expect("small");
        assert_eq!(found.normalized(), (&y.pow(2) - &Poly::integer(12)).normalized());
        // (x − y)(x + 1) and x + y have a common root where y = 0 and y = 1.
        let (a, b) = (&(&x - &y) * &(&x + &Poly::one()), &x + &y);
        let found = resultant(&a, &b, Var(0), work).expect("small");
        assert_eq!(found.normalized(), (&y * &(&y - &Poly::one())).normalized());
        assert_eq!(resultant(&a, &b, Var(0), &mut Work::new(3)), Err(Refusal::Spent));
    }

    /// Of the highest degrees that they can have, in one polynomial alone, and beyond the largest matrix.
    #[test]
    fn degrees_of_resultants() {
        let (x, y) = (Poly::var(Var(0)), Poly::var(Var(1)));
        let work = &mut Work::unlimited();
        let mut of = |a: &Poly, b: &Poly| resultant(a, b, Var(0), work).map(|p| p.normalized());
        let (a, b) = (&x.pow(2) + &y.pow(3), &(&x.pow(2) * &y.pow(3)) + &Poly::one());
        assert_eq!(of(&a, &b), Ok((&y.pow(6) - &Poly::one()).pow(2)));
        assert_eq!(of(&b, &a), Ok((&y.pow(6) - &Poly::one()).pow(2)));
        let (a, b) = (&x.pow(2) + &Poly::one(), &x - &y);
        assert_eq!(of(&a, &b), Ok(&y.pow(2) + &Poly::one()));
        assert_eq!(of(&b, &a), Ok(&y.pow(2) + &Poly::one()));
        // At y = 0 rows are exchanged.
        let a = &(&(&x.pow(2) * &y) + &x) + &Poly::one();
        let expected = &(&Poly::one() - &y.pow(2)).pow(2) + &y;
        assert_eq!(of(&a, &(&x.pow(2) + &y)), Ok(expected));
        let high = |degree| &x.pow(degree) + &Poly::one();
        assert_eq!(of(&high(119), &(&x - &Poly::integer(2))), Ok(Poly::one()));
        assert_eq!(
            of(&high(120), &(&x - &Poly::integer(2))),
            Err(Refusal::Unfit("a resultant is too large"))
        );
    }
}
