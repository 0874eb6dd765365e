//! Greatest common divisors and square-free parts of polynomials in any number of variables.

use super::modular::common_degree;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::univariate::{ToPoly, Univariate};
use crate::algebra::work::{Spent, Work};
use crate::collections::list::Listed;
use crate::collections::sort::sort_by;

/// The greatest common divisor, with whole coefficients without common factor and a positive leading one; 0 for
/// gcd(0, 0).
pub fn gcd(a: &Poly, b: &Poly) -> Poly {
    // Without a bound on the work there is always a result.
    checked_gcd(a, b, &mut Work::unlimited()).unwrap_or_else(Poly::one)
}

/// The greatest common divisor as [`gcd`] gives it; `None` when the work is spent.
pub fn checked_gcd(a: &Poly, b: &Poly, work: &mut Work) -> Option<Poly> {
    if a.is_zero() || b.is_zero() {
        return Some((if a.is_zero() { b } else { a }).normalized());
    }
    if a.as_constant().is_some() || b.as_constant().is_some() {
        return Some(Poly::one());
    }
    let (m, a) = split_monomial(a);
    let (n, b) = split_monomial(b);
    let common = Poly::term(meet(&m, &n), crate::algebra::rational::Rational::ONE);
    Some(&common * &gcd_without_monomials(&a.normalized(), &b.normalized(), work)?)
}

/// The quotient if a polynomial divides another one. That it does not is mostly seen from images modulo a prime, in little work.
///
/// # Errors
/// When the work is spent.
pub fn checked_quotient(poly: &Poly, divisor: &Poly, work: &mut Work) -> Result<Option<Poly>, Spent> {
    let variables = divisor.variables();
    let main = variables.iter().copied().max_by_key(|v| divisor.degree(*v));
    if poly.is_zero() && !divisor.is_zero() {
        return Ok(Some(Poly::zero()));
    }
    if variables.iter().any(|v| divisor.degree(*v) > poly.degree(*v)) {
        return Ok(None);
    }
    if let Some(main) = main.filter(|_| poly.len() * divisor.len() > WITHOUT_IMAGES) {
        work.spend((10 * (poly.len() + divisor.len())) as u64).ok_or(Spent)?;
        if common_degree(poly, divisor, main).is_some_and(|degree| degree < divisor.degree(main) as usize) {
            return Ok(None);
        }
    }
    work.spend_product(poly, divisor).ok_or(Spent)?;
    Ok(poly.div_exact(divisor))
}

/// The number of products of terms up to which a division takes no longer than images.
const WITHOUT_IMAGES: usize = 2_000;

/// The greatest common divisor of several polynomials; 0 for none.
pub fn gcd_all<'a>(polys: impl IntoIterator<Item = &'a Poly>, work: &mut Work) -> Option<Poly> {
    let mut polys: Vec<&Poly> = polys.into_iter().listed();
    // The simplest first, for an early end.
    sort_by(&mut polys, |p, q| (p.total_degree(), p.len()).cmp(&(q.total_degree(), q.len())));
    let mut common = Poly::zero();
    for p in polys {
        common = checked_gcd(&common, p, work)?;
        if common.is_one() {
            break;
        }
    }
    Some(common)
}

/// The content of a polynomial in one variable: the greatest common divisor of its coefficients.
pub fn content(poly: &Poly, var: Var, work: &mut Work) -> Option<Poly> {
    gcd_all(&poly.coefficients_in(var), work)
}

/// The largest monomial that divides the polynomial, and the quotient; 1 for the zero polynomial.
pub fn split_monomial(poly: &Poly) -> (Monomial, Poly) {
    let mut terms = poly.terms();
    let Some((first, _)) = terms.next() else { return (Monomial::one(), Poly::zero()) };
    let mut common = first.clone();
    while !common.is_one()
        && let Some((m, _)) = terms.next()
    {
        common = meet(&common, m);
    }
    if common == Monomial::one() {
        return (common, poly.clone());
    }
    let divided = poly.terms().filter_map(|(m, c)| Some((m.checked_div(&common)?, c.clone())));
    let quotient = Poly::from_terms(divided);
    (common, quotient)
}

