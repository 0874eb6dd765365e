//! Names of a spec as identifiers of Coq.

use std::collections::BTreeSet;

/// Words and names that have a meaning in the files that are written: keywords of Coq, and what statements and proofs
/// mention without a module in front.
const TAKEN: [&str; 76] = [
    "App",
    "Cut",
    "Definition",
    "Der",
    "Derive",
    "Diff",
    "Direct",
    "Excl",
    "Fn",
    "I",
    "IZR",
    "Incl",
    "Inf",
    "Int",
    "Lemma",
    "Num",
    "Opp",
    "Pow",
    "Prod",
    "Product",
    "Proof",
    "Prop",
    "Q",
    "Qed",
    "Quot",
    "R",
    "RInt",
    "Set",
    "Square",
    "Sum",
    "Theorem",
    "Type",
    "Var",
    "Z",
    "apply",
    "as",
    "at",
    "by",
    "box",
    "cofix",
    "cs",
    "derivative_by",
    "else",
    "end",
    "env",
    "equal_by",
    "ex",
    "exists",
    "exists2",
    "expr",
    "fix",
    "fn",
    "forall",
    "fr",
    "fun",
    "if",
    "in",
    "integral_by",
    "is",
    "is_RInt",
    "is_derive",
    "le_by",
    "let",
    "list",
    "lt_by",
    "match",
    "mod",
    "nat",
    "nil",
    "norm",
    "not",
    "nth",
    "pow",
    "return",
    "then",
    "where",
];

/// The identifiers of a file, each given once.
#[derive(Debug, Default)]
pub(super) struct Names {
    given: BTreeSet<String>,
}

impl Names {
    /// An identifier that resembles a name: `b[2,0]` becomes `b_2_0`. None of them contains a prime, so that names with
    /// one are free for other uses.
    pub(super) fn give(&mut self, name: &str) -> String {
        let plain = identifier(name);
        let mut new = plain.clone();
        let mut count = 1;
        while TAKEN.contains(&new.as_str()) || !self.given.insert(new.clone()) {
            count += 1;
            new = format!("{plain}_{count}");
        }
        new
    }
}

/// Letters and digits stay, and Greek letters; anything else becomes `_`, and `_` at the end is left out.
pub(super) fn identifier(name: &str) -> String {
    let mut text = String::new();
    for c in name.chars() {
        match c {
            'a'..='z' | 'A'..='Z' | '0'..='9' | 'α'..='ω' | 'Α'..='Ω' => text.push(c),
            _ if c.is_ascii() => text.push('_'),
            _ => text += &format!("u{:x}", u32::from(c)),
        }
    }
    let text = text.trim_end_matches('_');
    if text.starts_with(|c: char| c.is_alphabetic()) { text.to_string() } else { format!("x{text}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_identifiers_and_different() {
        let mut names = Names::default();
        assert_eq!(names.give("b[2,0,1]"), "b_2_0_1");
        assert_eq!(names.give("b_2_0_1"), "b_2_0_1_2");
        assert_eq!(names.give("λ1"), "λ1");
        assert_eq!(names.give("fun"), "fun_2");
        assert_eq!(names.give("R"), "R_2");
        assert_eq!(names.give("ж"), "u436");
        assert_eq!(names.give("_1"), "x_1");
    }
}
