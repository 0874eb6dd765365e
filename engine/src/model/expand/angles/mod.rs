//! Shape parameters and domain variables of a family in which sin, cos, exp or π occur: which of them are angles, and in
//! which tangents they are expanded.

mod declared;
mod edges;
mod limits;
mod numbers;
mod rate;
mod roots;
mod survey;
mod tangent;

use proc_macro2::Span;

use super::domain::{self, Domain, variable};
pub(super) use limits::are_ordered;

use super::shapes::Shapes;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::model::Parameter;
use crate::model::angle::{Kind, without_brackets};
use crate::model::chart::Constraint;
use crate::model::formula::numbers::range_of;
use crate::model::formula::phase::as_end_of_domain;
use crate::model::scope::Scope;
use crate::model::words::PI;
use crate::syntax::{self, Expr, ExprKind, RangeDecl, StatementKind};
use basis_kernel::Relation;
use basis_prover::collections::list::{Listed, Mapped};
use limits::{Bound, Limits, Place, limits, sum_of};
use numbers::{exponential, exponential_bounds, ranges, tangent};
use roots::roots;
use survey::{Use, survey};
use tangent::{angle, linear};

/// The shape parameters and the domain variables of a family with angles.
pub(super) fn declare<'a>(
    scope: &mut Scope<'a>,
    written: &'a syntax::Family,
    _: Span,
) -> Option<(Shapes, Domain)> {
    let (owned, order) = chains(scope, written)?;
    let shapes: Vec<(&RangeDecl, &[String])> = owned.iter().map(|(decl, doc)| (decl, *doc)).listed();
    let mut domain: Vec<(&RangeDecl, &[String])> = Vec::new();
    let mut product = false;
    for statement in &written.statements {
        match &statement.kind {
            StatementKind::Domain(decls) => {
                domain.extend(domain::of_span(scope, decls).iter().map(|d| (d, &statement.doc[..])));
            }
            StatementKind::Product(_) => product = true,
            _ => {}
        }
    }
    let names = shapes.iter().chain(&domain).map(|(d, _)| d.name.text.clone()).listed();
    let (mut uses, finer) = survey(scope, written, &names, shapes.len());
    scope.analytic.finer = finer;
    if let Some((parameter, t, function, span, turns)) = uses.frequencies.first() {
        let error = scope.error(*span, format!("the argument of `{function}` is not linear in one variable"));
        scope.report(error.help(as_end_of_domain(function, &names[parameter.0], &names[t.0], *turns)));
        return None;
    }
    let mut slots = Vec::new();
    for (decl, _) in &shapes {
        slots.push(variable(scope, &decl.name)?);
    }
    let own = if product {
        Some(domain::domain(scope, written)?)
    } else {
        for (decl, _) in &domain {
            let var = variable(scope, &decl.name)?;
            scope.domain.push(var);
            slots.push(var);
        }
        None
    };
    // The variables themselves follow, then the numbers.
    let count = scope.names.len();
    let itself = |k: usize| Var(count + k);
    scope.names.extend(names.iter().cloned());
    let slot_names = names.mapped(|name| format!("{name} ")); // not to be found by the name; replaced for angles
    for (k, slot) in slots.iter().enumerate() {
        scope.names[slot.0].clone_from(&slot_names[k]);
    }
    scope.analytic.pi = Some(Var(scope.names.len()));
    scope.names.push(String::from(PI[0]));
    given(scope);
    let mut fine = true;
    let mut limits = Vec::new();
    for (decl, _) in shapes.iter().chain(&domain) {
        limits.push(self::limits(scope, decl)?);
    }
    let shape_count = shapes.len();
    // An end of the domain that is a shape parameter is an angle like the variable.
    let mut all: Vec<Option<Use>> = (0..names.len()).map(|k| uses.of(Var(k)).cloned()).listed();
    for k in shape_count..names.len() {
        let Some(own) = all[k].clone() else { continue };
        // Of all spans, so that values at a knot are in one tangent, and powers of one exponential.
        let mut others = Vec::new();
        for statement in &written.statements {
            let StatementKind::Domain(decls) = &statement.kind else { continue };
            let this = domain[k - shape_count].0;
            let is_other = |decl: &&RangeDecl| decl.name.text == names[k] && !core::ptr::eq(*decl, this);
            for decl in decls.iter().filter(is_other) {
                others.push(self::limits(scope, decl)?);
            }
        }
        for end in limits[k].iter().chain(others.iter().flatten()).flatten() {
            if own.kind == Kind::Hyperbolic && !end.value.number.is_zero() {
                uses.numbers.push(&end.value.number.abs() * &own.unit);
            }
            for (var, factor, _) in &end.value.parts {
                let shape = var.0.checked_sub(count).filter(|s| *s < shape_count)?;
                let mut of = Use { unit: &own.unit * &factor.abs(), ..own.clone() };
                if let Some(known) = &all[shape] {
                    of.unit = of.unit.gcd(&known.unit);
                    of.torn = of.torn.or(known.torn);
                }
                if let Some(variable) = &mut all[k] {
                    variable.torn = variable.torn.or(of.torn);
                }
                all[shape] = Some(of);
            }
        }
    }
    for var in &uses.beside {
        if let Some(of) = &mut all[var.0] {
            of.beside = true;
        }
    }
    for (k, of) in all.iter().enumerate() {
        if let Some(Use { torn: Some(what), span, .. }) = of {
            let error = scope.error(*span, format!("`{}` appears in {what}", names[k]));
            scope.report(
                error.help("the functions of a family are those of one angle, and of its rational multiples"),
            );
            fine = false;
        }
    }
    if !fine {
        return None;
    }
    exponential(scope, &uses, &all, &limits);
    if let Some((_, number)) =
        scope.analytic.exponential.clone().filter(|(_, r)| exponential_bounds(r).is_none())
    {
        let of = all.iter().flatten().find(|of| of.kind == Kind::Hyperbolic);
        let span = of.map_or_else(|| written.name.span, |of| of.span);
        let error = scope.error(span, format!("exp({number}), which this contains, is too large a number"));
        scope.report(error.help(
            "end ranges, and exponents that are numbers, at 512 at most; or leave the end of the range out",
        ));
        return None;
    }
    tangent(scope, &all[..shape_count], &limits);
    roots(scope, &uses, &all, &limits, shape_count);
    let mut parameters = Vec::new();
    let mut ends: Vec<Constraint> = Vec::new();
    let mut constraints: Vec<Constraint> = Vec::new();
    for (k, (decl, doc)) in shapes.iter().chain(&domain).enumerate() {
        if k == shape_count {
            constraints = assumed(scope, written, &order, &slots[..k], &all, &parameters)?;
        }
        let at = Place { slot: slots[k], itself: itself(k), is_domain: k >= shape_count };
        let range = match &all[k] {
            Some(of) => angle(scope, decl, &at, of, &limits[k], (&all, count, &parameters), &mut ends),
            None if at.is_domain && limits[k].iter().flatten().any(Bound::is_no_number) => {
                linear(scope, decl, &at, &limits[k], count, (&parameters, &constraints))
            }
            None => plain(scope, decl, &at, &limits[k], written.incomplete),
        };
        let Some(range) = range else {
            fine = false;
            continue;
        };
        // Alone it needs no brackets.
        let name = &scope.names[slots[k].0];
        let (name, place) = (without_brackets(name).to_owned(), scope.place(decl.name.span));
        parameters.push(Parameter { name, doc: doc.to_vec(), place, var: slots[k], range });
    }
    if !fine {
        return None;
    }
    mirrors(scope, shape_count, &parameters, &limits, count)?;
    constraints.extend(ends);
    scope.analytic.ranges = ranges(scope);
    let domain = parameters.split_off(shape_count);
    if own.is_none() && domain.is_empty() {
        let error =
            scope.error(written.name.span, format!("the family `{}` has no domain", written.name.text));
        scope.report(error.help("write `domain 0 <= t <= 1;`"));
        return None;
    }
    Some((Shapes { parameters, constraints }, own.unwrap_or((domain, Vec::new()))))
}

