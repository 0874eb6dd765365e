//! What is written for nothing: parameters, names and index variables that nothing depends on, claims that are written twice.

use basis_prover::collections::sort::sort;
use proc_macro2::Span;

use super::formula::print::Printer;
use super::words::PI;
use crate::diagnostic::{Diagnostic, Place};
use crate::plural::list;
use crate::syntax::{
    self, Binding, ClaimKind, Condition, Expr, ExprKind, Factor, Generator, Loops, Relation, StatementKind,
};
#[cfg(feature = "joins")]
use crate::syntax::{TheoremKind, TheoremStatementKind};

/// Claims that are written twice are shown up to this number.
const MOST: usize = 10;

/// The warning about `-2 <= λ, μ <= 1` and `a, b > 0`, with which papers say that both lie there: here these are two ranges,
/// each without one of its ends, and any real number `a`.
fn shared_range(decls: &[syntax::ShapeDecl], place: &dyn Fn(Span) -> Place) -> Option<Diagnostic> {
    let text = |part: &Expr| Printer { constants: &[], component: None }.print(part);
    let named = |part: &Expr| part.named().is_some_and(|n| !PI.contains(&n));
    let sign = |included: &[bool]| if included == [true] { "<=" } else { "<" };
    // A range with one end: what stands before and behind a name in its place, and that name.
    let one_end = |d: &syntax::ShapeDecl| match &d.parts[..] {
        [low, own] if !named(low) && named(own) => {
            Some((format!("{} {} ", text(low), sign(&d.included)), String::new(), text(own)))
        }
        [own, high] if named(own) && !named(high) => {
            Some((String::new(), format!(" {} {}", sign(&d.included), text(high)), text(own)))
        }
        _ => None,
    };
    let lone = |d: &syntax::ShapeDecl| matches!(&d.parts[..], [own] if named(own));
    let start = decls.iter().position(|d| lone(d) || one_end(d).is_some())?;
    let run = decls[start..].iter().take_while(|d| lone(d) || one_end(d).is_some()).count();
    let run = &decls[start..start + run];
    let ends: Vec<_> = run.iter().filter_map(one_end).collect();
    let low = ends.first().map(|(low, ..)| low.clone()).filter(|_| one_end(&run[0]).is_some());
    let (low, high) = match (low, ends.last()) {
        // `-2 <= λ, μ <= 1`
        (Some(low), Some((_, high, _))) if ends.len() == 2 && !low.is_empty() && !high.is_empty() => {
            (low, high.clone())
        }
        // `0 < a, b`, `a, b > 0`, but not `a > 0, b`
        (_, Some((low, high, _))) if ends.len() == 1 && run.len() > 1 => {
            // Whether the end stands before the name.
            let begins = |d: &syntax::ShapeDecl| {
                let own = d.parts.iter().find(|p| named(p))?;
                let end = d.parts.iter().find(|p| !named(p))?;
                Some(end.span.start() < own.span.start())
            };
            let is_shared = begins(&run[0]) == Some(true) || begins(run.last()?) == Some(false);
            if !is_shared {
                return None;
            }
            (low.clone(), high.clone())
        }
        _ => return None,
    };
    let names: Vec<String> = run.iter().filter_map(|d| d.parts.iter().find(|p| named(p)).map(text)).collect();
    let ranges: Vec<String> = names.iter().map(|own| format!("{low}{own}{high}")).collect();
    let quoted: Vec<String> = names.iter().map(|own| format!("`{own}`")).collect();
    let message = format!("{} share no range: each has the ends that stand beside it", list(&quoted));
    let help = format!(
        "write `{}` if all of them lie there, a statement for each of them if they do not",
        ranges.join(", ")
    );
    let own = run[0].parts.iter().find(|p| named(p)).map_or_else(Span::call_site, |p| p.span);
    Some(Diagnostic::error(place(own), message).warning().help(help))
}

