//! The verdicts as JSON.

use basis_engine::algebra::rational;
use basis_engine::state::point_text;
use basis_engine::{Diagnostic, Severity, Verdict, Witness};
use serde::Serialize;
use serde_json::{Map, Value};

use super::prove::{Decided, DecidedClaim, Outcome};
use super::published::Record;
use crate::output::Status;

/// What `basis check --format json` prints.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    /// The files in the order in which they were checked.
    pub(crate) files: Vec<File>,
    /// What became of published statements that comments name.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) published: Vec<Record>,
    /// Whether every file was read and everything in it is as declared.
    pub(crate) ok: bool,
}

/// One file.
#[derive(Debug, Serialize)]
pub(crate) struct File {
    path: String,
    items: Vec<Item>,
    diagnostics: Vec<Message>,
    #[serde(skip)]
    status: Status,
}

/// A family of one order, a theorem or a join.
#[derive(Debug, Serialize)]
struct Item {
    kind: &'static str,
    name: String,
    /// The values of the index parameters; `null` without any.
    order: Option<Map<String, Value>>,
    claims: Vec<Claim>,
}

#[derive(Debug, Serialize)]
struct Claim {
    #[serde(rename = "claim")]
    text: String,
    /// Counted from one.
    line: Option<usize>,
    declared: &'static str,
    verdict: &'static str,
    /// How it was proved; `null` unless it was.
    method: Option<String>,
    /// Where it fails; `null` unless it does.
    witness: Option<Counterexample>,
    micros: u64,
}

#[derive(Debug, Serialize)]
struct Counterexample {
    at: Map<String, Value>,
    value: String,
    of: String,
}

#[derive(Debug, Serialize)]
struct Message {
    severity: &'static str,
    #[serde(rename = "message")]
    text: String,
    line: Option<usize>,
    column: Option<usize>,
    /// The file of line and column, if it is one that the checked file uses.
    #[serde(skip_serializing_if = "Option::is_none")]
    path: Option<String>,
}

impl Report {
    /// The report on several files.
    pub(crate) fn new(files: Vec<File>, published: Vec<Record>) -> Self {
        let ok = files.iter().all(|file| file.status == Status::Fine);
        Self { files, published, ok }
    }
}

impl File {
    /// The report on one file.
    pub(crate) fn new(outcome: &Outcome) -> Self {
        Self {
            path: outcome.path.clone(),
            items: outcome.items.iter().map(|decided| item(outcome, decided)).collect(),
            diagnostics: outcome.all_diagnostics().iter().map(|d| message(outcome, d)).collect(),
            status: outcome.status(),
        }
    }
}

fn item(outcome: &Outcome, decided: &Decided) -> Item {
    let order = decided.subject.order();
    Item {
        kind: decided.subject.kind(),
        name: decided.subject.name().to_string(),
        order: (!order.is_empty()).then(|| order.iter().map(|(n, v)| (n.clone(), Value::from(*v))).collect()),
        claims: decided.claims.iter().map(|c| claim(outcome, c)).collect(),
    }
}

fn claim(outcome: &Outcome, decided: &DecidedClaim) -> Claim {
    let (verdict, method, witness) = match &decided.verdict {
        Verdict::Proved(evidence) => ("proved", Some(evidence.method().to_string()), None),
        Verdict::Refuted(witness) => {
            ("refuted", Some(String::from("counterexample")), Some(counterexample(witness)))
        }
        Verdict::Undecided(_) => ("undecided", None, None),
    };
    Claim {
        text: decided.claim.text.clone(),
        line: outcome.line(&decided.claim.place),
        declared: decided.claim.expected.keyword(),
        verdict,
        method,
        witness,
        micros: decided.time.as_micros() as u64,
    }
}

fn counterexample(witness: &Witness) -> Counterexample {
    // A variable that has a rational value itself is not named by its tangent, which then is a number next to another one.
    let own = |name: &String| {
        let (_, place) = witness.places.iter().find(|(own, _)| own == name)?;
        let (variable, value) = place.split_once(" = ")?;
        rational::parse(value).map(|_| (String::from(variable), Value::from(value)))
    };
    let at = witness.at.iter().map(|(name, coordinate)| {
        own(name).unwrap_or_else(|| (name.clone(), Value::from(coordinate.value(name))))
    });
    let net = witness.net.iter().map(|(name, place)| (name.clone(), Value::from(point_text(place))));
    let value = witness.value_text();
    Counterexample {
        at: at.chain(net).collect(),
        value: value.strip_prefix("about ").map_or(value.clone(), String::from),
        of: witness.of.clone(),
    }
}

fn message(outcome: &Outcome, diagnostic: &Diagnostic) -> Message {
    let place = diagnostic.line_column(&outcome.sources);
    Message {
        severity: match diagnostic.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        },
        text: diagnostic.text(),
        line: place.map(|p| p.0),
        column: place.map(|p| p.1),
        path: outcome.foreign(diagnostic).map(String::from),
    }
}
