//! Resultants and discriminants, by evaluation and interpolation in the other variables.

use crate::collections::list::{Listed, Mapped};
use crate::collections::map::SortedMap;

use super::gcd::checked_product;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;

/// The resultant in a variable: the determinant of the Sylvester matrix, lc(a)^deg b · ∏ b(α) over the roots α of
/// a. It vanishes where the two have a common root or both leading coefficients vanish.
///
/// `None` when the work is spent.
pub fn resultant(a: &Poly, b: &Poly, var: Var, work: &mut Work) -> Option<Poly> {
    if a.is_zero() || b.is_zero() {
        return Some(Poly::zero());
    }
    let (m, n) = (a.degree(var), b.degree(var));
    match (m, n) {
        (_, 0) => power(b, m, work),
        (0, _) => power(a, n, work),
        (_, 1) => {
            let value = at_root(a, b, var, work)?;
            Some(if m % 2 == 1 { -&value } else { value })
        }
        (1, _) => at_root(b, a, var, work),
        _ => {
            // res(α a, β b) = αⁿ βᵐ res(a, b): compute with whole coefficients.
            let (f, g) = (a.normalized(), b.normalized());
            let scale = &quotient(a, &f)?.pow(n) * &quotient(b, &g)?.pow(m);
            Some(evaluate(&Quantity::Resultant(f, g), var, work)?.scale(&scale))
        }
    }
}

/// The discriminant in a variable: lc^(2n−2) ∏ (αᵢ − αⱼ)² over pairs of roots, 1 for degree 1 and 0 for degree 0.
///
/// `None` when the work is spent.
pub fn discriminant(p: &Poly, var: Var, work: &mut Work) -> Option<Poly> {
    let n = p.degree(var);
    match n {
        0 => Some(Poly::zero()),
        1 => Some(Poly::one()),
        2 => {
            let c = p.coefficients_in(var);
            let square = checked_product(&c[1], &c[1], work)?;
            Some(&square - &checked_product(&c[0], &c[2], work)?.scale(&Rational::from(4)))
        }
        _ => {
            let f = p.normalized();
            let scale = quotient(p, &f)?.pow(2 * n - 2);
            Some(evaluate(&Quantity::Discriminant(f), var, work)?.scale(&scale))
        }
    }
}

/// The number by which `whole` is multiplied in `p`.
fn quotient(p: &Poly, whole: &Poly) -> Option<Rational> {
    let ((_, a), (_, b)) = (p.leading_term()?, whole.leading_term()?);
    a.checked_div(b)
}

fn power(base: &Poly, exponent: u32, work: &mut Work) -> Option<Poly> {
    let mut result = Poly::one();
    for _ in 0..exponent {
        result = checked_product(&result, base, work)?;
    }
    Some(result)
}

/// d^deg p · p(−c/d) for the linear polynomial d·x + c.
fn at_root(p: &Poly, linear: &Poly, var: Var, work: &mut Work) -> Option<Poly> {
    let [c, d] = <[Poly; 2]>::try_from(linear.coefficients_in(var)).ok()?;
    let minus = -&c;
    let mut value = Poly::zero();
    let mut scale = Poly::one();
    for coefficient in p.coefficients_in(var).iter().rev() {
        let term = checked_product(coefficient, &scale, work)?;
        value = &checked_product(&value, &minus, work)? + &term;
        scale = checked_product(&scale, &d, work)?;
    }
    Some(value)
}

/// What is computed at the nodes of the interpolation.
enum Quantity {
    Resultant(Poly, Poly),
    Discriminant(Poly),
}

impl Quantity {
    fn polys(&self) -> Vec<&Poly> {
        match self {
            Self::Resultant(a, b) => vec![a, b],
            Self::Discriminant(p) => vec![p],
        }
    }

    /// The same with a number in place of a variable; `None` if a leading coefficient becomes zero.
    fn at(&self, other: Var, value: &Rational, var: Var) -> Option<Self> {
        let put = |p: &Poly| Some(p.at(other, value)).filter(|q| q.degree(var) == p.degree(var));
        Some(match self {
            Self::Resultant(a, b) => Self::Resultant(put(a)?, put(b)?),
            Self::Discriminant(p) => Self::Discriminant(put(p)?),
        })
    }

    /// A bound of the degree of the result in another variable.
    fn degree(&self, other: Var, var: Var) -> u32 {
        // Row by row of the Sylvester matrix; or by weight: the entry of column k has degree ≤ total − k.
        let bound = |a: &Poly, b: &Poly| {
            let (m, n) = (a.degree(var), b.degree(var));
            let (s, t) = (joint_degree(a, var, other), joint_degree(b, var, other));
            (n * a.degree(other) + m * b.degree(other)).min((n * s + m * t).saturating_sub(m * n))
        };
        match self {
            Self::Resultant(a, b) => bound(a, b),
            Self::Discriminant(p) => {
                let n = p.degree(var);
                bound(p, &p.derivative(var)).min((2 * n - 2) * p.degree(other))
            }
        }
    }

