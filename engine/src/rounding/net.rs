//! Bounds of the errors of points of patches, in two stages: the Bernstein net that binding control points gives, and the
//! point of the net.
//!
//! With M the largest |Pₖ|, each element of the net is Cᵣ = Σₖ wᵣₖ Pₖ, |Cᵣ| ≤ Λ M, and is computed with an error of at most
//! b u M. The point V(C) = Σᵣ Bᵣ Cᵣ is computed from the net by sums and by products with nonnegative factors only: it is a sum
//! of terms w·Cᵣ, w ≥ 0, that roundings multiply by products of factors 1 + δ. These are farthest from 1 where all roundings go
//! up, and there the error for a net of ones is the sum of what they add. If that error is at most κ u, relative to V(1) = Σ Bᵣ,
//! whatever the roundings are, the error for any net is at most κ u max|Cᵣ| Σ Bᵣ. Together that is
//!
//! (κ (Λ + b u) + b) u M Σ Bᵣ.
//!
//! Σ Bᵣ is 1 where the coordinates add up to 1 in each factor of the domain, and for barycentric coordinates that do not a
//! power of their sum.

use super::absolute::{Absolute, MOST_SIGNED};
use super::cell::Cell;
use super::exact::Exact;
use super::{Bound, Error, Inputs, OnSpan, Part, on_each, rest, rounded_up, value};
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::model::Family;
use crate::plan::Input;
use crate::steps::{FamilySteps, Step, Steps};
use basis_prover::collections::list::Listed;
use std::rc::Rc;

/// The bound of a point of a patch in ε, relative to the largest |Pₖ|; `None` when nothing is found or the work is spent.
pub(super) fn patch_point(family: &Family, steps: &FamilySteps<'_>, work: &mut Work) -> Option<Bound> {
    let none = vec![0; family.domain.len()];
    let mut parts = Vec::new();
    let kappa = evaluation(family, &steps.patch(&none)?, &mut parts, work)?;
    let bind = steps.bind();
    let inputs = Inputs::of(family, family.functions.len());
    let mut exact = Exact::new(&bind, &inputs)?;
    let cells = Cell::grid(&inputs.region, &inputs.shapes.iter().map(|v| (*v, 2)).listed());
    let (mut error, mut size) = (Rational::ZERO, Rational::ZERO);
    let mut known: Vec<usize> = Vec::new();
    for output in &bind.outputs {
        if known.contains(output) {
            continue;
        }
        known.push(*output);
        let absolute = Absolute::new(&mut exact, *output, &inputs.points, MOST_SIGNED, work)?;
        let bounded = on_each(&cells, &mut |cell| absolute.on(&mut exact, cell, work))?;
        let sizes = on_each(&cells, &mut |cell| absolute.size_on(cell, work))?;
        for (largest, found) in [(&mut error, bounded), (&mut size, sizes)] {
            for (bound, part) in found {
                parts.push(Part { own: Some(bound.clone()), ..part });
                if bound > *largest {
                    *largest = bound;
                }
            }
        }
    }
    let computed = &size + &(&error * &rest::unit());
    let total = &(&kappa * &computed) + &error;
    let bound = rounded_up(Vec::new(), Error::Absolute, &total);
    Some(Bound { cells: parts, ..bound })
}

/// κ: the relative error in u of the point of a net of ones; with the parts that it follows from.
fn evaluation(family: &Family, steps: &Steps, parts: &mut Vec<Part>, work: &mut Work) -> Option<Rational> {
    let inputs = Inputs { ones: true, ..Inputs::of(family, 0) };
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
    let bound = value(&mut [OnSpan { exact, steps, inputs: &inputs }], 0, work)?;
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
