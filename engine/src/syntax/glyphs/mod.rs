//! What a text must satisfy before Rust's lexer sees it: glyphs that are Rust tokens, balanced brackets.
//!
//! The lexer would say only "cannot parse"; formulas copied from papers deserve a better answer.

mod latex;

pub use latex::GREEK;

use std::borrow::Cow;

use self::latex::Pasted;
use super::error::{SyntaxError, SyntaxPlace};
use crate::plural::count;

/// Brackets nested deeper than this are refused, before they can exhaust the stack.
pub(super) const MAX_NESTING: usize = 64;

/// After this many errors the text is most likely not a spec at all.
const MAX_ERRORS: usize = 20;

/// A text without characters that is not allowed in a spec.
pub(super) struct Readable<'a> {
    /// The text, of the same length in bytes, in which every wrong character is replaced.
    pub(super) text: Cow<'a, str>,
    /// Where nothing stands in place of a wrong character: a statement there means something else than was meant.
    pub(super) gaps: Vec<usize>,
}

/// All characters and brackets of the text that is not allowed in a spec; and the text to go on with; `None` when
/// brackets do not balance.
pub(super) fn check(text: &str) -> (Vec<SyntaxError>, Option<Readable<'_>>) {
    let mut errors = Vec::new();
    let mut gaps = Vec::new();
    let mut repaired = Repaired { text, bytes: None };
    let mut open: Vec<(char, usize)> = Vec::new();
    let mut previous = ' ';
    let mut balanced = true;
    // Wrong characters, each with its error and the number of other places in which it stands.
    let mut seen: Vec<(char, usize, usize)> = Vec::new();
    let mut rest = Scanner { text, at: 0, unterminated: false, backslashes: Vec::new() };
    while let Some((at, c)) = rest.next_code_char(&mut errors) {
        if let Some(Pasted { len, plain, message, help }) = latex::pasted(&text[at..]) {
            let same = |error: usize| errors[error].help.as_ref() == Some(&help);
            match seen.iter_mut().find(|(known, error, _)| *known == c && same(*error)) {
                Some((.., others)) => *others += 1,
                None => {
                    seen.push((c, errors.len(), 0));
                    errors.push(new(text, at, message, &help));
                }
            }
            // What is longer than it was has no room.
            match plain.filter(|plain| plain.len() <= len) {
                Some(plain) => repaired.replace(at, len, &plain),
                None => {
                    gaps.push(at);
                    repaired.replace(at, len, "");
                }
            }
            rest.at = at + len;
            previous = c;
            continue;
        }
        match c {
            '(' | '[' | '{' => {
                open.push((c, at));
                if open.len() > MAX_NESTING {
                    errors.push(new(
                        text,
                        at,
                        "the brackets are nested too deeply",
                        "name parts of the formula with `let`",
                    ));
                    return (errors, None);
                }
            }
            ')' | ']' | '}' => balanced &= close(text, c, at, &mut open, &mut errors),
            '#' | '%' if begins_comment(text, at) => {
                let len = text[at..].find('\n').unwrap_or(text.len() - at);
                if !seen.iter().any(|(known, ..)| *known == c) {
                    seen.push((c, errors.len(), 0));
                    let message = format!("`{c}` does not begin a comment");
                    errors.push(new(text, at, &message, "write `// …`"));
                }
                repaired.replace(at, len, "");
                rest.at = at + len;
            }
            _ if QUOTES.contains(c) && is_path(text, at) => {
                errors.push(quoted(text, at, &mut rest, &mut repaired));
            }
            // The sign says it.
            _ if previous == '⁻' && SUPERSCRIPTS.contains(c) => repaired.replace(at, c.len_utf8(), ""),
            // Of several primes the first says it.
            _ if PRIMES.contains(c) && PRIMES.contains(previous) => {
                repaired.replace(at, c.len_utf8(), "");
            }
            _ => {
                if let Some((message, help, mut instead)) =
                    wrong_glyph(c, &text[..at], &text[at + c.len_utf8()..])
                {
                    // A digit would make one word with a letter that follows.
                    let next = text[at + c.len_utf8()..].chars().next();
                    let joined =
                        |next: char| next.is_alphabetic() || next == '(' && ends_with_function(&text[..at]);
                    if instead.ends_with(|c: char| c.is_ascii_digit()) && next.is_some_and(joined) {
                        instead.clear();
                    }
                    let same = |error: usize| errors[error].help.as_ref() == Some(&help);
                    match seen.iter_mut().find(|(known, error, _)| *known == c && same(*error)) {
                        Some((.., others)) => *others += 1,
                        None => {
                            seen.push((c, errors.len(), 0));
                            errors.push(new(text, at, &message, &help));
                        }
                    }
                    if instead.is_empty() {
                        gaps.push(at);
                    }
                    repaired.replace(at, c.len_utf8(), &instead);
                }
            }
        }
        previous = c;
        if errors.len() >= MAX_ERRORS {
            return (errors, None);
        }
    }
    for at in rest.backslashes {
        repaired.replace(at, 1, "/");
    }
    for (_, error, others) in seen.into_iter().filter(|(.., others)| *others > 0) {
        errors[error].message += &format!(", here and in {}", count(others, "other place"));
    }
    // What is left open at the end of the text: a bracket, a comment or a string.
    balanced &= open.is_empty() && !rest.unterminated;
    for (c, at) in open {
        errors.push(never_closed(text, c, at));
    }
    (errors, balanced.then(|| Readable { text: repaired.finish(), gaps }))
}

