//! Statements of a family, each read on its own so that one mistake does not hide the next.

use proc_macro2::{Delimiter, TokenTree};
use syn::parse::ParseStream;
use syn::{Result, Token};

use super::claims::claim;
use super::ending::semicolon;
use super::error::{error, is_missing_semicolon};
use super::expr::{MAX_INDICES, expr, index_range, loops};
use super::ranges::{self, range};
use super::tokens::{join, name, unexpected};
use super::words::{Doc, at_word, doc, equals, names_between, skip_statement, take_word};
use super::{
    Binding, ExprKind, Factor, Family, FunctionDef, Name, NameDef, Statement, StatementKind, SyntaxErrors,
};
use crate::advice::{did_you_mean, translated};
use basis_prover::collections::sort::sort_unique;

/// The words that begin a statement.
pub(super) const STATEMENTS: [&str; 11] = [
    "domain",
    "shape",
    "assume",
    "let",
    "permute",
    "base",
    "raise",
    "prove",
    "refute",
    "conjecture",
    "budget",
];

/// The most spans of a domain.
pub(crate) const MAX_SPANS: usize = 64;

const NAME_HELP: &str =
    "a name begins with a letter, and is made of letters, digits and `_`: `family Cubic3 { … }`";

const DOMAIN_HELP: &str = "write a range with two ends, such as `domain 0 <= t <= 1;`";

