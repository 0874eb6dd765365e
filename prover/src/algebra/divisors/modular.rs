//! Images modulo a prime: cheap proofs that two polynomials have no common factor, or that a determinant is not zero.

use crate::algebra::number::modulo;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::{Spent, Work};

/// The prime 2³¹ − 1: products of two residues fit in a machine word.
pub(in crate::algebra) const PRIME: u64 = 2_147_483_647;

/// The degree in `main` of the greatest common divisor of the images of two polynomials modulo [`PRIME`], with
/// fixed numbers put in place of the other variables.
///
/// The degree in `main` of the true greatest common divisor is at most this. `None` when an image loses its
/// degree, so that it proves nothing.
pub(super) fn common_degree(a: &Poly, b: &Poly, main: Var) -> Option<usize> {
    (0..3).find_map(|attempt| {
        let (f, g) = (image(a, main, attempt)?, image(b, main, attempt)?);
        (f.len() == a.degree(main) as usize + 1 && g.len() == b.degree(main) as usize + 1)
            .then(|| gcd_degree(f, g))
    })
}

/// The residue that stands for a variable.
fn number(var: usize, attempt: u64) -> u64 {
    // Residues without small multiplicative relations between them.
    (var as u64 + 2).wrapping_mul(715_827_881 + 48_271 * attempt) % PRIME
}

/// The coefficients of the image, constant first, without leading zeros; `None` when the prime divides a
/// denominator.
pub(super) fn image(poly: &Poly, main: Var, attempt: u64) -> Option<Vec<u64>> {
    let mut result = vec![0; poly.degree(main) as usize + 1];
    for (m, c) in poly.terms() {
        let mut value = u64::from(modulo(c, PRIME as u32)?);
        for (i, e) in m.exponents().iter().enumerate() {
            if *e > 0 && i != main.0 {
                value = value * power(number(i, attempt), u64::from(*e)) % PRIME;
            }
        }
        let slot = &mut result[usize::from(m.exponent(main))];
        *slot = (*slot + value) % PRIME;
    }
    trim(&mut result);
    Some(result)
}

/// The columns in which an elimination modulo [`PRIME`] finds its pivots; `None` when the prime divides
/// a denominator.
///
/// The minor of these columns and of as many rows is not zero; the rank may be greater.
///
/// # Errors
/// When the work is spent.
pub(in crate::algebra) fn pivot_columns(
    rows: &[Vec<Rational>],
    work: &mut Work,
) -> Result<Option<Vec<usize>>, Spent> {
    let residue = |x: &Rational| modulo(x, PRIME as u32).map(u64::from);
    let images: Option<Vec<Vec<u64>>> = rows.iter().map(|row| row.iter().map(residue).collect()).collect();
    let Some(mut rows) = images else { return Ok(None) };
    let width = rows.first().map_or(0, Vec::len);
    let mut columns = Vec::new();
    for column in 0..width {
        let done = columns.len();
        let Some(pivot) = (done..rows.len()).find(|r| rows[*r][column] != 0) else { continue };
        rows.swap(done, pivot);
        let (upper, lower) = rows.split_at_mut(done + 1);
        let pivot = &upper[done][column..];
        let inverse = power(pivot[0], PRIME - 2);
        for row in lower {
            let row = &mut row[column..];
            if row[0] == 0 {
                continue;
            }
            // Several of these are one product of numbers.
            work.spend(row.len() as u64 / 8 + 1).ok_or(Spent)?;
            let factor = PRIME - row[0] * inverse % PRIME;
            for (x, p) in row.iter_mut().zip(pivot) {
                *x = (*x + p * factor) % PRIME;
            }
        }
        columns.push(column);
        if columns.len() == rows.len() {
            break;
        }
    }
    Ok(Some(columns))
}

fn power(mut base: u64, mut e: u64) -> u64 {
    let mut result = 1;
    while e > 0 {
        if e & 1 == 1 {
            result = result * base % PRIME;
        }
        base = base * base % PRIME;
        e >>= 1;
    }
    result
}

fn trim(coefficients: &mut Vec<u64>) {
    while coefficients.last() == Some(&0) {
        coefficients.pop();
    }
}

/// The degree of the greatest common divisor of two polynomials over the field of residues, not both 0.
fn gcd_degree(mut a: Vec<u64>, mut b: Vec<u64>) -> usize {
    while let Some(lead) = b.last() {
        let inverse = power(*lead, PRIME - 2);
        while a.len() >= b.len() {
            let Some(top) = a.pop() else { break };
            let factor = PRIME - top * inverse % PRIME;
            let shift = a.len() + 1 - b.len();
            for (k, c) in b.iter().take(b.len() - 1).enumerate() {
                a[k + shift] = (a[k + shift] + c * factor) % PRIME;
            }
        }
        trim(&mut a);
        core::mem::swap(&mut a, &mut b);
    }
    a.len().saturating_sub(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_of_common_factors() {
        let (x, y) = (Poly::var(Var(0)), Poly::var(Var(1)));
        let a = &(&x - &y) * &(&x + &Poly::integer(2));
        let b = &(&x - &y) * &(&y + &Poly::integer(3));
        assert_eq!(common_degree(&a, &b, Var(0)), Some(1));
        assert_eq!(common_degree(&a, &b, Var(1)), Some(1));
        assert_eq!(common_degree(&a, &(&x + &y), Var(0)), Some(0));
        // The prime divides the leading coefficient.
        let lost = &x.scale(&PRIME.to_string().parse::<i64>().map_or(1.into(), Into::into)) + &Poly::one();
        assert_eq!(common_degree(&lost, &x, Var(0)), None);
    }
}