/// The warnings about a family without errors.
pub(super) fn warnings(written: &syntax::Family, place: &dyn Fn(Span) -> Place) -> Vec<Diagnostic> {
    let mut all = Vec::new();
    let mut used: Vec<&str> = Vec::new();
    let mut declared: Vec<(&str, Span)> = Vec::new();
    let given = written.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Let(def) => Some(def.name.text.as_str()),
        _ => None,
    });
    let given: Vec<&str> = given.collect();
    for statement in &written.statements {
        match &statement.kind {
            StatementKind::Shape(decls) => {
                all.extend(shared_range(decls, place));
                for decl in decls {
                    in_loops(&decl.loops, &mut used);
                    for part in &decl.parts {
                        // Beside another name π is the number, and a name that `let` gives is its value.
                        let is_value =
                            |n: &str| PI.contains(&n) && decl.names().len() > 1 || given.contains(&n);
                        match part.named().filter(|n| !is_value(n)) {
                            Some(known) if declared.iter().all(|(other, _)| *other != known) => {
                                declared.push((known, part.span));
                                if let ExprKind::Index(_, indices) = &part.kind {
                                    for index in indices {
                                        names(index, &mut used);
                                    }
                                }
                            }
                            _ => names(part, &mut used),
                        }
                    }
                }
            }
            StatementKind::Domain(decls) => {
                for limit in decls.iter().flat_map(|d| d.low.iter().chain(&d.high)) {
                    names(&limit.value, &mut used);
                }
            }
            StatementKind::Product(factors) => {
                let ranges = factors.iter().filter_map(Factor::range);
                for limit in ranges.flat_map(|d| d.low.iter().chain(&d.high)) {
                    names(&limit.value, &mut used);
                }
            }
            StatementKind::Assume(relation) => in_relation(relation, &mut used),
            StatementKind::Let(def) => names(&def.value, &mut used),
            StatementKind::Function(def) | StatementKind::Raise(def) => in_function(def, &mut used),
            StatementKind::Base(order, functions) => {
                used.push(&order.name.text);
                for def in functions {
                    in_function(def, &mut used);
                }
            }
            StatementKind::Claim(claim) => {
                in_claim(&claim.kind, &mut used);
                in_loops(&claim.loops, &mut used);
            }
            StatementKind::Budget(_) => {}
        }
    }
    used.extend(written.unread.iter().map(String::as_str));
    sort(&mut used);
    for order in &written.orders {
        let name = order.name.text.as_str();
        if used.binary_search(&name).is_err() {
            let message = format!("the index parameter `{name}` is never used");
            let warning = Diagnostic::error(place(order.name.span), message).warning();
            all.push(warning.help("leave it out, or let it run: `b[i] = … for i in 0..=n`"));
        }
    }
    // What is given by `let` has the name, if a parameter and a name were alike that would be an error.
    for (name, span) in declared {
        if used.binary_search(&name).is_err() {
            let warning =
                Diagnostic::error(place(span), format!("the shape parameter `{name}` is never used"));
            all.push(warning.warning().help("leave it out, or use it in a formula"));
        }
    }
    for statement in &written.statements {
        if let StatementKind::Let(def) = &statement.kind
            && used.binary_search(&def.name.text.as_str()).is_err()
        {
            let message = format!("the name `{}` is never used", def.name.text);
            all.push(Diagnostic::error(place(def.name.span), message).warning().help("leave it out"));
        }
        all.extend(idle_loop(written, statement, place));
    }
    let mut claims: Vec<(String, usize)> = Vec::new();
    for (k, statement) in written.statements.iter().enumerate() {
        if let StatementKind::Claim(claim) = &statement.kind {
            let spaceless: String = claim.text.chars().filter(|c| !c.is_whitespace()).collect();
            claims.push((format!("{} {spaceless}", claim.expected.keyword()), k));
        }
    }
    sort(&mut claims);
    // Each with the first of its kind, in the order of the text.
    let mut twice: Vec<(usize, usize)> = Vec::new();
    for same in claims.chunk_by(|(a, _), (b, _)| a == b) {
        twice.extend(same[1..].iter().map(|(_, k)| (*k, same[0].1)));
    }
    sort(&mut twice);
    for (again, first) in twice.into_iter().take(MOST) {
        let at = |k: usize| place(written.statements[k].span);
        let warning = Diagnostic::error(at(again), "the claim is written twice");
        let warning = warning.label("written again here").also(at(first), "first written here");
        all.push(warning.warning().help("leave one of them out"));
    }
    all
}

