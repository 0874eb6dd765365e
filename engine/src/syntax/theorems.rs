//! Statements of theorems and joins.

use proc_macro2::{Delimiter, Span, TokenTree};
use syn::parse::ParseStream;
use syn::{Result, Token};

use super::claims::assumption;
use super::error::{error, is_missing_semicolon};
use super::expr::{METHODS, expr, loops};
use super::ranges::{SHAPE_HELP, bounds};
use super::tokens::{comparison, join, name, unexpected};
use super::words::{Doc, at_word, doc, names_between, skip_statement, take_word, text_of};
use super::{
    Assertion, Comparison, Expected, Expr, ExprKind, PatchKind, SyntaxErrors, Theorem, TheoremKind,
    TheoremRelation, TheoremStatement, TheoremStatementKind,
};
use crate::advice::did_you_mean;
use basis_prover::collections::list::Listed;
use basis_prover::collections::sort::sort_unique;

/// The words that begin a statement.
const STATEMENTS: [&str; 11] = [
    "curve",
    "surface",
    "patch",
    "scalar",
    "assume",
    "let",
    "dimension",
    "prove",
    "refute",
    "conjecture",
    "budget",
];

/// `theorem Name { … }` or `join Name { … }`, after its doc comment.
pub(super) fn theorem(
    input: ParseStream<'_>,
    doc: Vec<String>,
    errors: &mut SyntaxErrors,
) -> Result<Theorem> {
    let kind = if at_word(input, "join") { TheoremKind::Join } else { TheoremKind::Theorem };
    take_word(input)?;
    if input.cursor().ident().is_none() {
        let help = format!("write `{} Name {{ … }}`", kind.keyword());
        return Err(error(input.span(), unexpected(input, "a name").to_string(), help));
    }
    let name = name(input)?;
    let next = match input.cursor().token_tree() {
        Some((TokenTree::Group(g), _)) => Some(g.delimiter()),
        _ => None,
    };
    if next == Some(Delimiter::Parenthesis) {
        let message = format!("a {} has no index parameters", kind.keyword());
        let help = "it is about one order of each family, which is named where the family is: `curve P = Bernstein(3);`";
        return Err(error(input.span(), message, help));
    }
    if next != Some(Delimiter::Brace) {
        return Err(unexpected(input, &format!("`{{` after `{} {}`", kind.keyword(), name.text)));
    }
    let content;
    syn::braced!(content in input);
    let mut statements = Vec::new();
    let mut incomplete = false;
    let mut unread = Vec::new();
    while !content.is_empty() {
        let start = content.fork();
        let declares = declares(&content);
        match statement(&content) {
            Ok(read) => statements.extend(read),
            Err(e) => {
                incomplete = true;
                let goes_on = is_missing_semicolon(&e);
                errors.push(e);
                if !goes_on {
                    skip_statement(&content);
                }
                if declares {
                    names_between(&start, &content, &mut unread);
                }
            }
        }
    }
    sort_unique(&mut unread);
    Ok(Theorem { doc, kind, name, statements, incomplete, unread })
}

/// Whether a statement may declare names: anything but a claim, a dimension or a budget.
fn declares(input: ParseStream<'_>) -> bool {
    let ahead = input.fork();
    let _ = doc(&ahead, Doc::Outer);
    !["prove", "refute", "conjecture", "dimension", "budget"].iter().any(|word| at_word(&ahead, word))
}

