//! A domain in parts, cut where a function or its slope vanishes at a definite number.
//!
//! A function that touches 0 inside of the domain, as exp(t) − t·exp(1) does at t = 1, falls before and rises after that point: no
//! ladder leads from one end of the domain to the other, and no bounds in place of t are narrow enough there. Up to that point,
//! and from there on, it is a function whose value at one end is exactly 0.
//!
//! **Theorem.** What holds on all parts of a domain holds on the domain.
//!
//! The points are multiples of the numbers of which exp(r) and tan(π/n) are made, so that the tangent at them is a quotient of
//! polynomials in these. That something vanishes there says where to cut, and is no part of a proof.

use basis_prover::collections::list::Listed;

use super::ladder::Ladder;
use super::sample::Sample;
use super::{Step, all_bounded, cells, values};
use crate::algebra::fraction::{Fraction, set_known_factors};
use crate::algebra::poly::Poly;
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::Comparison;
use crate::model::angle::{Angle, Kind, multiple_of_pi};
use crate::model::{Family, Function};

/// Multiples of a number on one side of 0 that are looked at, and points at which a domain is cut.
const MULTIPLES: i64 = 24;
const MAX_CUTS: usize = 4;

/// A point of the domain, or one of its ends.
#[derive(Clone)]
struct Place {
    /// The variable that stands for the tangent there.
    y: Fraction,
    /// The angle or exponent itself.
    itself: Fraction,
    text: String,
    is_included: bool,
}

/// What is enough for a function, by ladders on the parts of the domain between such points; where there is none, or the ends of
/// the domain depend on shape parameters, nothing.
pub(super) fn steps(
    family: &Family,
    angle: &Angle,
    whole: &Step,
    level: u32,
    sample: &Sample<'_>,
    work: &mut Work,
) -> Option<Vec<Step>> {
    let numbers = family.analytic.numbers();
    let is_number = |f: &Fraction| {
        [f.numer(), f.denom()].iter().all(|p| p.variables().iter().all(|v| numbers.contains(v)))
    };
    if ![&angle.low, &angle.width].into_iter().chain(&angle.limits).all(is_number)
        || angle.ends.iter().any(String::is_empty)
    {
        return None;
    }
    let places = places(family, angle, &whole.value, sample, work)?;
    let mut all = Vec::new();
    for (k, pair) in places.windows(2).enumerate() {
        let [low, high] = pair else { continue };
        let of = format!("{} [part {} of {}]", whole.of, k + 1, places.len() - 1);
        let part = part(family, angle, &whole.value, [low, high], work)?;
        set_known_factors(part.analytic.denominators());
        let found = on_part(&part, &Step { of, ..whole.clone() }, level, work);
        set_known_factors(family.analytic.denominators());
        all.extend(found?);
    }
    Some(all)
}

/// What is enough on a part: by a ladder, or with bounds from both of its ends.
fn on_part(part: &Family, whole: &Step, level: u32, work: &mut Work) -> Option<Vec<Step>> {
    let (var, ..) = part.interval()?;
    let angle = part.analytic.angle(var)?;
    let range = &part.domain.first()?.range;
    let value = &part.functions.first()?.value;
    let sample = Sample::new(part, work)?;
    let mut ladder = Ladder::new(part, angle, range, &sample);
    let strict = whole.comparison == Comparison::Greater;
    let found = match ladder.start(&whole.of, value, strict, work) {
        Some(()) => ladder.found,
        None => cells(angle, range, &sample, &Step { value: value.clone(), ..whole.clone() })?,
    };
    let mut all = all_bounded(part, found, level, &sample, work)?;
    for step in &mut all {
        if step.ranges.iter().all(|(v, _)| *v != var) {
            step.ranges.push((var, range.clone()));
        }
    }
    Some(all)
}

/// The family on a part of its domain, between whose ends its variable runs from 0 to 1, with one function alone.
fn part(
    family: &Family,
    angle: &Angle,
    value: &Fraction,
    [low, high]: [&Place; 2],
    work: &mut Work,
) -> Option<Family> {
    let mut part = Family { pieces: Vec::new(), over: Poly::one(), ..family.clone() };
    let span = high.y.sub_within(&low.y, work)?;
    let y = low.y.add_within(&span.mul_within(&Fraction::var(angle.var), work)?, work)?;
    let own = part.analytic.angles.iter_mut().find(|a| a.var == angle.var)?;
    own.low = angle.low.add_within(&angle.width.mul_within(&low.y, work)?, work)?;
    own.width = angle.width.mul_within(&span, work)?;
    own.limits = [low.itself.clone(), high.itself.clone()];
    own.ends = [low.text.clone(), high.text.clone()];
    own.mirror = Vec::new();
    let end = |place: &Place, x: Rational| {
        if place.is_included { End::Included(x) } else { End::Excluded(x) }
    };
    part.domain.first_mut()?.range = Range { low: end(low, Rational::ZERO), high: end(high, Rational::ONE) };
    let value = value.substitute_within(angle.var, &y, work).ok()??;
    part.functions = vec![Function { index: Vec::new(), value: family.analytic.reduced(value) }];
    Some(part)
}

