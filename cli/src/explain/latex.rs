//! A paper's section about each family: definition, properties, ends, contacts. A whole document, ready to compile.

use basis_engine::query::latex::{escape, inline, math, name as latex_name};

use super::facts::{ClaimFacts, Contact, Equation, Facts, FamilyFacts, MatrixFacts, TheoremFacts};
use super::lines::{display, loose};
use super::places;

/// The document.
pub(super) fn document(all: &[Facts]) -> String {
    let mut text = String::from(HEAD);
    for (k, facts) in all.iter().enumerate() {
        text += &match facts {
            Facts::Family(facts) => {
                let is_span = |other: Option<&Facts>| matches!(other, Some(Facts::Family(f)) if f.title == facts.title && f.whole_domain.is_some());
                // What is about all spans together stands with the first one, after the formulas of all of them.
                let others = all[k..].iter().take_while(|other| is_span(Some(other)));
                let others: Vec<&FamilyFacts> = others
                    .filter_map(|other| if let Facts::Family(f) = other { Some(&**f) } else { None })
                    .collect();
                match others.as_slice() {
                    [] => family(facts, &[facts]),
                    _ if k > 0 && is_span(all.get(k - 1)) => String::new(),
                    spans => family(facts, spans),
                }
            }
            Facts::Theorem(facts) | Facts::Join(facts) => theorem(facts),
        };
    }
    text + "\\end{document}\n"
}

const HEAD: &str = "\
% Written by `basis explain --format latex`. The packages are those of every LaTeX distribution.
\\documentclass{article}
\\usepackage[T1]{fontenc}
\\usepackage{amsmath,amssymb,amsthm}
\\theoremstyle{definition}
\\newtheorem*{definition}{Definition}
\\theoremstyle{plain}
\\newtheorem*{theorem}{Theorem}
\\theoremstyle{remark}
\\newtheorem*{remark}{Remark}
\\allowdisplaybreaks
\\setcounter{MaxMatrixCols}{20}
\\sloppy
\\begin{document}
";

/// The section of a family on one span or several.
fn family(facts: &FamilyFacts, spans: &[&FamilyFacts]) -> String {
    let mut text = head(&facts.title, &facts.doc);
    let ranges: Vec<String> =
        facts.shapes.iter().chain(&facts.assumptions).map(|range| inline(range)).collect();
    text += "\\begin{definition}\n";
    for (k, span) in spans.iter().enumerate() {
        let given = match (k, ranges.as_slice()) {
            (0, []) => String::from("The functions"),
            (0, ranges) => format!("For shape parameters {} the functions", ranges.join(", ")),
            _ => String::from("and"),
        };
        text += &format!("{given} on {}{}\n", domain(&span.domain), if k == 0 { " are" } else { "" });
        text += &display(span.functions.iter().map(function));
    }
    text += "\\end{definition}\n\n";
    text += &names(&facts.definitions);
    text += &claims(&facts.claims);
    for exception in &facts.dependent {
        let (values, relation) = exception.split_once(": ").unwrap_or((exception, ""));
        text += &format!("The functions are linearly dependent at {}", inline(values));
        text +=
            &if relation.is_empty() { String::from(".\n\n") } else { format!(": {}.\n\n", inline(relation)) };
    }
    if facts.whole_domain.is_some() {
        text += &contacts(facts);
        text += &matrices(&facts.matrices_of_whole_domain);
    }
    for span in spans {
        if spans.len() > 1 {
            text += &format!("\\subsection*{{On {}}}\n", domain(&span.domain));
        }
        text += &of_span(span);
    }
    text
}

