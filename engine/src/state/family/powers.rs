//! Functions that touch 0 at an irrational point, as √2 − sin(t) − cos(t) does at π/4.
//!
//! With x = tan(t/2) and r = tan(π/8) that is (r + 2)·x² − 2·x + r over a positive denominator, in which r is a variable
//! between bounds: there are values next to r at which it is negative. It is (r + 2)·(x − r)² because r² + 2·r = 1.
//!
//! **Theorem.** Polynomials that differ by a multiple of the minimal polynomial of r have the same value at r.
//!
//! So a numerator may be written as the product of its multiple factors over Q(r), which are not multiplied out modulo
//! the minimal polynomial, and of what is left. The factors are those of D. Y. Y. Yun, "On square-free decomposition
//! algorithms" (1976), of what all coefficients have in common, as polynomials in one variable over Q(r). On a domain that ends at
//! a shape parameter they are looked for in tan(t/2) itself.
//!
//! **Theorem.** Σ cₖ·B(n, k)(λ) ≥ 0 for a ≤ λ ≤ b if all cₖ ≥ 0, and Σ cₖ·(λ − a)ᵏ ≥ 0 for λ ≥ a.
//!
//! So √2 + λ − sin(t) − cos(t) ≥ 0 for 0 ≤ λ ≤ 1 follows from what is left of it at both ends, of which the first one is a product.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::real::field::{Element, Field};
use crate::algebra::univariate::{ToPoly as _, Univariate};
use crate::algebra::work::Work;
use crate::model::bernstein::{affine, bernstein_on};
use crate::model::roots::Root;
use crate::model::{Family, Parameter};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;

/// A polynomial in one variable over Q(r), constant first, without leading zeros.
type Over = Vec<Element>;

/// The work for powers, which is little beside that of a proof.
const POWERS: u64 = 1_000_000;

/// What is enough for a value to be ≥ 0, or > 0, or for its negative, where that needs factors that are powers only for the number
/// tan(π/n) in it: the value with these factors, or what it is at the ends of ranges of shape parameters, some of it with such
/// factors. Each with its name; `None` if there are none, or the work is spent.
pub(super) fn enough(family: &Family, of: &str, value: &Fraction) -> Option<Vec<(String, Fraction)>> {
    if !family.analytic.roots.iter().any(|root| value.numer().depends_on(root.var)) {
        return None;
    }
    let powers = with_powers(family, value).or_else(|| with_powers_of_the_tangent(family, value));
    if let Some(value) = powers {
        return Some(vec![(String::from(of), value)]);
    }
    let varying = |p: &&Parameter| value.numer().depends_on(p.var) && !value.denom().depends_on(p.var);
    family.shapes.iter().filter(varying).find_map(|p| {
        let parts = coefficients(value, p)?;
        let count = parts.len();
        let mut all = Vec::new();
        let mut has_powers = false;
        for (k, part) in parts.into_iter().enumerate() {
            let of = format!("coefficient {k} of {of} in {}", family.name_of(p));
            // Without powers at an end the value itself is as good.
            let found = if k == 0 || k + 1 == count { enough(family, &of, &part) } else { None };
            has_powers |= found.is_some();
            all.extend(found.unwrap_or_else(|| vec![(of, part)]));
        }
        has_powers.then_some(all)
    })
}

/// The coefficients of a value in a parameter, which are to be ≥ 0: in the Bernstein basis of its range, or in powers of the
/// distance from the only end.
fn coefficients(value: &Fraction, p: &Parameter) -> Option<Vec<Fraction>> {
    let (own, low) = (value.numer(), p.range.low.value()?);
    let parts = match p.range.high.value() {
        Some(high) => bernstein_on(own, p.var, [low, high], own.degree(p.var)),
        None => affine(&own.coefficients_in(p.var), low, &Rational::ONE),
    };
    parts.into_iter().map(|part| Fraction::new(part, value.denom().clone())).collect()
}

