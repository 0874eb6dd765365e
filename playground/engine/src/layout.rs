//! Rust tokens as lines: one statement or item on each, indented by the braces around it, documentation as comments.

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

const INDENT: &str = "    ";
/// Lists longer than this many characters stand on lines of their own.
const WIDTH: usize = 96;

/// The text of a file.
pub(crate) fn text(tokens: TokenStream) -> String {
    let mut out = Printer::default();
    out.block(tokens);
    out.end_line();
    out.done
}

#[derive(Default)]
struct Printer {
    done: String,
    line: String,
    depth: usize,
    /// Whether the next token follows the last one without a space.
    tight: bool,
}

impl Printer {
    fn end_line(&mut self) {
        let line = self.line.trim();
        if !line.is_empty() {
            // An empty line after each function.
            let starts = ["///", "#[", "pub fn ", "fn "].iter().any(|word| line.starts_with(word));
            if starts && self.done.lines().next_back().is_some_and(|last| last.trim() == "}") {
                self.done.push('\n');
            }
            self.done += &INDENT.repeat(self.depth);
            self.done += line;
            self.done.push('\n');
        }
        self.line.clear();
        self.tight = false;
    }

    /// How many `<` of the line have no `>`.
    fn angles(&self) -> usize {
        let line = self.line.replace("->", "").replace("=>", "");
        let count = |c| line.matches(c).count();
        usize::saturating_sub(count('<'), count('>'))
    }

    fn word(&mut self, word: &str, before: bool) {
        if before && !self.tight && !self.line.is_empty() && !self.line.ends_with(' ') {
            self.line.push(' ');
        }
        self.line += word;
        self.tight = false;
    }

    /// Statements or items.
    fn block(&mut self, tokens: TokenStream) {
        let all: Vec<TokenTree> = tokens.into_iter().collect();
        let mut k = 0;
        while k < all.len() {
            if let Some(text) = documentation(&all[k..]) {
                self.end_line();
                for line in text.lines() {
                    self.line = format!("///{line}");
                    self.end_line();
                }
                if text.is_empty() {
                    self.line = String::from("///");
                    self.end_line();
                }
                k += 2;
                continue;
            }
            let next = all.get(k + 1);
            match &all[k] {
                TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                    self.braces(group.stream(), next);
                }
                token => self.token(token, next),
            }
            let attribute = matches!((&all[k], k.checked_sub(1).and_then(|k| all.get(k))),
                (TokenTree::Group(group), Some(TokenTree::Punct(hash)))
                    if group.delimiter() == Delimiter::Bracket && hash.as_char() == '#');
            let ends = match &all[k] {
                TokenTree::Punct(p) => p.as_char() == ';' || p.as_char() == ',' && self.angles() == 0,
                _ => attribute,
            };
            if ends {
                self.end_line();
            }
            k += 1;
        }
    }

    /// What stands between braces, on lines of its own, and what follows the closing one.
    fn braces(&mut self, inner: TokenStream, next: Option<&TokenTree>) {
        if inner.is_empty() {
            self.word("{}", true);
        } else {
            self.word("{", true);
            self.end_line();
            self.depth += 1;
            self.block(inner);
            self.end_line();
            self.depth -= 1;
            self.line = String::from("}");
        }
        let goes_on = match next {
            Some(TokenTree::Punct(p)) => ";,.?)".contains(p.as_char()),
            Some(TokenTree::Ident(word)) => word == "else",
            _ => false,
        };
        if !goes_on {
            self.end_line();
        }
    }

    fn token(&mut self, token: &TokenTree, next: Option<&TokenTree>) {
        match token {
            TokenTree::Ident(word) => self.word(&word.to_string(), true),
            TokenTree::Literal(literal) => self.word(&literal.to_string(), true),
            TokenTree::Punct(p) => {
                let c = p.as_char();
                let joint = p.spacing() == Spacing::Joint;
                let path = c == ':' && (self.line.ends_with(':') || joint);
                let unary =
                    "&*-!".contains(c) && self.line.trim_end().ends_with(['(', '[', '=', ',', '{', '&']);
                let before = !(";,.?:".contains(c)
                    || self.line.ends_with(':') && path
                    || c == '>' && self.line.ends_with(|c: char| c.is_alphanumeric() || c == '>')
                    || c == '<'
                        && self.line.ends_with(|c: char| c.is_alphanumeric() || c == ':' || c == '_')
                    || c == '!' && matches!(next, Some(TokenTree::Group(_))));
                let path_start =
                    path && !self.line.ends_with(':') && self.line.ends_with([' ', ',', '=', '>', '+']);
                self.word(&c.to_string(), before || path_start);
                self.tight = ".#'".contains(c)
                    || unary
                    || joint
                    || path
                    || c == '<' && !self.line.ends_with(" <")
                    || c == '&' && !self.line.ends_with(" && &");
            }
            TokenTree::Group(group) => self.list(group.delimiter(), group.stream()),
        }
    }

    /// What stands between round or square brackets.
    fn list(&mut self, delimiter: Delimiter, inner: TokenStream) {
        let (open, close) = match delimiter {
            Delimiter::Parenthesis => ("(", ")"),
            Delimiter::Bracket => ("[", "]"),
            Delimiter::Brace => ("{", "}"),
            Delimiter::None => ("", ""),
        };
        let after_word = self.line.ends_with(|c: char| c.is_alphanumeric() || "_])>!#".contains(c));
        let keyword = ["return", "in", "if", "match", "let", "mut", "as", "->"]
            .iter()
            .any(|word| self.line.trim_end().ends_with(&format!(" {word}")) || self.line.trim_end() == *word);
        self.word(open, !after_word || keyword);
        self.tight = true;
        let all: Vec<TokenTree> = inner.into_iter().collect();
        let long = all.iter().map(|t| t.to_string().len() + 1).sum::<usize>() + self.line.len() > WIDTH
            && all.iter().any(|t| matches!(t, TokenTree::Punct(p) if p.as_char() == ','));
        if long {
            self.end_line();
            self.depth += 1;
            for (k, token) in all.iter().enumerate() {
                self.inline(token, all.get(k + 1));
                if matches!(token, TokenTree::Punct(p) if p.as_char() == ',') && self.line.len() > WIDTH / 2 {
                    self.end_line();
                }
            }
            self.end_line();
            self.depth -= 1;
        } else {
            for (k, token) in all.iter().enumerate() {
                self.inline(token, all.get(k + 1));
            }
        }
        self.tight = true;
        self.word(close, false);
    }

    fn inline(&mut self, token: &TokenTree, next: Option<&TokenTree>) {
        match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                self.braces(
                    group.stream(),
                    Some(&TokenTree::Punct(proc_macro2::Punct::new(',', Spacing::Alone))),
                );
            }
            token => self.token(token, next),
        }
    }
}

