//! What `at`, `except` and `with` give values to: one parameter, or all of a list.

use basis_prover::collections::list::{Listed, Mapped};

use super::names::bound_name;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::model::formula::print::Printer;
use crate::model::label;
use crate::model::scope::Scope;
use crate::syntax::{Binding, Expr, ExprKind};

/// What gives values to names.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Giver {
    /// A block of equations that hold at these values.
    At,
    /// The values at which functions are not independent.
    Except,
    /// The shape values of the next segment.
    With,
}

impl Giver {
    /// Its word with values, as it is written.
    fn with(self, values: &[String]) -> String {
        let all = values.join(", ");
        match self {
            Self::At => format!("at {all}"),
            Self::Except if values.len() > 1 => format!("except ({all})"),
            Self::Except => format!("except {all}"),
            Self::With => format!("with {all}"),
        }
    }
}

/// The names that get the value of a binding: a name without an index stands for all parameters of its list, but not for
/// those that what is assumed determines.
pub(super) fn bound_names(scope: &mut Scope<'_>, binding: &Binding) -> Option<Vec<String>> {
    let name = bound_name(scope, binding)?;
    let is_list = binding.indices.is_empty()
        && scope.variable(&name).is_none()
        && scope.determined.iter().all(|(known, _)| *known != name)
        && scope.is_list_of_shapes(&name);
    if !is_list {
        return Some(vec![name]);
    }
    let own = scope.shapes_of(&name).into_iter().filter(|(_, value)| value.as_var().is_some());
    Some(own.map(|(index, _)| label(&name, &index)).listed())
}

/// Whether a name is given one value and not a list of them; a list is reported.
pub(super) fn has_one_value(scope: &Scope<'_>, binding: &Binding, giver: Giver) -> bool {
    let ExprKind::List(values) = &binding.value.kind else { return true };
    let name = &binding.name.text;
    let found = crate::plural::count(values.len(), "value");
    let error =
        scope.error(binding.value.span, format!("expected one value of `{name}`, found a list of {found}"));
    let printer = Printer { constants: &scope.constants, component: None };
    let given = |(name, value): (&String, &Expr)| format!("{name} = {}", printer.print(value));
    let all = scope.shapes_of(name).mapped(|(index, _)| label(name, index));
    let is_list = binding.indices.is_empty() && scope.variable(name).is_none() && !all.is_empty();
    let help = if let [only] = values.as_slice() {
        format!("write `{}`: square brackets make a list", giver.with(&[given((name, only))]))
    } else if is_list && all.len() == values.len() {
        let values = all.iter().zip(values).map(given).listed();
        format!("write `{}`: each parameter gets its value by itself", giver.with(&values))
    } else if is_list {
        format!("each parameter gets its value by itself: `{name}` has {}", crate::plural::list(&all))
    } else if giver == Giver::At {
        String::from("write a block for each value")
    } else {
        let values = values.mapped(|value| given((name, value)));
        match giver {
            Giver::Except if !values.is_empty() => format!("write `except {}`", values.join(", ")),
            _ => String::from("write one of them"),
        }
    };
    scope.report(error.help(help));
    false
}

/// Reports a value for a parameter that what is assumed determines; whether it does.
pub(super) fn is_determined(
    scope: &mut Scope<'_>,
    name: &str,
    binding: &Binding,
    giver: Giver,
) -> Option<bool> {
    let Some((_, own)) = scope.determined.iter().find(|(known, _)| known == name) else { return Some(false) };
    let own = own.clone();
    let value = scope.scalar(&binding.value)?;
    let difference = scope.fits(scope.budget.sub(&own, &value), binding.value.span)?;
    let shown = own.display(&scope.names);
    let message = format!("`{name}` follows from the other shape parameters: it is {shown}");
    let error = scope.error(binding.name.span, message);
    let others = (0..scope.names.len()).map(Var).filter(|var| own.depends_on(*var)).listed();
    let solved = match &others[..] {
        [only] if giver != Giver::With => zero(&difference, *only).map(|value| (*only, value)),
        _ => None,
    };
    scope.report(error.help(match solved {
        Some((var, value)) => {
            let value = format!("{} = {}", scope.names[var.0], value.display(&scope.names));
            format!("write `{}`", giver.with(&[value]))
        }
        None if others.is_empty() => String::from("leave it out: it has no other value"),
        None => {
            let names = others.mapped(|var| scope.names[var.0].clone());
            format!("leave it out, and give values to {} instead", crate::plural::list(&names))
        }
    }));
    Some(true)
}

/// Where a function that is linear in a variable, with a number as its slope, is zero.
pub(super) fn zero(f: &Fraction, var: Var) -> Option<Fraction> {
    let p = f.as_poly().filter(|p| p.degree(var) == 1)?;
    let [rest, slope] = &p.coefficients_in(var)[..] else { return None };
    let scale = -slope.as_constant()?.recip()?;
    Some(Fraction::from(rest.scale(&scale)))
}
