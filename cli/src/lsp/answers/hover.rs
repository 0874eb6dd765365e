//! What the editor shows about the word under the pointer.

use basis_engine::query::{
    Document, FunctionFacts, Import, Symbol, SymbolKind, TokenKind, function_facts, latex, word,
};
use basis_engine::{Family, Subject, explain};
use core::ops::Range;
use lsp_types::{Hover, HoverContents, MarkupContent, MarkupKind, Position};

use super::marks::reasons;
use crate::domain;
use crate::lsp::files::{self, Other};
use crate::lsp::workspace::{Text, Workspace};
use basis_engine::query::Analysis;

/// The most functions that are shown at once.
const MAX_FUNCTIONS: usize = 8;

/// The most characters of a formula that are shown.
const MAX_FORMULA: usize = 600;

/// What there is to say about the word at a position.
pub(in crate::lsp) fn hover(
    workspace: &Workspace,
    text: &Text,
    analysis: &Analysis,
    position: Position,
) -> Option<Hover> {
    let offset = text.offset(position);
    let here = |i: &&Import| i.place.start <= offset && offset <= i.place.end;
    if let Some(import) = text.document.imports.iter().find(here) {
        let found = files::visible(&workspace.files, text.path.as_deref(), core::slice::from_ref(import));
        // What every spec can name stands last.
        let (first, _) = found.split_first().filter(|(_, rest)| !rest.is_empty())?;
        return Some(shown(text, &import.place, of_spec(&first.document)));
    }
    let (range, value) = match text.document.at(offset) {
        Some(name) => {
            let word = text.document.slice(&name.range);
            let value = match name.symbol.map(|s| &text.document.symbols[s]) {
                Some(symbol) => of_symbol(text, analysis, symbol, offset),
                None => of_other(&workspace.others(text), word),
            };
            (name.range.clone(), value?)
        }
        None => {
            let token = text.document.token(offset)?;
            let known = word(token.text(&text.document.text)).filter(|_| token.kind == TokenKind::Word)?;
            let mut value = format!("`{}`: {}", known.text, known.meaning);
            let own =
                |s: &basis_engine::query::Statement<'_>| s.place.start <= offset && offset <= s.place.end;
            if let Some(statement) = analysis.statements().iter().find(|s| own(s)) {
                value += &format!("\n\n{}", reasons(statement));
            }
            (token.range.clone(), value)
        }
    };
    Some(shown(text, &range, value))
}

fn shown(text: &Text, range: &Range<usize>, value: String) -> Hover {
    let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value });
    Hover { contents, range: Some(text.span(range)) }
}

/// What the comment of a spec says, and what it declares.
fn of_spec(document: &Document) -> String {
    let doc = document.tokens.iter().map(|t| t.text(&document.text)).map_while(|t| t.strip_prefix("//!"));
    let mut value = String::new();
    for line in doc {
        value += &format!("{}\n", line.trim_start());
    }
    for symbol in document.symbols.iter().filter(|s| s.kind.is_item()) {
        let first = symbol.doc.lines().next().unwrap_or_default();
        value += &format!("\n- {} **{}**", symbol.kind.noun(), symbol.name);
        if !first.is_empty() {
            value += &format!(": {first}");
        }
    }
    value
}

