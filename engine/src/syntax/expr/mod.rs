//! Expressions: precedence climbing of our own, because Rust's grammar reads `t^2*3` as `t^(2*3)`.
//!
//! From loose to tight: `+ -`, `* /`, unary `-`, `^` (to the right), then calls and indices.

mod side_by_side;

use basis_prover::collections::list::Listed;
use proc_macro2::{Delimiter, Literal, TokenTree};
use syn::buffer::Cursor;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Ident, Result, Token};

use self::side_by_side::{missing_operator, power_of_function};
use super::error::error;
use super::glyphs::MAX_NESTING;
use super::tokens::{comparison, join, name, number, unexpected};
use super::{Comparison, Condition, Expr, ExprKind, Generator, IndexRange, Loops, Role, Sign};

/// The most index variables of one `for`, and the most indices of a function.
pub(super) const MAX_INDICES: usize = 16;

/// An expression.
pub(super) fn expr(input: ParseStream<'_>) -> Result<Expr> {
    sum(input, 0)
}

/// The error for an expression whose tree is too high: what walks over it calls itself.
fn check_depth(input: ParseStream<'_>, depth: usize) -> Result<()> {
    if depth <= MAX_NESTING {
        return Ok(());
    }
    let help = "name parts of the formula with `let`";
    Err(error(input.span(), "the expression is nested too deeply", help))
}

fn sum(input: ParseStream<'_>, depth: usize) -> Result<Expr> {
    check_depth(input, depth)?;
    let first = product(input, depth)?;
    let mut terms = vec![(Sign::Plus, first)];
    while input.peek(Token![+]) || input.peek(Token![-]) {
        let sign = if input.parse::<Option<Token![+]>>()?.is_some() {
            Sign::Plus
        } else {
            input.parse::<Token![-]>()?;
            Sign::Minus
        };
        terms.push((sign, product(input, depth)?));
    }
    Ok(flat(terms, ExprKind::Sum))
}

fn product(input: ParseStream<'_>, depth: usize) -> Result<Expr> {
    let mut factors = vec![(Role::Factor, factor(input, depth)?)];
    loop {
        if input.peek(Token![*]) {
            let star = input.parse::<Token![*]>()?;
            if input.peek(Token![*]) {
                return Err(error(star.span, "`**` is not an operator", "write `^` for a power"));
            }
            factors.push((Role::Factor, factor(input, depth)?));
        } else if input.peek(Token![/]) {
            input.parse::<Token![/]>()?;
            factors.push((Role::Divisor, factor(input, depth)?));
        } else {
            break;
        }
    }
    missing_operator(input, &factors[factors.len() - 1].1)?;
    Ok(flat(factors, ExprKind::Product))
}

/// A single part stands for itself.
fn flat<T>(mut parts: Vec<(T, Expr)>, kind: fn(Vec<(T, Expr)>) -> ExprKind) -> Expr {
    let span = join(parts[0].1.span, parts[parts.len() - 1].1.span);
    match parts.pop() {
        Some((_, only)) if parts.is_empty() => only,
        Some(last) => {
            parts.push(last);
            Expr { span, kind: kind(parts) }
        }
        None => unreachable!("a sum or product has a first part"),
    }
}

/// −x binds looser than x^2 and may be repeated.
fn factor(input: ParseStream<'_>, depth: usize) -> Result<Expr> {
    let start = input.span();
    let mut negative = false;
    let mut signed = false;
    loop {
        if input.peek(Token![-]) {
            input.parse::<Token![-]>()?;
            negative = !negative;
        } else if input.peek(Token![+]) {
            input.parse::<Token![+]>()?;
        } else {
            break;
        }
        signed = true;
    }
    let inner = power(input, depth)?;
    if !signed {
        return Ok(inner);
    }
    let span = join(start, inner.span);
    let kind = if negative { ExprKind::Neg(Box::new(inner)) } else { inner.kind };
    Ok(Expr { span, kind })
}

