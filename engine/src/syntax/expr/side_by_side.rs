//! What stands side by side without an operator, as in papers: two factors, `sin t`, `sin^2(t)`, the next statement.

use proc_macro2::{Delimiter, TokenTree};
use syn::Result;
use syn::parse::ParseStream;

use crate::syntax::error::{NO_OPERATOR, error, missing_semicolon};
use crate::syntax::words::{PROPERTIES, text_of};
use crate::syntax::{Expr, ExprKind};

/// Functions that papers write without parentheses.
const FUNCTIONS: [&str; 7] = ["sin", "cos", "tan", "sinh", "cosh", "tanh", "exp"];

/// Longer arguments are not repeated in messages.
const LONGEST_SHOWN: usize = 20;

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
pub(super) fn missing_operator(input: ParseStream<'_>, before: &Expr) -> Result<()> {
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
            && (is_integral(before) || is_last(input) || is_argument(input)) =>
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
        "eps" | "epsilon" | "ε" | "ulp" | "ulps"
            if matches!(before.kind, ExprKind::Number(_)) && ends_after(input) =>
        {
            "a bound of rounding errors is a number, in units of ε: `rounding <= 5`"
        }
        _ if matches!(&before.kind, ExprKind::List(ends) if ends.len() == 2) && ends_after(input) => {
            "a range is written with its variable inside: `domain 0 <= t <= 1;`"
        }
        _ if matches!(&before.kind, ExprKind::Name(name) if name == "not") => "write `!=`, or `!(…)`",
        _ if matches!(&before.kind, ExprKind::Name(name) if name == "curve" || name == "surface") => {
            "the word stands alone: `curve P = Bernstein(2);`"
        }
        _ if matches!(&before.kind, ExprKind::Name(name) if name == "triangle" || name == "tetrahedron") => {
            "barycentric coordinates stand in parentheses: `domain triangle (u, v, w);`"
        }
        "triangle" | "tetrahedron" => {
            "the factors of a domain are separated by commas: `domain -1 <= z <= 1, triangle (u, v, w);`"
        }
        _ if found.starts_with('_') && is_power(input) => {
            "a truncated power is a formula for each span: `domain 0 <= t <= 1/2, 1/2 <= t <= 1; b[0] = 0 | (t - 1/2)^3;`"
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

/// Whether a comma follows after the next token, as in `integral(x dt, 0, 1)`.
fn is_argument(input: ParseStream<'_>) -> bool {
    let after = input.cursor().token_tree().and_then(|(_, after)| after.punct());
    after.is_some_and(|(sign, _)| sign.as_char() == ',')
}

/// Whether `+` or an exponent follows after the next token, as in `(t - 1)_+^3`.
fn is_power(input: ParseStream<'_>) -> bool {
    let after = input.cursor().token_tree().and_then(|(_, after)| after.punct());
    after.is_some_and(|(sign, _)| matches!(sign.as_char(), '+' | '^'))
}

/// Whether a statement ends after the next token.
fn ends_after(input: ParseStream<'_>) -> bool {
    let after = input.cursor().token_tree().map(|(_, after)| after);
    after.is_some_and(|after| after.eof() || after.punct().is_some_and(|(p, _)| p.as_char() == ';'))
}

/// Whether an expression is a call of `integral`.
fn is_integral(expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Call(callee, _) if matches!(&callee.kind, ExprKind::Name(n) if n == "integral"))
}

/// `sin^2(t)`, as papers write it, is an error with what to write in its place.
pub(super) fn power_of_function(input: ParseStream<'_>, base: &Expr) -> Result<()> {
    let ExprKind::Name(name) = &base.kind else { return Ok(()) };
    if name != "D" && !FUNCTIONS.contains(&name.as_str()) {
        return Ok(());
    }
    let Some((TokenTree::Literal(exponent), after)) = input.cursor().token_tree() else { return Ok(()) };
    let Some((_, _, behind)) = after.group(Delimiter::Parenthesis) else { return Ok(()) };
    let argument = text_of(after, behind);
    let argument = argument.strip_prefix('(').and_then(|inner| inner.strip_suffix(')')).unwrap_or(&argument);
    let argument = if argument.chars().count() > LONGEST_SHOWN { "…" } else { argument };
    if name == "D" {
        let message = "the order of a derivative is no exponent";
        return Err(error(exponent.span(), message, format!("write `D({argument}, {exponent})`")));
    }
    let message = format!("the exponent stands between `{name}` and its argument");
    Err(error(exponent.span(), message, format!("write `{name}({argument})^{exponent}`")))
}