fn of_symbol(text: &Text, analysis: &Analysis, symbol: &Symbol, offset: usize) -> Option<String> {
    let item = text.document.entry(symbol.place.start)?;
    let family = analysis.family(&item.title);
    let head = format!("**{}**, {}", symbol.name, symbol.kind.noun());
    let doc = if symbol.doc.is_empty() { String::new() } else { format!("\n\n{}", symbol.doc) };
    let facts = match (symbol.kind, family) {
        (SymbolKind::Functions, Some(family)) if family.pieces.is_empty() => functions(text, family, offset),
        // On each span of the domain a function has a formula of its own.
        (SymbolKind::Functions, Some(family)) => {
            let span = |piece: &Family| {
                format!("\n\non `{}`{}", domain::describe(piece), functions(text, piece, offset))
            };
            family.pieces.iter().map(|piece| span(piece)).collect()
        }
        (SymbolKind::Shape, Some(family)) => shape(text, family, symbol),
        (SymbolKind::Domain, Some(family)) => format!("\n\non `{}`", domain::describe(family)),
        (SymbolKind::Family, Some(family)) => summary(analysis, family),
        (SymbolKind::Join | SymbolKind::Theorem, _) => theorem(analysis, &symbol.name, |_| true),
        (SymbolKind::Patch, _) => {
            let one = label(text, offset);
            let all = format!("{}[", symbol.name);
            let own = |point: &str| one.as_ref().map_or_else(|| point.starts_with(&all), |one| point == one);
            format!("\n\n{}{}", written(text, symbol), theorem(analysis, &item.title, own))
        }
        (SymbolKind::Let | SymbolKind::Scalar, _) => format!("\n\n{}", written(text, symbol)),
        _ => String::new(),
    };
    let facts = if facts.is_empty() { declaration(text, symbol) } else { facts };
    Some(format!("{head}{doc}{facts}"))
}

/// Where a parameter or variable is declared, as it is written: of an index what it runs over.
fn declaration(text: &Text, symbol: &Symbol) -> String {
    let document = &text.document;
    let from = document.tokens.partition_point(|t| t.range.start < symbol.place.start);
    let item = document.entry(symbol.place.start);
    let statement = item.and_then(|e| e.statement(symbol.place.start)).map(|s| s.whole.clone());
    let mut end = None;
    let (mut k, mut runs) = (from, false);
    while let Some(token) = document.tokens.get(k) {
        let word = token.text(&document.text);
        if runs && matches!(word, "," | ";" | "if" | "for" | "{") || matches!(word, ")" | "]" | "}" | ";") {
            break;
        }
        runs |= word == "in";
        k = token.partner.map_or(k, |partner| partner.max(k));
        end = document.tokens.get(k).map(|t| t.range.end);
        k += 1;
    }
    let index = matches!(symbol.kind, SymbolKind::Index | SymbolKind::Order);
    let place = match (index && runs, end, statement) {
        (true, Some(end), _) => symbol.place.start..end,
        (_, _, Some(statement)) => statement,
        _ => return String::new(),
    };
    format!("\n\n```basis\n{}\n```", cut(document.slice(&place)))
}

/// A family of another spec.
fn of_other(others: &[Other], name: &str) -> Option<String> {
    let symbol = others.iter().find_map(|o| Some(&o.document.symbols[o.document.item(name)?]))?;
    Some(format!("**{name}**, {}\n\n{}", symbol.kind.noun(), symbol.doc))
}

/// The function whose index follows, or all of them.
fn functions(text: &Text, family: &Family, offset: usize) -> String {
    let facts = function_facts(family);
    let label = label(text, offset);
    let named: Vec<&FunctionFacts> = facts.iter().filter(|f| Some(&f.label) == label.as_ref()).collect();
    let shown: Vec<&FunctionFacts> = if named.is_empty() { facts.iter().collect() } else { named };
    let order = if family.order.is_empty() { String::new() } else { format!("\n\nof `{}`", family.title()) };
    let mut value = order;
    for f in shown.iter().take(MAX_FUNCTIONS) {
        value += &format!("\n\n```basis\n{} = {}\n", f.label, cut(&f.factored));
        if f.expanded != f.factored {
            value += &format!("{:1$} = {2}\n", "", f.label.chars().count(), cut(&f.expanded));
        }
        value += "```";
        if !f.bernstein.is_empty() && shown.len() <= 2 {
            let degree = f.bernstein.len() - 1;
            value +=
                &format!("\n\nBernstein coefficients of degree {degree}: `{}`", cut(&f.bernstein.join(", ")));
        }
        if let Some((low, high)) = &f.between {
            value += &format!("\n\nvalues between {low} and {high}");
        }
        if let (1, Some(math)) = (shown.len(), latex::math(&format!("{} = {}", f.label, f.factored))) {
            value += &format!("\n\nLaTeX: `{}`", cut(&math));
        }
    }
    if shown.len() > MAX_FUNCTIONS {
        value += &format!("\n\nand {} more", shown.len() - MAX_FUNCTIONS);
    }
    value
}

