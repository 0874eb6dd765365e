//! Ladders along a shape parameter, instead of bounds for it, which say little where it is large.

use super::Step;
use super::ladder::{Along, Ladder, alone, beside, is_alone};
use super::sample::Sample;
use crate::algebra::fraction::Fraction;
use crate::algebra::work::Work;
use crate::claim::Comparison;
use crate::model::Family;

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
