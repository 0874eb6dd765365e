//! One mistake, one error: what follows from a mistake is not said again.
//!
//! Tokens of shipped specs are left out, one at a time, and operators replaced; the errors are counted that
//! reading and expanding gives, verdicts of claims apart. With `BASIS_TESTS=list` and `--nocapture` all tokens are
//! taken, and the mutants with more than one error printed.

use basis_engine::{Disk, Library, Prover, Selected, Source};

const SPECS: [(&str, &str); 6] = [
    ("quartic", include_str!("../../../specs/quartic.basis")),
    ("cardinal", include_str!("../../../specs/cardinal.basis")),
    ("hermite", include_str!("../../../specs/hermite.basis")),
    ("smoothstep", include_str!("../../../specs/smoothstep.basis")),
    ("elements", include_str!("../../../specs/elements.basis")),
    ("quadratic", include_str!("../../../specs/quadratic.basis")),
];

/// An ordinary run leaves out every fourth token; all of them take a minute.
const STEP: usize = 4;

/// The tokens of a spec as ranges of bytes: names, numbers, operators of two characters, everything else alone.
fn tokens(text: &str) -> Vec<core::ops::Range<usize>> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let word = |c: char| c.is_alphanumeric() || c == '_';
        let len = if rest.starts_with("//") {
            at += rest.find('\n').unwrap_or(rest.len());
            continue;
        } else if c.is_whitespace() {
            at += c.len_utf8();
            continue;
        } else if word(c) {
            rest.find(|c| !word(c)).unwrap_or(rest.len())
        } else if c == '"' {
            rest[1..].find('"').map_or(1, |end| end + 2)
        } else if ["..=", "<=", ">=", "==", "!="].iter().any(|sign| rest.starts_with(sign)) {
            if rest.starts_with("..=") { 3 } else { 2 }
        } else {
            c.len_utf8()
        };
        tokens.push(at..at + len);
        at += len;
    }
    tokens
}

fn errors(text: &str) -> Vec<String> {
    let library = Library::from_source(&Disk, &Prover, Source::text("mutant.basis", text));
    library.items(Selected::EveryOrder);
    basis_engine::theorem::theorems(&library);
    let sources = library.sources();
    let place = |d: &basis_engine::Diagnostic| d.line_column(sources).unwrap_or_default();
    library.diagnostics().iter().map(|d| format!("{:?} {}", place(d), d.message)).collect()
}

#[test]
fn one_error_for_one_mistake() {
    let list = std::env::var_os("BASIS_TESTS").is_some_and(|v| v == "list");
    let (mut broken, mut several, mut worst) = (0, 0, 0);
    for (name, text) in SPECS {
        assert_eq!(errors(text), Vec::<String>::new(), "{name}");
        for token in tokens(text).into_iter().step_by(if list { 1 } else { STEP }) {
            let old = &text[token.clone()];
            let by: &[&str] = match old {
                "+" | "-" | "*" => &["", "/"],
                "=" | "<=" => &["", "<"],
                ";" => &["", ","],
                "," => &["", ";"],
                _ if old.starts_with(char::is_alphabetic) => &["", "zzz"],
                _ => &[""],
            };
            for new in by {
                let mut mutant = text.to_string();
                mutant.replace_range(token.clone(), new);
                let found = errors(&mutant);
                broken += usize::from(!found.is_empty());
                several += usize::from(found.len() > 1);
                worst = worst.max(found.len());
                if list && found.len() > 1 {
                    let line = text[..token.start].matches('\n').count();
                    println!(
                        "{name} `{old}` -> `{new}`: {}",
                        text.lines().nth(line).unwrap_or_default().trim()
                    );
                    println!("      {}", found.join("\n      "));
                }
            }
        }
    }
    println!("{broken} mutants with errors, {several} with more than one, at most {worst}");
    assert!(broken > 900, "only {broken} mutants have errors");
    assert!(
        several * 50 < broken && worst < 5,
        "{several} of {broken} mutants have more errors than mistakes, up to {worst}"
    );
}

/// A mistake in one claim about spans is said once, and the other claims are decided.
#[test]
fn claims_beside_a_mistaken_one() {
    let text = "family F {
        domain 0 <= x <= 1, 1 <= x <= 2;
        f[0] = x | 2 - x;
        prove nonnegative;
        prove f[3] >= 0;
        prove f[0] <= 1/(x - 3/2);
        prove smooth(0);
    }";
    assert_eq!(
        errors(text),
        ["(5, 15) there is no function `f[3]`", "(6, 25) the denominator vanishes at x = 3/2"]
    );
    let library = Library::from_source(&Disk, &Prover, Source::text("spans.basis", text));
    let items = library.items(Selected::EveryOrder);
    let claims: Vec<&str> = items[0].claims.iter().map(|c| c.text.as_str()).collect();
    assert_eq!(claims, ["nonnegative", "smooth(0)"]);
}