/// For polynomials without common factors of their terms.
fn gcd_without_monomials(a: &Poly, b: &Poly, work: &mut Work) -> Option<Poly> {
    if a == b {
        return Some(a.clone());
    }
    let (va, vb) = (a.variables(), b.variables());
    if va.is_empty() || vb.is_empty() {
        return Some(Poly::one());
    }
    // A variable in one of them only is not in the common divisor.
    if let Some(v) = va.iter().find(|v| !vb.contains(v)) {
        return with_coefficients(b, a, *v, work);
    }
    if let Some(v) = vb.iter().find(|v| !va.contains(v)) {
        return with_coefficients(a, b, *v, work);
    }
    let mut main = None;
    work.spend(10 * (a.len() + b.len()) as u64 * va.len() as u64)?;
    for v in &va {
        let bound = common_degree(a, b, *v);
        if bound == Some(0) {
            if va.len() == 1 {
                return Some(Poly::one());
            }
            // The common divisor is free of v: it divides all coefficients of both.
            let of_a = content(a, *v, work)?;
            return if of_a.is_one() { Some(of_a) } else { with_coefficients(&of_a, b, *v, work) };
        }
        let degree = bound.unwrap_or(usize::MAX);
        let size = a.degree(*v).min(b.degree(*v));
        if main.is_none_or(|(d, s, _)| (degree, size) < (d, s)) {
            main = Some((degree, size, *v));
        }
    }
    let (_, _, main) = main?;
    if let ([only], Some(f), Some(g)) =
        (&va[..], Univariate::from_poly(a, main), Univariate::from_poly(b, main))
    {
        return Some(f.gcd(&g, work)?.to_poly(*only));
    }
    for (small, large) in [(a, b), (b, a)] {
        if va.iter().all(|v| small.degree(*v) <= large.degree(*v)) {
            work.spend_product(small, large)?;
            if quotient(large, small, work).is_some() {
                return Some(small.clone());
            }
        }
    }
    by_remainders(a, b, main, work)
}

/// The greatest common divisor of a polynomial and of the coefficients of another in a variable.
fn with_coefficients(free: &Poly, other: &Poly, var: Var, work: &mut Work) -> Option<Poly> {
    let mut all = other.coefficients_in(var);
    all.push(free.clone());
    gcd_all(&all, work)
}

/// By the subresultant remainder sequence of the primitive parts.
fn by_remainders(a: &Poly, b: &Poly, var: Var, work: &mut Work) -> Option<Poly> {
    let (ca, cb) = (content(a, var, work)?, content(b, var, work)?);
    let common = checked_gcd(&ca, &cb, work)?;
    let (mut f, mut g) = (quotient(a, &ca, work)?, quotient(b, &cb, work)?);
    if f.degree(var) < g.degree(var) {
        core::mem::swap(&mut f, &mut g);
    }
    let (mut scale, mut height) = (Poly::one(), Poly::one());
    loop {
        let rest = pseudo_remainder(&f, &g, var, work)?;
        if rest.is_zero() {
            break;
        }
        if rest.degree(var) == 0 {
            return Some(common);
        }
        let delta = f.degree(var) - g.degree(var);
        let divisor = checked_product(&scale, &checked_power(&height, delta, work)?, work)?;
        f = g;
        g = quotient(&rest, &divisor, work)?;
        scale = leading_coefficient(&f, var);
        // height := scale^δ · height^(1−δ)
        let power = checked_power(&scale, delta, work)?;
        height =
            if delta == 0 { height } else { power.div_exact(&checked_power(&height, delta - 1, work)?)? };
    }
    let primitive = quotient(&g, &content(&g, var, work)?, work)?;
    checked_product(&common, &primitive, work).map(|p| p.normalized())
}

/// lc(b)^(deg a − deg b + 1) · a modulo b, as polynomials in `var`; `a` itself when its degree is lower.
pub fn pseudo_remainder(a: &Poly, b: &Poly, var: Var, work: &mut Work) -> Option<Poly> {
    let n = b.degree(var);
    let lead = leading_coefficient(b, var);
    let mut rest = a.clone();
    let Some(mut left) = (a.degree(var) + 1).checked_sub(n) else { return Some(rest) };
    while !rest.is_zero() && rest.degree(var) >= n && left > 0 {
        let shift = Monomial::one().with_exponent(var, (rest.degree(var) - n) as u16);
        let top = leading_coefficient(&rest, var);
        let top = &top * &Poly::term(shift, crate::algebra::rational::Rational::ONE);
        rest = &checked_product(&lead, &rest, work)? - &checked_product(&top, b, work)?;
        left -= 1;
    }
    checked_product(&rest, &checked_power(&lead, left, work)?, work)
}

