//! Whether the indices of a family's functions leave no gap.

use crate::diagnostic::Diagnostic;
use crate::model::label;
use crate::model::scope::Scope;
use crate::model::tuples::numbered;
use crate::plural::list;
use crate::syntax;
use basis_prover::collections::list::{Listed, Mapped};
use core::ops::Range;
use proc_macro2::Span;

use basis_prover::collections::sort::{sort_by, sort_by_key};

/// More functions than this are refused.
pub(crate) const MAX_FUNCTIONS: usize = 512;

/// Whether indices run from 0 without a gap: with one index for each coordinate those of a simplex are all tuples of one
/// sum, else every place is on its own. Reports what is missing.
pub(crate) fn check_indices(scope: &Scope<'_>, written: &syntax::Family) -> bool {
    // A formula that went wrong has left out the rest of its loop.
    let (false, Some(width)) = (scope.cut_short, scope.functions.keys().next().map(Vec::len)) else {
        return true;
    };
    let places = scope.index_places(width);
    if let Some(error) = places.iter().filter(|own| own.len() > 1).find_map(|own| other_sum(scope, own)) {
        scope.report(error);
        return false;
    }
    let first = scope.functions.keys().next().cloned().unwrap_or_default();
    let sum = first.iter().sum();
    let wanted = numbered(&places, &first, 0, &sizes(scope), MAX_FUNCTIONS);
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
    if let Some(error) = other_width(scope, width, span) {
        scope.report(error);
        return false;
    }
    let error = scope.error(span, format!("{} {verb} missing", list(&names)));
    scope.report(if let Some(help) = digits(scope, width) {
        error.help(help)
    } else if let [_] = places.as_slice() {
        on_simplex(scope, error, &missing, sum)
    } else if !places.is_empty() {
        on_product(scope, error, &places, &first)
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

/// What to write where all indices of a triangle are the digits of one number, `b[110]` for `b[1, 1, 0]`.
fn digits(scope: &Scope<'_>, width: usize) -> Option<String> {
    let names = scope.domain.len() + scope.simplices.len();
    let largest = scope.functions.keys().next_back()?;
    let digits = largest.first()?.to_string();
    let meant = width == 1 && names > 1 && digits.len() == names;
    let indices = digits.chars().map(String::from).listed().join(", ");
    let name = &scope.function_name;
    meant.then(|| format!("write an index for each coordinate: `{name}[{indices}]` for `{name}[{digits}]`"))
}

/// The first function whose indices at the places of a simplex have another sum there than those of most others.
fn other_sum(scope: &Scope<'_>, own: &Range<usize>) -> Option<Diagnostic> {
    let sum = |index: &[i64]| index[own.clone()].iter().sum::<i64>();
    let mut sums = scope.functions.keys().map(|index| sum(index));
    let first = sums.next()?;
    if sums.all(|other| other == first) {
        return None;
    }
    let mut functions: Vec<_> = scope.defined.iter().listed();
    sort_by_key(&mut functions, |(_, definition)| definition.place);
    let others = |s: i64| functions.iter().filter(|(index, _)| sum(index) == s).count();
    let (most, _) = functions.iter().rev().max_by_key(|(index, _)| others(sum(index)))?;
    let (odd, definition) = functions.iter().find(|(index, _)| sum(index) != sum(most))?;
    let name = |index| label(&scope.function_name, index);
    let of = if own.len() == most.len() { String::new() } else { format!(" in {}", coordinates(scope, own)) };
    let message = format!(
        "the indices of `{}`{of} sum to {}, those of `{}` to {}",
        name(odd),
        sum(odd),
        name(most),
        sum(most)
    );
    let error = scope.error(definition.span, message);
    Some(error.help("on a simplex the indices of all functions have the same sum"))
}

/// The coordinates to which some places of an index belong, `(u, v, w)` or `z`.
fn coordinates(scope: &Scope<'_>, own: &Range<usize>) -> String {
    let all = scope.factors().concat();
    let names: Vec<&str> = all[own.clone()].iter().map(|var| scope.names[var.0].as_str()).listed();
    if names.len() == 1 { names.concat() } else { format!("({})", names.join(", ")) }
}

/// What to write for functions that are missing on a product of simplices and intervals.
fn on_product(scope: &Scope<'_>, error: Diagnostic, places: &[Range<usize>], first: &[i64]) -> Diagnostic {
    let sizes = sizes(scope);
    let (mut shown, mut loops) = (Vec::new(), Vec::new());
    let mut letters = LETTERS.into_iter();
    for own in places {
        let names: Vec<&str> = letters.by_ref().take(own.len()).listed();
        let of = coordinates(scope, own);
        if own.len() == 1 {
            shown.push(format!("that of {of} goes up to {}", sizes[own.start] - 1));
            loops.push(format!("{} in 0..={}", names.concat(), sizes[own.start] - 1));
        } else {
            let sum: i64 = first[own.clone()].iter().sum();
            shown.push(format!("those of {of} sum to {sum}"));
            loops.push(format!("{} in simplex({sum})", names.join(", ")));
        }
    }
    error.label(format!("of the indices {}", list(&shown))).help(format!(
        "define one function for each index `for {}`, or number the functions with one index",
        loops.join(", ")
    ))
}

/// What to write for functions that are missing on a simplex.
fn on_simplex(scope: &Scope<'_>, error: Diagnostic, missing: &[&Vec<i64>], sum: i64) -> Diagnostic {
    let error = error.label(format!("the indices sum to {sum}"));
    let sorted = |index: &[i64]| {
        let mut index = index.to_vec();
        sort_by(&mut index, |a, b| b.cmp(a));
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

/// The error for functions on a product of simplices and intervals with another number of indices than it has coordinates.
fn other_width(scope: &Scope<'_>, width: usize, span: Span) -> Option<Diagnostic> {
    let factors = scope.factors();
    let names = factors.concat().mapped(|var| scope.names[var.0].clone());
    if scope.simplices.is_empty() || factors.len() < 2 || width < 2 || width == names.len() {
        return None;
    }
    let has = crate::plural::indices(width);
    let error =
        scope.error(span, format!("the functions have {has}, the domain has {} coordinates", names.len()));
    let first = scope.functions.keys().next()?;
    // The order is that of the first simplex.
    let sum = first.iter().take(factors.iter().map(Vec::len).max().unwrap_or(1)).sum::<i64>().max(1);
    let mut letters = LETTERS.into_iter();
    let (mut all, mut loops) = (Vec::new(), Vec::new());
    for own in &factors {
        let names: Vec<&str> = letters.by_ref().take(own.len()).listed();
        loops.push(match names.as_slice() {
            [only] => format!("{only} in 0..=1"),
            _ => format!("{} in simplex({sum})", names.join(", ")),
        });
        all.extend(names);
    }
    let name = &scope.function_name;
    let label = format!("one index for each coordinate: {}", list(&names));
    Some(error.label(label).help(format!(
        "write `{name}[{}] = … for {};`, or number the functions with one index",
        all.join(", "),
        loops.join(", ")
    )))
}

/// Names of index variables.
const LETTERS: [&str; 16] = ["i", "j", "k", "l", "m", "p", "q", "r", "s", "a", "c", "d", "e", "f", "g", "h"];

/// What to write when the indices run over a simplex of another dimension than the domain has.
fn too_few_names(scope: &Scope<'_>, width: usize, sum: i64) -> Option<String> {
    if width < 2 || !scope.functions.keys().all(|index| index.iter().sum::<i64>() == sum) {
        return None;
    }
    let name = &scope.function_name;
    Some(match (!scope.simplices.is_empty(), scope.domain.len()) {
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
