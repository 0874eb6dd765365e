//! `basis table`: the families of spec files with what is known of them, as a table in Markdown.

use std::collections::BTreeMap;

use basis_engine::claim::Expected;
use basis_engine::{ClaimKind, Family, Subject, Verdict};
use basis_kernel::Values;

use crate::args::TableArguments;
use crate::check::prove::{self, Decided};
use crate::check::{files, orders};
use crate::domain;
use crate::output::{self, Status};

const HEADER: &str = "\
| family | domain, shape parameters | sum 1 | ≥ 0 | symmetric | independent | joins | other claims |
| --- | --- | --- | --- | --- | --- | --- | --- |
";

/// Prints the table of everything that the arguments name.
pub(crate) fn run(arguments: &TableArguments) -> Status {
    let mut status = Status::Fine;
    let mut text = String::from(HEADER);
    for entry in files::find(&arguments.paths) {
        let outcome = prove::file(entry, prove::Formal::Left);
        status = status.max(outcome.status());
        for problem in outcome.all_diagnostics() {
            output::complain(&(problem.render(&outcome.sources, true) + "\n\n"));
        }
        for items in outcome.items.chunk_by(|a, b| a.subject.is_same(&b.subject)) {
            if let Some(row) = row(&outcome.path, items) {
                text += &row;
            }
        }
    }
    status.max(output::print(&text))
}

/// The row of a family, whose orders are `items`; `None` for a theorem.
fn row(path: &str, items: &[Decided]) -> Option<String> {
    let families: Vec<&Family> = items
        .iter()
        .filter_map(|item| match &item.subject {
            Subject::Family(family) => Some(&**family),
            Subject::Theorem(_) => None,
        })
        .collect();
    let family = families.first()?;
    let orders = orders::describe(families.iter().map(|f| f.order.as_slice()));
    let orders = if orders.is_empty() { orders } else { format!(", {orders}") };
    let ranges = |family: &Family| {
        let mut parts = vec![domain::describe(family)];
        parts.extend(family.shapes.iter().map(|shape| family.declared(shape)));
        parts.extend(domain::assumptions(family).iter().map(|text| format!("assume {text}")));
        parts.iter().map(|part| format!("`{part}`")).collect::<Vec<_>>().join(", ")
    };
    let mut domain = ranges(family);
    if families.iter().any(|other| ranges(other) != domain) {
        domain += &format!(" for {}", orders::values(&family.order));
    }
    let cells = [
        format!("[{}]({path}){orders}", family.name),
        domain,
        cell(items, |item| known(item, |kind| matches!(kind, ClaimKind::PartitionOfUnity))),
        cell(items, |item| known(item, |kind| matches!(kind, ClaimKind::Nonnegative))),
        cell(items, |item| known(item, |kind| matches!(kind, ClaimKind::Symmetric))),
        cell(items, independent),
        joins(items),
        others(items),
    ];
    Some(format!("| {} |\n", cells.map(|cell| cell.replace('|', "\\|")).join(" | ")))
}

/// ✓ for a claim that is proved, ✗ for one that is refuted.
fn known(item: &Decided, is: impl Fn(&ClaimKind) -> bool) -> Option<String> {
    let claim = item.claims.iter().find(|c| is(c.claim.kind.on_a_span()))?;
    Some(String::from(match claim.verdict {
        Verdict::Proved(_) => "✓",
        Verdict::Refuted(_) => "✗",
        Verdict::Undecided(_) => "?",
    }))
}

/// Independent, or independent but for some shape values.
fn independent(item: &Decided) -> Option<String> {
    let except = item.claims.iter().find_map(|c| match &c.claim.kind {
        ClaimKind::Independent(except) if !except.is_empty() && matches!(c.verdict, Verdict::Proved(_)) => {
            let Subject::Family(family) = &item.subject else { return None };
            let one = |values: &Values| {
                let parts: Vec<String> = values.iter().map(|(v, x)| family.shape_value(*v, x)).collect();
                if parts.len() == 1 { parts.concat() } else { format!("({})", parts.join(", ")) }
            };
            let all: Vec<String> = except.iter().map(one).collect();
            Some(format!("✓ except `{}`", all.join(", ")))
        }
        _ => None,
    });
    except.or_else(|| known(item, |kind| matches!(kind, ClaimKind::Independent(e) if e.is_empty())))
}

/// A cell of the table: one verdict for all orders, or each verdict with its orders.
fn cell(items: &[Decided], known: impl Fn(&Decided) -> Option<String>) -> String {
    let mut groups: Vec<(Option<String>, Vec<&Decided>)> = Vec::new();
    for item in items {
        let known = known(item);
        match groups.iter_mut().find(|(k, _)| *k == known) {
            Some((_, group)) => group.push(item),
            None => groups.push((known, vec![item])),
        }
    }
    if let [(known, _)] = groups.as_slice() {
        return known.clone().unwrap_or_default();
    }
    let part = |(known, group): (Option<String>, Vec<&Decided>)| {
        let orders = orders::describe(group.iter().map(|item| item.subject.order()));
        known.map(|known| format!("{known} for {orders}"))
    };
    groups.into_iter().filter_map(part).collect::<Vec<_>>().join("; ")
}

/// How smoothly neighbouring segments join: the highest order of continuity that is proved.
fn joins(items: &[Decided]) -> String {
    let order = |item: &Decided| {
        let proved = item.claims.iter().filter(|c| matches!(c.verdict, Verdict::Proved(_)));
        proved
            .filter_map(|c| match c.claim.kind {
                ClaimKind::Continuity(ref joint) if joint.next.is_empty() => Some(joint.order),
                _ => None,
            })
            .max()
    };
    let all: Vec<u32> = items.iter().filter_map(order).collect();
    match (all.iter().min(), all.iter().max()) {
        (Some(low), Some(high)) if low == high => format!("C{low}"),
        (Some(low), Some(high)) => format!("C{low} to C{high}"),
        _ => String::new(),
    }
}

/// The numbers of proved and of refuted claims that are not properties, all orders together.
fn others(items: &[Decided]) -> String {
    let other = |kind: &ClaimKind| matches!(kind, ClaimKind::Relation { .. });
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for claim in items.iter().flat_map(|item| &item.claims).filter(|c| other(c.claim.kind.on_a_span())) {
        let verdict = match claim.verdict {
            Verdict::Proved(_) => "proved",
            Verdict::Refuted(_) => "refuted",
            Verdict::Undecided(_) if claim.claim.expected == Expected::Open => "open",
            Verdict::Undecided(_) => "undecided",
        };
        *counts.entry(verdict).or_default() += 1;
    }
    let parts: Vec<String> = counts.iter().map(|(verdict, count)| format!("{count} {verdict}")).collect();
    parts.join(", ")
}