/// Whether a range is that of one parameter, with this name.
pub(super) fn is_alone(decl: &syntax::ShapeDecl, name: &str) -> bool {
    let mut names = decl.names();
    names.retain(|name| !PI.contains(name));
    names == [name]
}

/// Gives the shape parameters their values that have one.
pub(super) fn given(scope: &mut Scope<'_>) {
    for (name, turns) in scope.anew.given.clone() {
        let pi = scope.analytic.pi.map_or_else(Fraction::zero, Fraction::var);
        scope.determined.push((name, &Fraction::constant(turns) * &pi));
    }
}

/// Two parameters of a chain that follow one another: the places of the lower and of the upper one, whether they may be
/// equal, and the condition as it is written.
type Order = (usize, usize, bool, String);

/// A range with its doc comment.
type Documented<'a> = (RangeDecl, &'a [String]);

/// The ranges of the shape parameters, each alone, with the order of those in one chain.
fn chains<'a>(
    scope: &mut Scope<'_>,
    written: &'a syntax::Family,
) -> Option<(Vec<Documented<'a>>, Vec<Order>)> {
    let (mut all, mut order): (Vec<Documented<'a>>, Vec<Order>) = (Vec::new(), Vec::new());
    for statement in &written.statements {
        let StatementKind::Shape(decls) = &statement.kind else { continue };
        let mut single = Vec::new();
        for decl in decls {
            single.extend(super::shapes::without_indices(scope, decl)?);
        }
        for decl in &single {
            if scope.anew.given.iter().any(|(name, _)| is_alone(decl, name)) {
                continue;
            }
            let is_name = |e: &Expr| matches!(e.kind, ExprKind::Name(_));
            let end = |from: usize, above: bool| {
                let mut included = true;
                let mut k = from;
                loop {
                    let next =
                        if above { Some(k + 1).filter(|k| *k < decl.parts.len()) } else { k.checked_sub(1) }?;
                    included &= decl.included[k.min(next)];
                    k = next;
                    if !is_name(&decl.parts[k]) || PI.iter().any(|pi| names(&decl.parts[k]) == Some(*pi)) {
                        return Some(syntax::Limit { value: decl.parts[k].clone(), included });
                    }
                }
            };
            let mut before: Option<(usize, usize)> = None;
            for (k, part) in decl.parts.iter().enumerate() {
                let Some(text) = names(part).filter(|name| !PI.contains(name)) else { continue };
                let place = match all.iter().position(|(d, _)| d.name.text == text) {
                    // Only in a chain with others a name can be one that is declared before.
                    Some(known) if decl.names().len() > 1 => known,
                    _ => {
                        let name = syntax::Name { text: text.to_string(), span: part.span };
                        all.push((
                            RangeDecl { name, low: end(k, false), high: end(k, true) },
                            &statement.doc,
                        ));
                        all.len() - 1
                    }
                };
                if let Some((at, lower)) = before.filter(|(at, _)| at + 1 == k) {
                    let sign = if decl.included[at] { "<=" } else { "<" };
                    let text = format!("{} {sign} {text}", all[lower].0.name.text);
                    order.push((lower, place, decl.included[at], text));
                }
                before = Some((k, place));
            }
        }
    }
    Some((all, order))
}

/// The name that an expression is.
fn names(expr: &Expr) -> Option<&str> {
    match &expr.kind {
        ExprKind::Name(name) => Some(name),
        _ => None,
    }
}

/// What is assumed of shape parameters that are no angles.
fn assumed(
    scope: &mut Scope<'_>,
    written: &syntax::Family,
    order: &[Order],
    slots: &[Var],
    uses: &[Option<Use>],
    parameters: &[Parameter],
) -> Option<Vec<Constraint>> {
    let mut shapes = Shapes { parameters: parameters.to_vec(), constraints: Vec::new() };
    for (lower, upper, included, text) in order {
        let value = &Poly::var(slots[*upper]) - &Poly::var(slots[*lower]);
        let relation = if *included { Relation::NonNegative } else { Relation::Positive };
        shapes.constraints.push(Constraint { value, relation, text: text.clone(), is_end: false });
    }
    let mut span = None;
    for statement in &written.statements {
        if let StatementKind::Assume(relation) = &statement.kind {
            span = Some(relation.span);
            if !super::shapes::assume(scope, relation, &mut shapes) {
                return None;
            }
        }
    }
    let plain = |v: &Var| slots.iter().position(|slot| slot == v).is_some_and(|k| uses[k].is_none());
    let angle = shapes.constraints.iter().find(|c| !c.value.variables().iter().all(plain));
    let first = written.statements.iter().find(|s| matches!(s.kind, StatementKind::Shape(_)));
    let span = span.or(first.map(|s| s.span)).unwrap_or_else(Span::call_site);
    if let Some(constraint) = angle {
        let message = format!("`{}` is about an angle, or about `pi`", constraint.text);
        scope.report(scope.error(span, message).help("ranges of angles depend on no others"));
        return None;
    }
    if !super::shapes::has_values(scope, &shapes, span) {
        return None;
    }
    Some(shapes.constraints)
}

/// A variable that is no angle.
fn plain(
    scope: &mut Scope<'_>,
    decl: &RangeDecl,
    at: &Place,
    limits: &Limits,
    incomplete: bool,
) -> Option<Range> {
    // It stands for itself.
    let name = decl.name.text.clone();
    scope.names[at.itself.0] = format!("{name} ");
    scope.names[at.slot.0] = name;
    for limit in limits.iter().flatten() {
        if limit.is_no_number() {
            if incomplete {
                return Some(Range::unit()); // its sine may be what could not be read
            }
            let error = scope.error(
                decl.name.span,
                format!("an end of the range of `{}` is not a number", decl.name.text),
            );
            scope.report(error.help("ends with `pi`, and ends that are shape parameters, belong to domain variables, and to shape parameters that stand in `sin`, `cos`, `exp` and the like"));
            scope.undeclared.borrow_mut().push(decl.name.text.clone());
            return None;
        }
    }
    let range = range_of(scope, decl.name.span, (decl.low.as_ref(), decl.high.as_ref()), None, &|| {
        decl.name.text.clone()
    })?;
    if let (true, Some((low, high))) = (at.is_domain, range.finite()) {
        scope.ends.push((Fraction::constant(low.clone()), Fraction::constant(high.clone())));
    }
    if at.is_domain && range.finite().is_none_or(|(a, b)| a >= b) {
        let error =
            scope.error(decl.name.span, format!("the domain of `{}` is not an interval", decl.name.text));
        scope.report(error.help("write both ends, such as `domain 0 <= t <= 1;`"));
        return None;
    }
    Some(range)
}

/// y after the domain is reversed, for each domain variable that is an angle.
fn mirrors(
    scope: &mut Scope<'_>,
    shape_count: usize,
    parameters: &[Parameter],
    limits: &[Limits],
    count: usize,
) -> Option<()> {
    for (k, parameter) in parameters.iter().enumerate().skip(shape_count) {
        let Some(position) = scope.analytic.angles.iter().position(|a| a.var == parameter.var) else {
            continue;
        };
        let angle = scope.analytic.angles[position].clone();
        let own = if angle.kind == Kind::Linear { angle.tangent() } else { Fraction::var(angle.itself) };
        let mut reversed = -&own;
        for end in limits[k].iter().flatten() {
            reversed = &reversed + &sum_of(scope, &end.value, count)?;
        }
        // Where this is too much work nothing is known of the reversed domain, which is no mistake.
        scope.budget.shorten();
        let said = scope.diagnostics.take();
        let found = scope.angle_at(&angle, &reversed, Span::call_site());
        *scope.diagnostics.borrow_mut() = said;
        scope.budget.refill();
        if let Ok(Some(y)) = found {
            scope.analytic.angles[position].mirror = vec![(angle.var, y), (angle.itself, reversed)];
        }
    }
    Some(())
}
