//! Decides every claim of a file, with the time that each takes.

use std::rc::Rc;
use std::time::{Duration, Instant};

use basis_engine::diagnostic::Place;
use basis_engine::model::Expected;
use basis_engine::prove::{Statement, check};
use basis_engine::{
    Claim, Diagnostic, Diagnostics, Disk, Family, Library, Selected, Severity, Source, Sources, Theorem,
    TheoremClaim, Verdict, Witness, generate, prove,
};

use super::files::Entry;
use crate::output::Status;
use crate::spec;

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
    /// The claims in the order in which they are written.
    pub(crate) claims: Vec<DecidedClaim>,
}

/// What claims are about.
#[derive(Debug)]
pub(crate) enum Subject {
    /// A family of one order.
    Family(Rc<Family>),
    /// A theorem or a join.
    Theorem(Box<Theorem>),
}

impl Subject {
    /// `family`, `theorem` or `join`.
    pub(crate) const fn kind(&self) -> &'static str {
        match self {
            Self::Family(_) => "family",
            Self::Theorem(theorem) => theorem.kind.keyword(),
        }
    }

    /// The doc comment.
    pub(crate) fn doc(&self) -> &[String] {
        match self {
            Self::Family(family) => &family.doc,
            Self::Theorem(theorem) => &theorem.doc,
        }
    }

    /// The name.
    pub(crate) fn name(&self) -> &str {
        match self {
            Self::Family(family) => &family.name,
            Self::Theorem(theorem) => &theorem.name,
        }
    }

    /// The values of the index parameters; theorems have none.
    pub(crate) fn order(&self) -> &[(String, i64)] {
        match self {
            Self::Family(family) => &family.order,
            Self::Theorem(_) => &[],
        }
    }

    /// What has to be shown for a claim about the subject to be true.
    pub(crate) fn statements(&self, question: &Question) -> Vec<Statement> {
        match (self, question) {
            (Self::Family(family), Question::Family(claim)) => prove::statements(family, claim),
            (Self::Theorem(theorem), Question::Theorem(claim)) => prove::theorem_statements(theorem, claim),
            _ => Vec::new(),
        }
    }

    /// Checks that a claim about the subject fails at a witness as it says.
    ///
    /// # Errors
    /// What is wrong with the witness.
    pub(crate) fn check_witness(&self, question: &Question, witness: &Witness) -> Result<(), String> {
        match (self, question) {
            (Self::Family(family), Question::Family(claim)) => check::witness(family, claim, witness),
            (Self::Theorem(theorem), Question::Theorem(claim)) => {
                check::theorem_witness(theorem, claim, witness)
            }
            _ => Err(String::from("the claim is about something else")),
        }
    }

    /// Whether two subjects are the same family in perhaps different orders.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        self.kind() == other.kind() && self.name() == other.name()
    }
}

/// What is claimed.
#[derive(Debug)]
pub(crate) enum Question {
    /// Of a family.
    Family(Claim),
    /// Of a theorem or a join.
    Theorem(TheoremClaim),
}

impl Question {
    /// The claim as text.
    pub(crate) fn text(&self) -> &str {
        match self {
            Self::Family(claim) => &claim.text,
            Self::Theorem(claim) => &claim.text,
        }
    }

    /// Its doc comment.
    pub(crate) fn doc(&self) -> &[String] {
        match self {
            Self::Family(claim) => &claim.doc,
            Self::Theorem(claim) => &claim.doc,
        }
    }

    /// Whether it is declared true or false.
    pub(crate) const fn expected(&self) -> Expected {
        match self {
            Self::Family(claim) => claim.expected,
            Self::Theorem(claim) => claim.expected,
        }
    }

    /// Where it stands.
    pub(crate) const fn place(&self) -> &Place {
        match self {
            Self::Family(claim) => &claim.place,
            Self::Theorem(claim) => &claim.place,
        }
    }
}

/// A claim with its verdict.
#[derive(Debug)]
pub(crate) struct DecidedClaim {
    /// The claim.
    pub(crate) question: Question,
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
        prove::as_declared(self.question.expected(), &self.verdict)
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

/// Checks one file.
pub(crate) fn file(entry: Entry) -> Outcome {
    let path = entry.path.display().to_string();
    let source = match entry.problem.map_or_else(|| spec::read(&entry.path), Err) {
        Ok(source) => source,
        Err(problem) => {
            let (items, doc, sources) = (Vec::new(), Vec::new(), Sources::default());
            return Outcome { path, items, doc, diagnostics: vec![problem], sources, readable: false };
        }
    };
    decided(path, source)
}

/// Checks a text in memory.
pub(crate) fn text(name: &str, text: &str) -> Outcome {
    decided(name.to_owned(), Source::text(name, text))
}

fn decided(path: String, source: Source) -> Outcome {
    let library = Library::from_source(&Disk, source);
    let run = &mut prove::Run::default();
    let families = library.items(Selected::EveryOrder);
    let warnings = generate::no_floats(families.iter().map(|item| &*item.family));
    let families = families.into_iter().map(|item| {
        let claims = item.claims.into_iter().map(|claim| decide(&item.family, claim, run)).collect();
        Decided { subject: Subject::Family(item.family), claims }
    });
    let mut items: Vec<Decided> = families.collect();
    items.extend(library.theorems().into_iter().map(|theorem| {
        let claims = theorem.claims.iter().map(|claim| decide_theorem(&theorem, claim, run)).collect();
        Decided { subject: Subject::Theorem(Box::new(theorem)), claims }
    }));
    Outcome {
        path,
        items,
        doc: library.doc().to_vec(),
        diagnostics: library.diagnostics().into_iter().chain(warnings).collect(),
        sources: library.sources().clone(),
        readable: true,
    }
}

fn decide(family: &Family, claim: Claim, run: &mut prove::Run) -> DecidedClaim {
    let start = Instant::now();
    let verdict = run.claim(family, &claim);
    let time = start.elapsed();
    let error = prove::diagnose(family, &claim, &verdict);
    DecidedClaim { question: Question::Family(claim), verdict, error, time }
}

fn decide_theorem(theorem: &Theorem, claim: &TheoremClaim, run: &mut prove::Run) -> DecidedClaim {
    let start = Instant::now();
    let verdict = run.theorem_claim(theorem, claim);
    let time = start.elapsed();
    let error = prove::diagnose_theorem(theorem, claim, &verdict);
    DecidedClaim { question: Question::Theorem(claim.clone()), verdict, error, time }
}
