//! Ranges as papers write them: `0 <= t <= 1`, `0 < λ`, `λ >= -2`.

use proc_macro2::{Delimiter, Span, TokenTree};
use syn::parse::ParseStream;
use syn::{Error, Result};

use super::error::error;
use super::expr::{expr, loops};
use super::tokens::{DECIMAL_POINT, comparison};
use super::words::{at_word, text_of};
use super::{Bounds, Comparison, Expr, ExprKind, Limit, Name, RangeDecl, ShapeDecl};

/// What the range of a parameter may look like.
pub(super) const SHAPE_HELP: &str =
    "write a range such as `-3 <= λ <= 1`, `0 < λ`, or a name alone for all real numbers";

/// A range as papers write it: `0 <= t <= 1`, `0 < λ`, `λ >= -2`, or a name alone for all real numbers.
pub(super) fn range(input: ParseStream<'_>, help: &str) -> Result<RangeDecl> {
    let Bounds { target, low, high } = bounds(input, help)?;
    let ExprKind::Name(text) = target.kind else { return Err(no_name(target.span, help)) };
    Ok(RangeDecl { name: Name { text, span: target.span }, low, high })
}

/// Ranges of shape parameters in one chain, such as `0 < q < p <= 1`.
pub(super) fn shapes(input: ParseStream<'_>) -> Result<ShapeDecl> {
    let help = SHAPE_HELP;
    let (parts, included) = chain(input, help)?;
    if !parts.iter().any(|part| part.named().is_some()) {
        let part = parts.get(usize::from(parts.len() > 2)).unwrap_or(&parts[0]);
        let of_two = parts.len() > 1;
        return Err(if of_two { no_name(part.span, help) } else { no_target(part, help) });
    }
    Ok(ShapeDecl { parts, included, loops: loops(input)? })
}

/// A range as papers write it, whose name may have an index, `-3 < γ[1]`.
pub(super) fn bounds(input: ParseStream<'_>, help: &str) -> Result<Bounds> {
    let start = input.span();
    let (parts, included) = chain(input, help)?;
    let target = |e: Expr| match e.named() {
        Some(_) => Ok(e),
        None if is_triangle(&e) => {
            let message = "a range has one variable";
            let help = "a triangle has barycentric coordinates, whose sum is 1: `domain triangle (u, v, w);`; parameters with a sum are `assume α + β <= 1;`";
            Err(error(e.span, message, help))
        }
        None => Err(no_target(&e, help)),
    };
    let limit = |value, included: &bool| Some(Limit { value, included: *included });
    let mut parts = parts.into_iter();
    match (parts.next(), parts.next(), parts.next(), included.as_slice()) {
        (Some(only), None, None, []) => Ok(Bounds { target: target(only)?, low: None, high: None }),
        (Some(a), Some(b), None, [i]) => {
            if b.named().is_some() {
                Ok(Bounds { target: b, low: limit(a, i), high: None })
            } else if a.named().is_none() && matches!(a.kind, ExprKind::Number(_)) {
                target(b).map(|target| Bounds { target, low: limit(a, i), high: None })
            } else {
                Ok(Bounds { target: target(a)?, low: None, high: limit(b, i) })
            }
        }
        (Some(a), Some(b), Some(c), [i, j]) => {
            Ok(Bounds { target: target(b)?, low: limit(a, i), high: limit(c, j) })
        }
        _ => Err(error(start, "a range has at most two ends", help)),
    }
}

