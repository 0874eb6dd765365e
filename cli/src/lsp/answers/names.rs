//! Where a name is declared and named, in this spec and in others, and how it is renamed.

use std::collections::HashMap;
use std::path::PathBuf;

use basis_engine::query::{Document, SymbolKind, is_name};
use lsp_types::{Location, Position, Range, TextEdit, Uri, WorkspaceEdit};

use crate::lsp::files::{self, Other};
use crate::lsp::position::Lines;
use crate::lsp::workspace::{Text, Workspace};

/// Where the name at a position is declared.
pub(in crate::lsp) fn definition(
    workspace: &Workspace,
    text: &Text,
    position: Position,
) -> Option<Vec<Location>> {
    let offset = text.offset(position);
    let document = &text.document;
    let import = document.imports.iter().find(|i| i.place.start <= offset && offset <= i.place.end);
    if let Some(import) = import {
        let other = files::visible(&workspace.files, text.path.as_deref(), core::slice::from_ref(import));
        let (first, _) = other.split_first().filter(|(_, rest)| !rest.is_empty())?;
        return Some(vec![Location { uri: files::address(first)?, range: Range::default() }]);
    }
    let name = document.at(offset)?;
    let Some(symbol) = name.symbol else {
        let (other, place) = elsewhere(&workspace.others(text), document.slice(&name.range))?;
        return Some(vec![Location { uri: other, range: place }]);
    };
    let symbol_range = |range| vec![Location { uri: text.uri.clone(), range: text.span(range) }];
    if document.symbols[symbol].kind == SymbolKind::Functions
        && let Some(statement) = same_function(document, symbol, name.range.end)
    {
        return Some(symbol_range(&statement));
    }
    Some(symbol_range(&document.symbols[symbol].place))
}

/// The declaration of a family in another spec.
fn elsewhere(others: &[Other], name: &str) -> Option<(Uri, Range)> {
    let other = others.iter().find(|o| o.document.item(name).is_some())?;
    let symbol = &other.document.symbols[other.document.item(name)?];
    let lines = Lines::new(&other.document.text);
    Some((files::address(other)?, lines.span(&other.document.text, &symbol.place)))
}

/// Where the function with the index that follows a name is declared, `b[1] = …` for `b[1]`.
fn same_function(document: &Document, symbol: usize, end: usize) -> Option<core::ops::Range<usize>> {
    let index = |end: usize| {
        let open = document.tokens.partition_point(|t| t.range.start < end);
        let close = document.tokens.get(open)?.partner?;
        let inside = document.tokens.get(open..=close)?;
        (document.tokens[open].text(&document.text) == "[")
            .then(|| inside.iter().map(|t| t.text(&document.text)).collect::<String>())
    };
    let wanted = index(end)?;
    let places = document.places(symbol).filter(|o| o.role == basis_engine::query::Role::Declared);
    places.into_iter().find(|o| index(o.range.end).as_ref() == Some(&wanted)).map(|o| o.range.clone())
}

/// All places at which the name at a position stands, in this spec and in those of the workspace.
pub(in crate::lsp) fn references(
    workspace: &Workspace,
    text: &Text,
    position: Position,
    with_declaration: bool,
) -> Option<Vec<Location>> {
    let (name, kind) = meant(text, position)?;
    let mut all = Vec::new();
    for (uri, document, places) in occurrences(workspace, text, position, &name, kind) {
        let lines = Lines::new(&document.text);
        for (place, declared) in places {
            if with_declaration || !declared {
                all.push(Location { uri: uri.clone(), range: lines.span(&document.text, &place) });
            }
        }
    }
    Some(all)
}

/// The name at a position, and whether it is one of an item, which other specs can name.
fn meant(text: &Text, position: Position) -> Option<(String, Option<SymbolKind>)> {
    let name = text.document.at(text.offset(position))?;
    let kind = name.symbol.map(|s| text.document.symbols[s].kind);
    Some((text.document.slice(&name.range).to_string(), kind))
}