/// A text in which characters are replaced by others that take as many bytes.
struct Repaired<'a> {
    text: &'a str,
    /// The text with what is replaced so far, once something is.
    bytes: Option<Vec<u8>>,
}

impl<'a> Repaired<'a> {
    /// Replaces whole characters, `len` bytes of them, by a text that is no longer, and spaces.
    fn replace(&mut self, at: usize, len: usize, by: &str) {
        let by = if by.len() <= len { by } else { "" };
        let bytes = self.bytes.get_or_insert_with(|| self.text.as_bytes().to_vec());
        let place = &mut bytes[at..at + len];
        place.fill(b' ');
        place[..by.len()].copy_from_slice(by.as_bytes());
    }

    fn finish(self) -> Cow<'a, str> {
        match self.bytes {
            None => Cow::Borrowed(self.text),
            // Whole characters stand in place of whole characters.
            Some(bytes) => Cow::Owned(String::from_utf8(bytes).unwrap_or_default()),
        }
    }
}

fn never_closed(text: &str, open: char, at: usize) -> SyntaxError {
    new(text, at, &format!("this `{open}` is never closed"), &format!("add the missing `{}`", partner(open)))
}

/// Whether what begins here is meant as a comment, as other languages have it: at the beginning of a line or behind the end
/// of a statement, and no attribute of Rust.
fn begins_comment(text: &str, at: usize) -> bool {
    // A line may be as long as the text: only blanks are gone back over.
    let before = text[..at].trim_end_matches(|c: char| c != '\n' && c.is_whitespace());
    let attribute = text[at + 1..].starts_with(['[', '!']);
    !attribute && (before.is_empty() || before.ends_with(['\n', ';', '{', '}']))
}

/// Marks that are meant as quotation marks around a path.
const QUOTES: &str = "'’‘′`“”„«»";

/// Whether the path of a `use` begins here.
fn is_path(text: &str, at: usize) -> bool {
    let space = |c: char| c != '\n' && c.is_whitespace();
    let before = text[..at].trim_end_matches(space).strip_suffix("use");
    before
        .map(|before| before.trim_end_matches(space))
        .is_some_and(|rest| rest.is_empty() || rest.ends_with('\n'))
}

/// The error about a path in other quotation marks than `"`; goes on behind them, and repairs them.
fn quoted(text: &str, at: usize, rest: &mut Scanner<'_>, repaired: &mut Repaired<'_>) -> SyntaxError {
    let line = text[at..].lines().next().unwrap_or_default();
    let path = line.trim_end_matches(|c: char| c == ';' || c.is_whitespace());
    let mut inner = path.chars();
    let (first, last) = (inner.next(), inner.next_back());
    let shown = inner.as_str().replace('\\', "/");
    let help = format!("write it in the straight quotation marks of the keyboard: `use \"{shown}\";`");
    let len = |c: Option<char>| c.map_or(0, char::len_utf8);
    if last.is_some_and(|c| QUOTES.contains(c) || c == '"') {
        repaired.replace(at, path.len(), &format!("\"{shown}\""));
        rest.at = at + path.len();
    } else {
        repaired.replace(at, len(first), "");
    }
    let mut error = new(text, at, "a path cannot be in these quotation marks", &help);
    error.place = SyntaxPlace::Bytes(at..at + path.len());
    error
}

