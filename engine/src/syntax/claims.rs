//! Claims: `prove …` and `refute …`.

use std::rc::Rc;

use proc_macro2::{Delimiter, Ident, TokenTree};
use syn::buffer::Cursor;
use syn::parse::ParseStream;
use syn::{Result, Token};

use super::error::{error, is_missing_operator, is_missing_semicolon};
use super::expr::{expr, loops};
use super::tokens::{comparison, join, name, unexpected};
use super::words::{PROPERTIES, at_word, equals, take_word, text_of};
use super::{Binding, Claim, ClaimKind, Comparison, Expected, Expr, ExprKind, Loops, Relation};
use crate::advice::translated;

/// `prove …` or `refute …` without the final `;`.
pub(super) fn claim(input: ParseStream<'_>) -> Result<Claim> {
    let word = input.cursor().ident().map(|(word, _)| word.to_string());
    let expected = word.and_then(|word| Expected::of(&word)).unwrap_or(Expected::True);
    let keyword = take_word(input)?;
    let start = input.cursor();
    let mut only = Loops::default();
    let kind = match property(input) {
        Some(word) => {
            let span = take_word(input)?;
            let kind = match word {
                "partition_of_unity" => ClaimKind::PartitionOfUnity,
                "nonnegative" => ClaimKind::Nonnegative,
                "symmetric" => ClaimKind::Symmetric,
                "continuity" => continuity(input, span)?,
                "totally_positive" => ClaimKind::TotallyPositive,
                "smooth" => smooth(input, span)?,
                "rounding" => rounding(input, span)?,
                _ => ClaimKind::Independent(exceptions(input, span)?),
            };
            only = loops(input)?;
            kind
        }
        None if at_word(input, "at") => at(input)?,
        None if input.peek(Token![!]) => {
            let help = "write `refute …;` to claim that something is false";
            return Err(error(input.span(), "`!` does not begin a claim", help));
        }
        None if two_words(input) => return Err(unknown_property(input)),
        None => ClaimKind::Relation(relation(input)?),
    };
    let text = text_of(start, input.cursor());
    Ok(Claim { expected, keyword, kind, loops: only, text })
}