/// The warnings about claims that are made for no order and no index, given the numbers of the statements that make some.
pub(super) fn never_made(
    written: &syntax::Family,
    made: &[usize],
    place: &dyn Fn(Span) -> Place,
) -> Vec<Diagnostic> {
    let idle = written.statements.iter().enumerate().filter(|(number, statement)| {
        matches!(&statement.kind, StatementKind::Claim(_)) && !made.contains(number)
    });
    let warning = |(_, statement): (usize, &syntax::Statement)| {
        let warning = Diagnostic::error(
            place(statement.span),
            "nothing is claimed: no order and no index fits what stands behind `for` or `if`",
        );
        warning.warning().help("widen it, or leave the claim out")
    };
    idle.map(warning).collect()
}

/// The warning about an index variable of a claim that does not occur in it, or that hides an index parameter.
fn idle_loop(
    written: &syntax::Family,
    statement: &syntax::Statement,
    place: &dyn Fn(Span) -> Place,
) -> Option<Diagnostic> {
    let mut used = Vec::new();
    let (loops, is_claim) = match &statement.kind {
        StatementKind::Claim(claim) => {
            in_claim(&claim.kind, &mut used);
            let own = match &claim.kind {
                ClaimKind::Relation(relation) if !relation.loops.generators.is_empty() => &relation.loops,
                _ => &claim.loops,
            };
            in_loops(own, &mut used);
            (own, true)
        }
        StatementKind::Function(def) | StatementKind::Raise(def) => (&def.loops, false),
        _ => return None,
    };
    loops.generators.iter().find_map(|generator| {
        let Generator::Range(range) = generator else { return None };
        let name = &range.name.text;
        // That a variable is no index is an error already.
        if is_claim && !is_variable(written, name) && !used.contains(&name.as_str()) {
            let message = format!("the index variable `{name}` does not occur in the claim");
            let help = format!("write `b[{name}]` for each of the functions, or leave the loop out");
            return Some(Diagnostic::error(place(range.name.span), message).warning().help(help));
        }
        written.orders.iter().any(|order| order.name.text == *name).then(|| {
            let message = format!("the index variable hides the index parameter `{name}`");
            Diagnostic::error(place(range.name.span), message).warning().help("choose another name")
        })
    })
}

/// Whether a name is that of a domain variable or of a shape parameter.
fn is_variable(written: &syntax::Family, name: &str) -> bool {
    written.statements.iter().any(|statement| match &statement.kind {
        StatementKind::Domain(decls) => decls.iter().any(|decl| decl.name.text == name),
        StatementKind::Product(factors) => {
            factors.iter().any(|factor| factor.names().iter().any(|own| own.text == name))
        }
        StatementKind::Shape(decls) => {
            decls.iter().any(|decl| decl.parts.iter().any(|part| part.named() == Some(name)))
        }
        _ => false,
    })
}

