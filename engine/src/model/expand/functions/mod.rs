//! The functions of a family: one by one, by loops, by permutation, and by recursion from a lowest order.

mod indices;
pub(super) mod single;

use std::rc::Rc;

use proc_macro2::Span;

use self::indices::{MAX_FUNCTIONS, sizes};
use self::single::{numbered_corners, permuted};
use super::names;
use crate::algebra::poly::{Poly, Var};
use crate::model::scope::{Definition, Needed, PlannedFunction, Scope};
use crate::model::tuples::numbered;
use crate::model::{Family, Function, label};
use crate::plural::{count, indices};
use crate::syntax::{self, Binding, FunctionDef, StatementKind};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::sort_by;

pub(super) use self::indices::check_indices;

/// Defines what the statements define. Names and functions may stand in any order, unless the functions are raised from
/// those of a lowest order: then a statement sees what those before it define.
pub(crate) fn define<'a>(scope: &mut Scope<'a>, written: &'a syntax::Family) {
    name_functions(scope, written);
    check_spans(scope, written);
    for (count, def) in names::names(written).enumerate() {
        if !scope.has_room(count, def.name.span) {
            scope.cut_short = true;
            return;
        }
        names::declare(scope, &def.name);
    }
    let recursive = written
        .statements
        .iter()
        .any(|s| matches!(s.kind, StatementKind::Base(..) | StatementKind::Raise(_)));
    if !recursive {
        for statement in &written.statements {
            if let StatementKind::Function(def) = &statement.kind {
                plan(scope, def);
            }
        }
    }
    let mut base: Option<(String, i64)> = None;
    let (mut bases, mut raises) = (None, None);
    for statement in &written.statements {
        match &statement.kind {
            StatementKind::Let(def) => names::force(scope, &def.name.text),
            StatementKind::Function(def) => {
                if recursive {
                    plan(scope, def);
                }
                function(scope, def);
            }
            StatementKind::Base(order, functions) => {
                let help = "give the functions of one order; `raise` gives all others";
                if once(scope, &mut bases, order.name.span, "`base`", help) {
                    base = self::base(scope, written, order, functions);
                    scope.cut_short |= base.is_none();
                }
            }
            StatementKind::Raise(def) => {
                let help = "write the whole formula in one statement";
                match &base {
                    _ if !once(scope, &mut raises, def.name.span, "`raise`", help) => {}
                    Some((name, lowest)) => raise(scope, written, def, name, *lowest),
                    // A lowest order that went wrong has been reported.
                    None if bases.is_some() => {}
                    // What could not be read may have been the lowest order.
                    None if written.incomplete => scope.cut_short = true,
                    None => no_base(scope, written, def),
                }
            }
            _ => {}
        }
    }
    if let Some((name, lowest)) = &base
        && scope.constant(name).is_some_and(|n| n > *lowest)
        && !written.incomplete
        && !written.statements.iter().any(|s| matches!(s.kind, StatementKind::Raise(_)))
    {
        let error = scope
            .error(written.name.span, format!("the functions of order {name} > {lowest} are not defined"));
        let width = scope.functions.keys().next().map_or(1, Vec::len).min(4);
        let raised = format!("{}[{}]", scope.function_name, ["i", "j", "k", "l"][..width].join(", "));
        scope.report(error.help(format!(
            "write `raise {raised} = …;`, which gives the functions of order {name} from those of order {name} - 1"
        )));
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

/// `raise` without the functions it starts from.
fn no_base(scope: &mut Scope<'_>, written: &syntax::Family, def: &FunctionDef) {
    let error = scope.error(def.name.span, "`raise` needs the functions of the lowest order before it");
    if written.statements.iter().any(|s| matches!(s.kind, StatementKind::Base(..))) {
        scope.report(error.help("`base` and its functions come first, then `raise`"));
        scope.cut_short = true;
        return;
    }
    let order = written.orders.first().and_then(|order| Some((&order.name.text, scope.bounds(order)?.0)));
    scope.report(match order {
        Some((name, lowest)) => error.help(format!("write `base {name} = {lowest} {{ … }}`")),
        None => {
            error.help(format!("write `family {}(n in 3..=8)` and `base n = 3 {{ … }}`", written.name.text))
        }
    });
    scope.cut_short = true;
}

/// All definitions of functions, also those of the lowest order.
fn definitions(written: &syntax::Family) -> impl Iterator<Item = &FunctionDef> {
    written.statements.iter().flat_map(|s| match &s.kind {
        StatementKind::Function(def) | StatementKind::Raise(def) => core::slice::from_ref(def),
        StatementKind::Base(_, functions) => functions.as_slice(),
        _ => &[],
    })
}

/// All functions share the name that most of them have.
fn name_functions(scope: &mut Scope<'_>, written: &syntax::Family) {
    let mut counts: SortedMap<&str, usize> = SortedMap::new();
    for def in definitions(written) {
        *counts.get_or_insert_with(&def.name.text, || 0) += 1;
    }
    let most = counts.values().max().copied().unwrap_or(0);
    let usual = |def: &&FunctionDef| counts.get(&def.name.text.as_str()) == Some(&most);
    if let Some(def) = definitions(written).find(usual) {
        if scope.check_free(&def.name) {
            scope.function_name.clone_from(&def.name.text);
        } else {
            // What else has the name has no index: that is not another mistake.
            scope.undeclared.borrow_mut().push(def.name.text.clone());
        }
    }
    for def in definitions(written) {
        if scope.function_name.is_empty() {
            return;
        }
        if def.name.text != scope.function_name {
            let message =
                format!("the functions are called `{}`, not `{}`", scope.function_name, def.name.text);
            let error = scope.error(def.name.span, message);
            scope.undeclared.borrow_mut().push(def.name.text.clone());
            scope.report(error.help("use one name for all functions of a family, `let` for anything else"));
        }
    }
}

/// Finds out which functions a statement defines, each to be evaluated when it is needed.
fn plan<'a>(scope: &mut Scope<'a>, def: &'a FunctionDef) {
    let depth = scope.constants.len();
    let mut found: Option<(Vec<PlannedFunction<'a>>, bool)> = None;
    names::attempt(scope, &mut |scope| {
        let mut all = Vec::new();
        let fine = scope.each(&def.loops, &mut |scope| {
            // One more than there may be: then that is said.
            if all.len() > MAX_FUNCTIONS {
                return false;
            }
            let Some(index) = index(scope, def) else {
                scope.cut_short |= scope.waits_for.is_none();
                return false;
            };
            all.push(PlannedFunction { def, index, constants: scope.constants[depth..].to_vec() });
            true
        });
        found = Some((all, fine));
        Some(())
    });
    let Some((all, fine)) = found else { return };
    // A range that depends on the order may well be empty for the lowest one.
    if fine && all.is_empty() && scope.constants.is_empty() {
        let (message, help) = if def.loops.condition.is_some() {
            (
                "the condition does not hold: no function is defined",
                "leave the condition out, or the function",
            )
        } else {
            ("the loop is empty: no function is defined", "write the smaller bound first, `0..=n` includes n")
        };
        scope.report(scope.error(def.name.span, message).help(help));
    }
    for function in all {
        let indices = if numbered_corners(scope, def) {
            permuted(scope, &function.index)
        } else {
            vec![function.index.clone()]
        };
        if !indices.into_iter().all(|index| insert(scope, &function, index)) {
            return;
        }
    }
}

/// Evaluates the functions that a statement defines.
fn function(scope: &mut Scope<'_>, def: &FunctionDef) {
    let own = scope.planned_functions.iter().filter(|(_, planned)| core::ptr::eq(planned.def, def));
    let mut indices: Vec<(usize, Vec<i64>)> =
        own.map(|(index, _)| (scope.defined.get(index).map_or(0, |d| d.place), index.clone())).listed();
    sort_by(&mut indices, Ord::cmp);
    for (_, index) in indices {
        if scope.planned_functions.contains_key(&index) {
            names::solve(scope, Needed::Function(index));
        }
    }
}

/// Adds a function that is to be evaluated; reports one that is there already.
fn insert<'a>(scope: &mut Scope<'a>, function: &PlannedFunction<'a>, index: Vec<i64>) -> bool {
    let def = function.def;
    if let Some(Definition { span: first, permuted, .. }) = scope.defined.get(&index) {
        // Under another name it is no second mistake.
        if def.name.text != scope.function_name {
            return true;
        }
        let name = label(&def.name.text, &index);
        let error = scope
            .error(def.name.span, format!("`{name}` is defined twice"))
            .label("defined again here")
            .also(scope.place(*first), "first defined here");
        scope.report(error.help(if *permuted || def.permute {
            "`permute` defines all permutations of the index"
        } else {
            "remove one of the definitions"
        }));
        scope.cut_short = true;
        return false;
    }
    if scope.functions.len() + scope.planned_functions.len() >= MAX_FUNCTIONS {
        scope.report(
            scope.error(def.name.span, format!("the family has more than {MAX_FUNCTIONS} functions")),
        );
        scope.cut_short = true;
        return false;
    }
    let definition = Definition { place: scope.defined.len(), span: def.name.span, permuted: def.permute };
    scope.defined.insert(index.clone(), definition);
    let constants = function.constants.clone();
    scope.planned_functions.insert(index, PlannedFunction { def, index: function.index.clone(), constants });
    true
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
    let mut known = scope.functions.keys().chain(scope.planned_functions.keys());
    if let Some(other) = known.next().filter(|k| k.len() != index.len()) {
        let (new, old) = (label(&def.name.text, &index), label(&def.name.text, other));
        let message = format!("`{new}` has {}, `{old}` has {}", indices(index.len()), indices(other.len()));
        scope.report(
            scope.error(def.name.span, message).help("give all functions the same number of indices"),
        );
        return None;
    }
    Some(index)
}

