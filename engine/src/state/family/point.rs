//! Counterexamples as points of the names of a family.

use basis_kernel::Quotient;
use basis_prover::collections::list::Listed;
use basis_prover::{Coordinate, Counterexample, typical};

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::angle::{Angle, multiple_of_pi};
use crate::model::chart::Piece;

/// The names of the domain variables.
pub(super) fn domain_names(family: &Family) -> Vec<String> {
    let angles = family.domain.iter().filter_map(|p| family.analytic.angle(p.var));
    let other = angles.flat_map(|a| [a.name.clone(), a.tangent_name()]);
    family.domain_variables().map(|p| p.name.clone()).chain(other).listed()
}

/// A counterexample as a point of the names, complete with what `at` fixes and with values for what plays no part.
pub(super) fn named_point(
    family: &Family,
    found: &Counterexample,
    fixed: &[(Var, Fraction)],
    piece: &Piece,
) -> Vec<(String, Coordinate)> {
    // What plays no part in the image of a box has a value, too.
    let absent = |var: &Var| found.point.iter().all(|(v, _)| v != var);
    let idle = piece.ranges.iter().filter(|(var, _)| absent(var)).map(|(var, r)| (*var, typical(r))).listed();
    let image = |value: &Fraction| {
        let put = |p: Poly| idle.iter().fold(p, |p, (var, x)| p.at(*var, x));
        let quotient = piece.pull_back_fraction(value)?;
        found.evaluate(&Quotient {
            numerator: put(quotient.numerator),
            denominator: put(quotient.denominator),
        })
    };
    // On each simplex no more than what is left, and its last coordinate.
    let one = || (Rational::ONE, Fraction::constant(Rational::ONE));
    let mut rest: Vec<(Rational, Fraction)> = family.simplices.iter().map(|_| one()).listed();
    let mut all: Vec<(String, Coordinate)> = Vec::new();
    for (k, parameter) in family.shapes.iter().chain(&family.domain).enumerate() {
        let var = parameter.var;
        let place = k.checked_sub(family.shapes.len());
        let simplex = family.simplices.iter().position(|s| place.is_some_and(|k| s.places.contains(&k)));
        let mut on_simplex = simplex.and_then(|number| rest.get_mut(number));
        let given = found.point.iter().find(|(v, _)| *v == var).map(|(_, c)| c.clone());
        let fixed_value = fixed.iter().find(|(v, _)| *v == var).map(|(_, f)| f);
        if let Some((_, last)) = &mut on_simplex {
            *last = &*last - &fixed_value.cloned().unwrap_or_else(|| Fraction::var(var));
        }
        let known = if piece.steps.is_empty() {
            // Where all variables have values there are coordinates for those that are fixed, too.
            fixed_value.and_then(|f| value_at(family, found, f)).or(given)
        } else {
            image(fixed_value.unwrap_or(&Fraction::var(var)))
        };
        let value = known.unwrap_or_else(|| {
            let simple = typical(&parameter.range);
            let Some((left, last)) = &mut on_simplex else { return Coordinate::Rational(simple) };
            let simple = simple.min(left.clone());
            *last = last.substitute(var, &Fraction::constant(simple.clone())).unwrap_or_else(Fraction::zero);
            Coordinate::Rational(simple)
        });
        if let (Some((left, _)), Coordinate::Rational(x)) = (on_simplex, &value) {
            *left -= x;
        }
        all.push((parameter.name.clone(), value));
    }
    let parameters = family.shapes.iter().chain(&family.domain);
    // The parameters at the ends of the domain, of which the box may have others.
    let known = parameters.clone().zip(&all).map(|(p, (_, value))| (p.var, value.clone())).listed();
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
    // In the order of the spec, each last coordinate after the others of its simplex.
    for (simplex, (_, last)) in family.simplices.iter().zip(rest).rev() {
        let at = family.shapes.len() + simplex.places.end;
        let value = found.evaluate(&last.quotient());
        if let Some(value) = value {
            all.insert(at.min(all.len()), (simplex.last.name.clone(), value));
        }
    }
    all
}

/// The places of angles as one writes them instead of their tangents: the ends of a domain, t = π/2 and t = α for
/// tan(t/2) = 1 and tan(t/2) = tan(α/2), its middle, and what `at` fixes at a value that is no number or has no short tangent.
pub(super) fn places(
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

/// A value at a counterexample; where numbers tan(π/n) stand in it, with these in place of what is near them.
fn value_at(family: &Family, found: &Counterexample, f: &Fraction) -> Option<Coordinate> {
    let f = family.analytic.reduced(f.clone());
    let Some(root) = family.analytic.roots.iter().find(|root| f.depends_on(root.var)) else {
        return found.evaluate(&f.quotient());
    };
    found.with(root.var, Coordinate::Algebraic(root.number.clone()))?.evaluate(&f.quotient())
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
