//! Functions on an interval in other bases.

use basis_prover::collections::list::Mapped;
use basis_prover::collections::map::SortedMap;

use super::Family;
use crate::algebra::fibre::{self, Step};
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::Rational;

/// The Bernstein coefficients of all functions of a family on an interval, one row for each; of a rational
/// family, of the numerators.
pub(crate) fn bernstein_table(family: &Family) -> Option<Vec<Vec<Poly>>> {
    let (var, low, high) = family.interval()?;
    let degree = family.degree(var);
    Some(family.numerators().mapped(|numer| bernstein_on(numer, var, [low, high], degree)))
}

/// The Bernstein coefficients of a polynomial in a variable from `low` to `high`.
pub(crate) fn bernstein_on(p: &Poly, var: Var, [low, high]: [&Rational; 2], degree: u32) -> Vec<Poly> {
    to_bernstein(&affine(&p.coefficients_in(var), low, &(high - low)), degree)
}

/// The coefficients of all functions of a family on an interval in powers of the domain variable, one row for each,
/// without denominators, if these are as many as the functions and every function has a degree of its own.
///
/// Such a table is triangular: orthogonal polynomials have one.
pub(crate) fn graded_table(family: &Family) -> Option<Vec<Vec<Poly>>> {
    let (var, ..) = family.interval()?;
    let width = family.functions.len();
    let mut rows = Vec::new();
    let mut seen = vec![false; width];
    for numerator in family.numerators() {
        let mut row = numerator.coefficients_in(var);
        let degree = row.iter().rposition(|c| !c.is_zero())?;
        if core::mem::replace(seen.get_mut(degree)?, true) {
            return None;
        }
        row.resize(width, Poly::zero());
        rows.push(row);
    }
    Some(rows)
}

/// The coefficients of p(low + width·x).
pub(crate) fn affine(coefficients: &[Poly], low: &Rational, width: &Rational) -> Vec<Poly> {
    let mut result = coefficients.to_vec();
    shift(&mut result, low);
    if !width.is_one() {
        let mut power = Rational::ONE;
        for c in &mut result {
            *c = c.scale(&power);
            power *= width;
        }
    }
    result
}

/// The coefficients of p(by + x).
fn shift(coefficients: &mut [Poly], by: &Rational) {
    if by.is_zero() {
        return;
    }
    // By monomial, its coefficients for the powers of x.
    let mut fibres: SortedMap<Monomial, Vec<Rational>> = SortedMap::new();
    for (k, coefficient) in coefficients.iter().enumerate() {
        for (m, c) in coefficient.terms() {
            fibres.get_or_insert_with(m.clone(), || vec![Rational::ZERO; coefficients.len()])[k] = c.clone();
        }
    }
    let mut terms = coefficients.mapped(|_| Vec::new());
    for (m, mut fibre) in fibres {
        fibre::apply(&[Step::Shift(by.clone())], &mut fibre);
        for (k, c) in fibre.into_iter().enumerate() {
            terms[k].push((m.clone(), c));
        }
    }
    for (k, terms) in terms.into_iter().enumerate() {
        coefficients[k] = Poly::from_terms(terms);
    }
}

/// The Bernstein coefficients of degree n: c_j binomial(n, j) are the coefficients of (1 + x)^n p(x/(1 + x)), which is
/// x^n r(1 + 1/x), where r has the coefficients of p in reverse.
pub(crate) fn to_bernstein(coefficients: &[Poly], n: u32) -> Vec<Poly> {
    let mut result = coefficients.to_vec();
    result.resize(n as usize + 1, Poly::zero());
    result.reverse();
    shift(&mut result, &Rational::ONE);
    result.reverse();
    let mut binomial = Rational::ONE;
    for (j, c) in (0_i64..).zip(&mut result) {
        *c = c.scale(&binomial.recip().unwrap_or(Rational::ONE));
        binomial *= &Rational::new(i64::from(n) - j, j + 1);
    }
    result
}
