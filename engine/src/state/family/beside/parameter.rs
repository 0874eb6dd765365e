//! Ladders along a shape parameter, instead of bounds for it, which say little where it is large.

use basis_prover::collections::list::Listed;

use super::Step;
use super::ladder::{Along, Ladder};
use super::sample::Sample;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Poly;
use crate::algebra::work::Work;
use crate::claim::Comparison;
use crate::model::angle::{Angle, Kind};
use crate::model::{Family, Function, Parameter};

/// The shape parameters that stand beside their sines in a value.
fn beside<'f>(family: &'f Family, value: &Fraction) -> Vec<(&'f Parameter, &'f Angle)> {
    let all = family.shapes.iter().filter_map(|p| family.analytic.angle(p.var).map(|angle| (p, angle)));
    let fits = |angle: &Angle| angle.kind != Kind::Linear && angle.itself != angle.var;
    all.filter(|(_, angle)| fits(angle) && value.depends_on(angle.itself)).listed()
}

/// Whether there is one.
pub(super) fn is_beside(family: &Family, value: &Fraction) -> bool {
    !beside(family, value).is_empty()
}

/// Whether the variable of the domain plays no part.
pub(super) fn is_alone(family: &Family, value: &Fraction) -> bool {
    family.domain.iter().all(|p| {
        let itself = family.analytic.angle(p.var).map_or(p.var, |angle| angle.itself);
        !value.depends_on(p.var) && !value.depends_on(itself)
    })
}

/// What is enough for a function of shape parameters to be ≥ 0, or > 0, by derivatives in the one that stands beside its sine.
pub(super) fn alone(
    family: &Family,
    of: &str,
    value: &Fraction,
    strict: bool,
    work: &mut Work,
) -> Option<Vec<Step>> {
    if !is_alone(family, value) || !family.constraints.is_empty() {
        return None;
    }
    let all = beside(family, value);
    let [(own, angle)] = all.as_slice() else { return None };
    let (domain, shapes) = family.shapes.iter().cloned().partition(|p| p.var == own.var);
    let function = Function { index: Vec::new(), value: value.clone() };
    let along = Family {
        functions: vec![function],
        pieces: Vec::new(),
        over: Poly::one(),
        simplices: Vec::new(),
        shapes,
        domain,
        ..family.clone()
    };
    let sample = Sample::new(&along, work)?;
    let mut ladder = Ladder::new(&along, angle, &own.range, &sample);
    ladder.start(of, value, strict, work)?;
    let whole = (own.var, own.range.clone());
    Some(ladder.found.into_iter().map(|step| Step { ranges: vec![whole.clone()], ..step }).listed())
}

/// What is enough for a step by derivatives in the parameter at the upper end of the domain, from where the variable is on, if it
/// stands beside its sine.
pub(super) fn instead(
    family: &Family,
    step: &Step,
    sample: &Sample<'_>,
    work: &mut Work,
) -> Option<Vec<Step>> {
    if !step.is_plain() || !family.constraints.is_empty() {
        return None;
    }
    let strict = step.comparison == Comparison::Greater;
    if is_alone(family, &step.value) {
        return alone(family, &step.of, &step.value, strict, work);
    }
    let all = beside(family, &step.value);
    let [(own, angle)] = all.as_slice() else { return None };
    let (var, ..) = family.interval()?;
    let variable = family.analytic.angle(var)?;
    let [low, high] = &variable.limits;
    // From the same number on, so that the way to a parameter begins at the variable.
    let fits = *high == Fraction::var(angle.itself)
        && *low == angle.limits[0]
        && low.as_constant().is_some()
        && [variable, angle].iter().all(|a| !a.ends[0].is_empty());
    if !fits {
        return None;
    }
    let mut ladder = Ladder::new(family, angle, &own.range, sample);
    ladder.along = Along::Parameter;
    ladder.start(&step.of, &step.value, strict, work)?;
    let mut all = ladder.found;
    if strict && family.domain.first()?.range.low.is_included() {
        let first = family.at_end(&step.value, false, work)?;
        let of = format!("{} at {}", step.of, variable.ends[0]);
        match alone(family, &of, &first, true, work) {
            Some(steps) => all.extend(steps),
            None => all.push(Step::new(of, first, Comparison::Greater)),
        }
    }
    for step in &mut all {
        if step.ranges.is_empty() {
            step.ranges.push((own.var, own.range.clone()));
        }
    }
    Some(all)
}