/// The property that the next word names, when it stands alone.
fn property(input: ParseStream<'_>) -> Option<&'static str> {
    let (ident, after) = input.cursor().ident()?;
    let alone = match after.token_tree() {
        None | Some((TokenTree::Ident(_), _)) => true,
        Some((TokenTree::Punct(p), _)) => {
            p.as_char() == ';' || (ident == "rounding" && "<>=".contains(p.as_char()))
        }
        Some((TokenTree::Group(_) | TokenTree::Literal(_), _)) => ident == "continuity" || ident == "smooth",
    };
    PROPERTIES.into_iter().find(|p| alone && ident == p)
}

/// Whether two words follow, as in `partition of unity`; no expression begins like that.
fn two_words(input: ParseStream<'_>) -> bool {
    let Some((first, after)) = input.cursor().ident() else { return false };
    let same_line = |second: &Ident| second.span().start().line == first.span().end().line;
    first != "parallel" && after.ident().is_some_and(|(second, _)| second != "parallel" && same_line(&second))
}

/// Functions with which a claim may begin.
const CALLED: [&str; 4] = ["D", "integral", "sum", "product"];

/// A claim is about all values without being told so.
const FOR_ALL: &str = "a claim is about all values of its parameters; the loop of an index variable stands behind it: `b[i] >= 0 for i in 0..=3`";

/// The error for words that name no property.
fn unknown_property(input: ParseStream<'_>) -> syn::Error {
    let Some((word, after)) = input.cursor().ident() else { return unexpected(input, "a claim") };
    let text = word.to_string();
    let next = after.ident().map(|(word, _)| word.to_string()).unwrap_or_default();
    let help = match nearest(&text) {
        _ if text == "not" => format!("`refute {next};` claims that it is false"),
        _ if ["for", "forall", "all", "every", "each"].contains(&text.as_str()) => {
            let message = format!("`{text}` does not begin a claim");
            return error(word.span(), message, FOR_ALL);
        }
        _ if ["when", "where", "if", "with"].contains(&text.as_str()) => {
            let message = format!("`{text}` does not begin a claim");
            let help = "values are fixed by `at`: `prove at λ = 0 { b[0] = 1; }`";
            return error(word.span(), message, help);
        }
        _ if PROPERTIES.contains(&next.as_str()) => format!(
            "`{next}` is claimed of all functions, `prove {next};`; of one function write an inequality, `b[0] >= 0`"
        ),
        _ if CALLED.contains(&text.as_str()) => {
            let message = format!("the argument of `{text}` has no brackets");
            return error(word.span(), message, format!("write `{text}({})`", bare_argument(after)));
        }
        Some(near) => format!("did you mean `{near}`?"),
        None if text == "Σ" || text == "Π" => {
            let name = if text == "Σ" { "sum" } else { "product" };
            let message = format!("`{text}` is not a sign of the language");
            return error(word.span(), message, format!("write `{name}({next}[i] for i in 0..=n)`"));
        }
        None => of_papers(&text).unwrap_or_else(properties),
    };
    error(word.span(), format!("`{text}` is not a property"), help)
}

/// What is meant as the argument of a function that has no brackets: a name with what stands in brackets behind it, and the
/// loop over it.
fn bare_argument(from: Cursor<'_>) -> Rc<str> {
    let Some((_, mut end)) = from.ident() else { return "…".into() };
    while let Some((TokenTree::Group(_), after)) = end.token_tree() {
        end = after;
    }
    let argument = end;
    if end.ident().is_none_or(|(word, _)| word != "for") {
        return text_of(from, argument);
    }
    // `..=` is no comparison.
    let mut dots = false;
    while let Some((token, after)) = end.token_tree() {
        match &token {
            TokenTree::Punct(p) if p.as_char() == ';' => return text_of(from, argument),
            TokenTree::Punct(p) if "<>=".contains(p.as_char()) && !dots => return text_of(from, end),
            TokenTree::Punct(p) => dots = p.as_char() == '.',
            _ => dots = false,
        }
        end = after;
    }
    text_of(from, argument)
}

/// The property that a word resembles, begins, or ends in.
fn nearest(text: &str) -> Option<&'static str> {
    let last = text.rsplit('_').next().filter(|last| *last != text);
    crate::advice::closest(text, &PROPERTIES)
        .or_else(|| PROPERTIES.into_iter().find(|p| p.split('_').next() == Some(text)))
        .or_else(|| PROPERTIES.into_iter().find(|p| text.len() > 3 && p.starts_with(text)))
        .or_else(|| crate::advice::closest(last?, &PROPERTIES))
}

/// Properties that papers name and the language says otherwise.
const ELSEWHERE: [(&str, &str); 12] = [
    ("positive positivity", "claim `nonnegative`, or `b > 0` without zeros"),
    ("convex_hull convex_hull_property", "it follows from `partition_of_unity` and `nonnegative`"),
    ("affine_invariance affine_invariant", "it is what `partition_of_unity` says"),
    ("linear_precision reproduction", "write the sum, `sum(i/n*b[i] for i in 0..=n) = t`"),
    (
        "monotone monotonic monotonicity increasing decreasing",
        "claim the sign of a derivative, such as `D(b[0]) <= 0`",
    ),
    ("convex concave convexity", "claim the sign of a second derivative, such as `D(b[0], 2) >= 0`"),
    (
        "interpolation interpolatory endpoint_interpolation end_point_interpolation",
        "claim the values at the ends: `prove at t = 0 { b = [1, 0, 0]; }`",
    ),
    ("TP NTP STP total_positivity", "did you mean `totally_positive`?"),
    ("C G", "write `smooth(2)` of functions on several spans, `continuity(2)` of neighbouring segments"),
    ("variation_diminishing shape_preserving", "it follows from `totally_positive` and `partition_of_unity`"),
    ("normalized normalised normalization", "did you mean `partition_of_unity`?"),
    ("basis linearly_independent linear_independence", "did you mean `independent`?"),
];

