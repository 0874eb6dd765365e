//! Bounds of the errors of points of patches, in two stages: the Bernstein net that binding control points gives, and the
//! point of the net.
//!
//! With M the largest |Pₖ|, each element of the net is Cᵣ = Σₖ wᵣₖ Pₖ, |Cᵣ| ≤ Λ M, and is computed with an error of at
//! most bᵣ u M. The point V(C) = Σᵣ Bᵣ Cᵣ is computed from the net by sums and by products with nonnegative factors
//! only: it is a sum of terms w·Cᵣ, w ≥ 0, that roundings multiply by products of factors 1 + δ. These are farthest
//! from 1 where all roundings go up, and there the error for a net whose elements are all Λ M, off by bᵣ u M, is the
//! sum of what they add. If that error is at most κ u, relative to Λ M V(1), V(1) = Σ Bᵣ, whatever the roundings are,
//! the error for any net is at most
//!
//! κ u Λ M Σ Bᵣ.
//!
//! Σ Bᵣ is 1 where the coordinates add up to 1 in each factor of the domain, and for barycentric coordinates that do not a
//! power of their sum.

use super::absolute::{Absolute, MOST_SIGNED};
use super::cell::Cell;
use super::exact::Exact;
use super::refine::{Lack, refined};
use super::{Bound, Error, Inputs, OnSpan, Part, rounded_up, value};
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::plan::Input;
use crate::steps::{FamilySteps, Step, Steps};
use std::rc::Rc;

/// The bound of a point of a patch in ε, relative to the largest |Pₖ|; `None` when nothing is found or the work is spent.
pub(super) fn patch_point(family: &Family, steps: &FamilySteps<'_>, work: &mut Work) -> Option<Bound> {
    let none = vec![0; family.domain.len()];
    let mut parts = Vec::new();
    let bound = binding(family, &steps.bind(), &mut parts, work)?;
    let size = bound.iter().map(|[_, size]| size.clone()).max()?;
    let off = |(k, [error, _]): (usize, &[Rational; 2])| {
        Some((Input::Bound(k), Poly::constant(size.clone()), error.checked_div(&size)?))
    };
    let net = bound.iter().enumerate().map(off).collect::<Option<Vec<_>>>()?;
    let kappa = evaluation(family, &steps.patch(&none)?, net, &mut parts, work)?;
    let bound = rounded_up(Vec::new(), Error::Absolute, &(&kappa * &size));
    Some(Bound { cells: parts, ..bound })
}

/// b and Λ of each coefficient that binding control points gives; with the parts that they follow from.
fn binding(
    family: &Family,
    bind: &Steps,
    parts: &mut Vec<Part>,
    work: &mut Work,
) -> Option<Vec<[Rational; 2]>> {
    // No coordinate occurs.
    let (of_intervals, simplices) = (Vec::new(), Vec::new());
    let inputs = Inputs { of_intervals, simplices, ..Inputs::of(family, family.functions.len()) };
    let mut exact = Exact::new(bind, &inputs)?;
    let mut known: Vec<(usize, [Rational; 2])> = Vec::new();
    let mut all = Vec::new();
    for (k, output) in bind.outputs.iter().enumerate() {
        if let Some((_, found)) = known.iter().find(|(other, _)| other == output) {
            all.push(found.clone());
            continue;
        }
        let share = work.left() / (8 * (bind.outputs.len() - k) as u64);
        let absolute = Absolute::new(&mut exact, *output, &inputs.points, MOST_SIGNED, work)?;
        let bounded = refined(&inputs, share, work, &mut |cell, work| {
            absolute.on(&mut exact, cell, work).ok_or(Lack::Here)
        })?;
        let sizes =
            refined(&inputs, share, work, &mut |cell, work| absolute.size_on(cell, work).ok_or(Lack::Here))?;
        let found = [bounded, sizes].map(|cells| {
            let mut largest = Rational::ZERO;
            for (bound, part) in cells {
                let own = part.own.clone().or_else(|| Some(bound.clone()));
                parts.push(Part { own, ..part });
                largest = largest.max(bound);
            }
            largest
        });
        known.push((*output, found.clone()));
        all.push(found);
    }
    Some(all)
}

/// κ: the relative error in u of the point of a net; with the parts that it follows from.
fn evaluation(
    family: &Family,
    steps: &Steps,
    net: Vec<(Input, Poly, Rational)>,
    parts: &mut Vec<Part>,
    work: &mut Work,
) -> Option<Rational> {
    let inputs = Inputs { off: net, ..Inputs::of(family, 0) };
    let mut exact = Exact::new(steps, &inputs)?;
    let factors = factors_of_net(steps)?;
    let [whole] = &Cell::grid(&inputs.region, &[])[..] else { return None };
    let mut conditions: Vec<Poly> = Vec::new();
    for k in factors {
        let factor = exact.value(k, work)?.as_poly()?.clone();
        if whole.sign(&factor, work) != Some(true) {
            return None;
        }
        if factor.as_constant().is_none() && !conditions.contains(&factor) {
            conditions.push(factor);
        }
    }
    parts.push(Part {
        domain: Rc::clone(&whole.domain),
        conditions,
        value: Poly::zero(),
        sums: Vec::new(),
        rest: Rational::ZERO,
        own: Some(Rational::ZERO),
    });
    let share = work.left() / 8;
    let bound = value(&mut [OnSpan { exact, steps, inputs: &inputs }], 0, share, work)?;
    let Error::Relative(epsilons) = &bound.error else { return None };
    let kappa = epsilons * &Rational::from(2);
    parts.extend(bound.cells.into_iter().map(|part| Part { own: Some(kappa.clone()), ..part }));
    Some(kappa)
}

/// The factors with which elements of the net are multiplied; `None` if anything else is done with them than such
/// products and sums.
fn factors_of_net(steps: &Steps) -> Option<Vec<usize>> {
    let mut of_net: Vec<bool> = Vec::new();
    let mut factors = Vec::new();
    for step in &steps.steps {
        let is = |k: &usize| of_net[*k];
        of_net.push(match step {
            Step::Input(Input::Bound(_)) => true,
            Step::Add(a, b) if is(a) && is(b) => true,
            Step::Mul(a, b) if is(a) != is(b) => {
                factors.push(if is(a) { *b } else { *a });
                true
            }
            _ if step.operands().iter().any(is) => return None,
            _ => false,
        });
    }
    Some(factors)
}