/// The coefficient of the highest power of a variable.
pub fn leading_coefficient(poly: &Poly, var: Var) -> Poly {
    poly.coefficients_in(var).pop().unwrap_or_default()
}

/// The product, counted before it is computed.
pub fn checked_product(a: &Poly, b: &Poly, work: &mut Work) -> Option<Poly> {
    work.spend_product(a, b)?;
    Some(a * b)
}

fn checked_power(base: &Poly, exponent: u32, work: &mut Work) -> Option<Poly> {
    let mut result = Poly::one();
    for _ in 0..exponent {
        result = checked_product(&result, base, work)?;
    }
    Some(result)
}

/// The square-free decomposition: different factors without common divisors, each square-free and normalised,
/// with exponents, so that `poly` is a number times the product of the powers.
///
/// No factors for numbers. Factors are in order of their exponents; a variable that divides is a factor of its
/// own. `None` when the work is spent.
pub fn square_free(poly: &Poly, work: &mut Work) -> Option<Vec<(Poly, u32)>> {
    let (monomial, rest) = split_monomial(poly);
    let mut factors: Vec<(Poly, u32)> = Vec::new();
    for (i, e) in monomial.exponents().iter().enumerate().filter(|(_, e)| **e > 0) {
        factors.push((Poly::var(Var(i)), u32::from(*e)));
    }
    let mut rest = rest.normalized();
    // Squares are common, and a root is found much faster than a greatest common divisor.
    let exponent = match square_root(&rest, work) {
        Some(root) if !rest.is_one() => {
            rest = root;
            2
        }
        _ => 1,
    };
    let first = factors.len();
    while let Some(var) = rest.variables().into_iter().min_by_key(|v| rest.degree(*v)) {
        let lower = content(&rest, var, work)?;
        let primitive = if lower.is_one() { rest } else { quotient(&rest, &lower, work)? };
        yun(&primitive, var, &mut factors, work)?;
        rest = lower;
    }
    for (_, e) in &mut factors[first..] {
        *e *= exponent;
    }
    sort_by(&mut factors, |a, b| (a.1, a.0.total_degree(), &a.0).cmp(&(b.1, b.0.total_degree(), &b.0)));
    Some(factors)
}

/// The polynomial with a positive leading coefficient whose square this is, if there is one; from the greatest term on,
/// each term of a square is twice the product of the greatest term of the root and one that is not known yet, plus what
/// is known.
pub fn square_root(poly: &Poly, work: &mut Work) -> Option<Poly> {
    let half = |m: &Monomial| {
        let exponents = m.exponents();
        exponents.iter().all(|e| e % 2 == 0).then(|| Monomial::new(exponents.iter().map(|e| e / 2).listed()))
    };
    let (m, c) = poly.leading_term()?;
    half(poly.terms().next()?.0)?;
    let lead = (half(m)?, crate::algebra::number::square_root(c)?);
    let mut root = Poly::term(lead.0.clone(), lead.1.clone());
    let mut rest = poly - &(&root * &root);
    // The root of a square has no more terms than the square.
    for _ in 1..=poly.len() {
        let Some((m, c)) = rest.leading_term() else { return Some(root) };
        work.spend((rest.len() + root.len()) as u64 * (1 + root.max_bits() / 32))?;
        let next = Poly::term(m.checked_div(&lead.0)?, c / &(&lead.1 + &lead.1));
        rest = &rest - &(&(&(&root + &root) + &next) * &next);
        root = &root + &next;
    }
    None
}