    /// The number, when only `var` is left.
    fn number(&self, var: Var, work: &mut Work) -> Option<Rational> {
        match self {
            Self::Resultant(a, b) => {
                of_numbers(&Univariate::from_poly(a, var)?, &Univariate::from_poly(b, var)?, work)
            }
            Self::Discriminant(p) => {
                let p = Univariate::from_poly(p, var)?;
                let n = p.degree();
                let value = of_numbers(&p, &p.derivative(), work)?.checked_div(&p.leading())?;
                Some(if n * (n - 1) / 2 % 2 == 1 { -value } else { value })
            }
        }
    }
}

/// The highest sum of the exponents of two variables.
fn joint_degree(p: &Poly, x: Var, y: Var) -> u32 {
    p.terms().map(|(m, _)| u32::from(m.exponent(x)) + u32::from(m.exponent(y))).max().unwrap_or(0)
}

/// Computes the quantity by putting numbers in place of one other variable after the other.
fn evaluate(quantity: &Quantity, var: Var, work: &mut Work) -> Option<Poly> {
    let other = quantity.polys().into_iter().flat_map(Poly::variables).filter(|v| *v != var).max();
    let Some(other) = other else { return quantity.number(var, work).map(Poly::constant) };
    let count = quantity.degree(other, var) as usize + 1;
    let mut nodes = Vec::new();
    let mut values = Vec::new();
    let terms: usize = quantity.polys().into_iter().map(Poly::len).sum();
    for node in 0.. {
        if nodes.len() == count {
            break;
        }
        work.spend(4 * terms as u64 + 10)?;
        // 0, 1, −1, 2, −2, …
        let node = Rational::from(if node % 2 == 0 { -(node / 2) } else { node / 2 + 1 });
        if let Some(quantity) = quantity.at(other, &node, var) {
            values.push(evaluate(&quantity, var, work)?);
            nodes.push(node);
        }
    }
    interpolate(&nodes, &values, other, work)
}

/// The polynomial of lowest degree in `var` with the given values at the given different whole numbers; `None` when the
/// work is spent.
///
/// Lagrange's formula Σ vₖ ∏ (x − xⱼ)/(xₖ − xⱼ), brought to one denominator so that whole values need no fractions.
pub fn interpolate(nodes: &[Rational], values: &[Poly], var: Var, work: &mut Work) -> Option<Poly> {
    let n = nodes.len();
    work.spend((n * n * (2 + n / 20)) as u64)?;
    let mut product = vec![Rational::ONE];
    for x in nodes {
        product = times_linear(&product, x);
    }
    let weight = |k: usize| {
        let others = nodes.iter().enumerate().filter(|(j, _)| *j != k);
        others.fold(Rational::ONE, |w, (_, x)| &w * &(&nodes[k] - x))
    };
    let weights: Vec<Rational> = (0..n).map(weight).listed();
    let denominator = weights.iter().fold(Rational::ONE, |l, w| &(&l * &w.abs()) / &l.gcd(w));
    let basis: Vec<Vec<Rational>> = nodes
        .iter()
        .zip(&weights)
        .map(|(x, w)| {
            let factor = &denominator / w;
            by_linear(&product, x).mapped(|c| c * &factor)
        })
        .listed();
    let mut columns: SortedMap<Monomial, Vec<Rational>> = SortedMap::new();
    for (value, lagrange) in values.iter().zip(&basis) {
        let words = (value.max_bits() + denominator.bits()) / 64 + 1;
        work.spend(2 * (value.len() * n) as u64 * words)?;
        for (m, c) in value.terms() {
            let column = columns.get_or_insert_with(m.clone(), || vec![Rational::ZERO; n]);
            for (sum, l) in column.iter_mut().zip(lagrange) {
                *sum += &(c * l);
            }
        }
    }
    let terms = columns.iter().flat_map(|(monomial, column)| {
        let term = |(k, c): (usize, &Rational)| (monomial.with_exponent(var, k as u16), c / &denominator);
        column.iter().enumerate().filter(|(_, c)| !c.is_zero()).map(term).listed()
    });
    Some(Poly::from_terms(terms))
}

/// p·(x − a).
fn times_linear(p: &[Rational], a: &Rational) -> Vec<Rational> {
    let mut result = vec![Rational::ZERO; p.len() + 1];
    for (k, c) in p.iter().enumerate() {
        result[k + 1] += c;
        result[k] -= &(c * a);
    }
    result
}

/// p/(x − a) for a root a of p.
fn by_linear(p: &[Rational], a: &Rational) -> Vec<Rational> {
    let mut result = vec![Rational::ZERO; p.len() - 1];
    let mut above = Rational::ZERO;
    for k in (0..result.len()).rev() {
        above = &p[k + 1] + &(&above * a);
        result[k] = above.clone();
    }
    result
}

