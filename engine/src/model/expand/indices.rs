//! Whether the indices of a family's functions leave no gap.

use crate::diagnostic::Diagnostic;
use crate::model::label;
use crate::model::scope::Scope;
use crate::model::tuples::{grid, multi_indices};
use crate::plural::list;
use crate::syntax;
use basis_prover::collections::list::Listed;

/// More functions than this are refused.
pub(crate) const MAX_FUNCTIONS: usize = 512;

/// Whether indices run from 0 without a gap: on a simplex with one index for each corner all tuples of one sum, else
/// every place on its own. Reports what is missing.
pub(crate) fn check_indices(scope: &Scope<'_>, written: &syntax::Family) -> bool {
    // A formula that went wrong has left out the rest of its loop.
    let (false, Some(width)) = (scope.cut_short, scope.functions.keys().next().map(Vec::len)) else {
        return true;
    };
    let corners = scope.dependent.is_some() && width == scope.domain.len() + 1;
    if corners && let Some(error) = other_sum(scope) {
        scope.report(error);
        return false;
    }
    let sum = scope.functions.keys().next().map_or(0, |index| index.iter().sum());
    let wanted =
        if corners { multi_indices(width, sum, MAX_FUNCTIONS) } else { grid(&sizes(scope), MAX_FUNCTIONS) };
    let missing: Vec<&Vec<i64>> =
        wanted.iter().filter(|index| !scope.functions.contains_key(*index)).listed();
    if missing.is_empty() {
        return true;
    }
    let mut names: Vec<String> =
        missing.iter().take(4).map(|index| format!("`{}`", label(&scope.function_name, index))).listed();
    if missing.len() > 4 {
        names.push(String::from("others"));
    }
    let verb = if names.len() == 1 { "is" } else { "are" };
    let last = scope.defined.values().max_by_key(|definition| definition.place);
    let span = last.map_or(written.name.span, |definition| definition.span);
    let error = scope.error(span, format!("{} {verb} missing", list(&names)));
    scope.report(if corners {
        on_simplex(scope, error, &missing, sum)
    } else {
        let last = scope.functions.keys().next_back().map(|i| label(&scope.function_name, i));
        let error = error.label(format!("indices go up to `{}`", last.unwrap_or_default()));
        error.help(
            too_few_names(scope, width, sum)
                .unwrap_or_else(|| String::from("indices run from 0 without a gap")),
        )
    });
    false
}

/// On a simplex: the first function whose indices have another sum than those of most others.
fn other_sum(scope: &Scope<'_>) -> Option<Diagnostic> {
    let sum = |index: &[i64]| index.iter().sum::<i64>();
    let mut sums = scope.functions.keys().map(|index| sum(index));
    let first = sums.next()?;
    if sums.all(|other| other == first) {
        return None;
    }
    let mut functions: Vec<_> = scope.defined.iter().listed();
    functions.sort_by_key(|(_, definition)| definition.place);
    let others = |s: i64| functions.iter().filter(|(index, _)| sum(index) == s).count();
    let (most, _) = functions.iter().rev().max_by_key(|(index, _)| others(sum(index)))?;
    let (odd, definition) = functions.iter().find(|(index, _)| sum(index) != sum(most))?;
    let name = |index| label(&scope.function_name, index);
    let message = format!(
        "the indices of `{}` sum to {}, those of `{}` to {}",
        name(odd),
        sum(odd),
        name(most),
        sum(most)
    );
    let error = scope.error(definition.span, message);
    Some(error.help("on a simplex the indices of all functions have the same sum"))
}

/// What to write for functions that are missing on a simplex.
fn on_simplex(scope: &Scope<'_>, error: Diagnostic, missing: &[&Vec<i64>], sum: i64) -> Diagnostic {
    let error = error.label(format!("the indices sum to {sum}"));
    let sorted = |index: &[i64]| {
        let mut index = index.to_vec();
        index.sort_unstable_by(|a, b| b.cmp(a));
        index
    };
    let orbit = missing
        .iter()
        .map(|index| sorted(index))
        .find(|orbit| scope.functions.keys().any(|index| sorted(index) == *orbit));
    match orbit {
        Some(orbit) => {
            let name = label(&scope.function_name, &orbit);
            error.help(format!("`permute {name} = …;` defines all permutations of the index"))
        }
        None => error.help(format!("define one function for each index with the sum {sum}")),
    }
}

/// What to write when the indices run over a simplex of another dimension than the domain has.
fn too_few_names(scope: &Scope<'_>, width: usize, sum: i64) -> Option<String> {
    if width < 2 || !scope.functions.keys().all(|index| index.iter().sum::<i64>() == sum) {
        return None;
    }
    let name = &scope.function_name;
    Some(match (scope.dependent.is_some(), scope.domain.len()) {
        (true, 2) => format!(
            "a triangle has three coordinates: write `{name}[i, j, k] = … for i, j, k in simplex({sum});`"
        ),
        (true, _) => {
            format!(
                "a tetrahedron has four coordinates: write `{name}[i, j, k, l] = … for i, j, k, l in simplex({sum});`"
            )
        }
        (false, 1) => {
            format!("on an interval one index is enough: write `{name}[i] = … for i in 0..={sum};`")
        }
        (false, _) => {
            format!("on a box each index runs by itself: write `for i in 0..={sum}, j in 0..={sum}`")
        }
    })
}

/// One more than the greatest index, in every place.
pub(crate) fn sizes(scope: &Scope<'_>) -> Vec<i64> {
    let width = scope.functions.keys().next().map_or(0, Vec::len);
    (0..width).map(|k| scope.functions.keys().map(|index| index[k]).max().unwrap_or(0) + 1).listed()
}
