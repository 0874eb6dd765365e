//! Published statements and their fate, as a table and as JSON.

pub(crate) use basis_engine::published::join;
use basis_engine::published::{self, Decided, Fate, Published};
use serde::Serialize;

use super::prove::Outcome;
use crate::table::{self, BAD, GOOD, Mark, OPEN, Row, STRONG, styled};

/// A published statement in the JSON of the command.
#[derive(Debug, Serialize)]
pub(crate) struct Record {
    id: String,
    statement: String,
    verdict: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    corrected: Option<Corrected>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

/// What is true instead.
#[derive(Debug, Serialize)]
struct Corrected {
    statement: String,
    verdict: &'static str,
}

impl From<Published> for Record {
    fn from(published: Published) -> Self {
        let Published { id, statement, fate, corrected, reason } = published;
        let corrected = corrected.map(|c| Corrected { statement: c.statement, verdict: in_json(c.fate) });
        Self { id, statement, verdict: in_json(fate), corrected, reason }
    }
}

/// The name of a fate in JSON.
const fn in_json(fate: Fate) -> &'static str {
    match fate {
        Fate::NotExpressed => "not_expressed",
        Fate::Proved | Fate::Undecided | Fate::Refuted => fate.word(),
    }
}

/// The statements that a file names, in the order in which it names them first.
pub(crate) fn collect(outcome: &Outcome) -> Vec<Published> {
    let mut all = Vec::new();
    for item in &outcome.items {
        let claims = item.claims.iter().map(|claim| Decided {
            doc: &claim.claim.doc,
            expected: claim.claim.expected,
            verdict: &claim.verdict,
        });
        published::add_subject(&mut all, item.subject.doc(), claims);
    }
    published::add_file(&mut all, &outcome.doc);
    all
}

/// The statements as a table; empty when there are none.
pub(crate) fn text(all: &[Published], width: Option<u16>) -> String {
    if all.is_empty() {
        return String::new();
    }
    let rows: Vec<Row> = all
        .iter()
        .map(|p| {
            let (mark, remark) = outcome(p);
            Row { mark: Some(mark), cells: vec![p.id.clone(), p.fate.word().to_string(), remark] }
        })
        .collect();
    let heading = styled(STRONG, "Published statements");
    let table = table::layout(&["statement", "as published", "corrected"], &rows, &[], width);
    format!("{heading}\n{table}\n")
}

/// The mark of the row, and the correction or the reason why there is no claim.
fn outcome(published: &Published) -> (Mark, String) {
    match (&published.corrected, &published.reason, published.fate) {
        (Some(c), _, _) if c.fate == Fate::Proved => (("✓", GOOD), c.statement.clone()),
        (Some(c), _, _) => (("✗", BAD), format!("{} ({})", c.statement, c.fate.word())),
        (None, Some(reason), _) => (("–", OPEN), reason.clone()),
        (None, None, Fate::Proved) => (("✓", GOOD), String::new()),
        (None, None, Fate::Undecided) => (("?", OPEN), String::new()),
        (None, None, _) => (("✗", BAD), String::from("there is no correction")),
    }
}
