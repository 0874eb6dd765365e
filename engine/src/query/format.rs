//! The standard layout of a spec: indentation, one statement a line, spaces around signs.
//!
//! Words, signs and comments stay as they are, in their order; only the white space between them changes. Where a
//! statement is broken into lines, at most one empty line between statements, and whether a product is written `a*b` or
//! `a * b` and an index `b[i-1,0]` or `b[i - 1, 0]`, is left to the author.

use core::fmt;

use super::lex::{Token, TokenKind, tokens};
use super::vocabulary::word;

/// Why a text has no layout.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FormatError {
    /// The byte at which the bracket stands that has no partner.
    pub offset: usize,
}

impl fmt::Display for FormatError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a bracket has no partner")
    }
}

impl core::error::Error for FormatError {}

/// One step of indentation.
const STEP: usize = 4;

/// A line of the result.
#[derive(Default)]
struct Line {
    indent: usize,
    code: String,
    /// A comment behind code, with the number of columns between them and the column at which it stood.
    comment: Option<(String, usize, usize)>,
}

/// The text of a spec in its standard layout.
///
/// # Errors
/// When a bracket has no partner.
pub fn format(text: &str) -> Result<String, FormatError> {
    let tokens = tokens(text);
    let alone = |t: &&Token| matches!(t.kind, TokenKind::Open | TokenKind::Close) && t.partner.is_none();
    if let Some(alone) = tokens.iter().find(alone) {
        return Err(FormatError { offset: alone.range.start });
    }
    let writer = Writer { text, tokens: &tokens, lines: Vec::new(), open: Vec::new() };
    Ok(writer.write())
}

/// A bracket that is open.
struct Open {
    /// Whether its content stands on lines of its own.
    broken: bool,
    /// Whether it is `{`, in which statements stand.
    block: bool,
    /// Whether it holds the indices of the name before it.
    index: bool,
    /// The indentation of the line on which it stands.
    indent: usize,
}

struct Writer<'t> {
    text: &'t str,
    tokens: &'t [Token],
    lines: Vec<Line>,
    open: Vec<Open>,
}

