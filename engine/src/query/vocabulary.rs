//! The words of the language, each with what it means in a sentence: for completion, for hovering, and to know which
//! words are not names.

/// A word of the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// As it is written.
    pub text: &'static str,
    /// Where it is used.
    pub kind: WordKind,
    /// What follows it when it is inserted, `$0` where the cursor is then; empty if it stands alone.
    pub rest: &'static str,
    /// What it means.
    pub meaning: &'static str,
}

/// Where a word is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WordKind {
    /// It begins an item.
    Item,
    /// It begins a statement of a family.
    Statement,
    /// It begins a statement of a theorem or join.
    TheoremStatement,
    /// It begins a statement of either.
    EitherStatement,
    /// It is claimed of a whole family.
    Property,
    /// It is a function in formulas, with arguments in round brackets.
    Function,
    /// It joins parts of a statement.
    Connective,
}

impl WordKind {
    /// Whether statements begin with words of this kind.
    pub(super) const fn begins_statement(self) -> bool {
        matches!(self, Self::Statement | Self::TheoremStatement | Self::EitherStatement)
    }
}

const fn entry(text: &'static str, kind: WordKind, rest: &'static str, meaning: &'static str) -> Word {
    Word { text, kind, rest, meaning }
}

use WordKind::{Connective, EitherStatement, Function, Item, Property, Statement, TheoremStatement};

