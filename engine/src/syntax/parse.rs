//! From a text or from tokens to the syntax tree, with all mistakes on the way.

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::Token;
use syn::parse::{ParseStream, Parser};

use super::error::{SyntaxError, SyntaxErrors, SyntaxPlace, error};
use super::statements::family;
use super::tokens::{at_file_doc, unexpected};
use super::words::{Doc, at_word, doc, take_word};
use super::{Family, Home, Item, Spec, StatementKind, Theorem, Use, glyphs};
use crate::advice::{did_you_mean, translated};
use crate::source::MAX_BYTES;
use basis_prover::collections::sort::sort_unique;

/// The words that begin an item.
const ITEMS: [&str; 4] = ["family", "use", "theorem", "join"];

const ITEM_HELP: &str =
    "an item is `family Name { … }`, `theorem Name { … }`, `join Name { … }` or `use \"file.basis\";`";

/// Words with which statements begin, and in what they stand.
const INSIDE: [(&str, &str); 2] = [
    (
        "curve surface patch scalar dimension",
        "this belongs to a theorem, `theorem Name { curve P = Bernstein(3); … }`",
    ),
    (
        "domain shape let prove refute conjecture b assume permute base raise budget",
        "this belongs to a family, `family Name { domain 0 <= t <= 1; b[0] = 1 - t; … }`, or a theorem",
    ),
];

/// Makes proc-macro2 lex and join spans by itself, so that a text has lines and columns inside of a
/// compiler too; back to the compiler's own tokens when it goes.
struct OwnLexer;

impl OwnLexer {
    fn start() -> Self {
        proc_macro2::fallback::force();
        Self
    }
}

impl Drop for OwnLexer {
    fn drop(&mut self) {
        proc_macro2::fallback::unforce();
    }
}

/// Reads a spec from a text. The spans of the tree are byte ranges of the text; they stay valid on this
/// thread only.
pub fn parse_text(text: &str) -> (Spec, SyntaxErrors) {
    if text.len() > MAX_BYTES {
        let message = format!("the spec is longer than {} MiB", MAX_BYTES >> 20);
        let help = Some(String::from("split it into several files"));
        return alone(vec![SyntaxError { place: SyntaxPlace::Bytes(0..0), message, help }]);
    }
    let _own = OwnLexer::start();
    let (mut errors, readable) = glyphs::check(text);
    let Some(readable) = readable else { return alone(errors) };
    match readable.text.parse::<TokenStream>() {
        Ok(tokens) => {
            let (mut spec, mut more) = parse(tokens);
            if errors.is_empty() {
                complain_if_empty(&spec, &mut more);
            }
            leave_out(&mut spec, &readable);
            let at_end = text.trim_end().len();
            for e in more.shown_mut() {
                if let SyntaxPlace::Token(span) = e.place {
                    let range = span.byte_range();
                    // The end of the input has no token; show the end of the text.
                    let range = if range.is_empty() { at_end..at_end } else { range };
                    e.place = SyntaxPlace::Bytes(range);
                }
            }
            // What follows from a gap in the same statement, or is said of a word before it, is not another error.
            let follows = |e: &SyntaxError| match &e.place {
                SyntaxPlace::Bytes(range) => readable.gaps.iter().any(|gap| {
                    let between = |from: usize, to: usize, ends: &[char]| {
                        readable.text.get(from..to).is_some_and(|between| !between.contains(ends))
                    };
                    (range.start..=range.end).contains(gap)
                        || between(*gap, range.start, &[';', '{', '}'])
                        || between(range.end, *gap, &[';', '{', '}', '\n'])
                }),
                SyntaxPlace::Token(_) => false,
            };
            more.retain(|e| !follows(e));
            (spec, more.after(errors))
        }
        Err(e) => {
            let range = e.span().byte_range();
            let range = if range.is_empty() { range.start..(range.start + 1).min(text.len()) } else { range };
            let shown: String = text.get(range.start..).unwrap_or_default().chars().take(1).collect();
            let message = format!("`{shown}` is not allowed here");
            let help =
                Some(String::from("a spec is made of names, numbers, operators, brackets and `//` comments"));
            errors.push(SyntaxError { place: SyntaxPlace::Bytes(range), message, help });
            alone(errors)
        }
    }
}

/// A text of which nothing is read but its mistakes.
fn alone(errors: Vec<SyntaxError>) -> (Spec, SyntaxErrors) {
    (Spec::default(), SyntaxErrors::default().after(errors))
}

/// Leaves out the statements in which something is missing; every one goes from its first token to the next statement.
fn leave_out(spec: &mut Spec, readable: &glyphs::Readable<'_>) {
    let gaps = &readable.gaps;
    // The words of a statement, some of which may be names that it declares.
    let words = |span: Span, unread: &mut Vec<String>| {
        let text = readable.text.get(span.byte_range()).unwrap_or_default();
        let words = text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty());
        unread.extend(words.map(String::from));
        sort_unique(unread);
    };
    let start = |span: Span| span.byte_range().start;
    let mut end = usize::MAX;
    let mut whole = |from: usize| {
        let until = core::mem::replace(&mut end, from);
        !gaps.iter().any(|gap| (from..until).contains(gap))
    };
    for item in spec.items.iter_mut().rev() {
        match item {
            Item::Use(written) => {
                whole(start(written.span));
            }
            Item::Family(Family { name, statements, incomplete, unread, .. }) => {
                for k in (0..statements.len()).rev() {
                    if !whole(start(statements[k].span)) {
                        let left_out = statements.remove(k);
                        if !matches!(left_out.kind, StatementKind::Claim(_)) {
                            *incomplete = true;
                            words(left_out.span, unread);
                        }
                    }
                }
                whole(start(name.span));
            }
            Item::Theorem(Theorem { name, statements, incomplete, unread, .. }) => {
                for k in (0..statements.len()).rev() {
                    if !whole(start(statements[k].span)) {
                        words(statements.remove(k).span, unread);
                        *incomplete = true;
                    }
                }
                whole(start(name.span));
            }
        }
    }
}

