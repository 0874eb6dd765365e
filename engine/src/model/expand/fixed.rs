//! Values that claims fix in an `at` block or except, of shape parameters and of domain variables.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::model::angle::Angle;
use crate::model::formula::phase::Linear;
use crate::model::formula::print::Printer;
use crate::model::scope::{Inside, Scope};
use crate::model::{Barycentric, Family, Parameter, chart, label};
use crate::syntax::Binding;
use basis_prover::collections::list::{Listed, Mapped};
use proc_macro2::Span;

/// The shape values that an `except` lists.
pub(super) fn exceptions(
    scope: &mut Scope<'_>,
    family: &Family,
    written: &[Vec<Binding>],
) -> Option<Vec<Vec<(Var, Rational)>>> {
    let mut all = Vec::new();
    for exception in written {
        let mut values: Vec<(Var, Rational)> = Vec::new();
        for binding in exception {
            let name = bound_name(scope, binding)?;
            let named = |s: &&Parameter| scope.names[scope.itself(s.var).0] == name;
            let found = family.shapes.iter().find(named);
            let angle = found.and_then(|s| family.analytic.angle(s.var)).cloned();
            let value = match &angle {
                Some(angle) => {
                    let value = scope.scalar(&binding.value)?;
                    let tangent = scope.angle_at(angle, &value, binding.value.span);
                    match tangent.map(|x| x.map(|x| x.as_constant())) {
                        Ok(x) => x??,
                        Err((message, help)) => {
                            scope.report(scope.error(binding.value.span, message).help(help));
                            return None;
                        }
                    }
                }
                None => scope.number(&binding.value, "an exceptional value")?,
            };
            let Some(shape) = found else {
                if scope.is_mistaken(&name) {
                    return None;
                }
                let known: Vec<String> = family.shapes.mapped(|s| scope.names[scope.itself(s.var).0].clone());
                let error = scope.error(binding.name.span, format!("`{name}` is not a shape parameter"));
                scope.report(if known.is_empty() {
                    error.help("the family has no shape parameters")
                } else {
                    error.help(format!("shape parameters are {}", crate::plural::list(&known)))
                });
                return None;
            };
            if !shape.range.contains(&value) {
                let range = family.declared(shape);
                let error = scope.error(
                    binding.value.span,
                    match &angle {
                        Some(angle) => {
                            format!("the value of {} is outside of the declared range `{range}`", angle.name)
                        }
                        None => {
                            format!("{} = {value} is outside of the declared range `{range}`", shape.name)
                        }
                    },
                );
                scope.report(error.help("only values inside the range can be exceptions"));
                return None;
            }
            if values.iter().any(|(v, _)| *v == shape.var) {
                scope.report(scope.error(binding.name.span, format!("`{}` is given twice", shape.name)));
                return None;
            }
            values.push((shape.var, value));
        }
        let fixed = values.mapped(|(v, x)| (*v, Fraction::constant(x.clone())));
        if let (Some(first), true) = (exception.first(), family.pieces(&fixed, &[], true).is_empty()) {
            assumed_away(scope, family, first.name.span, "an exception violates what is assumed");
            return None;
        }
        all.push(values);
    }
    Some(all)
}

/// The name that gets a value, indices as numbers.
pub(super) fn bound_name(scope: &mut Scope<'_>, binding: &Binding) -> Option<String> {
    if binding.indices.is_empty() {
        return Some(binding.name.text.clone());
    }
    let mut index = Vec::new();
    for i in &binding.indices {
        index.push(scope.whole(i, "the index of a shape parameter")?);
    }
    Some(label(&binding.name.text, &index))
}

/// Reports values that what is assumed rules out.
fn assumed_away(scope: &Scope<'_>, family: &Family, span: Span, message: &str) {
    let texts = chart::texts(&family.constraints);
    let error = scope.error(span, message).note(format!("assumed is {}", texts.join(", ")));
    scope
        .report(error.help("claims are about the shape values that are declared and assumed; choose others"));
}

