//! From the tokens of a spec to its names: what stands where, also in a text that is not finished.

use super::document::{Document, Entry, Import, Occurrence, Role, Symbol, SymbolKind};
use super::lex::{Token, TokenKind, tokens};
use super::vocabulary::word;
use core::ops::Range;

use basis_prover::collections::list::Listed;
use basis_prover::collections::sort::{sort_by_key, sort_unique};

impl Document {
    /// Reads a text; whatever it is, there is an answer.
    pub fn new(text: impl Into<String>) -> Self {
        let text = text.into();
        let tokens = tokens(&text);
        let code = (0..tokens.len()).filter(|k| !tokens[*k].is_comment()).collect();
        let document = Self { text, tokens, ..Self::default() };
        let words = document.tokens.iter().filter(|token| !token.is_comment());
        let mut names = words.map(|token| token.text(&document.text).to_string()).listed();
        sort_unique(&mut names);
        let known = vec![Vec::new(); names.len()];
        let mut reader = Reader { document, code, names, known };
        reader.items();
        reader.names();
        reader.document
    }
}

struct Reader {
    document: Document,
    /// The positions of the tokens that are not comments.
    code: Vec<usize>,
    /// All words of the text, ascending.
    names: Vec<String>,
    /// The symbols of each of them, in the order in which they were declared.
    known: Vec<Vec<usize>>,
}

impl Reader {
    fn token(&self, k: usize) -> Option<&Token> {
        self.code.get(k).map(|at| &self.document.tokens[*at])
    }

    fn text(&self, k: usize) -> &str {
        self.token(k).map_or("", |t| t.text(&self.document.text))
    }

    fn kind(&self, k: usize) -> Option<TokenKind> {
        self.token(k).map(|t| t.kind)
    }

    fn is_word(&self, k: usize) -> bool {
        self.kind(k) == Some(TokenKind::Word)
    }

    fn start(&self, k: usize) -> usize {
        self.token(k).map_or(self.document.text.len(), |t| t.range.start)
    }

    fn end(&self, k: usize) -> usize {
        self.token(k).map_or(self.document.text.len(), |t| t.range.end)
    }

    fn range(&self, k: usize) -> Range<usize> {
        self.start(k)..self.end(k)
    }

    /// Of an opening bracket, the one that closes it; the end of the text if there is none.
    fn close(&self, k: usize) -> usize {
        let partner = self.token(k).and_then(|t| t.partner);
        partner.map_or(self.code.len(), |at| self.code.partition_point(|k| *k < at))
    }

    /// The token after this one; after an opening bracket, what follows its partner.
    fn after(&self, k: usize) -> usize {
        if self.kind(k) == Some(TokenKind::Open) { self.close(k) + 1 } else { k + 1 }
    }

    /// The doc comment before a token, without its slashes.
    fn doc(&self, k: usize) -> String {
        let Some(at) = self.code.get(k) else { return String::new() };
        let before = self.document.tokens[..*at].iter().rev().take_while(|t| t.is_comment());
        let mut lines: Vec<&str> = before
            .filter(|t| t.kind == TokenKind::Doc && !t.text(&self.document.text).starts_with("//!"))
            .map(|t| {
                let text = t.text(&self.document.text);
                let text = text.trim_start_matches("///").trim_start_matches("/**").trim_end_matches("*/");
                text.strip_prefix(' ').unwrap_or(text)
            })
            .collect();
        lines.reverse();
        lines.join("\n")
    }

    fn declare(
        &mut self,
        name: usize,
        kind: SymbolKind,
        scope: Range<usize>,
        whole: Range<usize>,
        doc: String,
    ) -> usize {
        let symbol =
            Symbol { name: self.text(name).to_string(), kind, place: self.range(name), scope, whole, doc };
        let position = self.document.symbols.len();
        if let Ok(k) = self.names.binary_search(&symbol.name) {
            self.known[k].push(position);
        }
        self.document.symbols.push(symbol);
        position
    }

    /// The symbols of a name, the last one first.
    fn named(&self, name: &str) -> impl Iterator<Item = usize> {
        let k = self.names.binary_search_by(|known| known.as_str().cmp(name)).ok();
        k.into_iter().flat_map(|k| &self.known[k]).rev().copied()
    }

    /// The symbol of a name that is declared in an item.
    fn in_item(&self, name: &str, scope: &Range<usize>) -> Option<usize> {
        let symbols = &self.document.symbols;
        self.named(name)
            .take_while(|s| symbols[*s].place.start >= scope.start || symbols[*s].kind.is_item())
            .find(|s| symbols[*s].scope == *scope)
    }

