//! The table of coefficients of a family, its columns as sums of coefficients of monomials, and the steps by which Coq sees
//! that its rows are independent.

use crate::coq::certificate;
use crate::coq::formula::polynomial_data;
use crate::coq::theorem::Missing;
use basis_engine::Family;
use basis_engine::algebra::rational::Rational;
use basis_kernel::algebra::poly::{Poly, Var};
use basis_kernel::algebra::range::Region;
use basis_kernel::algebra::work::Work;
use basis_kernel::collections::sort::sort_unique;
use basis_kernel::{Minors, Signed, minor};

const TOO_LONG: Missing = "a table of coefficients that is too long";

/// Exponents of the domain variables with a number: a part of a sum of coefficients.
type Functional = Vec<(Vec<u32>, Rational)>;

const BESIDE: Missing = "independence of functions of a variable beside its sine, or with pi";

/// The coefficients of the functions, in the basis of the certificate and as sums of coefficients of monomials.
pub(in crate::coq) struct Table<'a> {
    rows: &'a [Vec<Poly>],
    columns: Vec<Functional>,
    domain: Vec<Var>,
    shapes: Vec<Var>,
    /// The functions over a common denominator, which is the last one.
    quotients: Vec<Poly>,
}

impl<'a> Table<'a> {
    /// Finds out which sum of coefficients each column is.
    pub(in crate::coq) fn new(family: &Family, rows: &'a [Vec<Poly>]) -> Result<Self, Missing> {
        let numerators = family.numerators();
        let domain: Vec<Var> = family.domain.iter().map(|p| p.var).collect();
        let shapes: Vec<Var> = family.shapes.iter().map(|p| p.var).collect();
        let quotients = quotients(family, &numerators);
        let is_known = |v: &Var| domain.contains(v) || shapes.contains(v);
        if !quotients.iter().flat_map(Poly::variables).all(|v| is_known(&v)) {
            return Err(BESIDE);
        }
        let known = candidates(family, &numerators, &domain, rows.first().map_or(0, Vec::len));
        let values: Vec<Vec<Poly>> = known
            .iter()
            .map(|functional| numerators.iter().map(|p| applied(functional, p, &domain)).collect())
            .collect();
        let mut columns = Vec::new();
        for c in 0..rows.first().map_or(0, Vec::len) {
            let column: Vec<Poly> = rows.iter().map(|row| row[c].clone()).collect();
            let found = values.iter().position(|v| *v == column);
            columns.push(known[found.ok_or("a table of coefficients in another basis")?].clone());
        }
        Ok(Self { rows, columns, domain, shapes, quotients })
    }

    /// The common denominator as data, and the numerators of the functions over it, in the domain variables and then the
    /// shape parameters.
    pub(in crate::coq) fn quotients(&self) -> (String, Vec<String>) {
        let variables = [&self.domain[..], &self.shapes].concat();
        let mut all: Vec<String> = self.quotients.iter().map(|p| polynomial_data(p, &variables)).collect();
        let below = all.pop().unwrap_or_default();
        (below, all)
    }

    /// A step for each row of a table of numbers.
    pub(in crate::coq) fn numbers(&self) -> Result<Vec<String>, Missing> {
        let rows: Option<Vec<Vec<Rational>>> =
            self.rows.iter().map(|row| row.iter().map(Poly::as_constant).collect()).collect();
        let inverse = right_inverse(&rows.ok_or("a table that does not consist of numbers")?)
            .ok_or("functions that are dependent")?;
        let steps = (0..self.rows.len()).map(|i| {
            let factors = inverse.iter().map(|(c, x)| (*c, Poly::constant(x[i].clone())));
            self.step(i, factors.collect(), "Direct")
        });
        Ok(steps.collect())
    }

