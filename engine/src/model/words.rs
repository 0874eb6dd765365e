//! Names with a fixed meaning: the functions of the language, and those from elsewhere for which errors have advice.

/// Names that the language itself defines.
pub(crate) const BUILTINS: [&str; 10] =
    ["D", "integral", "binomial", "factorial", "floor", "ceil", "min", "max", "sum", "product"];

/// Functions that are not polynomials.
pub(crate) const ELSEWHERE: [&str; 10] =
    ["sin", "cos", "tan", "exp", "log", "ln", "sqrt", "abs", "sinh", "cosh"];

/// Names that papers have for binomial coefficients.
pub(crate) const BINOMIALS: [&str; 4] = ["C", "choose", "binom", "nCr"];
