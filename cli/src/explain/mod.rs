//! `basis explain`: what a family is, and what joins and theorems say, worked out exactly.

mod facts;
mod latex;
mod lines;
mod matrix;
mod places;

use std::rc::Rc;

use basis_engine::state::Run;
use basis_engine::theorem::theorems;
use basis_engine::{Disk, Family, Item, Library, Prover, Selected, Severity, Subject, decide_all, explain};

use crate::args::{ExplainArguments, ExplainFormat};
use crate::output::{self, Status, complain};
use crate::{eval, name, spec};
use facts::{ClaimFacts, Equation, Facts, FamilyFacts, MatrixFacts, TheoremFacts, Whole};

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
            let mut found = eval::find_despite_errors(&library, name).map(|family| vec![family]);
            let known: Vec<&str> = theorems.iter().map(|t| t.subject.name()).collect();
            if let (Err(errors), false) = (&mut found, known.is_empty()) {
                let known = format!("joins and theorems here: {}", known.join(", "));
                if let Some(unknown) = errors.iter_mut().find(|error| error.labels.is_empty()) {
                    unknown.notes.push(known);
                }
            }
            (found, Vec::new())
        }
        (None, _) if arguments.to.is_some() => {
            (eval::only_family(&library).map(|family| vec![family]), Vec::new())
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
    let target = match &arguments.to {
        Some(name) => match eval::find_family(&library, name) {
            Ok(target) => Some(target),
            Err(problems) => {
                // Those of the spec have been said.
                for error in problems.iter().filter(|_| errors.is_empty()) {
                    complain(&(error.render(library.sources(), true) + "\n\n"));
                }
                return Status::Unusable;
            }
        },
        None => None,
    };
    let mut all = Vec::new();
    let mut left_out = 0;
    // All claims first, and then facts with the work of a run of their own: neither takes what the other needs.
    let run = &mut Run::default();
    let families = families.unwrap_or_default();
    let items: Vec<_> = families.iter().map(|family| item(&library, family)).collect();
    let known: Vec<bool> = items.iter().map(Option::is_some).collect();
    let mut checked = decide_all(items.into_iter().flatten().collect(), run).into_iter();
    let checked: Vec<_> = known.into_iter().map(|known| known.then(|| checked.next()).flatten()).collect();
    let theorems = decide_all(theorems, run);
    let run = &mut Run::default();
    for (family, checked) in families.into_iter().zip(checked) {
        if run.is_spent() {
            left_out += 1;
            continue;
        }
        let next = next_order(&library, &family);
        let conversions = match &target {
            Some(target) => match explain::conversions(&family, target) {
                Ok(matrices) => matrices,
                Err(reason) => {
                    let message =
                        format!("there is no matrix from `{}` to `{}`", family.title(), target.title());
                    complain(&(output::error(message).note(reason).render(library.sources(), true) + "\n\n"));
                    return Status::Unusable;
                }
            },
            None => Vec::new(),
        };
        // On several spans each has formulas of its own; claims are about all of them, and stand with the first one.
        let spans =
            if family.pieces.is_empty() { core::slice::from_ref(&family) } else { &family.pieces[..] };
        let whole = run.counted_work(&mut || Whole::new(&family));
        for (k, span) in spans.iter().enumerate() {
            let checked = checked.as_ref().filter(|_| k == 0);
            let facts = run.counted_work(&mut || {
                FamilyFacts::new(&library, (&whole, span), checked, next.as_deref(), &conversions)
            });
            all.push(Facts::Family(Box::new(facts)));
        }
    }
    all.extend(theorems.iter().filter_map(|checked| Facts::theorem(&library, checked)));
    let printed = match arguments.format {
        ExplainFormat::Text => {
            let mut text = String::new();
            for (k, facts) in all.iter().enumerate() {
                if !text.is_empty() {
                    text.push('\n');
                }
                text += &as_text(facts, is_another_span(&all, k));
            }
            output::print(&text)
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

/// A family with its claims.
fn item(library: &Library<'_>, family: &Family) -> Option<Item> {
    let order: Vec<i64> = family.order.iter().map(|(_, value)| *value).collect();
    library.item(&family.name, &order).ok()
}

/// A family with one index parameter in the order after this one, if there is one.
fn next_order(library: &Library<'_>, family: &Family) -> Option<Rc<Family>> {
    let [(_, order)] = family.order.as_slice() else { return None };
    match library.item(&family.name, &[order + 1]).ok()?.subject {
        Subject::Family(next) => Some(next),
        Subject::Theorem(_) => None,
    }
}

/// Whether these are facts of another span of the family before them.
fn is_another_span(all: &[Facts], k: usize) -> bool {
    let title = |k: usize| match all.get(k) {
        Some(Facts::Family(f)) => f.whole_domain.as_ref().map(|_| &f.title),
        _ => None,
    };
    k > 0 && title(k).is_some() && title(k) == title(k - 1)
}

fn as_text(facts: &Facts, another_span: bool) -> String {
    match facts {
        Facts::Family(facts) => text(facts, another_span),
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

/// What is said of a family, or of another span of it.
fn text(facts: &FamilyFacts, another_span: bool) -> String {
    let mut text = String::new();
    if !another_span {
        text += &format!("{}: {}", facts.title, facts.whole_domain.as_ref().unwrap_or(&facts.domain));
        for (word, parts) in [("shape", &facts.shapes), ("assume", &facts.assumptions)] {
            if !parts.is_empty() {
                text += &format!("; {word} {}", parts.join(", "));
            }
        }
        text.push('\n');
        for line in &facts.doc {
            text += format!("    {line}").trim_end();
            text.push('\n');
        }
    }
    // On several spans what is about the whole family comes first.
    if facts.whole_domain.is_some() {
        if !another_span {
            summary(&mut text, &facts.claims);
            names(&mut text, &facts.definitions);
            independence(&mut text, facts);
            contacts(&mut text, facts);
            for matrix in &facts.matrices_of_whole_domain {
                grid(&mut text, matrix);
            }
            text.push('\n');
        }
        text += &format!("  On {}\n", facts.domain);
    }
    section(&mut text, "Functions", facts.functions.iter().map(|f| (&f.name, &f.factored)));
    section(&mut text, "Expanded", facts.functions.iter().map(|f| (&f.name, &f.expanded)));
    if facts.whole_domain.is_none() {
        summary(&mut text, &facts.claims);
        names(&mut text, &facts.definitions);
    }
    section(&mut text, "A curve with the control points P at both ends", pairs(&facts.ends));
    if facts.whole_domain.is_none() {
        independence(&mut text, facts);
    }
    section(
        &mut text,
        "Rounding errors of evaluation, at most",
        facts.rounding.iter().map(|r| (&r.of, &r.bound)),
    );
    if let Some(assumed) = &facts.rounding_assumes {
        text += &format!("    {assumed}\n");
    }
    if facts.whole_domain.is_none() {
        contacts(&mut text, facts);
    }
    for matrix in &facts.matrices {
        grid(&mut text, matrix);
    }
    if let Some(left_out) = &facts.matrices_open {
        text += &format!("\n  {left_out}\n");
    }
    places::section(&mut text, facts);
    if !facts.nonnegative.is_empty() {
        let others =
            if facts.assumptions.is_empty() { "in their declared ranges" } else { "as declared and assumed" };
        text += &format!("\n  All functions are nonnegative, the other parameters {others}, for\n");
        for range in &facts.nonnegative {
            text += &format!("    {range}\n");
        }
    }
    text
}

/// What contacts with another curve determine.
fn contacts(text: &mut String, facts: &FamilyFacts) {
    for contact in &facts.contacts {
        section(text, &contact.title, pairs(&contact.points));
        if !contact.conditions.is_empty() {
            *text += &format!("    for {}\n", contact.conditions.join(" and "));
        }
    }
}

/// Where the functions are linearly dependent.
fn independence(text: &mut String, facts: &FamilyFacts) {
    let mut lines: Vec<String> = facts.dependent.iter().map(|e| format!("dependent at {e}")).collect();
    match &facts.dependent_open {
        Some(left) => lines.push(format!("undecided: {left}")),
        None if lines.is_empty() => lines.push(String::from("independent for all shape values")),
        None => {}
    }
    *text += "\n  Linear independence\n";
    for line in lines {
        *text += &format!("    {line}\n");
    }
}

/// How many claims are proved and refuted, and which; claims of one statement with the same verdict share a line.
fn summary(text: &mut String, claims: &[ClaimFacts]) {
    if claims.is_empty() {
        return;
    }
    let word = |claim: &ClaimFacts| match (claim.verdict, claim.declared) {
        ("undecided", "conjecture") => "open conjecture",
        (verdict, _) => verdict,
    };
    let counts: Vec<String> = ["proved", "refuted", "undecided", "open conjecture"]
        .into_iter()
        .map(|wanted| (claims.iter().filter(|c| word(c) == wanted).count(), wanted))
        .filter(|(count, _)| *count > 0)
        .map(|(count, word)| match word {
            "open conjecture" => name::count(count, word),
            _ => format!("{count} {word}"),
        })
        .collect();
    *text += &format!("\n  Claims: {}\n", counts.join(", "));
    for (first, shown) in groups(claims) {
        let wrong = if first.as_declared { "" } else { ", not as declared" };
        *text += &format!("    {:9} {shown}{wrong}\n", first.verdict);
        if first.verdict != "proved" {
            *text += &format!("              {}\n", first.reason);
        }
    }
}

/// The claims as they are shown, of those of one statement with the same verdict the first one with how many there are.
fn groups(claims: &[ClaimFacts]) -> Vec<(&ClaimFacts, String)> {
    let mut groups: Vec<(&ClaimFacts, usize)> = Vec::new();
    for claim in claims {
        match groups.iter_mut().find(|(first, _)| {
            (first.statement, first.verdict, &first.written)
                == (claim.statement, claim.verdict, &claim.written)
        }) {
            Some((_, size)) => *size += 1,
            None => groups.push((claim, 1)),
        }
    }
    let shown = |(first, size): (&'_ ClaimFacts, usize)| match size {
        1 => first.claim.clone(),
        _ => format!("{} ({})", first.written, name::count(size, "claim")),
    };
    groups.into_iter().map(|group| (group.0, shown(group))).collect()
}

/// What names in the claims stand for.
fn names(text: &mut String, definitions: &[Equation]) {
    section(text, "Names in the claims", pairs(definitions));
}

/// A matrix with more columns is left to JSON.
const MAX_COLUMNS: usize = 24;

/// A matrix under its title, its columns aligned.
fn grid(text: &mut String, matrix: &MatrixFacts) {
    *text += &format!("\n  {}\n", matrix.title);
    if matrix.columns.len() > MAX_COLUMNS {
        let (rows, columns) = (matrix.rows.len(), matrix.columns.len());
        *text += &format!("    {rows} rows, {columns} columns: see `--format json`\n");
        return;
    }
    let head = std::iter::once("").chain(matrix.columns.iter().map(String::as_str));
    let body = matrix.rows.iter().zip(&matrix.entries);
    let body = body
        .map(|(name, row)| std::iter::once(name.as_str()).chain(row.iter().map(String::as_str)).collect());
    let lines: Vec<Vec<&str>> = std::iter::once(head.collect()).chain(body).collect();
    let width = |k: usize| lines.iter().filter_map(|line| line.get(k)).map(|cell| cell.chars().count()).max();
    let widths: Vec<usize> = (0..=matrix.columns.len()).map(|k| width(k).unwrap_or(0)).collect();
    for line in &lines {
        let cells = line.iter().zip(&widths).map(|(cell, width)| format!("{cell:>width$}"));
        *text += &format!("    {}\n", cells.collect::<Vec<_>>().join("  "));
    }
}

/// The curves and surfaces of a theorem, the points that it determines, and its claims with their verdicts.
fn theorem_text(facts: &TheoremFacts) -> String {
    let mut text = facts.heading.clone();
    for line in &facts.doc {
        text += &format!("    {line}\n");
    }
    section(&mut text, "Determined control points", pairs(&facts.points));
    text += "\n  Claims\n";
    for (first, shown) in groups(&facts.claims) {
        text += &format!("    {shown}\n      {}: {}\n", first.verdict, first.reason);
    }
    names(&mut text, &facts.definitions);
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