fn power(input: ParseStream<'_>, depth: usize) -> Result<Expr> {
    check_depth(input, depth)?;
    let base = postfix(input, depth)?;
    if !input.peek(Token![^]) {
        return Ok(base);
    }
    input.parse::<Token![^]>()?;
    power_of_function(input, &base)?;
    let start = input.span();
    let exponent = if input.peek(Token![-]) {
        input.parse::<Token![-]>()?;
        let inner = power(input, depth + 1)?;
        Expr { span: join(start, inner.span), kind: ExprKind::Neg(Box::new(inner)) }
    } else {
        power(input, depth + 1)?
    };
    let span = join(base.span, exponent.span);
    Ok(Expr { span, kind: ExprKind::Power(Box::new(base), Box::new(exponent)) })
}

fn postfix(input: ParseStream<'_>, depth: usize) -> Result<Expr> {
    // Each pair of brackets behind the first part is a level of the tree above it.
    let depth = depth + links(input);
    check_depth(input, depth)?;
    let mut value = atom(input, depth)?;
    loop {
        let Some((TokenTree::Group(group), _)) = input.cursor().token_tree() else { return Ok(value) };
        let span = join(value.span, group.span_close());
        value = match group.delimiter() {
            Delimiter::Bracket => {
                let content;
                syn::bracketed!(content in input);
                let indices = list(&content, depth + 1)?;
                if indices.is_empty() {
                    return Err(error(
                        group.span(),
                        "an index is missing between the brackets",
                        "write a number, such as `b[0]`",
                    ));
                }
                Expr { span, kind: ExprKind::Index(Box::new(value), indices) }
            }
            Delimiter::Parenthesis => {
                if let ExprKind::Number(n) = &value.kind {
                    return Err(error(
                        group.span(),
                        format!("an operator is missing between `{n}` and `(`"),
                        format!("write `{n}*(…)` for a product"),
                    ));
                }
                let content;
                syn::parenthesized!(content in input);
                let arguments = arguments(&content, depth + 1)?;
                Expr { span, kind: ExprKind::Call(Box::new(value), arguments) }
            }
            _ => return Ok(value),
        };
    }
}

/// Whether `/dt` follows, and then what is differentiated, without an operator.
fn is_differential(after: Cursor<'_>) -> bool {
    let Some((sign, after)) = after.punct() else { return false };
    let Some((below, after)) = after.ident() else { return false };
    let (below, behind) = (below.to_string(), after.token_tree());
    sign.as_char() == '/'
        && below.len() > 1
        && below.starts_with('d')
        && matches!(behind, Some((TokenTree::Ident(_) | TokenTree::Group(_), _)))
}

/// The number of brackets that follow the next token, `(…)` or `[…]`; no more than matter.
fn links(input: ParseStream<'_>) -> usize {
    let Some((_, mut rest)) = input.cursor().token_tree() else { return 0 };
    let mut links = 0;
    while let Some((TokenTree::Group(group), next)) = rest.token_tree()
        && matches!(group.delimiter(), Delimiter::Bracket | Delimiter::Parenthesis)
        && links <= MAX_NESTING
    {
        links += 1;
        rest = next;
    }
    links
}

