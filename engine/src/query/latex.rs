//! Formulas and claims of a spec as LaTeX.
//!
//! A formula is read as it is written, in the grammar of the language; what is not a formula, such as a sentence, has no
//! LaTeX and is set as text.

use super::lex::{Token, TokenKind, tokens};
use super::prose::letter;
use crate::syntax::GREEK;

pub use super::prose::escape;

/// A formula, equation or list of equations in math mode, such as `\frac{1}{2}\lambda t^{2}` for `1/2*λ*t^2`; nothing
/// where the text is not a formula.
pub fn math(text: &str) -> Option<String> {
    let tokens: Vec<Token> = tokens(text).into_iter().filter(|t| !t.is_comment()).collect();
    let mut reader = Reader { text, tokens: &tokens, at: 0, depth: 0 };
    let latex = reader.equations()?;
    (reader.at == tokens.len()).then_some(latex)
}

/// A formula in math mode within a text, or the text itself where it is none.
pub fn inline(text: &str) -> String {
    math(text).map_or_else(|| escape(text), |math| format!("${math}$"))
}

/// A name in math mode, `\lambda_{1}` for `λ1` and `\lambda_{1,P}` for `λ1_P`.
pub fn name(text: &str) -> String {
    let stem = text.trim_end_matches(|c: char| c.is_ascii_digit());
    let (stem, digits) = if stem.is_empty() { (text, "") } else { (stem, &text[stem.len()..]) };
    let (stem, index) = match stem.split_once('_') {
        Some((stem, index)) if !stem.is_empty() => {
            let letters = stem.trim_end_matches(|c: char| c.is_ascii_digit());
            let (letters, number) =
                if letters.is_empty() { (stem, "") } else { stem.split_at(letters.len()) };
            let comma = if number.is_empty() { "" } else { "," };
            (letters, format!("{number}{comma}{index}{digits}"))
        }
        _ => (stem, digits.to_string()),
    };
    let mut characters = stem.chars();
    let base = match (characters.next(), characters.next()) {
        (Some(c), None) => letter(c),
        _ if matches!(
            stem,
            "sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" | "exp" | "min" | "max" | "pi"
        ) =>
        {
            format!("\\{stem}")
        }
        _ => match GREEK.iter().find(|(word, _)| *word == stem) {
            Some((_, greek)) => greek.chars().map(letter).collect(),
            None => format!(
                "\\mathit{{{}}}",
                stem.chars()
                    .map(|c| if c.is_ascii_alphanumeric() {
                        c.to_string()
                    } else if c == '_' {
                        String::from("\\_")
                    } else {
                        letter(c)
                    })
                    .collect::<String>()
            ),
        },
    };
    match index.as_str() {
        "" => base,
        index => {
            let index: String = index.chars().filter(|c| *c != '_').map(letter).collect();
            format!("{base}_{{{index}}}")
        }
    }
}

/// How tightly the outermost operator of a formula binds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Binds {
    Sum,
    Negative,
    Product,
    Power,
    Atom,
}

/// A formula in LaTeX.
#[derive(Clone, Debug)]
struct Piece {
    latex: String,
    binds: Binds,
    /// Whether it begins with a digit: a factor before it needs a dot.
    digit: bool,
}

impl Piece {
    fn atom(latex: impl Into<String>) -> Self {
        Self { latex: latex.into(), binds: Binds::Atom, digit: false }
    }

    /// In brackets unless it binds at least so tightly.
    fn within(&self, binds: Binds) -> String {
        if self.binds >= binds { self.latex.clone() } else { format!("\\left({}\\right)", self.latex) }
    }
}

/// Formulas nested more deeply have no LaTeX.
const MAX_DEPTH: usize = 200;

struct Reader<'t> {
    text: &'t str,
    tokens: &'t [Token],
    at: usize,
    depth: usize,
}

