//! Expressions: precedence climbing of our own, because Rust's grammar reads `t^2*3` as `t^(2*3)`.
//!
//! From loose to tight: `+ -`, `* /`, unary `-`, `^` (to the right), then calls and indices.

use basis_prover::collections::list::Listed;
use proc_macro2::{Delimiter, Literal, TokenTree};
use syn::buffer::Cursor;
use syn::parse::ParseStream;
use syn::{Result, Token};

use super::error::{NO_OPERATOR, error, missing_semicolon};
use super::glyphs::MAX_NESTING;
use super::loops::loops;
use super::tokens::{join, name, number, unexpected};
use super::words::{PROPERTIES, text_of};
use super::{Expr, ExprKind, Role, Sign};

/// Functions that papers write without parentheses.
const FUNCTIONS: [&str; 7] = ["sin", "cos", "tan", "sinh", "cosh", "tanh", "exp"];

/// Longer arguments are not repeated in messages.
const LONGEST_SHOWN: usize = 20;

/// An expression.
pub(super) fn expr(input: ParseStream<'_>) -> Result<Expr> {
    sum(input, 0)
}

/// The error for an expression whose tree is too high: what walks over it calls itself.
pub(super) fn check_depth(input: ParseStream<'_>, depth: usize) -> Result<()> {
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

/// Whether a word begins a claim or another statement, and is nobody's name.
fn is_statement(word: &str) -> bool {
    ["prove", "refute", "conjecture", "curve", "surface", "scalar", "assume", "let"].contains(&word)
}

/// Whether `b[1] = …` follows: a definition, not a factor.
fn begins_definition(input: ParseStream<'_>) -> bool {
    let Some((_, after)) = input.cursor().ident() else { return false };
    let Some((TokenTree::Group(index), after)) = after.token_tree() else { return false };
    let Some((sign, after)) = after.punct() else { return false };
    let equation = sign.as_char() == '=' && after.punct().is_none_or(|(next, _)| next.as_char() != '=');
    index.delimiter() == Delimiter::Bracket && equation
}

/// Whether what follows on the next line can be another statement: anything but a loop, which needs its `for`.
fn begins_statement(input: ParseStream<'_>) -> bool {
    let Some((_, after)) = input.cursor().token_tree() else { return false };
    after.ident().is_none_or(|(word, _)| word != "in" && word != "for")
}

/// Two factors side by side, as papers write them, are an error with the place of the missing sign; on two lines it is
/// the end of a statement that is missing.
fn missing_operator(input: ParseStream<'_>, before: &Expr) -> Result<()> {
    let found = match input.cursor().token_tree() {
        Some((TokenTree::Ident(i), _))
            if i != "for" && i != "if" && i != "except" && i != "in" && i != "parallel" =>
        {
            i.to_string()
        }
        Some((TokenTree::Literal(l), _)) => l.to_string(),
        Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Parenthesis => String::from("("),
        _ => return Ok(()),
    };
    if begins_definition(input) {
        return Err(missing_semicolon(before.span));
    }
    let next_line = input.span().start().line > before.span.end().line;
    if is_statement(&found) || next_line && begins_statement(input) {
        return Err(missing_semicolon(before.span));
    }
    let function = match &before.kind {
        ExprKind::Name(name) if FUNCTIONS.contains(&name.as_str()) => Some((name.clone(), String::new())),
        ExprKind::Power(base, exponent) => match (&base.kind, &exponent.kind) {
            (ExprKind::Name(name), ExprKind::Number(n)) if FUNCTIONS.contains(&name.as_str()) => {
                Some((name.clone(), format!("^{n}")))
            }
            _ => None,
        },
        _ => None,
    };
    if let Some((name, power)) = function {
        let argument = if found == "(" { "…" } else { &found };
        let message = format!("the argument of `{name}` goes in parentheses");
        return Err(error(input.span(), message, format!("write `{name}({argument}){power}`")));
    }
    let help = match found.as_str() {
        _ if found.starts_with('d')
            && found.chars().count() == 2
            && (is_integral(before) || is_last(input)) =>
        {
            NO_DIFFERENTIAL
        }
        "and" | "or" => {
            "write two claims, one chain for a range, `0 < λ < 1`, `,` between the members of a list, `&&` or `||` between conditions"
        }
        _ if PROPERTIES.contains(&found.as_str()) => {
            "a property is claimed of all functions, `prove nonnegative;`; of one function write an inequality, `b[0] >= 0`"
        }
        "is" => "write `==`, `>=`, …, or of two vectors `a parallel b`",
        "where" | "when" | "with" => {
            "ranges are declared, `shape 0 <= λ <= 1;` (in theorems `scalar`), conditions `assume λ <= μ;`; index variables follow after `for`, and what holds of them and of index parameters after `if`: `if n > 1`"
        }
        "at" => "a place comes first: `prove at t = 0 { b[0] = 1; }`",
        "triangle" | "tetrahedron" => {
            "the factors of a domain are separated by commas: `domain -1 <= z <= 1, triangle (u, v, w);`"
        }
        _ => "write `*` between the factors of a product",
    };
    Err(error(input.span(), format!("{NO_OPERATOR}`{found}`"), help))
}

/// Of `integral(…) dt` what is meant by `dt` goes without saying.
const NO_DIFFERENTIAL: &str = "leave the differential out: `integral(x)` is over the whole domain, `integral(x, t, a, b)` between bounds";

/// Whether nothing follows after the next token, as in `integral(x dt)`.
fn is_last(input: ParseStream<'_>) -> bool {
    input.cursor().token_tree().is_some_and(|(_, after)| after.eof())
}

/// Whether an expression is a call of `integral`.
fn is_integral(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Call(callee, _) if matches!(&callee.kind, ExprKind::Name(n) if n == "integral"))
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

/// `sin^2(t)`, as papers write it, is an error with what to write in its place.
fn power_of_function(input: ParseStream<'_>, base: &Expr) -> Result<()> {
    let ExprKind::Name(name) = &base.kind else { return Ok(()) };
    if name != "D" && !FUNCTIONS.contains(&name.as_str()) {
        return Ok(());
    }
    let Some((TokenTree::Literal(exponent), after)) = input.cursor().token_tree() else { return Ok(()) };
    let Some((_, _, behind)) = after.group(Delimiter::Parenthesis) else { return Ok(()) };
    let argument = text_of(after, behind);
    let argument = argument.trim_start_matches('(').trim_end_matches(')');
    let argument = if argument.chars().count() > LONGEST_SHOWN { "…" } else { argument };
    if name == "D" {
        let message = "the order of a derivative is no exponent";
        return Err(error(exponent.span(), message, format!("write `D({argument}, {exponent})`")));
    }
    let message = format!("the exponent stands between `{name}` and its argument");
    Err(error(exponent.span(), message, format!("write `{name}({argument})^{exponent}`")))
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
            Err(error(g.span_open(), found, "write parentheses, `(…)`, around a part of a formula"))
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
            "write `sum(b[i] for i in 0..=3)`, or `product(…)`",
        )),
        Some((TokenTree::Punct(p), after)) if p.as_char() == '.' && after.literal().is_some() => {
            let found = unexpected(input, "a number, a name or `(`").to_string();
            Err(error(span, found, "a number begins with a digit: write `0.5`"))
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
                    "a sum has one `for`",
                    "write one sum in another: `sum(sum(x for i in 0..=n) for j in 0..=m)`",
                ));
            }
            if !parts.is_empty() || !content.is_empty() {
                return Err(error(
                    part.span,
                    "an expression with `for` has to be alone between its brackets",
                    "write `sum(t^i for i in 0..=n)`",
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

const CONDITIONS: &str = "conditions stand behind loops, `for i in 0..=n if i != 1`, and at the end of a statement: write a statement for each case, `… if i == 0;`";

fn separator(content: ParseStream<'_>) -> Result<()> {
    if content.peek(Token![,]) {
        content.parse::<Token![,]>()?;
    } else if content.peek(Token![;]) {
        let found = unexpected(content, "`,` or an operator").to_string();
        return Err(error(content.span(), found, "write `,` between arguments, as in `D(b[0], t)`"));
    } else if !content.is_empty() {
        let found = unexpected(content, "`,` or an operator");
        let help = if content.peek(Token![=]) || content.peek(Token![in]) {
            "write the loop of a sum behind the expression, `sum(t^i for i in 0..=3)`, the bounds of an integral one by one, `integral(b[0], t, 0, 1)`"
        } else if content.peek(Token![if]) {
            CONDITIONS
        } else if content.peek(Token![..]) {
            "a part of a list is written with a loop, `b[i] >= 0 for i in 0..=2`, a sum as `sum(b[i] for i in 0..=2)`"
        } else {
            return Err(found);
        };
        return Err(error(content.span(), found.to_string(), help));
    }
    Ok(())
}
