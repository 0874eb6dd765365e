//! `basis explain`: what a family is, and what joins and theorems say, worked out exactly.

use std::rc::Rc;

use basis_engine::state::Run;
use basis_engine::theorem::theorems;
use basis_engine::{
    Checked, Disk, Family, Item, Library, Prover, Selected, Severity, Subject, Verdict, decide_within,
    explain,
};

use crate::args::ExplainArguments;
use crate::output::{self, Status, complain};
use crate::{domain, eval, spec};

/// Derivatives at the ends are shown up to this order.
const ORDER: u32 = 2;

/// Explains the family, join or theorem that the arguments name, or all of the file, families in their lowest orders.
pub(crate) fn run(arguments: &ExplainArguments) -> Status {
    let library = match spec::read(&arguments.file) {
        Ok(source) => Library::from_source(&Disk, &Prover, source),
        Err(error) => {
            complain(&(error.render(&basis_engine::Sources::default(), true) + "\n"));
            return Status::Unusable;
        }
    };
    let theorems: Vec<Item> = theorems(&library);
    let named = arguments.name.as_ref().and_then(|name| theorems.iter().find(|t| t.subject.name() == name));
    let (families, theorems) = match (&arguments.name, named) {
        (Some(_), Some(theorem)) => (Ok(Vec::new()), vec![theorem.clone()]),
        (Some(name), None) => {
            let mut found = eval::find_family(&library, name).map(|family| vec![family]);
            let known: Vec<&str> = theorems.iter().map(|t| t.subject.name()).collect();
            if let (Err(errors), false) = (&mut found, known.is_empty()) {
                let known = format!("joins and theorems here: {}", known.join(", "));
                errors.iter_mut().take(1).for_each(|error| error.notes.push(known.clone()));
            }
            (found, Vec::new())
        }
        (None, _) => (Ok(lowest_orders(&library)), theorems),
    };
    let mut errors = match &families {
        Ok(_) => library.diagnostics(),
        Err(errors) => errors.clone(),
    };
    errors.retain(|d| d.severity == Severity::Error);
    for error in &errors {
        complain(&(error.render(library.sources(), true) + "\n\n"));
    }
    let run = &mut Run::default();
    let mut texts = Vec::new();
    let mut left_out = 0;
    for family in families.unwrap_or_default() {
        if run.is_spent() {
            left_out += 1;
        } else {
            texts.push(run.counted_work(family.budget, &mut || text(&family)));
        }
    }
    texts.extend(theorems.into_iter().map(|theorem| theorem_text(&decide_within(theorem, run))));
    let printed = output::print(&texts.join("\n"));
    if left_out > 0 {
        let message = format!("{} not explained: the others take too much work", count_are(left_out));
        let error = output::error(message).help("name one of them: `basis explain FILE Family`");
        complain(&(error.render(library.sources(), true) + "\n\n"));
    }
    if errors.is_empty() && left_out == 0 { printed } else { Status::Unusable }
}

/// `1 family is`, `2 families are`.
fn count_are(families: usize) -> String {
    format!("{} {}", crate::name::count(families, "family"), if families == 1 { "is" } else { "are" })
}

fn lowest_orders(library: &Library<'_>) -> Vec<Rc<Family>> {
    let mut families: Vec<Rc<Family>> = Vec::new();
    // The orders of a family are neighbours.
    for item in library.items(Selected::EveryOrder) {
        if let Subject::Family(family) = item.subject
            && families.last().is_none_or(|f| f.name != family.name)
        {
            families.push(family);
        }
    }
    families
}

fn text(family: &Family) -> String {
    let mut text = format!("{}: {}\n", family.title(), domain::describe(family));
    for line in &family.doc {
        text += &format!("    {line}\n");
    }
    let formulas = explain::formulas(family);
    section(&mut text, "Functions", formulas.iter().map(|f| (f.label.clone(), f.factored.clone())));
    section(&mut text, "Expanded", formulas.iter().map(|f| (f.label.clone(), f.expanded.clone())));
    let ends = explain::end_derivatives(family, ORDER);
    section(&mut text, "A curve with the control points P at both ends", ends.into_iter());
    let set = explain::exceptional_set(family);
    let mut independence: Vec<String> = set
        .exceptions
        .iter()
        .map(|e| format!("dependent at {}", explain::describe_exception(family, e)))
        .collect();
    match set.open {
        Some(left) => independence.push(format!("undecided: {left}")),
        None if independence.is_empty() => {
            independence.push(String::from("independent for all shape values"));
        }
        None => {}
    }
    text += "\n  Linear independence\n";
    for line in independence {
        text += &format!("    {line}\n");
    }
    section(&mut text, "Rounding errors of evaluation, at most", explain::rounding(family).into_iter());
    for contact in explain::contacts(family) {
        section(&mut text, &contact.title, contact.points.into_iter());
        if !contact.conditions.is_empty() {
            text += &format!("    for {}\n", contact.conditions.join(" and "));
        }
    }
    let ranges = explain::nonnegative_ranges(family);
    if !ranges.is_empty() {
        text += "\n  All functions are nonnegative, the other parameters in their declared ranges, for\n";
        for range in ranges {
            text += &format!("    {range}\n");
        }
    }
    text
}

/// The curves and surfaces of a theorem, the points that it determines, and its claims with their verdicts.
fn theorem_text(checked: &Checked) -> String {
    let Subject::Theorem(theorem) = &checked.subject else { return String::new() };
    let mut text = domain::theorem_heading(theorem, &theorem.title());
    for line in &theorem.doc {
        text += &format!("    {line}\n");
    }
    section(&mut text, "Determined control points", explain::determined_points(theorem).into_iter());
    text += "\n  Claims\n";
    for (claim, verdict) in &checked.claims {
        let (word, why) = match verdict {
            Verdict::Proved(evidence) => ("proved", evidence.method().to_string()),
            Verdict::Refuted(witness) => ("refuted", witness.notes.join("; ")),
            Verdict::Undecided(left) => ("undecided", left.clone()),
        };
        text += &format!("    {}\n      {word}: {why}\n", claim.text);
    }
    text
}

/// `name = value` lines under a title, the signs aligned.
fn section(text: &mut String, title: &str, lines: impl Iterator<Item = (String, String)>) {
    let lines: Vec<(String, String)> = lines.collect();
    if lines.is_empty() {
        return;
    }
    let width = lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    *text += &format!("\n  {title}\n");
    for (name, value) in lines {
        *text += &format!("    {name:width$} = {value}\n");
    }
}
