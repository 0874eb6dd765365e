//! Formulas that are pasted from LaTeX: what to write in place of a command or of braces.

/// Greek letters with the names that are typed for them.
pub const GREEK: [(&str, &str); 36] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("omicron", "ο"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Upsilon", "Υ"),
    ("Phi", "Φ"),
    ("Chi", "Χ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
];

/// Signs, functions, and what only says how a formula is set.
const COMMANDS: [(&str, &str); 27] = [
    ("cdot", "*"),
    ("times", "*"),
    ("le", "<="),
    ("leq", "<="),
    ("leqslant", "<="),
    ("ge", ">="),
    ("geq", ">="),
    ("geqslant", ">="),
    ("sin", "sin"),
    ("cos", "cos"),
    ("tan", "tan"),
    ("sinh", "sinh"),
    ("cosh", "cosh"),
    ("tanh", "tanh"),
    ("exp", "exp"),
    ("varphi", "φ"),
    ("vartheta", "θ"),
    ("varepsilon", "ε"),
    ("left", ""),
    ("right", ""),
    ("big", ""),
    ("Big", ""),
    ("quad", ""),
    ("displaystyle", ""),
    (",", ""),
    (";", ""),
    ("!", ""),
];

/// A command, or a power or index in braces.
pub(super) struct Pasted {
    /// Its length in bytes, with its arguments.
    pub(super) len: usize,
    /// What is meant, if the language has it.
    pub(super) plain: Option<String>,
    /// What is wrong with it.
    pub(super) message: &'static str,
    /// What to write instead.
    pub(super) help: String,
}

/// What a text begins with, if that is LaTeX.
pub(super) fn pasted(text: &str) -> Option<Pasted> {
    match text.as_bytes() {
        [b'\\', ..] => Some(command(text)),
        [b'^' | b'_', b'{', ..] => script(text),
        _ => None,
    }
}

/// The command whose backslash begins a text.
fn command(text: &str) -> Pasted {
    let message = "the character `\\` is not allowed in a spec";
    let rest = &text[1..];
    let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
    let one = rest.chars().next().filter(char::is_ascii_punctuation).map_or(0, char::len_utf8);
    let name = &rest[..letters.max(one)];
    let len = 1 + name.len();
    let known = GREEK.iter().chain(&COMMANDS).find(|(command, _)| *command == name);
    if let Some((_, plain)) = known {
        let help = if plain.is_empty() { String::from("leave it out") } else { format!("write `{plain}`") };
        return Pasted { len, plain: Some(String::from(*plain)), message, help };
    }
    let arguments = match name {
        "frac" | "dfrac" | "tfrac" | "binom" => arguments(&text[len..]),
        _ => None,
    };
    if let Some((length, above, below)) = arguments {
        let form = |above: &str, below: &str| match name {
            "binom" => format!("binomial({above}, {below})"),
            _ => format!("{}/{}", factor(above), factor(below)),
        };
        let whole = plain(above).zip(plain(below)).map(|(above, below)| form(&above, &below));
        let help = format!("write `{}`", whole.clone().unwrap_or_else(|| form("a", "b")));
        return Pasted { len: len + length, plain: whole, message, help };
    }
    let help = match name {
        "" => "remove it",
        "sum" => "write `sum(b[i] for i in 0..=n)`",
        "prod" => "write `product(… for i in 0..=n)`",
        "sqrt" => "a claim about a root is one about its square",
        "partial" => "write `D(b, t)` for a derivative",
        "infty" => "leave the end of the range out: `0 < λ` has no upper end",
        _ => "formulas are not LaTeX: write names, numbers, `+ - * / ^` and brackets",
    };
    // Its arguments mean nothing without it.
    let mut end = len;
    if matches!(name, "sum" | "prod" | "int") {
        while let Some(bounds) = script(&text[end..]).filter(|_| text[end..].starts_with(['_', '^'])) {
            end += bounds.len;
        }
    }
    while let Some((length, _)) = braces(&text[end..]) {
        end += length;
    }
    Pasted { len: end, plain: None, message, help: String::from(help) }
}

/// What is between the braces that begin a text, and the number of bytes to the end of them.
fn braces(text: &str) -> Option<(usize, &str)> {
    let start = text.len() - text.trim_start_matches(' ').len();
    let inner = text[start..].strip_prefix('{')?;
    let mut depth = 0_usize;
    for (at, c) in inner.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => return Some((start + at + 2, &inner[..at])),
            '}' => depth -= 1,
            ';' | '\n' => return None,
            _ => {}
        }
    }
    None
}