/// The text of `#[doc = "…"]`.
fn documentation(tokens: &[TokenTree]) -> Option<String> {
    let [TokenTree::Punct(hash), TokenTree::Group(group), ..] = tokens else { return None };
    if hash.as_char() != '#' || group.delimiter() != Delimiter::Bracket {
        return None;
    }
    let inner: Vec<TokenTree> = group.stream().into_iter().collect();
    let [TokenTree::Ident(doc), TokenTree::Punct(_), TokenTree::Literal(text)] = inner.as_slice() else {
        return None;
    };
    (doc == "doc").then(|| unquoted(&text.to_string()))
}

/// The text that a literal string stands for.
fn unquoted(literal: &str) -> String {
    if let Some(raw) = literal.strip_prefix("r\"").and_then(|t| t.strip_suffix('"')) {
        return String::from(raw);
    }
    let inner = literal.strip_prefix('"').and_then(|t| t.strip_suffix('"')).unwrap_or(literal);
    let mut text = String::new();
    let mut escaped = false;
    for c in inner.chars() {
        match (escaped, c) {
            (false, '\\') => escaped = true,
            (true, 'n') => {
                text.push('\n');
                escaped = false;
            }
            _ => {
                text.push(c);
                escaped = false;
            }
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The tokens as words, whatever stands between them; documentation by its lines.
    fn words(tokens: TokenStream, all: &mut Vec<String>) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut k = 0;
        while k < tokens.len() {
            if let Some(text) = documentation(&tokens[k..]) {
                all.extend(text.split('\n').map(|line| format!("///{line}")));
                k += 2;
                continue;
            }
            match &tokens[k] {
                TokenTree::Group(group) => {
                    all.push(format!("{:?}", group.delimiter()));
                    words(group.stream(), all);
                    all.push(String::from("end"));
                }
                token => all.push(token.to_string()),
            }
            k += 1;
        }
    }

    #[test]
    fn all_code_of_the_library_is_the_same_when_it_is_read_again() {
        use basis_engine::emit::{Job, Wanted, rust};
        use basis_engine::{Library, Prover, Selected, Source, decide};
        let mut count = 0;
        for (name, text) in basis_specs::SPECS.iter().filter(|(name, _)| !name.contains('/')) {
            let source = Source::text(*name, &crate::session::alone(name, text));
            let library = Library::from_source(&crate::text::NoFiles, &Prover, source);
            for item in library.items(Selected::WithoutOrder) {
                let items = [Wanted { checked: decide(item), name: None }];
                let job = Job { items: &items, spec: name, command: "basis emit" };
                let Ok(tokens) = rust::items(&job, &[]) else { continue };
                let printed = super::text(tokens.clone());
                let (mut before, mut after) = (Vec::new(), Vec::new());
                words(tokens, &mut before);
                words(printed.parse().expect("it is Rust"), &mut after);
                let differs = before.iter().zip(&after).position(|(a, b)| a != b);
                assert_eq!(differs.map(|k| (&before[k], &after[k])), None, "{name}");
                assert_eq!(before.len(), after.len(), "{name}");
                assert!(printed.lines().all(|line| line.trim_end() == line), "{name}");
                count += 1;
            }
        }
        assert!(count > 10, "{count} families");
    }
}
