//! Statements of a family, each read on its own so that one mistake does not hide the next.

use proc_macro2::{Delimiter, Span, TokenTree};
use syn::parse::ParseStream;
use syn::{Result, Token};

use super::claims::claim;
use super::error::{error, is_missing_semicolon};
use super::expr::{MAX_INDICES, comparison, expr, index_range, join, loops, name, unexpected};
use super::{
    Binding, Bounds, Comparison, Expr, ExprKind, Family, FunctionDef, Name, RangeDecl, Statement,
    StatementKind, SyntaxErrors,
};
use crate::advice::did_you_mean;
use basis_kernel::collections::sort::sort_unique;

/// The words that begin a statement.
pub(super) const STATEMENTS: [&str; 9] =
    ["domain", "shape", "let", "permute", "base", "raise", "prove", "refute", "budget"];

const DOMAIN_HELP: &str = "write a range with two ends, such as `domain 0 <= t <= 1;`";

/// What the range of a parameter may look like.
pub(super) const SHAPE_HELP: &str =
    "write a range such as `-3 <= λ <= 1`, `0 < λ`, or a name alone for all real numbers";

/// Whether the next token is this word.
pub(super) fn at_word(input: ParseStream<'_>, word: &str) -> bool {
    input.cursor().ident().is_some_and(|(ident, _)| ident == word)
}

/// Takes the next token, which is a word; its span.
pub(super) fn take_word(input: ParseStream<'_>) -> Result<Span> {
    use syn::ext::IdentExt;
    Ok(input.call(syn::Ident::parse_any)?.span())
}

/// `family Name(n in 1..=3) { … }`, after its doc comment.
pub(super) fn family(input: ParseStream<'_>, doc: Vec<String>, errors: &mut SyntaxErrors) -> Result<Family> {
    take_word(input)?;
    let name = name(input)?;
    let mut orders = Vec::new();
    if let Some((TokenTree::Group(g), _)) = input.cursor().token_tree()
        && g.delimiter() == Delimiter::Parenthesis
    {
        let content;
        syn::parenthesized!(content in input);
        while !content.is_empty() {
            orders.push(index_range(&content, "")?);
            if orders.len() > MAX_INDICES {
                let message = format!("a family has at most {MAX_INDICES} index parameters");
                return Err(error(name.span, message, "leave some of them out"));
            }
            if !content.is_empty() {
                content.parse::<Token![,]>().map_err(|_| unexpected(&content, "`,`"))?;
            }
        }
    }
    if !matches!(input.cursor().token_tree(), Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Brace)
    {
        return Err(unexpected(input, &format!("`{{` after `family {}`", name.text)));
    }
    let content;
    syn::braced!(content in input);
    let mut statements = Vec::new();
    let mut incomplete = false;
    let mut unread = Vec::new();
    while !content.is_empty() {
        let about_functions = !begins_claim(&content);
        let start = content.fork();
        match statement(&content) {
            Ok(statement) => statements.push(statement),
            Err(e) => {
                incomplete |= about_functions;
                let goes_on =
                    is_missing_semicolon(&e) || STATEMENTS.iter().any(|word| at_word(&content, word));
                errors.push(e);
                if !goes_on {
                    skip_statement(&content);
                }
                if about_functions {
                    names_between(&start, &content, &mut unread);
                }
            }
        }
    }
    sort_unique(&mut unread);
    Ok(Family { doc, name, orders, statements, incomplete, unread })
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

/// Whether a statement is a claim, perhaps with its first word misspelt: the functions do not depend on it.
fn begins_claim(input: ParseStream<'_>) -> bool {
    let ahead = input.fork();
    let _ = doc(&ahead, false);
    let Some((word, _)) = ahead.cursor().ident() else { return false };
    let word = word.to_string();
    ["prove", "refute", "budget"].contains(&crate::advice::closest(&word, &STATEMENTS).unwrap_or(&word))
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
        let written = if text.is_empty() { vec![""] } else { text.lines().collect() };
        lines.extend(
            written.into_iter().map(|line| line.strip_prefix(' ').unwrap_or(line).trim_end().to_string()),
        );
    }
    Ok(lines)
}