/// The same value with powers as factors that are such in the tangent of the domain variable, of which its own variable is the
/// part between ends that depend on shape parameters.
fn with_powers_of_the_tangent(family: &Family, value: &Fraction) -> Option<Fraction> {
    let (var, ..) = family.interval()?;
    let angle = family.analytic.angle(var).filter(|a| a.itself != var && !value.depends_on(a.itself))?;
    let is_shape = |v: Var| family.shapes.iter().any(|p| p.var == v);
    let depends = [&angle.low, &angle.width]
        .iter()
        .any(|f| [f.numer(), f.denom()].iter().any(|p| p.variables().into_iter().any(is_shape)));
    if !depends {
        return None;
    }
    let (tangent, found) = basis_prover::working_with(POWERS, &mut |work| {
        let y = Fraction::var(var).sub_within(&angle.low, work)?.div_within(&angle.width, work).ok()??;
        let tangent = value.substitute_within(var, &y, work).ok()??;
        Some((tangent.clone(), with_powers(family, &tangent)?))
    })?;
    // What stands below is the same up to what the substitution brings, so that only the numerator is put back.
    let below = Fraction::from(tangent.denom().clone());
    let back = |f: &Fraction| f.substitute(var, &angle.tangent());
    let found = back(&Fraction::from(found.numer().clone()))?.checked_div(&back(&below)?)?;
    let same = family.analytic.reduced(&found - value);
    same.is_zero().then_some(found)
}

/// The same value, with factors in the numerator as powers that are such only for the number tan(π/n) in it; `None` if
/// there are none, or the work is spent.
fn with_powers(family: &Family, value: &Fraction) -> Option<Fraction> {
    let above = value.numer();
    let mut own = family.analytic.roots.iter().filter(|root| above.depends_on(root.var));
    let (Some(root), None) = (own.next(), own.next()) else { return None };
    let variables = above.variables().into_iter().filter(|v| *v != root.var).listed();
    let found = basis_prover::working_with(POWERS, &mut |work| {
        variables.iter().find_map(|var| powers(above, *var, root, work))
    })?;
    let same = |f: Fraction| family.analytic.reduced(f);
    // It has been found modulo the minimal polynomial; that nothing else has changed is seen once more.
    same(Fraction::from(&found - above)).is_zero().then(|| Fraction::new(found, value.denom().clone()))?
}

/// A polynomial with the same value at r in which powers of polynomials in one of the variables are factors.
fn powers(p: &Poly, var: Var, root: &Root, work: &mut Work) -> Option<Poly> {
    let mut field = Field::new(root.number.clone());
    let mut parts = parts(p, var, root.var)?;
    let mut common = Over::new();
    for (_, part) in &parts {
        common = monic(&mut field, part.clone(), common, work)?;
        if common.len() < 3 {
            return None;
        }
    }
    let mut product = Poly::one();
    for (factor, exponent) in square_free(&mut field, &common, work)? {
        // Powers with rational coefficients are seen as they are.
        if exponent < 2 || factor.iter().all(Element::is_constant) {
            continue;
        }
        for (_, part) in &mut parts {
            for _ in 0..exponent {
                *part = quotient(&field, part, &factor, work)?;
            }
        }
        let power = to_poly(&factor, var, root.var).pow(exponent);
        work.spend_product(&product, &power)?;
        product = &product * &power;
    }
    if product.is_one() {
        return None;
    }
    let mut rest = Poly::zero();
    for (others, part) in parts {
        let monomial = Poly::from_terms([(Monomial::new(others), Rational::ONE)]);
        rest = &rest + &(&monomial * &to_poly(&part, var, root.var));
    }
    work.spend_product(&product, &rest)?;
    Some(&product * &rest)
}

/// The coefficients of the monomials in the other variables, by the exponents of these.
fn parts(p: &Poly, var: Var, root: Var) -> Option<Vec<(Vec<u16>, Over)>> {
    let mut found: SortedMap<Vec<u16>, Vec<Vec<Rational>>> = SortedMap::new();
    for (m, c) in p.terms() {
        let others = m.with_exponent(var, 0).with_exponent(root, 0).exponents();
        let (i, j) = (usize::from(m.exponent(var)), usize::from(m.exponent(root)));
        let rows = found.get_or_insert_with(others, Vec::new);
        rows.resize(rows.len().max(i + 1), Vec::new());
        let row = rows.get_mut(i)?;
        row.resize(row.len().max(j + 1), Rational::ZERO);
        *row.get_mut(j)? = c.clone();
    }
    let over = |rows: &Vec<Vec<Rational>>| rows.iter().cloned().map(Univariate::new).listed();
    Some(found.iter().map(|(others, rows)| (others.clone(), over(rows))).listed())
}

