//! One function of a family: its value, and those that follow by permuting indices and barycentric coordinates.

use crate::algebra::fraction::Fraction;
use crate::model::label;
use crate::model::scope::{PlannedFunction, Scope};
use crate::syntax::FunctionDef;
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::sort_unique;

/// Evaluates a function; `false` when it went wrong or waits for another one.
pub(super) fn evaluate(scope: &mut Scope<'_>, index: &[i64]) -> bool {
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
pub(super) fn give_up(scope: &mut Scope<'_>, index: &[i64]) {
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
    let corners = scope.domain.len() + 1;
    if !numbered_corners(scope, def) {
        let error = scope
            .error(def.name.span, "`permute` needs a simplex and one index for each barycentric coordinate");
        scope.report(error.help("declare `domain triangle (u, v, w);` and write `permute b[2,1,0] = …;`"));
        return false;
    }
    let mut new: SortedMap<Vec<i64>, Fraction> = SortedMap::new();
    for order in orders(corners) {
        let mut moved = vec![0; corners];
        for (from, to) in order.iter().enumerate() {
            moved[*to] = index[from];
        }
        let vars = scope.domain.clone();
        let by: Vec<Fraction> = order[..corners - 1].mapped(|to| scope.barycentric(*to));
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
    def.permute && scope.dependent.is_some() && def.indices.len() == scope.domain.len() + 1
}

/// All permutations of an index, each once.
pub(super) fn permuted(index: &[i64]) -> Vec<Vec<i64>> {
    let mut all = orders(index.len()).mapped(|order| order.mapped(|k| index[*k]));
    sort_unique(&mut all);
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