/// The functions of the lowest order; its index parameter and value.
fn base<'a>(
    scope: &mut Scope<'a>,
    written: &syntax::Family,
    order: &Binding,
    functions: &'a [FunctionDef],
) -> Option<(String, i64)> {
    let name = &order.name.text;
    let lowest = names::attempt(scope, &mut |scope| scope.whole(&order.value, "the lowest order"));
    let Some(wanted) = scope.constant(name) else {
        let error = scope.error(order.name.span, format!("`{name}` is not an index parameter of the family"));
        let from = lowest.unwrap_or(1);
        let help = format!("declare it: `family {}({name} in {from}..={})`", written.name.text, from + 5);
        scope.report(error.help(help));
        return None;
    };
    let lowest = lowest?;
    if wanted < lowest {
        let error = scope.error(
            order.value.span,
            format!("the order {name} = {wanted} is below the lowest order {lowest}"),
        );
        let declared = written.orders.iter().find(|o| o.name.text == *name);
        let last = declared.and_then(|o| scope.bounds(o)).map_or(lowest, |(_, last)| last.max(lowest));
        scope.report(error.help(format!("declare the range from there on: `{name} in {lowest}..={last}`")));
        return None;
    }
    scope.constants.push((name.clone(), lowest));
    for def in functions {
        plan(scope, def);
        function(scope, def);
    }
    scope.constants.pop();
    Some((name.clone(), lowest))
}

