//! Single words, doc comments, and what is skipped after a mistake.

use basis_prover::collections::list::Listed;
use proc_macro2::{Delimiter, LineColumn, Span, TokenTree};
use std::rc::Rc;
use syn::buffer::Cursor;
use syn::parse::ParseStream;
use syn::{Result, Token};

use super::error::error;
use super::tokens::{comparison, unexpected};
use super::{Comparison, Name};

/// The properties that are claimed by a word.
pub(super) const PROPERTIES: [&str; 8] = [
    "partition_of_unity",
    "nonnegative",
    "symmetric",
    "independent",
    "continuity",
    "smooth",
    "totally_positive",
    "rounding",
];

/// Whether the next token is this word.
pub(super) fn at_word(input: ParseStream<'_>, word: &str) -> bool {
    input.cursor().ident().is_some_and(|(ident, _)| ident == word)
}

/// Takes the next token, which is a word; its span.
pub(super) fn take_word(input: ParseStream<'_>) -> Result<Span> {
    use syn::ext::IdentExt;
    Ok(input.call(syn::Ident::parse_any)?.span())
}

/// `=` between a name and its value.
pub(super) fn equals(input: ParseStream<'_>, name: &Name) -> Result<()> {
    let at = input.span();
    match comparison(input)? {
        Some(Comparison::Equal) => Ok(()),
        Some(other) => {
            let message = format!("expected `=` after `{}`, found `{}`", name.text, other.symbol());
            Err(error(at, message, "write `=`: a value stands here, and no range"))
        }
        _ => {
            let found = unexpected(input, &format!("`=` after `{}`", name.text));
            let help = if input.peek(Token![:]) && input.peek2(Token![=]) {
                "write `=`"
            } else if input.peek(syn::token::Paren) {
                "leave the argument out: functions are those of the domain variable"
            } else if name.text == "mut" {
                "names keep their values: `let c = 1;`"
            } else if input.peek(Token![:]) {
                "write `=`; types are not written, every value is exact: `let c = 1/2;`"
            } else if input.peek(Token![->]) || input.peek(Token![=>]) {
                "write `=`: the left name has the value on the right"
            } else if input.is_empty() || input.peek(Token![;]) || input.peek(Token![,]) {
                let help = format!("write its value, `{} = 0`", name.text);
                return Err(error(found.span(), found.to_string(), help));
            } else {
                return Err(found);
            };
            Err(error(found.span(), found.to_string(), help))
        }
    }
}

/// Refuses `=` behind a word that a number follows.
pub(super) fn no_equals(input: ParseStream<'_>, instead: &str) -> Result<()> {
    if !input.peek(Token![=]) {
        return Ok(());
    }
    Err(error(input.span(), unexpected(input, "a number").to_string(), format!("write `{instead};`")))
}

/// The tokens from one place of a file to another as they are written, in one line: with one space wherever space, a
/// line end or a comment separates two of them.
pub(super) fn text_of(from: Cursor<'_>, to: Cursor<'_>) -> Rc<str> {
    let mut line = Line::default();
    let mut at = from;
    while at < to
        && let Some((token, after)) = at.token_tree()
    {
        line.token(token);
        at = after;
    }
    line.text.into()
}

/// Tokens as they are written, with one space in place of all that separates two of them.
#[derive(Default)]
struct Line {
    text: String,
    /// Where the last token ends.
    end: Option<LineColumn>,
}

impl Line {
    fn token(&mut self, token: TokenTree) {
        let TokenTree::Group(group) = token else {
            return self.word(&token.to_string(), token.span());
        };
        let (open, close) = match group.delimiter() {
            Delimiter::Parenthesis => ("(", ")"),
            Delimiter::Brace => ("{", "}"),
            Delimiter::Bracket => ("[", "]"),
            Delimiter::None => ("", ""),
        };
        if !open.is_empty() {
            self.word(open, group.span_open());
        }
        for token in group.stream() {
            self.token(token);
        }
        if !close.is_empty() {
            self.word(close, group.span_close());
        }
    }

    fn word(&mut self, word: &str, span: Span) {
        let in_word = |c: char| c.is_alphanumeric() || c == '_';
        // Tokens of a `macro_rules` may stand anywhere, but never make one word of two.
        let merges = self.text.ends_with(in_word) && word.starts_with(in_word);
        if self.end.is_some_and(|end| merges || end != span.start()) {
            self.text.push(' ');
        }
        self.text += word;
        self.end = Some(span.end());
    }
}