/// The resultant of polynomials with whole coefficients, by subresultants.
pub fn of_numbers(a: &Univariate, b: &Univariate, work: &mut Work) -> Option<Rational> {
    if a.is_zero() || b.is_zero() {
        return Some(Rational::ZERO);
    }
    let (mut f, mut g) = (a.coefficients().to_vec(), b.coefficients().to_vec());
    let mut negative = false;
    if f.len() < g.len() {
        negative = f.len() % 2 == 0 && g.len() % 2 == 0;
        core::mem::swap(&mut f, &mut g);
    }
    let (mut scale, mut height) = (Rational::ONE, Rational::ONE);
    while g.len() > 1 {
        let delta = (f.len() - g.len()) as u32;
        negative ^= f.len() % 2 == 0 && g.len() % 2 == 0;
        let rest = pseudo_remainder(f, &g, work)?;
        if rest.is_empty() {
            return Some(Rational::ZERO);
        }
        let divisor = &scale * &height.pow(delta);
        f = g;
        g = rest.mapped(|c| c / &divisor);
        scale = f.last()?.clone();
        height = if delta == 0 { height } else { &scale.pow(delta) / &height.pow(delta - 1) };
    }
    let n = f.len() as u32 - 1;
    let last = g.last()?;
    let value = if n == 0 { Rational::ONE } else { &last.pow(n) / &height.pow(n - 1) };
    Some(if negative { -value } else { value })
}

/// lc(g)^(deg f − deg g + 1)·f modulo g, without leading zeros.
fn pseudo_remainder(mut f: Vec<Rational>, g: &[Rational], work: &mut Work) -> Option<Vec<Rational>> {
    let lead = g.last()?;
    while f.len() >= g.len() {
        let top = f.pop()?;
        let shift = f.len() + 1 - g.len();
        work.spend(2 * f.len() as u64 * ((top.bits() + lead.bits()) / 64 + 1))?;
        for c in &mut f {
            *c *= lead;
        }
        for (k, c) in g.iter().take(g.len() - 1).enumerate() {
            f[k + shift] -= &(c * &top);
        }
    }
    while f.last().is_some_and(Rational::is_zero) {
        f.pop();
    }
    Some(f)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::letters::{n, x, y, z};

    fn product(roots: &[Poly]) -> Poly {
        roots.iter().fold(n(1), |p, r| &p * &(&x() - r))
    }
    fn res(a: &Poly, b: &Poly) -> Poly {
        resultant(a, b, Var(0), &mut Work::unlimited()).expect("unlimited")
    }
    fn disc(p: &Poly) -> Poly {
        discriminant(p, Var(0), &mut Work::unlimited()).expect("unlimited")
    }

    #[test]
    fn resultant_is_the_product_of_differences_of_roots() {
        let (a, b) = ([y(), n(2), &y() + &z()], [z(), &z().pow(2) - &y(), n(-1)]);
        for (k, l) in [(3, 3), (3, 2), (2, 3), (3, 1), (1, 3), (2, 1), (1, 1), (2, 2)] {
            let mut expected = n(1);
            for r in &a[..k] {
                for s in &b[..l] {
                    expected = &expected * &(r - s);
                }
            }
            assert_eq!(res(&product(&a[..k]), &product(&b[..l])), expected, "{k} {l}");
        }
    }

    #[test]
    fn resultant_of_constants_and_scaled_polynomials() {
        let a = &(&x().pow(2) * &y()) + &n(1);
        assert_eq!(res(&a, &n(3)), n(9));
        assert_eq!(res(&n(3), &a), n(9));
        assert_eq!(res(&a, &Poly::zero()), n(0));
        let b = &x().pow(3) - &z();
        let c = Rational::new(-2, 3);
        assert_eq!(res(&a.scale(&c), &b), res(&a, &b).scale(&c.pow(3)));
        assert_eq!(res(&a, &b.scale(&c)), res(&a, &b).scale(&c.pow(2)));
        // res(y x² + 1, x³ − z) = y³ z² + 1
        assert_eq!(res(&a, &b), &(&y().pow(3) * &z().pow(2)) + &n(1));
    }

    #[test]
    fn discriminants() {
        // x³ + y x + z: −4 y³ − 27 z²
        let p = &(&x().pow(3) + &(&x() * &y())) + &z();
        let expected = &(-&y().pow(3)).scale(&Rational::from(4)) - &z().pow(2).scale(&Rational::from(27));
        assert_eq!(disc(&p), expected);
        assert_eq!(disc(&p.scale(&Rational::from(2))), expected.scale(&Rational::from(16)));
        let q = &(&(&y() * &x().pow(2)) + &x()) + &z();
        assert_eq!(disc(&q), &n(1) - &(&y() * &z()).scale(&Rational::from(4)));
        assert_eq!(disc(&product(&[y(), y(), z()])), n(0));
        let roots = [y(), z(), n(1), n(-2)];
        let mut expected = n(1);
        for i in 0..4 {
            for j in 0..i {
                expected = &expected * &(&roots[i] - &roots[j]).pow(2);
            }
        }
        assert_eq!(disc(&product(&roots)), expected);
        assert_eq!(discriminant(&product(&roots), Var(0), &mut Work::new(100)), None);
    }
}
