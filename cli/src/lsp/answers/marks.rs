//! What the editor shows beside a text by itself: errors, and a mark with its reason at every claim.

use basis_engine::diagnostic::Place;
use basis_engine::{Severity, Verdict};
use lsp_types::{
    Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, InlayHint, InlayHintLabel,
    InlayHintTooltip, Location, MarkupContent, MarkupKind, Range, Uri,
};

use crate::check::orders;
use crate::lsp::files;
use crate::lsp::workspace::Text;
use basis_engine::query::{Analysis, Statement};

/// The most characters of a counterexample that stand in the text itself.
const MAX_LENGTH: usize = 70;

/// The messages about a text.
pub(in crate::lsp) fn diagnostics(text: &Text, analysis: &Analysis) -> Vec<Diagnostic> {
    let main = analysis.main();
    let mut all = Vec::new();
    for message in analysis.messages() {
        let own = |place: &Place| match place {
            Place::Text(id, range) if Some(*id) == main => Some(text.span(range)),
            _ => None,
        };
        let mut related = Vec::new();
        for (place, label) in message.labels.iter().skip(1) {
            if let Some(location) = location(text, analysis, place) {
                related.push(DiagnosticRelatedInformation { location, message: label.clone() });
            }
        }
        let mut words = message.text();
        let range = match message.labels.first() {
            None => Range::default(),
            Some((place, _)) => own(place).unwrap_or_else(|| {
                // What is wrong in another file stands at the line that uses it.
                if let Place::Text(id, range) = place {
                    let source = analysis.sources.get(*id);
                    words = format!("{}, line {}: {words}", source.name, source.line(range.start));
                }
                text.document.imports.first().map_or_else(Range::default, |import| text.span(&import.place))
            }),
        };
        let severity = match message.severity {
            Severity::Error => DiagnosticSeverity::ERROR,
            Severity::Warning => DiagnosticSeverity::WARNING,
        };
        all.push(Diagnostic {
            range,
            severity: Some(severity),
            source: Some(String::from("basis")),
            message: words,
            related_information: (!related.is_empty()).then_some(related),
            ..Diagnostic::default()
        });
    }
    all
}

/// A place in this text or in another file.
fn location(text: &Text, analysis: &Analysis, place: &Place) -> Option<Location> {
    let Place::Text(id, range) = place else { return None };
    if Some(*id) == analysis.main() {
        return Some(Location { uri: text.uri.clone(), range: text.span(range) });
    }
    let source = analysis.sources.get(*id);
    let (path, content) = (source.path.as_ref()?, source.text.as_ref()?);
    let uri: Uri = files::uri(path)?;
    Some(Location { uri, range: crate::lsp::position::Lines::new(content).span(content, range) })
}

/// A mark at every claim within some bytes.
pub(in crate::lsp) fn hints(text: &Text, analysis: &Analysis, range: Range) -> Vec<InlayHint> {
    let range = text.bytes(range);
    let statements = analysis.statements().into_iter();
    let inside = statements.filter(|s| s.place.start <= range.end && range.start <= s.place.end);
    inside.filter_map(|statement| hint(text, &statement)).collect()
}

fn hint(text: &Text, statement: &Statement<'_>) -> Option<InlayHint> {
    let label = mark(statement)?;
    Some(InlayHint {
        position: text.position(statement.place.end),
        label: InlayHintLabel::String(format!(" {label}")),
        kind: None,
        text_edits: None,
        tooltip: Some(InlayHintTooltip::MarkupContent(MarkupContent {
            kind: MarkupKind::Markdown,
            value: reasons(statement),
        })),
        padding_left: Some(true),
        padding_right: None,
        data: None,
    })
}

/// `✓`, `✗` with a counterexample, `?`; of several claims each sign with the orders that it is about.
fn mark(statement: &Statement<'_>) -> Option<String> {
    let mut labels = Vec::new();
    for (sign, is) in SIGNS {
        let these: Vec<_> = statement.decided.iter().filter(|(_, _, verdict)| is(verdict)).collect();
        let Some((_, _, verdict)) = these.first() else { continue };
        if these.len() == statement.decided.len() {
            let why = match verdict {
                Verdict::Refuted(witness) => witness.notes.join("; "),
                _ => String::new(),
            };
            let short: String = why.replace('`', "").chars().take(MAX_LENGTH).collect();
            let dots = if why.chars().count() > MAX_LENGTH { "…" } else { "" };
            return Some(format!("{sign} {short}{dots}").trim_end().to_string());
        }
        let all = these.iter().map(|(subject, _, _)| subject.order());
        labels.push(match orders::describe(all).as_str() {
            "" => format!("{sign} {}", these.len()),
            orders => format!("{sign} {orders}"),
        });
    }
    (!labels.is_empty()).then(|| labels.join("  "))
}

type Test = fn(&Verdict) -> bool;

const SIGNS: [(&str, Test); 3] = [
    ("✓", |verdict| matches!(verdict, Verdict::Proved(_))),
    ("✗", |verdict| matches!(verdict, Verdict::Refuted(_))),
    ("?", |verdict| matches!(verdict, Verdict::Undecided(_))),
];

/// The most claims of one statement whose reasons are shown.
const MAX_REASONS: usize = 6;

/// Why the claims of a statement hold, or where they fail, in Markdown.
pub(in crate::lsp) fn reasons(statement: &Statement<'_>) -> String {
    let mut lines = Vec::new();
    for (subject, claim, verdict) in statement.decided.iter().take(MAX_REASONS) {
        let about = match (statement.decided.len(), subject.order()) {
            (1, _) => String::new(),
            (_, []) => format!("`{}` is ", claim.text),
            (_, order) => format!("`{}`, {}: ", claim.text, orders::values(order)),
        };
        lines.push(format!("{about}{}", reason(verdict)));
    }
    if statement.decided.len() > MAX_REASONS {
        lines.push(format!("and {} more", statement.decided.len() - MAX_REASONS));
    }
    lines.join("\n\n")
}

/// The verdict with its reason, in Markdown.
fn reason(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Proved(evidence) => format!("**proved** by {}", evidence.method()),
        Verdict::Refuted(witness) => format!("**refuted**: {}", witness.notes.join("; ")),
        Verdict::Undecided(left) => format!("**undecided**: {left}"),
    }
}
