//! The values that `at` blocks fix of angles.
//!
//! A family with angles is expanded in tangents of parts of them, which may be irrational where the angle itself has a simple
//! value: with tan(α/4), at α = π/2. What is claimed there is about the family with π/2 in place of α, expanded anew.

use super::super::angles::{are_ordered, is_alone};
use super::super::names;
use super::super::shapes::without_indices;
use crate::algebra::fraction::Fraction;
use crate::algebra::rational::Rational;
use crate::model::angle::enclosure::pi_bounds;
use crate::model::angle::{Angle, Given, Kind};
use crate::model::formula::phase::Linear;
use crate::model::formula::print::Printer;
use crate::model::scope::{Fixed, Inside, Scope};
use crate::model::{Family, Library};
use crate::syntax::{self, Binding, StatementKind};

/// The angles among the shape parameters that a block fixes to values inside of their ranges at which their tangents are
/// irrational; the family has to be expanded with these values.
pub(in crate::model::expand) fn without_tangents<'a>(
    library: &'a Library<'a>,
    unit: usize,
    written: &'a syntax::Family,
    family: &Family,
    bindings: &'a [Binding],
) -> Given {
    let angles = || {
        let circular = family.analytic.angles.iter().filter(|angle| angle.kind == Kind::Circular);
        circular.filter(|angle| family.shapes.iter().any(|p| p.var == angle.var))
    };
    // Of `α[1]` the name is α.
    let base = |angle: &Angle| angle.name.split('[').next().unwrap_or_default().to_string();
    let perhaps = |binding: &&Binding| angles().any(|angle| base(angle) == binding.name.text);
    let mut bindings = bindings.iter().filter(perhaps).peekable();
    if bindings.peek().is_none() {
        return Given::new();
    }
    let mut scope = Scope::of_family(library, unit, family);
    names::plan(&mut scope, written);
    let mut given = Given::new();
    for binding in bindings {
        let name = names::attempt(&mut scope, &mut |scope| names::bound_name(scope, binding));
        let value = names::attempt(&mut scope, &mut |scope| scope.scalar(&binding.value));
        let Some(value) = value else { continue };
        let Some(turns) = multiple_of_pi(&value, &scope) else { continue };
        // A name without an index stands for all of its parameters.
        let is_meant =
            |angle: &&Angle| name.as_ref().is_some_and(|name| *name == angle.name || *name == base(angle));
        for angle in angles().filter(is_meant) {
            let is_rational = match scope.angle_at(angle, &value, binding.value.span) {
                Ok(y) => y.is_some_and(|y| family.analytic.roots.iter().all(|root| !y.depends_on(root.var))),
                Err(_) => false,
            };
            if !is_rational && lies_inside(&turns, written, angle, &mut scope) {
                given.push((angle.name.clone(), turns.clone()));
            }
        }
    }
    given
}

/// How many times π a number is.
fn multiple_of_pi(value: &Fraction, scope: &Scope<'_>) -> Option<Rational> {
    let linear = Linear::of(value, scope.analytic.pi)?;
    (linear.parts.is_empty() && linear.number.is_zero()).then_some(linear.pi)
}

/// Whether a multiple of π lies in the range of a shape parameter that has a range of its own.
fn lies_inside(turns: &Rational, written: &syntax::Family, angle: &Angle, scope: &mut Scope<'_>) -> bool {
    let declared = written.statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::Shape(decls) => decls.iter().find_map(|decl| {
            let single = without_indices(scope, decl)?;
            single.into_iter().find(|decl| is_alone(decl, &angle.name))
        }),
        _ => None,
    });
    let Some(decl) = declared else { return false };
    let limits = angle.limits.iter().zip(&angle.ends).zip([1, -1]);
    // The first part is the lower end, if there is one, and the last part the upper one.
    let included = [decl.included.first(), decl.included.last()];
    limits.zip(included).all(|(((limit, text), side), included)| {
        if text.is_empty() {
            return true;
        }
        let Some(limit) = Linear::of(limit, scope.analytic.pi).filter(|limit| limit.parts.is_empty()) else {
            return false;
        };
        let side = Rational::from(side);
        let (rise, beyond) = (&(turns - &limit.pi) * &side, &limit.number * &side);
        let (low, high) = pi_bounds();
        let distances = [&(&rise * low) - &beyond, &(&rise * high) - &beyond];
        let inside = |d: &Rational| d.is_positive() || d.is_zero() && included == Some(&true);
        distances.iter().all(inside)
    })
}

/// Fixes an angle: what takes its place, and the variable itself.
pub(super) fn fixed_angle(
    scope: &mut Scope<'_>,
    family: &Family,
    angle: &Angle,
    (value, binding): (Fraction, &Binding),
    fixed: &mut Fixed,
) -> Option<()> {
    let span = binding.value.span;
    let mut y = match scope.angle_at(angle, &value, span) {
        Ok(y) => y?,
        // Half a turn from the middle of one span lies in another, or in none, which is said where all are known.
        Err(_) if scope.span.is_some() && Linear::of(&value, scope.analytic.pi).is_some() => return None,
        Err((message, help)) => {
            scope.report(scope.error(span, message).help(help));
            return None;
        }
    };
    let parameter = family.shapes.iter().chain(family.domain_variables()).find(|p| p.var == angle.var)?;
    let declared = family.declared(parameter);
    if scope.is_domain_variable(angle.var) {
        y = scope.put_all(y, fixed, span)?;
        if scope.lies_elsewhere(&y, &parameter.range, family) {
            return None;
        }
    }
    let outside = match scope.analytic.number(&y) {
        Some(c) => !parameter.range.contains(&c),
        None => is_beyond(&value, angle),
    };
    let shown = Printer { constants: &scope.constants, component: None }.print(&binding.value);
    let written = format!("{} = {shown}", angle.name);
    if outside {
        let message = format!("{written} is outside of the declared range `{declared}`");
        let help = "claims are about the declared ranges; widen the range, or choose a value inside";
        scope.report(scope.error(span, message).help(help));
        return None;
    }
    let is_number = scope.analytic.number(&y).is_some();
    if y.as_constant().is_none() && !is_between_ends(scope, family, angle, &value) {
        let inside = Inside {
            value: y.clone(),
            name: parameter.name.clone(),
            range: scope.between_knots(&parameter.range, !scope.is_domain_variable(angle.var) || is_number),
            family: None,
            assumable: false,
            written: Some((written, declared)),
        };
        let place = scope.place(span);
        scope.must_stay_inside(inside, place);
    }
    fixed.push((angle.var, y));
    fixed.push((angle.itself, value));
    Some(())
}

/// Whether a value, a sum of multiples of parameters, is seen to lie between the ends of an angle, and at neither.
fn is_between_ends(scope: &Scope<'_>, family: &Family, angle: &Angle, value: &Fraction) -> bool {
    let linear = |f: &Fraction| Linear::of(f, scope.analytic.pi);
    let [Some(low), Some(high), Some(value)] = [&angle.limits[0], &angle.limits[1], value].map(linear) else {
        return false;
    };
    angle.ends.iter().all(|end| !end.is_empty())
        && are_ordered(scope, &low, &value, &family.shapes)
        && are_ordered(scope, &value, &high, &family.shapes)
}

/// Whether a number lies beyond the ends of a range that are numbers.
fn is_beyond(value: &Fraction, angle: &Angle) -> bool {
    let Some(value) = value.as_constant() else { return false };
    let end = |side: usize| angle.limits[side].as_constant().filter(|_| !angle.ends[side].is_empty());
    end(0).is_some_and(|low| value < low) || end(1).is_some_and(|high| value > high)
}