/// The functions of every order after the lowest, each from those of the order before.
fn raise(scope: &mut Scope<'_>, written: &syntax::Family, def: &FunctionDef, order: &str, lowest: i64) {
    if !def.loops.generators.is_empty() || def.loops.condition.is_some() {
        let error = scope.error(
            def.name.span,
            "`raise` gives all functions of the next order: it has no loop and no condition",
        );
        let help = "leave `for` and `if` out; of several formulas the right one is chosen by sums over one value, such as `sum(b[i] for k in 0..1 if i < n)`";
        scope.report(error.help(help));
        scope.cut_short = true;
        return;
    }
    let mut names = Vec::new();
    for i in &def.indices {
        match &i.kind {
            syntax::ExprKind::Name(name) if scope.taken(name).is_none() => names.push(name.clone()),
            syntax::ExprKind::Name(name) if name == order => {
                let error = scope.error(i.span, format!("`{name}` is the order, and no index"));
                scope.report(
                    error.help("the functions on the left are those of this order: `raise b[i] = …;`"),
                );
                scope.cut_short = true;
                return;
            }
            _ => {
                let error = scope.error(i.span, "`raise` needs a new name for each index");
                scope.report(error.help(
                    "write `raise b[i] = …;` with the functions of the order before on the right, `b[i]` and `b[i - 1]`",
                ));
                scope.cut_short = true;
                return;
            }
        }
    }
    // What is missing in the lowest order would be taken for zero in the next.
    if !check_indices(scope, written) {
        scope.cut_short = true;
        return;
    }
    let wanted = scope.constant(order).unwrap_or(lowest);
    if wanted > lowest {
        let known = scope.functions.iter();
        scope.base = known
            .filter_map(|(index, value)| Some(Function { index: index.clone(), value: value.clone()? }))
            .listed();
    }
    let mut done = lowest;
    if let Some(before) = order_before(scope, written, lowest, wanted) {
        scope.functions = SortedMap::new();
        for f in &before.functions {
            scope.functions.insert(f.index.clone(), Some(f.value.clone()));
        }
        done = wanted - 1;
    }
    for current in done + 1..=wanted {
        let Some(indices) = raised_indices(scope, def, names.len()) else {
            scope.cut_short = true;
            return;
        };
        scope.constants.push((order.to_string(), current));
        scope.missing_is_zero = true;
        let mut raised = SortedMap::new();
        for index in indices {
            let depth = scope.constants.len();
            scope.constants.extend(names.iter().cloned().zip(index.iter().copied()));
            let value = names::attempt(scope, &mut |scope| scope.scalar(&def.value));
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

/// The family of the order before, expanded once for all orders above it; `None` where it may not be what the
/// recursion runs through on its way to a higher order, and where its range begins later.
fn order_before(scope: &Scope<'_>, written: &syntax::Family, lowest: i64, wanted: i64) -> Option<Rc<Family>> {
    // Other statements may depend on the order that is wanted.
    let own = |s: &syntax::Statement| matches!(s.kind, StatementKind::Let(..) | StatementKind::Function(_));
    if written.orders.len() != 1 || written.statements.iter().any(own) {
        return None;
    }
    let mut family = None;
    // From the lowest on, so that each needs one other only.
    for order in lowest + 1..wanted {
        family = Some(scope.library.family(scope.unit, &written.name.text, &[order]).ok()?);
    }
    // Each order may have angles of its own, and shape parameters, so that its variables have other numbers.
    family.filter(|f| {
        let is_same = |v: &Var| f.names.get(v.0).is_some_and(|name| scope.names.get(v.0) == Some(name));
        let variables = |f: &Function| [f.value.numer(), f.value.denom()].map(Poly::variables).concat();
        f.analytic.is_empty()
            && scope.analytic.is_empty()
            && f.functions.iter().all(|f| variables(f).iter().all(is_same))
    })
}

/// The indices of the next order: those of a simplex with a sum greater by one, else one more in each place.
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
    let sizes = sizes(scope).mapped(|s| s + 1);
    let indices = numbered(&scope.index_places(width), &last, 1, &sizes, MAX_FUNCTIONS);
    if indices.len() > MAX_FUNCTIONS {
        scope.report(
            scope.error(def.name.span, format!("the family has more than {MAX_FUNCTIONS} functions")),
        );
        return None;
    }
    Some(indices)
}

/// Several formulas belong to several spans, and to functions without recursion.
fn check_spans(scope: &mut Scope<'_>, written: &syntax::Family) {
    for statement in &written.statements {
        let (def, plain) = match &statement.kind {
            StatementKind::Function(def) => (def, true),
            StatementKind::Raise(def) => (def, false),
            _ => continue,
        };
        if !def.further.is_empty() && (scope.span.is_none() || !plain) {
            scope.cut_short = true;
            if written.incomplete && plain {
                return; // what could not be read may have been the spans
            }
            let error = scope.error(def.name.span, "several formulas for one span");
            scope.report(
                error.help("name the domain variable once for each span: `domain 0 <= x <= 1, 1 <= x <= 3;`"),
            );
        }
    }
}
