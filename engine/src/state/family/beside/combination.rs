//! Signs of combinations of the functions of a family.
//!
//! **Theorem.** If g = Σ cⱼ·bⱼ with numbers cⱼ ≥ 0 and functions bⱼ ≥ 0, then g ≥ 0. Where some bⱼ with cⱼ > 0 is > 0, so is g.
//!
//! So 1 - b[1] is ≥ 0 where the functions sum to 1, although its derivative changes its sign the wrong way. Each
//! function goes a way of its own.

use basis_prover::algebra::matrix::vanishing_combinations;
use basis_prover::collections::list::{Listed, Mapped};

use super::Step;
use super::ladder::Ladder;
use super::sample::Sample;
use crate::algebra::fraction::Fraction;
use crate::algebra::range::End;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::Comparison;
use crate::model::Family;
use crate::model::angle::Angle;

/// What is enough for a value, which is a combination of some functions that are ≥ 0, to be > 0.
pub(super) fn positive(
    family: &Family,
    (of, value): (&str, &Fraction),
    parts: &[usize],
    sample: &Sample<'_>,
    work: &mut Work,
) -> Option<Vec<Step>> {
    let (var, ..) = family.interval()?;
    let angle = family.analytic.angle(var)?;
    let found = parts.iter().find_map(|position| {
        [true, false].into_iter().find_map(|upper| {
            let mut steps = positive_beside(family, angle, *position, upper, sample, work)?;
            let end = family.at_end(value, upper, work)?;
            let of = format!("{of} at {}", angle.ends[usize::from(upper)]);
            steps.push(Step::new(of, end, Comparison::Greater));
            Some(steps)
        })
    });
    super::all_bounded(family, found?, super::LEVEL, sample, work)
}

/// The positions of functions, more than one, of which a value is the sum with positive numbers.
pub(super) fn parts(family: &Family, value: &Fraction, work: &mut Work) -> Option<Vec<usize>> {
    let functions = family.functions.iter().map(|f| &f.value);
    let all = core::iter::once(value).chain(functions).listed();
    // An identity holds whatever stands for the variables, each of which is free: at more points than there are functions.
    let mut points = Vec::new();
    for k in 0_i64..4 * all.len() as i64 {
        let place = |v: usize| Rational::new((7 * k + 3 * v as i64 + k * v as i64) % 29 + 1, 31 + k);
        let point = (0..family.names.len()).map(place).listed();
        let column: Option<Vec<Rational>> = all.iter().map(|f| f.eval(&point)).collect();
        points.extend(column);
        if points.len() > all.len() {
            break;
        }
    }
    let rows = (0..all.len()).map(|row| points.mapped(|column| column[row].clone())).listed();
    let found = vanishing_combinations(&rows, work)?.into_iter().find(|c| !c[0].is_zero())?;
    let (own, others) = found.split_first()?;
    let mut rest = value.clone();
    let mut parts = Vec::new();
    for (position, number) in others.iter().enumerate().filter(|(_, number)| !number.is_zero()) {
        let number = (-number).checked_div(own)?;
        if number.is_negative() {
            return None;
        }
        let function = &family.functions[position].value;
        rest = rest.sub_within(&function.mul_within(&Fraction::constant(number.clone()), work)?, work)?;
        parts.push(position);
    }
    (parts.len() > 1 && family.analytic.reduced(rest).is_zero()).then_some(parts)
}

/// What is enough for a function to be > 0 on the domain without one of its ends.
fn positive_beside(
    family: &Family,
    angle: &Angle,
    position: usize,
    upper: bool,
    sample: &Sample<'_>,
    work: &mut Work,
) -> Option<Vec<Step>> {
    let mut range = family.domain.first()?.range.clone();
    let end = if upper { &mut range.high } else { &mut range.low };
    *end = End::Excluded(end.value()?.clone());
    let mut ladder = Ladder::new(family, angle, &range, sample);
    ladder.start(&family.function_label(position), &family.functions[position].value, true, work)?;
    let mut found = ladder.found;
    for step in &mut found {
        if step.ranges.iter().all(|(var, _)| *var != angle.var) {
            step.ranges.push((angle.var, range.clone()));
        }
    }
    Some(found)
}