    fn items(&mut self) {
        let mut k = 0;
        while k < self.code.len() {
            k = match self.text(k) {
                "use" => self.import(k),
                "family" | "theorem" | "join" if self.is_word(k + 1) => self.item(k),
                _ => self.after(k),
            };
        }
    }

    fn import(&mut self, k: usize) -> usize {
        let library = self.text(k + 1) == "library";
        let path = k + 1 + usize::from(library);
        if self.kind(path) == Some(TokenKind::Quoted) {
            let place = self.range(path);
            let path = self.text(path).trim_matches('"').to_string();
            self.document.imports.push(Import { path, library, place });
        }
        path + 1
    }

    fn item(&mut self, k: usize) -> usize {
        let kind = match self.text(k) {
            "family" => SymbolKind::Family,
            "theorem" => SymbolKind::Theorem,
            _ => SymbolKind::Join,
        };
        let mut open = k + 2;
        if self.text(open) == "(" {
            open = self.after(open);
        }
        if self.text(open) != "{" {
            return k + 2;
        }
        let close = self.close(open);
        let whole = self.start(k)..self.end(close);
        let doc = self.doc(k);
        let all = 0..self.document.text.len();
        let symbol = self.declare(k + 1, kind, all, whole.clone(), doc);
        let body = self.end(open)..self.start(close);
        let scope = self.start(k + 2)..whole.end;
        self.loops(k + 2, open, &scope, SymbolKind::Order);
        let mut children = Vec::new();
        let mut at = open + 1;
        while at < close.min(self.code.len()) {
            let (end, entry) = self.statement(at, close, kind, &scope);
            children.push(entry);
            at = end;
        }
        let entry = Entry {
            title: self.document.symbols[symbol].name.clone(),
            symbol: Some(symbol),
            whole,
            name: self.range(k + 1),
            body: Some(body),
            children,
        };
        self.document.entries.push(entry);
        close + 1
    }

    /// The position after a statement, and what it is.
    fn statement(
        &mut self,
        first: usize,
        limit: usize,
        item: SymbolKind,
        scope: &Range<usize>,
    ) -> (usize, Entry) {
        let mut last = first;
        let mut block = None;
        loop {
            if self.text(last) == ";" {
                break;
            }
            if self.text(last) == "{" {
                block = Some(last);
                last = self.close(last);
                break;
            }
            let next = self.after(last);
            if next >= limit || is_keyword(self.text(next)) && next > first && self.begins_line(next) {
                last = next - 1;
                break;
            }
            last = next;
        }
        let last = last.min(limit.saturating_sub(1)).max(first);
        let end = last + 1;
        let whole = self.start(first)..self.end(last);
        let symbol = self.declared(first, end, item, scope, &whole);
        let line = one_line(self.document.slice(&whole));
        let title = match block {
            Some(open) => one_line(self.document.slice(&(whole.start..self.start(open)))),
            None => line.trim_end_matches(';').to_string(),
        };
        let body = block.map(|open| self.end(open)..self.start(self.close(open)));
        self.loops(first, end, &whole, SymbolKind::Index);
        (end, Entry { title, symbol, whole, name: self.range(first), body, children: Vec::new() })
    }

    /// Whether a token is the first one on its line.
    fn begins_line(&self, k: usize) -> bool {
        k == 0 || self.document.text[self.end(k - 1)..self.start(k)].contains('\n')
    }

