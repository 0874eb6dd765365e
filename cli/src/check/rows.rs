//! From the claims of a family in all its orders to few rows: claims of one statement stand in one row where
//! their verdicts agree.

use std::fmt::Write as _;
use std::time::Duration;

use basis_engine::state::{FEW, Part, Standing};
use basis_engine::{Verdict, Witness};

use super::orders;
use super::prove::{Decided, DecidedClaim};
use super::statements::{Entry, parts};

/// Nets with more points are not printed in tables.
const MAX_POINTS: usize = 8;

/// Sums of more terms are shortened in tables.
const MAX_TERMS: usize = 6;

/// A row: claims of one statement with one verdict.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Row {
    /// The claim, with the orders and the number of claims that the row stands for.
    pub(crate) claim: String,
    /// The verdict, beside what is declared.
    pub(crate) standing: Standing,
    /// The method of the proof, the counterexample, or what is left to decide.
    pub(crate) reason: String,
    /// The longest time that one claim took.
    pub(crate) worst: Duration,
    /// The time of all.
    pub(crate) total: Duration,
}

/// The rows of a family, whose orders are `items`.
pub(crate) fn rows(items: &[Decided]) -> Vec<Row> {
    let mut rows = Vec::new();
    for (Part { standing, text, range, .. }, part) in parts(items) {
        if items.len() == 1 && part.len() <= FEW {
            let each = |e: &Entry<'_>| row(standing, e.decided.claim.text.clone(), reason(e.decided), &[*e]);
            rows.extend(part.iter().map(each));
        } else {
            let statement = if range.is_empty() { text } else { format!("{text} {range}") };
            let claim = describe(items, &statement, &part);
            rows.push(row(standing, claim, reasons(items, &part), &part));
        }
    }
    rows
}

fn row(standing: Standing, claim: String, reason: String, part: &[Entry<'_>]) -> Row {
    let times = part.iter().map(|e| e.decided.time);
    Row { claim, standing, reason, worst: times.clone().max().unwrap_or_default(), total: times.sum() }
}

/// The text of a statement, with the orders for which a part of its claims stands, if not for all.
fn describe(items: &[Decided], text: &str, part: &[Entry<'_>]) -> String {
    let mut text = String::from(text);
    let mut facts = Vec::new();
    // The claims of one order are neighbours.
    let orders = part.chunk_by(|a, b| a.item.subject.order() == b.item.subject.order());
    let orders: Vec<&[(String, i64)]> = orders.map(|chunk| chunk[0].item.subject.order()).collect();
    if orders.len() < items.len() {
        facts.push(orders::describe(orders.iter().copied()));
    }
    if part.len() > orders.len() {
        facts.push(crate::name::count(part.len(), "claim"));
    }
    if !facts.is_empty() {
        let _ = write!(text, "  [{}]", facts.join("; "));
    }
    text
}

/// Why the verdict is what it is.
fn reason(decided: &DecidedClaim) -> String {
    match &decided.verdict {
        Verdict::Proved(evidence) => evidence.method().to_string(),
        Verdict::Refuted(witness) => {
            let point = short_point(witness);
            let place = if point.is_empty() { String::new() } else { format!(" at {point}") };
            format!("{} = {}{place}", short_sum(&witness.of), witness.value_text())
        }
        Verdict::Undecided(left) => left.clone(),
    }
}

/// A sum of many terms by its first two and its last; the JSON output has them all.
fn short_sum(formula: &str) -> String {
    // Where the terms after the first begin, with their signs.
    let (mut starts, mut depth) = (Vec::new(), 0);
    for (at, c) in formula.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ' ' if depth == 0 && [" + ", " - "].iter().any(|sign| formula[at..].starts_with(sign)) => {
                starts.push(at);
            }
            _ => {}
        }
    }
    match starts.as_slice() {
        [_, third, .., last] if starts.len() >= MAX_TERMS => {
            format!("{} + …{}", &formula[..*third], &formula[*last..])
        }
        _ => formula.to_string(),
    }
}

/// The point of a counterexample; large nets are left to the JSON output.
fn short_point(witness: &Witness) -> String {
    let points = witness.points().listed.len();
    if points <= MAX_POINTS {
        return witness.point();
    }
    let mut short = witness.clone();
    short.net.clear();
    let more = format!("a net of {}", crate::name::count(points, "point"));
    let mut point = short.point();
    if !point.is_empty() {
        point += ", ";
    }
    point + &more
}

/// The methods of all proofs; of other verdicts the first reason, and the order to which it belongs.
fn reasons(items: &[Decided], part: &[Entry<'_>]) -> String {
    let mut all: Vec<String> = Vec::new();
    for entry in part {
        let reason = reason(entry.decided);
        if !all.contains(&reason) {
            all.push(reason);
        }
    }
    let proved = part.iter().all(|e| matches!(e.decided.verdict, Verdict::Proved(_)));
    match (all.as_slice(), part.first()) {
        ([first, _, ..], Some(entry)) if !proved => {
            if items.len() > 1 && part.len() > 1 {
                format!("{}: {first}", orders::values(entry.item.subject.order()))
            } else {
                format!("{first}, …")
            }
        }
        _ => all.join("; "),
    }
}

#[cfg(test)]
mod tests {
    use super::short_sum;

    #[test]
    fn long_sums_are_shortened() {
        assert_eq!(short_sum("b[0] + b[1] - 1"), "b[0] + b[1] - 1");
        assert_eq!(short_sum("b[0] + b[1] + b[2] + b[3] + b[4] + b[5] - 1"), "b[0] + b[1] + … - 1");
        assert_eq!(short_sum("b[0] - (1 + 2 + 3 + 4 + 5 + 6 + 7)*t"), "b[0] - (1 + 2 + 3 + 4 + 5 + 6 + 7)*t");
    }
}
