//! The verdicts as tables.

use std::fmt::Write as _;
use std::time::Duration;

use basis_engine::state::Standing;
use basis_engine::{Family, Subject};

use super::orders;
use super::prove::{Decided, Outcome};
use super::rows::rows;
use crate::domain;
use crate::name::count;
use crate::table::{self, BAD, FAINT, GOOD, Mark, OPEN, Row, STRONG, styled};

/// A reason is cut after this many characters: every row would be as long, and the whole of it is in the message about the
/// claim and in the JSON.
const LONGEST: usize = 1000;

fn cut(mut reason: String) -> String {
    if let Some((end, _)) = reason.char_indices().nth(LONGEST) {
        reason.truncate(end);
        reason.push('…');
    }
    reason
}

/// One file: its path, and a table for each family.
pub(crate) fn file(outcome: &Outcome, width: Option<u16>) -> String {
    let mut text = format!("{}\n\n", styled(FAINT, &outcome.path));
    for items in outcome.items.chunk_by(|a, b| a.subject.is_same(&b.subject)) {
        text += &family(items, width);
        text.push('\n');
    }
    text
}

/// One family in all its orders: a heading and a table.
fn family(items: &[Decided], width: Option<u16>) -> String {
    let mut text = heading(items);
    let rows = rows(items);
    if rows.is_empty() {
        text += "   no claims\n";
        return text;
    }
    let condensed = items.len() > 1;
    let cells: Vec<Row> = rows
        .into_iter()
        .map(|row| {
            let (mark, verdict) = verdict(row.standing);
            let mut cells = vec![row.claim, verdict.to_string(), cut(row.reason)];
            if condensed {
                cells.push(time(row.worst));
            }
            cells.push(time(row.total));
            Row { mark: Some(mark), cells }
        })
        .collect();
    let mut header = vec!["claim", "verdict", "method or counterexample"];
    header.extend(if condensed { ["worst", "total"].as_slice() } else { &["time"] });
    text + &table::layout(&header, &cells, &[3, 4], width)
}

const fn verdict(standing: Standing) -> (Mark, &'static str) {
    match standing {
        Standing::Proved => (("✓", GOOD), "proved"),
        Standing::Refuted => (("✓", GOOD), "refuted as declared"),
        Standing::False => (("✗", BAD), "refuted"),
        Standing::True => (("✗", BAD), "proved, declared false"),
        Standing::Undecided => (("?", OPEN), "undecided"),
        Standing::Open => (("?", OPEN), "conjecture, open"),
    }
}

/// The name, with the orders, functions and ranges of a family, or the curves and surfaces of a theorem.
fn heading(items: &[Decided]) -> String {
    let Some(first) = items.first() else { return String::new() };
    if let Subject::Theorem(theorem) = &first.subject {
        return domain::theorem_heading(theorem, &styled(STRONG, &theorem.title()));
    }
    let families: Vec<&Family> = items
        .iter()
        .filter_map(|item| match &item.subject {
            Subject::Family(family) => Some(&**family),
            Subject::Theorem(_) => None,
        })
        .collect();
    family_heading(&families)
}

/// The name with its orders, how many functions there are, of which degree, and the ranges.
fn family_heading(families: &[&Family]) -> String {
    let Some(family) = families.first() else { return String::new() };
    let mut title = family.name.clone();
    if !family.order.is_empty() {
        let names: Vec<&str> = family.order.iter().map(|(name, _)| name.as_str()).collect();
        let orders = orders::describe(families.iter().map(|family| family.order.as_slice()));
        let _ = write!(title, "({}), {orders}", names.join(", "));
    }
    let functions = range(families, |family| family.functions.len());
    let noun = if functions == "1" { "function" } else { "functions" };
    let mut facts = vec![
        format!("{functions} {noun} {}", kind(families)),
        format!("domain {}", same(families, domain::describe)),
    ];
    if families.iter().any(|family| !family.shapes.is_empty()) {
        facts.push(format!("shape {}", same(families, shapes)));
    }
    let assumed = |family: &Family| domain::assumptions(family).join(", ");
    if families.iter().any(|family| !assumed(family).is_empty()) {
        facts.push(format!("assume {}", same(families, assumed)));
    }
    format!("{}: {}\n", styled(STRONG, &title), facts.join("; "))
}

/// What kind of functions they are: `of degree 4`, or `with sin, cos`.
fn kind(families: &[&Family]) -> String {
    if let Some(with) = families.iter().find_map(|family| domain::transcendental(family)) {
        return String::from(with);
    }
    let all: Vec<Vec<u32>> = families.iter().map(|family| domain::degrees(family)).collect();
    let factors = all.first().map_or(0, Vec::len);
    let degrees: Vec<String> =
        (0..factors).map(|k| range(&all, |degrees| degrees.get(k).copied().unwrap_or(0))).collect();
    let degrees = if degrees.len() == 1 { degrees.concat() } else { format!("({})", degrees.join(", ")) };
    format!("of degree {degrees}")
}

/// `4`, or `2 to 31` where the orders differ.
fn range<F, T: Ord + ToString>(families: &[F], measure: impl Fn(&F) -> T) -> String {
    let values = || families.iter().map(&measure);
    match (values().min(), values().max()) {
        (Some(low), Some(high)) if low < high => format!("{} to {}", low.to_string(), high.to_string()),
        (Some(low), _) => low.to_string(),
        _ => String::new(),
    }
}

