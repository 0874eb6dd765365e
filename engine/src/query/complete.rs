//! What can be typed at a place.

use core::ops::Range;

use basis_prover::collections::sort::sort_by_key;

use super::document::{Document, SymbolKind};
use super::lex::TokenKind;
use super::vocabulary::{WORDS, Word, WordKind, word};
use crate::syntax::GREEK;

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
    /// The name of a spec between quotation marks.
    Spec,
}

/// What stands around a spec.
#[derive(Clone, Debug, Default)]
pub struct Around {
    /// The families of the specs that it uses, with what their comments say.
    pub families: Vec<(String, String)>,
    /// The names of the specs of the library.
    pub library: Vec<String>,
    /// The paths of other spec files, as `use` would name them.
    pub files: Vec<String>,
}

/// What can be typed at a position.
pub fn suggestions(document: &Document, offset: usize, around: &Around) -> Vec<Suggestion> {
    let comment =
        document.tokens.iter().find(|t| t.range.start < offset && offset <= t.range.end && t.is_comment());
    if comment.is_some() {
        return Vec::new();
    }
    let inside = |r: &Range<usize>| r.start < offset && offset <= r.end;
    if let Some(token) = document.tokens.iter().find(|t| t.kind == TokenKind::Quoted && inside(&t.range)) {
        let import = document.imports.iter().find(|i| i.place == token.range);
        return import.map_or_else(Vec::new, |import| {
            let names = if import.library { &around.library } else { &around.files };
            specs(names, import.library, token.range.start + 1..offset)
        });
    }
    let typed = typed(&document.text, offset);
    let mut all = Vec::new();
    letters(&document.text[typed.clone()], &typed, &mut all);
    if document.text[typed.clone()].starts_with('\\') {
        return all;
    }
    let place = Place::new(document, offset, &typed);
    for word in WORDS.iter().filter(|word| place.fits(word)) {
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
    let mut seen: Vec<&str> = Vec::new();
    // Names of inner scopes hide those of outer ones.
    let mut visible: Vec<_> = document.visible(typed.start).filter(|s| s.place != typed).collect();
    sort_by_key(&mut visible, |s| s.scope.end - s.scope.start);
    for symbol in visible {
        let own = symbol.kind.is_item() && symbol.whole.start <= offset && offset <= symbol.whole.end;
        let bounded = place.bounds() && place.has(&symbol.name);
        if own || bounded || !place.names(symbol.kind) || seen.contains(&symbol.name.as_str()) {
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
    if place.names(SymbolKind::Family) {
        for (name, doc) in around.families.iter().filter(|(name, _)| document.item(name).is_none()) {
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

/// Names of specs between quotation marks.
fn specs(names: &[String], library: bool, replaces: Range<usize>) -> Vec<Suggestion> {
    let meaning = if library { "a spec that comes with the toolchain" } else { "a spec of this folder" };
    let suggestion = |name: &String| Suggestion {
        label: name.clone(),
        insert: name.clone(),
        kind: SuggestionKind::Spec,
        meaning: String::from(meaning),
        replaces: replaces.clone(),
    };
    names.iter().map(suggestion).collect()
}

/// What stands before the word that is being typed.
struct Place<'d> {
    /// The kind of the item around it.
    item: Option<SymbolKind>,
    /// The words of the statement so far, a bracketed part as its opening bracket and what follows it.
    before: Vec<&'d str>,
    /// Whether a statement begins here.
    begins: bool,
    /// Whether a block of equations is around it.
    block: bool,
    /// Whether a number, a name or a closing bracket stands before it, which no other name can follow.
    ended: bool,
}

impl<'d> Place<'d> {
    fn new(document: &'d Document, offset: usize, typed: &Range<usize>) -> Self {
        let entry = document
            .entry(offset)
            .filter(|e| e.body.as_ref().is_some_and(|b| b.start <= offset && offset <= b.end));
        let item = entry.and_then(|e| e.symbol).map(|s| document.symbols[s].kind);
        let block = entry.is_some_and(|e| {
            let inside = |r: &Range<usize>| r.start <= offset && offset <= r.end;
            e.children.iter().any(|c| c.body.as_ref().is_some_and(inside))
        });
        let code: Vec<_> =
            document.tokens.iter().filter(|t| !t.is_comment() && t.range.end <= typed.start).collect();
        let text = |k: usize| code[k].text(&document.text);
        let mut first = code.len();
        while first > 0 && !matches!(text(first - 1), ";" | "{" | "}") {
            // A statement without its semicolon ends where the next line begins with a word of the language.
            let opens = first < code.len()
                && word(text(first)).is_some_and(|w| w.kind.begins_statement())
                && document.text[code[first - 1].range.end..code[first].range.start].contains('\n');
            if opens {
                break;
            }
            first -= 1;
        }
        let before: Vec<&str> = (first..code.len()).map(text).collect();
        let ended = code.last().filter(|_| !before.is_empty()).is_some_and(|t| match t.kind {
            TokenKind::Number | TokenKind::Close => true,
            TokenKind::Word => {
                word(t.text(&document.text)).is_none_or(|w| w.kind == WordKind::Property || w.text == "pi")
            }
            _ => false,
        });
        let begins = before.is_empty();
        Self { item, before, begins, block, ended }
    }

    fn last(&self) -> &str {
        self.before.last().copied().unwrap_or_default()
    }

    fn has(&self, word: &str) -> bool {
        self.before.contains(&word)
    }

    /// The word with which the statement begins.
    fn keyword(&self) -> &str {
        self.before.first().copied().unwrap_or_default()
    }

    fn claims(&self) -> bool {
        matches!(self.keyword(), "prove" | "refute" | "conjecture")
    }

    /// Whether an expression can stand here.
    fn is_formula(&self) -> bool {
        let ranges = matches!(self.keyword(), "domain" | "shape" | "scalar" | "dimension" | "budget");
        self.item.is_some()
            && (!self.begins || self.block)
            && !self.ended
            && !ranges
            && !matches!(self.last(), "let" | "for" | "raise" | "permute" | "curve" | "surface" | "patch")
            && !matches!(self.last(), "except" | "at" | "with")
    }

    /// Whether a curve or surface of a theorem gets its family here.
    fn is_patch(&self) -> bool {
        matches!(self.keyword(), "curve" | "surface" | "patch")
    }

    fn fits(&self, word: &Word) -> bool {
        let family = self.item == Some(SymbolKind::Family);
        let (inside, starts) = (self.item.is_some(), self.begins && !self.block);
        match (word.kind, word.text) {
            (WordKind::Item, _) => !inside && self.begins,
            (WordKind::Statement, _) => family && starts,
            (WordKind::TheoremStatement, _) => inside && !family && starts,
            (WordKind::EitherStatement, _) => inside && starts,
            (WordKind::Property, _) => family && matches!(self.last(), "prove" | "refute" | "conjecture"),
            (WordKind::Function, _) => self.is_formula() && !self.is_patch(),
            (_, "library") => self.last() == "use",
            (_, "at") => matches!(self.last(), "prove" | "refute" | "conjecture"),
            (_, "except") => self.claims() && self.last() == "independent",
            (_, "with") => self.has("continuity") && self.ended,
            (_, "for" | "if") => inside && self.ended && !matches!(self.keyword(), "domain" | "use"),
            (_, "in") => self.ended && (self.has("for") || !inside && self.last() != "use"),
            (_, "simplex") => self.last() == "in",
            (_, "triangle" | "tetrahedron") => family && matches!(self.last(), "domain" | ","),
            (_, "parallel") => inside && !family && self.claims() && self.ended,
            (_, "pi") => self.is_formula() && !self.is_patch() || self.bounds(),
            _ => false,
        }
    }

    /// Whether a bound of a range stands here.
    fn bounds(&self) -> bool {
        matches!(self.keyword(), "domain" | "shape") && !self.ended && self.last() != self.keyword()
    }

    /// Whether a name of this kind can stand here.
    fn names(&self, kind: SymbolKind) -> bool {
        let inside = self.item.is_some();
        match kind {
            SymbolKind::Theorem | SymbolKind::Join => false,
            SymbolKind::Family => self.is_formula(),
            _ if self.is_patch() => kind == SymbolKind::Scalar && self.has("(") && !self.ended,
            SymbolKind::Functions if self.begins && !self.block => inside,
            SymbolKind::Shape | SymbolKind::Order => {
                self.is_formula()
                    || inside && self.bounds()
                    || inside && matches!(self.last(), "except" | "at" | "with")
            }
            SymbolKind::Domain | SymbolKind::Scalar => self.is_formula() || self.last() == "at",
            _ => self.is_formula(),
        }
    }
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
        let around = Around {
            families: vec![(String::from("Quartic"), String::from("a family"))],
            library: vec![String::from("papers/quartic")],
            files: vec![String::from("base.basis")],
        };
        suggestions(&document, offset, &around)
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
        assert!(at("// fam|").is_empty() && at("family F { x \"fam|").is_empty());
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
    fn only_what_fits_is_suggested() {
        let labels = |text: &str| at(text).into_iter().map(|s| s.label).collect::<Vec<_>>();
        assert_eq!(labels("use library \"|\";"), ["papers/quartic"]);
        assert_eq!(labels("use library \"pap|"), ["papers/quartic"]);
        assert_eq!(labels("use \"|\"; family F {}"), ["base.basis"]);
        assert_eq!(labels("use |"), ["library"]);
        let family =
            |rest: &str| labels(&format!("family F {{ domain 0 <= t <= 1; shape 0 < λ; b[0] = t; {rest} }}"));
        assert_eq!(family("prove independent |"), ["except", "for", "if"]);
        assert_eq!(family("prove independent except |"), ["λ"]);
        assert_eq!(family("prove at |"), ["t", "λ"]);
        assert_eq!(family("prove continuity(1) |"), ["with", "for", "if"]);
        assert_eq!(family("prove b[i] <= 1 for i |"), ["for", "in", "if"]);
        assert_eq!(family("domain |"), ["triangle", "tetrahedron"]);
        assert_eq!(family("shape 0 <= μ <= |"), ["pi", "λ"]);
        let formula = family("b[1] = |");
        assert!(["sin", "pi", "t", "λ", "b", "Quartic"].iter().all(|l| formula.contains(&String::from(*l))));
        assert!(
            !["F", "library", "triangle", "at", "prove"].iter().any(|l| formula.contains(&String::from(*l)))
        );
        // A claim without its semicolon, before another one.
        assert!(family("prove nonnegative\n prove |").contains(&String::from("symmetric")));
        assert_eq!(labels("join J { curve P = |"), ["Quartic"]);
        assert!(labels("join J { curve P = Quartic(0); prove P(0) |").contains(&String::from("parallel")));
    }

    #[test]
    fn a_loop_hides_what_is_outside() {
        let all = at("family F(n in 1..=2) { domain 0 <= t <= 1; b[i] = t^| for i in 0..=n; }");
        assert!(has(&all, "i") && has(&all, "n") && has(&all, "t"));
    }
}