/// Reads a spec from the tokens of a macro call.
pub fn parse_tokens(tokens: TokenStream) -> (Spec, SyntaxErrors) {
    let (spec, mut errors) = parse(tokens);
    complain_if_empty(&spec, &mut errors);
    (spec, errors)
}

fn complain_if_empty(spec: &Spec, errors: &mut SyntaxErrors) {
    if spec.items.is_empty() && errors.is_empty() {
        errors.push(error(Span::call_site(), "the spec is empty", "write `family Name { … }`"));
    }
}

fn parse(tokens: TokenStream) -> (Spec, SyntaxErrors) {
    let mut errors = SyntaxErrors::default();
    let mut spec = Spec::default();
    let read = |input: ParseStream<'_>| -> syn::Result<()> {
        spec.doc = doc(input, Doc::Inner)?;
        while !input.is_empty() {
            let start = input.fork();
            match item(input, &mut errors) {
                Ok(item) => spec.items.push(item),
                Err(e) => {
                    errors.push(e);
                    skip_item(input);
                    // Names of items stand outside of brackets; an empty one stands for a name that is missing.
                    let before = spec.unread.len();
                    while start.cursor() != input.cursor()
                        && let Ok(token) = start.parse::<TokenTree>()
                    {
                        if let TokenTree::Ident(name) = token {
                            spec.unread.push(name.to_string());
                        }
                    }
                    if spec.unread.len() == before + 1 {
                        spec.unread.push(String::new());
                    }
                }
            }
        }
        sort_unique(&mut spec.unread);
        Ok(())
    };
    // What an error has left unread inside of brackets is not another error.
    if let Err(e) = Parser::parse2(read, tokens)
        && errors.is_empty()
    {
        errors.push(e);
    }
    (spec, errors)
}

fn item(input: ParseStream<'_>, errors: &mut SyntaxErrors) -> syn::Result<Item> {
    let doc = doc(input, Doc::Outer)?;
    if at_word(input, "family") {
        return Ok(Item::Family(family(input, doc, errors)?));
    }
    if at_word(input, "theorem") || at_word(input, "join") {
        return Ok(Item::Theorem(super::theorems::theorem(input, doc, errors)?));
    }
    if at_word(input, "use") {
        take_word(input)?;
        let (home, expected, help) = if at_word(input, "library") {
            take_word(input)?;
            let expected = "expected the name of a spec of the library in quotation marks";
            (Home::Library, expected, "write `use library \"quartic\";`")
        } else {
            (Home::Folder, "expected a path in quotation marks", "write `use \"quartic.basis\";`")
        };
        let name = input.cursor().ident().map(|(name, _)| name.to_string());
        let path: syn::LitStr = input.parse().map_err(|e| match &name {
            Some(name) => {
                let help = format!("write `use library \"{name}\";`, or `use \"{name}.basis\";` for a file");
                error(e.span(), expected, help)
            }
            None => error(e.span(), expected, help),
        })?;
        // Of a file this is said before; the compiler has its own words for escapes that it does not know.
        if path.token().to_string().contains('\\') {
            return Err(error(path.span(), glyphs::BACKSLASH, glyphs::SLASH));
        }
        if !input.peek(Token![;]) {
            return Err(error(path.span(), "expected `;` after the path", help));
        }
        input.parse::<Token![;]>()?;
        return Ok(Item::Use(Use { home, path: path.value(), span: path.span() }));
    }
    let expected = "`family`, `theorem`, `join` or `use`";
    let found = unexpected(input, expected);
    if at_file_doc(input) {
        return Err(found);
    }
    if input.peek(Token![;]) {
        return Err(error(input.span(), found.to_string(), "remove it: no `;` follows after `}`"));
    }
    let help = match input.cursor().ident() {
        Some((word, _)) => {
            let word = word.to_string();
            let otherwise = || translated(&word, &INSIDE).unwrap_or_else(|| String::from(ITEM_HELP));
            did_you_mean(&word, &ITEMS, &otherwise)
        }
        None => String::from(ITEM_HELP),
    };
    Err(error(input.span(), found.to_string(), help))
}

/// Goes on at the next word that begins an item, at least one token further.
fn skip_item(input: ParseStream<'_>) {
    while !input.is_empty() {
        // The token was seen, so it can be taken.
        let token = input.parse::<TokenTree>();
        let block =
            matches!(token, Ok(TokenTree::Group(ref g)) if g.delimiter() == proc_macro2::Delimiter::Brace);
        if block || ITEMS.iter().any(|word| at_word(input, word)) {
            return;
        }
    }
}
