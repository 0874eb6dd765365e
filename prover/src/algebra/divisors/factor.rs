//! Factored forms for reading: contents, square-free parts and linear factors.

use super::gcd::{content, leading_coefficient, square_free};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::roots::{linear, rational_roots};
use crate::algebra::univariate::{ToPoly, Univariate};
use crate::algebra::work::Work;
use crate::collections::list::{Listed, Mapped};
use crate::collections::sort::sort_by;

/// The work that [`factor`] may take.
const WORK: u64 = 1_000_000;
/// The most candidates for linear factors of one polynomial.
const MAX_CANDIDATES: usize = 200;

/// A number and polynomials with exponents whose product is the polynomial.
///
/// The polynomials are normalised, different and square-free. Found are all factors that lack one of the variables, and
/// the factors of degree 1, with a number as one of its coefficients; what is left may be reducible. 0 has no factors.
pub fn factor(p: &Poly) -> (Rational, Vec<(Poly, u32)>) {
    checked_factor(p, &mut Work::new(WORK)).unwrap_or_else(|| {
        let whole = p.normalized();
        (quotient(p, [(&whole, 1)].into_iter()), vec![(whole, 1)])
    })
}

/// As [`factor`]; `None` when the work is spent.
pub fn checked_factor(p: &Poly, work: &mut Work) -> Option<(Rational, Vec<(Poly, u32)>)> {
    let mut factors = Vec::new();
    for (f, exponent) in square_free(p, work)? {
        let mut waiting = vec![f];
        while let Some(f) = waiting.pop() {
            let parts = split(&f, work)?;
            if parts.is_empty() {
                factors.push((f, exponent));
            }
            waiting.extend(parts);
        }
    }
    sort_by(&mut factors, |a, b| {
        (a.0.total_degree(), a.0.len(), a.1, &a.0).cmp(&(b.0.total_degree(), b.0.len(), b.1, &b.0))
    });
    Some((quotient(p, factors.iter().map(|(f, e)| (f, *e))), factors))
}

/// The number c with p = c·∏ fᵉ: leading terms multiply.
fn quotient<'a>(p: &Poly, factors: impl Iterator<Item = (&'a Poly, u32)>) -> Rational {
    let lead = |p: &Poly| p.leading_term().map_or(Rational::ZERO, |(_, c)| c.clone());
    factors.fold(lead(p), |c, (f, e)| c.checked_div(&lead(f).pow(e)).unwrap_or(Rational::ZERO))
}

/// Two factors of a square-free polynomial, neither a number; no factors when it has none of the forms looked for.
fn split(f: &Poly, work: &mut Work) -> Option<Vec<Poly>> {
    let variables = f.variables();
    if let [only] = &variables[..] {
        let p = Univariate::from_poly(f, *only)?;
        if p.degree() < 2 {
            return Some(Vec::new());
        }
        let root = rational_roots(&p, work)?.into_iter().next();
        return Some(root.map_or_else(Vec::new, |x| with_rest(f, linear(&x).to_poly(*only))));
    }
    for var in &variables {
        let common = content(f, *var, work)?;
        if common.as_constant().is_none() {
            return Some(with_rest(f, common));
        }
    }
    // Of degree 1 and without a common factor of the coefficients: irreducible.
    if variables.iter().any(|v| f.degree(*v) == 1) {
        return Some(Vec::new());
    }
    for var in &variables {
        let parts = linear_in(f, *var, &variables, work)?;
        if !parts.is_empty() {
            return Some(parts);
        }
    }
    Some(Vec::new())
}

/// A divisor and the quotient, normalised; nothing if it does not divide.
fn with_rest(f: &Poly, divisor: Poly) -> Vec<Poly> {
    f.div_exact(&divisor).map_or_else(Vec::new, |rest| vec![divisor, rest.normalized()])
}

/// A factor x − a − Σ bⱼ yⱼ and the rest, if there is one: it passes through rational roots at a point of the other
/// variables and at its neighbours.
fn linear_in(f: &Poly, x: Var, variables: &[Var], work: &mut Work) -> Option<Vec<Poly>> {
    let others: Vec<Var> = variables.iter().copied().filter(|v| *v != x).listed();
    let lead = leading_coefficient(f, x);
    let at = |p: &Poly, start: i64, step: Option<Var>| {
        others.iter().fold(p.clone(), |p, v| p.at(*v, &Rational::from(start + i64::from(step == Some(*v)))))
    };
    // A point at which, as at its neighbours, the degree in x is kept.
    let steps: Vec<Option<Var>> = [None].into_iter().chain(others.iter().map(|v| Some(*v))).listed();
    let keeps = |start: &i64| steps.iter().all(|s| !at(&lead, *start, *s).is_zero());
    let Some(start) = [0, 2, -3, 5].into_iter().find(keeps) else { return Some(Vec::new()) };
    let mut candidates: Vec<Poly> = Vec::new();
    let mut values: Vec<Rational> = Vec::new();
    for step in steps {
        let p = Univariate::from_poly(&at(f, start, step), x)?;
        let roots = rational_roots(&p.square_free_part(work)?, work)?;
        let Some(y) = step else {
            candidates = roots.mapped(|r| Poly::constant(r.clone()));
            values = roots;
            continue;
        };
        let offset = &Poly::var(y) - &Poly::integer(start);
        let slopes = |(c, a): (&Poly, &Rational)| {
            let with = |r: &Rational| (c + &offset.scale(&(r - a)), a.clone());
            roots.mapped(with)
        };
        (candidates, values) = candidates.iter().zip(&values).flat_map(slopes).take(MAX_CANDIDATES).unzip();
    }
    for candidate in candidates {
        let linear = (&Poly::var(x) - &candidate).normalized();
        work.spend_product(&linear, f)?;
        let parts = with_rest(f, linear);
        if !parts.is_empty() {
            return Some(parts);
        }
    }
    Some(Vec::new())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::letters::{n, x, y};

    #[test]
    fn factored_form_of_a_product() {
        let parts = [
            (y(), 2),
            (&x() - &n(1), 3),
            (&(&x().scale(&3.into()) + &y()) - &n(2), 1),
            (&(&x() * &y()) - &n(1), 1),
            (&x() - &y().scale(&2.into()), 1),
            (&x().pow(2) + &n(1), 2),
        ];
        let number = Rational::new(-5, 6);
        let p = parts.iter().fold(Poly::constant(number.clone()), |p, (f, e)| &p * &f.pow(*e));
        let (c, factors) = factor(&p);
        assert_eq!(c, number);
        assert_eq!(factors.len(), parts.len());
        assert!(parts.iter().all(|part| factors.contains(part)), "{factors:?}");
        assert_eq!(factors.iter().fold(Poly::constant(c), |p, (f, e)| &p * &f.pow(*e)), p);
    }

    #[test]
    fn products_of_linear_factors() {
        let z = Poly::var(Var(2));
        let lines = [&x() - &y(), &(&x() + &y()) + &z, &(&x().scale(&2.into()) - &y()) + &n(3)];
        let p = lines.iter().fold(n(1), |p, f| &p * f);
        let (c, factors) = factor(&p);
        assert!(c.is_one());
        assert!(lines.iter().all(|f| factors.contains(&(f.clone(), 1))), "{factors:?}");
    }

    #[test]
    fn numbers_and_irreducible_polynomials() {
        assert_eq!(factor(&Poly::zero()), (Rational::ZERO, vec![]));
        assert_eq!(factor(&n(-4)), (Rational::from(-4), vec![]));
        let p = &x().pow(2) - &n(2);
        assert_eq!(factor(&p), (Rational::ONE, vec![(p, 1)]));
    }
}
