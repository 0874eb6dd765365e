//! Chains of ranges such as `0 < q < p <= 1`: which parameters they declare, and where the range of each ends.

use core::ops::ControlFlow;

use basis_kernel::Relation;
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::sort::{sort, sort_by};
use proc_macro2::Span;

use super::{Shapes, constrain};
use crate::algebra::fraction::Fraction;
use crate::algebra::range::{End, Range};
use crate::model::expand::domain::variable;
use crate::model::expand::names::attempt;
use crate::model::formula::numbers::checked_range;
use crate::model::formula::print::Printer;
use crate::model::scope::Scope;
use crate::model::{Parameter, label};
use crate::syntax::{self, Expr, ExprKind, Factor, Generator, Name, ShapeDecl, StatementKind};

/// What stands in a chain of ranges.
enum Part {
    /// A parameter that the chain declares, with its range.
    New(Name),
    /// A number, or an expression in parameters that are declared before.
    Value(Fraction),
}

/// The values of the index variables of a chain; `None` with an error if there are none, or a bound went wrong.
fn rounds(scope: &mut Scope<'_>, decl: &ShapeDecl) -> Option<Vec<Vec<(String, i64)>>> {
    let mut rounds = None;
    let depth = scope.constants.len();
    attempt(scope, &mut |scope| {
        let mut all = Vec::new();
        let fine = scope.each(&decl.loops, &mut |scope| {
            all.push(scope.constants[depth..].to_vec());
            true
        });
        rounds = fine.then_some(all);
        Some(())
    });
    let rounds = rounds?;
    if rounds.is_empty() && scope.constants.is_empty() {
        let span = decl.parts.first().map_or_else(Span::call_site, |part| part.span);
        let error = scope.error(span, "the loop is empty: no shape parameter is declared");
        scope.report(error.help("write the smaller bound first, `1..=n` includes n"));
        return None;
    }
    Some(rounds)
}

/// The chains that one with index variables stands for: names such as `w[0]` in place of indices.
#[cfg(feature = "angles")]
pub(in crate::model::expand) fn without_indices(
    scope: &mut Scope<'_>,
    decl: &ShapeDecl,
) -> Option<Vec<ShapeDecl>> {
    let is_indexed = |e: &Expr| matches!(e.kind, ExprKind::Index(..));
    if decl.loops.generators.is_empty() && !decl.parts.iter().any(is_indexed) {
        return Some(vec![decl.clone()]);
    }
    let mut all = Vec::new();
    for constants in rounds(scope, decl)? {
        let mut one = ShapeDecl { loops: syntax::Loops::default(), ..decl.clone() };
        for part in &mut one.parts {
            *part = part.with_indices(&constants);
            if is_indexed(part)
                && let Some(name) = name_of(scope, part)?
            {
                part.kind = ExprKind::Name(name.text);
            }
        }
        all.push(one);
    }
    Some(all)
}

/// Declares what a chain declares, for all values of its index variables; whether all went well.
pub(super) fn declare(
    scope: &mut Scope<'_>,
    decl: &ShapeDecl,
    doc: &[String],
    others: &Others,
    shapes: &mut Shapes,
) -> bool {
    let depth = scope.constants.len();
    let Some(rounds) = rounds(scope, decl) else { return false };
    if !has_index(scope, decl, &rounds) {
        return false;
    }
    let mut fine = true;
    for constants in rounds {
        scope.constants.extend(constants);
        let done = one(scope, decl, doc, others, shapes);
        scope.constants.truncate(depth);
        fine &= done.is_some();
        if !fine {
            break;
        }
    }
    fine
}

/// Whether a loop has parameters with an index to declare; if not, that is reported, and names such as `λ_1` are no
/// other mistakes.
fn has_index(scope: &Scope<'_>, decl: &ShapeDecl, rounds: &[Vec<(String, i64)>]) -> bool {
    let is_indexed = |e: &Expr| matches!(e.kind, ExprKind::Index(..));
    let Some(generator) = decl.loops.generators.first() else { return true };
    let named = decl.parts.iter().find_map(|part| Some((part.named()?, part.span)));
    let Some((name, span)) = named.filter(|_| !decl.parts.iter().any(is_indexed)) else { return true };
    let index = match generator {
        Generator::Range(range) => &range.name.text,
        Generator::Simplex(names, _) => names.first().map_or("i", |name| &name.text),
    };
    let list = name.strip_suffix(index).map_or(name, |list| list.trim_end_matches('_'));
    let error =
        scope.error(span, format!("`{name}` has no index, and one declaration for all values of `{index}`"));
    scope.report(error.help(format!("write `{list}[{index}]`")));
    let values = rounds.iter().filter_map(|constants| constants.iter().find(|(name, _)| name == index));
    let names = values.flat_map(|(_, k)| [format!("{list}_{k}"), format!("{list}{k}")]);
    scope.undeclared.borrow_mut().extend(names);
    false
}

