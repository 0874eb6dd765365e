//! A message as rustc prints its own: a title, the lines concerned with marks under them, notes and help.
//!
//! ```text
//! error: `b[0]` is defined twice
//!  --> line.basis:3:19
//!   |
//! 3 |     b[0] = 1 - t; b[0] = t;
//!   |                   ^^^^ defined again here
//!   |     ---- first defined here
//!   |
//!   = help: remove one of the definitions
//! ```

use core::ops::Range;

use basis_prover::collections::sort::sort_unique;
use unicode_width::UnicodeWidthStr;

use super::{Diagnostic, Place, Severity};
use crate::source::{Source, SourceId, Sources};

/// How characters look: the codes that a terminal takes for it.
type Paint = &'static str;
const PLAIN: Paint = "";
const BOLD: Paint = "\u{1b}[1m";
const RED: Paint = "\u{1b}[1m\u{1b}[91m";
const YELLOW: Paint = "\u{1b}[1m\u{1b}[33m";
const BLUE: Paint = "\u{1b}[1m\u{1b}[94m";
const RESET: &str = "\u{1b}[0m";

/// The most bytes of a line that are printed; of a longer line those around its marks.
const WIDEST: usize = 130;

/// The most lines of one mark that are all printed; of more the first three and the last two.
const TALLEST: usize = 8;

/// A marked part of a text: its first and last line, counted from one, and where in them it begins and ends, in bytes.
struct Mark<'a> {
    first: usize,
    start: usize,
    last: usize,
    end: usize,
    label: &'a str,
    /// What it is drawn with.
    sign: &'static str,
    paint: Paint,
}

/// The message with its notes and help, without an end of line; `styled` adds the colours of a terminal.
pub(super) fn render(diagnostic: &Diagnostic, sources: &Sources, styled: bool) -> String {
    let (level, paint) = match diagnostic.severity {
        Severity::Error => ("error", RED),
        Severity::Warning => ("warning", YELLOW),
    };
    // One entry for each text: its line and column that the terminal opens, and its marks.
    let mut texts: Vec<(SourceId, (usize, usize), Vec<Mark<'_>>)> = Vec::new();
    let mut gutter = 0;
    for (k, (place, label)) in diagnostic.labels.iter().enumerate() {
        let Place::Text(id, range) = place else { continue };
        let source = sources.get(*id);
        let Some(text) = source.text.as_deref() else { continue };
        let range = visible(text, range);
        let mark = if k == 0 {
            mark(source, &range, label, ("^", paint))
        } else {
            // Only the first mark goes from line to line.
            let end = source.line_range(source.line(range.start)).end;
            mark(source, &(range.start..range.end.min(end)), label, ("-", BLUE))
        };
        gutter = mark.last.to_string().len().max(gutter);
        match texts.iter_mut().find(|(other, ..)| other == id) {
            Some((.., marks)) => marks.push(mark),
            None => texts.push((*id, source.line_column(range.start), vec![mark])),
        }
    }
    let mut page = Page { text: String::new(), styled, gutter };
    page.put(level, paint);
    page.put(&format!(": {}", printed(&diagnostic.message)), BOLD);
    for (k, (id, (line, column), marks)) in texts.iter().enumerate() {
        let source = sources.get(*id);
        page.margin("", if k == 0 { "--> " } else { "::: " });
        page.put(&format!("{}:{line}:{column}", source.name), PLAIN);
        page.margin("", " |");
        page.lines(source, marks);
    }
    let help = diagnostic.help.iter().map(|text| ("help", text));
    let notes = diagnostic.notes.iter().map(|text| ("note", text)).chain(help);
    for (k, (word, text)) in notes.enumerate() {
        if k == 0 {
            page.margin("", " |");
        }
        page.margin("", " = ");
        page.put(word, BOLD);
        // Further lines begin under the first.
        let indent = format!("\n{:1$}", "", gutter + " = note: ".len());
        page.put(&format!(": {}", printed(text).replace('\n', &indent)), PLAIN);
    }
    page.text
}

fn mark<'a>(
    source: &Source,
    range: &Range<usize>,
    label: &'a str,
    (sign, paint): (&'static str, Paint),
) -> Mark<'a> {
    let (first, last) = (source.line(range.start), source.line(range.end));
    let [start, end] =
        [(first, range.start), (last, range.end)].map(|(line, at)| at - source.line_range(line).start);
    Mark { first, start, last, end, label, sign, paint }
}

/// What is printed so far.
struct Page {
    text: String,
    styled: bool,
    /// The width of the line numbers.
    gutter: usize,
}

impl Page {
    fn put(&mut self, text: &str, paint: Paint) {
        let styled = self.styled && !paint.is_empty() && !text.is_empty();
        for part in if styled { [paint, text, RESET] } else { ["", text, ""] } {
            self.text.push_str(part);
        }
    }

    /// Begins a line: the number of a line of the text, or nothing, and the bar behind it.
    fn margin(&mut self, number: &str, bar: &str) {
        let gutter = self.gutter;
        self.text.push('\n');
        self.put(&format!("{number:>gutter$}{bar}"), BLUE);
    }