type Places = Vec<(core::ops::Range<usize>, bool)>;

/// The places of a name in all specs that mean the same thing by it.
fn occurrences(
    workspace: &Workspace,
    text: &Text,
    position: Position,
    name: &str,
    kind: Option<SymbolKind>,
) -> Vec<(Uri, Document, Places)> {
    let own = |document: &Document, symbol: Option<usize>| -> Places {
        let declared = symbol.map(|s| document.symbols[s].place.clone());
        document
            .occurrences
            .iter()
            .filter(|o| o.symbol == symbol && (symbol.is_some() || document.slice(&o.range) == name))
            .map(|o| (o.range.clone(), Some(&o.range) == declared.as_ref()))
            .collect()
    };
    let symbol = text.document.at(text.offset(position)).and_then(|o| o.symbol);
    if let (Some(_), false) = (symbol, kind.is_some_and(SymbolKind::is_item)) {
        return vec![(text.uri.clone(), text.document.clone(), own(&text.document, symbol))];
    }
    // The file that declares the family.
    let home: Option<PathBuf> = if symbol.is_some() {
        text.path.clone()
    } else {
        let others = workspace.others(text);
        others.iter().find(|o| o.document.item(name).is_some()).map(|o| o.path.clone())
    };
    let mut all = vec![(text.uri.clone(), text.document.clone(), own(&text.document, symbol))];
    let Some(home) = home else { return all };
    for path in workspace.specs() {
        if Some(&path) == text.path.as_ref() {
            continue;
        }
        let Some(document) = workspace.document(&path) else { continue };
        let uses =
            files::visible(&workspace.files, Some(&path), &document.imports).iter().any(|o| o.path == home);
        let places = match document.item(name) {
            Some(item) if path == home => own(&document, Some(item)),
            None if uses => own(&document, None),
            _ => continue,
        };
        if let (Some(uri), false) = (files::uri(&path), places.is_empty()) {
            all.push((uri, document, places));
        }
    }
    all
}

/// The name that would be renamed.
pub(in crate::lsp) fn prepare(
    workspace: &Workspace,
    text: &Text,
    position: Position,
) -> Result<Range, String> {
    let name = text.document.at(text.offset(position)).ok_or("there is no name here")?;
    let word = text.document.slice(&name.range);
    if name.symbol.is_none() {
        let others = workspace.others(text);
        match others.iter().find(|o| o.document.item(word).is_some()) {
            None => return Err(format!("`{word}` is not declared anywhere")),
            Some(other) if other.shipped => {
                return Err(format!("`{word}` comes with the toolchain and keeps its name"));
            }
            Some(_) => {}
        }
    }
    Ok(text.span(&name.range))
}

/// The edits that rename what stands at a position.
#[allow(clippy::mutable_key_type)] // addresses are keys in the protocol's own type, and nothing changes them
pub(in crate::lsp) fn rename(
    workspace: &Workspace,
    text: &Text,
    position: Position,
    new: &str,
) -> Result<WorkspaceEdit, String> {
    prepare(workspace, text, position)?;
    if !is_name(new) {
        return Err(format!("`{new}` is not a name: write letters and digits, but no word of the language"));
    }
    let (name, kind) = meant(text, position).ok_or("there is no name here")?;
    let mut changes: HashMap<Uri, Vec<TextEdit>> = HashMap::new();
    for (uri, document, places) in occurrences(workspace, text, position, &name, kind) {
        // The new name would mean something else at one of the places.
        for (place, _) in &places {
            if let Some(taken) = document.visible(place.start).find(|s| s.name == new) {
                return Err(format!("`{new}` is already a {} here", taken.kind.noun()));
            }
        }
        let lines = Lines::new(&document.text);
        let edit = |(place, _): (core::ops::Range<usize>, bool)| TextEdit {
            range: lines.span(&document.text, &place),
            new_text: new.to_string(),
        };
        changes.insert(uri, places.into_iter().map(edit).collect());
    }
    Ok(WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() })
}