    /// Steps for blocks, the last one first.
    pub(in crate::coq) fn blocks(&self, blocks: &[Minors], region: &Region) -> Result<Vec<String>, Missing> {
        let mut steps = Vec::new();
        let ranges: Vec<_> = self.shapes.iter().map(|v| (*v, region.range(*v))).collect();
        let work = &mut Work::usual(1);
        for block in blocks.iter().rev() {
            let (Signed::Positive(proof) | Signed::Negative(proof)) = &block.sign;
            let cert = certificate::sign(proof, &ranges)?;
            let rows: Vec<&[Poly]> = block.rows.iter().map(|r| &self.rows[*r][..]).collect();
            for (i, row) in block.rows.iter().enumerate() {
                let mut factors: Vec<(usize, Poly)> = Vec::new();
                for columns in &block.columns {
                    // Of several minors the squares are added.
                    let weight = match block.columns.len() {
                        1 => Poly::one(),
                        _ => minor(&rows, columns, work).map_err(|_| TOO_LONG)?,
                    };
                    for (c, column) in columns.iter().enumerate() {
                        let others: Vec<&[Poly]> =
                            rows.iter().enumerate().filter(|(r, _)| *r != i).map(|(_, row)| *row).collect();
                        let rest: Vec<usize> =
                            columns.iter().copied().filter(|other| other != column).collect();
                        let cofactor = minor(&others, &rest, work).map_err(|_| TOO_LONG)?;
                        let cofactor = if (i + c) % 2 == 1 { -&cofactor } else { cofactor };
                        factors.push((*column, &cofactor * &weight));
                    }
                }
                steps.push(self.step(*row, factors, &cert));
            }
        }
        Ok(steps)
    }

    /// A step as data: factors of columns become factors of monomials.
    pub(in crate::coq) fn step(&self, row: usize, factors: Vec<(usize, Poly)>, cert: &str) -> String {
        let mut sum: Vec<(Vec<u32>, Poly)> = Vec::new();
        for (column, factor) in factors {
            for (exponents, x) in &self.columns[column] {
                let part = factor.scale(x);
                match sum.iter_mut().find(|(known, _)| known == exponents) {
                    Some((_, p)) => *p = &*p + &part,
                    None => sum.push((exponents.clone(), part)),
                }
            }
        }
        let parts = sum.iter().filter(|(_, p)| !p.is_zero()).map(|(exponents, p)| {
            let exponents: Vec<String> = exponents.iter().map(u32::to_string).collect();
            format!("([{}]%nat, {})", exponents.join("; "), polynomial_data(p, &self.shapes))
        });
        let parts: Vec<String> = parts.collect();
        format!("Step {row} [{}] {cert}", parts.join("; "))
    }
}

/// The functions over a common denominator, which is the last one. Where they are no quotients in the domain variables, the
/// table has each numerator by itself; the product of the denominators is common to all, and the rows of the table are
/// multiples of those here.
fn quotients(family: &Family, numerators: &[Poly]) -> Vec<Poly> {
    if family.is_rational() {
        return numerators.iter().chain([&family.over]).cloned().collect();
    }
    let mut different: Vec<&Poly> = Vec::new();
    for f in &family.functions {
        if !different.contains(&f.value.denom()) {
            different.push(f.value.denom());
        }
    }
    let product = |without: Option<&Poly>| {
        let factors = different.iter().filter(|p| Some(**p) != without);
        factors.fold(Poly::one(), |product, p| &product * *p)
    };
    let of =
        |(f, numerator): (&basis_engine::model::Function, &Poly)| numerator * &product(Some(f.value.denom()));
    family.functions.iter().zip(numerators).map(of).chain([product(None)]).collect()
}

/// The value of a sum of coefficients, a polynomial in the shape parameters.
fn applied(functional: &Functional, p: &Poly, domain: &[Var]) -> Poly {
    let mut terms = Vec::new();
    for (m, c) in p.terms() {
        let exponents: Vec<u32> = domain.iter().map(|v| u32::from(m.exponent(*v))).collect();
        if let Some((_, x)) = functional.iter().find(|(known, _)| *known == exponents) {
            let shape = domain.iter().fold(m.clone(), |m, v| m.with_exponent(*v, 0));
            terms.push((shape, c * x));
        }
    }
    Poly::from_terms(terms)
}

