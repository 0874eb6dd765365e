//! Checks subdivisions by computing the Bernstein coefficients of every cell anew.

use super::{CellCoefficients, Claim, check, inside};
use crate::algebra::poly::{Monomial, Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::{Rational, binomial};
use crate::decide::Relation;
use crate::decide::certificate::Subdivision;

/// Cells within each other.
const MAX_DEPTH: usize = 300;
/// The most coefficients on a cell.
const MAX_SIZE: u64 = 200_000;

/// Checks all cells.
pub(super) fn subdivision(claim: &Claim<'_>, tree: &Subdivision) -> Result<(), String> {
    let size = claim.ranges.iter().try_fold(1_u64, |n, (v, _)| {
        n.checked_mul(u64::from(claim.poly.degree(*v)) + 1).filter(|n| *n <= MAX_SIZE)
    });
    check(size.is_some(), || "there are too many coefficients".into())?;
    // The way to the cell stands on a list, so that depth costs no stack.
    let mut cells = vec![(tree, claim.ranges.clone(), 0)];
    while let Some((tree, ranges, depth)) = cells.pop() {
        check(depth < MAX_DEPTH, || "the subdivision is too deep".into())?;
        match tree {
            Subdivision::Leaf => leaf(claim, &ranges)?,
            Subdivision::Split { var, at, low, high } => {
                let k = ranges
                    .iter()
                    .position(|(v, _)| v == var)
                    .ok_or("a cell is cut along an unknown variable")?;
                check(inside(&ranges[k].1, at), || format!("the cut at {at} misses its cell"))?;
                let (mut lower, mut upper) = (ranges.clone(), ranges);
                lower[k].1.high = End::Included(at.clone());
                upper[k].1.low = End::Included(at.clone());
                cells.push((high, upper, depth + 1));
                cells.push((low, lower, depth + 1));
            }
        }
    }
    Ok(())
}

fn leaf(claim: &Claim<'_>, ranges: &[(Var, Range)]) -> Result<(), String> {
    claim.spend(cost(&claim.poly, ranges))?;
    let form = coefficients(&claim.poly, ranges)?;
    claim.cells.borrow_mut().push(listed(&claim.poly, &form, ranges));
    check(form.terms().all(|(_, c)| !c.is_negative()), || "a Bernstein coefficient is negative".into())?;
    if claim.relation == Relation::NonNegative {
        return Ok(());
    }
    // On every smallest face that belongs to the region a coefficient must be positive.
    let degree = |v: Var| claim.poly.degree(v) as u16;
    let mut faces: Vec<Vec<(Var, u16)>> = vec![Vec::new()];
    for (var, range) in ranges {
        let mut ends = Vec::new();
        if range.low.is_included() {
            ends.push(0);
        }
        if range.high.is_included() {
            ends.push(degree(*var));
        }
        if !ends.is_empty() {
            let with = |face: &Vec<(Var, u16)>, end: u16| [&face[..], &[(*var, end)]].concat();
            faces = faces.iter().flat_map(|f| ends.iter().map(move |e| with(f, *e))).collect();
        }
        check(faces.len() <= 1 << 12, || "there are too many faces".into())?;
    }
    let positive =
        |face: &Vec<(Var, u16)>| form.terms().any(|(m, _)| face.iter().all(|(v, e)| m.exponent(*v) == *e));
    check(faces.iter().all(positive), || "the polynomial vanishes on a face of a cell".into())
}

/// How many operations on machine words the coefficients take: a conversion along every variable, with products of numbers
/// that grow with each of them.
pub(super) fn cost(poly: &Poly, ranges: &[(Var, Range)]) -> u64 {
    let mut bits = poly.max_bits();
    let mut size = 1_u64;
    let mut sum = 0_u64;
    for (var, range) in ranges {
        let degree = u64::from(poly.degree(*var));
        let ends = [&range.low, &range.high].into_iter().filter_map(|e| e.value());
        let end = ends.map(Rational::bits).sum::<u64>();
        bits = bits.saturating_add(degree.saturating_mul(end));
        size = size.saturating_mul(degree + 1);
        let product = (1 + bits / 64).saturating_mul(1 + end / 64);
        sum = sum.saturating_add((degree + 1).saturating_mul(product));
    }
    size.saturating_mul(sum)
}

/// The coefficients of all indices.
fn listed(poly: &Poly, form: &Poly, ranges: &[(Var, Range)]) -> CellCoefficients {
    let mut monomials = vec![Monomial::one()];
    for (var, _) in ranges {
        let raised = |m: &Monomial| {
            (0..=poly.degree(*var) as u16).map(|e| m.with_exponent(*var, e)).collect::<Vec<_>>()
        };
        monomials = monomials.iter().flat_map(raised).collect();
    }
    monomials.iter().map(|m| form.coefficient(m)).collect()
}

/// The tensor of Bernstein coefficients as a polynomial: the coefficient of index (i, j, …) is that of xⁱ yʲ ….
///
/// On a finite side bᵢ = Σⱼ C(i, j)/C(n, j) qⱼ for p(low + (high − low)·s) = Σ qⱼ sʲ. On x ≥ low, with x = low + s/(1 − s),
/// it is bⱼ = qⱼ/C(n, j) for p(low + s) = Σ qⱼ sʲ; on x ≤ high the same for p(high − s) with the order reversed.
pub(super) fn coefficients(poly: &Poly, ranges: &[(Var, Range)]) -> Result<Poly, String> {
    let mut form = poly.clone();
    for (var, range) in ranges {
        let n = poly.degree(*var);
        let (start, slope) = match (range.low.value(), range.high.value()) {
            (Some(a), Some(b)) => (a, b - a),
            (Some(a), None) => (a, Rational::ONE),
            (None, Some(b)) => (b, Rational::from(-1)),
            (None, None) => return Err("a cell has a side without ends".into()),
        };
        let line = &Poly::constant(start.clone()) + &Poly::var(*var).scale(&slope);
        let q = form.substitute(*var, &line).coefficients_in(*var);
        let divided = |j: u32| {
            let c = binomial(n, j).recip().unwrap_or(Rational::ONE);
            q.get(j as usize).map_or_else(Poly::zero, |p| p.scale(&c))
        };
        let b: Vec<Poly> = match (&range.low, &range.high) {
            (End::Infinite, _) => (0..=n).rev().map(divided).collect(),
            (_, End::Infinite) => (0..=n).map(divided).collect(),
            _ => {
                let sum = |i: u32| (0..=i).fold(Poly::zero(), |s, j| &s + &divided(j).scale(&binomial(i, j)));
                (0..=n).map(sum).collect()
            }
        };
        form = Poly::from_coefficients(*var, &b);
    }
    Ok(form)
}
