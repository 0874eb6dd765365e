//! Equations on a page: what is wider than a line is broken before signs, and what no line holds, such as a long denominator,
//! gets a letter that is explained below.

/// The width of a page in tenths of the width of a digit.
const PAGE: usize = 620;

/// What a line is indented by that goes on with an equation: the name of the function before it, and some room.
const INDENT: usize = 55;

/// Equations below each other.
pub(super) fn display(lines: impl Iterator<Item = String>) -> String {
    let lines: Vec<String> = lines.collect();
    let mut names = Names { letter: free_letter(&lines), meant: Vec::new() };
    let lines: Vec<String> = lines.iter().map(|line| broken(line, &mut names)).collect();
    let mut text = lines.join(" \\\\\n");
    for (k, meant) in names.meant.iter().enumerate() {
        let before = if k == 0 { " \\\\\n\\intertext{with}\n" } else { " \\\\\n" };
        let line = filled(&loose(&format!("{} &= {meant}", names.name(k)), "\\bigl", "\\bigr"));
        text += &format!("{before}{line}");
    }
    format!("\\begin{{align*}}\n{text}\n\\end{{align*}}\n")
}

/// An equation, over several lines if it does not fit on one.
fn broken(line: &str, names: &mut Names) -> String {
    if width(line, Fractions::Full) <= PAGE {
        return line.to_string();
    }
    filled(&loose(&short(line, names), "\\bigl", "\\bigr"))
}

/// Letters for parts of formulas that are too wide for a line.
struct Names {
    letter: char,
    meant: Vec<String>,
}

impl Names {
    fn name(&self, k: usize) -> String {
        format!("{}_{{{}}}", self.letter, k + 1)
    }

    /// The name of a part.
    fn of(&mut self, part: &str) -> String {
        let known = self.meant.iter().position(|meant| meant == part);
        let k = known.unwrap_or_else(|| {
            self.meant.push(String::from(part));
            self.meant.len() - 1
        });
        self.name(k)
    }
}

/// A letter that stands for nothing else in formulas.
fn free_letter(lines: &[String]) -> char {
    let is_taken = |letter: &char| {
        // Commands are no names.
        let names = lines.iter().flat_map(|line| line.split('\\').enumerate());
        let mut rests = names.map(|(k, part)| if k == 0 { part } else { &part[letters(part)..] });
        rests.any(|rest| rest.contains(*letter))
    };
    "dqrkmghsvwz".chars().find(|letter| !is_taken(letter)).unwrap_or('d')
}

/// Fractions with long numerators as products, `\frac{1}{d} (n)`, and names in place of long denominators and of numbers
/// that are as wide as a line.
fn short(math: &str, names: &mut Names) -> String {
    let mut text = String::new();
    let mut rest = math;
    while let Some(at) = rest.find("\\frac{") {
        let (before, fraction) = rest.split_at(at);
        let (numer, more) = group(&fraction["\\frac".len()..]);
        let (denom, more) = group(more);
        let is_long = |part: &str| width(part, Fractions::Full) > PAGE / 2;
        let denom = if is_long(denom) { names.of(denom) } else { String::from(denom) };
        let fraction = match is_long(numer) {
            true if numer.contains(' ') => format!("\\frac{{1}}{{{denom}}} \\left({numer}\\right)"),
            true => format!("\\frac{{{}}}{{{denom}}}", names.of(numer)),
            false => format!("\\frac{{{numer}}}{{{denom}}}"),
        };
        text += &format!("{before}{fraction}");
        rest = more;
    }
    text + rest
}

/// A formula over as many lines as it needs.
fn filled(line: &str) -> String {
    let mut text = String::new();
    let mut used = 0;
    for part in parts(line, |rest| rest.starts_with(" + ") || rest.starts_with(" - ")) {
        let own = width(part, Fractions::Full);
        if used > INDENT && used + own > PAGE {
            text += " \\\\\n&\\quad";
            used = INDENT;
        }
        if used + own <= PAGE {
            text += part;
            used += own;
            continue;
        }
        // A product ends a line before a bracket.
        for factor in parts(part, |rest| rest.starts_with(" \\bigl")) {
            let own = width(factor, Fractions::Full);
            if used > INDENT && used + own > PAGE {
                text += " \\\\\n&\\quad";
                used = INDENT;
            }
            (text, used) = with_digits(text, used, factor);
        }
    }
    text
}

/// Adds a formula; a number that is wider than a line goes on in the next one.
fn with_digits(mut text: String, mut used: usize, factor: &str) -> (String, usize) {
    if used + width(factor, Fractions::Full) <= PAGE {
        return (text + factor, used + width(factor, Fractions::Full));
    }
    let (mut depth, mut digits, mut from) = (0_i32, 0, 0);
    for (at, c) in factor.char_indices() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        let inside = c.is_ascii_digit() && digits > 0 && depth == 0;
        if inside && used + width(&factor[from..at], Fractions::Full) > PAGE - INDENT {
            text += &format!("{} \\\\\n&\\quad ", &factor[from..at]);
            (used, from) = (INDENT, at);
        }
        digits = if c.is_ascii_digit() { digits + 1 } else { 0 };
    }
    let rest = &factor[from..];
    (text + rest, used + width(rest, Fractions::Full))
}

