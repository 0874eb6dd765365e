//! The functions of a family: one by one, by loops, by permutation, and by recursion from a lowest order.

use std::collections::BTreeMap;

use super::scope::{Scope, multi_indices};
use super::{Function, label};
use proc_macro2::Span;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::syntax::{self, Binding, FunctionDef, StatementKind};
use crate::words::{count, list};

/// More functions than this are refused.
const MAX_FUNCTIONS: usize = 512;

/// Defines what the statements define, in the order in which they are written.
pub(super) fn define(scope: &mut Scope<'_>, written: &syntax::Family) {
    name_functions(scope, written);
    let mut base = None;
    let (mut bases, mut raises) = (None, None);
    for statement in &written.statements {
        match &statement.kind {
            StatementKind::Let(name, value) => {
                let free = scope.check_free(name);
                let value = scope.scalar(value);
                if free {
                    scope.lets.push((name.text.clone(), value));
                }
            }
            StatementKind::Function(def) => function(scope, def),
            StatementKind::Base(order, functions) => {
                let first = once(scope, &mut bases, order.name.span, "`base`", "there is one lowest order");
                base = if first { self::base(scope, order, functions) } else { base };
            }
            StatementKind::Raise(def) => {
                let help = "write the whole formula in one statement";
                match &base {
                    _ if !once(scope, &mut raises, def.name.span, "`raise`", help) => {}
                    Some((name, lowest)) => raise(scope, def, name, *lowest),
                    // A lowest order that went wrong has been reported.
                    None if bases.is_some() => {}
                    None => {
                        scope.cut_short = true;
                        scope.report(
                            scope
                                .error(
                                    def.name.span,
                                    "`raise` needs the functions of the lowest order before it",
                                )
                                .help("write `base n = 3 { … }`"),
                        );
                    }
                }
            }
            _ => {}
        }
    }
    if let Some((name, lowest)) = &base
        && scope.constant(name).is_some_and(|n| n > *lowest)
        && !written.statements.iter().any(|s| matches!(s.kind, StatementKind::Raise(_)))
    {
        let error = scope
            .error(written.name.span, format!("the functions of order {name} > {lowest} are not defined"));
        scope.report(
            error.help(
                "write `raise b[i] = …;`, which gives the functions of order n from those of order n - 1",
            ),
        );
        scope.cut_short = true;
    }
}

/// Whether a statement that a family has at most once is the first one; the others are errors.
fn once(scope: &Scope<'_>, first: &mut Option<Span>, span: Span, what: &str, help: &str) -> bool {
    let Some(first) = *first else {
        *first = Some(span);
        return true;
    };
    let error = scope.error(span, format!("{what} is given twice")).label("given again here");
    scope.report(error.also(scope.place(first), "first given here").help(help));
    false
}

/// All definitions of functions, also those of the lowest order.
fn definitions(written: &syntax::Family) -> impl Iterator<Item = &FunctionDef> {
    written.statements.iter().flat_map(|s| match &s.kind {
        StatementKind::Function(def) | StatementKind::Raise(def) => core::slice::from_ref(def),
        StatementKind::Base(_, functions) => functions.as_slice(),
        _ => &[],
    })
}

/// All functions share the name of the first one.
fn name_functions(scope: &mut Scope<'_>, written: &syntax::Family) {
    for def in definitions(written) {
        if scope.function_name.is_empty() {
            if scope.check_free(&def.name) {
                scope.function_name.clone_from(&def.name.text);
            }
        } else if def.name.text != scope.function_name {
            let message =
                format!("the functions are called `{}`, not `{}`", scope.function_name, def.name.text);
            let error = scope.error(def.name.span, message);
            scope.report(error.help("use one name for all functions of a family, `let` for anything else"));
        }
    }
}