/// What to write for `C2`, `continuous` or another word of papers.
fn of_papers(text: &str) -> Option<String> {
    if let Some(help) = translated(text, &ELSEWHERE) {
        return Some(help);
    }
    let order = match text.strip_prefix(['C', 'c']) {
        _ if text == "continuous" => 0,
        Some(order) => order.parse::<u8>().ok()?,
        None if text.strip_prefix(['G', 'g']).is_some_and(|order| order.parse::<u8>().is_ok()) => {
            let help = "of segments with one tangent write a theorem, `D(P)(1) parallel D(Q)(0)`; with equal derivatives claim `continuity(1)`";
            return Some(String::from(help));
        }
        None => return None,
    };
    Some(format!(
        "write `smooth({order})` of functions on several spans, `continuity({order})` of neighbouring segments"
    ))
}

fn properties() -> String {
    format!("claim a property ({}) or write an equation or inequality", PROPERTIES.join(", "))
}

/// `continuity(2)` after its first word.
fn continuity(input: ParseStream<'_>, word: proc_macro2::Span) -> Result<ClaimKind> {
    let order = order(input, word, "continuity")?;
    Ok(ClaimKind::Continuity(order, neighbours(input)?))
}

/// `smooth(1)` after its first word.
fn smooth(input: ParseStream<'_>, word: proc_macro2::Span) -> Result<ClaimKind> {
    order(input, word, "smooth").map(ClaimKind::Smooth)
}

/// The number of derivatives behind a property.
fn order(input: ParseStream<'_>, word: proc_macro2::Span, name: &str) -> Result<Expr> {
    if !matches!(input.cursor().token_tree(), Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Parenthesis)
    {
        return Err(error(
            word,
            format!("`{name}` needs the number of continuous derivatives"),
            match input.cursor().literal() {
                Some((number, _)) => format!("write `{name}({number})`"),
                None => format!("write `{name}(2)`"),
            },
        ));
    }
    let content;
    syn::parenthesized!(content in input);
    let order = expr(&content)?;
    if !content.is_empty() {
        let help = "the order alone stands in the parentheses, `smooth(1)`: it is claimed of all functions";
        return Err(error(content.span(), unexpected(&content, "`)`").to_string(), help));
    }
    Ok(order)
}

/// `with d0 = d1` after `continuity(2)`.
fn neighbours(input: ParseStream<'_>) -> Result<Vec<Binding>> {
    if !at_word(input, "with") {
        return Ok(Vec::new());
    }
    take_word(input)?;
    if input.peek(Token![;]) {
        let help =
            "write `with λ = 1/2` for the value there; a parameter that is not named is another free number";
        return Err(error(input.span(), "`with` needs a shape value of the next segment", help));
    }
    bindings(input)
}

/// `rounding <= 5` after its first word.
fn rounding(input: ParseStream<'_>, word: proc_macro2::Span) -> Result<ClaimKind> {
    match comparison(input)? {
        Some(Comparison::LessEqual) => Ok(ClaimKind::Rounding(expr(input)?)),
        _ => {
            Err(error(word, "`rounding` needs a bound of the errors", "write `rounding <= 5`, in units of ε"))
        }
    }
}

