//! Checks sequences of projections, and the samples of open cells.

use super::elimination::resultant;
use super::sturm::Sturm;
use super::{Claim, check};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::decide::Relation;
use crate::decide::certificate::{Cells, Sample};

/// Checks that p and everything that has to be projected is made of the polynomials of the levels.
pub(super) fn projections(
    claim: &Claim<'_>,
    order: &[Var],
    levels: &[Vec<Poly>],
    trailing: bool,
) -> Result<(), String> {
    let mut sorted = order.to_vec();
    sorted.sort();
    let same = sorted.iter().eq(claim.ranges.iter().map(|(v, _)| v));
    check(same, || "the order of the variables lacks one or has another".into())?;
    check(levels.len() == order.len(), || "there is not one level for each variable".into())?;
    for (k, (var, level)) in order.iter().zip(levels).enumerate() {
        for (i, p) in level.iter().enumerate() {
            check(!level[..i].contains(p), || "a polynomial occurs twice".into())?;
            let lower = p.variables().iter().all(|v| order[..=k].contains(v));
            check(lower && p.depends_on(*var), || "a polynomial is on the wrong level".into())?;
        }
    }
    made_of(claim, &claim.poly, levels)?;
    for k in (1..order.len()).rev() {
        let (var, below) = (order[k], &levels[..k]);
        let range = claim.range(var)?;
        for (i, p) in levels[k].iter().enumerate() {
            let coefficients = p.coefficients_in(var);
            made_of(claim, coefficients.last().unwrap_or(p), below)?;
            for x in [range.low.value(), range.high.value()].into_iter().flatten() {
                let restriction = p.at(var, x);
                // The end itself may be a root everywhere.
                let linear = &Poly::var(var) - &Poly::constant(x.clone());
                if !(restriction.is_zero() && p.div_exact(&linear).is_some_and(|q| q.as_constant().is_some()))
                {
                    made_of(claim, &restriction, below)?;
                }
            }
            let is_variable = p.degree(var) == 1 && coefficients[0].is_zero();
            if trailing && !is_variable {
                made_of(claim, &coefficients[0], below)?;
            }
            if p.degree(var) > 1 {
                let discriminant = resultant(p, &p.derivative(var), var, &mut claim.work.borrow_mut())?;
                made_of(claim, &discriminant, below)?;
            }
            for q in &levels[k][i + 1..] {
                let resultant = resultant(p, q, var, &mut claim.work.borrow_mut())?;
                made_of(claim, &resultant, below)?;
            }
        }
    }
    Ok(())
}

/// Checks that a polynomial is a number different from zero times powers of given ones.
fn made_of(claim: &Claim<'_>, poly: &Poly, levels: &[Vec<Poly>]) -> Result<(), String> {
    let mut rest = poly.clone();
    check(!rest.is_zero(), || "a projection is zero".into())?;
    for factor in levels.iter().rev().flatten() {
        while rest.as_constant().is_none() {
            let words = 1 + (rest.max_bits() + factor.max_bits()) / 64;
            claim.spend((rest.len() * factor.len()) as u64 * words)?;
            let Some(quotient) = rest.div_exact(factor) else { break };
            rest = quotient;
        }
    }
    check(rest.as_constant().is_some(), || "a projection has a factor that the levels lack".into())
}

/// Checks an open cylindrical decomposition.
pub(super) fn cells(claim: &Claim<'_>, cells: &Cells) -> Result<(), String> {
    check(claim.relation == Relation::NonNegative, || "open cells are for p ≥ 0 only".into())?;
    projections(claim, &cells.order, &cells.levels, false)?;
    samples(claim, &cells.order, &cells.levels, &claim.poly, &cells.samples)
}

/// Checks the samples of a level and those above; the polynomials have the lower samples in place of their variables.
fn samples(
    claim: &Claim<'_>,
    order: &[Var],
    levels: &[Vec<Poly>],
    poly: &Poly,
    samples: &[Sample],
) -> Result<(), String> {
    let (Some((var, order)), Some((level, levels))) = (order.split_first(), levels.split_first()) else {
        check(samples.is_empty(), || "there are samples above the highest level".into())?;
        let value = poly.as_constant().ok_or("a variable is without a sample")?;
        return check(!value.is_negative(), || "p is negative at a sample".into());
    };
    let values: Vec<&Rational> = samples.iter().map(|s| &s.value).collect();
    let sturm = Sturm::new(level.iter(), *var, &mut claim.work.borrow_mut())?;
    claim.spend(sturm.cost(&values))?;
    sturm.separated(&values, claim.range(*var)?)?;
    for sample in samples {
        let at = |p: &Poly| p.at(*var, &sample.value);
        let words = |p: &Poly| 1 + (p.max_bits() + u64::from(p.degree(*var)) * sample.value.bits()) / 64;
        for p in levels.iter().flatten() {
            claim.spend(p.len() as u64 * words(p))?;
        }
        let levels: Vec<Vec<Poly>> = levels.iter().map(|level| level.iter().map(at).collect()).collect();
        self::samples(claim, order, &levels, &at(poly), &sample.above)?;
    }
    Ok(())
}