fn statement(input: ParseStream<'_>) -> Result<Statement> {
    let doc = doc(input, false)?;
    let start = input.span();
    let Some((TokenTree::Ident(word), after)) = input.cursor().token_tree() else {
        return Err(unexpected(input, "a statement"));
    };
    let kind = match word.to_string().as_str() {
        "domain" => {
            take_word(input)?;
            if let Some(names) = simplex(input)? {
                let end = semicolon(input, None)?;
                let kind = StatementKind::Simplex(names);
                return Ok(Statement { doc, span: join(start, end), last: end, kind });
            }
            let mut ranges = vec![range(input, DOMAIN_HELP)?];
            while input.peek(Token![,]) {
                input.parse::<Token![,]>()?;
                ranges.push(range(input, DOMAIN_HELP)?);
            }
            StatementKind::Domain(ranges)
        }
        "shape" => {
            take_word(input)?;
            StatementKind::Shape(range(input, SHAPE_HELP)?)
        }
        "let" => {
            take_word(input)?;
            let name = name(input)?;
            equals(input, &name)?;
            StatementKind::Let(name, expr(input)?)
        }
        "prove" | "refute" => {
            let claim = claim(input)?;
            StatementKind::Claim(claim)
        }
        "permute" => {
            take_word(input)?;
            StatementKind::Function(FunctionDef { permute: true, ..function(input)? })
        }
        "raise" => {
            take_word(input)?;
            StatementKind::Raise(function(input)?)
        }
        "base" => {
            take_word(input)?;
            base(input)?
        }
        "budget" => {
            take_word(input)?;
            StatementKind::Budget(expr(input)?)
        }
        other => match after.token_tree() {
            Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Bracket => {
                StatementKind::Function(function(input)?)
            }
            Some((TokenTree::Punct(p), _)) if p.as_char() == '=' => {
                return Err(error(
                    word.span(),
                    format!("`{other}` has no index"),
                    format!("write `{other}[0] = …;` for a basis function, `let {other} = …;` for a name"),
                ));
            }
            _ => return Err(unknown_statement(&word, other)),
        },
    };
    let end = semicolon(input, Some(&kind))?;
    Ok(Statement { doc, span: join(start, end), last: end, kind })
}

fn unknown_statement(word: &proc_macro2::Ident, text: &str) -> syn::Error {
    let help = did_you_mean(text, &STATEMENTS, &|| {
        String::from(
            "statements are `domain`, `shape`, `let`, `b[i] = …`, `permute`, `base`, `raise`, `prove`, `refute` and `budget`",
        )
    });
    error(word.span(), format!("`{text}` does not begin a statement"), help)
}

/// The `;` at the end of a statement; a block needs none.
fn semicolon(input: ParseStream<'_>, kind: Option<&StatementKind>) -> Result<Span> {
    if input.peek(Token![;]) {
        return Ok(input.parse::<Token![;]>()?.span);
    }
    match kind {
        Some(StatementKind::Claim(claim)) if matches!(claim.kind, super::ClaimKind::At(..)) => {
            return Ok(claim.keyword);
        }
        Some(StatementKind::Base(order, _)) => return Ok(order.name.span),
        _ => {}
    }
    let help = match kind {
        Some(StatementKind::Shape(_)) if input.peek(Token![,]) => {
            "every shape parameter has a statement of its own: `shape 0 <= λ <= 1; shape 0 <= μ <= 1;`"
        }
        Some(StatementKind::Claim(_)) if at_word(input, "except") => {
            "`except` belongs to `independent`; for other claims narrow the range of the parameter"
        }
        _ => "a statement ends with `;`",
    };
    Err(error(input.span(), unexpected(input, "`;` or an operator").to_string(), help))
}

/// `=` between a name and its value.
pub(super) fn equals(input: ParseStream<'_>, name: &Name) -> Result<()> {
    match comparison(input)? {
        Some(Comparison::Equal) => Ok(()),
        _ => Err(unexpected(input, &format!("`=` after `{}`", name.text))),
    }
}

fn function(input: ParseStream<'_>) -> Result<FunctionDef> {
    let name = name(input)?;
    let content;
    syn::bracketed!(content in input);
    let mut indices = Vec::new();
    while !content.is_empty() {
        indices.push(expr(&content)?);
        if !content.is_empty() {
            content.parse::<Token![,]>().map_err(|_| unexpected(&content, "`,`"))?;
        }
    }
    if indices.is_empty() {
        return Err(error(name.span, "the index is missing", format!("write `{}[0] = …;`", name.text)));
    }
    if indices.len() > MAX_INDICES {
        let message = format!("a function has at most {MAX_INDICES} indices");
        return Err(error(name.span, message, "number the functions with fewer indices"));
    }
    equals(input, &name)?;
    let value = expr(input)?;
    let loops = loops(input)?;
    Ok(FunctionDef { permute: false, name, indices, value, loops })
}

/// `base n = 3 { … }` after its first word.
fn base(input: ParseStream<'_>) -> Result<StatementKind> {
    let name = name(input)?;
    equals(input, &name)?;
    let value = expr(input)?;
    if !matches!(input.cursor().token_tree(), Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Brace)
    {
        return Err(unexpected(input, "`{` with the functions of the lowest order"));
    }
    let content;
    syn::braced!(content in input);
    let mut functions = Vec::new();
    while !content.is_empty() {
        let permute = at_word(&content, "permute");
        if permute {
            take_word(&content)?;
        }
        functions.push(FunctionDef { permute, ..function(&content)? });
        semicolon(&content, None)?;
    }
    Ok(StatementKind::Base(Binding { name, value }, functions))
}

