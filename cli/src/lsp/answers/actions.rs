//! What the editor offers to do: insert the claims that hold, and correct the ones that do not.

use std::collections::HashMap;

use basis_engine::claim::Expected;
use basis_engine::query::{SymbolKind, claims_that_hold, independent_claim};
use basis_engine::{Claim, ClaimKind, Family, Subject, Verdict, explain};
use core::ops::Range;
use lsp_types::{CodeAction, CodeActionKind, TextEdit, Uri, WorkspaceEdit};
use serde_json::{Value, json};

use crate::lsp::workspace::{Text, Workspace};
use basis_engine::query::{Analysis, Statement};

/// The actions for a range of a text. What takes long is worked out when one of them is chosen, if the editor can ask.
pub(in crate::lsp) fn actions(
    workspace: &Workspace,
    text: &Text,
    analysis: &Analysis,
    range: lsp_types::Range,
) -> Vec<CodeAction> {
    let range = text.bytes(range);
    let mut all = Vec::new();
    for statement in analysis.statements() {
        if statement.complete && statement.place.start <= range.end && range.start <= statement.place.end {
            corrections(text, analysis, &statement, &mut all);
        }
    }
    if let Some(entry) = text.document.entry(range.start)
        && analysis.family(&entry.title).is_some()
    {
        let mut action = CodeAction {
            title: format!("Insert the claims that hold of {}", entry.title),
            kind: Some(CodeActionKind::SOURCE),
            data: Some(json!({ "uri": text.uri.as_str(), "family": entry.title })),
            ..CodeAction::default()
        };
        if !workspace.resolves {
            action.edit = insert(workspace, text, &entry.title);
        }
        if workspace.resolves || action.edit.is_some() {
            all.push(action);
        }
    }
    all
}

/// The action with its edit.
pub(in crate::lsp) fn resolve(workspace: &Workspace, mut action: Value) -> Value {
    let word = |name: &str| action.get("data").and_then(|d| d.get(name)).and_then(Value::as_str);
    let edit = match (word("uri"), word("family")) {
        (Some(uri), Some(family)) => workspace.text(uri).and_then(|text| insert(workspace, text, family)),
        _ => None,
    };
    if let Value::Object(fields) = &mut action
        && fields.get("edit").is_none_or(Value::is_null)
    {
        // An editor that finds no edit in an action reports an error; an empty one changes nothing.
        fields.insert(String::from("edit"), json!(edit.unwrap_or_default()));
    }
    action
}

/// The claims that hold of a family and that it does not make, behind its other statements.
fn insert(workspace: &Workspace, text: &Text, family: &str) -> Option<WorkspaceEdit> {
    let claims = claims_that_hold(&workspace.files, &text.source(), family);
    let entry = text.document.entries.iter().find(|e| e.title == family)?;
    let body = entry.body.clone()?;
    if claims.is_empty() {
        return None;
    }
    let mut new = String::new();
    for claim in &claims {
        for line in claim.statement.lines() {
            new += &format!("\n    {line}");
        }
    }
    let inside = text.document.slice(&body);
    let end = body.start + inside.trim_end().len();
    let before = if entry.children.is_empty() { "" } else { "\n" };
    let new_text = format!("{before}{new}\n");
    // A comment in the last line stays before what is inserted.
    Some(edits(text, vec![(end..body.end, new_text)]))
}

#[allow(clippy::mutable_key_type)] // addresses are keys in the protocol's own type, and nothing changes them
fn edits(text: &Text, edits: Vec<(Range<usize>, String)>) -> WorkspaceEdit {
    let edits = edits.into_iter().map(|(range, new_text)| TextEdit { range: text.span(&range), new_text });
    let mut changes: HashMap<Uri, Vec<TextEdit>> = HashMap::new();
    changes.insert(text.uri.clone(), edits.collect());
    WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }
}

