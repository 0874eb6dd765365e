//! The family of a command: `Bernstein`, `Bernstein(3)` or `Bernstein(n=3)`.

use std::rc::Rc;

use basis_engine::theorem::theorems;
use basis_engine::{Diagnostic, Family, Item, Library, Selected, Severity, Subject};

use crate::name;
use crate::output::error;

/// What is typed for a family.
#[derive(Debug, PartialEq, Eq)]
struct Typed<'a> {
    name: &'a str,
    /// The values of the index parameters, with their names if these are given.
    order: Vec<(Option<&'a str>, i64)>,
}

/// The family that a text names, expanded.
///
/// # Errors
/// The text is not a family with its order, there is no such family, or the spec has errors.
pub(super) fn find(library: &Library<'_>, text: &str) -> Result<Rc<Family>, Vec<Diagnostic>> {
    let found = despite_errors(library, text);
    // A spec with errors is not what its author means, even if this family can be expanded.
    let problems = errors(library.diagnostics());
    if found.is_ok() && !problems.is_empty() { Err(problems) } else { found }
}

/// The same, if this family can be expanded, whatever is wrong with others.
///
/// # Errors
/// The text is not a family with its order, there is no such family, or it has errors.
pub(super) fn despite_errors(library: &Library<'_>, text: &str) -> Result<Rc<Family>, Vec<Diagnostic>> {
    let typed = parse(text).map_err(|e| vec![e])?;
    let names = library.names();
    let known: Vec<&str> = names.iter().map(|(name, _)| name.as_str()).collect();
    let family = name::position(typed.name, &known).map_or(typed.name, |k| known[k]);
    let item = in_order(library, family, &typed.order).and_then(|order| {
        library.item(family, &order).map_err(|e| e.map(|(message, help)| error(message).help(help)))
    });
    match item {
        Ok(Item { subject: Subject::Family(family), .. }) => Ok(family),
        Ok(_) | Err(None) => Err(errors(library.diagnostics())),
        Err(Some(mut error)) => {
            let theorems = theorems(library);
            if let Some(other) = theorems.iter().find(|other| other.subject.name() == typed.name) {
                error.message = format!("`{}` is a {}, not a family", typed.name, other.subject.kind());
            }
            Err(errors(library.diagnostics()).into_iter().chain([error]).collect())
        }
    }
}

/// The only family of a spec, in its lowest order.
pub(super) fn only(library: &Library<'_>) -> Result<Rc<Family>, Vec<Diagnostic>> {
    let mut families: Vec<Rc<Family>> = Vec::new();
    for item in library.items(Selected::EveryOrder) {
        if let Subject::Family(family) = item.subject
            && families.iter().all(|known| known.name != family.name)
        {
            families.push(family);
        }
    }
    let errors = errors(library.diagnostics());
    if !errors.is_empty() {
        return Err(errors);
    }
    match families.as_slice() {
        [one] => Ok(Rc::clone(one)),
        [] => Err(vec![error("the spec has no family")]),
        several => {
            let names: Vec<String> = several.iter().map(|f| f.title()).collect();
            let message = "the spec has several families";
            Err(vec![error(message).help(format!("name one of them: {}", names.join(", ")))])
        }
    }
}

/// The values in the order in which the family declares its index parameters.
fn in_order(
    library: &Library<'_>,
    family: &str,
    typed: &[(Option<&str>, i64)],
) -> Result<Vec<i64>, Option<Diagnostic>> {
    // Without such a family the library says what is wrong.
    let Some(declared) = library.index_names(family) else { return Ok(Vec::new()) };
    let declared: Vec<&str> = declared.iter().map(String::as_str).collect();
    let template: Vec<String> = declared.iter().map(|name| format!("{name}=…")).collect();
    let wanted =
        if declared.is_empty() { family.to_string() } else { format!("{family}({})", template.join(", ")) };
    let fail = |message: String| Err(Some(error(message).help(format!("write `{wanted}`"))));
    let mut order: Vec<Option<i64>> = vec![None; declared.len()];
    for (k, (typed_name, value)) in typed.iter().enumerate() {
        let position = match typed_name {
            Some(typed_name) => match name::position(typed_name, &declared) {
                Some(position) => position,
                None => return fail(format!("`{typed_name}` is not an index parameter of `{family}`")),
            },
            None => k,
        };
        match order.get_mut(position) {
            Some(slot) if slot.is_none() => *slot = Some(*value),
            Some(_) => return fail(format!("the index parameter `{}` is given twice", declared[position])),
            None if declared.is_empty() => return fail(format!("`{family}` has no index parameters")),
            None => {
                return fail(format!(
                    "`{family}` has only {}",
                    name::count(declared.len(), "index parameter")
                ));
            }
        }
    }
    match order.iter().position(Option::is_none) {
        Some(missing) => fail(format!("the index parameter `{}` has no value", declared[missing])),
        None => Ok(order.into_iter().flatten().collect()),
    }
}

fn parse(text: &str) -> Result<Typed<'_>, Diagnostic> {
    let malformed = || {
        error(format!("`{text}` is not a family"))
            .help("write its name, with the values of its index parameters if it has any: `Hermite`, 'Bernstein(3)' or 'Bernstein(n=3)'")
    };
    let text = text.trim();
    let (family, order) = match text.split_once('(') {
        Some((family, rest)) => (family.trim_end(), Some(rest.strip_suffix(')').ok_or_else(malformed)?)),
        None => (text, None),
    };
    if family.is_empty() || family.contains([')', ',', '=']) || family.contains(char::is_whitespace) {
        return Err(malformed());
    }
    let mut values = Vec::new();
    for part in order.unwrap_or("").split(',').map(str::trim) {
        let (index, value) = match part.split_once('=') {
            Some((index, value)) => (Some(index.trim()), value.trim()),
            None => (None, part),
        };
        if part.is_empty() && order.is_none_or(|order| order.trim().is_empty()) {
            continue;
        }
        let value = value.parse().map_err(|_| {
            error(format!("`{value}` is not the value of an index parameter")).help(format!(
                "index parameters are whole numbers: `{family}(3)`; shape values are given with `--shape`"
            ))
        })?;
        values.push((index, value));
    }
    Ok(Typed { name: family, order: values })
}

/// The errors among messages.
fn errors(diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    diagnostics.into_iter().filter(|d| d.severity == Severity::Error).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn typed<'a>(name: &'a str, order: &[(Option<&'a str>, i64)]) -> Typed<'a> {
        Typed { name, order: order.to_vec() }
    }

    #[test]
    fn reads_names_with_and_without_order() {
        assert_eq!(parse("Hermite").ok(), Some(typed("Hermite", &[])));
        assert_eq!(parse("Hermite()").ok(), Some(typed("Hermite", &[])));
        assert_eq!(parse("Bernstein(3)").ok(), Some(typed("Bernstein", &[(None, 3)])));
        assert_eq!(parse(" Bernstein ( n = 3 ) ").ok(), Some(typed("Bernstein", &[(Some("n"), 3)])));
        assert_eq!(parse("Box(2, m=-3)").ok(), Some(typed("Box", &[(None, 2), (Some("m"), -3)])));
    }

    #[test]
    fn refuses_everything_else() {
        for text in
            ["", "(3)", "B(3", "B)3(", "B(3))", "B(n)", "B(3,)", "B(,)", "B(1/2)", "B C", "B=3", "B(3)(4)"]
        {
            assert_eq!(parse(text).ok(), None, "{text}");
        }
    }
}
