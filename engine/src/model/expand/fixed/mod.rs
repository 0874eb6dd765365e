//! The values that `at` blocks fix: of variables, of barycentric coordinates, and by `angle` of angles.

#[cfg(feature = "angles")]
mod angle;
#[cfg(not(feature = "angles"))]
#[path = "no_angle.rs"]
mod angle;

use basis_prover::collections::sort::sort_by_key;
use proc_macro2::Span;

use self::angle::fixed_angle;
use super::bindings::{Giver, bound_names, has_one_value, zero};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::model::scope::{Fixed, Inside, Scope};
use crate::model::{Barycentric, Family, Parameter, chart};
use crate::syntax::Binding;
use basis_prover::collections::list::Listed;

pub(super) use self::angle::without_tangents;

/// Reports values that what is assumed rules out.
pub(super) fn assumed_away(scope: &Scope<'_>, family: &Family, span: Span, message: &str) {
    let texts = chart::texts(&family.constraints);
    let error = scope.error(span, message).note(format!("assumed is {}", texts.join(", ")));
    scope
        .report(error.help("claims are about the shape values that are declared and assumed; choose others"));
}

/// The values that an `at` block fixes.
pub(super) fn fixed(scope: &mut Scope<'_>, family: &Family, bindings: &[Binding]) -> Option<Fixed> {
    let mut fixed = Fixed::new();
    let pending = scope.pending.len();
    let mut all: Vec<(&Binding, String)> = Vec::new();
    for binding in bindings {
        let names = bound_names(scope, binding)?;
        if !has_one_value(scope, binding, Giver::At) {
            return None;
        }
        // With what is given the family is expanded.
        let is_given = |name: &String| scope.anew.given.iter().any(|(given, _)| given == name);
        all.extend(names.into_iter().filter(|name| !is_given(name)).map(|name| (binding, name)));
    }
    // At α = 1, t = α the point is where the shape value says.
    let is_point = |name: &str| scope.variable(name).is_some_and(|var| scope.is_domain_variable(var));
    let is_determined = |name: &str| scope.determined.iter().any(|(n, _)| n == name);
    sort_by_key(&mut all, |(_, name)| (is_point(name), is_determined(name)));
    for (binding, name) in &all {
        let by_assumption = scope.determined.iter().find(|(n, _)| n == name).map(|(_, value)| value.clone());
        if let Some(own) = by_assumption {
            let own = scope.put_all(own, &fixed, binding.value.span)?;
            let value = scope.scalar(&binding.value)?;
            let difference = scope.fits(scope.budget.sub(&own, &value), binding.value.span)?;
            if difference.is_zero() {
                continue;
            }
            let solved = family.shapes.iter().find_map(|p| Some((p, zero(&difference, p.var)?)));
            let Some((parameter, value)) = solved else {
                let message = format!("`{name}` is {} here, as assumed", own.display(&scope.names));
                let error = scope.error(binding.value.span, message);
                scope.report(
                    error.help("leave it out, or choose other values of the parameters on which it depends"),
                );
                return None;
            };
            fix(scope, (family, parameter), &parameter.name, (value, binding), &mut fixed)?;
            continue;
        }
        let Some(var) = scope.variable(name) else {
            if scope.taken(name).is_some() {
                let error = scope.error(binding.name.span, format!("`{name}` is not a variable"));
                scope.report(error.help(if scope.constant(name).is_some() {
                    format!("an index parameter is fixed behind the claim: `b[0] = 1 if {name} == 2`")
                } else {
                    format!("an `at` block fixes one of {}", crate::plural::list(&scope.names))
                }));
            } else if scope.is_list_of_shapes(&binding.name.text) {
                scope.no_such_shape(&binding.name.text, name, binding.name.span);
            } else {
                scope.unknown(name, binding.name.span);
            }
            return None;
        };
        if fixed.iter().any(|(v, _)| *v == var) {
            let error = scope.error(binding.name.span, format!("`{name}` is given twice"));
            scope.report(error.help("write one block for each value"));
            return None;
        }
        let mut value = scope.scalar(&binding.value)?;
        if scope.is_domain_variable(var) {
            value = scope.put_all(value, &fixed, binding.value.span)?;
        }
        if let Some(angle) = family.analytic.angle(var).cloned() {
            fixed_angle(scope, family, &angle, (value, binding), &mut fixed)?;
            continue;
        }
        let Some(parameter) = family.shapes.iter().chain(family.domain_variables()).find(|p| p.var == var)
        else {
            scope.report(scope.error(binding.name.span, format!("`{name}` is a number")));
            return None;
        };
        fix(scope, (family, parameter), name, (value, binding), &mut fixed)?;
    }
    let span = bindings.first().map_or_else(Span::call_site, |b| b.value.span);
    let simplices = scope.simplices.clone();
    let fixed = simplices.iter().try_fold(fixed, |fixed, own| independent(scope, own, fixed, span))?;
    for (k, (var, value)) in fixed.iter().enumerate() {
        if let Some((user, with)) = fixed.iter().find(|(_, value)| value.depends_on(*var)) {
            let name = scope.names[var.0].clone();
            let span = all.get(k).map_or(span, |(b, _)| b.name.span);
            let error = scope.error(span, format!("`{name}` is fixed and used as a value at the same time"));
            // at α = β, β = γ: the value of β is known.
            let end = value.display(&scope.names);
            let put = with.substitute(*var, value).map(|with| with.display(&scope.names));
            let is_circle = with.substitute(*var, value).is_none_or(|with| with.depends_on(*user));
            let (user, own) = (&scope.names[user.0], user == var);
            scope.report(error.help(if own {
                String::from("write a value in which it does not occur")
            } else if is_circle {
                format!("`{user}` and `{name}` are given by each other: leave one of them out")
            } else {
                let put = put.unwrap_or_else(|| String::from("…"));
                format!("put the value of `{name}` in its place: `{user} = {put}, {name} = {end}`")
            }));
            scope.pending.truncate(pending); // that the values stay in their ranges
            return None;
        }
    }
    if !family.constraints.is_empty() && family.pieces(&fixed, &[], true).is_empty() {
        scope.pending.truncate(pending);
        assumed_away(scope, family, span, "the block fixes values that violate what is assumed");
        return None;
    }
    Some(fixed)
}