/// Expressions with inequalities between them, in ascending order, and whether neighbours may be equal.
fn chain(input: ParseStream<'_>, help: &str) -> Result<(Vec<Expr>, Vec<bool>)> {
    let start = input.cursor();
    let mut parts = vec![expr(input)?];
    let mut signs = Vec::new();
    loop {
        let at = input.span();
        let Some(sign) = comparison(input)? else { break };
        signs.push((sign, at));
        parts.push(expr(input).map_err(|e| of_two_ranges(e, input, &parts))?);
    }
    if at_word(input, "in") {
        let name = text_of(start, input.cursor());
        let interval = input.cursor().ident().and_then(|(_, after)| after.token_tree());
        let (sign, ends) = match interval {
            Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Parenthesis => {
                ("<", g.stream().to_string())
            }
            Some((TokenTree::Group(g), _)) => ("<=", g.stream().to_string()),
            _ => ("", String::new()),
        };
        let names: Vec<&str> = name.trim_matches(['(', ')']).split(',').map(str::trim).collect();
        let help = match ends.split_once(',') {
            Some(_) if names.len() > 1 => {
                let intervals = intervals(input);
                let each: Vec<String> = names
                    .iter()
                    .enumerate()
                    .map(|(k, name)| {
                        let [low, high] = intervals.get(k).or(intervals.last()).cloned().unwrap_or_default();
                        format!("{low} <= {name} <= {high}")
                    })
                    .collect();
                format!("write a range for each variable: `{}`", each.join(", "))
            }
            Some((low, high)) if !high.contains(',') => {
                let [low, high] = [low, high].map(|end| end.trim().replace("- ", "-"));
                format!("write `{low} {sign} {name} {sign} {high}`")
            }
            _ if ends.is_empty() && help == SHAPE_HELP => {
                format!(
                    "a range is `0 <= {name} <= 1`; whole numbers belong to an index parameter, `family F({name} in 1..=4)`"
                )
            }
            _ => String::from(help),
        };
        return Err(error(input.span(), "`in` cannot be used here", help));
    }
    // With >, the chain is read from the other end.
    let descending = matches!(signs.first(), Some((Comparison::Greater | Comparison::GreaterEqual, _)));
    if descending {
        parts.reverse();
        signs.reverse();
    }
    let mut included = Vec::new();
    for (sign, span) in &signs {
        included.push(match (sign, descending) {
            (Comparison::Less, false) | (Comparison::Greater, true) => false,
            (Comparison::LessEqual, false) | (Comparison::GreaterEqual, true) => true,
            (Comparison::Equal, _) => {
                let text = text_of(start, input.cursor());
                let sides = text.split_once('=').filter(|_| parts.len() == 2 && parts[0].named().is_some());
                let help = sides.map_or_else(
                    || String::from("a number has a name by `let c = 2;`; the range of one value is `1 <= λ <= 1`"),
                    |(name, value)| {
                        let (name, value) = (name.trim(), value.trim_start_matches('=').trim());
                        format!(
                            "a number has a name by `let {name} = {value};`; the range of one value is `{value} <= {name} <= {value}`"
                        )
                    },
                );
                return Err(error(*span, "a range is made of inequalities, this is an equation", help));
            }
            _ => return Err(error(*span, format!("`{}` does not fit in this range", sign.symbol()), help)),
        });
    }
    Ok((parts, included))
}

/// The ends of the intervals in `in [0, 1] x [-1, 1]`.
fn intervals(input: ParseStream<'_>) -> Vec<[String; 2]> {
    let mut all = Vec::new();
    let mut at = input.cursor();
    while let Some((token, after)) = at.token_tree() {
        at = after;
        if let TokenTree::Group(g) = &token {
            let text = g.stream().to_string();
            let Some((low, high)) = text.split_once(',') else { break };
            all.push([low, high].map(|end| end.trim().replace("- ", "-")));
        } else if matches!(&token, TokenTree::Punct(p) if p.as_char() == ';') {
            break;
        }
    }
    all
}

/// The error for `λ > 0 λ < 1`.
fn of_two_ranges(e: Error, input: ParseStream<'_>, parts: &[Expr]) -> Error {
    match (parts, input.cursor().ident()) {
        ([Expr { kind: ExprKind::Name(name), .. }], Some((again, _))) if again == name => {
            let help = format!("write both ends in one chain, such as `0 < {name} < 1`");
            error(e.span(), format!("the range of `{name}` has two parts"), help)
        }
        _ => e,
    }
}

/// A triangle as papers write it, `0 <= u, 0 <= v, u + v <= 1`.
fn is_triangle(target: &Expr) -> bool {
    matches!(&target.kind, ExprKind::Sum(terms) if terms.iter().all(|(_, term)| matches!(term.kind, ExprKind::Name(_))))
}

/// The error for an expression without a name; a number alone may be the second half of `0,5`.
fn no_target(found: &Expr, help: &str) -> Error {
    match found.kind {
        ExprKind::Number(_) => no_name(found.span, &format!("{help}; {DECIMAL_POINT}")),
        _ => no_name(found.span, help),
    }
}

fn no_name(span: Span, help: &str) -> Error {
    error(span, "expected the name whose range this is", help)
}