/// The values that an `at` block fixes.
pub(super) fn fixed(
    scope: &mut Scope<'_>,
    family: &Family,
    bindings: &[Binding],
) -> Option<Vec<(Var, Fraction)>> {
    let mut fixed: Vec<(Var, Fraction)> = Vec::new();
    let pending = scope.pending.len();
    let mut all: Vec<(&Binding, String)> = Vec::new();
    for binding in bindings {
        let name = bound_name(scope, binding)?;
        if binding.indices.is_empty() && scope.variable(&name).is_none() && scope.is_list_of_shapes(&name) {
            // A name without an index stands for all of its parameters.
            let own = scope.shapes_of(&name).into_iter().filter(|(_, value)| value.as_var().is_some());
            all.extend(own.map(|(index, _)| (binding, label(&name, &index))));
        } else {
            all.push((binding, name));
        }
    }
    for (binding, name) in &all {
        let Some(var) = scope.variable(name) else {
            let determined = scope.determined.iter().any(|(n, _)| n == name);
            if determined {
                let error =
                    scope.error(binding.name.span, format!("`{name}` is determined by an assumption"));
                scope.report(error.help("fix the parameters on which it depends"));
            } else if scope.taken(name).is_some() {
                let error = scope.error(binding.name.span, format!("`{name}` is not a variable"));
                scope.report(
                    error.help(format!("an `at` block fixes one of {}", crate::plural::list(&scope.names))),
                );
            } else {
                scope.unknown(name, binding.name.span);
            }
            return None;
        };
        if fixed.iter().any(|(v, _)| *v == var) {
            scope.report(scope.error(binding.name.span, format!("`{name}` is given twice")));
            return None;
        }
        let value = scope.scalar(&binding.value)?;
        if let Some(angle) = family.analytic.angle(var).cloned() {
            fixed_angle(scope, family, &angle, (value, binding), &mut fixed)?;
            continue;
        }
        let Some(parameter) = family.shapes.iter().chain(family.domain_variables()).find(|p| p.var == var)
        else {
            scope.report(scope.error(binding.name.span, format!("`{name}` is a number")));
            return None;
        };
        let inside = Inside {
            value: value.clone(),
            name: name.clone(),
            range: parameter.range.clone(),
            family: None,
            assumable: false,
        };
        let place = scope.place(binding.value.span);
        if scope.is_domain_variable(var) && scope.lies_elsewhere(&value, &parameter.range) {
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
    }
    let span = bindings.first().map_or_else(Span::call_site, |b| b.value.span);
    let simplices = scope.simplices.clone();
    let fixed = simplices.iter().try_fold(fixed, |fixed, own| independent(scope, own, fixed, span))?;
    for (k, (var, value)) in fixed.iter().enumerate() {
        if let Some((user, _)) = fixed.iter().find(|(_, value)| value.depends_on(*var)) {
            let name = scope.names[var.0].clone();
            let span = all.get(k).map_or(span, |(b, _)| b.name.span);
            let error = scope.error(span, format!("`{name}` is fixed and used as a value at the same time"));
            // at α = β, β = γ: the value of β is known.
            let end = value.display(&scope.names);
            let (user, own) = (&scope.names[user.0], user == var);
            scope.report(error.help(if own {
                String::from("write a value in which it does not occur")
            } else {
                format!("write `{user} = …` with the value of `{name}`, which is {end}")
            }));
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

/// Fixes an angle: what takes its place, and the variable itself.
fn fixed_angle(
    scope: &mut Scope<'_>,
    family: &Family,
    angle: &Angle,
    (value, binding): (Fraction, &Binding),
    fixed: &mut Vec<(Var, Fraction)>,
) -> Option<()> {
    let span = binding.value.span;
    let y = match scope.angle_at(angle, &value, span) {
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
    if scope.is_domain_variable(angle.var) && scope.lies_elsewhere(&y, &parameter.range) {
        return None;
    }
    match y.as_constant() {
        Some(c) if !parameter.range.contains(&c) => {
            let shown = Printer { constants: &scope.constants, component: None }.print(&binding.value);
            let message = format!("{} = {shown} is outside of the declared range `{declared}`", angle.name);
            let help = "claims are about the declared ranges; widen the range, or choose a value inside";
            scope.report(scope.error(span, message).help(help));
            return None;
        }
        Some(_) => {}
        None => {
            let (name, range) = (parameter.name.clone(), parameter.range.clone());
            let inside = Inside { value: y.clone(), name, range, family: None, assumable: false };
            let place = scope.place(span);
            scope.must_stay_inside(inside, place);
        }
    }
    fixed.push((angle.var, y));
    fixed.push((angle.itself, value));
    Some(())
}

/// On a simplex: the last barycentric coordinate fixes another one, and all of them sum to 1.
fn independent(
    scope: &Scope<'_>,
    simplex: &Barycentric,
    mut fixed: Vec<(Var, Fraction)>,
    span: Span,
) -> Option<Vec<(Var, Fraction)>> {
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