/// Ends, contacts, matrices and extrema of a family, or on one of its spans.
fn of_span(facts: &FamilyFacts) -> String {
    let mut text = String::new();
    if !facts.ends.is_empty() {
        let b = facts.functions.first().and_then(|f| f.name.split_once('[')).map_or("b", |(b, _)| b);
        text += &format!("A curve $C = \\sum_i {}_i P_i$ has at its ends\n", latex_name(b));
        text += &display(facts.ends.iter().map(|e| e.latex.clone()));
    }
    if facts.whole_domain.is_none() {
        text += &contacts(facts);
    }
    text += &matrices(&facts.matrices);
    if let Some(left_out) = &facts.matrices_open {
        text += &format!("{}\n\n", escape(left_out));
    }
    for f in &facts.extrema {
        let (least, greatest) = (places::taken(&f.minimum, &inline), places::taken(&f.maximum, &inline));
        // `f[1] at a = 0, b = 0`
        let (name, at) = f.name.split_once(" at ").map_or((&*f.name, None), |(name, at)| (name, Some(at)));
        let at = at.map(|at| format!(" at {}", inline(at))).unwrap_or_default();
        if places::is_constant(f) {
            text +=
                &format!("The function {}{at} is constant, {}.\n\n", inline(name), inline(&f.minimum.value));
            continue;
        }
        text += &format!(
            "The function {}{at} has {}, the least value {least} and the greatest value {greatest}.",
            inline(name),
            places::zeros(f, &inline).replacen("zero ", "zeros ", 1),
        );
        for note in places::notes(f) {
            let (first, rest) = note.split_at(1);
            text += &format!(" {}{rest}.", first.to_uppercase());
        }
        text += "\n\n";
    }
    for open in &facts.extrema_open {
        let (name, why) = (inline(&open.name), escape(&open.why));
        text += &format!("Zeros and extrema of {name} are not stated: {why}.\n\n");
    }
    text
}

/// What contacts with another curve determine.
fn contacts(facts: &FamilyFacts) -> String {
    facts.contacts.iter().map(of_contact).collect()
}

fn matrices(all: &[MatrixFacts]) -> String {
    let mut text = String::new();
    for matrix in all.iter().filter(|m| m.columns.len() <= MAX_COLUMNS) {
        let (title, formula) = matrix.title.split_once(": ").unwrap_or((&matrix.title, ""));
        let formula = if formula.is_empty() { String::new() } else { format!(". {}", sum(formula)) };
        let (shown, letters) = super::matrix::matrix(&matrix.entries);
        // The heading ends with its full stop.
        let (stop, formula) = formula.split_at(formula.len().min(1));
        text += &format!("\\paragraph{{{}{stop}}}{formula}\n{shown}", words(title));
        if !letters.is_empty() {
            text += &format!("with\n{}", display(letters.into_iter()));
        }
        text.push('\n');
    }
    text
}

/// `name &= formula`
fn function(f: &super::facts::Function) -> String {
    let (name, value) = (math(&f.name).unwrap_or_default(), &f.latex);
    if value.is_empty() {
        format!("{name} &= \\text{{{}}}", escape(&f.factored))
    } else {
        format!("{name} &= {value}")
    }
}

/// Wider matrices do not fit on a page.
const MAX_COLUMNS: usize = 16;

/// A domain in words: the triangle where $u + v + w = 1$ and $u, v, w \ge 0$.
fn domain(text: &str) -> String {
    let mut parts: Vec<String> = Vec::new();
    let mut rest = text;
    loop {
        let simplex = rest.split_once(" (").and_then(|(kind, after)| {
            let (names, after) = after.split_once(')')?;
            let plain = kind.chars().all(|c| c.is_ascii_lowercase());
            plain.then_some((kind, names, after.strip_prefix(", ").unwrap_or(after)))
        });
        let Some((kind, names, after)) = simplex else { break };
        let names: Vec<String> = names.split(", ").map(latex_name).collect();
        parts.push(format!("the {kind} where ${} = 1$ and ${} \\ge 0$", names.join(" + "), names.join(", ")));
        rest = after;
    }
    if !rest.is_empty() {
        parts.push(inline(rest));
    }
    parts.join(", times ")
}

/// What a matrix is for, such as `b[i] = Σ M[i,j]*B[j]`.
fn sum(formula: &str) -> String {
    let sides = formula.split_once(" = Σ ").and_then(|(left, right)| Some((math(left)?, math(right)?)));
    // Lines end where brackets are of a fixed size.
    let set =
        |(left, right): (String, String)| loose(&format!("${left} = \\sum {right}$"), "\\bigl", "\\bigr");
    sides.map_or_else(|| inline(formula), set)
}

