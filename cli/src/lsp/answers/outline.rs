//! The outline of a spec, and what can be folded.

use basis_engine::query::{Document, Entry, SymbolKind as Kind, TokenKind};
use lsp_types::{DocumentSymbol, FoldingRange, FoldingRangeKind, SymbolKind};

use crate::lsp::workspace::Text;

/// The items with their statements.
pub(in crate::lsp) fn outline(text: &Text) -> Vec<DocumentSymbol> {
    text.document.entries.iter().map(|entry| symbol(text, entry)).collect()
}

#[allow(deprecated)] // the protocol's type has an old field that must be given
fn symbol(text: &Text, entry: &Entry) -> DocumentSymbol {
    let children: Vec<DocumentSymbol> = entry.children.iter().map(|child| symbol(text, child)).collect();
    DocumentSymbol {
        name: entry.title.clone(),
        detail: None,
        kind: kind(&text.document, entry),
        tags: None,
        deprecated: None,
        range: text.span(&entry.whole),
        selection_range: text.span(&entry.name),
        children: (!children.is_empty()).then_some(children),
    }
}

fn kind(document: &Document, entry: &Entry) -> SymbolKind {
    match entry.symbol.map(|s| document.symbols[s].kind) {
        Some(Kind::Family) => SymbolKind::CLASS,
        Some(Kind::Theorem | Kind::Join) => SymbolKind::MODULE,
        Some(Kind::Functions) => SymbolKind::FUNCTION,
        Some(Kind::Let) => SymbolKind::CONSTANT,
        Some(Kind::Patch) => SymbolKind::OBJECT,
        Some(_) => SymbolKind::VARIABLE,
        None => SymbolKind::BOOLEAN,
    }
}

/// Items, blocks, lists over several lines, and comments.
pub(in crate::lsp) fn folds(text: &Text) -> Vec<FoldingRange> {
    let document = &text.document;
    let mut all = Vec::new();
    let mut fold = |first: usize, last: usize, kind: Option<FoldingRangeKind>| {
        let (start, end) = (text.position(first).line, text.position(last).line);
        if start < end {
            all.push(FoldingRange { start_line: start, end_line: end, kind, ..FoldingRange::default() });
        }
    };
    for token in document.tokens.iter().filter(|t| t.kind == TokenKind::Open) {
        if let Some(partner) = token.partner {
            fold(token.range.start, document.tokens[partner].range.start, None);
        }
    }
    // Comments on neighbouring lines.
    let mut run: Option<(usize, usize)> = None;
    for token in &document.tokens {
        run = match (run, token.is_comment()) {
            (Some((first, last)), true)
                if !document.text[last..token.range.start].trim_matches(' ').contains("\n\n") =>
            {
                Some((first, token.range.end))
            }
            (before, comment) => {
                if let Some((first, last)) = before {
                    fold(first, last, Some(FoldingRangeKind::Comment));
                }
                comment.then_some((token.range.start, token.range.end))
            }
        };
    }
    if let Some((first, last)) = run {
        fold(first, last, Some(FoldingRangeKind::Comment));
    }
    all
}