    /// The lines of a text that have marks, and what little is between them.
    fn lines(&mut self, source: &Source, marks: &[Mark<'_>]) {
        let text = source.text.as_deref().unwrap_or_default();
        let mut lines = Vec::new();
        for mark in marks {
            let hidden = if mark.last - mark.first < TALLEST { 0..0 } else { mark.first + 3..mark.last - 1 };
            lines.extend((mark.first..=mark.last).filter(|line| !hidden.contains(line)));
        }
        sort_unique(&mut lines);
        let mut before = lines.first().map_or(0, |line| line - 1);
        for line in lines {
            if line == before + 2 {
                self.line(line - 1, &text[source.line_range(line - 1)], marks); // no longer than dots in its place
            } else if line > before + 1 {
                let tall = marks.iter().find(|mark| mark.first < line && before < mark.last);
                self.text.push('\n');
                self.put("...", BLUE);
                if let Some(mark) = tall {
                    self.put(&format!("{:>1$}", "|", self.gutter + 1), mark.paint);
                }
            }
            before = line;
            self.line(line, &text[source.line_range(line)], marks);
        }
    }

    /// A line of a text, and below it its marks.
    fn line(&mut self, number: usize, text: &str, marks: &[Mark<'_>]) {
        let starts = marks.iter().filter(|mark| mark.first == number).map(|mark| mark.start);
        let ends = marks.iter().filter(|mark| mark.last == number).map(|mark| mark.end);
        let window = window(text, starts.chain(ends).min().unwrap_or(0));
        let dots = |cut: bool| if cut { "..." } else { "" };
        let (left, right) = (dots(window.start > 0), dots(window.end < text.len()));
        let column =
            |at: usize| left.len() + columns(&text[window.start..at.clamp(window.start, window.end)]);
        // A mark over several lines is a bracket beside them; it is open above where the mark begins inside of a line.
        let tall = marks.iter().find(|mark| mark.first < mark.last);
        let begins = tall.filter(|mark| mark.first == number);
        let ends = tall.filter(|mark| mark.last == number);
        let whole = begins.is_some_and(|mark| text[..mark.start].trim_start().is_empty());
        let inside = tall.is_some_and(|mark| mark.first < number && number <= mark.last);
        let paint = tall.map_or(PLAIN, |mark| mark.paint);
        let bracket = |sign| {
            if tall.is_none() {
                ""
            } else if whole || inside {
                sign
            } else {
                "  "
            }
        };

        self.margin(&number.to_string(), " |");
        let shown = format!("{left}{}{right}", printed(&text[window.clone()]));
        let side = bracket(if whole { "/ " } else { "| " });
        if shown.is_empty() {
            self.put(format!(" {side}").trim_end(), paint); // no blanks at the end of a line
        } else {
            self.put(" ", PLAIN);
            self.put(side, paint);
            self.put(&shown, PLAIN);
        }
        for mark in marks.iter().filter(|mark| mark.first == number && mark.last == number) {
            self.margin("", " | ");
            self.put(bracket("| "), paint);
            let (start, end) = (column(mark.start), column(mark.end));
            self.put(&" ".repeat(start), PLAIN);
            self.put(&mark.sign.repeat(end.saturating_sub(start).max(1)), mark.paint);
            self.word(mark);
        }
        if let Some(mark) = begins.filter(|_| !whole) {
            self.margin("", " | ");
            self.put(&format!(" {}^", "_".repeat(column(mark.start) + 1)), paint);
        }
        if let Some(mark) = ends {
            self.margin("", " | ");
            self.put(&format!("|{}^", "_".repeat(column(mark.end))), paint);
            self.word(mark);
        }
    }

    /// What is said about a mark, behind it.
    fn word(&mut self, mark: &Mark<'_>) {
        if !mark.label.is_empty() {
            self.put(&format!(" {}", printed(mark.label)), mark.paint);
        }
    }
}

/// The range cut to the text and widened to whole characters; at the end of the text at least an empty range on its
/// last line.
///
/// A token that stands in for a character of several bytes ends inside of it.
fn visible(text: &str, range: &Range<usize>) -> Range<usize> {
    let start = before(text, range.start.min(text.trim_end().len()));
    let mut stop = range.end.min(text.len());
    while !text.is_char_boundary(stop) {
        stop += 1;
    }
    start..stop.max(start)
}

/// What is printed of a line: all of it, or what surrounds its first mark.
fn window(line: &str, mark: usize) -> Range<usize> {
    if line.len() <= WIDEST {
        return 0..line.len();
    }
    let start = before(line, mark.saturating_sub(WIDEST / 2).min(line.len() - WIDEST));
    start..before(line, start + WIDEST)
}

/// The last place between characters that is not behind this one.
fn before(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// A text as it is printed: tabs as blanks, signs for what would steer the terminal.
fn printed(text: &str) -> String {
    let mut printed = String::new();
    for c in text.chars() {
        match c {
            '\t' => printed.push_str("    "),
            '\n' => printed.push(c),
            // Behind U+2400 stand signs for the control characters of ASCII, in their order.
            '\0'..='\x1f' => printed.extend(char::from_u32(0x2400 + u32::from(c))),
            '\x7f'..='\u{9f}'
            | '\u{200e}'
            | '\u{200f}'
            | '\u{202a}'..='\u{202e}'
            | '\u{2066}'..='\u{2069}' => {
                printed.push(char::REPLACEMENT_CHARACTER);
            }
            _ => printed.push(c),
        }
    }
    printed
}

/// How many columns of a terminal a text takes as it is printed.
fn columns(text: &str) -> usize {
    UnicodeWidthStr::width(printed(text).as_str())
}
