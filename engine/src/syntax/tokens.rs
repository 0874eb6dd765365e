//! Tokens with a meaning of their own: names, exact numbers, signs of comparison; and what is said of a token that stands
//! where something else was expected.

use proc_macro2::{Delimiter, Literal, Span, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Ident, Result, Token};

use super::error::error;
use super::{Comparison, Name};
use crate::algebra::rational::{self, Rational};

/// Numbers with more digits than this are refused.
const MAX_DIGITS: usize = 1000;

/// Names with more letters than this are refused.
const MAX_LETTERS: usize = 200;

/// The span from one token to another; on compilers that cannot join spans the first one.
pub(super) fn join(a: Span, b: Span) -> Span {
    a.join(b).unwrap_or(a)
}

/// Whether a `//!` comment follows.
pub(super) fn at_file_doc(input: ParseStream<'_>) -> bool {
    input.peek(Token![#]) && input.peek2(Token![!]) && input.peek3(syn::token::Bracket)
}

/// What to write instead of one that is not the first thing in a file.
const FILE_DOC_HELP: &str =
    "it describes the whole file, at its top; write `///` above what is described, or `//`";

/// What stands where something else was expected.
pub(super) fn unexpected(input: ParseStream<'_>, expected: &str) -> syn::Error {
    match input.cursor().token_tree() {
        None => syn::Error::new(input.span(), format!("expected {expected}, but nothing follows")),
        Some((TokenTree::Group(g), _)) => {
            let open = match g.delimiter() {
                Delimiter::Parenthesis => "`(`",
                Delimiter::Bracket => "`[`",
                _ => "`{`",
            };
            syn::Error::new(g.span_open(), format!("expected {expected}, found {open}"))
        }
        Some((TokenTree::Punct(p), _)) if at_file_doc(input) => error(
            p.span(),
            format!("expected {expected}, found a comment that begins with `//!`"),
            FILE_DOC_HELP,
        ),
        // What a doc comment is made of is not what stands there.
        Some((TokenTree::Punct(p), _)) if p.as_char() == '#' && input.peek2(syn::token::Bracket) => {
            syn::Error::new(p.span(), format!("expected {expected}, found a doc comment"))
        }
        Some((token, _)) => syn::Error::new(token.span(), format!("expected {expected}, found `{token}`")),
    }
}

/// A name; the words of the language's own grammar are not names.
pub(super) fn name(input: ParseStream<'_>) -> Result<Name> {
    let Some((TokenTree::Ident(_), _)) = input.cursor().token_tree() else {
        return Err(unexpected(input, "a name"));
    };
    let ident = input.call(Ident::parse_any)?;
    let text = ident.to_string();
    if ["for", "in", "if", "let", "use", "crate", "as"].contains(&text.as_str()) || text.starts_with("r#") {
        return Err(error(
            ident.span(),
            format!("`{text}` is a word of the language, not a name"),
            "choose another name",
        ));
    }
    if text.len() > MAX_LETTERS && text.chars().count() > MAX_LETTERS {
        let help = format!("at most {MAX_LETTERS} letters are read");
        return Err(error(ident.span(), "the name is too long", help));
    }
    let plain = |c: char| match c {
        '\u{b5}' => 'μ',
        '\u{2126}' => 'Ω',
        c if c.is_ascii() => c,
        c => letter_of_formulas(c).unwrap_or(c),
    };
    Ok(Name { text: text.chars().map(plain).collect(), span: ident.span() })
}

/// What to write for `0,5`.
pub(super) const DECIMAL_POINT: &str = "a number has a decimal point: write `0.5`";

/// The letter that a character of the block for formulas stands for, such as λ for 𝜆: what is pasted from a PDF has them, and
/// they look like the plain ones.
fn letter_of_formulas(c: char) -> Option<char> {
    let number = c as u32;
    let nth = |first: char, k: u32| char::from_u32(first as u32 + k);
    match number {
        0x210e => Some('h'),
        0x1d400..=0x1d6a3 => match (number - 0x1d400) % 52 {
            k @ 0..26 => nth('A', k),
            k => nth('a', k - 26),
        },
        0x1d6a8..=0x1d7c9 => match (number - 0x1d6a8) % 58 {
            17 => Some('Θ'),
            25 | 51 => None,
            k @ 0..25 => nth('Α', k),
            k @ 26..51 => nth('α', k - 26),
            k => "εθκφρπ".chars().nth(k as usize - 52),
        },
        _ => None,
    }
}

/// An exact number: digits, perhaps with a decimal point.
pub(super) fn number(literal: &Literal) -> Result<Rational> {
    let text = literal.to_string();
    if text.len() > MAX_DIGITS {
        return Err(error(
            literal.span(),
            "the number has too many digits",
            format!("at most {MAX_DIGITS} are read"),
        ));
    }
    if let Some(value) = rational::from_decimal(&text) {
        return Ok(value);
    }
    let digits: String = text.chars().take_while(char::is_ascii_digit).collect();
    let rest = &text[digits.len()..];
    if digits.is_empty() {
        return Err(error(
            literal.span(),
            format!("expected a number, found {text}"),
            "numbers are written as 3, 1/3 or 0.62",
        ));
    }
    if rest.starts_with(['e', 'E'])
        && rest[1..].starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+')
    {
        return Err(error(
            literal.span(),
            format!("`{text}` is not an exact number of the language"),
            "write a power of ten, such as `3*10^6` or `1/10^6`",
        ));
    }
    if rest.starts_with(char::is_alphabetic) && digits != "0" {
        return Err(error(
            literal.span(),
            format!("an operator is missing in `{text}`"),
            format!("write `{digits}*{rest}`"),
        ));
    }
    Err(error(
        literal.span(),
        format!("`{text}` is not a number of the language"),
        "numbers are written as 3, 1/3 or 0.62",
    ))
}

/// A comparison sign, if one follows.
pub(super) fn comparison(input: ParseStream<'_>) -> Result<Option<Comparison>> {
    let apart = |first: bool, joined: bool| first && !joined && input.peek2(Token![=]);
    for (is_here, wrong, help) in [
        (apart(input.peek(Token![<]), input.peek(Token![<=])), "< =", "write `<=`, without a space"),
        (apart(input.peek(Token![>]), input.peek(Token![>=])), "> =", "write `>=`, without a space"),
        (apart(input.peek(Token![!]), input.peek(Token![!=])), "! =", "write `!=`, without a space"),
        (apart(input.peek(Token![=]), input.peek(Token![==])), "= =", "write `=`"),
        (
            input.peek(Token![=>]),
            "=>",
            "write `>=` for \"at least\", `=` for a definition; what holds for some values is `prove at λ = 0 { b[0] = 1; }`",
        ),
        (
            input.peek(Token![<]) && input.peek2(Token![>]),
            "<>",
            "write `!=` in conditions; of two sides that differ somewhere, claim `refute … = …;`",
        ),
        (input.peek(Token![=]) && input.peek2(Token![<]) && !input.peek(Token![==]), "=<", "write `<=`"),
    ] {
        if is_here {
            return Err(error(input.span(), format!("`{wrong}` is not a sign of the language"), help));
        }
    }
    Ok(Some(if input.peek(Token![==]) {
        input.parse::<Token![==]>()?;
        Comparison::Equal
    } else if input.peek(Token![<=]) {
        input.parse::<Token![<=]>()?;
        Comparison::LessEqual
    } else if input.peek(Token![>=]) {
        input.parse::<Token![>=]>()?;
        Comparison::GreaterEqual
    } else if input.peek(Token![!=]) {
        input.parse::<Token![!=]>()?;
        Comparison::NotEqual
    } else if input.peek(Token![<]) {
        input.parse::<Token![<]>()?;
        Comparison::Less
    } else if input.peek(Token![>]) {
        input.parse::<Token![>]>()?;
        Comparison::Greater
    } else if input.peek(Token![=]) {
        input.parse::<Token![=]>()?;
        Comparison::Equal
    } else {
        return Ok(None);
    }))
}
