//! Published statements and what became of them: which claims belong to which statement of a paper, told by doc
//! comments.
//!
//! A paragraph of a doc comment that begins with an identifier and a colon, `quad-T2: The join is …`, says that a
//! claim, or every claim of a theorem, is part of a published statement. `quad-T2 corrected: …` marks the claims of
//! what is true instead, and `quad-T2 not expressed: …` in the comment of a file says why there are no claims.

use crate::claim::Expected;
use crate::model::{Library, Selected};
use crate::state::Verdict;
use crate::theorem::theorems;

/// A published statement.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Published {
    /// Its identifier.
    pub id: String,
    /// What is published; empty where it is not expressed.
    pub statement: String,
    /// Whether it is true.
    pub fate: Fate,
    /// What is true instead.
    pub corrected: Option<Correction>,
    /// Why it is not expressed.
    pub reason: Option<String>,
}

/// What is true instead.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Correction {
    /// The corrected statement.
    pub statement: String,
    /// Whether it is true.
    pub fate: Fate,
}

/// The verdict on a published statement: of those on its claims the last in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fate {
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
    /// The fate in a word or two.
    pub const fn word(self) -> &'static str {
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

impl Published {
    /// What is true instead, or why it is not expressed; empty for a true statement.
    pub fn remark(&self) -> &str {
        match (&self.corrected, &self.reason) {
            (Some(correction), _) => &correction.statement,
            (None, Some(reason)) => reason,
            (None, None) => "",
        }
    }
}

/// A decided claim, as far as statements are concerned.
#[derive(Clone, Copy, Debug)]
pub struct Decided<'a> {
    /// The doc comment of the claim.
    pub doc: &'a [String],
    /// Whether it is declared true or false.
    pub expected: Expected,
    /// Whether it is true.
    pub verdict: &'a Verdict,
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

/// The statements that a spec names, in the order in which it names them first, with all its claims decided.
pub fn statements(library: &Library<'_>) -> Vec<Published> {
    let mut all = Vec::new();
    for item in library.items(Selected::EveryOrder).into_iter().chain(theorems(library)) {
        let checked = crate::decide(item);
        let claims = checked.claims.iter();
        let decided =
            claims.map(|(claim, verdict)| Decided { doc: &claim.doc, expected: claim.expected, verdict });
        add_subject(&mut all, checked.subject.doc(), decided);
    }
    add_file(&mut all, library.doc());
    all
}

/// Adds the statements that the comments of a family or a theorem, and of its claims, name.
pub fn add_subject<'a>(
    all: &mut Vec<Published>,
    doc: &[String],
    claims: impl IntoIterator<Item = Decided<'a>>,
) {
    let inherited = tags(doc);
    for claim in claims {
        let own = tags(claim.doc);
        // A claim with a comment of its own speaks for itself; another one is part of what the theorem states.
        let tags = if own.is_empty() { &inherited } else { &own };
        for tag in tags {
            add(all, tag, claim);
        }
    }
}

/// Adds the statements that the comment of a file says are not expressed.
pub fn add_file(all: &mut Vec<Published>, doc: &[String]) {
    for tag in tags(doc) {
        if tag.role == Role::NotExpressed && all.iter().all(|p| p.id != tag.id) {
            let (statement, fate) = (String::new(), Fate::NotExpressed);
            all.push(Published { id: tag.id, statement, fate, corrected: None, reason: Some(tag.text) });
        }
    }
}

/// Adds the statements that another file names to those of the files before it.
pub fn join(all: &mut Vec<Published>, more: Vec<Published>) {
    for new in more {
        let Some(known) = all.iter_mut().find(|p| p.id == new.id) else {
            all.push(new);
            continue;
        };
        // That a file does not express it says nothing where another one does.
        if new.fate == Fate::NotExpressed {
            continue;
        }
        if known.statement.is_empty() {
            known.statement = new.statement;
        }
        known.fate = known.fate.max(new.fate);
        if let Some(correction) = new.corrected {
            match &mut known.corrected {
                Some(known) => known.fate = known.fate.max(correction.fate),
                none => *none = Some(correction),
            }
        }
    }
}

fn add(all: &mut Vec<Published>, tag: &Tag, claim: Decided<'_>) {
    let at = all.iter().position(|p| p.id == tag.id).unwrap_or_else(|| {
        let (id, statement) = (tag.id.clone(), String::new());
        all.push(Published { id, statement, fate: Fate::Proved, corrected: None, reason: None });
        all.len() - 1
    });
    let entry = &mut all[at];
    let fate = Fate::of(claim.verdict);
    match tag.role {
        Role::Published => {
            if entry.statement.is_empty() {
                entry.statement.clone_from(&tag.text);
            }
            entry.fate = entry.fate.max(fate);
        }
        Role::Corrected => {
            // A correction is proved, not refuted.
            let fate = if claim.expected == Expected::True { fate } else { Fate::Undecided };
            let corrected = entry
                .corrected
                .get_or_insert_with(|| Correction { statement: tag.text.clone(), fate: Fate::Proved });
            corrected.fate = corrected.fate.max(fate);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Disk, Source};

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

    #[test]
    fn one_false_claim_refutes_a_statement() {
        let spec = "//! x-3 not expressed: A picture.\n\
            family Line { domain 0 <= t <= 1; b[0] = 1 - t; b[1] = t;\n\
            /// x-1: Both are at least -1.\n prove b[0] >= -1;\n\
            /// x-2: They sum to 1, and to 2.\n prove partition_of_unity;\n\
            /// x-2: They sum to 1, and to 2.\n refute sum(b) = 2;\n\
            /// x-2 corrected: They sum to 1.\n prove sum(b) = 1; }";
        let library = Library::from_source(&Disk, &crate::Prover, Source::text("x.basis", spec));
        let all = statements(&library);
        assert!(library.diagnostics().is_empty(), "{:?}", library.diagnostics());
        let brief: Vec<(&str, Fate, &str)> =
            all.iter().map(|p| (p.id.as_str(), p.fate, p.remark())).collect();
        let expected = [
            ("x-1", Fate::Proved, ""),
            ("x-2", Fate::Refuted, "They sum to 1."),
            ("x-3", Fate::NotExpressed, "A picture."),
        ];
        assert_eq!(brief, expected);
        assert_eq!(all[1].corrected.as_ref().map(|c| c.fate), Some(Fate::Proved));
    }
}