/// The warnings about scalars of a theorem that nothing depends on, and about control points of curves that there are not.
#[cfg(feature = "joins")]
pub(super) fn of_theorem(written: &syntax::Theorem, place: &dyn Fn(Span) -> Place) -> Vec<Diagnostic> {
    let mut used: Vec<&str> = Vec::new();
    let (mut scalars, mut patches) = (Vec::new(), Vec::new());
    // Names with an index, `R` of `let R[0] = …;`.
    let mut indexed: Vec<(&str, Span)> = Vec::new();
    for statement in &written.statements {
        if let TheoremStatementKind::Patch(_, name, _) = &statement.kind {
            patches.push(name.text.as_str());
        }
        match &statement.kind {
            TheoremStatementKind::Scalar(bounds, loops) => {
                in_loops(loops, &mut used);
                for limit in bounds.low.iter().chain(&bounds.high) {
                    names(&limit.value, &mut used);
                }
                if let ExprKind::Name(name) = &bounds.target.kind {
                    scalars.push((name.as_str(), bounds.target.span));
                }
            }
            TheoremStatementKind::Patch(_, _, value)
            | TheoremStatementKind::Dimension(value)
            | TheoremStatementKind::Budget(value) => names(value, &mut used),
            TheoremStatementKind::Assume(relation) => in_relation(relation, &mut used),
            TheoremStatementKind::Let(target, value, loops) => {
                if let ExprKind::Index(base, _) = &target.kind
                    && let ExprKind::Name(name) = &base.kind
                {
                    indexed.push((name, base.span));
                }
                names(target, &mut used);
                names(value, &mut used);
                in_loops(loops, &mut used);
            }
            TheoremStatementKind::Claim(claim) => {
                names(&claim.left, &mut used);
                names(&claim.right, &mut used);
                in_loops(&claim.loops, &mut used);
            }
        }
    }
    sort(&mut used);
    let idle = scalars.into_iter().filter(|(name, _)| used.binary_search(name).is_err());
    let warning = |(name, span): (&str, Span)| {
        let message = format!("the scalar `{name}` is never used");
        Diagnostic::error(place(span), message).warning().help("leave it out, or use it in a claim")
    };
    let mut all: Vec<Diagnostic> = idle.map(warning).collect();
    // In a join this is an error.
    for (k, (name, span)) in indexed.iter().enumerate().filter(|_| written.kind == TheoremKind::Theorem) {
        let given = indexed.iter().filter(|(other, _)| other == name).count();
        let mentioned = used.iter().filter(|other| *other == name).count();
        let is_first = indexed[..k].iter().all(|(other, _)| other != name);
        if is_first && mentioned == given && !patches.contains(name) {
            let message = format!("there is no curve or surface `{name}`, and nothing else uses this name");
            let help = format!(
                "declare the curve, `curve {name} = …;`, whose control point this is, or leave it out"
            );
            all.push(Diagnostic::error(place(*span), message).warning().help(help));
        }
    }
    all
}

/// Adds the names in an expression.
fn names<'e>(expr: &'e Expr, used: &mut Vec<&'e str>) {
    match &expr.kind {
        ExprKind::Name(name) => used.push(name),
        ExprKind::Each(_, loops) => in_loops(loops, used),
        _ => {}
    }
    for part in expr.parts() {
        names(part, used);
    }
}

fn in_function<'e>(def: &'e syntax::FunctionDef, used: &mut Vec<&'e str>) {
    for part in def.indices.iter().chain([&def.value]).chain(&def.further) {
        names(part, used);
    }
    in_loops(&def.loops, used);
}

fn in_loops<'e>(loops: &'e Loops, used: &mut Vec<&'e str>) {
    for generator in &loops.generators {
        match generator {
            Generator::Range(range) => {
                names(&range.low, used);
                names(&range.high, used);
            }
            Generator::Simplex(_, sum) => names(sum, used),
        }
    }
    if let Some(condition) = &loops.condition {
        in_condition(condition, used);
    }
}

fn in_condition<'e>(condition: &'e Condition, used: &mut Vec<&'e str>) {
    match condition {
        Condition::Compare(a, _, b) => {
            names(a, used);
            names(b, used);
        }
        Condition::All(parts) | Condition::Any(parts) => {
            for part in parts {
                in_condition(part, used);
            }
        }
        Condition::Not(inner) => in_condition(inner, used),
    }
}

fn in_relation<'e>(relation: &'e Relation, used: &mut Vec<&'e str>) {
    names(&relation.left, used);
    names(&relation.right, used);
    for (_, side) in &relation.chain {
        names(side, used);
    }
    in_loops(&relation.loops, used);
}

fn in_bindings<'e>(bindings: &'e [Binding], used: &mut Vec<&'e str>) {
    for binding in bindings {
        used.push(&binding.name.text);
        names(&binding.value, used);
    }
}

fn in_claim<'e>(claim: &'e ClaimKind, used: &mut Vec<&'e str>) {
    match claim {
        ClaimKind::Independent(exceptions) => {
            for e in exceptions {
                in_bindings(e, used);
            }
        }
        ClaimKind::Continuity(order, next) => {
            names(order, used);
            in_bindings(next, used);
        }
        ClaimKind::Smooth(order) | ClaimKind::Rounding(order) => names(order, used),
        ClaimKind::Relation(relation) => in_relation(relation, used),
        ClaimKind::At(bindings, relations) => {
            in_bindings(bindings, used);
            for relation in relations {
                in_relation(relation, used);
            }
        }
        _ => {}
    }
}
