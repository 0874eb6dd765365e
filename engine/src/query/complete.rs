//! What can be typed at a place.

use core::ops::Range;

use super::document::{Document, SymbolKind};
use super::lex::TokenKind;
use super::vocabulary::{GREEK, WORDS, WordKind};

/// Something that can be typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggestion {
    /// As it is shown.
    pub label: String,
    /// What is inserted in place of [`Suggestion::replaces`]; `$0` is where the cursor is then.
    pub insert: String,
    /// What it is.
    pub kind: SuggestionKind,
    /// What it means, in a sentence.
    pub meaning: String,
    /// What has been typed of it.
    pub replaces: Range<usize>,
}

/// The kinds of suggestions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SuggestionKind {
    /// A word of the language.
    Keyword,
    /// A claim about a whole family.
    Property,
    /// A function of the language.
    Function,
    /// A name of the spec.
    Symbol(SymbolKind),
    /// A Greek letter.
    Letter,
}

/// What can be typed at a position, `others` being the families of the specs that this one uses, with what their
/// comments say.
pub fn suggestions(document: &Document, offset: usize, others: &[(String, String)]) -> Vec<Suggestion> {
    let comment =
        document.tokens.iter().find(|t| t.range.start < offset && offset <= t.range.end && t.is_comment());
    let quoted =
        document.token(offset).is_some_and(|t| t.kind == TokenKind::Quoted && t.range.start < offset);
    if comment.is_some() || quoted {
        return Vec::new();
    }
    let typed = typed(&document.text, offset);
    let mut all = Vec::new();
    letters(&document.text[typed.clone()], &typed, &mut all);
    if document.text[typed.clone()].starts_with('\\') {
        return all;
    }
    let entry = document
        .entry(offset)
        .filter(|e| e.body.as_ref().is_some_and(|b| b.start <= offset && offset <= b.end));
    let item = entry.and_then(|e| e.symbol).map(|s| document.symbols[s].kind);
    let before = document.tokens.iter().rfind(|t| !t.is_comment() && t.range.end <= typed.start);
    let last = before.map_or("", |t| t.text(&document.text));
    let begins = matches!(last, "" | ";" | "{" | "}");
    let block = entry.is_some_and(|e| {
        let inside = |r: &Range<usize>| r.start <= offset && offset <= r.end;
        e.children.iter().any(|c| c.body.as_ref().is_some_and(inside))
    });
    let family = item == Some(SymbolKind::Family);
    let fits = |kind: WordKind| match kind {
        WordKind::Item => item.is_none(),
        WordKind::Statement => family && begins && !block,
        WordKind::TheoremStatement => item.is_some() && !family && begins && !block,
        WordKind::EitherStatement => item.is_some() && begins && !block,
        WordKind::Property => family && matches!(last, "prove" | "refute" | "conjecture"),
        WordKind::Connective => item.is_some() && (!begins || block) || item.is_none() && last == "use",
        WordKind::Function => item.is_some() && (!begins || block),
    };
    for word in WORDS.iter().filter(|word| fits(word.kind)) {
        // Brackets or a semicolon that stand already are not written again.
        let follows = document.text[offset..].trim_start_matches([' ', '\t']).starts_with(['(', ';', '{']);
        let rest = if follows { "" } else { word.rest };
        let kind = match word.kind {
            WordKind::Property => SuggestionKind::Property,
            WordKind::Function => SuggestionKind::Function,
            _ => SuggestionKind::Keyword,
        };
        all.push(Suggestion {
            label: word.text.to_string(),
            insert: format!("{}{rest}", word.text),
            kind,
            meaning: word.meaning.to_string(),
            replaces: typed.clone(),
        });
    }
    if item.is_none() {
        return all;
    }
    let mut seen: Vec<&str> = Vec::new();
    // Names of inner scopes hide those of outer ones.
    let mut visible: Vec<_> = document.visible(typed.start).filter(|s| s.place != typed).collect();
    visible.sort_by_key(|s| s.scope.end - s.scope.start);
    for symbol in visible {
        let formula = !matches!(symbol.kind, SymbolKind::Theorem | SymbolKind::Join);
        if begins && !block && symbol.kind != SymbolKind::Functions
            || !formula
            || seen.contains(&symbol.name.as_str())
        {
            continue;
        }
        seen.push(&symbol.name);
        let doc = symbol.doc.lines().next().unwrap_or_default();
        let noun = symbol.kind.noun();
        let meaning = if doc.is_empty() { noun.to_string() } else { format!("{noun}: {doc}") };
        all.push(Suggestion {
            label: symbol.name.clone(),
            insert: symbol.name.clone(),
            kind: SuggestionKind::Symbol(symbol.kind),
            meaning,
            replaces: typed.clone(),
        });
    }
    if !begins || block {
        for (name, doc) in others.iter().filter(|(name, _)| document.item(name).is_none()) {
            all.push(Suggestion {
                label: name.clone(),
                insert: name.clone(),
                kind: SuggestionKind::Symbol(SymbolKind::Family),
                meaning: doc.clone(),
                replaces: typed.clone(),
            });
        }
    }
    all
}