    /// Declares what a statement declares, and returns the first symbol.
    fn declared(
        &mut self,
        first: usize,
        end: usize,
        item: SymbolKind,
        scope: &Range<usize>,
        whole: &Range<usize>,
    ) -> Option<usize> {
        let doc = self.doc(first);
        let family = item == SymbolKind::Family;
        let before = self.document.symbols.len();
        match self.text(first) {
            "domain" if family => {
                for k in self.ranged(first + 1, end) {
                    self.declare_once(k, SymbolKind::Domain, scope, whole, &doc);
                }
            }
            "shape" if family => {
                for k in self.ranged(first + 1, end) {
                    self.declare_once(k, SymbolKind::Shape, scope, whole, &doc);
                }
            }
            "scalar" if !family => {
                for k in self.ranged(first + 1, end) {
                    self.declare_once(k, SymbolKind::Scalar, scope, whole, &doc);
                }
            }
            "curve" | "surface" | "patch" if !family && self.is_word(first + 1) => {
                self.declare_once(first + 1, SymbolKind::Patch, scope, whole, &doc);
            }
            "let" if self.is_word(first + 1) => {
                self.declare_once(first + 1, SymbolKind::Let, scope, whole, &doc);
                // The arguments of a name.
                if family && self.text(first + 2) == "(" {
                    let close = self.close(first + 2);
                    for k in first + 3..close {
                        if self.is_word(k) {
                            self.declare(k, SymbolKind::Index, whole.clone(), whole.clone(), String::new());
                        }
                    }
                }
            }
            "base" if family => {
                let open = (first..end).find(|k| self.text(*k) == "{").unwrap_or(end);
                let mut k = open + 1;
                while k < end {
                    let name = if self.text(k) == "permute" { k + 1 } else { k };
                    if self.is_word(name) && self.text(name + 1) == "[" {
                        self.declare_once(name, SymbolKind::Functions, scope, whole, &doc);
                    }
                    while k < end && self.text(k) != ";" {
                        k = self.after(k);
                    }
                    k += 1;
                }
            }
            word if family => {
                let name = if matches!(word, "permute" | "raise") { first + 1 } else { first };
                if self.is_word(name) && self.text(name + 1) == "[" && self.text(self.after(name + 1)) == "="
                {
                    self.declare_once(name, SymbolKind::Functions, scope, whole, &doc);
                }
            }
            _ => {}
        }
        (before < self.document.symbols.len()).then_some(before).or_else(|| {
            // Another function of the same family.
            let moved = matches!(self.text(first), "permute" | "raise");
            let known = self.in_item(self.text(first + usize::from(moved)), scope)?;
            let function = self.document.symbols[known].kind == SymbolKind::Functions;
            (function && (moved || !is_keyword(self.text(first)))).then_some(known)
        })
    }

    /// Declares a name in an item unless it is declared there.
    fn declare_once(
        &mut self,
        k: usize,
        kind: SymbolKind,
        scope: &Range<usize>,
        whole: &Range<usize>,
        doc: &str,
    ) {
        let name = self.text(k);
        if word(name).is_some() && kind != SymbolKind::Patch {
            return;
        }
        if self.in_item(name, scope).is_none() {
            self.declare(k, kind, scope.clone(), whole.clone(), doc.to_string());
        }
    }

    /// The names between comparisons, `λ` in `-3 <= λ <= 1`, of a list of ranges; the coordinates of a simplex.
    fn ranged(&self, from: usize, to: usize) -> Vec<usize> {
        let mut names = Vec::new();
        let mut start = from;
        while start < to {
            let mut parts: Vec<(usize, usize)> = Vec::new();
            let (mut k, mut begin) = (start, start);
            while k < to && !matches!(self.text(k), "," | ";" | "for") {
                if matches!(self.text(k), "<" | "<=" | ">" | ">=") {
                    parts.push((begin, k));
                    begin = k + 1;
                }
                k = self.after(k);
            }
            parts.push((begin, k));
            if matches!(self.text(start), "triangle" | "tetrahedron") && self.text(start + 1) == "(" {
                names.extend((start + 2..self.close(start + 1)).filter(|k| self.is_word(*k)));
            } else {
                let name = |part: &(usize, usize)| {
                    let single = part.1 == part.0 + 1
                        || self.text(part.0 + 1) == "[" && self.after(part.0 + 1) == part.1;
                    (single && self.is_word(part.0)).then_some(part.0)
                };
                match parts.as_slice() {
                    [_, middle @ .., _] if !middle.is_empty() => names.extend(middle.iter().filter_map(name)),
                    all => names.extend(all.iter().filter_map(name).take(1)),
                }
            }
            if self.text(k) == "for" {
                break;
            }
            start = k + 1;
        }
        names
    }

    /// Declares the variables before each `in`: in the brackets around them, outside of all in `scope`.
    fn loops(&mut self, from: usize, to: usize, scope: &Range<usize>, kind: SymbolKind) {
        let mut around: Vec<usize> = Vec::new();
        for k in from..to.min(self.code.len()) {
            match self.kind(k) {
                Some(TokenKind::Open) => around.push(k),
                Some(TokenKind::Close) => {
                    around.pop();
                }
                _ => {}
            }
            if self.text(k) != "in" || k == from {
                continue;
            }
            let mut names = Vec::new();
            let mut at = k - 1;
            while at >= from && self.is_word(at) && word(self.text(at)).is_none() {
                names.push(at);
                if at < from + 2 || self.text(at - 1) != "," || !self.is_word(at - 2) {
                    break;
                }
                at -= 2;
            }
            let inner = match around.last() {
                Some(open) if kind == SymbolKind::Index => self.inner(*open, k, to),
                _ => scope.clone(),
            };
            for name in names.into_iter().rev() {
                self.declare(name, kind, inner.clone(), inner.clone(), String::new());
            }
        }
    }

