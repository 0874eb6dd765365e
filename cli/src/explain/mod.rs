//! `basis explain`: what a family is, and what joins and theorems say, worked out exactly.

mod facts;
mod latex;

use std::rc::Rc;

use basis_engine::state::Run;
use basis_engine::theorem::theorems;
use basis_engine::{
    Checked, Disk, Family, Item, Library, Prover, Selected, Severity, Subject, decide_within,
};

use crate::args::{ExplainArguments, ExplainFormat};
use crate::output::{self, Status, complain};
use crate::{eval, spec};
use facts::{Claims, Equation, Facts, FamilyFacts, TheoremFacts};

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
    let wanted = match arguments.format {
        ExplainFormat::Text => Claims::LeftOut,
        ExplainFormat::Json | ExplainFormat::Latex => Claims::Shown,
    };
    let run = &mut Run::default();
    let mut all = Vec::new();
    let mut left_out = 0;
    // On several spans each has formulas of its own.
    let spans = |family: Rc<Family>| {
        if family.pieces.is_empty() { vec![family] } else { family.pieces.clone() }
    };
    for family in families.unwrap_or_default().into_iter().flat_map(spans) {
        if run.is_spent() {
            left_out += 1;
            continue;
        }
        let checked = (wanted == Claims::Shown).then(|| checked(&library, &family, run)).flatten();
        let facts = run.counted_work(family.budget, &mut || FamilyFacts::new(&family, checked.as_ref()));
        all.push(Facts::Family(Box::new(facts)));
    }
    all.extend(theorems.into_iter().filter_map(|theorem| Facts::theorem(&decide_within(theorem, run))));
    let printed = match arguments.format {
        ExplainFormat::Text => {
            let texts: Vec<String> = all.iter().map(as_text).collect();
            output::print(&texts.join("\n"))
        }
        ExplainFormat::Json => output::print_json(&serde_json::json!({ "items": all })),
        ExplainFormat::Latex => output::print(&latex::document(&all)),
    };
    if left_out > 0 {
        let message = format!("{} not explained: the others take too much work", count_are(left_out));
        let error = output::error(message).help("name one of them: `basis explain FILE Family`");
        complain(&(error.render(library.sources(), true) + "\n\n"));
    }
    if errors.is_empty() && left_out == 0 { printed } else { Status::Unusable }
}

/// The claims of a family with their verdicts.
fn checked(library: &Library<'_>, family: &Family, run: &mut Run) -> Option<Checked> {
    let order: Vec<i64> = family.order.iter().map(|(_, value)| *value).collect();
    Some(decide_within(library.item(&family.name, &order).ok()?, run))
}

fn as_text(facts: &Facts) -> String {
    match facts {
        Facts::Family(facts) => text(facts),
        Facts::Theorem(facts) | Facts::Join(facts) => theorem_text(facts),
    }
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

fn text(facts: &FamilyFacts) -> String {
    let mut text = format!("{}: {}\n", facts.title, facts.domain);
    for line in &facts.doc {
        text += &format!("    {line}\n");
    }
    section(&mut text, "Functions", facts.functions.iter().map(|f| (&f.name, &f.factored)));
    section(&mut text, "Expanded", facts.functions.iter().map(|f| (&f.name, &f.expanded)));
    section(&mut text, "A curve with the control points P at both ends", pairs(&facts.ends));
    let mut independence: Vec<String> = facts.dependent.iter().map(|e| format!("dependent at {e}")).collect();
    match &facts.dependent_open {
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
    section(
        &mut text,
        "Rounding errors of evaluation, at most",
        facts.rounding.iter().map(|r| (&r.of, &r.bound)),
    );
    for contact in &facts.contacts {
        section(&mut text, &contact.title, pairs(&contact.points));
        if !contact.conditions.is_empty() {
            text += &format!("    for {}\n", contact.conditions.join(" and "));
        }
    }
    if !facts.nonnegative.is_empty() {
        text += "\n  All functions are nonnegative, the other parameters in their declared ranges, for\n";
        for range in &facts.nonnegative {
            text += &format!("    {range}\n");
        }
    }
    text
}

/// The curves and surfaces of a theorem, the points that it determines, and its claims with their verdicts.
fn theorem_text(facts: &TheoremFacts) -> String {
    let mut text = facts.heading.clone();
    for line in &facts.doc {
        text += &format!("    {line}\n");
    }
    section(&mut text, "Determined control points", pairs(&facts.points));
    text += "\n  Claims\n";
    for claim in &facts.claims {
        text += &format!("    {}\n      {}: {}\n", claim.claim, claim.verdict, claim.reason);
    }
    text
}

fn pairs(equations: &[Equation]) -> impl Iterator<Item = (&String, &String)> {
    equations.iter().map(|e| (&e.name, &e.value))
}

/// `name = value` lines under a title, the signs aligned.
fn section<'f>(text: &mut String, title: &str, lines: impl Iterator<Item = (&'f String, &'f String)>) {
    let lines: Vec<(&String, &String)> = lines.collect();
    if lines.is_empty() {
        return;
    }
    let width = lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    *text += &format!("\n  {title}\n");
    for (name, value) in lines {
        *text += &format!("    {name:width$} = {value}\n");
    }
}