/// What could be written in place of a claim that is not as declared.
fn corrections(text: &Text, analysis: &Analysis, statement: &Statement<'_>, all: &mut Vec<CodeAction>) {
    let Some((subject, claim, _)) = statement.decided.first() else { return };
    let every = |is: fn(&Verdict) -> bool| statement.decided.iter().all(|(_, _, v)| is(v));
    let refuted = every(|v| matches!(v, Verdict::Refuted(_)));
    let proved = every(|v| matches!(v, Verdict::Proved(_)));
    let mut offer = |title: String, changes: Vec<(Range<usize>, String)>, preferred: bool| {
        all.push(CodeAction {
            title,
            kind: Some(CodeActionKind::QUICKFIX),
            edit: Some(edits(text, changes)),
            is_preferred: Some(preferred),
            ..CodeAction::default()
        });
    };
    if claim.expected == Expected::True
        && statement.decided.iter().any(|(_, _, v)| matches!(v, Verdict::Refuted(_)))
    {
        let family = match subject {
            Subject::Family(family) if family.order.is_empty() => analysis.family(&family.name),
            _ => None,
        };
        if let Some((family, _)) = family.zip(text.document.entry(statement.place.start)) {
            for (title, changes) in of_family(text, family, claim, &statement.place) {
                offer(title, changes, true);
            }
        }
    }
    let word = match claim.expected {
        Expected::True if refuted => "refute",
        Expected::False if proved => "prove",
        _ => return,
    };
    // The keyword of an equation in a block is that of all its equations.
    let old = claim.expected.keyword();
    if text.document.slice(&statement.place).starts_with(old) {
        let keyword = statement.place.start..statement.place.start + old.len();
        offer(format!("Write `{word}`"), vec![(keyword, word.to_string())], false);
    }
}

type Offer = (String, Vec<(Range<usize>, String)>);

/// A range on which a family is nonnegative, or the exceptions to its independence.
fn of_family(text: &Text, family: &Family, claim: &Claim, place: &Range<usize>) -> Vec<Offer> {
    match &claim.kind {
        ClaimKind::Nonnegative => {
            let ranges = explain::nonnegative_ranges(family).into_iter();
            let offers = ranges.filter_map(|range| {
                let declared = declaration(text, family, &range.name)?;
                // One range with rational ends can stand in a spec.
                let [only] = &range.ranges[..] else { return None };
                let plain = !only.contains('(') && only.contains("<=") && range.remark.is_some();
                plain.then(|| (format!("Narrow the range to `{only}`"), vec![(declared, only.clone())]))
            });
            offers.collect()
        }
        ClaimKind::Independent(_) => {
            let Some(right) = independent_claim(family, &explain::exceptional_set(family)) else {
                return Vec::new();
            };
            let written = text.document.slice(place);
            let end = if written.ends_with(';') { place.end - 1 } else { place.end };
            let start = place.start + claim.expected.keyword().len();
            vec![(format!("Write `{right}`"), vec![(start..end, format!(" {right}"))])]
        }
        _ => Vec::new(),
    }
}

/// The part of a `shape` statement that declares a parameter.
fn declaration(text: &Text, family: &Family, name: &str) -> Option<Range<usize>> {
    let document = &text.document;
    let item = document.item(&family.name)?;
    let scope = document.symbols[item].whole.clone();
    let symbol = document.symbols.iter().find(|s| {
        s.kind == SymbolKind::Shape
            && s.name == name
            && scope.start <= s.place.start
            && s.place.end <= scope.end
    })?;
    let whole = &symbol.whole;
    let (mut start, mut end) = (whole.start, whole.end);
    let mut depth = 0;
    for token in document.tokens.iter().filter(|t| whole.start <= t.range.start && t.range.end <= whole.end) {
        let word = token.text(&document.text);
        depth += i32::from(matches!(word, "(" | "[")) - i32::from(matches!(word, ")" | "]"));
        if !(matches!(word, "shape" | ";") || word == "," && depth == 0) {
            continue;
        }
        if token.range.end <= symbol.place.start {
            start = token.range.end;
        } else if token.range.start >= symbol.place.end {
            end = token.range.start;
            break;
        }
    }
    let written = &document.text[start..end];
    let from = start + written.len() - written.trim_start().len();
    Some(from..from + written.trim().len())
}