/// `triangle (u, v, w)` or `tetrahedron (u, v, w, x)`; `None` when something else follows.
fn simplex(input: ParseStream<'_>) -> Result<Option<Vec<Name>>> {
    let Some((word, after)) = input.cursor().ident() else { return Ok(None) };
    let text = word.to_string();
    match after.token_tree() {
        Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Parenthesis => {}
        Some((TokenTree::Ident(_), _)) if text == "triangle" => {
            let help = "write `domain triangle (u, v, w);`";
            return Err(error(word.span(), "a triangle needs its coordinates in parentheses", help));
        }
        Some((TokenTree::Ident(_), _)) if text == "tetrahedron" => {
            let help = "write `domain tetrahedron (u, v, w, x);`";
            return Err(error(word.span(), "a tetrahedron needs its coordinates in parentheses", help));
        }
        _ => return Ok(None),
    }
    let corners = match text.as_str() {
        "triangle" => 3,
        "tetrahedron" => 4,
        _ => {
            let help = did_you_mean(&text, &["triangle", "tetrahedron"], &|| {
                String::from(
                    "write `triangle (u, v, w)`, `tetrahedron (u, v, w, x)` or a range, `0 <= t <= 1`",
                )
            });
            return Err(error(word.span(), format!("`{text}` is not a domain"), help));
        }
    };
    take_word(input)?;
    let example = if corners == 3 { "triangle (u, v, w)" } else { "tetrahedron (u, v, w, x)" };
    let content;
    syn::parenthesized!(content in input);
    let mut names = Vec::new();
    while !content.is_empty() {
        names.push(self::name(&content)?);
        if !content.is_empty() {
            content.parse::<Token![,]>().map_err(|_| unexpected(&content, "`,`"))?;
        }
    }
    if names.len() != corners {
        let here = crate::plural::here(names.len());
        let message = format!("a {text} has {corners} barycentric coordinates, {here}");
        let help = match names.len() {
            3 => String::from("write `domain tetrahedron (u, v, w, x);`, or `domain triangle (u, v, w);`"),
            4 => String::from("write `domain triangle (u, v, w);`, or `domain tetrahedron (u, v, w, x);`"),
            _ => format!("write `domain {example};`"),
        };
        return Err(error(word.span(), message, help));
    }
    Ok(Some(names))
}

/// A range as papers write it: `0 <= t <= 1`, `0 < λ`, `λ >= -2`, or a name alone for all real numbers.
fn range(input: ParseStream<'_>, help: &str) -> Result<RangeDecl> {
    let Bounds { target, low, high } = bounds(input, false, help)?;
    let ExprKind::Name(text) = target.kind else { return Err(unexpected(input, "a name")) };
    Ok(RangeDecl { name: Name { text, span: target.span }, low, high })
}

/// A range as papers write it, whose name may have an index, `-3 < γ[1]`, if that is `indexed`.
pub(super) fn bounds(input: ParseStream<'_>, indexed: bool, help: &str) -> Result<Bounds> {
    let start = input.span();
    let mut parts = vec![expr(input)?];
    let mut signs = Vec::new();
    loop {
        let at = input.span();
        let Some(sign) = comparison(input)? else { break };
        signs.push((sign, at));
        parts.push(expr(input)?);
    }
    if at_word(input, "in") {
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
                let help = "a range of one value is written `1 <= λ <= 1`";
                return Err(error(*span, "a range is made of inequalities, this is an equation", help));
            }
            _ => return Err(error(*span, format!("`{}` does not fit in this range", sign.symbol()), help)),
        });
    }
    let is_target = |e: &Expr| match &e.kind {
        ExprKind::Name(_) => true,
        ExprKind::Index(base, _) => indexed && matches!(base.kind, ExprKind::Name(_)),
        _ => false,
    };
    let target = |e: Expr| {
        if is_target(&e) { Ok(e) } else { Err(error(e.span, "expected the name whose range this is", help)) }
    };
    let mut parts = parts.into_iter();
    match (parts.next(), parts.next(), parts.next(), included.as_slice()) {
        (Some(only), None, None, []) => Ok(Bounds { target: target(only)?, low: None, high: None }),
        (Some(a), Some(b), None, [i]) => {
            if is_target(&b) {
                Ok(Bounds { target: b, low: Some((a, *i)), high: None })
            } else if !is_target(&a) && matches!(a.kind, ExprKind::Number(_)) {
                target(b).map(|target| Bounds { target, low: Some((a, *i)), high: None })
            } else {
                Ok(Bounds { target: target(a)?, low: None, high: Some((b, *i)) })
            }
        }
        (Some(a), Some(b), Some(c), [i, j]) => {
            Ok(Bounds { target: target(b)?, low: Some((a, *i)), high: Some((c, *j)) })
        }
        _ => Err(error(start, "a range has at most two ends", help)),
    }
}
