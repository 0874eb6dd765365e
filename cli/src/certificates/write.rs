//! From verdicts to files.

use std::fs;
use std::path::{Component, Path, PathBuf};

use basis_engine::prove::point_text;
use basis_engine::source::LIBRARY;
use basis_engine::{Diagnostic, Verdict};
use serde_json::{Map, Value, json};

use super::{FORMAT, coordinate_text, proofs, statements};
use crate::check::prove::{Decided, DecidedClaim, Outcome, Question, Subject};
use crate::output::error;

/// Writes the certificates of one file; what stands in the way.
pub(crate) fn write(folder: &Path, outcome: &Outcome) -> Vec<Diagnostic> {
    let mut problems = Vec::new();
    for decided in &outcome.items {
        let path = folder.join(place(&outcome.path, &decided.subject));
        let written = item(outcome, decided).and_then(|value| {
            let text = serde_json::to_string_pretty(&value).map_err(|e| e.to_string())?;
            if let Some(parent) = path.parent() {
                fs::create_dir_all(parent).map_err(|e| e.to_string())?;
            }
            fs::write(&path, text + "\n").map_err(|e| e.to_string())
        });
        if let Err(e) = written {
            problems.push(error(format!("cannot write the certificate `{}`: {e}", path.display())));
        }
    }
    problems
}

/// `Bernstein(3)`, `join G1`.
pub(super) fn title(subject: &Subject) -> String {
    match subject {
        Subject::Family(family) => family.title(),
        Subject::Theorem(theorem) => theorem.title(),
    }
}

/// `specs/quartic.basis`, `Bernstein(3)` → `specs/quartic/Bernstein-3.json`, `library:quartic` → `library/quartic/…`; always
/// inside of the folder.
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

/// The certificate of a family of one order, a theorem or a join.
///
/// # Errors
/// A proof that does not check; that would be a mistake in the search.
pub(crate) fn item(outcome: &Outcome, decided: &Decided) -> Result<Value, String> {
    let claims = decided.claims.iter().map(|c| claim(outcome, &decided.subject, c));
    let claims = claims.collect::<Result<Vec<Value>, String>>()?;
    let mut fields = Map::new();
    fields.insert(String::from("format"), Value::from(FORMAT));
    fields.insert(String::from("spec"), Value::from(outcome.path.clone()));
    fields.extend(statements::subject(&decided.subject));
    fields.insert(String::from("claims"), Value::from(claims));
    Ok(Value::Object(fields))
}

fn claim(outcome: &Outcome, subject: &Subject, decided: &DecidedClaim) -> Result<Value, String> {
    let mut fields = head(&decided.question, outcome.line(decided.question.place()));
    let mut put = |key: &str, value: Value| fields.insert(String::from(key), value);
    match &decided.verdict {
        Verdict::Proved(evidence) => {
            put("verdict", Value::from("proved"));
            let names = statements::names(subject);
            let all = subject.statements(&decided.question);
            let steps = all.iter().zip(&evidence.steps).map(|(statement, step)| {
                let mut fields = statements::statement(&names, statement);
                let proof = proofs::proof(statement, &step.proof, &names);
                let proof =
                    proof.map_err(|e| format!("the proof of `{}` is wrong: {e}", decided.question.text()))?;
                fields.insert(String::from("proof"), proof);
                Ok(Value::Object(fields))
            });
            put("steps", Value::from(steps.collect::<Result<Vec<_>, String>>()?));
        }
        Verdict::Refuted(witness) => {
            put("verdict", Value::from("refuted"));
            let at: Map<String, Value> =
                witness.at.iter().map(|(n, c)| (n.clone(), Value::from(coordinate_text(c, n)))).collect();
            let net: Map<String, Value> =
                witness.net.iter().map(|(n, place)| (n.clone(), Value::from(point_text(place)))).collect();
            put(
                "witness",
                json!({"of": witness.of, "at": at, "net": net, "value": witness.value.to_string()}),
            );
        }
        Verdict::Undecided(left) => {
            put("verdict", Value::from("undecided"));
            put("left", Value::from(left.clone()));
        }
    }
    Ok(Value::Object(fields))
}

/// What a claim says.
pub(super) fn head(question: &Question, line: Option<usize>) -> Map<String, Value> {
    Map::from_iter([
        (String::from("claim"), Value::from(question.text())),
        (String::from("line"), Value::from(line)),
        (String::from("declared"), Value::from(question.expected().keyword())),
    ])
}
