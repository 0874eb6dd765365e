//! Decides every claim of a file, with the time that each takes.

use std::time::{Duration, Instant};

use basis_engine::diagnostic::Place;
use basis_engine::formulas::{self, Formulas, PointFormulas};
use basis_engine::model::obligation::Obligation;
use basis_engine::state;
use basis_engine::{
    Claim, Diagnostic, Diagnostics, Disk, Item, Library, Prover, Severity, Sources, Subject, Verdict,
    expanded,
};

use super::files::Entry;
use crate::output::Status;
use crate::spec;

/// Whether formulas are read a second time, as they are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Formal {
    /// Nobody asks for them.
    Left,
    /// They are exported.
    Kept,
}

/// What checking a file gives.
#[derive(Debug)]
pub(crate) struct Outcome {
    /// The path as the user wrote it.
    pub(crate) path: String,
    /// The families of the file, in every order, then its theorems and joins.
    pub(crate) items: Vec<Decided>,
    /// The doc comment of the file.
    pub(crate) doc: Vec<String>,
    /// What is wrong with the spec apart from its claims.
    pub(crate) diagnostics: Vec<Diagnostic>,
    /// The file and those it uses.
    pub(crate) sources: Sources,
    /// Whether the file was read.
    pub(crate) readable: bool,
}

/// A family of one order, a theorem or a join, with its claims.
#[derive(Debug)]
pub(crate) struct Decided {
    /// What the claims are about.
    pub(crate) subject: Subject,
    /// What holds, so that its formulas and claims mean something.
    pub(crate) obligations: Vec<Obligation>,
    /// The claims in the order in which they are written.
    pub(crate) claims: Vec<DecidedClaim>,
    /// If they are asked for, the formulas of a family as they are written; nothing if one has no counterpart.
    pub(crate) formulas: Option<Formulas>,
    /// The same of a theorem or join.
    pub(crate) points: Option<PointFormulas>,
}

/// A claim with its verdict.
#[derive(Debug)]
pub(crate) struct DecidedClaim {
    /// The claim.
    pub(crate) claim: Claim,
    /// Whether it is true.
    pub(crate) verdict: Verdict,
    /// The error, if the verdict is not the declared one.
    pub(crate) error: Option<Diagnostic>,
    /// How long it took to find out.
    pub(crate) time: Duration,
}

impl DecidedClaim {
    /// Whether the verdict is the declared one.
    pub(crate) fn as_declared(&self) -> bool {
        state::as_declared(self.claim.expected, &self.verdict)
    }
}

impl Outcome {
    /// How a run that checks only this file ends.
    pub(crate) fn status(&self) -> Status {
        let errors = self.diagnostics.iter().any(|d| d.severity == Severity::Error);
        let mut claims = self.items.iter().flat_map(|item| &item.claims);
        if !self.readable {
            Status::Unusable
        } else if errors || claims.any(|c| !c.as_declared()) {
            Status::Wrong
        } else {
            Status::Fine
        }
    }

    /// Everything that is wrong, claims that are not as declared included.
    pub(crate) fn all_diagnostics(&self) -> Vec<Diagnostic> {
        let claims = self.items.iter().flat_map(|item| &item.claims).filter_map(|c| c.error.clone());
        let all: Diagnostics = self.diagnostics.iter().cloned().chain(claims).collect();
        all.into_list()
    }

    /// The name of the file of a place, if it is another one than the file that was asked for.
    pub(crate) fn foreign(&self, diagnostic: &Diagnostic) -> Option<&str> {
        let (main, _) = self.sources.iter().next()?;
        match diagnostic.labels.first()? {
            (Place::Text(id, _), _) if *id != main => Some(&self.sources.get(*id).name),
            _ => None,
        }
    }

    /// The line of a place, counted from one; `None` where a place is not in a text.
    pub(crate) fn line(&self, place: &Place) -> Option<usize> {
        match place {
            Place::Text(id, range) => Some(self.sources.get(*id).line(range.start)),
            Place::Token(..) => None,
        }
    }
}

/// Checks one file; formulas are kept for [`crate::coq`].
pub(crate) fn file(entry: Entry, formal: Formal) -> Outcome {
    watched(entry, formal, &|| ())
}

/// Checks one file, and says of each claim that it is decided.
pub(crate) fn watched(entry: Entry, formal: Formal, decided: &dyn Fn()) -> Outcome {
    let path = entry.path.display().to_string();
    let source = match entry.problem.map_or_else(|| spec::read(&entry.path), |problem| Err(problem.into())) {
        Ok(source) => source,
        Err(problem) => {
            let (items, doc, sources) = (Vec::new(), Vec::new(), Sources::default());
            return Outcome { path, items, doc, diagnostics: vec![problem], sources, readable: false };
        }
    };
    let library = Library::from_source(&Disk, &Prover, source);
    let run = &mut state::Run::default();
    let (items, warnings) = expanded(&library, run);
    let mut items = decide(items, run, decided);
    if formal == Formal::Kept {
        for item in &mut items {
            match &item.subject {
                Subject::Family(family) => {
                    let claims: Vec<Claim> = item.claims.iter().map(|c| c.claim.clone()).collect();
                    item.formulas = formulas::of(&library, family, &claims);
                }
                Subject::Theorem(theorem) => item.points = formulas::of_theorem(&library, theorem),
            }
        }
    }
    Outcome {
        path,
        items,
        doc: library.doc().to_vec(),
        diagnostics: library.diagnostics().into_iter().chain(warnings).collect(),
        sources: library.sources().clone(),
        readable: true,
    }
}

/// Decides all claims of a file, each in the first round that suffices for it.
fn decide(items: Vec<Item>, run: &mut state::Run, decided: &dyn Fn()) -> Vec<Decided> {
    let claims = items.iter().flat_map(|item| item.claims.iter().map(|claim| (&item.subject, claim)));
    let claims: Vec<_> = claims.collect();
    let mut times = vec![Duration::ZERO; claims.len()];
    let mut verdicts: Vec<Option<Verdict>> = claims.iter().map(|_| None).collect();
    let mut start = Instant::now();
    run.decide_all(&claims, &mut |k, verdict| {
        times[k] += start.elapsed();
        if verdict.is_some() {
            verdicts[k] = verdict;
            decided();
        }
        start = Instant::now();
    });
    let mut verdicts = verdicts.into_iter().zip(times);
    let mut decided = Vec::new();
    for Item { subject, obligations, claims } in items {
        let claims = claims.into_iter().zip(&mut verdicts).filter_map(|(claim, (verdict, time))| {
            let verdict = verdict?;
            let error = state::diagnose(&subject, &claim, &verdict);
            Some(DecidedClaim { claim, verdict, error, time })
        });
        let claims = claims.collect();
        decided.push(Decided { subject, obligations, claims, formulas: None, points: None });
    }
    decided
}
