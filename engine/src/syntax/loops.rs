//! Loops: what index variables run over, and the conditions behind them.

use proc_macro2::{Delimiter, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Ident, Result, Token};

use super::error::error;
use super::expr::{check_depth, expr};
use super::tokens::{comparison, name, unexpected};
use super::{Condition, Generator, IndexRange, Loops};

/// The most index variables of one `for`, and the most indices of a function.
pub(super) const MAX_INDICES: usize = 16;

/// `for i in 0..=n, j in 0..=n if i != j`, or a part of it, or nothing.
pub(super) fn loops(input: ParseStream<'_>) -> Result<Loops> {
    let mut result = Loops::default();
    if input.peek(Token![for]) {
        input.parse::<Token![for]>()?;
        let start = input.span();
        let mut names = 0;
        loop {
            let generator = generator(input)?;
            names += match &generator {
                Generator::Range(_) => 1,
                Generator::Simplex(names, _) => names.len(),
            };
            if names > MAX_INDICES {
                let message = format!("a `for` has at most {MAX_INDICES} index variables");
                return Err(error(start, message, "write several statements"));
            }
            result.generators.push(generator);
            if !input.peek(Token![,]) || begins_range(input) {
                break;
            }
            input.parse::<Token![,]>()?;
        }
    }
    if input.peek(Token![if]) {
        input.parse::<Token![if]>()?;
        result.condition = Some(Box::new(any(input, 0)?));
    }
    Ok(result)
}

/// Conditions joined by `||`, which binds looser than `&&`.
fn any(input: ParseStream<'_>, depth: usize) -> Result<Condition> {
    check_depth(input, depth)?;
    let mut parts = vec![all(input, depth)?];
    while input.peek(Token![||]) {
        input.parse::<Token![||]>()?;
        parts.push(all(input, depth)?);
    }
    Ok(if parts.len() > 1 { Condition::Any(parts) } else { parts.remove(0) })
}

/// Conditions joined by `&&`.
fn all(input: ParseStream<'_>, depth: usize) -> Result<Condition> {
    let mut parts = vec![condition(input, depth)?];
    while input.peek(Token![&&]) {
        input.parse::<Token![&&]>()?;
        parts.push(condition(input, depth)?);
    }
    Ok(if parts.len() > 1 { Condition::All(parts) } else { parts.remove(0) })
}

/// A comparison, or a condition in brackets, perhaps with `!` in front.
fn condition(input: ParseStream<'_>, depth: usize) -> Result<Condition> {
    if input.peek(Token![!]) && !input.peek(Token![!=]) {
        let not = input.parse::<Token![!]>()?;
        if !matches!(input.cursor().token_tree(), Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Parenthesis)
            && !input.peek(Token![!])
        {
            let help = "write `!(i == j)`, or `i != j`";
            return Err(error(not.span, "`!` needs a condition in brackets", help));
        }
        check_depth(input, depth)?;
        return Ok(Condition::Not(Box::new(condition(input, depth + 1)?)));
    }
    if let Some((TokenTree::Group(g), _)) = input.cursor().token_tree()
        && g.delimiter() == Delimiter::Parenthesis
        && compares(g.stream())
    {
        let content;
        syn::parenthesized!(content in input);
        let inner = any(&content, depth + 1)?;
        if !content.is_empty() {
            return Err(unexpected(&content, "`)`, `&&` or `||`"));
        }
        return Ok(inner);
    }
    let left = expr(input)?;
    let Some(sign) = comparison(input)? else {
        return Err(unexpected(input, "a comparison such as `!=`"));
    };
    Ok(Condition::Compare(left, sign, expr(input)?))
}

/// Whether brackets hold a condition and not a number: a sign of a comparison or `!` stands in them, perhaps deeper.
fn compares(tokens: proc_macro2::TokenStream) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Punct(p) => "<>=!".contains(p.as_char()),
        TokenTree::Group(g) => g.delimiter() == Delimiter::Parenthesis && compares(g.stream()),
        _ => false,
    })
}

