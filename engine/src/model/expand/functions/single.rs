//! One function of a family: its value, and those that follow by permuting indices and barycentric coordinates.

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::model::label;
use crate::model::scope::{PlannedFunction, Scope};
use crate::plural::list;
use crate::syntax::FunctionDef;
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::sort_unique;

/// Evaluates a function; `false` when it went wrong or waits for another one.
pub(in crate::model::expand) fn evaluate(scope: &mut Scope<'_>, index: &[i64]) -> bool {
    let Some(PlannedFunction { def, index: own, constants }) = scope.planned_functions.get(&index.to_vec())
    else {
        return false;
    };
    let (def, own) = (*def, own.clone());
    let depth = scope.constants.len();
    scope.constants.extend(constants.iter().cloned());
    // The formula of the span.
    let further = scope.span.and_then(|(k, _)| def.further.get(k.checked_sub(1)?));
    let value = scope.scalar(further.unwrap_or(&def.value));
    scope.constants.truncate(depth);
    let Some(value) = value else { return false };
    if def.permute {
        return permutations(scope, def, &own, &value);
    }
    scope.planned_functions.remove(&own);
    scope.functions.insert(own, Some(value));
    true
}

/// Leaves a function without a value, and those that the same loop or permutation defines.
pub(in crate::model::expand) fn give_up(scope: &mut Scope<'_>, index: &[i64]) {
    let Some(PlannedFunction { def, .. }) = scope.planned_functions.get(&index.to_vec()) else { return };
    let def = *def;
    if def.permute || !def.loops.generators.is_empty() {
        scope.cut_short = true;
        scope.planned_functions.retain(|_, planned| !core::ptr::eq(planned.def, def));
        return;
    }
    scope.planned_functions.remove(&index.to_vec());
    scope.functions.insert(index.to_vec(), None);
}

/// Defines all functions that follow by permuting indices and barycentric coordinates together.
fn permutations(scope: &mut Scope<'_>, def: &FunctionDef, index: &[i64], value: &Fraction) -> bool {
    if !numbered_corners(scope, def) {
        let names: Vec<String> = scope.factors().concat().mapped(|var| scope.names[var.0].clone());
        let error = if scope.simplices.len() < scope.factors().len() && !scope.simplices.is_empty() {
            let zeros = vec!["0"; names.len() - 1].join(",");
            scope
                .error(def.name.span, "`permute` needs one index for each coordinate of the domain")
                .help(format!("write one for each of {}: `permute b[1,{zeros}] = …;`", list(&names)))
        } else {
            scope
                .error(
                    def.name.span,
                    "`permute` needs a simplex and one index for each barycentric coordinate",
                )
                .help("declare `domain triangle (u, v, w);` and write `permute b[2,1,0] = …;`")
        };
        scope.report(error);
        return false;
    }
    let coordinates = scope.factors().concat();
    let mut new: SortedMap<Vec<i64>, Fraction> = SortedMap::new();
    let vars = scope.domain.clone();
    for order in exchanges(scope) {
        let mut moved = vec![0; order.len()];
        for (from, to) in order.iter().enumerate() {
            moved[*to] = index[from];
        }
        let place = |var: &Var| coordinates.iter().position(|c| c == var).unwrap_or(0);
        let by: Vec<Fraction> = vars.mapped(|var| {
            let to = coordinates[order[place(var)]];
            scope.last_of(to).map_or_else(|| Fraction::var(to), |simplex| scope.last_coordinate(simplex))
        });
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
        scope.planned_functions.remove(&index);
        scope.functions.insert(index, Some(value));
    }
    true
}

/// Whether a definition is one of functions that have an index for each corner of a simplex, and for all permutations.
pub(super) fn numbered_corners(scope: &Scope<'_>, def: &FunctionDef) -> bool {
    def.permute && !scope.index_places(def.indices.len()).is_empty()
}

/// All permutations of an index, each once: of the places that belong to a simplex among themselves.
pub(super) fn permuted(scope: &Scope<'_>, index: &[i64]) -> Vec<Vec<i64>> {
    let mut all = exchanges(scope).mapped(|order| order.mapped(|k| index[*k]));
    sort_unique(&mut all);
    all
}

/// All orders of the coordinates of the domain that exchange those of a simplex among themselves.
fn exchanges(scope: &Scope<'_>) -> Vec<Vec<usize>> {
    let mut all: Vec<Vec<usize>> = vec![Vec::new()];
    for factor in scope.factors() {
        let own = orders(factor.len());
        let longer = |start: &Vec<usize>| {
            let more = |order: &Vec<usize>| [&start[..], &order.mapped(|k| start.len() + k)].concat();
            own.mapped(more)
        };
        all = all.iter().flat_map(longer).listed();
    }
    all
}

/// All orders of 0, 1, …, len − 1.
fn orders(len: usize) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new()];
    for _ in 0..len {
        all = all
            .into_iter()
            .flat_map(|start: Vec<usize>| {
                (0..len).filter(|k| !start.contains(k)).map(|k| [start.as_slice(), &[k]].concat()).listed()
            })
            .listed();
    }
    all
}
