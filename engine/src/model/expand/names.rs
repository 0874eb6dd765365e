//! Names and functions in any order: what a formula needs is evaluated before it, wherever it stands in the family.
//!
//! A formula that meets something without a value yet gives up and says what it waits for; that is evaluated first, and
//! then the formula again. So the stack stays flat, however long a chain of definitions is.

use proc_macro2::Span;

use super::functions::single;
use crate::model::label;
use crate::model::scope::{Needed, Planned, Scope};
use crate::syntax::{self, Binding, Name, NameDef, StatementKind};
use basis_prover::collections::list::Mapped;

/// Makes the names of a family known, each to be evaluated when it is needed.
pub(crate) fn plan<'a>(scope: &mut Scope<'a>, written: &'a syntax::Family) {
    for NameDef { name, parameters, value } in names(written) {
        if scope.planned.named(&name.text).is_none() {
            scope.planned.insert(name.text.clone(), Planned { parameters, value, is_declared: false });
        }
    }
}

/// Declares a name, once its place in the family is reached; whether it is free.
pub(crate) fn declare(scope: &mut Scope<'_>, name: &Name) -> bool {
    if !scope.check_free(name) {
        // Of two names that are alike the first one stays.
        if scope.planned.named(&name.text).is_some_and(|planned| !planned.is_declared) {
            scope.planned.remove(&name.text);
        }
        return false;
    }
    if let Some(planned) = scope.planned.named(&name.text).copied() {
        scope.planned.insert(name.text.clone(), Planned { is_declared: true, ..planned });
    }
    true
}

/// The names that the statements of a family give.
pub(crate) fn names(written: &syntax::Family) -> impl Iterator<Item = &NameDef> {
    written.statements.iter().filter_map(|s| match &s.kind {
        StatementKind::Let(def) => Some(def),
        _ => None,
    })
}

/// Evaluates a name that stands for one value, if that has not been done.
pub(crate) fn force(scope: &mut Scope<'_>, name: &str) {
    if scope.planned.named(name).is_some_and(|planned| planned.parameters.is_empty())
        && scope.lets.named(name).is_none()
    {
        solve(scope, Needed::Name(name.to_string()));
    }
}

/// Evaluates an expression, and before it what it needs.
pub(crate) fn attempt<'a, T>(
    scope: &mut Scope<'a>,
    run: &mut dyn FnMut(&mut Scope<'a>) -> Option<T>,
) -> Option<T> {
    loop {
        let pending = scope.pending.len();
        let result = run(scope);
        let Some((needed, _)) = scope.waits_for.take() else { return result };
        scope.pending.truncate(pending);
        solve(scope, needed);
    }
}

/// Evaluates a name or a function with all that it needs.
pub(crate) fn solve(scope: &mut Scope<'_>, first: Needed) {
    let mut stack = vec![first];
    while let Some(top) = stack.last().cloned() {
        let pending = scope.pending.len();
        let done = evaluate(scope, &top);
        match scope.waits_for.take() {
            None => {
                if !done {
                    fail(scope, &top);
                }
                stack.pop();
            }
            Some((needed, span)) => {
                scope.pending.truncate(pending);
                match stack.iter().position(|waiting| *waiting == needed) {
                    None => stack.push(needed),
                    Some(from) => {
                        report_circle(scope, &stack[from..], span);
                        for waiting in &stack[from..] {
                            fail(scope, waiting);
                        }
                        stack.truncate(from);
                    }
                }
            }
        }
    }
}

/// Evaluates one name or function; `false` when it went wrong or waits for another one.
fn evaluate(scope: &mut Scope<'_>, needed: &Needed) -> bool {
    match needed {
        Needed::Function(index) => single::evaluate(scope, index),
        Needed::Name(name) => {
            let Some(value) = scope.planned.named(name).map(|planned| planned.value) else { return false };
            // What is around the formula that needs the name has no meaning in it.
            let own = scope.order;
            let around = scope.constants.split_off(own.min(scope.constants.len()));
            let arguments = core::mem::take(&mut scope.arguments);
            let result = scope.value(value);
            scope.constants.extend(around);
            scope.arguments = arguments;
            let fine = result.is_some();
            if let Some(value) = result {
                scope.lets.insert(name.clone(), Some(value));
            }
            fine
        }
    }
}

/// Gives up on something: what needs it is not reported as well.
fn fail(scope: &mut Scope<'_>, needed: &Needed) {
    match needed {
        Needed::Name(name) => {
            scope.lets.insert(name.clone(), None);
        }
        Needed::Function(index) => single::give_up(scope, index),
    }
}

/// A circle of definitions, all of which wait for the next one.
fn report_circle(scope: &Scope<'_>, circle: &[Needed], span: Span) {
    let shown = |needed: &Needed| match needed {
        Needed::Name(name) => name.clone(),
        Needed::Function(index) => label(&scope.function_name, index),
    };
    let Some(first) = circle.first().map(shown) else { return };
    if scope.is_mistaken(&first) {
        return; // its name was declared for something else, too
    }
    let error = scope.error(span, format!("`{first}` is defined by itself"));
    let error = if circle.len() == 1 {
        error
    } else {
        let mut names: Vec<String> = circle.mapped(shown);
        names.push(first);
        if names.len() > 12 {
            let left_out = names.len() - 10;
            names.splice(6..6 + left_out, [String::from("…")]);
        }
        error.note(format!("the circle is {}", names.join(" -> ")))
    };
    scope.report(error.help("a formula may use functions and names, in any order, that do not need it"));
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