fn close(
    text: &str,
    c: char,
    at: usize,
    open: &mut Vec<(char, usize)>,
    errors: &mut Vec<SyntaxError>,
) -> bool {
    let Some(&(o, start)) = open.last() else {
        errors.push(closes_nothing(text, c, at));
        return false;
    };
    if partner(o) == c {
        open.pop();
        return true;
    }
    let in_block = open.iter().rposition(|(o, _)| *o == '{').map_or(0, |k| k + 1);
    if c == '}' && in_block > 0 {
        // A brace ends everything that is open inside of it.
        while let Some((o, start)) = open.pop().filter(|(o, _)| *o != '{') {
            errors.push(never_closed(text, o, start));
        }
    } else if o == '{' || closes_later(&text[at + 1..], partner(o)) {
        errors.push(closes_nothing(text, c, at));
    } else {
        let message = format!("`{o}` is closed by `{c}`");
        let inside = text.get(start + 1..at).unwrap_or_default();
        // What is open around it and closed here was meant to be closed here.
        let outer = open[in_block..].iter().rposition(|(o, _)| partner(*o) == c);
        // A range in interval notation is the usual reason.
        let help = if outer.is_none() && inside.contains(',') && !inside.contains('\n') {
            String::from("brackets must balance; write a range as inequalities, such as `0 < λ <= 4`")
        } else if outer.is_some() {
            format!("add the missing `{}`", partner(o))
        } else {
            format!("write `{}`", partner(o))
        };
        errors.push(new(text, at, &message, &help));
        open.truncate(outer.map_or(open.len() - 1, |k| in_block + k));
    }
    false
}

fn closes_nothing(text: &str, c: char, at: usize) -> SyntaxError {
    new(text, at, &format!("this `{c}` closes nothing"), "remove it, or add the opening bracket")
}

/// Whether a bracket is closed in the rest of a statement.
fn closes_later(rest: &str, close: char) -> bool {
    let mut depth = 0;
    for c in rest.chars() {
        match c {
            ';' | '{' | '}' => return false,
            '(' | '[' => depth += 1,
            _ if c == close && depth == 0 => return true,
            ')' | ']' if depth == 0 => return false,
            ')' | ']' => depth -= 1,
            _ => {}
        }
    }
    false
}

const fn partner(open: char) -> char {
    match open {
        '(' => ')',
        '[' => ']',
        _ => '}',
    }
}

fn new(text: &str, at: usize, message: &str, help: &str) -> SyntaxError {
    let len = text[at..].chars().next().map_or(0, char::len_utf8);
    SyntaxError {
        place: SyntaxPlace::Bytes(at..at + len),
        message: message.to_string(),
        help: Some(help.to_string()),
    }
}

/// Signs of derivatives.
const PRIMES: &str = "'′″‴’";

const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const SUBSCRIPTS: &str = "₀₁₂₃₄₅₆₇₈₉";

/// Functions whose powers papers write as `sin²t`.
const FUNCTIONS: [&str; 6] = ["sinh", "cosh", "tanh", "sin", "cos", "tan"];

/// Whether the name of a function stands before something.
fn ends_with_function(before: &str) -> bool {
    FUNCTIONS.iter().any(|f| before.ends_with(f))
}

/// The name or the brackets after a function, without the brackets; `t` for anything else.
fn argument(after: &str) -> &str {
    let after = after.trim_start_matches(' ');
    let name = after.find(|c: char| !c.is_alphabetic()).map_or(after, |end| &after[..end]);
    let plain = |c: char| c.is_alphanumeric() || " +-*/.".contains(c);
    let inner = after.strip_prefix('(').and_then(|rest| rest.split_once(')')).map(|(inner, _)| inner);
    match inner {
        Some(inner) if !inner.is_empty() && inner.chars().all(plain) => inner,
        _ if name.is_empty() => "t",
        _ => name,
    }
}