/// The two arguments with which a text begins, and the number of bytes to the end of them.
fn arguments(text: &str) -> Option<(usize, &str, &str)> {
    let (first, above) = braces(text)?;
    let (second, below) = braces(&text[first..])?;
    Some((first + second, above, below))
}

/// A formula in the signs of the language; `None` where it has commands that mean nothing here.
fn plain(text: &str) -> Option<String> {
    let mut all = String::new();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        if c == '\\' {
            let command = command(rest);
            all += &command.plain?;
            at += command.len;
        } else if let Some((len, inner)) = rest.strip_prefix('^').and_then(braces) {
            all += &format!("^{}", factor(&plain(inner)?));
            at += 1 + len;
        } else if let Some((len, inner)) = rest.strip_prefix('_').and_then(braces) {
            all += &format!("[{}]", plain(inner)?);
            at += 1 + len;
        } else if "{}".contains(c) {
            return None;
        } else {
            all.push(c);
            at += c.len_utf8();
        }
    }
    Some(String::from(all.trim()))
}

/// A formula as a factor or an exponent, in brackets if it is not one name or number.
fn factor(text: &str) -> String {
    let one = !text.is_empty() && text.chars().all(|c| c.is_alphanumeric() || c == '_');
    if one { String::from(text) } else { format!("({text})") }
}

/// What `^{…}` or `_{…}` means.
fn script(text: &str) -> Option<Pasted> {
    let (len, inner) = braces(&text[1..])?;
    if text.starts_with('_') && inner.contains('=') {
        // The loop of a sum, with the upper bound behind it.
        let bound = &text[1 + len..];
        let upper = match bound.strip_prefix('^').map(|upper| (upper, braces(upper))) {
            Some((_, Some((len, _)))) => 1 + len,
            Some((upper, None)) => 1 + upper.chars().next().map_or(0, char::len_utf8),
            None => 0,
        };
        let help = String::from("write the loop behind the expression, `sum(b[i] for i in 0..=n)`");
        return Some(Pasted { len: 1 + len + upper, plain: None, message: "a loop has no braces", help });
    }
    let inner = plain(inner)?;
    let (plain, message) = if text.starts_with('^') {
        (format!("^{}", factor(&inner)), "an exponent has no braces")
    } else {
        (format!("[{inner}]"), "an index has no braces")
    };
    let help = format!("write `{plain}`");
    Some(Pasted { len: 1 + len, plain: Some(plain), message, help })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_in_the_signs_of_the_language() {
        assert_eq!(plain("\\frac{1}{2} \\cdot \\lambda").as_deref(), Some("1/2 * λ"));
        assert_eq!(plain("(1-t)^{2}b_{i}").as_deref(), Some("(1-t)^2b[i]"));
        assert_eq!(plain("\\dfrac{1 + \\mu}{t^{n-1}}").as_deref(), Some("(1 + μ)/(t^(n-1))"));
        assert_eq!(plain("\\binom{n}{i}").as_deref(), Some("binomial(n, i)"));
        assert_eq!(plain("\\left(1\\right)").as_deref(), Some("(1)"));
        for open in ["\\frac{1}", "\\sqrt{2}", "{", "\\frac{1}{2", "\\"] {
            assert_eq!(plain(open), None, "{open}");
        }
    }
}
