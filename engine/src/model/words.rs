//! Names with a fixed meaning: the functions of the language, and those from elsewhere for which errors have advice.

/// Names that the language itself defines.
pub(crate) const BUILTINS: [&str; 10] =
    ["D", "integral", "binomial", "factorial", "floor", "ceil", "min", "max", "sum", "product"];

/// Functions of angles.
pub(crate) const CIRCULAR: [&str; 3] = ["sin", "cos", "tan"];

/// Functions of exponentials.
pub(crate) const HYPERBOLIC: [&str; 4] = ["sinh", "cosh", "tanh", "exp"];

/// The names of the number π.
pub(crate) const PI: [&str; 2] = ["pi", "π"];

/// Whether a name is that of a function of angles or of exponentials.
pub(crate) fn is_transcendental(name: &str) -> bool {
    CIRCULAR.contains(&name) || HYPERBOLIC.contains(&name)
}

/// Functions that the language does not have.
pub(crate) const ELSEWHERE: [&str; 8] = ["log", "ln", "sqrt", "abs", "arcsin", "arccos", "arctan", "atan"];

/// Names that papers have for binomial coefficients.
pub(crate) const BINOMIALS: [&str; 4] = ["C", "choose", "binom", "nCr"];

/// Names that papers have for basis functions.
pub(crate) const FUNCTIONS: [&str; 8] = ["b", "B", "N", "f", "F", "phi", "φ", "M"];

/// Names that papers have for the variable of the domain.
pub(crate) const VARIABLES: [&str; 10] = ["s", "t", "u", "v", "x", "y", "z", "ξ", "θ", "φ"];

/// What to write for a function under a name from elsewhere; the argument stands for `…`.
pub(crate) const OTHER_NAMES: [(&str, &str); 34] = [
    ("delta", "b[0] = …; b[i] = … for i in 1..=n;"),
    ("δ", "b[0] = …; b[i] = … for i in 1..=n;"),
    ("kronecker", "b[0] = …; b[i] = … for i in 1..=n;"),
    ("int", "integral(…)"),
    ("integrate", "integral(…)"),
    ("Integrate", "integral(…)"),
    ("d", "D(…)"),
    ("diff", "D(…)"),
    ("deriv", "D(…)"),
    ("derivative", "D(…)"),
    ("Sum", "sum(…)"),
    ("prod", "product(…)"),
    ("fact", "factorial(…)"),
    ("pow", "x^2"),
    ("csc", "1/sin(…)"),
    ("sec", "1/cos(…)"),
    ("cot", "cos(…)/sin(…)"),
    ("ctg", "cos(…)/sin(…)"),
    ("tg", "tan(…)"),
    ("sh", "sinh(…)"),
    ("ch", "cosh(…)"),
    ("th", "tanh(…)"),
    ("coth", "1/tanh(…)"),
    ("sech", "1/cosh(…)"),
    ("csch", "1/sinh(…)"),
    ("Sin", "sin(…)"),
    ("Cos", "cos(…)"),
    ("Tan", "tan(…)"),
    ("Exp", "exp(…)"),
    ("Σ", "sum(b[i] for i in 0..=3)"),
    ("Π", "product(… for i in 0..=3)"),
    ("det", "a*d - b*c"),
    ("wronskian", "b[0]*D(b[1]) - D(b[0])*b[1]"),
    ("Wronskian", "b[0]*D(b[1]) - D(b[0])*b[1]"),
];