fn function(scope: &mut Scope<'_>, def: &FunctionDef) {
    let mut any = false;
    let fine = scope.each(&def.loops, &mut |scope| {
        any = true;
        let Some(index) = index(scope, def) else { return false };
        let value = scope.scalar(&def.value);
        scope.cut_short |= value.is_none() && (def.permute || !def.loops.generators.is_empty());
        if def.permute {
            return value.is_some_and(|value| permutations(scope, def, &index, &value));
        }
        if scope.functions.contains_key(&index) {
            let name = label(&def.name.text, &index);
            let error = scope.error(def.name.span, format!("`{name}` is defined twice"));
            scope.report(error.label("defined again here").help("remove one of the definitions"));
            return false;
        }
        let fine = value.is_some();
        scope.functions.insert(index, value);
        fine
    });
    // A range that depends on the order may well be empty for the lowest one.
    if fine && !any && scope.constants.is_empty() {
        let error = scope.error(def.name.span, "the loop is empty: no function is defined");
        scope.report(error.help("write the smaller bound first, `0..=n` includes n"));
    }
}

/// The index that a definition gives, checked.
fn index(scope: &mut Scope<'_>, def: &FunctionDef) -> Option<Vec<i64>> {
    let mut index = Vec::new();
    for i in &def.indices {
        index.push(scope.whole(i, "the index of a function")?);
    }
    if let Some(negative) = index.iter().find(|i| **i < 0) {
        scope.report(
            scope
                .error(def.name.span, format!("the index {negative} is negative"))
                .help("indices start at 0"),
        );
        return None;
    }
    if scope.functions.len() >= MAX_FUNCTIONS {
        scope.report(
            scope.error(def.name.span, format!("the family has more than {MAX_FUNCTIONS} functions")),
        );
        return None;
    }
    if let Some(other) = scope.functions.keys().next().filter(|k| k.len() != index.len()) {
        let indices = |n: usize| if n == 1 { String::from("1 index") } else { format!("{n} indices") };
        let (new, old) = (label(&def.name.text, &index), label(&def.name.text, other));
        let message = format!("`{new}` has {}, `{old}` has {}", indices(index.len()), indices(other.len()));
        scope.report(
            scope.error(def.name.span, message).help("give all functions the same number of indices"),
        );
        return None;
    }
    Some(index)
}

/// Defines all functions that follow by permuting indices and barycentric coordinates together.
fn permutations(scope: &mut Scope<'_>, def: &FunctionDef, index: &[i64], value: &Fraction) -> bool {
    let corners = scope.domain.len() + 1;
    if scope.dependent.is_none() || index.len() != corners {
        let error = scope
            .error(def.name.span, "`permute` needs a simplex and one index for each barycentric coordinate");
        scope.report(error.help("declare `domain triangle (u, v, w);` and write `permute b[2,1,0] = …;`"));
        return false;
    }
    let mut new: BTreeMap<Vec<i64>, Fraction> = BTreeMap::new();
    for order in orders(corners) {
        let mut moved = vec![0; corners];
        for (from, to) in order.iter().enumerate() {
            moved[*to] = index[from];
        }
        let vars = scope.domain.clone();
        let by: Vec<Fraction> = order[..corners - 1].iter().map(|to| scope.barycentric(*to)).collect();
        let Some(value) = scope.put(value, &vars, &by, def.value.span) else { return false };
        match new.get(&moved) {
            Some(other) if *other != value => {
                let name = label(&def.name.text, &moved);
                let error = scope
                    .error(def.value.span, format!("two permutations give different formulas for `{name}`"));
                scope.report(
                    error.help(
                        "where two indices are equal, the formula must be symmetric in their variables",
                    ),
                );
                return false;
            }
            _ => {
                new.insert(moved, value);
            }
        }
    }
    for (index, value) in new {
        if scope.functions.contains_key(&index) {
            let name = label(&def.name.text, &index);
            let error =
                scope.error(def.name.span, format!("`{name}` is defined twice")).label("defined again here");
            scope.report(error.help("`permute` defines all permutations of the index"));
            return false;
        }
        scope.functions.insert(index, Some(value));
    }
    true
}

/// All orders of 0, 1, …, len − 1.
fn orders(len: usize) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new()];
    for _ in 0..len {
        all = all
            .into_iter()
            .flat_map(|start: Vec<usize>| {
                (0..len)
                    .filter(|k| !start.contains(k))
                    .map(|k| [start.as_slice(), &[k]].concat())
                    .collect::<Vec<_>>()
            })
            .collect();
    }
    all
}