impl<'t> Reader<'t> {
    fn peek(&self) -> &'t str {
        self.tokens.get(self.at).map_or("", |t| t.text(self.text))
    }

    fn kind(&self) -> Option<TokenKind> {
        self.tokens.get(self.at).map(|t| t.kind)
    }

    fn take(&mut self) -> &'t str {
        let text = self.peek();
        self.at += 1;
        text
    }

    fn eat(&mut self, text: &str) -> bool {
        let found = self.kind().is_some() && self.peek() == text;
        self.at += usize::from(found);
        found
    }

    /// Equations and inequalities, separated by commas, with what index variables run over.
    fn equations(&mut self) -> Option<String> {
        let mut latex = self.chain()?;
        while self.eat(",") {
            latex += ",\\ ";
            latex += &self.chain()?;
        }
        latex += &self.loops()?;
        Some(latex)
    }

    /// `a <= b <= c`
    fn chain(&mut self) -> Option<String> {
        let mut latex = if self.peek() == "<" { return None } else { self.sum()?.latex };
        while let Some(sign) = relation(self.peek()) {
            self.at += 1;
            latex = format!("{latex} {sign} {}", self.sum()?.latex);
        }
        Some(latex)
    }

    /// `for i in 0..=n, j in 0..=n if i != j`, or nothing.
    fn loops(&mut self) -> Option<String> {
        let mut latex = String::new();
        if self.eat("for") {
            latex += "\\quad ";
            loop {
                let mut names = vec![self.word()?];
                while self.eat(",") {
                    names.push(self.word()?);
                }
                if !self.eat("in") {
                    return None;
                }
                if self.eat("simplex") {
                    if !self.eat("(") {
                        return None;
                    }
                    let sum = self.sum()?.latex;
                    latex += &format!("{} = {sum}", names.join(" + "));
                    if !self.eat(")") {
                        return None;
                    }
                } else {
                    let low = self.sum()?.latex;
                    let inclusive = self.peek() == "..=";
                    if !self.eat("..=") && !self.eat("..") {
                        return None;
                    }
                    let high = self.sum()?.latex;
                    let sign = if inclusive { "\\le" } else { "<" };
                    latex += &format!("{low} \\le {} {sign} {high}", names.join(", "));
                }
                if !self.eat(",") {
                    break;
                }
                latex += ",\\ ";
            }
        }
        if self.eat("if") {
            latex += if latex.is_empty() { "\\quad " } else { ",\\ " };
            latex += &self.chain()?;
            while self.eat("&&") {
                latex += ",\\ ";
                latex += &self.chain()?;
            }
        }
        Some(latex)
    }

    fn word(&mut self) -> Option<String> {
        (self.kind() == Some(TokenKind::Word)).then(|| name(self.take()))
    }

    fn sum(&mut self) -> Option<Piece> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return None;
        }
        let mut sum = self.product()?;
        while matches!(self.peek(), "+" | "-") && self.kind() == Some(TokenKind::Sign) {
            let sign = self.take();
            let next = self.product()?;
            let next = if next.binds <= Binds::Negative { next.within(Binds::Product) } else { next.latex };
            sum =
                Piece { latex: format!("{} {sign} {next}", sum.latex), binds: Binds::Sum, digit: sum.digit };
        }
        self.depth -= 1;
        Some(sum)
    }

    fn product(&mut self) -> Option<Piece> {
        let negative = {
            let mut negative = false;
            while matches!(self.peek(), "+" | "-") && self.kind() == Some(TokenKind::Sign) {
                negative ^= self.take() == "-";
            }
            negative
        };
        let mut product = self.power()?;
        while matches!(self.peek(), "*" | "/") && self.kind() == Some(TokenKind::Sign) {
            let sign = self.take();
            let negative = self.eat("-");
            let mut next = self.power()?;
            if negative {
                next = Piece {
                    latex: format!("-{}", next.within(Binds::Power)),
                    binds: Binds::Negative,
                    digit: false,
                };
            }
            product = if sign == "/" {
                // A fraction needs no brackets inside; of a quotient divided by another number it is one.
                let (numer, denom) = match fraction(&product.latex) {
                    Some((numer, below)) => {
                        let dot = if next.digit { " \\cdot " } else { "\\," };
                        (numer.to_owned(), format!("{below}{dot}{}", next.within(Binds::Product)))
                    }
                    None => (product.latex, next.latex),
                };
                Piece { latex: format!("\\frac{{{numer}}}{{{denom}}}"), binds: Binds::Product, digit: false }
            } else {
                let (left, right) = (product.within(Binds::Product), next.within(Binds::Product));
                // Brackets keep their distance by themselves.
                let apart = left.ends_with("\\right)") || right.starts_with("\\left(");
                let dot = match (next.digit, apart) {
                    (true, _) => " \\cdot ",
                    (false, true) => " ",
                    (false, false) => "\\,",
                };
                Piece { latex: format!("{left}{dot}{right}"), binds: Binds::Product, digit: product.digit }
            };
        }
        if negative {
            let latex = format!("-{}", product.within(Binds::Product));
            return Some(Piece { latex, binds: Binds::Negative, digit: false });
        }
        Some(product)
    }

    fn power(&mut self) -> Option<Piece> {
        let base = self.postfix()?;
        if !self.eat("^") {
            return Some(base);
        }
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return None;
        }
        let negative = self.eat("-");
        let exponent = self.power()?;
        self.depth -= 1;
        let sign = if negative { "-" } else { "" };
        let exponent = if negative { exponent.within(Binds::Power) } else { exponent.latex };
        let sine = ["\\sin", "\\cos", "\\tan", "\\sinh", "\\cosh", "\\tanh"]
            .iter()
            .find_map(|f| Some((f, base.latex.strip_prefix(f).filter(|rest| rest.starts_with("\\left("))?)));
        let latex = match sine {
            Some((f, argument)) if !negative => format!("{f}^{{{exponent}}}{argument}"),
            _ => format!("{}^{{{sign}{exponent}}}", base.within(Binds::Atom)),
        };
        Some(Piece { latex, binds: Binds::Power, digit: base.digit })
    }

    fn postfix(&mut self) -> Option<Piece> {
        let word = if self.kind() == Some(TokenKind::Word) { self.peek() } else { "" };
        let mut piece = self.atom()?;
        let mut first = true;
        loop {
            match self.peek() {
                "[" if self.kind() == Some(TokenKind::Open) => {
                    self.at += 1;
                    let mut indices = self.list("]")?;
                    // `w[0]_Q`: an entry of a list of shape values, of the patch Q.
                    if self.kind() == Some(TokenKind::Word)
                        && let Some(patch) = self.peek().strip_prefix('_').filter(|rest| !rest.is_empty())
                    {
                        self.at += 1;
                        indices.push(name(patch));
                    }
                    // A second index, such as the coordinate of a point, stands beside the first one.
                    let has_index = piece.latex.ends_with('}') && piece.latex.contains("_{");
                    let base = if has_index && piece.binds == Binds::Atom {
                        format!("{{{}}}", piece.latex)
                    } else {
                        piece.within(Binds::Atom)
                    };
                    piece = Piece::atom(format!("{base}_{{{}}}", indices.join(",")));
                }
                "(" if self.kind() == Some(TokenKind::Open) => {
                    self.at += 1;
                    piece = if first {
                        self.call(word, &piece)?
                    } else {
                        let arguments = self.list(")")?;
                        Piece::atom(format!(
                            "{}\\left({}\\right)",
                            piece.within(Binds::Atom),
                            arguments.join(", ")
                        ))
                    };
                }
                "'" => {
                    self.at += 1;
                    piece.latex.push('\'');
                }
                _ => return Some(piece),
            }
            first = false;
        }
    }

    /// A function of the language, or a name, with its arguments.
    fn call(&mut self, word: &str, piece: &Piece) -> Option<Piece> {
        if matches!(word, "sum" | "product") {
            let body = self.sum()?;
            let loops = self.loops()?;
            if !self.eat(")") {
                return None;
            }
            let sign = if word == "sum" { "\\sum" } else { "\\prod" };
            let loops = loops.trim_start_matches("\\quad ");
            let body = body.within(Binds::Product);
            let below = if loops.is_empty() { String::new() } else { format!("_{{{loops}}}") };
            return Some(Piece {
                latex: format!("{sign}{below} {body}"),
                binds: Binds::Negative,
                digit: false,
            });
        }
        let arguments = self.list(")")?;
        if let ("exp", [x]) = (word, arguments.as_slice()) {
            return Some(Piece { latex: format!("e^{{{x}}}"), binds: Binds::Power, digit: false });
        }
        let latex = match (word, arguments.as_slice()) {
            ("binomial", [n, k]) => format!("\\binom{{{n}}}{{{k}}}"),
            ("factorial", [n]) if n.chars().count() == 1 => format!("{n}!"),
            ("factorial", [n]) => format!("\\left({n}\\right)!"),
            ("floor", [x]) => format!("\\left\\lfloor {x} \\right\\rfloor"),
            ("ceil", [x]) => format!("\\left\\lceil {x} \\right\\rceil"),
            ("dot", [a, b]) => format!("\\left\\langle {a}, {b} \\right\\rangle"),
            ("cross", [a, b]) => format!("\\left({a}\\right) \\times \\left({b}\\right)"),
            ("sqrt", [x]) => format!("\\sqrt{{{x}}}"),
            ("integral", [x]) => format!("\\int {x}"),
            ("integral", [x, var]) => format!("\\int {} \\,d{var}", integrand(x)),
            ("integral", [x, var, low, high]) => {
                format!("\\int_{{{low}}}^{{{high}}} {} \\,d{var}", integrand(x))
            }
            ("D", [x, vars @ ..]) => derivative(x, vars),
            _ => format!("{}\\left({}\\right)", piece.latex, arguments.join(", ")),
        };
        Some(Piece::atom(latex))
    }

    fn atom(&mut self) -> Option<Piece> {
        let kind = self.kind()?;
        match (kind, self.peek()) {
            (TokenKind::Number, _) => {
                Some(Piece { latex: self.take().to_string(), binds: Binds::Atom, digit: true })
            }
            (TokenKind::Word, _) => Some(Piece::atom(name(self.take()))),
            (TokenKind::Open, "(") => {
                self.at += 1;
                let mut parts = self.list(")")?;
                if parts.len() != 1 {
                    return Some(Piece::atom(format!("\\left({}\\right)", parts.join(", "))));
                }
                let latex = parts.pop()?;
                // Whether brackets are needed is seen where the formula stands.
                let binds = if is_simple(&latex) { Binds::Atom } else { Binds::Sum };
                Some(Piece {
                    digit: binds == Binds::Atom && latex.starts_with(|c: char| c.is_ascii_digit()),
                    latex,
                    binds,
                })
            }
            (TokenKind::Open, "[") => {
                self.at += 1;
                if self.eat("]") {
                    return Some(Piece::atom("\\left[\\,\\right]"));
                }
                let mut parts = vec![self.sum()?.latex];
                while self.eat(",") {
                    parts.push(self.sum()?.latex);
                }
                let loops = self.loops()?;
                self.eat("]").then(|| Piece::atom(format!("\\left[{}{loops}\\right]", parts.join(",\\ "))))
            }
            _ => None,
        }
    }

    /// Formulas up to a closing bracket.
    fn list(&mut self, close: &str) -> Option<Vec<String>> {
        let mut parts = Vec::new();
        while !self.eat(close) {
            parts.push(self.sum()?.latex);
            if !self.eat(",") && self.peek() != close {
                return None;
            }
        }
        Some(parts)
    }
}

