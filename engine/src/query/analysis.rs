//! The verdicts of one version of a text, decided piece by piece.

use core::ops::Range;

use basis_prover::collections::map::SortedMap;

use crate::claim::Claim;
use crate::diagnostic::{Diagnostic, Diagnostics, Place};
use crate::expanded;
use crate::model::{Family, Library};
use crate::plural::count;
use crate::source::{Files, Source, SourceId, Sources};
use crate::state::{self, Prover, Run, Verdict};
use crate::subject::Subject;

/// The items of one version of a text, with the verdicts that are decided.
#[derive(Debug)]
pub struct Analysis {
    /// The families in every order, then the theorems and joins.
    pub items: Vec<Analysed>,
    /// What is wrong apart from claims.
    pub diagnostics: Vec<Diagnostic>,
    /// The text and those it uses.
    pub sources: Sources,
    /// The round, the item and the claim that come next.
    next: (usize, usize, usize),
    run: Run,
}

/// An item with the claims that are decided.
#[derive(Debug)]
pub struct Analysed {
    /// What the claims are about.
    pub subject: Subject,
    /// The claims, in the order in which they are written.
    pub claims: Vec<(Claim, Option<Verdict>)>,
}

/// A statement that makes claims, one for each order and value of its index variables.
#[derive(Debug)]
pub struct Statement<'a> {
    /// Its bytes.
    pub place: Range<usize>,
    /// Its claims that are decided.
    pub decided: Vec<(&'a Subject, &'a Claim, &'a Verdict)>,
    /// Whether all are.
    pub complete: bool,
}

impl Analysis {
    /// Reads and expands a text.
    pub fn new(files: &dyn Files, source: Source) -> Self {
        let library = Library::from_source(files, &Prover, source);
        let mut run = Run::default();
        let (items, warnings) = expanded(&library, &mut run);
        let items = items.into_iter().map(|item| Analysed {
            subject: item.subject,
            claims: item.claims.into_iter().map(|claim| (claim, None)).collect(),
        });
        let items = items.collect();
        let diagnostics = library.diagnostics().into_iter().chain(warnings).collect();
        Self { items, diagnostics, sources: library.sources().clone(), next: (0, 0, 0), run }
    }

    /// Whether every claim is decided.
    pub fn is_done(&self) -> bool {
        self.next.0 >= Run::ROUNDS
    }

    /// Goes on with the next claim that is open, which may take several attempts; `false` when there is none.
    pub fn decide_next(&mut self) -> bool {
        while !self.is_done() {
            let (round, item, claim) = self.next;
            let Some(item) = self.items.get_mut(item) else {
                let open = self.items.iter().flat_map(|item| &item.claims).any(|(_, v)| v.is_none());
                self.next = (if open { round + 1 } else { Run::ROUNDS }, 0, 0);
                continue;
            };
            let Some((claim, verdict)) = item.claims.get_mut(claim) else {
                self.next = (round, self.next.1 + 1, 0);
                continue;
            };
            self.next.2 += 1;
            if verdict.is_none() {
                *verdict = self.run.decide_in(round, &item.subject, claim);
                return true;
            }
        }
        false
    }

    /// The messages about the text so far, those about claims included. Of the claims of one statement with the same verdict,
    /// such as those of many orders, the first stands for all.
    pub fn messages(&self) -> Vec<Diagnostic> {
        let mut claims: Vec<(Diagnostic, usize)> = Vec::new();
        let mut known = SortedMap::new();
        for item in &self.items {
            let verdicts = item.claims.iter().filter_map(|(claim, verdict)| Some((claim, verdict.as_ref()?)));
            for (claim, verdict) in verdicts {
                let Some(message) = state::diagnose(&item.subject, claim, verdict) else { continue };
                let kind = (matches!(verdict, Verdict::Proved(_)), matches!(verdict, Verdict::Refuted(_)));
                let first = match &claim.place {
                    Place::Text(id, range) => {
                        *known.get_or_insert_with((*id, range.start, range.end, kind), || claims.len())
                    }
                    Place::Token(..) => claims.len(),
                };
                match claims.get_mut(first) {
                    Some((_, others)) => *others += 1,
                    None => claims.push((message, 0)),
                }
            }
        }
        let with_others = |(message, others): (Diagnostic, usize)| match others {
            0 => message,
            _ => message.note(format!("{} of this statement: the same verdict", count(others, "more claim"))),
        };
        let mut all: Diagnostics = self.diagnostics.iter().cloned().collect();
        all.extend(claims.into_iter().map(with_others));
        all.into_list()
    }

    /// The text itself, among those that were read.
    pub fn main(&self) -> Option<SourceId> {
        self.sources.iter().next().map(|(id, _)| id)
    }

    /// The statements that make claims, in the order of the text.
    pub fn statements(&self) -> Vec<Statement<'_>> {
        let mut all: SortedMap<(usize, usize), Statement<'_>> = SortedMap::new();
        for item in &self.items {
            for (claim, verdict) in &item.claims {
                let Place::Text(id, place) = &claim.place else { continue };
                if Some(*id) != self.main() {
                    continue;
                }
                let statement = all.get_or_insert_with((place.start, place.end), || Statement {
                    place: place.clone(),
                    decided: Vec::new(),
                    complete: true,
                });
                match verdict {
                    Some(verdict) => statement.decided.push((&item.subject, claim, verdict)),
                    None => statement.complete = false,
                }
            }
        }
        all.into_values()
    }

    /// A family in its lowest order.
    pub fn family(&self, name: &str) -> Option<&Family> {
        self.items.iter().find_map(|item| match &item.subject {
            Subject::Family(family) if family.name == name => Some(family.as_ref()),
            _ => None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::query::forget_tokens;
    use crate::source::Disk;

    #[test]
    fn verdicts_and_messages_need_no_tokens() {
        let spec = "family Bent {\n    domain 0 <= t <= pi/2;\n    b[0] = 1 - sin(t);\n    b[1] = sin(t);\n\
                    \n    prove partition_of_unity;\n    prove b[0] >= 1/2;\n    prove b[0](t/2) <= 1;\n    wrong;\n}\n";
        let source = || Source::text("bent.basis", spec);
        let mut at_once = Analysis::new(&Disk, source());
        while at_once.decide_next() {}
        let shown = |analysis: &Analysis| {
            analysis.messages().iter().map(|m| m.render(&analysis.sources, false)).collect::<Vec<_>>()
        };
        let expected = shown(&at_once);
        assert_eq!(expected.len(), 2, "{expected:?}");
        let mut later = Analysis::new(&Disk, source());
        forget_tokens();
        let _other = Analysis::new(
            &Disk,
            Source::text("other.basis", "family Other { domain 0 <= t <= 1; b[0] = 1; }"),
        );
        while later.decide_next() {}
        assert_eq!(shown(&later), expected);
        assert_eq!(shown(&at_once), expected);
    }
}