/// The functions of the lowest order; its index parameter and value.
fn base(scope: &mut Scope<'_>, order: &Binding, functions: &[FunctionDef]) -> Option<(String, i64)> {
    let name = &order.name.text;
    let lowest = scope.whole(&order.value, "the lowest order");
    let Some(wanted) = scope.constant(name) else {
        let error = scope.error(order.name.span, format!("`{name}` is not an index parameter of the family"));
        scope.report(error.help(format!("declare it: `family Name({name} in 1..=8)`")));
        return None;
    };
    let lowest = lowest?;
    if wanted < lowest {
        let error = scope.error(
            order.value.span,
            format!("the order {name} = {wanted} is below the lowest order {lowest}"),
        );
        scope.report(error.help(format!("declare the range from there on: `{name} in {lowest}..=8`")));
        scope.cut_short = true;
        return None;
    }
    scope.constants.push((name.clone(), lowest));
    for def in functions {
        function(scope, def);
    }
    scope.constants.pop();
    Some((name.clone(), lowest))
}

/// The functions of every order after the lowest, each from those of the order before.
fn raise(scope: &mut Scope<'_>, def: &FunctionDef, order: &str, lowest: i64) {
    let mut names = Vec::new();
    for i in &def.indices {
        match &i.kind {
            syntax::ExprKind::Name(name) if scope.taken(name).is_none() => names.push(name.clone()),
            _ => {
                let error = scope.error(i.span, "`raise` needs a new name for each index");
                scope.report(error.help("write `raise b[i,j,k] = …;`"));
                scope.cut_short = true;
                return;
            }
        }
    }
    let wanted = scope.constant(order).unwrap_or(lowest);
    if wanted > lowest {
        let known = scope.functions.iter();
        scope.base = known
            .filter_map(|(index, value)| Some(Function { index: index.clone(), value: value.clone()? }))
            .collect();
    }
    for current in lowest + 1..=wanted {
        let Some(indices) = raised_indices(scope, def, names.len()) else {
            scope.cut_short = true;
            return;
        };
        scope.constants.push((order.to_string(), current));
        scope.missing_is_zero = true;
        let mut raised = BTreeMap::new();
        for index in indices {
            let depth = scope.constants.len();
            scope.constants.extend(names.iter().cloned().zip(index.iter().copied()));
            let value = scope.scalar(&def.value);
            scope.constants.truncate(depth);
            scope.cut_short |= value.is_none();
            raised.insert(index, value);
            if scope.cut_short {
                break;
            }
        }
        scope.missing_is_zero = false;
        scope.constants.pop();
        scope.functions = raised;
        if scope.cut_short {
            return;
        }
    }
}

/// The indices of the next order: on a simplex those with a sum greater by one, else one more in each place.
fn raised_indices(scope: &Scope<'_>, def: &FunctionDef, width: usize) -> Option<Vec<Vec<i64>>> {
    let last = scope.functions.keys().next_back()?.clone();
    if last.len() != width {
        let message = format!(
            "`raise` has {}, the functions of the lowest order have {}",
            count(width, "name"),
            last.len()
        );
        scope.report(scope.error(def.name.span, message).help("use as many names as there are indices"));
        return None;
    }
    let indices = if scope.dependent.is_some() && width == scope.domain.len() + 1 {
        multi_indices(width, last.iter().sum::<i64>() + 1, MAX_FUNCTIONS)
    } else {
        grid(&sizes(scope).iter().map(|s| s + 1).collect::<Vec<_>>())
    };
    if indices.len() > MAX_FUNCTIONS {
        scope.report(
            scope.error(def.name.span, format!("the family has more than {MAX_FUNCTIONS} functions")),
        );
        return None;
    }
    Some(indices)
}