/// Yun's algorithm for a polynomial whose coefficients in `var` have no common divisor.
fn yun(poly: &Poly, var: Var, factors: &mut Vec<(Poly, u32)>, work: &mut Work) -> Option<()> {
    let derivative = poly.derivative(var);
    let common = checked_gcd(poly, &derivative, work)?;
    if common.is_one() {
        factors.push((poly.clone(), 1));
        return Some(());
    }
    let mut rest = quotient(poly, &common, work)?;
    let mut slope = quotient(&derivative, &common, work)?;
    let mut exponent = 1;
    while rest.as_constant().is_none() {
        let next = &slope - &rest.derivative(var);
        let factor = checked_gcd(&rest, &next, work)?;
        rest = quotient(&rest, &factor, work)?;
        slope = quotient(&next, &factor, work)?;
        if !factor.is_one() {
            factors.push((factor, exponent));
        }
        exponent += 1;
    }
    Some(())
}

/// The greatest common divisor of two monomials.
fn meet(a: &Monomial, b: &Monomial) -> Monomial {
    if a.is_one() || b.is_one() {
        return Monomial::one();
    }
    Monomial::new(a.exponents().iter().zip(&b.exponents()).map(|(x, y)| *x.min(y)).listed())
}

/// The quotient, if one divides the other and the work is not spent.
fn quotient(a: &Poly, b: &Poly, work: &mut Work) -> Option<Poly> {
    let words = 1 + (a.max_bits() + b.max_bits()) / 64;
    work.spend((a.len() * b.len()) as u64 * words / 4)?;
    a.div_exact(b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::rational::Rational;
    use crate::tests::letters::{n, x, y, z};

    #[test]
    fn gcd_of_simple_cases() {
        assert_eq!(gcd(&Poly::zero(), &Poly::zero()), Poly::zero());
        assert_eq!(gcd(&Poly::zero(), &x().scale(&Rational::new(-2, 3))), x());
        assert_eq!(gcd(&n(6), &n(4)), n(1));
        assert_eq!(gcd(&(&x() * &y()), &(&x().pow(2) * &z())), x());
        assert_eq!(gcd(&(&x() - &y()), &(&y() - &x())), &x() - &y());
        assert_eq!(gcd(&(&(&x() + &n(1)) * &(&y() + &n(1))), &(&y().pow(2) - &n(1))), &y() + &n(1));
    }

    #[test]
    fn gcd_by_remainders() {
        let common = &(&(&x().pow(2) * &y()) + &(&z() * &x())) - &n(3);
        let a = &common * &(&(&x() * &z()) + &(&y().pow(3) + &n(1)));
        let b = &common * &(&(&x().pow(2) - &(&y() * &z())) + &n(7));
        assert_eq!(gcd(&a, &b), common);
        let scaled = gcd(&a.scale(&Rational::new(-5, 7)), &b.scale(&Rational::new(1, 9)));
        assert_eq!(scaled, common);
        assert_eq!(checked_gcd(&a, &b, &mut Work::new(50)), None);
    }

    #[test]
    fn square_free_decomposition() {
        let f = &(&x() - &y()) + &z();
        let g = &x().pow(2) + &y();
        let p = (&(&f.pow(2) * &g) * &(&z() - &n(1)).pow(3)).scale(&Rational::new(-3, 4));
        let p = &p * &y().pow(2);
        let parts = square_free(&p, &mut Work::unlimited()).expect("unlimited");
        assert_eq!(parts, vec![(g.clone(), 1), (f.clone(), 2), (y(), 2), (&z() - &n(1), 3)]);
        assert_eq!(square_free(&n(5), &mut Work::unlimited()), Some(vec![]));
        let square = &(&f * &x()) * &g.pow(2);
        let parts = square_free(&square.pow(2).scale(&Rational::new(5, 3)), &mut Work::unlimited());
        assert_eq!(parts, Some(vec![(f, 2), (x(), 2), (g, 4)]));
    }

    #[test]
    fn square_roots() {
        let p = &(&(&x() * &y()).scale(&Rational::from(3)) - &z().pow(2)) + &n(7);
        let root = |p: &Poly| square_root(p, &mut Work::unlimited());
        assert_eq!(root(&p.pow(2)), Some(p.clone()));
        assert_eq!(root(&(&p.pow(2) + &n(1))), None);
        assert_eq!(root(&(&p.pow(2) + &x())), None);
        assert_eq!(root(&p.pow(2).scale(&Rational::from(2))), None);
        assert_eq!(root(&-&p.pow(2)), None);
    }
}