/// `except λ = -3, λ = 1` or `except (α = 0, β = 1)`: a list of exceptions, each one or several values.
fn exceptions(input: ParseStream<'_>, before: proc_macro2::Span) -> Result<Vec<Vec<Binding>>> {
    let mut all = Vec::new();
    if !at_word(input, "except") {
        return Ok(all);
    }
    take_word(input)?;
    if at_word(input, "at") {
        return Err(error(input.span(), "`at` does not follow after `except`", "write `except λ = -3`"));
    }
    if input.peek(Token![;]) {
        return Err(error(before, "`except` without a value", "write `except λ = -3`"));
    }
    if !begins_exception(input) {
        let found = unexpected(input, "the name of a parameter with its value").to_string();
        return Err(error(
            input.span(),
            found,
            "write `except λ = -3`, of several parameters `except (α = 0, β = 1)`",
        ));
    }
    loop {
        let exception = match input.cursor().token_tree() {
            Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Parenthesis => {
                let content;
                syn::parenthesized!(content in input);
                let all = bindings(&content)?;
                if !content.is_empty() {
                    let found = unexpected(&content, "`,` or `)`").to_string();
                    let help = "the values of one point are separated by commas: `except (α = -3, β = 0)`";
                    return Err(error(content.span(), found, help));
                }
                all
            }
            _ => vec![binding(input)?],
        };
        if exception.is_empty() {
            return Err(error(before, "`except` without a value", "write `except λ = -3`"));
        }
        all.push(exception);
        if !input.peek(Token![,]) {
            return Ok(all);
        }
        input.parse::<Token![,]>()?;
    }
}

/// Whether `λ = …`, `λ[1] = …` or `(…)` seems to follow.
fn begins_exception(input: ParseStream<'_>) -> bool {
    match input.cursor().token_tree() {
        Some((TokenTree::Group(g), _)) => g.delimiter() == Delimiter::Parenthesis,
        Some((TokenTree::Ident(_), after)) => match after.token_tree() {
            Some((TokenTree::Punct(sign), _)) => sign.as_char() != ';',
            next => matches!(next, Some((TokenTree::Group(_), _))),
        },
        _ => false,
    }
}

fn binding(input: ParseStream<'_>) -> Result<Binding> {
    let name = name(input)?;
    let mut indices = Vec::new();
    if matches!(input.cursor().token_tree(), Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Bracket)
    {
        let content;
        syn::bracketed!(content in input);
        indices = super::expr::list(&content, 0)?;
        if indices.is_empty() {
            let help = format!("write a number, such as `{}[1] = 0`", name.text);
            return Err(error(name.span, "an index is missing between the brackets", help));
        }
    }
    equals(input, &name)?;
    Ok(Binding { name, indices, value: expr(input)? })
}

fn bindings(input: ParseStream<'_>) -> Result<Vec<Binding>> {
    let mut all = vec![binding(input)?];
    while input.peek(Token![,]) {
        input.parse::<Token![,]>()?;
        all.push(binding(input)?);
    }
    Ok(all)
}

/// What is claimed elsewhere than at values.
const ON_A_PART: &str = "`at t = 0` fixes values; what is claimed on a part of the domain is claimed of a function with another argument, `b[0](t/2)` for `0 <= t <= 1/2`";