/// What a column can be: a coefficient of a monomial; a Bernstein coefficient; a coefficient of a homogeneous monomial.
fn candidates(family: &Family, numerators: &[Poly], domain: &[Var], width: usize) -> Vec<Functional> {
    let mut monomials: Vec<Vec<u32>> = Vec::new();
    for (m, _) in numerators.iter().flat_map(Poly::terms) {
        monomials.push(domain.iter().map(|v| u32::from(m.exponent(*v))).collect());
    }
    sort_unique(&mut monomials);
    let mut all = Vec::new();
    if family.is_simplex() {
        let total = |m: &[u32]| m.iter().sum::<u32>();
        let degree = monomials.iter().map(|m| total(m)).max().unwrap_or(0);
        let mut exponents: Vec<Vec<u32>> = vec![Vec::new()];
        for _ in domain {
            exponents = exponents
                .into_iter()
                .flat_map(|e: Vec<u32>| {
                    let left = degree - total(&e);
                    (0..=left).map(move |k| [&e[..], &[k]].concat()).collect::<Vec<_>>()
                })
                .collect();
        }
        for e in exponents {
            // Of a monomial m times (u + v + w)^(degree - |m|) the coefficient with the exponents e.
            let below = monomials.iter().filter(|m| m.iter().zip(&e).all(|(a, b)| a <= b));
            let parts = below.map(|m| {
                let mut rest: Vec<u32> = e.iter().zip(m).map(|(b, a)| b - a).collect();
                rest.push(degree - total(&e));
                let factor = rest.iter().fold(factorial(degree - total(m)), |x, k| &x / &factorial(*k));
                (m.clone(), factor)
            });
            all.push(parts.collect());
        }
        return all;
    }
    if let Some((_, low, high)) = family.interval() {
        let (n, length) = (width.saturating_sub(1) as u32, high - low);
        for j in 0..=n {
            // The Bernstein coefficients of x^k on 0 <= x <= 1 are binomial(j, k)/binomial(n, k), with t = low + length x.
            let parts = monomials.iter().map(|m| {
                let i = m[0];
                let sum = (0..=i.min(j)).map(|k| {
                    let power = &low.pow(i - k) * &length.pow(k);
                    &(&binomial(i, k) * &power) * &(&binomial(j, k) / &binomial(n, k))
                });
                (m.clone(), sum.fold(Rational::ZERO, |a, b| &a + &b))
            });
            all.push(parts.filter(|(_, x)| !x.is_zero()).collect());
        }
    }
    all.extend(monomials.into_iter().map(|m| vec![(m, Rational::ONE)]));
    all
}

fn factorial(n: u32) -> Rational {
    (1..=i64::from(n)).fold(Rational::ONE, |p, k| &p * &Rational::from(k))
}

fn binomial(n: u32, k: u32) -> Rational {
    if k > n { Rational::ZERO } else { &factorial(n) / &(&factorial(k) * &factorial(n - k)) }
}

/// Columns with factors for each row: the sum of factor times column is the unit vector of the row.
fn right_inverse(rows: &[Vec<Rational>]) -> Option<Vec<(usize, Vec<Rational>)>> {
    let n = rows.len();
    // [rows | 1], brought into reduced form: then the right half is the inverse of the pivot columns.
    let unit = |i: usize| (0..n).map(move |j| if i == j { Rational::ONE } else { Rational::ZERO });
    let mut wide: Vec<Vec<Rational>> =
        rows.iter().enumerate().map(|(i, r)| r.iter().cloned().chain(unit(i)).collect()).collect();
    let width = rows.first()?.len();
    let mut pivots = Vec::new();
    for column in 0..width {
        let done = pivots.len();
        let Some(found) = (done..n).find(|r| !wide[*r][column].is_zero()) else { continue };
        wide.swap(done, found);
        let factor = wide[done][column].recip()?;
        for x in &mut wide[done] {
            *x = &*x * &factor;
        }
        let pivot = wide[done].clone();
        for (r, row) in wide.iter_mut().enumerate() {
            if r != done && !row[column].is_zero() {
                let factor = row[column].clone();
                for (x, p) in row.iter_mut().zip(&pivot) {
                    *x = &*x - &(&factor * p);
                }
            }
        }
        pivots.push(column);
        if pivots.len() == n {
            break;
        }
    }
    if pivots.len() < n {
        return None;
    }
    Some(pivots.into_iter().enumerate().map(|(k, c)| (c, wide[k][width..].to_vec())).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_inverses_give_unit_vectors() {
        let r = |n: i64| Rational::from(n);
        let rows = vec![vec![r(1), r(2), r(3)], vec![r(2), r(4), r(7)]];
        let inverse = right_inverse(&rows).expect("independent");
        for (i, row) in rows.iter().enumerate() {
            for j in 0..2 {
                let sum = inverse.iter().fold(Rational::ZERO, |sum, (c, x)| &sum + &(&row[*c] * &x[j]));
                assert_eq!(sum, r(i64::from(i == j)));
            }
        }
        assert!(right_inverse(&[vec![r(1), r(2)], vec![r(2), r(4)]]).is_none());
    }
}