/// What stands between the sign of an integral and its variable: a sum in brackets.
fn integrand(latex: &str) -> String {
    let is_sum = latex.contains(" + ") || latex.contains(" - ");
    if is_sum { format!("\\left({latex}\\right)") } else { latex.to_owned() }
}

/// The parts of what is a single fraction with a number below the line.
fn fraction(latex: &str) -> Option<(&str, &str)> {
    let (numer, denom) = latex.strip_prefix("\\frac{")?.strip_suffix('}')?.split_once("}{")?;
    let is_number = |text: &str| text.chars().all(|c| c.is_ascii_digit());
    (is_number(numer) && is_number(denom)).then_some((numer, denom))
}

/// Whether a formula in brackets needs none: one number or one letter.
fn is_simple(latex: &str) -> bool {
    latex.chars().all(|c| c.is_ascii_digit()) || latex.chars().count() == 1
}

/// A derivative, `b'` or `\partial_{\lambda} b`.
fn derivative(x: &str, vars: &[String]) -> String {
    let simple = x.chars().all(|c| c.is_ascii_alphanumeric() || "_{},\\".contains(c));
    let base = if simple { x.to_string() } else { format!("\\left({x}\\right)") };
    let number = |text: &String| text.parse::<u32>().ok();
    match vars {
        [] => format!("{{{base}}}'"),
        [k] if number(k) == Some(2) => format!("{{{base}}}''"),
        [k] if number(k).is_some() => format!("{{{base}}}^{{({k})}}"),
        _ => {
            let mut latex = String::new();
            for (k, var) in vars.iter().enumerate().filter(|(_, v)| number(v).is_none()) {
                match vars.get(k + 1).and_then(number) {
                    Some(order) if order != 1 => latex += &format!("\\partial_{{{var}}}^{{{order}}} "),
                    _ => latex += &format!("\\partial_{{{var}}} "),
                }
            }
            format!("{latex}{base}")
        }
    }
}