/// What is wrong with a function that the recursion reads and that does not exist; `None` when it lies outside of the order
/// before, where the functions are 0.
pub(super) fn gap(scope: &Scope<'_>, index: &[i64]) -> Option<(String, &'static str)> {
    let sizes = sizes(scope);
    if index.len() != sizes.len() || index.iter().any(|i| *i < 0) {
        return None;
    }
    let corners = scope.dependent.is_some() && index.len() == scope.domain.len() + 1;
    let wanted = label(&scope.function_name, index);
    let missing = format!("`{wanted}` is missing in the order before");
    let define = "the recursion needs all functions of the lowest order: define it in `base`";
    if !corners {
        return index.iter().zip(&sizes).all(|(i, size)| i < size).then_some((missing, define));
    }
    let sum = |index: &[i64]| index.iter().sum::<i64>();
    let before = scope.functions.keys().map(|other| sum(other)).max().unwrap_or(0);
    if sum(index) == before {
        return Some((missing, define));
    }
    let message =
        format!("the indices of `{wanted}` sum to {}, those of the order before to {before}", sum(index));
    Some((message, "lower one index by one in every term: `b[i-1,j,k]`, `b[i,j-1,k]`, `b[i,j,k-1]`"))
}

/// One more than the greatest index, in every place.
fn sizes(scope: &Scope<'_>) -> Vec<i64> {
    let width = scope.functions.keys().next().map_or(0, Vec::len);
    (0..width).map(|k| scope.functions.keys().map(|index| index[k]).max().unwrap_or(0) + 1).collect()
}

/// All tuples below the given sizes, in lexicographic order; at most one more than a family may have.
fn grid(sizes: &[i64]) -> Vec<Vec<i64>> {
    let mut all = vec![Vec::new()];
    for size in sizes {
        all = all
            .iter()
            .flat_map(|start: &Vec<i64>| (0..*size).map(move |k| [start.as_slice(), &[k]].concat()))
            .take(MAX_FUNCTIONS + 1)
            .collect();
    }
    all
}

/// Indices run from 0 without a gap: on a simplex with one index for each corner all tuples of one sum, else
/// every place on its own.
pub(super) fn check_indices(scope: &Scope<'_>, written: &syntax::Family) {
    // A formula that went wrong has left out the rest of its loop.
    let (false, Some(width)) = (scope.cut_short, scope.functions.keys().next().map(Vec::len)) else { return };
    let corners = scope.dependent.is_some() && width == scope.domain.len() + 1;
    let sum = scope.functions.keys().map(|index| index.iter().sum::<i64>()).max().unwrap_or(0);
    let wanted = if corners { multi_indices(width, sum, MAX_FUNCTIONS) } else { grid(&sizes(scope)) };
    let mut missing: Vec<String> = wanted
        .iter()
        .filter(|index| !scope.functions.contains_key(*index))
        .map(|index| format!("`{}`", label(&scope.function_name, index)))
        .collect();
    let too_low = scope.functions.keys().find(|index| corners && index.iter().sum::<i64>() != sum);
    if missing.is_empty() && too_low.is_none() {
        return;
    }
    if missing.len() > 4 {
        missing.truncate(4);
        missing.push(String::from("others"));
    }
    let last = scope.functions.keys().next_back().map(|i| label(&scope.function_name, i)).unwrap_or_default();
    let span = definitions(written).last().map_or(written.name.span, |def| def.name.span);
    let error = match too_low {
        Some(index) => {
            let (low, high) = (label(&scope.function_name, index), index.iter().sum::<i64>());
            scope
                .error(span, format!("the indices of `{low}` sum to {high}, those of `{last}` to {sum}"))
                .help("on a simplex the indices of all functions have the same sum")
        }
        None => {
            let verb = if missing.len() == 1 { "is" } else { "are" };
            scope
                .error(span, format!("{} {verb} missing", list(&missing)))
                .label(format!("indices go up to `{last}`"))
                .help("indices run from 0 without a gap")
        }
    };
    scope.report(error);
}

impl Scope<'_> {
    /// A barycentric coordinate by its place; the last one is 1 minus the others.
    pub(super) fn barycentric(&self, place: usize) -> Fraction {
        match self.domain.get(place) {
            Some(var) => Fraction::var(*var),
            None => {
                let one = Fraction::constant(Rational::ONE);
                self.domain.iter().fold(one, |rest, var: &Var| &rest - &Fraction::var(*var))
            }
        }
    }
}
