//! The end of a statement, and what is meant by what stands there instead.

use proc_macro2::Span;
use syn::parse::ParseStream;
use syn::{Result, Token};

use super::error::error;
use super::expr::METHODS;
use super::tokens::{DECIMAL_POINT, unexpected};
use super::words::at_word;
use super::{Claim, ClaimKind, Expr, ExprKind, FunctionDef, NameDef, StatementKind};

/// The `;` at the end of a statement; a block needs none.
pub(super) fn semicolon(input: ParseStream<'_>, kind: Option<&StatementKind>) -> Result<Span> {
    if input.peek(Token![;]) {
        return Ok(input.parse::<Token![;]>()?.span);
    }
    match kind {
        Some(StatementKind::Claim(claim)) if matches!(claim.kind, ClaimKind::At(..)) => {
            if input.peek(Token![for]) {
                let help = "an index variable belongs to one equation, `prove at t = 0 { b[i] = 0 for i in 1..=n; }`; at a place that depends on it claim the value there: `D(b[i])(i/n) = 0 for i in 1..n;`";
                return Err(error(input.span(), "`for` does not follow after a block", help));
            }
            if input.peek(Token![if]) {
                let help = "a condition belongs to one equation: `prove at t = 0 { b[0] = 1 if n == 1; }`";
                return Err(error(input.span(), "`if` does not follow after a block", help));
            }
            return Ok(claim.keyword);
        }
        Some(StatementKind::Base(order, _)) => return Ok(order.name.span),
        _ => {}
    }
    let help = match kind {
        Some(StatementKind::Claim(_)) if at_word(input, "except") => {
            "`except` belongs to `independent`; for other claims narrow the range of the parameter"
        }
        Some(StatementKind::Claim(_)) if input.peek(syn::token::Brace) => {
            "values are fixed by `at`: `prove at t = 0 { b[0] = 1; }`"
        }
        _ if input.peek(Token![for]) => {
            "all index variables stand behind one `for`, `for i in 0..=n, j in 0..=n if i != j`, and conditions at the end"
        }
        Some(StatementKind::Claim(_)) if at_word(input, "at") => {
            "a property is claimed for all values; at some of them claim its equations or inequalities, `prove at λ = 0 { b[0] >= 0; }`"
        }
        Some(StatementKind::Claim(claim)) if has_loops(claim) && input.peek(Token![,]) => {
            "conditions stand behind the loops: `for i in 0..=n, j in 0..=n if i != j`"
        }
        Some(StatementKind::Claim(_)) if input.peek(Token![,]) && begins_digits(input) => DECIMAL_POINT,
        Some(StatementKind::Claim(_)) if input.peek(Token![,]) => {
            "write a statement for each claim: a statement ends with `;`"
        }
        Some(StatementKind::Claim(claim))
            if matches!(claim.kind, ClaimKind::Independent(_)) && input.cursor().ident().is_some() =>
        {
            "values that are left out follow after `except`: `independent except λ = -3`"
        }
        Some(StatementKind::Function(_)) if input.peek(Token![||]) => {
            "the formulas on neighbouring spans are separated by one bar: `b[0] = t | 2 - t;`"
        }
        Some(StatementKind::Function(_)) if begins_values(input) => {
            "the range of an index follows after `for`: `b[i] = t^i for i in 0..=2;`"
        }
        Some(StatementKind::Claim(claim))
            if matches!(claim.kind, ClaimKind::Independent(_)) && input.peek(Token![&&]) =>
        {
            "values that are left out are separated by commas, `except λ = 0, λ = 1`; those of one point stand in parentheses, `except (λ = 0, μ = 1)`"
        }
        Some(StatementKind::Claim(_)) if input.peek(Token![||]) || input.peek(Token![&&]) => {
            "write two claims: `&&` and `||` stand between conditions, behind `if`"
        }
        Some(StatementKind::Let(..)) if input.peek(Token![|]) => {
            "a name has one formula for all spans; write those of the spans in the functions"
        }
        Some(StatementKind::Assume(_)) if input.peek(Token![,]) || input.peek(Token![&&]) => {
            "write an `assume` for each: `assume a + b <= 1; assume a <= b;`"
        }
        Some(
            StatementKind::Function(FunctionDef { value, .. }) | StatementKind::Let(NameDef { value, .. }),
        ) if input.peek(Token![,]) && ends_in_number(value) && begins_digits(input) => DECIMAL_POINT,
        Some(StatementKind::Function(_)) if input.peek(Token![,]) => {
            "the formulas on neighbouring spans are separated by a bar, `b[0] = t | 2 - t;`, statements by `;`"
        }
        _ if input.peek(Token![!]) => "write `factorial(n)`",
        _ if input.peek(Token![,]) && begins_digits(input) => DECIMAL_POINT,
        Some(StatementKind::Shape(_)) if input.peek(Token![:]) => {
            "types are not written: a name alone, `shape λ;`, is any real number"
        }
        Some(StatementKind::Claim(_)) if at_word(input, "with") => {
            "values of the next segment follow after `continuity(2) with d0 = d1, d1 = d2`; of other claims the values are fixed by `at λ = 1 { … }`"
        }
        Some(StatementKind::Claim(claim))
            if matches!(claim.kind, ClaimKind::Continuity(..)) && input.peek(Token![=]) =>
        {
            "equations are separated by commas: `with d0 = d1, d1 = d2`"
        }
        Some(StatementKind::Claim(claim))
            if matches!(claim.kind, ClaimKind::Smooth(_)) && input.peek(Token![,]) =>
        {
            "it is claimed of all functions: `smooth(1)`"
        }
        _ if input.peek(Token![.]) => METHODS,
        _ if input.peek(Token![%]) => {
            "write a part of the whole as a fraction, `1/2`, or as a decimal, `0.5`"
        }
        _ => "a statement ends with `;`",
    };
    Err(error(input.span(), unexpected(input, "`;` or an operator").to_string(), help))
}

/// Whether a claim runs over index variables.
fn has_loops(claim: &Claim) -> bool {
    let own = match &claim.kind {
        ClaimKind::Relation(relation) => &relation.loops,
        _ => &claim.loops,
    };
    !own.generators.is_empty()
}

/// Whether an expression ends in a number.
fn ends_in_number(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Number(_) => true,
        ExprKind::Neg(inner) => ends_in_number(inner),
        ExprKind::Sum(parts) => parts.last().is_some_and(|(_, last)| ends_in_number(last)),
        ExprKind::Product(parts) => parts.last().is_some_and(|(_, last)| ends_in_number(last)),
        _ => false,
    }
}

/// Whether a comma and values of a name follow, as in `, i = 0, 1, 2`.
fn begins_values(input: ParseStream<'_>) -> bool {
    let Some((_, after)) = input.cursor().punct().filter(|(comma, _)| comma.as_char() == ',') else {
        return false;
    };
    let Some((_, after)) = after.ident() else { return false };
    after.punct().is_some_and(|(sign, _)| sign.as_char() == '=')
        || after.ident().is_some_and(|(word, _)| word == "in")
}

/// Whether a comma and a number follow, as in `0,5`.
fn begins_digits(input: ParseStream<'_>) -> bool {
    input.cursor().punct().is_some_and(|(_, after)| after.literal().is_some())
}
