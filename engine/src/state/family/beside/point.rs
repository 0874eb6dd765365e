//! Angles in counterexamples as one writes them.

use basis_prover::collections::list::Listed;
use basis_prover::{Coordinate, Counterexample};

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::angle::{Angle, multiple_of_pi};

/// Puts angles in place of what stands for them in the values of all parameters.
pub(in crate::state::family) fn name_angles(
    family: &Family,
    found: &Counterexample,
    fixed: &[(Var, Fraction)],
    all: &mut [(String, Coordinate)],
) {
    let parameters = family.shapes.iter().chain(&family.domain);
    // The parameters at the ends of the domain, of which the box may have others.
    let known = parameters.clone().zip(&*all).map(|(p, (_, value))| (p.var, value.clone())).listed();
    for (entry, parameter) in all.iter_mut().zip(parameters) {
        if let Some(angle) = family.analytic.angle(parameter.var) {
            let itself = fixed.iter().find(|(v, _)| *v == angle.itself).and_then(|(_, f)| f.as_constant());
            if let Coordinate::Algebraic(_) = &entry.1 {
                let y = fixed.iter().find(|(v, _)| *v == angle.var);
                let x = y.and_then(|(_, y)| angle.tangent().substitute(angle.var, y));
                let x = x.and_then(|x| value_at(family, found, &x));
                let itself = itself.map(|value| (angle.name.clone(), Coordinate::Rational(value)));
                if let Some(known) = itself.or_else(|| Some((angle.tangent_name(), x?))) {
                    *entry = known;
                }
                continue;
            }
            *entry = named_angle(family, angle, (&parameter.name, &entry.1), &known);
        }
    }
}

/// The places of angles as one writes them instead of their tangents: the ends of a domain, t = π/2 and t = α for
/// tan(t/2) = 1 and tan(t/2) = tan(α/2), its middle, and what `at` fixes at a value that is no number or has no short tangent.
pub(in crate::state::family) fn places(
    family: &Family,
    fixed: &[(Var, Fraction)],
    at: &[(String, Coordinate)],
    image: &[(Var, Coordinate)],
) -> Vec<(String, String)> {
    const SHORT: u64 = 40;
    let mut all = Vec::new();
    for (parameter, (name, value)) in family.shapes.iter().chain(&family.domain).zip(at) {
        let Some(angle) = family.analytic.angle(parameter.var) else { continue };
        let long = match value {
            Coordinate::Rational(x) => x.bits() > SHORT,
            Coordinate::Algebraic(_) => true,
        };
        let given = fixed.iter().find(|(var, _)| *var == angle.itself).map(|(_, f)| written(f, family));
        let is_scaled = *name == parameter.name && *name != angle.name && *name != angle.tangent_name();
        let is_shifted = !angle.shift.is_zero() && !angle.turns && *name == angle.tangent_name();
        let range = family.region().range(parameter.var);
        let shown = image.iter().find(|(var, _)| *var == angle.var).and_then(|(_, y)| match y {
            Coordinate::Rational(y) => Some(y),
            Coordinate::Algebraic(_) => None,
        });
        let is_named = is_scaled || *name == angle.tangent_name() && *name != angle.name;
        let here = |end: &usize| {
            let y = [&range.low, &range.high][*end].value();
            is_named && !angle.ends[*end].is_empty() && y.is_some() && y == shown
        };
        let end = (0..2).find(here).map(|end| angle.ends[end].clone());
        let zero = matches!(value, Coordinate::Rational(x) if x.is_zero());
        let middle = (is_shifted && zero).then(|| multiple_of_pi(&angle.shift));
        if let Some(text) = given.filter(|_| long || is_scaled).or(end).or(middle) {
            all.push((name.clone(), format!("{} = {text}", angle.name)));
        }
    }
    all
}

/// A value with whole numbers above a common denominator, `pi/6`.
fn written(f: &Fraction, family: &Family) -> String {
    let denominator = f.numer().numeric_content().denom();
    if denominator.is_one() || !f.denom().is_one() {
        return f.display(&family.names);
    }
    let above = f.numer().scale(&denominator);
    let text = above.display(&family.names).to_string();
    if above.len() > 1 { format!("({text})/{denominator}") } else { format!("{text}/{denominator}") }
}

/// What takes the place of an angle as a reader wants it: the angle 0, else x.
fn named_angle(
    family: &Family,
    angle: &Angle,
    (name, y): (&str, &Coordinate),
    known: &[(Var, Coordinate)],
) -> (String, Coordinate) {
    let as_it_is = (String::from(name), y.clone());
    let Coordinate::Rational(value) = y else { return as_it_is };
    // The ends of the range as far as it is known where they are.
    let put = |f: &Fraction| {
        let shapes = family.shapes.iter().map(|s| s.var);
        let known = shapes.filter(|v| f.depends_on(*v)).try_fold(f.clone(), |f, v| {
            let (_, c) = known.iter().find(|(w, _)| *w == v)?;
            let Coordinate::Rational(x) = c else { return None };
            f.substitute(v, &Fraction::constant(x.clone()))
        })?;
        known.as_constant()
    };
    let zero = value.is_zero() && angle.low.is_zero();
    if zero && angle.shift.is_zero() {
        return (angle.name.clone(), Coordinate::Rational(Rational::ZERO));
    }
    // At an end that is a number the angle has it.
    for (end, limit) in angle.limits.iter().enumerate().filter(|(end, _)| !angle.ends[*end].is_empty()) {
        let here = family.region().range(angle.var);
        let here = [here.low, here.high][end].value() == Some(value);
        if let Some(limit) = limit.as_constant().filter(|_| here) {
            return (angle.name.clone(), Coordinate::Rational(limit));
        }
    }
    let (Some(low), Some(width)) = (put(&angle.low), put(&angle.width)) else { return as_it_is };
    (angle.tangent_name(), Coordinate::Rational(&low + &(&width * value)))
}

/// A value at a counterexample; where numbers tan(π/n) stand in it, with these in place of what is near them.
pub(in crate::state::family) fn value_at(
    family: &Family,
    found: &Counterexample,
    f: &Fraction,
) -> Option<Coordinate> {
    let f = family.analytic.reduced(f.clone());
    let Some(root) = family.analytic.roots.iter().find(|root| f.depends_on(root.var)) else {
        return found.evaluate(&f.quotient());
    };
    found.with(root.var, Coordinate::Algebraic(root.number.clone()))?.evaluate(&f.quotient())
}
