//! Shape parameters: their ranges, which may depend on one another, and what `assume` says of their values.

use core::ops::ControlFlow;

use basis_kernel::{Relation, Statement as Proposition};
use proc_macro2::Span;
use std::rc::Rc;

use super::domain::variable;
use super::names::attempt;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, PolyExt as _, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::model::budget::SPLIT;
use crate::model::chart::{self, Constraint, MAX_CONDITIONS, Piece};
use crate::model::formula::numbers::checked_range;
use crate::model::formula::print::Printer;
use crate::model::obligation::Goal;
use crate::model::scope::Scope;
use crate::model::{Parameter, label};
use crate::syntax::{
    self, Comparison, Expr, ExprKind, Factor, Generator, Name, Relation as Written, ShapeDecl, StatementKind,
};
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;

/// The shape parameters of a family, and what is assumed of them.
pub(super) struct Shapes {
    pub(super) parameters: Vec<Parameter>,
    pub(super) constraints: Vec<Constraint>,
}

/// What stands in a chain of ranges.
enum Part {
    /// A parameter that the chain declares, with its range.
    New(Name),
    /// A number, or an expression in parameters that are declared before.
    Value(Fraction),
}

/// Declares the shape parameters, which become variables 0, 1, …, and reads what is assumed of them.
pub(super) fn shapes(scope: &mut Scope<'_>, written: &syntax::Family) -> Option<Shapes> {
    let mut shapes = Shapes { parameters: Vec::new(), constraints: Vec::new() };
    let mut complete = true;
    let mut others = Others::new(written);
    for statement in &written.statements {
        let StatementKind::Shape(decls) = &statement.kind else { continue };
        for decl in decls {
            if let Some(place) = own_name(decl).and_then(|own| others.later.iter().position(|n| *n == own)) {
                others.later.remove(place);
            }
            if !declare(scope, decl, &statement.doc, &others, &mut shapes) {
                complete = false;
                // What follows from that is not another mistake.
                let names = decl.parts.iter().filter_map(written_name).map(String::from);
                scope.undeclared.borrow_mut().extend(names);
            }
        }
    }
    let mut last = None;
    for statement in &written.statements {
        let StatementKind::Assume(relation) = &statement.kind else { continue };
        last = Some(relation.span);
        complete &= !complete || assume(scope, relation, &mut shapes);
    }
    if !complete {
        return None;
    }
    let first = written.statements.iter().find(|s| matches!(s.kind, StatementKind::Shape(_)));
    let span = last.or(first.map(|s| s.span)).unwrap_or_else(Span::call_site);
    has_values(scope, &shapes, span).then_some(shapes)
}

