//! Suggestions while one types.

use basis_engine::Files;
use basis_engine::query::{Around, SuggestionKind, SymbolKind, suggestions};
use lsp_types::{
    CompletionItem, CompletionItemKind, CompletionTextEdit, InsertTextFormat, Position, TextEdit,
};

use crate::lsp::files;
use crate::lsp::workspace::{Text, Workspace};

/// What can be typed at a position; with `snippets` the editor can put the cursor into what is inserted.
pub(in crate::lsp) fn complete(
    workspace: &Workspace,
    text: &Text,
    snippets: bool,
    position: Position,
) -> Vec<CompletionItem> {
    let others = workspace.others(text);
    let families = others.iter().flat_map(|other| {
        let families = other.document.symbols.iter().filter(|s| s.kind == SymbolKind::Family);
        families.map(|s| (s.name.clone(), s.doc.lines().next().unwrap_or_default().to_string()))
    });
    let offset = text.offset(position);
    let mut around = Around { families: families.collect(), ..Around::default() };
    // Folders are read only where a path is typed.
    if let Some(import) =
        text.document.imports.iter().find(|i| i.place.start < offset && offset <= i.place.end)
    {
        if import.library {
            around.library = workspace.files.library().iter().map(|(name, _)| name.to_string()).collect();
        } else {
            around.files = files::beside(text.path.as_deref());
        }
    }
    let all = suggestions(&text.document, offset, &around).into_iter();
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
        SuggestionKind::Spec => CompletionItemKind::FILE,
    }
}

/// Names of the spec stand before words of the language.
const fn order(kind: SuggestionKind) -> u8 {
    match kind {
        SuggestionKind::Property | SuggestionKind::Spec => 0,
        SuggestionKind::Symbol(_) => 1,
        SuggestionKind::Letter => 2,
        SuggestionKind::Function => 3,
        SuggestionKind::Keyword => 4,
    }
}