/// A statement; of scalars declared together, one for each.
fn statement(input: ParseStream<'_>) -> Result<Vec<TheoremStatement>> {
    let doc = doc(input, Doc::Outer)?;
    let start = input.span();
    let Some((word, after)) = input.cursor().ident() else { return Err(unexpected(input, "a statement")) };
    let word = word.to_string();
    if !STATEMENTS.contains(&word.as_str()) {
        let bracket = matches!(after.token_tree(), Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Bracket);
        let help = match word.as_str() {
            _ if bracket => format!("write `let {word}[…] = …;` to determine a control point"),
            _ if after.punct().is_some_and(|(sign, _)| sign.as_char() == '=') => format!(
                "write `curve {word} = Bernstein(3);` for a curve over a family, `let {word} = …;` for a number or a point"
            ),
            "point" | "vector" => String::from(
                "points are control points: `curve P = Bernstein(1);` has any two points, `P[0]` and `P[1]`",
            ),
            "domain" | "shape" => String::from(
                "families have domains and shape parameters; here a parameter is a scalar, `scalar 0 <= c <= 1;`",
            ),
            _ => did_you_mean(&word, &STATEMENTS, &|| {
                format!("statements here are `{}`", STATEMENTS.join("`, `"))
            }),
        };
        return Err(error(start, format!("`{word}` does not begin a statement of a theorem"), help));
    }
    take_word(input)?;
    let mut scalars = Vec::new();
    let kind = match word.as_str() {
        "scalar" => loop {
            let scalar = TheoremStatementKind::Scalar(bounds(input, SHAPE_HELP)?, loops(input)?);
            if !input.peek(Token![,]) {
                break scalar;
            }
            input.parse::<Token![,]>()?;
            scalars.push(scalar);
        },
        "assume" => TheoremStatementKind::Assume(assumption(input)?),
        "let" => {
            let target = target(input)?;
            let sign = input.span();
            if comparison(input)? != Some(Comparison::Equal) {
                let help = "a value is given by `let c = …;`, a range by `scalar 0 < c;`";
                return Err(error(sign, "expected `=` and a value", help));
            }
            let value = expr(input)?;
            TheoremStatementKind::Let(target, value, loops(input)?)
        }
        "dimension" => {
            super::words::no_equals(input, "dimension 2")?;
            TheoremStatementKind::Dimension(expr(input)?)
        }
        "budget" => {
            super::words::no_equals(input, "budget 10")?;
            TheoremStatementKind::Budget(expr(input)?)
        }
        "prove" | "refute" | "conjecture" => {
            let expected = Expected::of(&word).unwrap_or(Expected::True);
            TheoremStatementKind::Claim(assertion(input, expected)?)
        }
        _ => {
            let name = name(input)?;
            if comparison(input)? != Some(Comparison::Equal) {
                let help = if input.peek(Token![,]) {
                    format!("write a statement for each, `{word} {} = Bernstein(3);`", name.text)
                } else {
                    format!("write `{word} {} = Bernstein(3);`", name.text)
                };
                return Err(error(input.span(), unexpected(input, "`=` and a family").to_string(), help));
            }
            let kind = if word == "curve" { PatchKind::Curve } else { PatchKind::Surface };
            TheoremStatementKind::Patch(kind, name, expr(input)?)
        }
    };
    if !input.peek(Token![;]) {
        let message = unexpected(input, "`;` or an operator").to_string();
        let help = match &kind {
            TheoremStatementKind::Patch(..) if input.peek(syn::token::Brace) => {
                "control points stand in brackets: `curve P = Bernstein(1) [(0, 0), (1, 1)];`"
            }
            TheoremStatementKind::Patch(..) if input.peek(Token![=]) => {
                "control points follow at once: `curve P = Bernstein(1) [(0, 0), (1, 1)];`"
            }
            _ if input.peek(Token![.]) => METHODS,
            _ if !input.peek(Token![,]) && !input.peek(Token![&&]) && !input.peek(Token![||]) => {
                "a statement ends with `;`"
            }
            TheoremStatementKind::Claim(_) => "write two claims: a statement ends with `;`",
            TheoremStatementKind::Assume(_) if input.peek(Token![||]) => {
                "every assumption holds: write a theorem for each of the cases"
            }
            _ => "write two statements: a statement ends with `;`",
        };
        return Err(error(input.span(), message, help));
    }
    let end = input.parse::<Token![;]>()?.span;
    scalars.push(kind);
    let statement = |kind| TheoremStatement { doc: doc.clone(), span: join(start, end), last: end, kind };
    Ok(scalars.into_iter().map(statement).listed())
}