fn atom(input: ParseStream<'_>, depth: usize) -> Result<Expr> {
    let span = input.span();
    match input.cursor().token_tree() {
        Some((TokenTree::Literal(literal), _)) => {
            input.parse::<Literal>()?;
            Ok(Expr { span, kind: ExprKind::Number(number(&literal)?) })
        }
        Some((TokenTree::Ident(word), _)) if word == "if" => {
            let help = "conditions choose among the values of index variables, `for i in 0..=n if i != 1`; on parts of the domain a function is given in spans, `domain 0 <= t <= 1, 1 <= t <= 2;`";
            Err(error(span, "a formula has no cases", help))
        }
        Some((TokenTree::Ident(word), after)) if word == "d" && is_differential(after) => Err(error(
            span,
            "a derivative is not written as a quotient",
            "write `D(b[0])`, `D(b[0], λ)`, `D(b[0], 2)`",
        )),
        Some((TokenTree::Ident(_), _)) => Ok(Expr { span, kind: ExprKind::Name(name(input)?.text) }),
        Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Parenthesis => {
            let content;
            syn::parenthesized!(content in input);
            let mut inner = sum(&content, depth + 1)?;
            if content.peek(Token![,]) {
                content.parse::<Token![,]>()?;
                let parts = core::iter::once(inner).chain(list(&content, depth + 1)?).listed();
                return Ok(Expr { span: g.span(), kind: ExprKind::Tuple(parts) });
            }
            if !content.is_empty() {
                let found = unexpected(&content, "`)` or an operator");
                return Err(if content.peek(Token![if]) || content.peek(Token![for]) {
                    error(found.span(), found.to_string(), CONDITIONS)
                } else if comparison(&content.fork()).is_ok_and(|sign| sign.is_some()) {
                    error(found.span(), found.to_string(), format!("a comparison is no number; {CONDITIONS}"))
                } else if content.peek(Token![.]) {
                    error(found.span(), found.to_string(), METHODS)
                } else {
                    found
                });
            }
            inner.span = g.span();
            Ok(inner)
        }
        Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Bracket => {
            let content;
            syn::bracketed!(content in input);
            let mut parts = arguments(&content, depth + 1)?;
            let each = parts.len() == 1 && matches!(parts[0].kind, ExprKind::Each(..));
            let kind = match parts.pop() {
                Some(only) if each => only.kind,
                last => ExprKind::List(parts.into_iter().chain(last).listed()),
            };
            Ok(Expr { span: g.span(), kind })
        }
        Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Brace => {
            let found = unexpected(input, "a number, a name or `(`").to_string();
            input.parse::<TokenTree>()?;
            Err(error(
                g.span_open(),
                found,
                "a list is `[1, 0]`, a loop `for i in 0..=2`, a sum `sum(t^i for i in 0..=2)`; around a part of a formula stand parentheses",
            ))
        }
        Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::None => {
            // A fragment that another macro passed on.
            let content = input.call(none_delimited)?;
            let mut inner = syn::parse::Parser::parse2(|i: ParseStream<'_>| sum(i, depth + 1), content)?;
            inner.span = g.span();
            Ok(inner)
        }
        Some((TokenTree::Punct(p), _)) if p.as_char() == '|' => Err(error(
            span,
            "bars have no meaning around an expression",
            "write `-1 <= x <= 1` for |x| <= 1; the square of a length, in theorems, is `dot(x, x)`",
        )),
        Some((TokenTree::Punct(p), _)) if p.as_char() == ':' => {
            let found = unexpected(input, "a number, a name or `(`").to_string();
            Err(error(span, found, "leave the `:` out"))
        }
        Some((TokenTree::Punct(_), _)) if input.peek(Token![...]) || input.peek(Token![..]) => Err(error(
            span,
            "dots do not stand for the terms between others",
            "write `sum(b[i] for i in 0..=3)`, `product(…)`, and all entries of a list or `[x for i in 0..=n]`",
        )),
        Some((TokenTree::Punct(p), after)) if p.as_char() == '.' && after.literal().is_some() => {
            let found = unexpected(input, "a number, a name or `(`").to_string();
            Err(error(span, found, "a number begins with a digit: write `0.5`"))
        }
        Some((TokenTree::Punct(p), _)) if p.as_char() == '<' => {
            let found = unexpected(input, "a number, a name or `(`").to_string();
            let help =
                "an inner product is `integral(b[0]*b[1])` of functions, in theorems `dot(a, b)` of points";
            Err(error(span, found, help))
        }
        _ => Err(unexpected(input, "a number, a name or `(`")),
    }
}

fn none_delimited(input: ParseStream<'_>) -> Result<proc_macro2::TokenStream> {
    input.step(|cursor| match cursor.token_tree() {
        Some((TokenTree::Group(g), rest)) => Ok((g.stream(), rest)),
        _ => Err(cursor.error("a group was seen here")),
    })
}

/// Expressions separated by commas up to the end of the brackets.
pub(super) fn list(content: ParseStream<'_>, depth: usize) -> Result<Vec<Expr>> {
    let mut parts = Vec::new();
    while !content.is_empty() {
        parts.push(sum(content, depth)?);
        separator(content)?;
    }
    Ok(parts)
}

/// As [`list`], where an expression may run over index variables: `t^i for i in 0..=n`.
fn arguments(content: ParseStream<'_>, depth: usize) -> Result<Vec<Expr>> {
    let mut parts = Vec::new();
    while !content.is_empty() {
        let part = sum(content, depth)?;
        if content.peek(Token![for]) {
            let loops = loops(content)?;
            if parts.is_empty() && content.peek(Token![for]) {
                return Err(error(
                    part.span,
                    "there is one `for`",
                    "write both loops behind it: `x for i in 0..=n, j in 0..=m`",
                ));
            }
            if !parts.is_empty() || !content.is_empty() {
                let help = if parts.is_empty() && content.peek(Token![,]) {
                    "write `sum(t^i for i in 0..=n)`, with a condition behind the loop: `sum(t^i for i in 0..=n if i != j)`"
                } else {
                    "write `sum(t^i for i in 0..=n)`"
                };
                return Err(error(
                    part.span,
                    "an expression with `for` has to be alone between its brackets",
                    help,
                ));
            }
            let span = part.span;
            return Ok(vec![Expr { span, kind: ExprKind::Each(Box::new(part), loops) }]);
        }
        parts.push(part);
        separator(content)?;
    }
    Ok(parts)
}

/// What to write for `(1 - t).powi(2)`.
pub(super) const METHODS: &str =
    "functions stand before their arguments, `sin(t)`; a power is `(1 - t)^2`, a component `b[0, 1]`";

const CONDITIONS: &str = "conditions stand behind loops, `for i in 0..=n if i != 1`, and at the end of a statement: write a statement for each case, `… if i == 0;`";

/// Whether what follows is `= 1/2` and the end of the arguments, and no range.
fn gives_a_value(content: ParseStream<'_>) -> bool {
    let ahead = content.fork();
    matches!(comparison(&ahead), Ok(Some(Comparison::Equal))) && sum(&ahead, 0).is_ok() && ahead.is_empty()
}

fn separator(content: ParseStream<'_>) -> Result<()> {
    if content.peek(Token![,]) {
        content.parse::<Token![,]>()?;
    } else if content.peek(Token![;]) {
        let found = unexpected(content, "`,` or an operator").to_string();
        return Err(error(content.span(), found, "write `,` between arguments, as in `D(b[0], t)`"));
    } else if !content.is_empty() {
        let found = unexpected(content, "`,` or an operator");
        let help = if gives_a_value(content) {
            "a value of the domain variable stands between the parentheses without its name, `b[0](0)`, `D(b[0])(1/2)`, those of the shape parameters of a family likewise, `F(1/2)`; in the family itself a parameter is fixed by `at λ = 1/2 { … }`"
        } else if content.peek(Token![=]) || content.peek(Token![in]) {
            "write the loop of a sum or a list behind the expression, `sum(t^i for i in 0..=3)`, `[t^i for i in 0..=3]`, the bounds of an integral one by one, `integral(b[0], t, 0, 1)`"
        } else if content.peek(Token![if]) {
            CONDITIONS
        } else if content.peek(Token![..]) {
            "a part of a list is written with a loop, `b[i] >= 0 for i in 0..=2`, a sum as `sum(b[i] for i in 0..=2)`, an integral between bounds as `integral(b[0], t, 0, 1)`"
        } else if content.peek(Token![.]) {
            METHODS
        } else {
            return Err(found);
        };
        return Err(error(content.span(), found.to_string(), help));
    }
    Ok(())
}

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