/// Goes on after the next `;`, or after a block.
pub(super) fn skip_statement(input: ParseStream<'_>) {
    while let Some((token, _)) = input.cursor().token_tree() {
        // The token was seen, so it can be taken.
        let _ = input.parse::<TokenTree>();
        match token {
            TokenTree::Punct(p) if p.as_char() == ';' => return,
            // Cases as programs have them, `if c { x } else { y } for i in 0..=n;`, are one statement.
            TokenTree::Group(g)
                if g.delimiter() == Delimiter::Brace
                    && !["else", "for", "if"].iter().any(|word| at_word(input, word)) =>
            {
                let _ = input.parse::<Option<Token![;]>>();
                return;
            }
            _ => {}
        }
    }
}

/// How a doc comment is written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Doc {
    /// `///`, before what it is about.
    Outer,
    /// `//!`, at the top of a spec.
    Inner,
}

/// The lines of the doc comment of that kind that stands here, if one does.
pub(super) fn doc(input: ParseStream<'_>, kind: Doc) -> Result<Vec<String>> {
    let mut lines = Vec::new();
    while input.peek(Token![#]) && input.peek2(Token![!]) == (kind == Doc::Inner) {
        let hash = input.parse::<Token![#]>()?;
        if kind == Doc::Inner {
            input.parse::<Token![!]>()?;
        }
        let content;
        syn::bracketed!(content in input);
        if !at_word(&content, "doc") {
            return Err(error(
                hash.span,
                "attributes have no meaning in a spec",
                "remove it, or write a doc comment, `/// …`",
            ));
        }
        take_word(&content)?;
        content.parse::<Token![=]>()?;
        let text: syn::LitStr = content.parse()?;
        // A block comment is one string with several lines, an empty line between paragraphs one with none.
        let text = text.value();
        let written = if text.is_empty() { vec![""] } else { text.lines().listed() };
        lines.extend(
            written.into_iter().map(|line| line.strip_prefix(' ').unwrap_or(line).trim_end().to_string()),
        );
    }
    Ok(lines)
}

/// The names in the tokens from one place to a later one; an empty one stands for a name that is missing where a
/// statement declares one.
pub(super) fn names_between(start: ParseStream<'_>, end: ParseStream<'_>, names: &mut Vec<String>) {
    // What went wrong in a doc comment has no names.
    let _ = doc(start, Doc::Outer);
    let before = names.len();
    let named = ["let", "curve", "surface"].iter().any(|word| at_word(start, word));
    let mut position = 0;
    while start.cursor() != end.cursor()
        && let Ok(token) = start.parse::<TokenTree>()
    {
        if named && position == 1 && !matches!(token, TokenTree::Ident(_)) {
            names.push(String::new());
        }
        names_in(token, names);
        position += 1;
    }
    if names.len() == before + 1 {
        names.push(String::new());
    }
}

fn names_in(token: TokenTree, names: &mut Vec<String>) {
    match token {
        TokenTree::Ident(ident) => names.push(ident.to_string()),
        TokenTree::Group(group) => group.stream().into_iter().for_each(|token| names_in(token, names)),
        TokenTree::Punct(_) | TokenTree::Literal(_) => {}
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenTree;
    use syn::parse::{ParseStream, Parser};

    fn line(input: ParseStream<'_>) -> syn::Result<String> {
        let from = input.cursor();
        while !input.is_empty() {
            input.parse::<TokenTree>()?;
        }
        Ok(super::text_of(from, input.cursor()).to_string())
    }

    #[test]
    fn tokens_in_one_line() {
        let written = |text: &str| line.parse_str(text).expect("tokens");
        assert_eq!(written("b[ i ]>=0   for i in 0..=n"), "b[ i ]>=0 for i in 0..=n");
        assert_eq!(written("D(b[0])  // prove ; here\n\t== [ 1,0 ]"), "D(b[0]) == [ 1,0 ]");
        assert_eq!(written("λ /* of // b */ * (1 -t)"), "λ * (1 -t)");
    }

    #[test]
    fn two_words_stay_apart() {
        // As of a `macro_rules`: every token stands at the same place.
        let text = line.parse2(quote::quote!(b[i] >= 0 for i in 0..=n)).expect("tokens");
        assert!(text.contains("0 for i in 0"), "{text}");
    }
}