/// All words.
pub const WORDS: [Word; 59] = [
    entry(
        "family",
        Item,
        " $0 {\n    domain 0 <= t <= 1;\n}",
        "basis functions on a domain, with their claims",
    ),
    entry("theorem", Item, " $0 {\n}", "claims about curves and surfaces over families"),
    entry(
        "join",
        Item,
        " $0 {\n}",
        "a theorem that becomes a function: it computes the control points that `let` determines",
    ),
    entry(
        "use",
        Item,
        " \"$0.basis\";",
        "makes the families of another file visible; `use library \"quartic\";` those of a shipped spec",
    ),
    entry("library", Connective, "", "a spec that comes with the toolchain: `use library \"quartic\";`"),
    entry(
        "domain",
        Statement,
        " 0 <= t <= 1;$0",
        "the domain variables and their closed ranges, or a triangle or tetrahedron",
    ),
    entry(
        "shape",
        Statement,
        " 0 <= $0 <= 1;",
        "a shape parameter and its range; `<` leaves an end out, a missing side has no end",
    ),
    entry(
        "permute",
        Statement,
        " b[$0] = ",
        "this function and all that follow by permuting indices and variables together",
    ),
    entry("base", Statement, " n = $0 {\n}", "the functions of the lowest order of a recursion"),
    entry("raise", Statement, " b[i] = $0;", "the functions of order n in terms of those of order n − 1"),
    entry(
        "let",
        EitherStatement,
        " $0 = ;",
        "a name for an expression; in a theorem also determines a control point",
    ),
    entry("prove", EitherStatement, " $0;", "a claim that is declared true"),
    entry("refute", EitherStatement, " $0;", "a claim that is declared false"),
    entry(
        "conjecture",
        EitherStatement,
        " $0;",
        "a claim that may stay undecided; refuted it is an error, and proved a warning that asks for `prove`",
    ),
    entry("budget", EitherStatement, " $0;", "how many times the usual work may be spent on each claim"),
    entry(
        "assume",
        EitherStatement,
        " $0;",
        "a condition on shape parameters or scalars under which the claims are meant: `assume α^2 + β^2 <= 1;`",
    ),
    entry(
        "curve",
        TheoremStatement,
        " P = $0;",
        "a curve over a family, with the control points `P[0]`, `P[1]`, …",
    ),
    entry(
        "surface",
        TheoremStatement,
        " S = $0;",
        "a surface over a product of two families, or over a family on a triangle or box",
    ),
    entry("patch", TheoremStatement, " T = $0;", "the same as `surface`"),
    entry("scalar", TheoremStatement, " 0 < $0;", "a scalar and its range"),
    entry("dimension", TheoremStatement, " $0;", "the number of coordinates of points"),
    entry("partition_of_unity", Property, ";", "the functions sum to 1"),
    entry(
        "nonnegative",
        Property,
        ";",
        "every function is ≥ 0 on the domain for all shape values in their ranges",
    ),
    entry(
        "symmetric",
        Property,
        ";",
        "reversing the domain reverses the functions; on a simplex, all permutations of indices and coordinates",
    ),
    entry(
        "independent",
        Property,
        ";",
        "the functions are linearly independent for all shape values; `except λ = -3` names those at which they are not",
    ),
    entry(
        "continuity",
        Property,
        "($0);",
        "neighbouring segments, control points shifted by one, join with this many continuous derivatives",
    ),
    entry("smooth", Property, "($0);", "derivatives up to this order agree at all inner knots"),
    entry(
        "totally_positive",
        Property,
        ";",
        "no minor of (b[j](t_i)) is negative, for all t_0 < t_1 < … and all shape values",
    ),
    entry(
        "rounding",
        Property,
        " <= $0;",
        "the values that are computed are within this many ε of the exact ones",
    ),
    entry(
        "at",
        Connective,
        " $0 {  }",
        "fixed values at which equations and inequalities hold: `at t = 0 { b[0] = 1; }`",
    ),
    entry("except", Connective, " $0", "the shape values at which the functions are dependent"),
    entry(
        "with",
        Connective,
        " $0",
        "the shape values of the next segment in terms of those of this one: `continuity(1) with d0 = d1`",
    ),
    entry("for", Connective, " $0 in 0..=n", "one for each value of index variables"),
    entry("in", Connective, " ", "what an index variable runs over"),
    entry("if", Connective, " $0", "a condition on index variables and orders"),
    entry("simplex", Connective, "($0)", "all whole numbers ≥ 0 with this sum, in lexicographic order"),
    entry("triangle", Connective, " (u, v, w)", "barycentric coordinates, u + v + w = 1, all ≥ 0"),
    entry(
        "tetrahedron",
        Connective,
        " (u, v, w, x)",
        "barycentric coordinates in space, with the sum 1, all ≥ 0",
    ),
    entry("parallel", Connective, " $0", "the same direction and the same sense"),
    entry("D", Function, "($0)", "a derivative: `D(x)`, `D(x, 2)`, `D(x, λ)`, `D(x, u, v)`"),
    entry("sum", Function, "($0 for i in 0..=n)", "a sum over index variables, or of a list"),
    entry("product", Function, "($0 for i in 0..=n)", "a product over index variables"),
    entry(
        "integral",
        Function,
        "($0)",
        "the integral over the domain, or between bounds: `integral(x, t, a, b)`",
    ),
    entry("binomial", Function, "(n, $0)", "the binomial coefficient n over i"),
    entry("factorial", Function, "($0)", "n!"),
    entry("floor", Function, "($0)", "the largest whole number that is not larger"),
    entry("ceil", Function, "($0)", "the smallest whole number that is not smaller"),
    entry("min", Function, "($0)", "the smaller of two numbers"),
    entry("max", Function, "($0)", "the larger of two numbers"),
    entry(
        "cross",
        Function,
        "($0)",
        "the cross product of two vectors; without coordinates their outer product",
    ),
    entry("dot", Function, "($0)", "the scalar product of two vectors"),
    entry("sin", Function, "($0)", "the sine of an angle"),
    entry("cos", Function, "($0)", "the cosine of an angle"),
    entry("tan", Function, "($0)", "the tangent of an angle"),
    entry("sinh", Function, "($0)", "the hyperbolic sine"),
    entry("cosh", Function, "($0)", "the hyperbolic cosine"),
    entry("tanh", Function, "($0)", "the hyperbolic tangent"),
    entry("exp", Function, "($0)", "the exponential function"),
    entry("pi", Connective, "", "the number π"),
];

/// The word of the language with this text.
pub fn word(text: &str) -> Option<&'static Word> {
    WORDS.iter().find(|word| word.text == text || word.text == "pi" && text == "π")
}

/// Whether a text can be a name in a spec.
pub fn is_name(text: &str) -> bool {
    let mut characters = text.chars();
    characters.next().is_some_and(|c| c.is_alphabetic() || c == '_')
        && characters.all(|c| c.is_alphanumeric() || c == '_')
        && text != "_"
        && word(text).is_none()
}