/// A chain with fixed values of its index variables.
fn one(
    scope: &mut Scope<'_>,
    decl: &ShapeDecl,
    doc: &[String],
    others: &Others,
    shapes: &mut Shapes,
) -> Option<()> {
    let mut parts = Vec::new();
    // What is declared twice says more than a value that has no meaning.
    let mut found = Vec::new();
    for k in 0..decl.parts.len() {
        found.push(match target(scope, decl, k, others) {
            ControlFlow::Break(name) => Some(name?),
            ControlFlow::Continue(()) => None,
        });
    }
    for (part, name) in decl.parts.iter().zip(found) {
        parts.push(match name {
            Some(name) => Part::New(name),
            None => Part::Value(attempt(scope, &mut |scope| scope.scalar(part))?),
        });
    }
    let is_new = |part: &Part| matches!(part, Part::New(_));
    if !parts.iter().any(is_new) {
        let part = decl.parts.iter().find(|part| part.named().is_some()).unwrap_or(&decl.parts[0]);
        let error = scope.error(part.span, "the chain declares no shape parameter");
        scope.report(error.help("write `assume …;` for what is assumed of parameters that are declared"));
        return None;
    }
    for pair in parts.windows(2) {
        if let [Part::Value(a), Part::Value(b)] = pair
            && a.as_constant().is_some()
            && b.as_constant().is_some()
        {
            let error = scope.error(decl.parts[0].span, "a range has at most two ends");
            scope.report(
                error.help("write a range such as `-3 <= λ <= 1`, or a chain such as `0 < q < p <= 1`"),
            );
            return None;
        }
    }
    let printer = Printer { constants: &scope.constants, component: None };
    let texts = decl.parts.mapped(|part| printer.print(part));
    let mut found = vec![None; parts.len()];
    for k in in_order(&parts) {
        found[k] = Some(match &parts[k] {
            Part::Value(value) => value.clone(),
            Part::New(name) => {
                let range = Range {
                    low: hull(&parts, decl, k, false, shapes),
                    high: hull(&parts, decl, k, true, shapes),
                };
                let crossing =
                    if range.is_empty() { crossing(&parts, k, &range, shapes, &texts) } else { None };
                let range = match (range.finite(), crossing) {
                    // Of a chain, `2 < q < p <= 1`, the ends stand in one line.
                    (Some((a, b)), _) if a > b && parts.len() > 3 => {
                        let error = scope.error(name.span, format!("the range of `{}` is empty", name.text));
                        let label = format!("{a} is above {b}");
                        scope.report(
                            error.label(label).help("write the chain from the smallest to the greatest"),
                        );
                        None
                    }
                    (Some(_), Some(label)) => {
                        let error = scope.error(name.span, format!("the range of `{}` is empty", name.text));
                        scope.report(
                            error.label(label).help("choose ends between which there are values, here or where the other parameter is declared"),
                        );
                        None
                    }
                    _ => checked_range(scope, name.span, range, &|| name.text.clone()),
                };
                let var = variable(scope, name);
                let (range, var) = (range?, var?);
                let (name, place, doc) = (name.text.clone(), scope.place(name.span), doc.to_vec());
                shapes.parameters.push(Parameter { name, doc, place, var, range });
                Fraction::var(var)
            }
        });
    }
    let values: Vec<Fraction> = found.into_iter().flatten().listed();
    for k in 1..parts.len() {
        let (a, b) = (&parts[k - 1], &parts[k]);
        // A number beside a new name is the end of its range.
        let number = |part: &Part| matches!(part, Part::Value(value) if value.as_constant().is_some());
        if number(a) && is_new(b) || is_new(a) && number(b) {
            continue;
        }
        let sign = if decl.included[k - 1] { "<=" } else { "<" };
        let text = format!("{} {sign} {}", texts[k - 1], texts[k]);
        let span = if is_new(b) { decl.parts[k - 1].span } else { decl.parts[k].span };
        let relation = if decl.included[k - 1] { Relation::NonNegative } else { Relation::Positive };
        constrain(scope, &(&values[k] - &values[k - 1]), relation, text, span, shapes)?;
    }
    Some(())
}

/// The places of a chain: the parameters of one list in the order of their indices, which is that of their values everywhere.
fn in_order(parts: &[Part]) -> Vec<usize> {
    let entry = |part: &'_ Part| {
        let Part::New(name) = part else { return None };
        let (list, index) = name.text.strip_suffix(']')?.split_once('[')?;
        let index = index.split(',').map(str::parse::<i64>).collect::<Result<Vec<_>, _>>().ok()?;
        Some((String::from(list), index))
    };
    let placed = |(place, part)| entry(part).map(|(list, index)| (list, index, place));
    let mut entries: Vec<(String, Vec<i64>, usize)> = parts.iter().enumerate().filter_map(placed).listed();
    sort_by(&mut entries, |(a, _, p), (b, _, q)| (a, p).cmp(&(b, q)));
    let places = entries.mapped(|(.., place)| *place);
    sort(&mut entries);
    let mut order = (0..parts.len()).listed();
    for (place, (.., own)) in places.into_iter().zip(entries) {
        order[place] = own;
    }
    order
}

