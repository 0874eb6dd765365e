//! Published statements and their fate: which claims belong to which statement of a paper, told by doc comments.
//!
//! A paragraph of a doc comment that begins with an identifier and a colon, `quad-T2: The join is …`, says that a claim, or
//! every claim of a theorem, is part of a published statement. `quad-T2 corrected: …` marks the claims of what is true
//! instead, and `quad-T2 not expressed: …` in the comment of a file says why there are no claims.

use std::collections::BTreeMap;

use basis_engine::Verdict;
use basis_engine::model::Expected;
use serde::Serialize;

use super::prove::{DecidedClaim, Outcome};
use crate::table::{self, BAD, GOOD, Mark, OPEN, Row, STRONG, styled};

/// A published statement.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Published {
    /// Its identifier.
    id: String,
    /// What is published; empty where it is not expressed.
    statement: String,
    /// Whether it is true.
    verdict: Fate,
    /// What is true instead.
    #[serde(skip_serializing_if = "Option::is_none")]
    corrected: Option<Correction>,
    /// Why it is not expressed.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

/// What is true instead.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
struct Correction {
    statement: String,
    verdict: Fate,
}

/// What is known about a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
enum Fate {
    /// All its claims are proved.
    Proved,
    /// It has no claims.
    NotExpressed,
    /// A claim is not decided.
    Undecided,
    /// A claim is refuted.
    Refuted,
}

impl Fate {
    const fn word(self) -> &'static str {
        match self {
            Self::Proved => "proved",
            Self::NotExpressed => "not expressed",
            Self::Undecided => "undecided",
            Self::Refuted => "refuted",
        }
    }

    const fn of(verdict: &Verdict) -> Self {
        match verdict {
            Verdict::Proved(_) => Self::Proved,
            Verdict::Undecided(_) => Self::Undecided,
            Verdict::Refuted(_) => Self::Refuted,
        }
    }
}

/// What a paragraph says about a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    Published,
    Corrected,
    NotExpressed,
}

/// A paragraph that names a statement.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Tag {
    id: String,
    role: Role,
    text: String,
}

/// The statements that files name, in the order in which they name them first.
pub(crate) fn collect(outcome: &Outcome, all: &mut Vec<Published>) {
    let mut places: BTreeMap<String, usize> =
        all.iter().enumerate().map(|(place, p)| (p.id.clone(), place)).collect();
    for item in &outcome.items {
        let inherited = tags(item.subject.doc());
        let mut found: Option<Vec<usize>> = None;
        for claim in &item.claims {
            let own = tags(claim.question.doc());
            // A claim with a comment of its own speaks for itself; another one is part of what the theorem states.
            if own.is_empty() {
                let found = found.get_or_insert_with(|| find(all, &mut places, &inherited));
                inherited.iter().zip(found).for_each(|(tag, place)| add(&mut all[*place], tag, claim));
            } else {
                let found = find(all, &mut places, &own);
                own.iter().zip(found).for_each(|(tag, place)| add(&mut all[place], tag, claim));
            }
        }
    }
    for tag in tags(&outcome.doc) {
        if tag.role == Role::NotExpressed && !places.contains_key(&tag.id) {
            places.insert(tag.id.clone(), all.len());
            let (statement, verdict) = (String::new(), Fate::NotExpressed);
            all.push(Published { id: tag.id, statement, verdict, corrected: None, reason: Some(tag.text) });
        }
    }
}

/// The places of the statements that are named, those that are new at the end.
fn find(all: &mut Vec<Published>, places: &mut BTreeMap<String, usize>, tags: &[Tag]) -> Vec<usize> {
    let mut find = |tag: &Tag| {
        *places.entry(tag.id.clone()).or_insert_with(|| {
            let (id, statement) = (tag.id.clone(), String::new());
            all.push(Published { id, statement, verdict: Fate::Proved, corrected: None, reason: None });
            all.len() - 1
        })
    };
    tags.iter().map(&mut find).collect()
}