/// A formula in parts, each of which but the first begins outside of all groups as the condition says.
fn parts(line: &str, begins: impl Fn(&str) -> bool) -> Vec<&str> {
    let mut all = Vec::new();
    let (mut depth, mut from) = (0_i32, 0);
    for (at, c) in line.char_indices() {
        if depth == 0 && at > from && begins(&line[at..]) {
            all.push(&line[from..at]);
            from = at;
        }
        depth += i32::from(c == '{') - i32::from(c == '}');
    }
    all.push(&line[from..]);
    all
}

/// Brackets of other kinds in place of those that grow with what they hold, in which no line ends.
pub(super) fn loose(math: &str, open: &str, close: &str) -> String {
    let text = math.replace("\\left(", &format!("{open}(")).replace("\\right)", &format!("{close})"));
    text.replace("\\left[", &format!("{open}[")).replace("\\right]", &format!("{close}]"))
}

/// How large fractions are printed.
#[derive(Clone, Copy)]
pub(super) enum Fractions {
    /// As in equations on lines of their own.
    Full,
    /// As in texts and matrices.
    Small,
}

/// About how wide a formula is in print, in tenths of the width of a digit.
pub(super) fn width(formula: &str, fractions: Fractions) -> usize {
    let of = |part: &str| width(part, fractions);
    let mut all = 0;
    let mut rest = formula;
    while let Some(c) = rest.chars().next() {
        let after = &rest[c.len_utf8()..];
        (all, rest) = match c {
            '\\' if after.starts_with("frac{") => {
                let (numer, more) = group(&after["frac".len()..]);
                let (denom, more) = group(more);
                let widest = of(numer).max(of(denom));
                let widest = if matches!(fractions, Fractions::Full) { widest } else { widest * 7 / 10 };
                (all + 5 + widest, more)
            }
            '\\' if after.starts_with([',', ' ', ';']) => (all + 3, &after[1..]),
            '\\' => {
                let (command, more) = after.split_at(letters(after).max(1).min(after.len()));
                let own = match command {
                    "left" | "right" | "bigl" | "bigr" | "mathit" | "text" | "mathrm" => 0,
                    "quad" => 20,
                    "sin" | "cos" | "tan" | "exp" | "min" | "max" | "sinh" | "cosh" | "tanh" => {
                        9 * command.len()
                    }
                    "le" | "ge" | "ne" => 24,
                    _ => 11,
                };
                (all + own, more)
            }
            '^' | '_' => {
                let (script, more) = group(after);
                (all + of(script) * 7 / 10, more)
            }
            '+' | '-' | '=' => (all + 24, after),
            '{' | '}' | ' ' | '&' => (all, after),
            _ => (all + 11, after),
        };
    }
    all
}

/// How many letters a text begins with.
fn letters(text: &str) -> usize {
    text.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(text.len())
}

/// What stands in the braces with which a text begins, or its first sign, and what follows.
fn group(text: &str) -> (&str, &str) {
    let mut depth = 0;
    for (at, c) in text.char_indices() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        if depth == 0 {
            let end = at + c.len_utf8();
            let inside = text[..end].strip_prefix('{').and_then(|t| t.strip_suffix('}'));
            return (inside.unwrap_or(&text[..end]), &text[end..]);
        }
    }
    (text, "")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The lines of a display, without what stands around them.
    fn lines(equations: &[&str]) -> Vec<String> {
        let text = display(equations.iter().map(ToString::to_string));
        let inside = text.strip_prefix("\\begin{align*}\n").and_then(|t| t.strip_suffix("\n\\end{align*}\n"));
        inside.expect("it is a display").split(" \\\\\n").map(String::from).collect()
    }

    #[test]
    fn widths_are_those_of_print() {
        let small = |text| width(text, Fractions::Small);
        assert_eq!(small("\\frac{1}{20}"), small("\\frac{20}{1}"));
        assert!(small("\\frac{1}{20}") < width("\\frac{1}{20}", Fractions::Full));
        assert!(small("\\alpha") < small("aa") && small("x^{2}") < small("x2"));
        assert_eq!(group("x2"), ("x", "2"));
        assert_eq!(group("{a{b}}c"), ("a{b}", "c"));
    }

    #[test]
    fn a_line_that_fits_stays_as_it_is() {
        let line = "b_{0} &= \\frac{\\left(1 - t\\right)^{3}}{1 + t}";
        assert_eq!(lines(&[line]), [line]);
    }

    #[test]
    fn no_line_is_wider_than_the_page() {
        let sum = vec!["17\\,x^{2}\\,y"; 30].join(" + ");
        let digits = "1234567890".repeat(20);
        let all = [
            format!("b_{{0}} &= {sum}"),
            format!("b_{{0}} &= \\frac{{{sum}}}{{2}}"),
            format!("b_{{0}} &= 1 - \\frac{{x}}{{{sum}}} + \\frac{{y}}{{{sum}}}"),
            format!("b_{{0}} &= \\frac{{{digits}}}{{{digits}1}}"),
            format!("b_{{0}} &= x \\left({sum}\\right) \\left({sum}\\right)"),
            format!("b_{{0}} &= {digits}\\,x"),
        ];
        for equation in &all {
            for line in lines(&[equation]) {
                assert!(width(&line, Fractions::Full) <= PAGE + INDENT, "{equation}: {line}");
            }
        }
        // One denominator has one letter, and one that is free.
        let named = lines(&[&all[2], "P_{0} &= d\\,f"]);
        assert_eq!(named[0], "b_{0} &= 1 - \\frac{x}{q_{1}} + \\frac{y}{q_{1}}");
        assert!(named[2].starts_with("\\intertext{with}\nq_{1} &= 17\\,x^{2}\\,y"), "{named:?}");
    }
}