/// Fixes a parameter that is no angle to a value in its range.
fn fix(
    scope: &mut Scope<'_>,
    (family, parameter): (&Family, &Parameter),
    name: &str,
    (value, binding): (Fraction, &Binding),
    fixed: &mut Fixed,
) -> Option<()> {
    let is_point = scope.is_domain_variable(parameter.var);
    let range = scope.between_knots(&parameter.range, !is_point || value.as_constant().is_some());
    let inside = Inside {
        value: value.clone(),
        name: name.to_owned(),
        range,
        family: None,
        assumable: false,
        written: None,
    };
    let (var, place) = (parameter.var, scope.place(binding.value.span));
    if scope.is_domain_variable(var) && scope.lies_elsewhere(&value, &parameter.range, family) {
        return None;
    }
    match value.as_constant() {
        Some(c) if !parameter.range.contains(&c) => {
            scope.report(inside.outside(&c, place));
            return None;
        }
        Some(_) => {}
        None if scope.simplex_of(var).is_some() => {
            let error =
                scope.error(binding.value.span, format!("`{name}` is fixed to something that varies"));
            scope.report(
                error.help("on a simplex an `at` block fixes coordinates to numbers, such as `w = 0`"),
            );
            return None;
        }
        None => scope.must_stay_inside(inside, place),
    }
    fixed.push((var, value));
    Some(())
}

/// On a simplex: the last barycentric coordinate fixes another one, and all of them sum to 1.
fn independent(scope: &Scope<'_>, simplex: &Barycentric, mut fixed: Fixed, span: Span) -> Option<Fixed> {
    let (own, dependent) = (&scope.domain[simplex.places.clone()], simplex.last.var);
    let given = fixed.iter().filter(|(v, _)| own.contains(v) || *v == dependent);
    // What the given coordinates leave for the others.
    let left = given.filter_map(|(_, f)| f.as_constant()).fold(Rational::ONE, |left, c| &left - &c);
    let last = fixed.iter().position(|(v, _)| *v == dependent).map(|k| fixed.remove(k).1);
    let coordinate = |fixed: &[(Var, Fraction)], var: Var| {
        fixed.iter().find(|(v, _)| *v == var).map_or_else(|| Fraction::var(var), |(_, f)| f.clone())
    };
    let one = Fraction::constant(Rational::ONE);
    if let Some(last) = last {
        match own.iter().rev().find(|v| fixed.iter().all(|(f, _)| f != *v)) {
            Some(free) => {
                let others = own.iter().filter(|v| *v != free);
                let value = others.fold(&one - &last, |rest, v| &rest - &coordinate(&fixed, *v));
                fixed.push((*free, value));
            }
            None => {
                let sum = own.iter().fold(last, |sum, v| &sum + &coordinate(&fixed, *v));
                if sum != one {
                    let error = scope.error(
                        span,
                        format!("the barycentric coordinates sum to {}, not to 1", sum.display(&scope.names)),
                    );
                    scope.report(error.help("choose coordinates that sum to 1"));
                    return None;
                }
            }
        }
    }
    if left.is_negative() {
        let error =
            scope.error(span, "the point lies outside of the simplex: its coordinates sum to more than 1");
        scope.report(error.help("claims are about the domain; choose a point inside"));
        return None;
    }
    // At a corner nothing is left for the other coordinates.
    if left.is_zero() {
        fixed.retain(|(var, f)| !own.contains(var) || own.iter().all(|v| !f.depends_on(*v)));
        let free: Vec<Var> = own.iter().copied().filter(|v| fixed.iter().all(|(f, _)| f != v)).listed();
        fixed.extend(free.into_iter().map(|v| (v, Fraction::zero())));
    }
    Some(fixed)
}