/// The number at which the range of the part at a place ends, as far as that is known from its chain.
fn hull(parts: &[Part], decl: &ShapeDecl, at: usize, above: bool, shapes: &Shapes) -> End {
    let mut strict = false;
    let mut found = End::Infinite;
    let mut k = at;
    loop {
        let next = if above { (k + 1 < parts.len()).then_some(k + 1) } else { k.checked_sub(1) };
        let Some(next) = next else { return found };
        strict |= !decl.included[k.min(next)];
        k = next;
        let Part::Value(value) = &parts[k] else { continue };
        let own = match (value.as_constant(), value.as_var()) {
            (Some(c), _) => Some((c, strict)),
            (None, Some(var)) => {
                let range = shapes.parameters.iter().find(|p| p.var == var).map(|p| &p.range);
                let end = range.map(|range| if above { &range.high } else { &range.low });
                end.and_then(|end| Some((end.value()?.clone(), strict || !end.is_included())))
            }
            _ => None,
        };
        let Some((value, strict)) = own else { continue };
        let better = match found.value() {
            None => true,
            Some(known) if *known == value => strict,
            Some(known) => (value < *known) == above,
        };
        if better {
            found = if strict { End::Excluded(value) } else { End::Included(value) };
        }
    }
}

/// Why no values lie between the ends of a range, where another parameter is one of them.
fn crossing(parts: &[Part], at: usize, range: &Range, shapes: &Shapes, texts: &[String]) -> Option<String> {
    // The part that is the end on one side, as text, and whether it is a parameter.
    let by = |above: bool| {
        let end = if above { &range.high } else { &range.low };
        let number = end.value()?;
        let mut beyond: Vec<usize> = if above { (at + 1..parts.len()).listed() } else { (0..at).listed() };
        if !above {
            beyond.reverse();
        }
        beyond.into_iter().find_map(|k| {
            let Part::Value(value) = &parts[k] else { return None };
            let Some(var) = value.as_var() else {
                return (value.as_constant().as_ref() == Some(number)).then(|| (number.to_string(), false));
            };
            let own = shapes.parameters.iter().find(|p| p.var == var).map(|p| &p.range)?;
            let own = if above { &own.high } else { &own.low };
            if own.value() != Some(number) {
                return None;
            }
            let bound = match (above, own.is_included()) {
                (true, true) => "at most",
                (true, false) => "below",
                (false, true) => "at least",
                (false, false) => "above",
            };
            Some((format!("`{}`, which is {bound} {number}", texts[k]), true))
        })
    };
    let ((low, by_low), (high, by_high)) = (by(false)?, by(true)?);
    let is = if range.low.value() > range.high.value() { "is above" } else { "is not below" };
    let comma = if by_low { "," } else { "" };
    (by_low || by_high).then(|| format!("its low end {low}{comma} {is} {high}"))
}

/// Of `λ[2]` what stands before the bracket.
fn base(name: &str) -> &str {
    name.split('[').next().unwrap_or_default()
}

/// The name that an expression is, indices as numbers; `None` when one of them is no number, `Some(None)` for anything
/// but a name.
#[allow(clippy::option_option)] // what went wrong is reported, and what is no name is a value
fn name_of(scope: &mut Scope<'_>, expr: &Expr) -> Option<Option<Name>> {
    match &expr.kind {
        ExprKind::Name(text) => Some(Some(Name { text: text.clone(), span: expr.span })),
        ExprKind::Index(base, indices) => {
            let ExprKind::Name(name) = &base.kind else { return Some(None) };
            let mut index = Vec::new();
            for i in indices {
                index.push(attempt(scope, &mut |scope| scope.whole(i, "the index of a shape parameter"))?);
            }
            if index.iter().any(|i| *i < 0) {
                let error =
                    scope.error(expr.span, format!("the index of `{}` is negative", label(name, &index)));
                scope.report(
                    error.help(
                        "let the loop begin later, or give that end of the range a statement of its own",
                    ),
                );
                return None;
            }
            Some(Some(Name { text: label(name, &index), span: expr.span }))
        }
        _ => Some(None),
    }
}