/// A title with its formulas in math mode: words with an operator or a bracket are formulas.
fn words(title: &str) -> String {
    let word = |word: &str| {
        let (word, end) = word.strip_suffix(',').map_or((word, ""), |word| (word, ","));
        let formula = word.contains(['[', '*', '(']) || word == "+";
        format!("{}{end}", if formula { inline(word) } else { escape(word) })
    };
    let plain = |text: &str| text.split(' ').map(word).collect::<Vec<_>>().join(" ");
    // A denominator is one formula, with spaces in it, and so is what is integrated.
    if let Some((before, below)) = title.split_once(" over the common denominator ") {
        return format!("{} over the common denominator {}", plain(before), inline(below));
    }
    match title.split_once("the integrals of ") {
        Some((before, rest)) => {
            let (formula, given) = rest.split_once(" for ").map_or((rest, None), |(f, g)| (f, Some(g)));
            let given = given.map(|g| format!(" for {}", inline(g))).unwrap_or_default();
            format!("{}the integrals of {}{given}", plain(before), inline(formula))
        }
        None => plain(title),
    }
}

fn of_contact(contact: &Contact) -> String {
    if contact.points.is_empty() {
        return String::new();
    }
    let (title, equations) = contact.title.split_once(": ").unwrap_or((&contact.title, ""));
    let conditions: Vec<String> = contact.conditions.iter().map(|c| inline(c)).collect();
    let given =
        if conditions.is_empty() { String::new() } else { format!(", for {},", conditions.join(" and ")) };
    let mut text =
        format!("\\paragraph{{{}.}} The condition {} determines{given}\n", escape(title), inline(equations));
    text += &display(contact.points.iter().map(|e: &Equation| e.latex.clone()));
    text
}

fn theorem(facts: &TheoremFacts) -> String {
    let mut text = head(&facts.name, &facts.doc);
    let patches: Vec<String> = facts.patches.iter().map(|p| inline(p)).collect();
    let scalars: Vec<String> = facts.scalars.iter().map(|s| inline(s)).collect();
    if !patches.is_empty() {
        text += &format!("Let {}", patches.join(", "));
        text += &if scalars.is_empty() {
            String::from(".\n\n")
        } else {
            format!(" with {}.\n\n", scalars.join(", "))
        };
    }
    if !facts.points.is_empty() {
        text += "The control points are\n";
        text += &display(facts.points.iter().map(|e| e.latex.clone()));
    }
    text += &names(&facts.definitions);
    text + &claims(&facts.claims)
}

fn head(title: &str, doc: &[String]) -> String {
    let mut text = format!("\\section*{{{}}}\n", escape(title));
    for line in doc {
        text += &escape(line);
        text.push('\n');
    }
    text + "\n"
}

/// What names in the claims stand for.
fn names(definitions: &[Equation]) -> String {
    if definitions.is_empty() {
        return String::new();
    }
    format!("In what follows\n{}\n", display(definitions.iter().map(|e| e.latex.clone())))
}

/// What is proved as a theorem, what is refuted as a remark.
fn claims(claims: &[ClaimFacts]) -> String {
    let mut text = String::new();
    // Of the claims of one statement the sentence is the same.
    let mut groups: Vec<(&ClaimFacts, Vec<&ClaimFacts>)> = Vec::new();
    for claim in claims {
        match groups.last_mut() {
            Some((first, group)) if first.statement == claim.statement && first.latex == claim.latex => {
                group.push(claim);
            }
            _ => groups.push((claim, vec![claim])),
        }
    }
    let proved: Vec<&str> = groups
        .iter()
        .filter(|(_, group)| group.iter().all(|c| c.verdict == "proved"))
        .map(|(first, _)| first.latex.as_str())
        .collect();
    if !proved.is_empty() {
        text += "\\begin{theorem}\n\\leavevmode\n\\begin{enumerate}\n";
        for sentence in proved {
            text += &format!("\\item {}\n", flowing(sentence));
        }
        text += "\\end{enumerate}\n\\end{theorem}\n\n";
    }
    for (first, group) in &groups {
        if let Some(refuted) = group.iter().find(|c| c.verdict == "refuted") {
            let sentence = within(&flowing(first.latex.trim_end_matches('.')));
            let reason = reason(&refuted.reason);
            text += &format!(
                "\\begin{{remark}}\nIt is false that {sentence}. Indeed, {reason}.\n\\end{{remark}}\n\n"
            );
        } else if let Some(open) = group.iter().find(|c| c.verdict == "undecided") {
            let sentence = within(&flowing(first.latex.trim_end_matches('.')));
            let reason = reason(&open.reason);
            text += &format!(
                "\\begin{{remark}}\nIt is not decided whether {sentence} ({reason}).\n\\end{{remark}}\n\n"
            );
        }
    }
    text
}