fn add(entry: &mut Published, tag: &Tag, claim: &DecidedClaim) {
    let fate = Fate::of(&claim.verdict);
    match tag.role {
        Role::Published => {
            if entry.statement.is_empty() {
                entry.statement.clone_from(&tag.text);
            }
            entry.verdict = entry.verdict.max(fate);
        }
        Role::Corrected => {
            // A correction is proved, not refuted.
            let fate = if claim.question.expected() == Expected::True { fate } else { Fate::Undecided };
            let corrected = entry
                .corrected
                .get_or_insert_with(|| Correction { statement: tag.text.clone(), verdict: Fate::Proved });
            corrected.verdict = corrected.verdict.max(fate);
        }
        Role::NotExpressed => {}
    }
}

/// The paragraphs of a comment that name a statement.
fn tags(doc: &[String]) -> Vec<Tag> {
    doc.split(|line| line.trim().is_empty()).filter_map(|lines| tag(&lines.join(" "))).collect()
}

fn tag(paragraph: &str) -> Option<Tag> {
    let (head, text) = paragraph.trim().split_once(':')?;
    let (id, role) = match head.split_once(' ') {
        None => (head, Role::Published),
        Some((id, "corrected")) => (id, Role::Corrected),
        Some((id, "not expressed")) => (id, Role::NotExpressed),
        Some(_) => return None,
    };
    let is_id = id.contains('-')
        && id.starts_with(|c: char| c.is_ascii_alphabetic())
        && id.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '.');
    is_id.then(|| Tag { id: id.to_string(), role, text: text.trim().to_string() })
}

/// The statements as a table; empty when there are none.
pub(crate) fn text(all: &[Published], width: Option<u16>) -> String {
    if all.is_empty() {
        return String::new();
    }
    let rows: Vec<Row> = all
        .iter()
        .map(|p| {
            let (mark, remark) = p.outcome();
            Row { mark: Some(mark), cells: vec![p.id.clone(), p.verdict.word().to_string(), remark] }
        })
        .collect();
    let heading = styled(STRONG, "Published statements");
    let table = table::layout(&["statement", "as published", "corrected"], &rows, &[], width);
    format!("{heading}\n{table}\n")
}

impl Published {
    /// Its identifier.
    pub(crate) fn id(&self) -> &str {
        &self.id
    }

    /// What is published; empty where it is not expressed.
    pub(crate) fn statement(&self) -> &str {
        &self.statement
    }

    /// What is known about it, in a word.
    pub(crate) fn verdict(&self) -> &'static str {
        self.verdict.word()
    }

    /// What is true instead, or why it is not expressed; empty for a true statement.
    pub(crate) fn remark(&self) -> &str {
        match (&self.corrected, &self.reason) {
            (Some(correction), _) => &correction.statement,
            (None, Some(reason)) => reason,
            (None, None) => "",
        }
    }

    /// The mark of the row, and the correction or the reason why there is no claim.
    fn outcome(&self) -> (Mark, String) {
        match (&self.corrected, &self.reason, self.verdict) {
            (Some(c), _, _) if c.verdict == Fate::Proved => (("✓", GOOD), c.statement.clone()),
            (Some(c), _, _) => (("✗", BAD), format!("{} ({})", c.statement, c.verdict.word())),
            (None, Some(reason), _) => (("–", OPEN), reason.clone()),
            (None, None, Fate::Proved) => (("✓", GOOD), String::new()),
            (None, None, Fate::Undecided) => (("?", OPEN), String::new()),
            (None, None, _) => (("✗", BAD), String::from("there is no correction")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paragraphs_name_statements() {
        let doc: Vec<String> =
            ["quad-T2: It is", "so.", "", "quad-T2 corrected: It is not.", "", "Note: no id."]
                .map(String::from)
                .to_vec();
        let tag = |role, text: &str| Tag { id: String::from("quad-T2"), role, text: text.to_string() };
        assert_eq!(tags(&doc), [tag(Role::Published, "It is so."), tag(Role::Corrected, "It is not.")]);
        assert_eq!(super::tag("a-b not expressed: why").map(|t| t.role), Some(Role::NotExpressed));
        assert_eq!(super::tag("u–v: no"), None);
        assert_eq!(super::tag("quad-T2 (2): no"), None);
    }
}