/// The place in a chain of the name whose range it is; `None` in a chain that may declare several.
fn primary(decl: &ShapeDecl) -> Option<usize> {
    match &decl.parts[..] {
        [_] => Some(0),
        [a, b] => match (a.named().is_some(), b.named().is_some()) {
            (true, false) => Some(0),
            (false, true) => Some(1),
            _ => None,
        },
        [a, b, c] if b.named().is_some() && !(a.named().is_some() && c.named().is_some()) => Some(1),
        _ => None,
    }
}

/// Words for the end of a range that has none.
const INFINITE: [&str; 5] = ["inf", "infty", "infinity", "Infinity", "oo"];

/// Whether a part of a chain is a parameter that is declared here, and its name; `None` in place of it where that is
/// reported.
fn target(scope: &mut Scope<'_>, decl: &ShapeDecl, k: usize, others: &Others) -> ControlFlow<Option<Name>> {
    let Some(name) = name_of(scope, &decl.parts[k]) else { return ControlFlow::Break(None) };
    let Some(name) = name else { return ControlFlow::Continue(()) };
    let first = base(&name.text);
    let indexed = first.len() < name.text.len();
    let free = |scope: &Scope<'_>| {
        let scalar = if indexed { scope.variable(first).is_some() } else { scope.taken(first).is_some() };
        scope.variable(&name.text).is_none() && !scalar
    };
    let is_end = (k == 0 || k + 1 == decl.parts.len()) && primary(decl) != Some(k);
    if is_end
        && INFINITE.contains(&name.text.as_str())
        && scope.taken(first).is_none()
        && scope.planned.named(first).is_none()
    {
        let error = scope.error(name.span, format!("`{}` is no number", name.text));
        scope.report(error.help("leave the end of the range out: `0 < λ` has no upper end"));
        return ControlFlow::Break(None);
    }
    // In `0 <= μ[i] <= μ[i + 1] for i in 1..n` the step before has declared the first name, and this one the next.
    let goes_on = indexed
        && scope.variable(&name.text).is_some()
        && decl.parts[k + 1..].iter().any(|part| part.named().is_some());
    if primary(decl) == Some(k) && !goes_on {
        if others.doubled.contains(&name.text) {
            let error = scope.error(name.span, format!("`{}` is already a domain variable", name.text));
            scope.undeclared.borrow_mut().push(name.text.clone());
            scope.report(error.label("declared again here").help("choose another name"));
            return ControlFlow::Break(None);
        }
        if free(scope) {
            return ControlFlow::Break(Some(name));
        }
        let known = if scope.variable(&name.text).is_some() { name.text.clone() } else { first.to_string() };
        scope.check_free(&Name { text: known, span: name.span });
        return ControlFlow::Break(None);
    }
    if scope.planned.named(first).is_some() || scope.constant(first).is_some() || !free(scope) {
        return ControlFlow::Continue(());
    }
    let what = if others.domain.iter().any(|n| n == first) {
        "is a domain variable"
    } else if others.later.iter().any(|n| n == first) {
        "is declared further below"
    } else {
        return ControlFlow::Break(Some(name));
    };
    let error = scope.error(name.span, format!("`{first}` {what}"));
    let chain = if what.starts_with("is declared") {
        "; one chain declares several, `shape 0 <= λ <= μ <= 1;`"
    } else {
        ""
    };
    let help = "ranges depend on numbers and on shape parameters that are declared before";
    scope.report(error.help(format!("{help}{chain}")));
    ControlFlow::Break(None)
}

/// Names that have a meaning in other statements of the family.
pub(super) struct Others {
    /// Of the domain variables.
    domain: Vec<String>,
    /// Names of shape parameters that a domain variable further up has.
    doubled: Vec<String>,
    /// Of the shape parameters that later chains declare.
    pub(super) later: Vec<String>,
}

impl Others {
    pub(super) fn new(written: &syntax::Family) -> Self {
        let (mut domain, mut later, mut doubled) = (Vec::<String>::new(), Vec::new(), Vec::new());
        for statement in &written.statements {
            match &statement.kind {
                StatementKind::Domain(decls) => domain.extend(decls.iter().map(|d| d.name.text.clone())),
                StatementKind::Product(factors) => {
                    domain.extend(factors.iter().flat_map(Factor::names).map(|name| name.text.clone()));
                }
                StatementKind::Shape(decls) => {
                    let own = decls.iter().filter_map(own_name).listed();
                    doubled.extend(own.iter().filter(|name| domain.contains(name)).cloned());
                    later.extend(own);
                }
                _ => {}
            }
        }
        Self { domain, doubled, later }
    }
}

/// The name whose range a chain is, without its index.
pub(super) fn own_name(decl: &ShapeDecl) -> Option<String> {
    match &decl.parts[primary(decl)?].kind {
        ExprKind::Name(name) => Some(name.clone()),
        ExprKind::Index(base, _) => match &base.kind {
            ExprKind::Name(name) => Some(name.clone()),
            _ => None,
        },
        _ => None,
    }
}