/// A sentence as a part of another one.
fn within(sentence: &str) -> String {
    let lower = |word: &str| Some(format!("{}{}", word.to_lowercase(), sentence.strip_prefix(word)?));
    lower("The ")
        .or_else(|| lower("At "))
        .or_else(|| lower("Neighbouring "))
        .unwrap_or_else(|| sentence.to_string())
}

/// What a scalar should be declared as is no part of a proof.
fn without_hints(text: &str) -> String {
    let mut parts = text.split("; `");
    let mut kept = parts.next().unwrap_or_default().to_string();
    for part in parts {
        let is_hint = part.ends_with("` can be any number") || part.ends_with(";` declares it positive");
        if !is_hint {
            kept += &format!("; `{part}");
        }
    }
    kept
}

/// A reason; formulas stand in it between the marks of code, or around equations.
fn reason(text: &str) -> String {
    let mut latex = String::new();
    let text = without_hints(text);
    for (k, part) in text.split('`').enumerate() {
        if k % 2 == 1 && math(part).is_some() {
            latex += &inline(part);
            continue;
        }
        // `is -16/625 at λ = -4, t = 1/5`: words, with formulas from a word to the next.
        let mut words: Vec<&str> = Vec::new();
        let mut pending: Vec<&str> = Vec::new();
        let flush = |pending: &mut Vec<&str>, latex: &mut String| {
            if !pending.is_empty() {
                *latex += &bracketed(&pending.join(" "));
                pending.clear();
            }
        };
        for word in part.split(' ') {
            words.push(word);
            let plain = word.trim_end_matches([')', ';']);
            let prose = plain.len() > 1 && plain.chars().all(|c| c.is_ascii_lowercase() || c == ',');
            if prose || word.is_empty() {
                flush(&mut pending, &mut latex);
                if words.len() > 1 && !latex.ends_with(' ') && !latex.is_empty() {
                    latex.push(' ');
                }
                latex += &escape(word);
                latex.push(' ');
            } else {
                let (formula, end) = match word.strip_suffix(';') {
                    Some(formula) => (formula, ";"),
                    None => (word, ""),
                };
                pending.push(formula);
                if !end.is_empty() {
                    flush(&mut pending, &mut latex);
                    latex += "; ";
                }
            }
        }
        flush(&mut pending, &mut latex);
    }
    latex.trim().replace("  ", " ")
}

/// A formula before which a bracket opens, or after which one closes, that is about the words around it.
fn bracketed(text: &str) -> String {
    if math(text).is_none() {
        if let Some((before, after)) = text.split_once(") - (") {
            return format!("{}) $-$ ({}", bracketed(before), bracketed(after));
        }
        if let Some(rest) = text.strip_prefix('(') {
            return format!("({}", bracketed(rest));
        }
        if let Some(rest) = text.strip_suffix(')') {
            return format!("{})", bracketed(rest));
        }
        // A value after what has it.
        if let Some(value) = text.strip_prefix("= ").and_then(math) {
            return format!("$= {value}$");
        }
        // A sign alone stands between two phrases.
        if text == "-" {
            return String::from("$-$");
        }
    }
    inline(text)
}

/// The most characters of a sentence that is one line of its formulas.
const MAX_LINE: usize = 100;

/// A sentence whose formulas may end a line anywhere between terms and entries.
fn flowing(sentence: &str) -> String {
    if sentence.chars().count() <= MAX_LINE {
        return sentence.to_string();
    }
    loose(sentence, "", "").replace(",\\ ", ",\\allowbreak\\ ")
}