/// Whether a range of a shape parameter follows after the comma, `, 0 <= μ`, and not another index variable.
fn begins_range(input: ParseStream<'_>) -> bool {
    let ahead = input.fork();
    ahead.parse::<Token![,]>().is_ok()
        && !ahead.is_empty()
        && (ahead.cursor().ident().is_none() || !ahead.peek2(Token![in]) && !ahead.peek2(Token![,]))
        && ahead.call(expr).is_ok()
        && ahead.call(comparison).is_ok_and(|sign| sign.is_some())
}

/// `i in low..=high`, or `i, j, k in simplex(n)`.
fn generator(input: ParseStream<'_>) -> Result<Generator> {
    let ahead = input.fork();
    if ahead.cursor().ident().is_none() {
        return Ok(Generator::Range(index_range(input, NO_SCALAR)?));
    }
    let mut names = vec![name(&ahead)?];
    while ahead.peek(Token![,]) {
        ahead.parse::<Token![,]>()?;
        match name(&ahead) {
            Ok(name) => names.push(name),
            Err(_) => break,
        }
    }
    let simplex = ahead.peek(Token![in])
        && ahead.parse::<Token![in]>().is_ok()
        && ahead.cursor().ident().is_some_and(|(word, _)| word == "simplex");
    if !simplex {
        return Ok(Generator::Range(index_range(input, NO_SCALAR)?));
    }
    ahead.call(Ident::parse_any)?;
    let content;
    syn::parenthesized!(content in ahead);
    let sum = expr(&content)?;
    if !content.is_empty() {
        return Err(unexpected(&content, "`)`"));
    }
    syn::parse::discouraged::Speculative::advance_to(input, &ahead);
    Ok(Generator::Simplex(names, sum))
}

/// What an index is, for those who mean a scalar.
const NO_SCALAR: &str =
    "; indices run over whole numbers, and a claim is about all values of its parameters without `for`";

/// `i in low..=high`.
pub(super) fn index_range(input: ParseStream<'_>, hint: &str) -> Result<IndexRange> {
    if input.cursor().ident().is_none() {
        let found = unexpected(input, "the name of an index").to_string();
        let help = if input.peek(syn::token::Paren) {
            String::from(
                "index variables stand without parentheses: `i in 0..=3`, or `i, j, k in simplex(2)` for all with the sum 2",
            )
        } else {
            format!("write a range, such as `i in 0..=3`{hint}")
        };
        return Err(error(input.span(), found, help));
    }
    let name = name(input)?;
    if !input.peek(Token![in]) {
        let found = unexpected(input, &format!("`in` after `{}`", name.text)).to_string();
        let name = if name.text == "all" { "i" } else { &name.text };
        let help = if input.peek(Token![=]) && !hint.is_empty() {
            format!(
                "an index variable runs over a range, `for {name} in 0..=3`; the value of a parameter is fixed before the formula, `at {name} = 0 {{ b[0] = 1; }}`, that of an index parameter behind it, `if {name} == 2`"
            )
        } else if input.peek(Token![,]) {
            format!(
                "each index variable has its range, `{name} in 0..=3, j in 0..=3`; all with a sum are `{name}, j in simplex(3)`"
            )
        } else if input.peek(Token![+]) {
            String::from("all indices with a sum are written `i, j, k in simplex(2)`")
        } else {
            format!("write a range, such as `{name} in 0..=3`{hint}")
        };
        return Err(error(input.span(), found, help));
    }
    input.parse::<Token![in]>()?;
    let low = expr(input)?;
    let inclusive = input.peek(Token![..=]);
    if input.peek(Token![...]) {
        return Err(error(input.span(), "`...` is not a sign of a range", "write `0..=3` for 0, 1, 2, 3"));
    }
    if inclusive {
        input.parse::<Token![..=]>()?;
    } else if input.peek(Token![..]) {
        input.parse::<Token![..]>()?;
    } else {
        let help = format!("write `0..=3` for 0, 1, 2, 3{hint}");
        return Err(error(low.span, "this is not a range of an index", help));
    }
    if input.is_empty() || input.peek(Token![;]) {
        let found = unexpected(input, "the last value").to_string();
        let help = format!("write both ends of the range, such as `{} in 1..=8`", name.text);
        return Err(error(input.span(), found, help));
    }
    let high = expr(input)?;
    Ok(IndexRange { name, low, high, inclusive })
}