/// `at t = 0, λ = 1 { b = [1, 0]; D(b) = [-1, 1]; }`
fn at(input: ParseStream<'_>) -> Result<ClaimKind> {
    take_word(input)?;
    let start = input.fork();
    let fixed = bindings(input).map_err(|e| {
        // at 0 <= t <= 1/2: a part of the domain.
        let inequality = expr(&start).is_ok()
            && comparison(&start).is_ok_and(|sign| sign.is_some_and(|s| s != Comparison::Equal));
        if inequality {
            let help = format!("{ON_A_PART}; for some of the shape values declare a family with that range");
            return error(start.span(), "`at` fixes values, this is a range", help);
        }
        if input.fork().parse::<syn::Lit>().is_ok() {
            let help = "write `prove at t = 1/2 { b[0] = 1; }`, with the name of the variable and without a comma in a number";
            return error(input.span(), e.to_string(), help);
        }
        if input.peek(Token![in]) {
            return error(input.span(), "`at` fixes values, this is a range", ON_A_PART);
        }
        if input.peek(syn::token::Brace) || input.peek(syn::token::Paren) {
            let help =
                "write `prove at t = 0, λ = 1 { b[0] = 1; }`, with a comma between values and no parentheses";
            return error(input.span(), e.to_string(), help);
        }
        if is_missing_operator(&e) && at_word(input, "and") {
            let help =
                "values of several variables are separated by commas, `at t = 0, λ = 1 { … }`; each point has a block of its own";
            return error(input.span(), "`and` cannot be used here", help);
        }
        let braces = is_missing_semicolon(&e) || is_missing_operator(&e) && begins_equation(input);
        if !braces {
            return e;
        }
        // What follows on the right is meant to hold there.
        let found = unexpected(input, "`{` with the equations that hold there").to_string();
        error(input.span(), found, "write `prove at t = 0 { b[0] = 1; }`")
    })?;
    if !matches!(input.cursor().token_tree(), Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Brace)
    {
        let found = unexpected(input, "`{` with the equations that hold there");
        let help = if input.peek(Token![;]) || input.peek(Token![&&]) {
            "values are separated by commas: `prove at t = 0, λ = 1 { b[0] = 1; }`"
        } else {
            "write `prove at t = 0 { b[0] = 1; }`"
        };
        return Err(error(found.span(), found.to_string(), help));
    }
    let content;
    syn::braced!(content in input);
    let mut relations = Vec::new();
    while !content.is_empty() {
        if ["prove", "refute", "conjecture"].iter().any(|word| at_word(&content, word)) {
            let help = "the word stands before `at`, the block has equations: `prove at t = 0 { b[0] = 1; b[1] = 0; }`";
            return Err(error(content.span(), "no claim stands in a block", help));
        }
        let mut relation = relation(&content)?;
        if content.peek(Token![;]) {
            relation.last = content.parse::<Token![;]>()?.span;
            relations.push(relation);
        } else if !content.is_empty() {
            return Err(error(
                content.span(),
                unexpected(&content, "`;`").to_string(),
                "every equation in the block ends with `;`",
            ));
        } else {
            relations.push(relation);
        }
    }
    if relations.is_empty() {
        return Err(error(
            content.span(),
            "the block claims nothing",
            "write equations, such as `b = [1, 0, 0];`",
        ));
    }
    Ok(ClaimKind::At(fixed, relations))
}

/// Whether an equation or inequality follows, and not the block with them.
fn begins_equation(input: ParseStream<'_>) -> bool {
    let mut rest = input.cursor();
    while let Some((token, after)) = rest.token_tree() {
        match token {
            TokenTree::Punct(p) if "<>=".contains(p.as_char()) => return true,
            TokenTree::Punct(p) if p.as_char() == ';' => return false,
            TokenTree::Group(g) if g.delimiter() == Delimiter::Brace => return false,
            _ => rest = after,
        }
    }
    false
}

/// What is assumed of shape values: a relation.
pub(super) fn assumption(input: ParseStream<'_>) -> Result<Relation> {
    let ahead = input.fork();
    let left = expr(&ahead)?;
    if comparison(&ahead)?.is_none() {
        let found = unexpected(&ahead, "`<=`, `>=`, `<`, `>` or `=`").to_string();
        let help = if at_word(&ahead, "parallel") {
            "assumptions are about scalars; a point is determined by `let Q[1] = P[3] + δ*(P[3] - P[2]);`"
        } else {
            "write what is assumed as an inequality, `assume α + β <= 1;`, or a linear equation"
        };
        return Err(error(if ahead.is_empty() { left.span } else { ahead.span() }, found, help));
    }
    relation(input)
}

/// The most signs of a chain after the first one.
const MAX_CHAIN: usize = 15;

