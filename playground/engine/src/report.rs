//! What is known of the open spec: its families and theorems, verdicts at statements, messages with places.

use basis_engine::algebra::rational::ToFloat as _;
use basis_engine::diagnostic::Place;
use basis_engine::query::{self, Analysis, Statement};
use basis_engine::state::as_declared;
use basis_engine::{Claim, ClaimKind, Coordinate, Severity, Subject, Verdict, Witness};
use serde_json::{Value, json};

use crate::drawing;
use crate::places::Places;

/// The most statements that are listed, and of each the most claims.
const MAX_STATEMENTS: usize = 2000;
const MAX_CLAIMS: usize = 6;

/// The families, theorems and joins, and how many claims they make.
pub(crate) fn items(analysis: &Analysis) -> Value {
    let item = |item: &basis_engine::query::Analysed| {
        let subject = &item.subject;
        let own = match subject {
            Subject::Family(family) => Some(family.source) == analysis.main(),
            Subject::Theorem(_) => true,
        };
        json!({
            "kind": subject.kind(),
            "name": subject.name(),
            "title": subject.title(),
            "doc": subject.doc(),
            "own": own
        })
    };
    let claims: usize = analysis.items.iter().map(|item| item.claims.len()).sum();
    json!({ "items": analysis.items.iter().map(item).collect::<Vec<_>>(), "claims": claims })
}

/// The statements that make claims, and the messages.
pub(crate) fn verdicts(analysis: &Analysis, places: &Places) -> Value {
    let all = analysis.statements();
    let statements: Vec<Value> =
        all.iter().take(MAX_STATEMENTS).map(|s| statement(analysis, s, places)).collect();
    json!({
        "done": analysis.is_done(),
        "statements": statements,
        "unlisted": all.len().saturating_sub(MAX_STATEMENTS),
        "messages": messages(analysis, places)
    })
}

fn messages(analysis: &Analysis, places: &Places) -> Vec<Value> {
    let message = |message: basis_engine::Diagnostic| {
        let mut words = message.text();
        let mut place = (0, 0);
        match message.labels.first() {
            Some((Place::Text(id, range), _)) if Some(*id) == analysis.main() => {
                place = (places.at(range.start), places.at(range.end));
            }
            Some((Place::Text(id, range), _)) => {
                let source = analysis.sources.get(*id);
                words = format!("{}, line {}: {words}", source.name, source.line(range.start));
            }
            _ => {}
        }
        let severity = if message.severity == Severity::Error { "error" } else { "warning" };
        json!({ "from": place.0, "to": place.1, "severity": severity, "message": words })
    };
    analysis.messages().into_iter().map(message).collect()
}

fn word(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Proved(_) => "proved",
        Verdict::Refuted(_) => "refuted",
        Verdict::Undecided(_) => "undecided",
    }
}

fn statement(analysis: &Analysis, statement: &Statement<'_>, places: &Places) -> Value {
    let count = |name: &str| statement.decided.iter().filter(|(_, _, v)| word(v) == name).count();
    let unexpected = statement.decided.iter().filter(|(_, claim, v)| !as_declared(claim.expected, v)).count();
    // What is not as declared first, then what is false, then the rest.
    let rank = |(_, claim, verdict): &(&Subject, &Claim, &Verdict)| match word(verdict) {
        _ if !as_declared(claim.expected, verdict) => 0,
        "proved" => 2,
        _ => 1,
    };
    let shown = (0..3).flat_map(|k| statement.decided.iter().filter(move |one| rank(one) == k));
    let claims: Vec<Value> = shown.take(MAX_CLAIMS).map(|one| claim(analysis, one)).collect();
    let first = statement.decided.first();
    json!({
        "from": places.at(statement.place.start),
        "to": places.at(statement.place.end),
        "about": first.map(|(subject, ..)| format!("{} {}", subject.kind(), subject.name())),
        "text": first.map(|(_, claim, _)| format!("{} {}", claim.statement.text, claim.statement.range).trim_end().to_string()),
        "at": first.and_then(|(_, claim, _)| match &claim.kind {
            ClaimKind::Relation { at, .. } => at.as_deref(),
            _ => None,
        }),
        "declared": first.map(|(_, claim, _)| claim.expected.keyword()),
        "proved": count("proved"),
        "refuted": count("refuted"),
        "undecided": count("undecided"),
        "unexpected": unexpected,
        "complete": statement.complete,
        "claims": claims
    })
}

/// A decided claim.
fn claim(analysis: &Analysis, (subject, claim, verdict): &(&Subject, &Claim, &Verdict)) -> Value {
    let item = analysis.items.iter().position(|item| core::ptr::eq(&raw const item.subject, *subject));
    let reason = match verdict {
        Verdict::Proved(evidence) => String::from(evidence.method()),
        Verdict::Refuted(witness) => witness.notes.join("; "),
        Verdict::Undecided(left) => left.clone(),
    };
    let witness = match (verdict, subject) {
        (Verdict::Refuted(witness), Subject::Family(family)) => {
            let function = query::function_of(family, &witness.of);
            Some(json!({ "at": numbers(witness), "function": function, "point": witness.point() }))
        }
        (Verdict::Refuted(witness), Subject::Theorem(_)) => Some(json!({ "point": witness.point() })),
        _ => None,
    };
    json!({
        "item": item,
        "title": subject.title(),
        "text": claim.text,
        "verdict": word(verdict),
        "reason": reason,
        "witness": witness
    })
}

/// The coordinates of a counterexample that matter, by name.
fn numbers(witness: &Witness) -> Value {
    let number = |c: &Coordinate| match c {
        Coordinate::Rational(x) => x.to_f64(),
        Coordinate::Algebraic(x) => drawing::middle(x.low(), x.high()),
    };
    let shown = witness.at.iter().filter(|(name, _)| !witness.idle.contains(name));
    shown.map(|(name, c)| (name.clone(), json!(number(c)))).collect::<serde_json::Map<_, _>>().into()
}