/// The greatest common divisor with the leading coefficient 1; of 0 and 0 it is 0.
fn monic(field: &mut Field, a: Over, b: Over, work: &mut Work) -> Option<Over> {
    let common = field.common_divisor(a, b, work)?;
    let Some(leading) = common.last() else { return Some(common) };
    let per = field.inverse(leading, work)?;
    common.iter().map(|c| field.mul(c, &per, work)).collect()
}

/// The quotient by a divisor with the leading coefficient 1; `None` if a rest is left.
fn quotient(field: &Field, p: &Over, by: &Over, work: &mut Work) -> Option<Over> {
    let mut rest = p.clone();
    let mut found = Over::new();
    while rest.len() >= by.len() {
        let top = field.reduce(&rest.pop()?, work)?;
        let (shift, minus) = (rest.len() + 1 - by.len(), top.scale(&Rational::from(-1)));
        for (k, c) in by[..by.len() - 1].iter().enumerate() {
            rest[shift + k] = rest[shift + k].add(&field.mul(c, &minus, work)?);
        }
        found.push(top);
    }
    for c in rest {
        if !field.reduce(&c, work)?.is_zero() {
            return None;
        }
    }
    found.reverse();
    Some(found)
}

/// The factors of a polynomial with the leading coefficient 1 that have no factor in common, with their exponents.
fn square_free(field: &mut Field, p: &Over, work: &mut Work) -> Option<Vec<(Over, u32)>> {
    let slope = p.iter().enumerate().skip(1).map(|(k, c)| c.scale(&Rational::from(k as i64))).listed();
    let mut others = monic(field, p.clone(), slope, work)?;
    let mut own = quotient(field, p, &others, work)?;
    let (mut found, mut exponent) = (Vec::new(), 1);
    while own.len() > 1 {
        let next = monic(field, own.clone(), others.clone(), work)?;
        let factor = quotient(field, &own, &next, work)?;
        others = quotient(field, &others, &next, work)?;
        if factor.len() > 1 {
            found.push((factor, exponent));
        }
        (own, exponent) = (next, exponent + 1);
    }
    Some(found)
}

fn to_poly(p: &Over, var: Var, root: Var) -> Poly {
    let x = Poly::var(var);
    p.mapped(|c| c.to_poly(root)).iter().rev().fold(Poly::zero(), |sum, c| &(&sum * &x) + c)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claim::ClaimKind;
    use crate::subject::Subject;
    use crate::{Library, Selected, Source};
    use basis_prover::{cut_short_within, measured};

    /// Until it was counted, a claim took work for it that no share of a run had.
    #[test]
    fn the_work_is_that_of_the_claim() {
        let spec = "family F {
            domain 0 <= t <= pi/2;
            b[0] = sin(t) + cos(t);
            prove b[0] <= 2*sin(pi/4);
        }";
        let library = Library::from_source(&crate::Disk, &crate::Prover, Source::text("powers.basis", spec));
        let item = library.items(Selected::EveryOrder).remove(0);
        let Subject::Family(family) = &item.subject else { panic!("a family") };
        // With tan(π/8), which the functions do not need.
        let family = item.claims[0].about.as_deref().unwrap_or(family);
        let ClaimKind::Relation { differences, .. } = &item.claims[0].kind else { panic!("a comparison") };
        let value = &differences[0].1.value;
        let (found, units) = measured(&mut || enough(family, "b[0]", value));
        assert!(found.is_some_and(|found| found.len() == 1) && units > 100, "{units} units");
        let (found, is_cut) = cut_short_within(units / 2, &mut || enough(family, "b[0]", value));
        assert!(found.is_none() && is_cut);
    }
}
