//! The shape values that a claim names: those of the next segment, and exceptions.

use basis_prover::collections::list::Mapped;
use proc_macro2::Span;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::claim::Joint;
use crate::model::expand::bindings::{Giver, bound_names, has_one_value, is_determined};
use crate::model::expand::fixed::assumed_away;
use crate::model::formula::print::Printer;
use crate::model::scope::{Inside, Scope};
use crate::model::{Family, Parameter};
use crate::syntax::Binding;

/// What to write for `except a = b`.
const EXCEPTIONS: &str = "exceptions are points; that functions are dependent along a line is claimed of a family in which the one parameter is given by the other, `let a = b;`";

/// A name that gets a value, as text.
pub(super) fn bound_text(printer: &Printer<'_>, binding: &Binding) -> String {
    let indices = binding.indices.mapped(|i| printer.print(i)).join(",");
    let name = &binding.name.text;
    if indices.is_empty() { name.clone() } else { format!("{name}[{indices}]") }
}

/// The shape values of the next segment: those that are given, and free ones.
pub(super) fn neighbour(
    scope: &mut Scope<'_>,
    family: &Family,
    next: &[Binding],
    order: u32,
    span: Span,
) -> Option<Joint> {
    if !family.constraints.is_empty() {
        let error = scope.error(span, "a neighbour with other shape values violates what is assumed");
        scope.report(error.help("state the joint in a `theorem`, or for equal shape values"));
        return None;
    }
    let mut given: Vec<(Var, Fraction)> = Vec::new();
    let mut all: Vec<(&Binding, String)> = Vec::new();
    for binding in next {
        let names = bound_names(scope, binding)?;
        if !has_one_value(scope, binding, Giver::With) {
            return None;
        }
        all.extend(names.into_iter().map(|name| (binding, name)));
    }
    for (binding, name) in all {
        if is_determined(scope, &name, binding, Giver::With)? {
            return None;
        }
        let Some(shape) = family.shapes.iter().find(|s| s.name == name) else {
            let known: Vec<String> = family.shapes.mapped(|s| s.name.clone());
            let error = scope.error(binding.name.span, format!("`{name}` is not a shape parameter"));
            scope.report(error.help(if known.is_empty() {
                String::from("the family has no shape parameters: leave `with` out")
            } else {
                format!("the next segment has {}", crate::plural::list(&known))
            }));
            return None;
        };
        if given.iter().any(|(v, _)| *v == shape.var) {
            let error = scope.error(binding.name.span, format!("`{name}` is given twice"));
            scope.report(error.help("on the left stands each shape parameter of the next segment once"));
            return None;
        }
        let value = scope.scalar(&binding.value)?;
        if let Some(var) = scope.domain.iter().find(|v| value.depends_on(**v)) {
            let message = format!("the value contains the domain variable `{}`", scope.names[var.0]);
            let error = scope.error(binding.value.span, message);
            scope.report(error.help("shape values of the next segment are made of those of this one"));
            return None;
        }
        let inside = Inside {
            value: value.clone(),
            name,
            range: shape.range.clone(),
            family: None,
            assumable: false,
            written: None,
        };
        let place = scope.place(binding.value.span);
        match value.as_constant() {
            Some(c) if !shape.range.contains(&c) => {
                scope.report(inside.outside(&c, place));
                return None;
            }
            Some(_) => {}
            None => scope.must_stay_inside(inside, place),
        }
        given.push((shape.var, value));
    }
    let mut joint = Joint { order, next: Vec::new(), free: Vec::new() };
    for shape in &family.shapes {
        let own = given.iter().find(|(v, _)| *v == shape.var).map(|(_, value)| value.clone());
        joint.next.push(own.unwrap_or_else(|| {
            let var = Var(family.names.len() + joint.free.len());
            joint.free.push(Parameter { name: format!("{}'", shape.name), var, ..shape.clone() });
            Fraction::var(var)
        }));
    }
    Some(joint)
}

/// Exceptional shape values as text.
pub(super) fn describe_values(values: &[(Var, Rational)], family: &Family) -> String {
    let parts: Vec<String> = values.mapped(|(v, x)| family.shape_value(*v, x));
    if parts.len() == 1 { parts.concat() } else { format!("({})", parts.join(", ")) }
}

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
            let names = bound_names(scope, binding)?;
            if !has_one_value(scope, binding, Giver::Except) {
                return None;
            }
            for name in &names {
                let value = exceptional(scope, family, binding, name, &values)?;
                values.push(value);
            }
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

/// The value of one shape parameter at an exception, beside those that are known.
fn exceptional(
    scope: &mut Scope<'_>,
    family: &Family,
    binding: &Binding,
    name: &str,
    known: &[(Var, Rational)],
) -> Option<(Var, Rational)> {
    let named = |s: &&Parameter| scope.names[scope.itself(s.var).0] == name;
    let found = family.shapes.iter().find(named);
    let angle = found.and_then(|s| family.analytic.angle(s.var)).cloned();
    if is_determined(scope, name, binding, Giver::Except)? {
        return None;
    }
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
        None => scope.number_or(&binding.value, "an exceptional value", EXCEPTIONS)?,
    };
    let Some(shape) = found else {
        if scope.is_mistaken(name) {
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
                None => format!("{} = {value} is outside of the declared range `{range}`", shape.name),
            },
        );
        scope.report(error.help("only values inside the range can be exceptions"));
        return None;
    }
    if known.iter().any(|(v, _)| *v == shape.var) {
        scope.report(scope.error(binding.name.span, format!("`{}` is given twice", shape.name)));
        return None;
    }
    Some((shape.var, value))
}