/// The part of a word before a position, with a backslash before it.
fn typed(text: &str, offset: usize) -> Range<usize> {
    let before = text.get(..offset).unwrap_or_default();
    let word = before.trim_end_matches(|c: char| c.is_alphanumeric() || c == '_');
    let start = if word.ends_with('\\') { word.len() - 1 } else { word.len() };
    start..before.len()
}

/// The Greek letters whose names begin with what is typed: all of them after a backslash, otherwise from two letters
/// on.
fn letters(typed: &str, place: &Range<usize>, all: &mut Vec<Suggestion>) {
    let (name, few) = match typed.strip_prefix('\\') {
        Some(rest) => (rest, 0),
        None => (typed, 2),
    };
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &name[stem.len()..];
    if stem.len() < few {
        return;
    }
    for (word, letter) in GREEK.iter().filter(|(word, _)| word.starts_with(stem) && *word != "omicron") {
        let backslash = if typed.starts_with('\\') { "\\" } else { "" };
        all.push(Suggestion {
            label: format!("{backslash}{word}{digits}"),
            insert: format!("{letter}{digits}"),
            kind: SuggestionKind::Letter,
            meaning: format!("{letter}{digits}"),
            replaces: place.clone(),
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The suggestions at `|` in a text.
    fn at(text: &str) -> Vec<Suggestion> {
        let offset = text.find('|').expect("a place is marked");
        let document = Document::new(text.replace('|', ""));
        suggestions(&document, offset, &[(String::from("Quartic"), String::from("a family"))])
    }

    fn has(all: &[Suggestion], label: &str) -> bool {
        all.iter().any(|s| s.label == label)
    }

    #[test]
    fn claims_follow_prove_and_statements_begin_lines() {
        let all = at("family F { domain 0 <= t <= 1; b[0] = t; prove non| }");
        assert!(has(&all, "nonnegative") && has(&all, "b") && has(&all, "Quartic") && !has(&all, "domain"));
        let all = at("family F { domain 0 <= t <= 1; | }");
        assert!(has(&all, "prove") && !has(&all, "nonnegative") && !has(&all, "t") && !has(&all, "curve"));
        let all = at("join J { | }");
        assert!(has(&all, "curve") && has(&all, "prove") && !has(&all, "shape"));
        assert!(has(&at("|"), "family") && !has(&at("|"), "prove"));
        let all = at("family F { domain 0 <= t <= 1; b[0] = t; prove at t = 0 { | } }");
        assert!(has(&all, "b") && has(&all, "D") && !has(&all, "prove"));
        assert!(at("// fam|").is_empty() && at("use \"fam|").is_empty());
    }

    #[test]
    fn letters_have_names() {
        let all = at("family F { shape \\lam| }");
        assert_eq!(all.len(), 1);
        assert_eq!((all[0].insert.as_str(), all[0].replaces.len()), ("λ", 4));
        let all = at("family F { domain 0 <= t <= 1; shape 0 <= λ; b[0] = lambda1| }");
        let letter = all.iter().find(|s| s.kind == SuggestionKind::Letter).expect("λ1 is suggested");
        assert_eq!(letter.insert, "λ1");
    }

    #[test]
    fn a_loop_hides_what_is_outside() {
        let all = at("family F(n in 1..=2) { domain 0 <= t <= 1; b[i] = t^| for i in 0..=n; }");
        assert!(has(&all, "i") && has(&all, "n") && has(&all, "t"));
    }
}
