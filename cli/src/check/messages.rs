//! What is wrong, as rustc would print it; a claim that fails in many orders is shown once.

use std::collections::BTreeSet;

use basis_engine::{Diagnostic, Diagnostics};

use super::orders;
use super::prove::Outcome;
use super::statements::{Entry, parts};
use crate::name::count;

/// Prints messages, each once, even if several files use the file that it is about.
#[derive(Debug, Default)]
pub(crate) struct Printer {
    printed: BTreeSet<String>,
}

impl Printer {
    /// Those of the messages about one file that are new.
    pub(crate) fn render(&mut self, messages: Vec<String>) -> String {
        let mut text = String::new();
        for rendered in messages {
            if self.printed.insert(rendered.clone()) {
                text += &rendered;
                text += "\n\n";
            }
        }
        text
    }
}

/// The messages about one file.
pub(crate) fn of(outcome: &Outcome) -> Vec<String> {
    let all: Diagnostics = outcome.diagnostics.iter().cloned().chain(claims(outcome)).collect();
    all.into_list().iter().map(|diagnostic| diagnostic.render(&outcome.sources, true)).collect()
}

/// The first of the claims of each statement that fail in the same way, and how many more there are.
fn claims(outcome: &Outcome) -> Vec<Diagnostic> {
    let families = outcome.items.chunk_by(|a, b| a.subject.is_same(&b.subject));
    let failures = families.flat_map(parts);
    failures.filter_map(|(_, entries)| first_of(&entries)).collect()
}

fn first_of(entries: &[Entry<'_>]) -> Option<Diagnostic> {
    let [first, others @ ..] = entries else { return None };
    let order = first.item.subject.order();
    let mut diagnostic = first.decided.error.clone()?;
    let (here, elsewhere): (Vec<&Entry<'_>>, Vec<&Entry<'_>>) =
        others.iter().partition(|e| e.item.subject.order() == order);
    if !here.is_empty() {
        let more = count(here.len(), "more claim");
        diagnostic = diagnostic.note(format!("{more} of this statement: the same verdict"));
    }
    if !elsewhere.is_empty() {
        let orders = orders::describe(elsewhere.iter().map(|e| e.item.subject.order()));
        diagnostic = diagnostic.note(format!("for {orders}: the same verdict"));
    }
    Some(diagnostic)
}