    /// Where the variables of a loop at `k` inside of a bracket are visible: in the bracket, of a block in the
    /// statement.
    fn inner(&self, open: usize, k: usize, to: usize) -> Range<usize> {
        let close = self.close(open);
        if self.text(open) != "{" {
            return self.start(open)..self.end(close);
        }
        let mut first = k;
        while first > open + 1 && self.text(first - 1) != ";" {
            first -= 1;
        }
        let last = (k..to.min(close)).find(|k| self.text(*k) == ";").unwrap_or(close);
        self.start(first)..self.end(last)
    }

    /// Finds what every word names.
    fn names(&mut self) {
        sort_by_key(&mut self.document.entries, |e| e.whole.start);
        for k in 0..self.code.len() {
            if !self.is_word(k) {
                continue;
            }
            let name = self.text(k).to_string();
            let range = self.range(k);
            let mut best = self.meant(&name, &range);
            if best.is_none() && word(&name).is_some() {
                continue;
            }
            if best.is_none()
                && let Some(scalar) = self.implied(k)
            {
                best = Some(scalar);
            }
            let declared = best.is_some_and(|s| self.document.symbols[s].place == range);
            let defines = best
                .is_some_and(|s| self.document.symbols[s].kind == SymbolKind::Functions && self.defines(k));
            let role = if declared || defines { Role::Declared } else { Role::Named };
            self.document.occurrences.push(Occurrence { range, symbol: best, role });
        }
    }

    /// What a name at a place means: of several symbols the innermost one.
    fn meant(&self, name: &str, range: &Range<usize>) -> Option<usize> {
        let item = self.document.entry(range.start);
        let from = item.map_or(0, |item| item.whole.start);
        let mut best: Option<usize> = None;
        for s in self.named(name) {
            let symbol = &self.document.symbols[s];
            let seen = symbol.scope.start <= range.start && range.end <= symbol.scope.end;
            let inner = best.is_none_or(|other| {
                let other = &self.document.symbols[other].scope;
                other.end - other.start > symbol.scope.end - symbol.scope.start
            });
            if seen && inner {
                best = Some(s);
            }
            // What was declared before the item has a scope of its own, or is an item.
            if symbol.place.end < from && best.is_some() {
                break;
            }
        }
        best
    }

    /// Whether `b[1] = …` stands at a name, as a statement.
    fn defines(&self, k: usize) -> bool {
        let starts = k == 0 || matches!(self.text(k - 1), ";" | "{" | "}" | "raise" | "permute");
        let inside = self.document.entry(self.start(k)).and_then(|e| e.statement(self.start(k)));
        let claim =
            inside.is_some_and(|c| matches!(self.document.slice(&c.name), "prove" | "refute" | "conjecture"));
        starts && !claim && self.text(k + 1) == "[" && self.text(self.after(k + 1)) == "="
    }

    /// In a theorem, a new name in a shape value is a scalar.
    fn implied(&mut self, k: usize) -> Option<usize> {
        let entry = self.document.entry(self.start(k))?;
        let item = self.document.symbols[entry.symbol?].kind;
        let statement = entry.statement(self.start(k))?;
        let patch = matches!(self.document.slice(&statement.name), "curve" | "surface" | "patch");
        // Families stand before a bracket, shape values inside of one.
        let family = self.text(k + 1) == "(" || !self.is_inside(k, statement);
        if !matches!(item, SymbolKind::Theorem | SymbolKind::Join) || !patch || family {
            return None;
        }
        let (scope, whole) = (entry.whole.clone(), statement.whole.clone());
        Some(self.declare(k, SymbolKind::Scalar, scope, whole, String::new()))
    }

    /// Whether a token of a statement stands in round brackets.
    fn is_inside(&self, k: usize, statement: &Entry) -> bool {
        let first =
            self.code.partition_point(|at| self.document.tokens[*at].range.start < statement.whole.start);
        (first..k).any(|open| self.text(open) == "(" && self.close(open) > k)
    }
}

/// Whether a word begins a statement.
fn is_keyword(text: &str) -> bool {
    use super::vocabulary::WordKind::{EitherStatement, Item, Statement, TheoremStatement};
    word(text).is_some_and(|w| matches!(w.kind, Statement | TheoremStatement | EitherStatement | Item))
}

/// A text with one space in place of all that separates two words, without comments.
fn one_line(text: &str) -> String {
    let mut line = String::new();
    let mut end = 0;
    for token in tokens(text).iter().filter(|t| !t.is_comment()) {
        if !line.is_empty() && token.range.start > end {
            line.push(' ');
        }
        line += token.text(text);
        end = token.range.end;
    }
    line
}