/// The ends of the domain and, in between, the points at which a function or its slope vanishes; `None` if there is none.
fn places(
    family: &Family,
    angle: &Angle,
    value: &Fraction,
    sample: &Sample<'_>,
    work: &mut Work,
) -> Option<Vec<Place>> {
    let range = &family.domain.first()?.range;
    let (low, high) = range.finite()?;
    let typical = sample.typical();
    let slope = family.derivative_within(value, angle.var, work)?;
    let mut found: Vec<(Rational, Place)> = Vec::new();
    for (x, itself, text) in numbers(family, angle)? {
        let y = x.sub_within(&angle.low, work)?.div_within(&angle.width, work).ok()??;
        let place = Place { y, itself, text, is_included: true };
        let at = (angle, &place.y, &place.itself);
        let about = |f: &Fraction, work: &mut Work| values::about_at(family, f, at, &typical, work);
        let Some(own) = about(&place.y, work) else { continue };
        if !(*low < own.0 && own.1 < *high) || found.iter().any(|(y, _)| own.0 <= *y && *y <= own.1) {
            continue;
        }
        for f in [value, &slope] {
            let may_vanish = about(f, work).is_some_and(|(a, b)| a.signum() * b.signum() <= 0);
            if !may_vanish {
                continue;
            }
            let there = f.substitute_within(angle.var, &place.y, work).ok()??;
            let there = there.substitute_within(angle.itself, &place.itself, work).ok()??;
            if family.analytic.reduced(there).is_zero() {
                found.push((own.0.clone(), place));
                break;
            }
        }
    }
    if found.is_empty() || found.len() > MAX_CUTS {
        return None;
    }
    basis_prover::collections::sort::sort_by(&mut found, |a, b| a.0.cmp(&b.0));
    let end = |side: usize| {
        let end = [&range.low, &range.high][side];
        Some(Place {
            y: Fraction::constant(end.value()?.clone()),
            itself: angle.limits[side].clone(),
            text: angle.ends[side].clone(),
            is_included: end.is_included(),
        })
    };
    let mut all = vec![end(0)?];
    all.extend(found.into_iter().map(|(_, place)| place));
    all.push(end(1)?);
    Some(all)
}

/// Numbers whose tangents are quotients of polynomials in exp(r), or in a number tan(π/n): tangents, values and texts.
fn numbers(family: &Family, angle: &Angle) -> Option<Vec<(Fraction, Fraction, String)>> {
    let analytic = &family.analytic;
    let one = Fraction::constant(Rational::ONE);
    let mut all = Vec::new();
    // tan(π/n) and n, in whose multiples the angle v·(s − shift) is.
    let circular: Vec<(Fraction, i64)> = match angle.kind {
        Kind::Linear => return None,
        Kind::Hyperbolic => {
            let (var, r) = analytic.exponential.as_ref()?;
            // exp(2·v·s) = exp(r)ᵏ.
            let unit = r.checked_div(&(&angle.rate * &Rational::from(2)))?;
            let mut power = one.clone();
            for k in 1..=MULTIPLES {
                power = &power * &Fraction::var(*var);
                let tangent = (&power - &one).checked_div(&(&power + &one))?;
                let value = &unit * &Rational::from(k);
                let both = [(tangent.clone(), value.clone()), (-&tangent, -value)];
                for (tangent, value) in both {
                    all.push((tangent, Fraction::constant(value.clone()), value.to_string()));
                }
            }
            Vec::new()
        }
        Kind::Circular => {
            let roots = analytic.roots.last().map(|root| (Fraction::var(root.var), root.parts));
            roots.into_iter().chain([(one.clone(), 4)]).listed()
        }
    };
    let value = |turn: &Rational| {
        let value = &angle.shift + &turn.checked_div(&angle.rate)?;
        if angle.turns {
            return Some((Fraction::constant(value.clone()), value.to_string()));
        }
        let text = multiple_of_pi(&value);
        let itself = if value.is_zero() {
            Fraction::zero()
        } else {
            &Fraction::var(analytic.pi?) * &Fraction::constant(value)
        };
        Some((itself, text))
    };
    for (first, n) in circular {
        let mut tangent = first.clone();
        for j in 1..(n + 1) / 2 {
            let turn = Rational::new(j, n);
            for (x, turn) in [(tangent.clone(), turn.clone()), (-&tangent, -turn)] {
                if let Some((itself, text)) = value(&turn) {
                    all.push((x, itself, text));
                }
            }
            // tan(a + b) = (tan a + tan b)/(1 − tan a·tan b).
            let sum = (&tangent + &first).checked_div(&(&one - &(&tangent * &first)));
            let Some(sum) = sum else { break };
            tangent = analytic.reduced(sum);
        }
    }
    let zero = if angle.kind == Kind::Circular {
        value(&Rational::ZERO)
    } else {
        Some((Fraction::constant(angle.shift.clone()), angle.shift.to_string()))
    };
    all.extend(zero.map(|(itself, text)| (Fraction::zero(), itself, text)));
    Some(all)
}
