//! Suggestions while one types.

use basis_engine::query::{SuggestionKind, SymbolKind, suggestions};
use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionTextEdit, InsertTextFormat, Position, TextEdit,
};

use crate::lsp::files::Other;
use crate::lsp::workspace::Text;

/// What can be typed at a position; with `snippets` the editor can put the cursor into what is inserted.
pub(in crate::lsp) fn complete(
    text: &Text,
    others: &[Other],
    snippets: bool,
    position: Position,
) -> Vec<CompletionItem> {
    let families = others.iter().flat_map(|other| {
        let families = other.document.symbols.iter().filter(|s| s.kind == SymbolKind::Family);
        families.map(|s| (s.name.clone(), s.doc.lines().next().unwrap_or_default().to_string()))
    });
    let families: Vec<(String, String)> = families.collect();
    let all = suggestions(&text.document, text.offset(position), &families).into_iter();
    let item = |suggestion: basis_engine::query::Suggestion| {
        let snippet = snippets && suggestion.insert.contains("$0");
        let new_text = if snippet {
            suggestion.insert
        } else {
            suggestion.insert.split("$0").next().unwrap_or_default().to_string()
        };
        let edit = TextEdit { range: text.span(&suggestion.replaces), new_text };
        CompletionItem {
            filter_text: Some(suggestion.label.clone()),
            label: suggestion.label,
            kind: Some(kind(suggestion.kind)),
            detail: Some(suggestion.meaning),
            sort_text: Some(format!("{}", order(suggestion.kind))),
            insert_text_format: snippet.then_some(InsertTextFormat::SNIPPET),
            text_edit: Some(CompletionTextEdit::Edit(edit)),
            ..CompletionItem::default()
        }
    };
    all.map(item).collect()
}

const fn kind(kind: SuggestionKind) -> CompletionItemKind {
    match kind {
        SuggestionKind::Keyword => CompletionItemKind::KEYWORD,
        SuggestionKind::Property => CompletionItemKind::PROPERTY,
        SuggestionKind::Function | SuggestionKind::Symbol(SymbolKind::Functions) => {
            CompletionItemKind::FUNCTION
        }
        SuggestionKind::Symbol(SymbolKind::Family) => CompletionItemKind::CLASS,
        SuggestionKind::Symbol(SymbolKind::Let) => CompletionItemKind::CONSTANT,
        SuggestionKind::Symbol(_) => CompletionItemKind::VARIABLE,
        SuggestionKind::Letter => CompletionItemKind::TEXT,
    }
}

/// Names of the spec stand before words of the language.
const fn order(kind: SuggestionKind) -> u8 {
    match kind {
        SuggestionKind::Property => 0,
        SuggestionKind::Symbol(_) => 1,
        SuggestionKind::Letter => 2,
        SuggestionKind::Function => 3,
        SuggestionKind::Keyword => 4,
    }
}