/// A sign between two sides.
fn relation(text: &str) -> Option<&'static str> {
    Some(match text {
        "=" | "==" => "=",
        "!=" => "\\ne",
        "<" => "<",
        "<=" => "\\le",
        ">" => ">",
        ">=" => "\\ge",
        "parallel" => "\\parallel",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_look_as_in_papers() {
        let cases = [
            ("(1 - λ*t)*(1 - t)^3", "\\left(1 - \\lambda\\,t\\right) \\left(1 - t\\right)^{3}"),
            ("1/2*t^2", "\\frac{1}{2}\\,t^{2}"),
            ("-16/625", "-\\frac{16}{625}"),
            ("2*3^n", "2 \\cdot 3^{n}"),
            ("-(3 + λ1)", "-\\left(3 + \\lambda_{1}\\right)"),
            ("a - (b - c)", "a - \\left(b - c\\right)"),
            ("a - -b", "a - \\left(-b\\right)"),
            ("(a*b)^2", "\\left(a\\,b\\right)^{2}"),
            ("(λ + 1)/(2*δ)*P[0]", "\\frac{\\lambda + 1}{2\\,\\delta}\\,P_{0}"),
            ("b[2,0,1] >= 0", "b_{2,0,1} \\ge 0"),
            ("D(b[1], λ) >= 0", "\\partial_{\\lambda} b_{1} \\ge 0"),
            ("D(b, 2) = [6*(1 + λ), 0]", "{b}'' = \\left[6 \\left(1 + \\lambda\\right),\\ 0\\right]"),
            ("C''(0)", "C''\\left(0\\right)"),
            ("λ12_P^2", "\\lambda_{12,P}^{2}"),
            ("λ_P = -2, t = 1/2", "\\lambda_{P} = -2,\\ t = \\frac{1}{2}"),
            ("sum(i/n*b[i] for i in 0..=n) = t", "\\sum_{0 \\le i \\le n} \\frac{i}{n}\\,b_{i} = t"),
            ("b[i] >= 0 for i in 0..n if i != 1", "b_{i} \\ge 0\\quad 0 \\le i < n,\\ i \\ne 1"),
            ("binomial(n, i)", "\\binom{n}{i}"),
            ("sin(θ)^2*exp(-2*t)", "\\sin^{2}\\left(\\theta\\right) e^{-2\\,t}"),
            ("exp(t)^2", "\\left(e^{t}\\right)^{2}"),
            ("weight*x", "\\mathit{weight}\\,x"),
            ("P(1)[0]", "P\\left(1\\right)_{0}"),
            ("Q[1][0]", "{Q_{1}}_{0}"),
            ("2*w[0]_Q^2", "2\\,w_{0,Q}^{2}"),
            ("-3 <= λ < 1", "-3 \\le \\lambda < 1"),
        ];
        for (text, latex) in cases {
            assert_eq!(math(text).as_deref(), Some(latex), "{text}");
        }
    }

    #[test]
    fn what_is_no_formula_has_no_latex() {
        for text in
            ["", "1 +", "(a", "a)", "every λ", "undecided: the budget is spent", "a < ", "b[", "f(x y)"]
        {
            assert_eq!(math(text), None, "{text}");
        }
        assert_eq!(math(&format!("{}1{}", "(".repeat(1000), ")".repeat(1000))), None);
        assert_eq!(math(&format!("{}1", "2^".repeat(1000))), None);
        assert_eq!(inline("50% of λ"), "50\\% of $\\lambda$");
        assert_eq!(escape("S₁ᵢ¹⁰ × ″"), "S$_{1}$$_{i}$$^{1}$$^{0}$ $\\times$ $''$");
        assert_eq!(escape("`a_b` & \"c\" ≥ 0…"), "\\texttt{a\\_b} \\& ``c'' $\\ge$ 0\\dots{}");
    }
}