/// A name, or a name with indices, that gets a value.
fn target(input: ParseStream<'_>) -> Result<Expr> {
    let target = expr(input)?;
    let fine = match &target.kind {
        ExprKind::Name(_) => true,
        ExprKind::Index(base, _) => matches!(base.kind, ExprKind::Name(_)),
        _ => false,
    };
    if fine {
        return Ok(target);
    }
    let named = |all: &[Expr]| all.iter().all(|argument| matches!(argument.kind, ExprKind::Name(_)));
    let help = if matches!(&target.kind, ExprKind::Call(_, arguments) if named(arguments)) {
        "names with arguments stand in families; here write the expression where it is needed"
    } else {
        "write `let c = …;` or `let Q[1] = …;`: an equation is solved for the control point"
    };
    Err(error(target.span, "`let` gives a value to a name or to a control point", help))
}

/// `left == right for …`, with any comparison or `parallel`.
fn assertion(input: ParseStream<'_>, expected: Expected) -> Result<Assertion> {
    let (start, first) = (input.span(), input.cursor());
    if let Some((word, after)) = first.ident()
        && after.ident().is_some()
    {
        let word = word.to_string();
        let help = match word.as_str() {
            "at" => {
                "write the values as arguments, such as `prove P(0) == P[0];`, or declare a scalar with one value, `scalar 1 <= c <= 1;`"
            }
            "exists" => {
                "that a positive factor exists is claimed by `a parallel b`; any other one is written out"
            }
            "forall" | "all" | "for" => {
                "a claim is about all values in the declared ranges, `scalar 0 <= c <= 1;`; the loop of an index variable stands behind it: `P[i] == Q[i] for i in 0..=3`"
            }
            _ => "",
        };
        if !help.is_empty() {
            return Err(error(start, format!("`{word}` does not begin a claim of a theorem"), help));
        }
    }
    let left = expr(input)?;
    let relation = if at_word(input, "parallel") {
        take_word(input)?;
        TheoremRelation::Parallel
    } else {
        if input.peek(Token![|]) || input.peek(Token![||]) {
            let help = "write `a parallel b`: the same direction and the same sense";
            return Err(error(input.span(), "bars are not a relation between vectors", help));
        }
        match comparison(input)? {
            Some(sign) => TheoremRelation::Compare(sign),
            None => return Err(no_relation(input, &left)),
        }
    };
    let right = expr(input)?;
    if at_word(input, "parallel")
        || matches!(input.cursor().token_tree(), Some((TokenTree::Punct(p), _)) if "<>=".contains(p.as_char()))
    {
        return Err(error(input.span(), "a claim has two sides only", "write two claims"));
    }
    let loops = loops(input)?;
    let span: Span = join(start, right.span);
    let text = text_of(first, input.cursor());
    Ok(Assertion { expected, left, relation, right, loops, text, span })
}

fn no_relation(input: ParseStream<'_>, left: &Expr) -> syn::Error {
    if let (ExprKind::Name(word), true) = (&left.kind, input.peek(Token![;])) {
        let message = format!("`{word}` alone is not a claim of a theorem");
        let help = "properties such as `nonnegative` are claims of families; here write `… == …`, `… > …` or `… parallel …`";
        return error(left.span, message, help);
    }
    if let ExprKind::Call(callee, _) = &left.kind
        && matches!(&callee.kind, ExprKind::Name(word) if word == "parallel")
    {
        let help = "write `a parallel b`: the same direction and the same sense";
        return error(left.span, "`parallel` stands between two vectors", help);
    }
    let joint = |word: &str| {
        let order = word.strip_prefix(['C', 'G', 'c', 'g']).unwrap_or("0");
        word == "continuity" || word == "smooth" || word.len() == 2 && order.parse::<u8>().is_ok()
    };
    if let ExprKind::Call(callee, _) = &left.kind
        && let ExprKind::Name(word) = &callee.kind
        && joint(word)
    {
        let message = format!("`{word}` is not a claim of a theorem");
        let help = "write the equations of the joint: `prove P(1) == Q(0);` and `prove D(P)(1) == D(Q)(0);`, or `… parallel …` for the same tangent";
        return error(left.span, message, help);
    }
    let help = if input.peek(Token![.]) {
        "coordinates are written `P(t)[0]`, `P(t)[1]`"
    } else {
        "a claim is an equation, an inequality, or says that two vectors have the same direction"
    };
    error(input.span(), unexpected(input, "`==`, `<=`, `>=`, `<`, `>` or `parallel`").to_string(), help)
}
