//! Signs from sample points: projections, and one point in each open cell of a decomposition.
//!
//! **Theorem** (Collins; McCallum; Strzeboński for open cells). Let p be made of polynomials of the highest level, and
//! the leading coefficients, discriminants, pairwise resultants and restrictions to the ends of the range of each level
//! be made of polynomials of the lower ones. Over an open cell of the lower variables on which none of those vanishes,
//! the roots of the level are continuous and keep apart: p has one sign on each of the open cells between them. The
//! open cells together are dense in the box; so p ≥ 0 if it is at one point of each.

use super::claim::{Claim, divided};
use super::elimination::resultant;
use super::sturm::Sturm;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::certificate::{Cells, Sample};
use crate::collections::sort::sort;
use crate::refusal::{Refusal, fits, shown};
use crate::statement::Relation;

/// Checks that p and everything that has to be projected is made of the polynomials of the levels.
pub(super) fn projections(
    claim: &Claim,
    order: &[Var],
    levels: &[Vec<Poly>],
    trailing: bool,
    work: &mut Work,
) -> Result<(), Refusal> {
    let mut sorted = order.to_vec();
    sort(&mut sorted);
    let same = sorted.iter().eq(claim.ranges.iter().map(|(v, _)| v));
    fits(same, "the order of the variables lacks one or has another")?;
    fits(levels.len() == order.len(), "there is not one level for each variable")?;
    for (k, (var, level)) in order.iter().zip(levels).enumerate() {
        for (i, p) in level.iter().enumerate() {
            fits(!level[..i].contains(p), "a polynomial occurs twice")?;
            let lower = p.variables().iter().all(|v| order[..=k].contains(v));
            fits(lower && p.depends_on(*var), "a polynomial is on the wrong level")?;
        }
    }
    made_of(&claim.poly, levels, work)?;
    for k in (1..order.len()).rev() {
        let (var, below) = (order[k], &levels[..k]);
        let range = claim.range(var)?;
        for (i, p) in levels[k].iter().enumerate() {
            let coefficients = p.coefficients_in(var);
            made_of(coefficients.last().unwrap_or(p), below, work)?;
            for x in [range.low.value(), range.high.value()].into_iter().flatten() {
                work.spend_at(p, var, x).ok_or(Refusal::Spent)?;
                let restriction = p.at(var, x);
                // The end itself may be a root everywhere.
                let linear = &Poly::var(var) - &Poly::constant(x.clone());
                if !(restriction.is_zero() && p.div_exact(&linear).is_some_and(|q| q.as_constant().is_some()))
                {
                    made_of(&restriction, below, work)?;
                }
            }
            let is_variable = p.degree(var) == 1 && coefficients[0].is_zero();
            if trailing && !is_variable {
                made_of(&coefficients[0], below, work)?;
            }
            if p.degree(var) > 1 {
                let discriminant = resultant(p, &p.derivative(var), var, work)?;
                made_of(&discriminant, below, work)?;
            }
            for q in &levels[k][i + 1..] {
                let resultant = resultant(p, q, var, work)?;
                made_of(&resultant, below, work)?;
            }
        }
    }
    Ok(())
}

/// Checks that a polynomial is a number different from zero times powers of given ones.
fn made_of(poly: &Poly, levels: &[Vec<Poly>], work: &mut Work) -> Result<(), Refusal> {
    let mut rest = poly.clone();
    shown(!rest.is_zero(), "a projection is zero")?;
    for factor in levels.iter().rev().flatten() {
        rest = divided(rest, factor, work)?.0;
    }
    shown(rest.as_constant().is_some(), "a projection has a factor that the levels lack")
}

/// Checks an open cylindrical decomposition.
pub(super) fn cells(claim: &Claim, cells: &Cells, work: &mut Work) -> Result<(), Refusal> {
    fits(claim.relation == Relation::NonNegative, "open cells are for p ≥ 0 only")?;
    projections(claim, &cells.order, &cells.levels, false, work)?;
    samples(claim, (&cells.order, &cells.levels), &claim.poly, &cells.samples, work)
}

/// Checks the samples of a level and those above; the polynomials have the lower samples in place of their variables.
fn samples(
    claim: &Claim,
    (order, levels): (&[Var], &[Vec<Poly>]),
    poly: &Poly,
    samples: &[Sample],
    work: &mut Work,
) -> Result<(), Refusal> {
    let (Some((var, order)), Some((level, levels))) = (order.split_first(), levels.split_first()) else {
        fits(samples.is_empty(), "there are samples above the highest level")?;
        let value = poly.as_constant().ok_or(Refusal::Unfit("a variable is without a sample"))?;
        return shown(!value.is_negative(), "p is negative at a sample");
    };
    let values: Vec<&Rational> = samples.iter().map(|s| &s.value).collect();
    let sturm = Sturm::new(level.iter(), *var, work)?;
    work.spend(sturm.cost(&values)).ok_or(Refusal::Spent)?;
    sturm.separated(&values, claim.range(*var)?)?;
    for sample in samples {
        let at = |p: &Poly| p.at(*var, &sample.value);
        for p in levels.iter().flatten().chain([poly]) {
            work.spend_at(p, *var, &sample.value).ok_or(Refusal::Spent)?;
        }
        let levels: Vec<Vec<Poly>> = levels.iter().map(|level| level.iter().map(at).collect()).collect();
        self::samples(claim, (order, &levels), &at(poly), &sample.above, work)?;
    }
    Ok(())
}