impl<'t> Writer<'t> {
    fn word(&self, k: usize) -> &'t str {
        self.tokens[k].text(self.text)
    }

    /// The white space before a token.
    fn gap(&self, k: usize) -> &str {
        let before = if k == 0 { 0 } else { self.tokens[k - 1].range.end };
        &self.text[before..self.tokens[k].range.start]
    }

    fn breaks(&self, k: usize) -> usize {
        self.gap(k).matches('\n').count()
    }

    /// The last token before this one that is not a comment.
    fn previous(&self, k: usize) -> Option<usize> {
        (0..k).rev().find(|k| !self.tokens[*k].is_comment())
    }

    fn write(mut self) -> String {
        for k in 0..self.tokens.len() {
            self.token(k);
        }
        self.align();
        let mut text = String::new();
        for line in &self.lines {
            let (code, comment) = (&line.code, &line.comment);
            if !code.is_empty() || comment.is_some() {
                text.extend(core::iter::repeat_n(' ', line.indent));
                text += code;
            }
            if let Some((comment, gap, _)) = comment {
                text.extend(core::iter::repeat_n(' ', *gap));
                text += comment;
            }
            text.push('\n');
        }
        text
    }

    fn token(&mut self, k: usize) {
        let token = &self.tokens[k];
        if token.is_comment() {
            return self.comment(k);
        }
        if token.kind == TokenKind::Close {
            return self.close(k);
        }
        if self.starts_line(k) {
            let (empty, indent) = (self.is_apart(k), self.indent(k));
            self.line(empty, indent);
        } else {
            let space = self.spaced(k);
            self.push(if space { " " } else { "" });
        }
        let word = self.word(k);
        self.push(word);
        if token.kind == TokenKind::Open {
            let block = word == "{";
            let next = k + 1;
            let empty = token.partner == Some(next);
            let item = block && self.open.is_empty();
            let broken = !empty && (item || self.breaks(next) > 0);
            let indent = self.lines.last().map_or(0, |line| line.indent);
            let index = word == "["
                && k > 0
                && matches!(self.tokens[k - 1].kind, TokenKind::Word | TokenKind::Close)
                && self.gap(k).is_empty();
            self.open.push(Open { broken, block, index, indent });
        }
    }

    /// Whether a token begins a line.
    fn starts_line(&self, k: usize) -> bool {
        let Some(before) = self.previous(k) else { return true };
        if self.follows_comment(k) {
            return true;
        }
        let last = self.word(before);
        let in_block = self.open.last().is_none_or(|open| open.block);
        let broken = self.open.last().is_none_or(|open| open.broken);
        match last {
            "{" => broken,
            ";" if in_block => broken,
            "}" => broken && self.word(k) != ";",
            _ => self.breaks(k) > 0 && !matches!(self.word(k), ";" | ","),
        }
    }

    /// Whether a comment stands before a token that goes on to the end of its line.
    fn follows_comment(&self, k: usize) -> bool {
        k > 0 && self.word(k - 1).starts_with("//")
    }

    /// Whether an empty line stands before a token: one that the author left, or between items.
    fn is_apart(&self, k: usize) -> bool {
        let Some(before) = k.checked_sub(1) else { return false };
        let opens = self.tokens[before].kind == TokenKind::Open;
        let item =
            self.open.is_empty() && self.word(before) == "}" && self.tokens[k].kind != TokenKind::Comment;
        !opens && (item || self.breaks(k) > 1)
    }

    /// The indentation of a line that begins with a token.
    fn indent(&self, k: usize) -> usize {
        let inside = match self.open.last() {
            Some(open) if open.broken => open.indent + STEP,
            Some(open) => open.indent,
            None => 0,
        };
        let continued = match self.previous(k) {
            None => false,
            Some(before) => match self.open.last() {
                // A statement goes on.
                Some(open) if open.block => !matches!(self.word(before), ";" | "{" | "}"),
                // In brackets that are broken the entries stand below each other.
                Some(open) => !open.broken,
                None => !matches!(self.word(before), ";" | "}"),
            },
        };
        inside + if continued { STEP } else { 0 }
    }

    fn close(&mut self, k: usize) {
        let open = self.open.pop();
        let (broken, indent) = open.as_ref().map_or((false, 0), |open| (open.broken, open.indent));
        let block = open.is_some_and(|open| open.block);
        let word = self.word(k);
        let after_comment = self.follows_comment(k);
        let empty = self.tokens[k].partner == k.checked_sub(1);
        if after_comment || broken && (block || self.breaks(k) > 0) {
            self.line(false, indent);
        } else if block && !empty {
            self.push(" ");
        }
        self.push(word);
    }

    fn comment(&mut self, k: usize) {
        let lines: Vec<&str> = self.word(k).lines().map(str::trim_end).collect();
        let behind = k > 0 && self.breaks(k) == 0;
        let is_line = self.word(k).starts_with("//");
        let code = self.lines.last().is_some_and(|line| !line.code.is_empty() && line.comment.is_none());
        if behind && code && is_line {
            let start = self.text[..self.tokens[k].range.start].rfind('\n').map_or(0, |at| at + 1);
            let column = self.text[start..self.tokens[k].range.start].chars().count();
            let gap = self.gap(k).chars().count().max(1);
            if let Some(line) = self.lines.last_mut() {
                line.comment = Some((lines[0].to_string(), gap, column));
            }
            return;
        }
        if behind && code {
            // A comment inside of a line.
            let tight = self.word(k - 1).ends_with(['(', '[']);
            let text = lines.join("\n");
            self.push(if tight { "" } else { " " });
            self.push(&text);
            return;
        }
        let (empty, indent) = (self.is_apart(k), self.comment_indent(k));
        self.line(empty, indent);
        // The lines of a comment keep their own indentation.
        let text = lines.join("\n");
        self.push(&text);
    }

    /// A comment on a line of its own stands as what follows it.
    fn comment_indent(&self, k: usize) -> usize {
        let next = (k + 1..self.tokens.len()).find(|k| !self.tokens[*k].is_comment());
        let closes = next.is_some_and(|next| self.tokens[next].kind == TokenKind::Close);
        match (self.open.last(), closes) {
            (Some(open), true) => open.indent + STEP,
            _ => self.indent(k),
        }
    }

    /// Begins a line, perhaps after an empty one.
    fn line(&mut self, empty: bool, indent: usize) {
        if empty && !self.lines.is_empty() {
            self.lines.push(Line::default());
        }
        self.lines.push(Line { indent, ..Line::default() });
    }

    fn push(&mut self, text: &str) {
        if self.lines.is_empty() {
            self.lines.push(Line::default());
        }
        if let Some(line) = self.lines.last_mut()
            && !(line.code.is_empty() && text == " ")
        {
            line.code += text;
        }
    }

    /// Whether a space stands between a token and the one before it on a line.
    fn spaced(&self, k: usize) -> bool {
        let Some(before) = k.checked_sub(1) else { return false };
        if self.tokens[before].is_comment() {
            return true;
        }
        let (a, b) = (self.word(before), self.word(k));
        let (left, right) = (self.tokens[before].kind, self.tokens[k].kind);
        if matches!(b, "," | ";") || matches!(a, "(" | "[") {
            return false;
        }
        let in_index = self.open.last().is_some_and(|open| open.index);
        if a == "," && in_index {
            return !self.gap(k).is_empty();
        }
        if a == "{" || b == "{" || matches!(a, "," | ";" | "}") {
            return true;
        }
        if left == TokenKind::Sign {
            return match a {
                "^" | ".." | "..=" | "." | "'" | "!" => false,
                "+" | "-" if in_index => self.is_binary(before) && self.is_wide(before),
                "+" | "-" => self.is_binary(before),
                // Two of them in a row are no formula.
                "*" | "/" if matches!(b, "*" | "/") => !self.gap(k).is_empty(),
                "*" | "/" => self.is_wide(before),
                _ => !Self::is_other(a) || !self.gap(k).is_empty(),
            };
        }
        if right == TokenKind::Sign {
            return match b {
                "^" | ".." | "..=" | "." | "'" => false,
                "*" | "/" => self.is_wide(k),
                "+" | "-" if in_index && self.is_binary(k) => self.is_wide(k),
                "!" => !self.gap(k).is_empty(),
                _ => !Self::is_other(b) || !self.gap(k).is_empty(),
            };
        }
        if right == TokenKind::Open {
            let keyword = word(a).is_some_and(|w| !w.rest.starts_with('(')) && !self.is_call(k);
            return left == TokenKind::Word && keyword
                || left == TokenKind::Close && b == "[" && !self.gap(k).is_empty();
        }
        true
    }

    /// Whether a word of the language stands as a name before this bracket: a name may be the same as such a word.
    fn is_call(&self, k: usize) -> bool {
        self.gap(k).is_empty() && self.word(k) == "["
    }

    /// Whether a sign is none of the language.
    fn is_other(sign: &str) -> bool {
        const KNOWN: [&str; 14] =
            ["=", "==", "!=", "<", "<=", ">", ">=", "&&", "||", "|", "+", "-", "*", "/"];
        !KNOWN.contains(&sign)
    }

    /// Whether a plus or minus stands between two terms.
    fn is_binary(&self, k: usize) -> bool {
        let Some(before) = self.previous(k) else { return false };
        match self.tokens[before].kind {
            TokenKind::Number | TokenKind::Close => true,
            TokenKind::Word => !matches!(
                self.word(before),
                "prove"
                    | "refute"
                    | "conjecture"
                    | "parallel"
                    | "if"
                    | "in"
                    | "domain"
                    | "shape"
                    | "scalar"
                    | "assume"
                    | "budget"
            ),
            _ => false,
        }
    }

    /// Whether the author wrote a space at either side of a sign, or a comment, which has spaces around it.
    fn is_wide(&self, k: usize) -> bool {
        let before = !self.gap(k).is_empty() || k > 0 && self.tokens[k - 1].is_comment();
        before || self.tokens.get(k + 1).is_some_and(|t| t.is_comment() || !self.gap(k + 1).is_empty())
    }

    /// Comments behind neighbouring lines that stood in one column stand in one column again.
    fn align(&mut self) {
        let width = |line: &Line| line.indent + line.code.chars().count();
        let column = |line: &Line| line.comment.as_ref().map(|(_, _, column)| *column);
        let mut first = 0;
        while first < self.lines.len() {
            let at = column(&self.lines[first]);
            let mut next = first + 1;
            while at.is_some() && next < self.lines.len() && column(&self.lines[next]) == at {
                next += 1;
            }
            let group = &mut self.lines[first..next];
            let widest = group.iter().map(&width).max().unwrap_or(0);
            let gap = group.iter().filter_map(|l| l.comment.as_ref().map(|(_, gap, _)| *gap)).min();
            for line in group {
                let own = width(line);
                if let (Some(comment), Some(gap)) = (&mut line.comment, gap) {
                    comment.1 = widest - own + gap;
                }
            }
            first = next;
        }
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::{TokenStream, TokenTree};

    use super::*;

    fn formatted(text: &str) -> String {
        let once = format(text).expect("the brackets match");
        let again = format(&once).expect("the brackets match");
        assert_eq!(once, again, "a second time nothing changes");
        let words = |text: &str| tokens(text).iter().map(|t| t.text(text).to_string()).collect::<Vec<_>>();
        assert_eq!(words(text), words(&once), "nothing is lost");
        assert_eq!(read(text), read(&once), "it is read as before");
        once
    }

    /// The tokens that the parser reads.
    fn read(text: &str) -> Option<Vec<String>> {
        fn leaves(stream: TokenStream) -> Vec<String> {
            let each = |tree| match tree {
                TokenTree::Group(group) => leaves(group.stream()),
                leaf => vec![leaf.to_string()],
            };
            stream.into_iter().flat_map(each).collect()
        }
        text.parse().ok().map(leaves)
    }

    #[test]
    fn numbers_that_end_with_a_point() {
        let text = "family F { b[0] = 1.-t; prove b[0] <= 3. for i in 0..=3. if i != 1; }";
        assert_eq!(
            formatted(text),
            "family F {\n    b[0] = 1. - t;\n    prove b[0] <= 3. for i in 0..=3. if i != 1;\n}\n"
        );
    }

    #[test]
    fn the_layout_is_the_house_style() {
        let messy = "//! Doc.\nuse   \"a.basis\" ;\nfamily F( n in 1 ..= 3 ){domain 0<=t<=1;shape -3<=λ<=1 ; // range\n\n\n  b[i]=λ*t ^ i-( 1-t )*-1 for i in 0..=n;prove at t=0{b[0]=1;D( b )=[-1,1];}\n}\nfamily G{}\n";
        let expected = "//! Doc.\nuse \"a.basis\";\nfamily F(n in 1..=3) {\n    domain 0 <= t <= 1;\n    shape -3 <= λ <= 1; // range\n\n    b[i] = λ*t^i - (1 - t)*-1 for i in 0..=n;\n    prove at t = 0 { b[0] = 1; D(b) = [-1, 1]; }\n}\n\nfamily G {}\n";
        assert_eq!(formatted(messy), expected);
    }

    #[test]
    fn broken_statements_stay_broken() {
        let text = "family F {\n    prove D(b) = [\n        -3*λ*t^2,\n      1,\n    ];\n prove at t = 0 {\n   b = [1,\n   0];\n}\n    let c = 1\n+ 2;\n}\n";
        let expected = "family F {\n    prove D(b) = [\n        -3*λ*t^2,\n        1,\n    ];\n    prove at t = 0 {\n        b = [1,\n            0];\n    }\n    let c = 1\n        + 2;\n}\n";
        assert_eq!(formatted(text), expected);
    }

    #[test]
    fn comments_keep_their_place() {
        let text = "family F {\n    // first\n    domain 0 <= t <= 1;   // a\n    b[0] = /* one */ 1;   // b\n    // last\n}\n// end\n";
        assert_eq!(
            formatted(text),
            "family F {\n    // first\n    domain 0 <= t <= 1;   // a\n    b[0] = /* one */ 1;   // b\n    // last\n}\n// end\n"
        );
        formatted("family F { // a\n b[0] = 1 // no semicolon\n + 2; /* x\n   y */ }\n/* c */ family G {}");
        formatted("x /* a */\n/* b\n */ y // c");
        // What follows after a line of its own does not become part of it.
        let text =
            "family F {\n    let c = 1\n        // a\n        ;\n    b[0] = (c\n        // b\n    );\n}\n";
        assert_eq!(formatted(text), text);
        formatted(
            "family F { b[0] = [1\n// a\n, 2\n// b\n]\n// c\n; prove at t = 0\n// d\n{ b = 1\n// e\n}\n// f\n}",
        );
    }

    /// Comments may stand between any two tokens.
    #[test]
    fn comments_everywhere_have_a_layout() {
        let text = "family F(n in 1..=3) { shape w[i] > 0 for i in 0..=n; b[i-1, 0] = -2*t^i/(1 - !t)*D(b, 2)[i+1]; prove at t = 0 { b = [1, -2*t]; } }\n";
        for comment in ["/* c */", "// c\n", "/// c\n", "/* a\n  b */", "/**/", "// /* c\n", "/* c */ // d\n"]
        {
            for token in tokens(text) {
                for at in [token.range.start, token.range.end] {
                    let text = format!("{}{comment}{}", &text[..at], &text[at..]);
                    // After a slash another comment begins, which may hold a bracket.
                    if format(&text).is_ok() {
                        formatted(&text);
                    }
                }
            }
        }
    }

    #[test]
    fn a_bracket_without_a_partner_is_named() {
        assert_eq!(format("family F {\n  b[0] = (1;\n}"), Err(FormatError { offset: 11 - 2 }));
        assert_eq!(format("x)"), Err(FormatError { offset: 1 }));
    }

    /// Formatting keeps every token and changes nothing the second time, whatever stands there.
    #[test]
    fn every_piece_of_a_spec_has_a_layout() {
        for (_, text) in basis_specs::SPECS {
            formatted(text);
        }
        let text = basis_specs::SPECS.iter().find(|(name, _)| *name == "quadratic").expect("it is shipped").1;
        let cuts: Vec<usize> = text.char_indices().map(|(at, _)| at).step_by(97).collect();
        for (k, from) in cuts.iter().enumerate() {
            for to in &cuts[k..] {
                let piece = &text[*from..*to];
                if format(piece).is_ok() {
                    formatted(piece);
                }
            }
        }
    }
}