/// `left = right for i in 0..=n`, with any comparison, or a chain `a <= b <= c`.
pub(super) fn relation(input: ParseStream<'_>) -> Result<Relation> {
    let (start, first) = (input.span(), input.cursor());
    let single = first.ident();
    let left = expr(input)?;
    let Some(comparison) = comparison(input)? else {
        if let Some((word, _)) = &single
            && input.peek(Token![;])
        {
            let text = word.to_string();
            // `smooth(1)` and `continuity(1)` are about the whole family like the others.
            let counts = matches!(text.as_str(), "smooth" | "continuity");
            if counts && matches!(left.kind, ExprKind::Call(..)) {
                let help = format!(
                    "write `prove {text}(…);` outside of `at`; at fixed shape values, claim the equations of the derivatives"
                );
                let message = format!("`{text}` is a property of the whole family, not an equation");
                return Err(error(word.span(), message, help));
            }
            if text == "rounding" && matches!(left.kind, ExprKind::Call(..)) {
                let message = "`rounding` takes no arguments";
                return Err(error(word.span(), message, "write `rounding <= 5`, in units of ε"));
            }
            if PROPERTIES.contains(&text.as_str()) && matches!(left.kind, ExprKind::Call(..)) {
                let help = format!(
                    "write `prove {text};` for all functions; of one function write an inequality, `b[0] >= 0`"
                );
                return Err(error(word.span(), format!("`{text}` takes no arguments"), help));
            }
            if PROPERTIES.contains(&text.as_str()) {
                return Err(error(
                    word.span(),
                    format!("`{text}` is a property of the whole family, not an equation"),
                    format!(
                        "write `prove {text};` outside of `at`; at fixed shape values, claim its equations or inequalities, such as `b >= 0;`"
                    ),
                ));
            }
            let help = of_papers(&text)
                .or_else(|| Some(format!("did you mean `{}`?", nearest(&text)?)))
                .unwrap_or_else(properties);
            return Err(error(word.span(), format!("`{text}` is not a property"), help));
        }
        let word =
            single.map(|(word, _)| word.to_string()).filter(|word| PROPERTIES.contains(&word.as_str()));
        let help = match word {
            Some(word) if input.peek(Token![,]) || input.peek(Token![&&]) => {
                format!("write a statement for each claim: `prove {word};` and the next one by itself")
            }
            None if input.peek(Token![,]) => String::from(
                "write a statement for each claim, `prove b[0] >= 0;`, or a loop, `b[i] >= 0 for i in 0..=1`",
            ),
            _ if input.peek(Token![for]) => String::from(
                "a list stands in brackets, `[b[i](1) for i in 0..=1] = [0, 1]`; the loop of a claim stands behind it, `b[i](1) >= 0 for i in 0..=1`",
            ),
            _ if input.peek(Token![:]) => {
                String::from("claims have no names: a comment `/// …` before the claim says what it is")
            }
            _ => String::from("a claim is an equation or an inequality"),
        };
        let found = unexpected(input, "`=`, `<=`, `>=`, `<` or `>`").to_string();
        return Err(error(input.span(), found, help));
    };
    let right = expr(input)?;
    let mut chain = Vec::new();
    let mut last_sign = comparison;
    loop {
        let at = input.span();
        let Some(sign) = super::tokens::comparison(input)? else { break };
        let direction = |sign: Comparison| match sign {
            Comparison::Less | Comparison::LessEqual => -1,
            Comparison::Greater | Comparison::GreaterEqual => 1,
            Comparison::Equal | Comparison::NotEqual => 0,
        };
        let turns = direction(sign) * direction(last_sign) < 0;
        if turns || [sign, comparison].contains(&Comparison::NotEqual) {
            let message = if turns {
                format!("`{}` and `{}` do not make a chain", last_sign.symbol(), sign.symbol())
            } else {
                String::from("`!=` is not allowed in a chain")
            };
            return Err(error(at, message, "write a chain in one direction, `-1 <= x <= 1`, or two claims"));
        }
        if direction(sign) != 0 {
            last_sign = sign;
        }
        chain.push((sign, expr(input)?));
        if chain.len() > MAX_CHAIN {
            let help = "write several claims";
            return Err(error(at, format!("a chain has at most {} signs", MAX_CHAIN + 1), help));
        }
    }
    let sides = input.cursor();
    let loops = loops(input)?;
    let (text, range) = (text_of(first, sides), text_of(sides, input.cursor()));
    let last = chain.last().map_or(right.span, |(_, side)| side.span);
    let span = join(start, last);
    Ok(Relation { left, comparison, right, chain, loops, text, range, span, last })
}