/// The declared ranges of the shape parameters.
fn shapes(family: &Family) -> String {
    let ranges: Vec<String> = family.shapes.iter().map(|p| family.declared(p)).collect();
    ranges.join(", ")
}

/// A text that may depend on the order; if it does, that of the first one that has any.
fn same(families: &[&Family], text: impl Fn(&Family) -> String) -> String {
    let mut texts = families.iter().map(|family| (family, text(family)));
    let Some((first, first_text)) = texts.find(|(_, text)| !text.is_empty()) else { return String::new() };
    if families.iter().all(|family| text(family) == first_text) {
        first_text
    } else {
        format!("{first_text} (for {})", orders::values(&first.order))
    }
}

/// A duration to three digits at most: `12 µs`, `3.4 ms`, `1.20 s`.
fn time(duration: Duration) -> String {
    let seconds = duration.as_secs_f64();
    match seconds {
        s if s < 999.5e-6 => format!("{:.0} µs", s * 1e6),
        s if s < 9.95e-3 => format!("{:.1} ms", s * 1e3),
        s if s < 0.9995 => format!("{:.0} ms", s * 1e3),
        s if s < 9.995 => format!("{s:.2} s"),
        s => format!("{s:.1} s"),
    }
}

/// The counts of a whole run.
#[derive(Debug, Default)]
pub(crate) struct Summary {
    files: usize,
    unreadable: usize,
    families: usize,
    theorems: usize,
    orders: usize,
    claims: usize,
    proved: usize,
    refuted: usize,
    wrong: usize,
    undecided: usize,
    open: usize,
    errors: usize,
}

impl Summary {
    /// Counts one file.
    pub(crate) fn add(&mut self, outcome: &Outcome) {
        if outcome.readable {
            self.files += 1;
            self.errors +=
                outcome.diagnostics.iter().filter(|d| d.severity == basis_engine::Severity::Error).count();
        } else {
            self.unreadable += 1;
        }
        let subjects = || outcome.items.chunk_by(|a, b| a.subject.is_same(&b.subject));
        let is_family = |items: &&[Decided]| matches!(items[0].subject, Subject::Family(_));
        self.families += subjects().filter(is_family).count();
        self.theorems += subjects().filter(|items| !is_family(items)).count();
        self.orders += outcome.items.iter().filter(|item| is_family(&core::slice::from_ref(item))).count();
        for decided in outcome.items.iter().flat_map(|item| &item.claims) {
            self.claims += 1;
            *match Standing::of(&decided.claim, &decided.verdict) {
                Standing::Proved => &mut self.proved,
                Standing::Refuted => &mut self.refuted,
                Standing::False | Standing::True => &mut self.wrong,
                Standing::Undecided => &mut self.undecided,
                Standing::Open => &mut self.open,
            } += 1;
        }
    }

    /// Counts what another run has counted.
    pub(crate) fn join(&mut self, other: &Self) {
        let Self { files, unreadable, families, theorems, orders, claims, proved, .. } = other;
        let Self { refuted, wrong, undecided, open, errors, .. } = other;
        let sums = [
            (&mut self.files, files),
            (&mut self.unreadable, unreadable),
            (&mut self.families, families),
            (&mut self.theorems, theorems),
            (&mut self.orders, orders),
            (&mut self.claims, claims),
            (&mut self.proved, proved),
            (&mut self.refuted, refuted),
            (&mut self.wrong, wrong),
            (&mut self.undecided, undecided),
            (&mut self.open, open),
            (&mut self.errors, errors),
        ];
        for (sum, more) in sums {
            *sum += more;
        }
    }

    /// The last line; empty when there was nothing to check.
    pub(crate) fn line(&self, elapsed: Duration) -> String {
        if self.files == 0 {
            return String::new();
        }
        let mut families = count(self.families, "family");
        if self.orders > self.families {
            let _ = write!(families, " in {}", count(self.orders, "order"));
        }
        if self.theorems > 0 {
            let theorems = count(self.theorems, "theorem");
            families = if self.families > 0 { format!("{families}, {theorems}") } else { theorems };
        }
        let counted = format!("{}, {families}, {}", count(self.files, "file"), count(self.claims, "claim"));
        let parts = [
            (self.proved, format!("{} proved", self.proved), GOOD),
            (self.refuted, format!("{} refuted as declared", self.refuted), GOOD),
            (self.wrong, format!("{} not as declared", self.wrong), BAD),
            (self.undecided, format!("{} undecided", self.undecided), OPEN),
            (self.open, count(self.open, "open conjecture"), OPEN),
            (self.errors, count(self.errors, "error"), BAD),
            (self.unreadable, format!("{} unreadable", self.unreadable), BAD),
        ];
        let verdicts: Vec<String> =
            parts.into_iter().filter(|(n, ..)| *n > 0).map(|(_, text, style)| styled(style, &text)).collect();
        let verdicts = if verdicts.is_empty() { String::new() } else { format!(": {}", verdicts.join(", ")) };
        format!("{counted}{verdicts}; {}\n", time(elapsed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_have_few_digits() {
        let of = |nanos| time(Duration::from_nanos(nanos));
        assert_eq!([of(400), of(12_300), of(999_400)], ["0 µs", "12 µs", "999 µs"]);
        assert_eq!([of(999_600), of(3_440_000), of(9_960_000)], ["1.0 ms", "3.4 ms", "10 ms"]);
        assert_eq!([of(999_400_000), of(999_600_000), of(12_340_000_000)], ["999 ms", "1.00 s", "12.3 s"]);
    }
}
