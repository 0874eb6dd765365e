//! The text of a spec as words, signs and comments with their places; nothing is left out but white space.
//!
//! What the parser reads are the tokens of proc-macro2, which has no comments and stops at the first bracket that does
//! not match. Here everything is a token, whatever is typed.

use core::ops::Range;

/// A piece of the text of a spec.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Its bytes.
    pub range: Range<usize>,
    /// Of a bracket, the position of the other one in the list of tokens, if it has one.
    pub partner: Option<usize>,
}

/// The kinds of tokens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// A name or a word of the language.
    Word,
    /// A number, such as `3` or `0.62`.
    Number,
    /// A text in quotation marks.
    Quoted,
    /// An operator or another sign, such as `<=` or `;`.
    Sign,
    /// `(`, `[` or `{`.
    Open,
    /// `)`, `]` or `}`.
    Close,
    /// `// …` or `/* … */`.
    Comment,
    /// `/// …`, `//! …` or `/** … */`.
    Doc,
}

impl Token {
    /// The token as it is written.
    pub fn text<'t>(&self, text: &'t str) -> &'t str {
        text.get(self.range.clone()).unwrap_or_default()
    }

    /// Whether it is a comment of either kind.
    pub const fn is_comment(&self) -> bool {
        matches!(self.kind, TokenKind::Comment | TokenKind::Doc)
    }
}

/// Signs of several characters, longer ones first.
const SIGNS: [&str; 9] = ["..=", "..", "<=", ">=", "==", "!=", "&&", "||", "->"];

/// The tokens of a text, in order.
pub fn tokens(text: &str) -> Vec<Token> {
    let mut tokens: Vec<Token> = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        if first.is_whitespace() {
            at += first.len_utf8();
            continue;
        }
        let (kind, len) = next(&text[at..], first);
        let mut partner = None;
        if kind == TokenKind::Open {
            open.push(tokens.len());
        } else if kind == TokenKind::Close
            && let Some(k) = open.last().copied()
            && closes(tokens[k].text(text), &text[at..at + len])
        {
            open.pop();
            tokens[k].partner = Some(tokens.len());
            partner = Some(k);
        }
        tokens.push(Token { kind, range: at..at + len, partner });
        at += len;
    }
    tokens
}

fn closes(open: &str, close: &str) -> bool {
    matches!((open, close), ("(", ")") | ("[", "]") | ("{", "}"))
}

/// The kind and the length of what a text begins with, which is not white space.
fn next(text: &str, first: char) -> (TokenKind, usize) {
    let line = text.find('\n').unwrap_or(text.len());
    if text.starts_with("//") {
        let doc = text.starts_with("//!") || text.starts_with("///") && !text.starts_with("////");
        return (if doc { TokenKind::Doc } else { TokenKind::Comment }, text[..line].trim_end().len());
    }
    if text.starts_with("/*") {
        let doc = text.starts_with("/*!")
            || text.starts_with("/**") && !text.starts_with("/***") && !text.starts_with("/**/");
        return (if doc { TokenKind::Doc } else { TokenKind::Comment }, block(text));
    }
    if first == '"' {
        return (TokenKind::Quoted, quoted(&text[..line]));
    }
    let in_word = |c: char| c.is_alphanumeric() || c == '_';
    let run = |text: &str| text.find(|c| !in_word(c)).unwrap_or(text.len());
    if first.is_ascii_digit() {
        let whole = run(text);
        // As in Rust, a point at the end of a number belongs to it, unless a range or a name begins there.
        let fraction = text[whole..]
            .strip_prefix('.')
            .filter(|rest| !rest.starts_with(|c: char| c == '.' || in_word(c) && !c.is_ascii_digit()));
        return (TokenKind::Number, fraction.map_or(whole, |rest| whole + 1 + run(rest)));
    }
    if in_word(first) {
        return (TokenKind::Word, run(text));
    }
    let sign = SIGNS.iter().find(|sign| text.starts_with(**sign));
    let len = sign.map_or(first.len_utf8(), |sign| sign.len());
    match first {
        '(' | '[' | '{' => (TokenKind::Open, len),
        ')' | ']' | '}' => (TokenKind::Close, len),
        _ => (TokenKind::Sign, len),
    }
}

/// The length of a comment in `/* … */`, in which others may stand.
fn block(text: &str) -> usize {
    let (mut at, mut depth) = (0, 0);
    while at < text.len() {
        if text[at..].starts_with("/*") {
            (at, depth) = (at + 2, depth + 1);
        } else if text[at..].starts_with("*/") {
            (at, depth) = (at + 2, depth - 1);
            if depth == 0 {
                return at;
            }
        } else {
            at += text[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    text.len()
}

/// The length of a text in quotation marks; one that does not end goes to the end of the line.
fn quoted(line: &str) -> usize {
    let mut escaped = false;
    for (at, c) in line.char_indices().skip(1) {
        match c {
            '"' if !escaped => return at + 1,
            '\\' => escaped = !escaped,
            _ => escaped = false,
        }
    }
    line.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<&str> {
        tokens(text).iter().map(|t| t.text(text)).collect()
    }

    #[test]
    fn everything_but_white_space_is_a_token() {
        assert_eq!(
            words("b[i] = 0.5*λ^2 for i in 0..=n;"),
            ["b", "[", "i", "]", "=", "0.5", "*", "λ", "^", "2", "for", "i", "in", "0", "..=", "n", ";"]
        );
        assert_eq!(
            words("x // a\n/* b /* c */ d */ y /// e "),
            ["x", "// a", "/* b /* c */ d */", "y", "/// e"]
        );
        assert_eq!(words("use \"a b\"; use \"open\nx"), ["use", "\"a b\"", ";", "use", "\"open", "x"]);
        assert_eq!(words("/* open λ"), ["/* open λ"]);
        assert_eq!(words("t² → 3"), ["t²", "→", "3"]);
        assert_eq!(words("1. - 2.5.x"), ["1.", "-", "2.5", ".", "x"]);
        assert_eq!(words("0..2. if 3.if"), ["0", "..", "2.", "if", "3", ".", "if"]);
    }

    #[test]
    fn brackets_know_each_other() {
        let of = |text| tokens(text).iter().map(|t| t.partner).collect::<Vec<_>>();
        assert_eq!(of("([])"), [Some(3), Some(2), Some(1), Some(0)]);
        assert_eq!(of("(]"), [None, None]);
    }
}