/// Whether there are shape values that satisfy all that is assumed; if not, that is reported.
pub(super) fn has_values(scope: &mut Scope<'_>, shapes: &Shapes, span: Span) -> bool {
    let ranges = shapes.parameters.mapped(|p| (p.var, p.range.clone()));
    let constraints = shapes.constraints.mapped(|c| (c.value.clone(), c.relation));
    let fixed = core::mem::take(&mut scope.impossible);
    match parts(scope, &ranges, &constraints, span) {
        None => return false,
        Some(pieces) if fixed.is_none() && !pieces.is_empty() => return true,
        Some(_) => {}
    }
    let texts = chart::texts(&shapes.constraints);
    let error = scope.error(fixed.unwrap_or(span), "no shape values satisfy all that is assumed");
    let error = if texts.is_empty() { error } else { error.note(format!("assumed is {}", texts.join(", "))) };
    scope.report(error.help("widen the ranges, or leave an assumption out"));
    false
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
pub(super) fn without_indices(scope: &mut Scope<'_>, decl: &ShapeDecl) -> Option<Vec<ShapeDecl>> {
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
fn declare(
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
    let named = decl.parts.iter().find_map(|part| Some((written_name(part)?, part.span)));
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

/// The name that a part of a chain is, without its index.
fn written_name(part: &Expr) -> Option<&str> {
    match &part.kind {
        ExprKind::Name(name) => Some(name),
        ExprKind::Index(base, _) => written_name(base),
        _ => None,
    }
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
        let part = decl.parts.iter().find(|part| is_named(part)).unwrap_or(&decl.parts[0]);
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
    let mut values: Vec<Fraction> = Vec::new();
    for (k, part) in parts.iter().enumerate() {
        values.push(match part {
            Part::Value(value) => value.clone(),
            Part::New(name) => {
                let range = Range {
                    low: hull(&parts, decl, k, false, shapes),
                    high: hull(&parts, decl, k, true, shapes),
                };
                let range = match range.finite() {
                    // Of a chain, `2 < q < p <= 1`, the ends stand in one line.
                    Some((a, b)) if a > b && parts.len() > 3 => {
                        let error = scope.error(name.span, format!("the range of `{}` is empty", name.text));
                        let label = format!("{a} is above {b}");
                        scope.report(
                            error.label(label).help("write the chain from the smallest to the greatest"),
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

/// Notes that a value has a sign; it must be a polynomial.
fn constrain(
    scope: &Scope<'_>,
    value: &Fraction,
    relation: Relation,
    text: String,
    span: Span,
    shapes: &mut Shapes,
) -> Option<()> {
    if shapes.constraints.len() == MAX_CONDITIONS {
        let message = format!("a family has at most {MAX_CONDITIONS} conditions on its shape values");
        scope.report(scope.error(span, message).help("leave out those that follow from others"));
        return None;
    }
    let Some(value) = value.as_poly() else {
        let error = scope.error(span, "a denominator contains a parameter in a condition on shape values");
        scope.report(error.help("multiply by it: write the condition with polynomials"));
        return None;
    };
    shapes.constraints.push(Constraint { value: value.clone(), relation, text, is_end: false });
    Some(())
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

/// Whether an expression is a name, perhaps with an index.
fn is_named(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Name(_) => true,
        ExprKind::Index(base, _) => matches!(base.kind, ExprKind::Name(_)),
        _ => false,
    }
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
            Some(Some(Name { text: label(name, &index), span: expr.span }))
        }
        _ => Some(None),
    }
}

/// The place in a chain of the name whose range it is; `None` in a chain that may declare several.
fn primary(decl: &ShapeDecl) -> Option<usize> {
    match &decl.parts[..] {
        [_] => Some(0),
        [a, b] => match (is_named(a), is_named(b)) {
            (true, false) => Some(0),
            (false, true) => Some(1),
            _ => None,
        },
        [a, b, c] if is_named(b) && !(is_named(a) && is_named(c)) => Some(1),
        _ => None,
    }
}

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
    // In `0 <= μ[i] <= μ[i + 1] for i in 1..n` the step before has declared the first name, and this one the next.
    let goes_on = indexed && scope.variable(&name.text).is_some() && decl.parts[k + 1..].iter().any(is_named);
    if primary(decl) == Some(k) && !goes_on {
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
    scope.report(error.help("ranges depend on numbers and on shape parameters that are declared before"));
    ControlFlow::Break(None)
}

/// Names that have a meaning in other statements of the family.
struct Others {
    /// Of the domain variables.
    domain: Vec<String>,
    /// Of the shape parameters that later chains declare.
    later: Vec<String>,
}

impl Others {
    fn new(written: &syntax::Family) -> Self {
        let (mut domain, mut later) = (Vec::new(), Vec::new());
        for statement in &written.statements {
            match &statement.kind {
                StatementKind::Domain(decls) => domain.extend(decls.iter().map(|d| d.name.text.clone())),
                StatementKind::Product(factors) => {
                    domain.extend(factors.iter().flat_map(Factor::names).map(|name| name.text.clone()));
                }
                StatementKind::Shape(decls) => later.extend(decls.iter().filter_map(own_name)),
                _ => {}
            }
        }
        Self { domain, later }
    }
}

/// The name whose range a chain is, without its index.
fn own_name(decl: &ShapeDecl) -> Option<String> {
    match &decl.parts[primary(decl)?].kind {
        ExprKind::Name(name) => Some(name.clone()),
        ExprKind::Index(base, _) => match &base.kind {
            ExprKind::Name(name) => Some(name.clone()),
            _ => None,
        },
        _ => None,
    }
}

/// Reads an assumption, for all values of its index variables; whether all went well.
pub(super) fn assume(scope: &mut Scope<'_>, relation: &Written, shapes: &mut Shapes) -> bool {
    let mut rounds = None;
    let depth = scope.constants.len();
    attempt(scope, &mut |scope| {
        let mut all = Vec::new();
        let fine = scope.each(&relation.loops, &mut |scope| {
            all.push(scope.constants[depth..].to_vec());
            true
        });
        rounds = Some((all, fine));
        Some(())
    });
    let Some((rounds, mut fine)) = rounds else { return false };
    for constants in rounds {
        scope.constants.extend(constants);
        fine &= assume_one(scope, relation, shapes).is_some();
        scope.constants.truncate(depth);
    }
    fine
}

fn assume_one(scope: &mut Scope<'_>, relation: &Written, shapes: &mut Shapes) -> Option<()> {
    let mut left = &relation.left;
    let first = core::iter::once((relation.comparison, &relation.right));
    for (sign, right) in first.chain(relation.chain.iter().map(|(sign, side)| (*sign, side))) {
        let a = attempt(scope, &mut |scope| scope.scalar(left))?;
        let b = attempt(scope, &mut |scope| scope.scalar(right))?;
        let printer = Printer { constants: &scope.constants, component: None };
        let text = format!("{} {} {}", printer.print(left), sign.symbol(), printer.print(right));
        let difference = scope.fits(scope.budget.sub(&a, &b), relation.span)?;
        match sign {
            Comparison::Equal => determine(scope, &difference, relation.span, &text, shapes)?,
            Comparison::NotEqual => {
                let error = scope.error(relation.span, "an assumption is an inequality or a linear equation");
                scope.report(error.help("narrow the range of a parameter, such as by `assume λ > 0;`"));
                return None;
            }
            _ => {
                let strict = matches!(sign, Comparison::Less | Comparison::Greater);
                let below = matches!(sign, Comparison::Less | Comparison::LessEqual);
                let value = if below { -&difference } else { difference };
                let relation_of = if strict { Relation::Positive } else { Relation::NonNegative };
                constrain(scope, &value, relation_of, text, relation.span, shapes)?;
            }
        }
        left = right;
    }
    Some(())
}

/// An equation that is linear in a parameter determines it: of several the one that is declared last.
fn determine(
    scope: &mut Scope<'_>,
    difference: &Fraction,
    span: Span,
    text: &str,
    shapes: &mut Shapes,
) -> Option<()> {
    let p = difference.numer();
    if let Some(c) = p.as_constant() {
        if !c.is_zero() {
            scope.impossible = Some(span);
        }
        return Some(());
    }
    if scope.analytic.pi.is_some() {
        let error = scope.error(span, "an equation cannot determine a parameter beside angles, or ends of the domain that are parameters");
        scope.report(error.help("put the value of the parameter in its place"));
        return None;
    }
    let slope = |var: Var| p.derivative(var).as_constant().filter(|c| !c.is_zero());
    let found =
        shapes.parameters.iter().rev().find_map(|parameter| Some((parameter.var, slope(parameter.var)?)));
    let Some((var, slope)) = found else {
        let error = scope.error(span, "the equation is not linear in a shape parameter");
        scope.report(error.help(
            "an equation determines a parameter, as in `assume B + 2*C = 1;`; otherwise write inequalities",
        ));
        return None;
    };
    let value = p.at(var, &Rational::ZERO).scale(&-&slope.recip().unwrap_or(Rational::ONE));
    // The parameter is no variable any more, and those after it move up.
    let place = shapes.parameters.iter().position(|p| p.var == var)?;
    let parameter = shapes.parameters.remove(place);
    let moved = |v: Var| if v > var { Var(v.0 - 1) } else { v };
    let names: Vec<Var> = (0..scope.names.len()).map(|k| moved(Var(k))).listed();
    let put = |p: &Poly| p.substitute(var, &value).rename(&names);
    for constraint in &mut shapes.constraints {
        constraint.value = put(&constraint.value);
    }
    let value = value.rename(&names);
    for (_, known) in &mut scope.determined {
        if let Some(p) = known.as_poly() {
            *known = Fraction::from(put(p));
        }
    }
    for other in &mut shapes.parameters {
        other.var = moved(other.var);
    }
    scope.names.remove(var.0);
    // What has been evaluated already may mention the variables as they were.
    scope.lets = SortedMap::new();
    scope.determined.push((parameter.name.clone(), Fraction::from(value.clone())));
    for (end, above) in [(&parameter.range.low, false), (&parameter.range.high, true)] {
        let Some(bound) = end.value() else { continue };
        let distance = &value - &Poly::constant(bound.clone());
        let distance = if above { -&distance } else { distance };
        let relation = if end.is_included() { Relation::NonNegative } else { Relation::Positive };
        let sign = match (above, end.is_included()) {
            (false, true) => ">=",
            (false, false) => ">",
            (true, true) => "<=",
            (true, false) => "<",
        };
        let text = format!("{} {sign} {bound} by {text}", parameter.name);
        shapes.constraints.push(Constraint { value: distance, relation, text, is_end: false });
    }
    Some(())
}

/// The values that satisfy conditions, in parts; none if it is known that there are no such values. `None` when that takes
/// too much work, which is reported.
pub(crate) fn parts(
    scope: &Scope<'_>,
    ranges: &[(Var, Range)],
    constraints: &[(Poly, Relation)],
    span: Span,
) -> Option<Vec<Piece>> {
    let (pieces, units) = basis_prover::measured(&mut || {
        let pieces = chart::pieces(ranges, constraints);
        if pieces.iter().all(|piece| is_empty(scope, piece)) { Vec::new() } else { pieces }
    });
    // Each variable that is eliminated is looked for in all conditions.
    let units = units + 20 * (ranges.len() * constraints.len()) as u64;
    scope.within(scope.budget.run().decision(units), span, SPLIT).map(|()| pieces)
}

/// Whether it is known that a part of the values has no points: one of its premises is false everywhere.
fn is_empty(scope: &Scope<'_>, piece: &Piece) -> bool {
    let domain =
        Rc::new(basis_kernel::Domain::of(crate::algebra::range::Region { ranges: piece.ranges.clone() }));
    piece.premises.iter().any(|(p, relation)| {
        let other = match relation {
            Relation::NonNegative => Relation::Positive,
            Relation::Positive => Relation::NonNegative,
        };
        let Some(p) = piece.pull_back(p) else { return false };
        let value = basis_kernel::Quotient::from(-&p);
        let never = Goal::Holds(Proposition::Sign { value, relation: other, domain: Rc::clone(&domain) });
        // Where proofs are checked later, nothing is known.
        matches!(scope.library.judge().judge(&never, 1), Ok(Some(_)))
    })
}
