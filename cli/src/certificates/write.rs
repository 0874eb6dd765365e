//! From verdicts to files.

use std::fs;
use std::path::{Component, Path, PathBuf};

use basis_engine::algebra::rational::Rational;
use basis_engine::model::obligation::{Ground, Obligation};
use basis_engine::source::LIBRARY;
use basis_engine::{Diagnostic, Subject, Verdict};
use basis_kernel::{Certificate, Proof, text};
use serde_json::{Map, Value};

use super::head::{FORMAT, SIGNS, claim as head, subject};
use crate::check::prove::{Decided, DecidedClaim, Outcome};
use crate::output::error;

/// Writes the certificates of one file; what stands in the way.
pub(crate) fn write(folder: &Path, outcome: &Outcome) -> Vec<Diagnostic> {
    let mut problems = Vec::new();
    for decided in &outcome.items {
        let path = folder.join(place(&outcome.path, &decided.subject));
        let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
        let written = folder.and_then(|()| fs::write(&path, item(outcome, decided)));
        if let Err(e) = written {
            problems.push(error(format!("cannot write the certificate `{}`: {e}", path.display())));
        }
    }
    problems
}

/// `specs/quartic.basis`, `Bernstein(3)` → `specs/quartic/Bernstein-3.json`, `library:quartic` → `library/quartic/…`;
/// always inside of the folder.
fn place(spec: &str, subject: &Subject) -> PathBuf {
    let mut place = PathBuf::new();
    let spec = spec.strip_prefix(LIBRARY).map_or_else(|| spec.to_string(), |name| format!("library/{name}"));
    for part in Path::new(&spec).with_extension("").components() {
        match part {
            Component::Normal(name) => place.push(name),
            Component::ParentDir => place.push("up"),
            Component::Prefix(_) | Component::RootDir | Component::CurDir => {}
        }
    }
    let order = subject.order().iter().map(|(_, value)| format!("-{value}"));
    place.join(format!("{}{}.json", subject.name(), order.collect::<String>()))
}

/// The certificate of a family of one order, a theorem or a join: a line for each claim.
pub(super) fn item(outcome: &Outcome, decided: &Decided) -> String {
    let mut lines =
        vec![field("format", &Value::from(FORMAT)), field("spec", &Value::from(outcome.path.as_str()))];
    lines.extend(subject(&decided.subject).iter().map(|(key, value)| field(key, value)));
    lines.push(each("obligations", decided.obligations.iter().map(obligation)));
    lines.push(each("claims", decided.claims.iter().map(|c| claim(outcome, c))));
    format!("{{\n{}\n}}\n", lines.join(",\n"))
}

fn field(key: &str, value: &Value) -> String {
    format!("  {}: {value}", Value::from(key))
}

/// A list with a line for each element.
fn each(key: &str, values: impl Iterator<Item = Value>) -> String {
    let lines: Vec<String> = values.map(|value| format!("    {value}")).collect();
    let list = if lines.is_empty() { String::from("[]") } else { format!("[\n{}\n  ]", lines.join(",\n")) };
    format!("  {}: {list}", Value::from(key))
}

/// A proof as text, unless it only computes.
fn proof(proof: &Proof) -> Option<Value> {
    match proof.certificate() {
        Certificate::Direct => None,
        certificate => Some(Value::from(text::certificate_text(certificate))),
    }
}

/// Those of some proofs that do not only compute, by their places; nothing if there are none.
fn proofs<'p>(all: impl Iterator<Item = &'p Proof>) -> Option<(String, Value)> {
    let written: Map<String, Value> =
        all.enumerate().filter_map(|(k, step)| Some((k.to_string(), proof(step)?))).collect();
    (!written.is_empty()).then(|| (String::from("proofs"), Value::Object(written)))
}

fn obligation(obligation: &Obligation) -> Value {
    let mut fields = Map::new();
    fields.insert(String::from("of"), Value::from(obligation.of.clone()));
    let Some(ground) = &obligation.ground else { return Value::Object(fields) };
    if let Some(sign) = SIGNS[ground.alternative()] {
        fields.insert(String::from(sign), Value::from(true));
    }
    match ground {
        Ground::Alone { proof: known, .. } => {
            fields.extend(proof(known).map(|text| (String::from("proof"), text)));
        }
        Ground::Derived { way, proofs: all, .. } => {
            fields.insert(String::from("way"), Value::from(*way));
            fields.insert(String::from("steps"), Value::from(all.len()));
            fields.extend(proofs(all.iter()));
        }
    }
    Value::Object(fields)
}

fn claim(outcome: &Outcome, decided: &DecidedClaim) -> Value {
    let mut fields = head(&decided.claim, outcome.line(&decided.claim.place));
    let mut put = |key: &str, value: Value| fields.insert(String::from(key), value);
    match &decided.verdict {
        Verdict::Proved(evidence) => {
            put("steps", Value::from(evidence.steps().len()));
            if evidence.ways().iter().any(|way| *way > 0) {
                put("ways", Value::from(evidence.ways()));
            }
            fields.extend(proofs(evidence.steps().iter().map(|(_, step)| step)));
        }
        Verdict::Refuted(witness) => {
            put("of", Value::from(witness.of_statement()));
            put("witness", Value::from(text::witness_text(witness.refutation().witness())));
            if let Some(value) = witness.refutation().value() {
                put("value", Value::from(value.to_string()));
            }
            if let Some(text) = witness.everywhere().and_then(proof) {
                put("proof", text);
            }
            if !witness.given.is_empty() {
                let place = |place: &Vec<Rational>| {
                    Value::from(place.iter().map(Rational::to_string).collect::<Vec<_>>())
                };
                put("given", Value::from(witness.given.iter().map(place).collect::<Vec<_>>()));
            }
        }
        Verdict::Undecided(left) => {
            put("left", Value::from(left.clone()));
        }
    }
    Value::Object(fields)
}