/// The function on which a prime stands, with its index on either side of the prime: `b[0]'`, `b'[0]`; `b` where there is none.
fn differentiated(before: &str, after: &str) -> String {
    let index = |text: &str| !text.contains(['\n', ';', '[']);
    let (before, own) = match before.strip_suffix(']').and_then(|inner| inner.rsplit_once('[')) {
        Some((name, inner)) if index(inner) => (name, &before[name.len()..]),
        _ => (before, ""),
    };
    let name = &before[before.trim_end_matches(|c: char| c.is_alphanumeric() || c == '_').len()..];
    let behind = after.trim_start_matches(|c| PRIMES.contains(c));
    let behind = behind.strip_prefix('[').and_then(|rest| rest.split_once(']')).map(|(inner, _)| inner);
    match behind.filter(|inner| index(inner)) {
        Some(inner) if !name.is_empty() && own.is_empty() => format!("{name}[{inner}]"),
        _ if name.is_empty() => String::from("b"),
        _ => format!("{name}{own}"),
    }
}

/// What is wrong with a character outside of comments and strings, what to write instead, and Rust tokens
/// that stand for it while the rest of the text is read (no longer than the character in bytes).
fn wrong_glyph(c: char, before: &str, after: &str) -> Option<(String, String, String)> {
    // Nearly all characters are these; the check runs unoptimised on every build.
    if c.is_ascii() && !matches!(c, '\'' | '`' | '\0' | '$') {
        return None;
    }
    let digit = |set: &str| set.chars().position(|d| d == c);
    if let Some(d) = digit(SUPERSCRIPTS) {
        let message = format!("the superscript `{c}` is not allowed in a spec");
        let help = match FUNCTIONS.iter().find(|f| before.ends_with(**f)) {
            Some(function) => format!("write `{function}({})^{d}`", argument(after)),
            None => format!("write `^{d}` for a power, such as `t^{d}`"),
        };
        return Some((message, help, format!("^{d}")));
    }
    if let Some(d) = digit(SUBSCRIPTS) {
        // What begins a statement is a function.
        let name = before.trim_end_matches(|c: char| c.is_alphanumeric() || c == '_');
        if name.len() < before.len() && name.trim_end().ends_with([';', '{', '}']) {
            let message = format!("the subscript `{c}` is not allowed in a spec");
            let help = format!("write an index in square brackets, `{}[{d}]`", &before[name.len()..]);
            return Some((message, help, format!("[{d}]")));
        }
        let base = before.chars().next_back().filter(|c| c.is_alphanumeric()).unwrap_or('λ');
        let message = format!("the subscript `{c}` is not allowed in a spec");
        let help =
            format!("write the digit after the name, such as `{base}{d}`, or an index, such as `b[{d}]`");
        return Some((message, help, d.to_string()));
    }
    if PRIMES.contains(c) {
        let name = differentiated(before, after);
        let help = format!("write `D({name})` for the derivative of `{name}`, `D({name}, 2)` for the second");
        return Some((format!("the character `{c}` is not allowed in a spec"), help, String::new()));
    }
    let (help, instead) = match c {
        '∥' | '‖' => ("write `a parallel b` for vectors, `dot(a, a)` for the square of a length", ""),
        '⊥' => ("write `dot(a, b) == 0`", ""),
        '∧' => (
            "write `cross(a, b)` for vectors, `&&` between conditions, a statement for each of two claims",
            "",
        ),
        '⟨' | '⟩' => ("write `dot(a, b)`", ""),
        '√' => ("a claim about a root is one about its square", ""),
        '∈' => ("write `0 <= t <= 1` for a range, `i in 0..=n` for an index variable", ""),
        '∫' => ("write `integral(b[0])`, or `integral(b[0], t, 0, 1)` between bounds", ""),
        '∀' => ("a claim is about all values in the declared ranges, which goes without saying", ""),
        '≡' => ("write `==`", "=="),
        '±' | '∓' => ("write two claims", ""),
        '≈' | '≃' | '≅' => ("numbers are exact here: write `==`, or two inequalities", ""),
        '≤' | '⩽' | '≦' => ("write `<=`", "<="),
        '≥' | '⩾' | '≧' => ("write `>=`", ">="),
        '≠' => ("write `!=` in a condition of a loop; `refute … = …;` claims that two things differ", "!="),
        '−' | '–' | '—' | '‐' | '‑' | '﹣' | '－' => {
            ("write the minus sign of the keyboard, `-`", "-")
        }
        '×' => ("write `*` for a product, `cross(a, b)` for that of two vectors", "*"),
        '·' | '∙' | '⋅' | '∗' | '＊' => {
            ("write `*` for a product, `dot(a, b)` for that of two vectors", "*")
        }
        '…' | '⋯' => ("write `sum(b[i] for i in 0..=3)`, or a loop, `for i in 0..=3`", ""),
        '⁻' => ("write `^(-1)` for a power with a negative exponent", ""),
        '（' | '［' => ("write the bracket of the keyboard, `(` or `[`", ""),
        '）' | '］' => ("write the bracket of the keyboard, `)` or `]`", ""),
        '，' => ("write the comma of the keyboard", ","),
        '；' => ("write the semicolon of the keyboard", ";"),
        '＝' => ("write the sign of the keyboard, `=`", "="),
        '＋' => ("write the sign of the keyboard, `+`", "+"),
        '÷' | '⁄' | '∕' | '／' => ("write `/` for a quotient", "/"),
        '∑' => ("write `sum(b[i] for i in 0..=n)`", ""),
        '∏' => ("write `product(… for i in 0..=n)`", ""),
        '∂' => ("write `D(b, t)` for a derivative", ""),
        '°' => ("angles are in radians: 90 degrees are `pi/2`", "*pi/180"),
        '½' => ("write `1/2`", "1"),
        '¼' => ("write `1/4`", "1"),
        '¾' => ("write `3/4`", "1"),
        '∞' => (
            "leave the end of the range out: `0 < λ` has no upper end; of a domain put t = s/(1 - s) with `0 <= s < 1`",
            "",
        ),
        '“' | '”' | '„' | '«' | '»' => ("write the straight quotation mark `\"`", ""),
        '\u{a0}' | '\u{2009}' | '\u{202f}' | '\u{3000}' => ("write an ordinary space", ""),
        '$' => ("leave it out: formulas stand without marks around them", ""),
        '\u{1d7ce}'..='\u{1d7ff}' => ("write the digit of the keyboard", ""),
        '`' | '\0' => ("remove it", ""),
        c if is_invisible(c) => ("it is invisible: remove it", ""),
        _ if c.is_alphanumeric() || c.is_whitespace() || is_name_part(c) => return None,
        _ => ("names are letters and digits; operators are `+ - * / ^`", ""),
    };
    let shown = if c.is_whitespace() || c.is_control() || is_invisible(c) {
        format!("U+{:04X}", c as u32)
    } else {
        format!("`{c}`")
    };
    Some((format!("the character {shown} is not allowed in a spec"), help.to_string(), instead.to_string()))
}