/// The label `b[1]` at a position where numbers follow the name in brackets.
fn label(text: &Text, offset: usize) -> Option<String> {
    let document = &text.document;
    let name = document.at(offset)?;
    let open = document.tokens.partition_point(|t| t.range.start < name.range.end);
    let bracket = document.tokens.get(open).filter(|t| t.text(&document.text) == "[")?;
    let inside = document.tokens.get(open + 1..bracket.partner?)?;
    let numbers: Vec<&str> =
        inside.iter().filter(|t| t.kind == TokenKind::Number).map(|t| t.text(&document.text)).collect();
    Some(format!("{}[{}]", document.slice(&name.range), numbers.join(",")))
}

fn cut(formula: &str) -> String {
    if formula.chars().count() <= MAX_FORMULA {
        return formula.to_string();
    }
    formula.chars().take(MAX_FORMULA).chain(['…']).collect()
}

fn shape(text: &Text, family: &Family, symbol: &Symbol) -> String {
    let Some(parameter) = family.shapes.iter().find(|p| p.name == symbol.name) else { return String::new() };
    let mut value = format!("\n\ndeclared `{}`", family.declared(parameter));
    let position = text.document.symbols.iter().position(|s| s == symbol);
    let uses = position.map_or(0, |s| text.document.places(s).count().saturating_sub(1));
    value += &format!(", named in {}", crate::name::count(uses, "place"));
    let range = explain::nonnegative_ranges(family).into_iter().find(|r| r.name == symbol.name);
    if let Some(range) = range {
        value += &format!("\n\nall functions are nonnegative for `{range}`");
    }
    for exception in &explain::exceptional_set(family).exceptions {
        if exception.values.iter().any(|(var, _)| *var == parameter.var) {
            value += &format!("\n\ndependent at `{}`", explain::describe_exception(family, exception));
        }
    }
    value
}

fn summary(analysis: &Analysis, family: &Family) -> String {
    let of = |item: &&basis_engine::query::Analysed| matches!(&item.subject, Subject::Family(f) if f.name == family.name);
    let items: Vec<_> = analysis.items.iter().filter(of).collect();
    let claims = || items.iter().flat_map(|item| &item.claims);
    let decided = claims().filter_map(|(claim, verdict)| Some((claim, verdict.as_ref()?)));
    let fine = decided.filter(|(c, v)| basis_engine::state::as_declared(c.expected, v)).count();
    let functions = crate::name::count(family.functions.len(), "function");
    let kind = domain::transcendental(family).map_or_else(
        || {
            let degrees: Vec<String> = domain::degrees(family).iter().map(u32::to_string).collect();
            format!("of degree {}", degrees.join(", "))
        },
        String::from,
    );
    let mut value = format!("\n\n{functions} {kind} on `{}`", domain::describe(family));
    for shape in &family.shapes {
        value += &format!(", `{}`", family.declared(shape));
    }
    if items.len() > 1 {
        value += &format!("; the lowest of {} orders", items.len());
    }
    value + &format!("\n\n{fine} of {} as declared", crate::name::count(claims().count(), "claim"))
}

/// A declaration as it stands in the text.
fn written(text: &Text, symbol: &Symbol) -> String {
    format!("```basis\n{}\n```", text.document.slice(&symbol.whole))
}

/// The control points that a join determines, those that are asked for.
fn theorem(analysis: &Analysis, name: &str, wanted: impl Fn(&str) -> bool) -> String {
    let subject = analysis.items.iter().map(|item| &item.subject).find(|s| s.name() == name);
    let Some(Subject::Theorem(theorem)) = subject else { return String::new() };
    let points = explain::determined_points(theorem);
    let lines: Vec<String> = points
        .iter()
        .filter(|(point, _)| wanted(point))
        .map(|(point, value)| format!("{point} = {}\n", cut(value)))
        .collect();
    if lines.is_empty() { String::new() } else { format!("\n\n```basis\n{}```", lines.concat()) }
}
