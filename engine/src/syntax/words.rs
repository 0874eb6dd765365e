//! Single words, doc comments, and what is skipped after a mistake.

use basis_prover::collections::list::Listed;
use proc_macro2::{Delimiter, Span, TokenTree};
use syn::parse::ParseStream;
use syn::{Result, Token};

use super::error::error;
use super::expr::{comparison, unexpected};
use super::{Comparison, Name};

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
    match comparison(input)? {
        Some(Comparison::Equal) => Ok(()),
        _ => Err(unexpected(input, &format!("`=` after `{}`", name.text))),
    }
}

/// Goes on after the next `;`, or after a block.
pub(super) fn skip_statement(input: ParseStream<'_>) {
    while let Some((token, _)) = input.cursor().token_tree() {
        // The token was seen, so it can be taken.
        let _ = input.parse::<TokenTree>();
        match token {
            TokenTree::Punct(p) if p.as_char() == ';' => return,
            TokenTree::Group(g) if g.delimiter() == Delimiter::Brace => return,
            _ => {}
        }
    }
}

/// The lines of the doc comment that stands here, if one does: `///` or, with `inner`, `//!`.
pub(super) fn doc(input: ParseStream<'_>, inner: bool) -> Result<Vec<String>> {
    let mut lines = Vec::new();
    while input.peek(Token![#]) && input.peek2(Token![!]) == inner {
        let hash = input.parse::<Token![#]>()?;
        if inner {
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
    let _ = doc(start, false);
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