/// Whether a character is one that nobody sees: a soft hyphen, spaces and signs without width, the mark at the beginning of a file.
const fn is_invisible(c: char) -> bool {
    matches!(c, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{2060}'..='\u{2064}' | '\u{feff}')
}

/// Whether Rust allows the character inside a name although it is neither letter nor digit.
fn is_name_part(c: char) -> bool {
    syn::parse_str::<proc_macro2::Ident>(&format!("a{c}")).is_ok()
}

/// What is wrong with a path, and what to write instead.
pub(super) const BACKSLASH: &str = "a path cannot have a backslash";
pub(super) const SLASH: &str = "write `/` between folders, on every system: `use \"../quartic.basis\";`";

/// Walks over a text, leaving out comments and strings.
struct Scanner<'a> {
    text: &'a str,
    at: usize,
    unterminated: bool,
    /// Where they stand in strings.
    backslashes: Vec<usize>,
}

impl Scanner<'_> {
    fn next_code_char(&mut self, errors: &mut Vec<SyntaxError>) -> Option<(usize, char)> {
        loop {
            let rest = &self.text[self.at..];
            if rest.starts_with("//") {
                self.at += rest.find('\n').unwrap_or(rest.len());
            } else if rest.starts_with("/*") {
                self.skip_block_comment(errors);
            } else if rest.starts_with('"') {
                self.skip_string(errors);
            } else {
                let c = rest.chars().next()?;
                let at = self.at;
                self.at += c.len_utf8();
                return Some((at, c));
            }
        }
    }

    /// Block comments nest, as in Rust.
    fn skip_block_comment(&mut self, errors: &mut Vec<SyntaxError>) {
        let (start, mut depth) = (self.at, 0_usize);
        loop {
            let rest = &self.text[self.at..];
            if rest.starts_with("/*") {
                (self.at, depth) = (self.at + 2, depth + 1);
            } else if rest.starts_with("*/") {
                (self.at, depth) = (self.at + 2, depth - 1);
                if depth == 0 {
                    return;
                }
            } else if let Some(c) = rest.chars().next() {
                self.at += c.len_utf8();
            } else {
                errors.push(new(self.text, start, "this comment is never closed", "add `*/`"));
                self.unterminated = true;
                return;
            }
        }
    }

    fn skip_string(&mut self, errors: &mut Vec<SyntaxError>) {
        let start = self.at;
        self.at += 1;
        let known = self.backslashes.len();
        while let Some(c) = self.text[self.at..].chars().next() {
            let at = self.at;
            self.at += c.len_utf8();
            match c {
                '"' => return,
                '\\' => {
                    if self.backslashes.len() == known {
                        errors.push(new(self.text, at, BACKSLASH, SLASH));
                    }
                    self.backslashes.push(at);
                }
                _ => {}
            }
        }
        self.unterminated = true;
        errors.push(new(self.text, start, "this string is never closed", "add the closing `\"`"));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn messages(text: &str) -> Vec<String> {
        check(text).0.into_iter().map(|e| format!("{} | {}", e.message, e.help.unwrap_or_default())).collect()
    }

    fn repaired(text: &str) -> Option<String> {
        Some(check(text).1?.text.into_owned())
    }

    #[test]
    fn a_clean_text_has_no_errors() {
        assert!(
            messages("family F { b[0] = (1 - λ*t)^2; } // t² ≤ 1 '\n/* ( /* b' */ */ use \"a')\";")
                .is_empty()
        );
    }

    #[test]
    fn glyphs_of_papers_get_advice() {
        assert_eq!(
            messages("t²"),
            ["the superscript `²` is not allowed in a spec | write `^2` for a power, such as `t^2`"]
        );
        assert!(messages("λ₁")[0].contains("such as `λ1`"));
        assert!(messages("b'")[0].contains("D(b)"));
        assert!(messages("a − b ≤ c")[1].contains("`<=`"));
    }

    #[test]
    fn the_rest_is_read_with_what_was_meant() {
        assert_eq!(repaired("t² − λ₁").as_deref(), Some("t^2 -   λ1  "));
        assert_eq!(repaired("b''").as_deref(), Some("b  "));
        assert_eq!(repaired("("), None);
    }

    #[test]
    fn paths_are_read_as_they_are_meant() {
        let path = "use \"a/b.basis\";";
        for text in ["use 'a/b.basis';", "use `a/b.basis`;", "use 'a\\b.basis';", "use \"a\\b.basis\";"] {
            let errors = check(text).0;
            assert_eq!(errors.len(), 1, "{text}");
            assert!(errors[0].help.as_deref().is_some_and(|h| h.contains("use \"")), "{text}");
            assert_eq!(repaired(text).as_deref(), Some(path));
        }
        assert_eq!(repaired("use “a/b.basis” ;\n").as_deref(), Some("use \"a/b.basis\"     ;\n"));
        assert_eq!(messages("use 'a;").len(), 1);
        assert_eq!(messages("use '").len(), 1);
        assert!(messages("use a'")[0].contains("D(a)"));
    }

    #[test]
    fn brackets_must_balance() {
        assert!(
            messages("λ in (0, 4]")[0]
                .contains("`(` is closed by `]` | brackets must balance; write a range as inequalities")
        );
        assert!(messages("f(")[0].contains("never closed"));
        // At the bracket that is left open, not at the brace that ends the block.
        let (errors, _) = check("family F { b[0] = (1 - t; }");
        assert_eq!(errors.len(), 1);
        assert!(matches!(errors[0].place, SyntaxPlace::Bytes(ref r) if *r == (18..19)), "{errors:?}");
        assert_eq!(messages("{ ( [ } (").len(), 3);
        assert_eq!(messages("( }").len(), 1);
        assert!(messages(")")[0].contains("closes nothing"));
        assert!(messages(&"(".repeat(100_000))[0].contains("too deeply"));
        assert!(messages("/* ")[0].contains("never closed"));
    }
}