/// `family Name(n in 1..=3) { … }`, after its doc comment.
pub(super) fn family(input: ParseStream<'_>, doc: Vec<String>, errors: &mut SyntaxErrors) -> Result<Family> {
    take_word(input)?;
    if input.cursor().ident().is_none() {
        let found = unexpected(input, "a name");
        let help = if input.cursor().literal().is_some() { NAME_HELP } else { "write `family Name { … }`" };
        return Err(error(found.span(), found.to_string(), help));
    }
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
        let found = unexpected(input, &format!("`{{` after `family {}`", name.text));
        if !input.peek(Token![-]) && !input.peek(Token![.]) {
            return Err(error(
                found.span(),
                found.to_string(),
                format!("write `family {} {{ … }}`", name.text),
            ));
        }
        // What was a part of the name is not read as another mistake.
        while !input.is_empty() && !input.peek(syn::token::Brace) {
            input.parse::<TokenTree>()?;
        }
        return Err(error(found.span(), found.to_string(), NAME_HELP));
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

/// Whether a statement is a claim, perhaps with its first word misspelt: the functions do not depend on it.
fn begins_claim(input: ParseStream<'_>) -> bool {
    let ahead = input.fork();
    let _ = doc(&ahead, Doc::Outer);
    let Some((word, _)) = ahead.cursor().ident() else { return false };
    let word = word.to_string();
    ["prove", "refute", "conjecture", "budget"]
        .contains(&crate::advice::closest(&word, &STATEMENTS).unwrap_or(&word))
}

fn statement(input: ParseStream<'_>) -> Result<Statement> {
    let doc = doc(input, Doc::Outer)?;
    let start = input.span();
    let Some((TokenTree::Ident(word), after)) = input.cursor().token_tree() else {
        return Err(unexpected(input, "a statement"));
    };
    let kind = match word.to_string().as_str() {
        "domain" => {
            take_word(input)?;
            domain(input)?
        }
        "shape" => {
            take_word(input)?;
            let mut shapes = vec![ranges::shapes(input)?];
            while input.peek(Token![,]) {
                input.parse::<Token![,]>()?;
                shapes.push(ranges::shapes(input)?);
            }
            StatementKind::Shape(shapes)
        }
        "assume" => {
            take_word(input)?;
            StatementKind::Assume(super::claims::assumption(input)?)
        }
        "let" => {
            take_word(input)?;
            StatementKind::Let(definition(input)?)
        }
        word @ ("prove" | "refute" | "conjecture") if input.peek2(Token![;]) => {
            let help = format!("write what is claimed, such as `{word} nonnegative;`");
            let keyword = input.span();
            take_word(input)?;
            return Err(error(keyword, "nothing is claimed", help));
        }
        "prove" | "refute" | "conjecture" => {
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
            super::words::no_equals(input, "budget 10")?;
            StatementKind::Budget(expr(input)?)
        }
        other => match after.token_tree() {
            Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Bracket => {
                StatementKind::Function(function(input)?)
            }
            Some((TokenTree::Punct(p), value)) if p.as_char() == '=' => {
                // `b_0` and `b0` are written for `b[0]`.
                let stem = other.trim_end_matches(|c: char| c.is_ascii_digit());
                let number = &other[stem.len()..];
                let (stem, number) = match stem.trim_end_matches('_') {
                    "" => (other, "0"),
                    stem if !number.is_empty() => (stem, number),
                    _ => (other, "0"),
                };
                if matches!(value.token_tree(), Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Bracket)
                {
                    let help = format!("write each function by itself, `{other}[0] = …; {other}[1] = …;`");
                    return Err(error(word.span(), format!("`{other}` has no index"), help));
                }
                return Err(error(
                    word.span(),
                    format!("`{other}` has no index"),
                    format!(
                        "write `{stem}[{number}] = …;` for a basis function, `let {other} = …;` for a name"
                    ),
                ));
            }
            Some((TokenTree::Group(g), rest))
                if g.delimiter() == Delimiter::Parenthesis
                    && matches!(rest.punct(), Some((p, _)) if p.as_char() == '=') =>
            {
                let stem = other.trim_end_matches(|c: char| c.is_ascii_digit());
                let number = Some(&other[stem.len()..]).filter(|digits| !digits.is_empty()).unwrap_or("0");
                let stem = Some(stem.trim_end_matches('_')).filter(|stem| !stem.is_empty()).unwrap_or(other);
                return Err(error(
                    word.span(),
                    format!("`{other}` does not begin a statement"),
                    format!(
                        "write `{stem}[{number}] = …;` for a basis function, `let {other}(t) = …;` for a name with an argument"
                    ),
                ));
            }
            Some((TokenTree::Ident(within), _)) if within == "in" => {
                let message = format!("`{other}` does not begin a statement");
                let help = format!(
                    "write `domain 0 <= {other} <= 1;` for the variable, `shape 0 <= {other} <= 1;` for a shape parameter"
                );
                return Err(error(word.span(), message, help));
            }
            _ => return Err(unknown_statement(&word, other)),
        },
    };
    let end = semicolon(input, Some(&kind))?;
    Ok(Statement { doc, span: join(start, end), last: end, kind })
}

/// Words with which statements begin elsewhere, and what to write.
const ELSEWHERE: [(&str, &str); 19] = [
    ("for foreach loop", "a loop stands behind the formula: `b[i] = t^i for i in 0..=3;`"),
    ("parameter parameters param params", "write `shape -1 <= λ <= 1;` for a shape parameter"),
    ("claim claims assert lemma show property ensure check verify proof prop", "write `prove …;`"),
    ("theorem join", "it stands outside of the family"),
    ("disprove deny", "write `refute …;`"),
    ("define def set var where", "write `let c = …;` for a name, `b[0] = …;` for a basis function"),
    ("variable variables interval", "write `domain 0 <= t <= 1;`"),
    (
        "span spans piece pieces piecewise segment",
        "spans follow one another in the domain, and in each function: `domain 0 <= t <= 1, 1 <= t <= 2;` and `b[0] = t | 2 - t;`",
    ),
    ("over denominator denom weight weights", "divide in the formulas: `let w = 1 + t; b[0] = 1/w;`"),
    (
        "angle frequency scale tension",
        "an angle, or a frequency, is the end of the domain: `shape 0 < α < pi; domain 0 <= t <= α;`",
    ),
    ("periodic period", "claim it of the functions: `prove b[1] = b[0](t + pi/2);`"),
    (
        "values vector components",
        "the values are numbers: write a function for each component, `b[i, 0] = …; b[i, 1] = …;`",
    ),
    ("scalar", "a parameter of a family is `shape 0 <= λ <= 1;`; scalars belong to theorems"),
    ("fn function", "a name with an argument is `let h(x) = x^2;`"),
    ("at", "write `prove at t = 0 { b[0] = 1; }`"),
    (
        "partition_of_unity nonnegative symmetric independent continuity smooth totally_positive rounding",
        "write `prove` before it",
    ),
    ("use", "it stands at the beginning of the file, outside of the family"),
    (
        "curve surface patch",
        "curves belong to theorems: `theorem Name { curve P = Family; … }` outside of the family",
    ),
    ("knots knot", "knots are the ends of spans: `domain 0 <= t <= 1, 1 <= t <= 2;`"),
];

fn unknown_statement(word: &proc_macro2::Ident, text: &str) -> syn::Error {
    let others = || translated(text, &ELSEWHERE);
    let help = did_you_mean(text, &STATEMENTS, &|| {
        if let Some(help) = others() {
            return help;
        }
        String::from(
            "statements are `domain`, `shape`, `assume`, `let`, `b[i] = …`, `permute`, `base`, `raise`, `prove`, `refute`, `conjecture` and `budget`",
        )
    });
    error(word.span(), format!("`{text}` does not begin a statement"), help)
}

/// `c = …` or `h(x, y) = …` after `let`.
fn definition(input: ParseStream<'_>) -> Result<NameDef> {
    let name = name(input)?;
    let mut parameters: Vec<Name> = Vec::new();
    match input.cursor().token_tree() {
        Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Parenthesis => {
            let content;
            syn::parenthesized!(content in input);
            while !content.is_empty() {
                let parameter = self::name(&content)?;
                // Too many are an error of their own.
                if parameters.iter().take(MAX_INDICES).any(|known| known.text == parameter.text) {
                    let message = format!("the argument `{}` is named twice", parameter.text);
                    return Err(error(parameter.span, message, "give every argument a name of its own"));
                }
                parameters.push(parameter);
                if !content.is_empty() {
                    content.parse::<Token![,]>().map_err(|_| {
                        let found = unexpected(&content, "`,`").to_string();
                        let help = "the arguments of a name are names themselves: `let h(x) = x^2;`";
                        error(content.span(), found, help)
                    })?;
                }
            }
            if parameters.is_empty() || parameters.len() > MAX_INDICES {
                let message = match parameters.len() {
                    0 => format!("`{}` has brackets without arguments", name.text),
                    _ => format!("a name has at most {MAX_INDICES} arguments"),
                };
                let help = format!("write `let {} = …;` or `let {}(x) = …;`", name.text, name.text);
                return Err(error(name.span, message, help));
            }
        }
        Some((TokenTree::Group(g), _)) if g.delimiter() == Delimiter::Bracket => {
            let found = unexpected(input, &format!("`=` after `{}`", name.text)).to_string();
            let help = format!(
                "a list is given as a whole: `let {} = [-1, 0, 1];` or `let {} = [i/2 for i in 0..=2];`",
                name.text, name.text
            );
            return Err(error(g.span_open(), found, help));
        }
        _ => {}
    }
    equals(input, &name)?;
    Ok(NameDef { name, parameters, value: expr(input)? })
}

fn function(input: ParseStream<'_>) -> Result<FunctionDef> {
    let name = name(input)?;
    let content;
    syn::bracketed!(content in input);
    let mut indices = Vec::new();
    while !content.is_empty() {
        indices.push(expr(&content)?);
        if !content.is_empty() {
            content.parse::<Token![,]>().map_err(|_| {
                let found = unexpected(&content, "`,`");
                if !content.peek(Token![for]) {
                    return found;
                }
                let help = format!("the range follows the formula: `{}[i] = … for i in 0..=n;`", name.text);
                error(content.span(), found.to_string(), help)
            })?;
        }
    }
    if indices.is_empty() {
        return Err(error(name.span, "the index is missing", format!("write `{}[0] = …;`", name.text)));
    }
    if indices.len() > MAX_INDICES {
        let message = format!("a function has at most {MAX_INDICES} indices");
        return Err(error(name.span, message, "number the functions with fewer indices"));
    }
    if input.peek(syn::token::Bracket) {
        let found = unexpected(input, &format!("`=` after `{}[…]`", name.text));
        let help = format!("all indices stand in one pair of brackets: `{}[1, 0, 0] = …;`", name.text);
        return Err(error(found.span(), found.to_string(), help));
    }
    equals(input, &name)?;
    let value = expr(input)?;
    let mut further = Vec::new();
    while input.peek(Token![|]) && !input.peek(Token![||]) {
        input.parse::<Token![|]>()?;
        further.push(expr(input)?);
        if further.len() == MAX_SPANS {
            let help = "leave some of the spans out";
            return Err(error(name.span, format!("a function has at most {MAX_SPANS} spans"), help));
        }
    }
    let loops = loops(input)?;
    Ok(FunctionDef { permute: false, name, indices, value, further, loops })
}

/// `base n = 3 { … }` after its first word.
fn base(input: ParseStream<'_>) -> Result<StatementKind> {
    if input.peek(syn::token::Brace) {
        let found = unexpected(input, "the index parameter").to_string();
        return Err(error(input.span(), found, "name the lowest order: `base n = 1 { … }`"));
    }
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
    Ok(StatementKind::Base(Binding { name, indices: Vec::new(), value }, functions))
}

/// The factors of a domain, `0 <= t <= 1` or `triangle (u, v, w), -1 <= z <= 1`, after its first word.
fn domain(input: ParseStream<'_>) -> Result<StatementKind> {
    let (mut factors, mut ranges) = (Vec::new(), Vec::new());
    loop {
        match simplex(input)? {
            Some(names) => {
                factors.extend(ranges.drain(..).map(Factor::Range));
                factors.push(Factor::Simplex(names));
                if !input.is_empty() && !input.peek(Token![,]) && !input.peek(Token![;]) {
                    return Err(error(
                        input.span(),
                        unexpected(input, "`,` or `;`").to_string(),
                        "the factors of a domain are separated by commas: `domain triangle (u, v, w), -1 <= z <= 1;`",
                    ));
                }
            }
            None => {
                no_equation(input)?;
                ranges.push(range(input, DOMAIN_HELP)?);
            }
        }
        if !input.peek(Token![,]) {
            break;
        }
        input.parse::<Token![,]>()?;
    }
    if factors.is_empty() {
        return Ok(StatementKind::Domain(ranges));
    }
    factors.extend(ranges.into_iter().map(Factor::Range));
    Ok(StatementKind::Product(factors))
}

/// Refuses an equation in a domain, of barycentric coordinates or of a function.
fn no_equation(input: ParseStream<'_>) -> Result<()> {
    let ahead = input.fork();
    let Ok(left) = expr(&ahead) else { return Ok(()) };
    let help = match left.kind {
        _ if !ahead.peek(Token![=]) => return Ok(()),
        ExprKind::Sum(_) => {
            "barycentric coordinates, whose sum is 1, are declared by `domain triangle (u, v, w);` or `domain tetrahedron (u, v, w, x);`"
        }
        ExprKind::Index(..) => "functions are statements of their own: the domain ends with `;`",
        _ => return Ok(()),
    };
    Err(error(ahead.span(), "a range is made of inequalities, this is an equation", help))
}

/// `triangle (u, v, w)` or `tetrahedron (u, v, w, x)`; `None` when something else follows.
fn simplex(input: ParseStream<'_>) -> Result<Option<Vec<Name>>> {
    let Some((word, after)) = input.cursor().ident() else { return Ok(None) };
    let text = word.to_string();
    let is_simplex = matches!(text.as_str(), "triangle" | "tetrahedron");
    match after.token_tree() {
        Some((TokenTree::Group(g), rest)) if g.delimiter() == Delimiter::Parenthesis => {
            let last = match rest.token_tree() {
                Some((TokenTree::Punct(p), _)) => matches!(p.as_char(), ',' | ';'),
                other => other.is_none(),
            };
            // The lower end of a range, as `factorial(2) <= t <= 3`.
            if !is_simplex && !last {
                return Ok(None);
            }
        }
        Some((TokenTree::Group(g), _)) if is_simplex && g.delimiter() != Delimiter::Parenthesis => {
            let coordinates = if text == "triangle" { "u, v, w" } else { "u, v, w, x" };
            let help = format!("write `domain {text} ({coordinates});`");
            return Err(error(word.span(), format!("a {text} needs its coordinates in parentheses"), help));
        }
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
        "prism" | "wedge" => {
            let help = "a prism is a product: write `domain triangle (u, v, w), -1 <= z <= 1;`";
            return Err(error(word.span(), format!("`{text}` is not a domain"), help));
        }
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
