//! Shape parameters and domain variables of a family in which sin, cos, exp or π occur: which of them are angles, and in
//! which tangents they are expanded.

use proc_macro2::Span;

use super::domain::{self, Domain, variable};
use super::edges::{Edge, edge};
use super::shapes::Shapes;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range, Region};
use crate::algebra::rational::Rational;
use crate::model::Parameter;
use crate::model::angle::{Angle, Kind, multiple_of_pi};
use crate::model::chart::Constraint;
use crate::model::formula::numbers::range_of;
use crate::model::formula::phase::{Linear, as_end_of_domain, frequency};
use crate::model::formula::print::Printer;
use crate::model::scope::{Argument, Scope, Stage};
use crate::model::words::{CIRCULAR, PI, is_transcendental};
use crate::syntax::{self, Binding, ClaimKind, Expr, ExprKind, Factor, RangeDecl, StatementKind};
use basis_kernel::Relation;
use basis_prover::collections::list::{Listed, Mapped};
use basis_prover::collections::map::SortedMap;

/// Whether sin, cos, exp and the like, or π, occur in a family, or a shape parameter at an end of the domain.
pub(super) fn occur(written: &syntax::Family) -> bool {
    let mut found = parametric_ends(written);
    each_expression(written, &mut |expr| found |= mentions(expr));
    found && !written.statements.iter().any(|s| declares_pi(&s.kind))
}

/// Whether a shape parameter stands at an end of the domain.
fn parametric_ends(written: &syntax::Family) -> bool {
    let declared = |name: &String| {
        written
            .statements
            .iter()
            .any(|s| matches!(&s.kind, StatementKind::Shape(decls) if decls.iter().any(|d| d.names().contains(&&**name))))
    };
    let decls = written.statements.iter().flat_map(|s| match &s.kind {
        StatementKind::Domain(decls) => decls.as_slice(),
        _ => &[],
    });
    decls.flat_map(|d| d.low.iter().chain(&d.high)).any(|limit| limit.value.has_name(&declared))
}

fn declares_pi(kind: &StatementKind) -> bool {
    let is_pi = |name: &syntax::Name| PI.contains(&name.text.as_str());
    match kind {
        // Beside another name it is the number at the end of a range.
        StatementKind::Shape(decls) => decls.iter().any(|d| {
            let names = d.names();
            !names.is_empty() && names.iter().all(|name| PI.contains(name))
        }),
        StatementKind::Domain(decls) => decls.iter().any(|d| is_pi(&d.name)),
        StatementKind::Product(factors) => factors.iter().flat_map(Factor::names).any(is_pi),
        StatementKind::Let(def) => is_pi(&def.name),
        _ => false,
    }
}

/// Calls a function with every expression of a family.
fn each_expression(written: &syntax::Family, with: &mut dyn FnMut(&Expr)) {
    let range = |decl: &RangeDecl, with: &mut dyn FnMut(&Expr)| {
        for limit in decl.low.iter().chain(&decl.high) {
            with(&limit.value);
        }
    };
    for statement in &written.statements {
        match &statement.kind {
            StatementKind::Domain(decls) => decls.iter().for_each(|decl| range(decl, with)),
            StatementKind::Product(factors) => {
                factors.iter().filter_map(Factor::range).for_each(|decl| range(decl, with));
            }
            StatementKind::Shape(decls) => {
                decls.iter().flat_map(|d| &d.parts).for_each(&mut *with);
            }
            StatementKind::Assume(relation) => {
                with(&relation.left);
                with(&relation.right);
                relation.chain.iter().for_each(|(_, side)| with(side));
            }
            StatementKind::Let(def) => with(&def.value),
            StatementKind::Function(def) | StatementKind::Raise(def) => {
                with(&def.value);
                def.further.iter().for_each(&mut *with);
            }
            StatementKind::Base(_, functions) => functions.iter().for_each(|def| with(&def.value)),
            StatementKind::Claim(claim) => match &claim.kind {
                ClaimKind::Relation(r) => sides(r, with),
                ClaimKind::At(bindings, relations) => {
                    for b in bindings {
                        with(&b.value);
                    }
                    for r in relations {
                        sides(r, with);
                    }
                }
                ClaimKind::Independent(exceptions) => {
                    exceptions.iter().flatten().for_each(|b| with(&b.value));
                }
                _ => {}
            },
            StatementKind::Budget(_) => {}
        }
    }
}

/// The sides of a claim.
fn sides(relation: &syntax::Relation, with: &mut dyn FnMut(&Expr)) {
    with(&relation.left);
    with(&relation.right);
    relation.chain.iter().for_each(|(_, side)| with(side));
}

fn mentions(expr: &Expr) -> bool {
    let own = match &expr.kind {
        ExprKind::Name(name) => PI.contains(&name.as_str()),
        ExprKind::Call(callee, _) => matches!(&callee.kind, ExprKind::Name(name) if is_transcendental(name)),
        _ => false,
    };
    own || expr.parts().into_iter().any(mentions)
}

/// The arguments of one variable, or of one number.
#[derive(Default)]
struct Uses {
    /// By variable: its factors, those in sin and cos first, then those in exp; whether they are multiples of π.
    by_var: Vec<(Var, Use)>,
    /// Numbers in arguments of exp.
    numbers: Vec<Rational>,
    /// Shape parameters that stand in functions themselves.
    beside: Vec<Var>,
    /// Shape parameters as frequencies of domain variables, with the function, and where.
    frequencies: Vec<(Var, Var, String, Span)>,
}

#[derive(Clone, Debug)]
struct Use {
    kind: Kind,
    turns: bool,
    /// The greatest common divisor of the factors.
    unit: Rational,
    /// Whether the factors do not go together.
    torn: Option<&'static str>,
    /// Whether the variable stands in functions itself, too: its tangent is to be bounded then, as bounds for it need.
    beside: bool,
    span: Span,
}

impl Uses {
    fn add(&mut self, var: Var, new: Use) {
        if let Some((_, known)) = self.by_var.iter_mut().find(|(v, _)| *v == var) {
            if known.kind != new.kind {
                known.torn = Some("sin or cos, and exp, sinh or cosh");
                known.span = new.span;
            } else if known.turns != new.turns {
                known.torn = Some("sin and cos of different angles, with and without `pi`");
                known.span = new.span;
            }
            known.unit = known.unit.gcd(&new.unit);
        } else {
            self.by_var.push((var, new));
        }
    }

    fn of(&self, var: Var) -> Option<&Use> {
        self.by_var.iter().find(|(v, _)| *v == var).map(|(_, u)| u)
    }
}

/// All uses in a family. It is expanded with all variables themselves and one more for every sine; errors are those of
/// the expansion proper.
fn survey<'a>(scope: &Scope<'a>, written: &'a syntax::Family, names: &[String], shapes: usize) -> Uses {
    let mut probe = Scope::new(scope.library, scope.unit, scope.source);
    probe.constants.clone_from(&scope.constants);
    probe.order = scope.order;
    probe.names = names.to_vec();
    probe.domain = (shapes..names.len()).map(Var).listed();
    probe.analytic.pi = Some(Var(names.len()));
    probe.names.push(String::from(PI[0]));
    probe.recorded = Some(Vec::new());
    let (mut places, mut beside) = (Vec::new(), Vec::new());
    // The angles are the same on all spans, so that their tangents can be compared.
    for k in 0..scope.span.map_or(1, |(_, count)| count) {
        probe.span = scope.span.map(|(_, count)| (k, count));
        probe.functions = SortedMap::new();
        probe.planned_functions = SortedMap::new();
        probe.defined = SortedMap::new();
        probe.lets = SortedMap::new();
        probe_claims(&mut probe, written, &mut places);
        for var in (0..shapes).map(Var) {
            if probe.functions.values().flatten().any(|f| f.depends_on(var)) {
                beside.push(var);
            }
        }
    }
    let mut uses = Uses { beside, ..Uses::default() };
    for Argument { name, value, span } in probe.recorded.unwrap_or_default() {
        let Some(linear) = Linear::of(&value, probe.analytic.pi) else {
            let pair = frequency(&value, |v| v.0 < shapes, |v| (shapes..names.len()).contains(&v.0));
            if let Some((parameter, t)) = pair {
                uses.frequencies.push((parameter, t, name, span));
            }
            continue;
        };
        // Not of a sine of a sine.
        if linear.parts.iter().any(|(var, ..)| var.0 >= names.len()) {
            continue;
        }
        let circular = CIRCULAR.contains(&name.as_str());
        let kind = if circular { Kind::Circular } else { Kind::Hyperbolic };
        for (var, factor, turns) in &linear.parts {
            uses.add(*var, Use { kind, turns: *turns, unit: factor.abs(), torn: None, beside: false, span });
        }
        if !circular && !linear.number.is_zero() {
            uses.numbers.push(linear.number.abs());
        }
    }
    for (var, value) in places {
        let Some(of) = uses.of(var).cloned() else { continue };
        if let Some(number) = value.as_constant() {
            if of.kind == Kind::Hyperbolic && !number.is_zero() {
                uses.numbers.push(&number.abs() * &of.unit);
            }
        } else if let Some(linear) = Linear::of(&value, probe.analytic.pi) {
            // In the middle of the domain, at t = α/2, the angle of α is half of that of t.
            for (shape, factor, _) in linear.parts.iter().filter(|(shape, ..)| shape.0 < shapes) {
                uses.add(*shape, Use { unit: &of.unit * &factor.abs(), ..of.clone() });
            }
        }
    }
    uses
}

/// Evaluates the functions and the claims of a family; the values that `at` gives to variables.
fn probe_claims<'a>(probe: &mut Scope<'a>, written: &'a syntax::Family, places: &mut Vec<(Var, Fraction)>) {
    probe.stage = Stage::Defining;
    super::names::plan(probe, written);
    super::functions::define(probe, written);
    probe.stage = Stage::Complete;
    for statement in &written.statements {
        let StatementKind::Claim(claim) = &statement.kind else { continue };
        match &claim.kind {
            ClaimKind::Relation(relation) => probe_relation(probe, relation),
            ClaimKind::At(bindings, relations) => {
                for Binding { name, value, .. } in bindings {
                    let var = probe.variable(&name.text);
                    places.extend(var.zip(probe.scalar(value)));
                }
                for relation in relations {
                    probe_relation(probe, relation);
                }
            }
            _ => {}
        }
    }
}

/// Evaluates the sides of a claim for all values of its index variables.
fn probe_relation(probe: &mut Scope<'_>, relation: &syntax::Relation) {
    probe.each(&relation.loops, &mut |probe| {
        sides(relation, &mut |side| {
            probe.value(side);
        });
        probe.waits_for = None;
        true
    });
}

/// An end of a range of an angle.
struct Bound {
    value: Linear,
    included: bool,
    text: String,
}

impl Bound {
    /// Whether it contains π or shape parameters.
    fn is_no_number(&self) -> bool {
        !self.value.pi.is_zero() || !self.value.parts.is_empty()
    }
}

/// x at a number, by ψ/π or by the number.
enum Tangent {
    Exact(Rational),
    Infinite,
    Irrational,
}

impl Tangent {
    fn of(kind: Kind, rate: &Rational, turns: bool, shift: &Rational, at: &Linear) -> Self {
        if kind == Kind::Hyperbolic {
            return if at.number.is_zero() { Self::Exact(Rational::ZERO) } else { Self::Irrational };
        }
        let (own, other) = if turns { (&at.number, &at.pi) } else { (&at.pi, &at.number) };
        if !other.is_zero() {
            return Self::Irrational;
        }
        let psi = &(own - shift) * rate; // in multiples of π
        match (&psi * &Rational::from(4)).to_i64() {
            Some(k @ (-1..=1)) => Self::Exact(Rational::from(k)),
            Some(2 | -2) => Self::Infinite,
            _ => Self::Irrational,
        }
    }
}

/// The shape parameters and the domain variables of a family with angles.
pub(super) fn declare<'a>(scope: &mut Scope<'a>, written: &'a syntax::Family) -> Option<(Shapes, Domain)> {
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
    let mut uses = survey(scope, written, &names, shapes.len());
    if let Some((parameter, t, function, span)) = uses.frequencies.first() {
        let error = scope.error(*span, format!("the argument of `{function}` is not linear in one variable"));
        scope.report(error.help(as_end_of_domain(function, &names[parameter.0], &names[t.0])));
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
        let mut spans = Vec::new();
        for statement in &written.statements {
            let StatementKind::Domain(decls) = &statement.kind else { continue };
            for decl in decls.iter().filter(|decl| decl.name.text == names[k]) {
                spans.push(self::limits(scope, decl)?);
            }
        }
        for end in spans.iter().flatten().flatten() {
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
        let bare = name.strip_prefix('(').and_then(|name| name.strip_suffix(')'));
        let bare = bare.filter(|inner| !inner.contains([')', '(']));
        let (name, place) = (bare.unwrap_or(name).to_string(), scope.place(decl.name.span));
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

/// Two parameters of a chain that follow one another: the places of the lower and of the upper one, whether they may be
/// equal, and the condition as it is written.
type Order = (usize, usize, bool, String);

/// A range with its doc comment.
type Documented<'a> = (RangeDecl, &'a [String]);

/// The ranges of the shape parameters, each alone, with the order of those in one chain.
fn chains<'a>(scope: &Scope<'_>, written: &'a syntax::Family) -> Option<(Vec<Documented<'a>>, Vec<Order>)> {
    let (mut all, mut order): (Vec<Documented<'a>>, Vec<Order>) = (Vec::new(), Vec::new());
    for statement in &written.statements {
        let StatementKind::Shape(decls) = &statement.kind else { continue };
        for decl in decls {
            let is_name = |e: &Expr| matches!(e.kind, ExprKind::Name(_));
            let indexed = |e: &&Expr| matches!(&e.kind, ExprKind::Index(base, _) if matches!(&base.kind, ExprKind::Name(_)));
            if let Some(part) = decl.parts.iter().find(indexed) {
                let error = scope.error(part.span, "a shape parameter with an index stands beside angles, or ends of the domain that are parameters");
                scope.report(error.help("give each of them a name of its own"));
                return None;
            }
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

/// Where a variable stands.
struct Place {
    slot: Var,
    itself: Var,
    is_domain: bool,
}

/// The ends of a range as they are written, where it has ends; `None` when one is no sum of multiples.
fn limits(scope: &mut Scope<'_>, decl: &RangeDecl) -> Option<Limits> {
    let mut ends = [None, None];
    for (end, limit) in ends.iter_mut().zip([&decl.low, &decl.high]) {
        let Some(syntax::Limit { value: expr, included }) = limit else { continue };
        let value = scope.scalar(expr).and_then(|f| Linear::of(&f, scope.analytic.pi));
        let Some(value) = value else {
            if scope.diagnostics.borrow().is_empty() {
                let message = "the end of a range is a number, a multiple of `pi`, or a shape parameter";
                scope.report(scope.error(expr.span, message));
            }
            return None;
        };
        let text = Printer { constants: &scope.constants, component: None }.print(expr);
        *end = Some(Bound { value, included: *included, text });
    }
    Some(ends)
}

/// The ends of a range, the lower one first.
type Limits = [Option<Bound>; 2];

/// The range as it is written.
fn declared(name: &str, limits: &Limits) -> String {
    let sign = |limit: &Bound| if limit.included { "<=" } else { "<" };
    let mut text = String::from(name);
    if let [Some(low), _] = limits {
        text = format!("{} {} {text}", low.text, sign(low));
    }
    if let [_, Some(high)] = limits {
        text = format!("{text} {} {}", sign(high), high.text);
    }
    text
}

/// The number exp(r) in which all others are powers.
fn exponential(scope: &mut Scope<'_>, uses: &Uses, all: &[Option<Use>], limits: &[Limits]) {
    let mut unit = Rational::ZERO;
    for number in &uses.numbers {
        unit = unit.gcd(number);
    }
    for (of, ends) in all.iter().zip(limits) {
        let Some(of) = of.as_ref().filter(|of| of.kind == Kind::Hyperbolic) else { continue };
        for end in ends.iter().flatten() {
            unit = unit.gcd(&(&end.value.number * &of.unit));
        }
    }
    if !unit.is_zero() {
        scope.analytic.exponential = Some((Var(scope.names.len()), unit.clone()));
        scope.names.push(format!("exp({unit})"));
    }
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
            return None;
        }
    }
    let range =
        range_of(scope, decl.name.span, decl.low.as_ref(), decl.high.as_ref(), &|| decl.name.text.clone())?;
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

/// The sum at an end of a range.
fn sum_of(scope: &Scope<'_>, value: &Linear, count: usize) -> Option<Fraction> {
    let mut sum = Fraction::constant(value.number.clone());
    for (var, factor, turns) in &value.parts {
        // A parameter that is no angle stands where it is declared.
        let angle = scope.analytic.angles.iter().any(|a| a.itself == *var);
        let var = if angle { *var } else { Var(var.0.checked_sub(count)?) };
        let mut part = &Fraction::constant(factor.clone()) * &Fraction::var(var);
        if *turns {
            part = &part * &Fraction::var(scope.analytic.pi?);
        }
        sum = &sum + &part;
    }
    if !value.pi.is_zero() {
        sum = &sum + &(&Fraction::constant(value.pi.clone()) * &Fraction::var(scope.analytic.pi?));
    }
    Some(sum)
}

/// A domain variable whose ends contain shape parameters or π: y runs from 0 to 1.
fn linear(
    scope: &mut Scope<'_>,
    decl: &RangeDecl,
    at: &Place,
    limits: &Limits,
    count: usize,
    (known, constraints): (&[Parameter], &[Constraint]),
) -> Option<Range> {
    let name = &decl.name.text;
    let [Some(low), Some(high)] = limits else {
        let error = scope.error(decl.name.span, format!("the domain of `{name}` has no end on one side"));
        scope.report(error.help("write both ends, such as `domain 0 <= t <= α;`"));
        return None;
    };
    let (first, last) = (sum_of(scope, &low.value, count)?, sum_of(scope, &high.value, count)?);
    let width = &last - &first;
    let ranges = known.iter().map(|p| (p.var, p.range.clone())).chain(ranges(scope));
    let region = Region { ranges: ranges.listed() };
    if let Err(text) = scope.is_positive(&width, &region, constraints) {
        let message = format!("the ends of the domain of `{name}` are not in order");
        let error = scope.error(decl.name.span, message).label(text);
        scope.report(
            error.help("narrow the ranges of the parameters so that the lower end is below the upper one"),
        );
        return None;
    }
    let new = Angle {
        name: name.clone(),
        kind: Kind::Linear,
        var: at.slot,
        itself: at.itself,
        rate: Rational::ONE,
        turns: false,
        shift: Rational::ZERO,
        low: first.clone(),
        width,
        limits: [first.clone(), last.clone()],
        ends: [low.text.clone(), high.text.clone()],
        declared: declared(name, limits),
        mirror: Vec::new(),
    };
    let own = |f: &Fraction| {
        let text = f.display(&scope.names);
        if text.contains([' ', '*', '/']) { format!("({text})") } else { text }
    };
    let (from, width) = (first.display(&scope.names), own(&new.width));
    scope.names[at.slot.0] = match (new.low.is_zero(), from.strip_prefix('-')) {
        (true, _) => format!("{name}/{width}"),
        (false, Some(below)) if !below.contains(' ') => format!("({name} + {below})/{width}"),
        _ => format!("({name} - {})/{width}", own(&first)),
    };
    scope.analytic.angles.push(new);
    scope.ends.push((Fraction::zero(), Fraction::constant(Rational::ONE)));
    let end = |l: &Bound, x: Rational| if l.included { End::Included(x) } else { End::Excluded(x) };
    Some(Range { low: end(low, Rational::ZERO), high: end(high, Rational::ONE) })
}

/// ψ/π at an end of a range that is a multiple of π, or of 1 where the rate is one of π.
fn psi(rate: &Rational, turns: bool, shift: &Rational, end: &Bound) -> Rational {
    &(if turns { &end.value.number } else { &end.value.pi } - shift) * rate
}

/// Angles in the domain from which others can be measured: sin and cos of all multiples of them are 0, 1 or −1. First 0.
fn shifts(unit: &Rational, turns: bool, ends: &[&Bound]) -> Vec<Rational> {
    const MOST: i64 = 32;
    let mut all = vec![Rational::ZERO];
    let value = |l: &Bound| if turns { l.value.number.clone() } else { l.value.pi.clone() };
    let ([low, high], Some(step)) = (ends, (unit + unit).recip()) else { return all };
    let first = value(low).checked_div(&step).map_or(Rational::ZERO, |n| -(-n).floor());
    for k in 0..MOST {
        let shift = &(&first + &Rational::from(k)) * &step;
        if shift <= value(high) && !shift.is_zero() {
            all.push(shift);
        }
    }
    all
}

/// Whether `rate` times an end that holds shape parameters is less than a quarter turn at all their values.
fn stays_finite(scope: &Scope<'_>, rate: &Rational, end: &Bound, known: &[Parameter]) -> bool {
    let value = &end.value;
    let mut reached = true;
    if let ([(var, factor, _)], true) = (&value.parts[..], value.pi.is_zero() && value.number.is_zero()) {
        // Of one parameter alone it is known from its own range.
        let Some(angle) = scope.analytic.angles.iter().find(|a| a.itself == *var) else { return false };
        if angle.rate == rate * &factor.abs() {
            return true;
        }
        let own = known.iter().find(|parameter| parameter.var == angle.var);
        reached = own.is_none_or(|own| {
            [&own.range.low, &own.range.high]
                .iter()
                .any(|end| matches!(end, End::Included(x) if !x.is_zero()))
        });
    }
    // In units of π; where an end of a range is no multiple of it, nothing is known.
    let Some(pi) = scope.analytic.pi else { return false };
    let mut sum = value.pi.abs();
    for (var, factor, _) in &value.parts {
        let Some(angle) = scope.analytic.angles.iter().find(|a| a.itself == *var) else { return false };
        let mut largest = Rational::ZERO;
        for limit in &angle.limits {
            let Some(multiple) = limit.derivative(pi).as_constant() else { return false };
            if *limit != &Fraction::var(pi) * &Fraction::constant(multiple.clone()) {
                return false;
            }
            largest = largest.max(multiple.abs());
        }
        sum += &(&largest * &factor.abs());
    }
    let (turned, quarter) = (rate * &sum, Rational::new(1, 2));
    value.number.is_zero() && (turned < quarter || turned == quarter && !reached)
}

/// Makes a variable an angle; the range of y.
fn angle(
    scope: &mut Scope<'_>,
    decl: &RangeDecl,
    at: &Place,
    of: &Use,
    limits: &Limits,
    (all, count, known): (&[Option<Use>], usize, &[Parameter]),
    conditions: &mut Vec<Constraint>,
) -> Option<Range> {
    let name = &decl.name.text;
    let ends: Vec<&Bound> = limits.iter().flatten().listed();
    let circular = of.kind == Kind::Circular;
    let wrong = |scope: &Scope<'_>, message: String, help: &str| {
        scope.report(scope.error(decl.name.span, message).help(help));
    };
    if (at.is_domain || circular) && ends.len() < 2 {
        let help = if at.is_domain {
            "write both ends, such as `domain 0 <= t <= pi/2;`"
        } else {
            "write both ends, such as `shape 0 < α < pi;`"
        };
        wrong(scope, format!("the range of `{name}` has no end on one side"), help);
        return None;
    }
    let parametric: Vec<&(Var, Rational, bool)> = ends.iter().flat_map(|l| &l.value.parts).listed();
    if !at.is_domain && !parametric.is_empty() {
        wrong(
            scope,
            format!("the range of `{name}` depends on another parameter"),
            "give it numbers as ends",
        );
        return None;
    }
    let half = Rational::new(1, 2);
    // The rate: half of the unit, or a part of that, so that the tangent is finite, and rational at the ends; else what
    // takes their place.
    let mut chosen = None;
    let mut edges: [Option<Edge>; 2] = [None, None];
    if parametric.is_empty() {
        if circular && !of.turns && at.is_domain {
            let proper = |l: &&Bound| {
                l.value.number.is_zero()
                    && (&l.value.pi + &l.value.pi).is_integer()
                    && l.value.pi.abs() <= Rational::ONE
            };
            if let Some(end) = ends.iter().find(|l| !proper(l)) {
                let help = "ends of an angle are multiples of `pi/2` from `-pi` to `pi`, or a shape parameter: `shape 0 < α < pi; domain 0 <= θ <= α;`";
                wrong(
                    scope,
                    format!(
                        "the end {} of the angle `{name}` is not a multiple of pi/2 between -pi and pi",
                        end.text
                    ),
                    help,
                );
                return None;
            }
        }
        if circular && !of.turns && !at.is_domain {
            let proper = |l: &&Bound| l.value.number.is_zero() && l.value.pi.abs() <= Rational::ONE;
            if let Some(end) = ends.iter().find(|l| !proper(l)) {
                let help =
                    "ends of an angle are 0 and rational multiples of `pi` up to `pi`: `shape 0 < α < pi;`";
                wrong(
                    scope,
                    format!("the end {} of the angle `{name}` is not a multiple of pi", end.text),
                    help,
                );
                return None;
            }
        }
        let shifts =
            if circular && at.is_domain { shifts(&of.unit, of.turns, &ends) } else { vec![Rational::ZERO] };
        'search: for m in 1..=8 {
            let rate = &(&of.unit * &half) * &Rational::new(1, m);
            for shift in &shifts {
                let finite = |l: &&Bound| {
                    let psi = psi(&rate, of.turns, shift, l).abs();
                    psi < half || psi == half && !l.included && !at.is_domain && !of.beside
                };
                if circular && !ends.iter().all(finite) {
                    continue;
                }
                let mut tangents =
                    ends.iter().map(|l| Tangent::of(of.kind, &rate, of.turns, shift, &l.value));
                if !circular || !tangents.any(|t| matches!(t, Tangent::Irrational)) {
                    chosen = Some((rate, shift.clone()));
                    break 'search;
                }
            }
        }
        if chosen.is_none() && circular && !at.is_domain && !of.turns {
            let mut rates = (1..=8).map(|m| &(&of.unit * &half) * &Rational::new(1, m));
            let found = rates.find_map(|rate| Some((irrational_ends(at.slot, &rate, &ends)?, rate)));
            if let Some((found, rate)) = found {
                edges = found;
                chosen = Some((rate, Rational::ZERO));
            }
        }
        if chosen.is_none() {
            let texts: Vec<&str> = ends.mapped(|l| l.text.as_str());
            wrong(
                scope,
                format!(
                    "the functions of `{name}` have irrational values at the ends {} of its range",
                    texts.join(" and ")
                ),
                if at.is_domain {
                    "choose ends at which half of the smallest angle is a multiple of pi/4; a shape parameter may also be the end of the domain, `shape 0 < α <= pi/2; domain 0 <= t <= α;`"
                } else {
                    "let the range begin at 0, or choose ends at which half of the smallest angle is a multiple of pi/4"
                },
            );
            return None;
        }
    } else {
        // The rates of the parameters have been found: that of the variable is a multiple of them.
        let mut rates: Vec<(Rational, Rational)> = Vec::new();
        for (var, factor, _) in &parametric {
            let shape = all.get(var.0.checked_sub(count)?)?;
            shape.as_ref()?;
            let angle = scope.analytic.angles.iter().find(|a| a.itself == *var)?;
            rates.push((angle.rate.clone(), factor.abs()));
        }
        // The least common multiple of those that the ends ask for.
        let mut least: Option<Rational> = None;
        for (rate, factor) in &rates {
            let wanted = rate.checked_div(factor)?;
            least = Some(match &least {
                Some(known) => (known * &wanted).checked_div(&known.gcd(&wanted))?,
                None => wanted,
            });
        }
        let least = least?;
        let goes = |rate: &Rational| {
            let multiple = |(own, factor): &(Rational, Rational)| (rate * factor).checked_div(own);
            !of.turns && rates.iter().all(|known| multiple(known).is_some_and(|n| n.is_integer()))
        };
        // Where the variable is used with larger factors than the parameter, its rate is larger, too, if its tangent is
        // finite then.
        let own = (&of.unit * &half).checked_div(&least)?;
        let rate = match own.to_i64() {
            Some(n) if n > 1 && !of.beside => {
                let rate = &least * &own;
                let finite = ends.iter().all(|l| !circular || stays_finite(scope, &rate, l, known));
                if goes(&rate) && finite { rate } else { least }
            }
            _ => least,
        };
        if !goes(&rate) {
            wrong(
                scope,
                format!("the ends of the domain of `{name}` are not multiples of one angle"),
                "write `domain 0 <= t <= α;` or `domain -α <= t <= α;`",
            );
            return None;
        }
        // Beyond a quarter turn the tangent is another one.
        if let Some(end) = ends.iter().find(|l| circular && !stays_finite(scope, &rate, l, known)) {
            let reach = multiple_of_pi(&half.checked_div(&rate)?);
            wrong(
                scope,
                format!("the end {} of the angle `{name}` can be {reach} or more", end.text),
                "make one shape parameter the whole angle, `domain 0 <= t <= α;`, or narrow the ranges",
            );
            return None;
        }
        chosen = Some((rate, Rational::ZERO));
    }
    let (rate, shift) = chosen?;
    let one = Fraction::constant(Rational::ONE);
    let mut new = Angle {
        name: name.clone(),
        kind: of.kind,
        var: at.slot,
        itself: at.itself,
        rate,
        turns: of.turns,
        shift,
        low: Fraction::zero(),
        width: one.clone(),
        limits: [0, 1].map(|k| {
            limits[k].as_ref().and_then(|l| sum_of(scope, &l.value, count)).unwrap_or_else(Fraction::zero)
        }),
        ends: [0, 1].map(|k| limits[k].as_ref().map_or_else(String::new, |l| l.text.clone())),
        declared: declared(name, limits),
        mirror: Vec::new(),
    };
    scope.names[at.slot.0] = new.tangent_name();
    let exact = parametric.is_empty() && (circular || ends.iter().all(|l| l.value.number.is_zero()));
    let range = if exact {
        let end = |side: usize| match &limits[side] {
            Some(l) if edges[side].is_some() => {
                let beyond = edges[side].as_ref().map_or(Rational::ZERO, |edge| edge.beyond.clone());
                if l.included { End::Included(beyond) } else { End::Excluded(beyond) }
            }
            None => {
                // Only of a hyperbolic parameter.
                End::Excluded(Rational::from(if side == 0 { -1 } else { 1 }))
            }
            Some(l) => match Tangent::of(new.kind, &new.rate, new.turns, &new.shift, &l.value) {
                Tangent::Exact(x) if l.included => End::Included(x),
                Tangent::Exact(x) => End::Excluded(x),
                Tangent::Infinite | Tangent::Irrational => End::Infinite,
            },
        };
        Range { low: end(0), high: end(1) }
    } else if !at.is_domain {
        wrong(
            scope,
            format!("the end of the range of `{name}` has an irrational tangent"),
            "a parameter in `exp`, `sinh` or `cosh` has 0 or no end: `shape 0 < α;`",
        );
        return None;
    } else {
        // x = low + width·y
        let mut values = Vec::new();
        for l in &ends {
            let mut sum = Fraction::constant(l.value.number.clone());
            for (var, factor, _) in &l.value.parts {
                sum = &sum + &(&Fraction::constant(factor.clone()) * &Fraction::var(*var));
            }
            if let Some(pi) = scope.analytic.pi {
                sum = &sum + &(&Fraction::constant(l.value.pi.clone()) * &Fraction::var(pi));
            }
            match scope.angle_at(&new, &sum, decl.name.span) {
                Ok(x) => values.push(x?),
                Err((message, help)) => {
                    wrong(scope, message, &help);
                    return None;
                }
            }
        }
        if !ordered(scope, &ends, known) {
            wrong(
                scope,
                format!("the ends of the domain of `{name}` could not be proved to be in order"),
                "let the parameter at the end be positive: `shape 0 < α < pi; domain 0 <= t <= α;`",
            );
            return None;
        }
        new.low = values.first()?.clone();
        new.width = values.last()? - &new.low;
        // In brackets, as powers of it may be written.
        let (x, low, high) = (new.tangent_name(), of_end(&new, ends[0]), of_end(&new, ends[1]));
        scope.names[at.slot.0] = if new.low.is_zero() {
            format!("({x}/{high})")
        } else {
            format!("(({x} - {low})/({high} - {low}))")
        };
        let end = |l: &Bound, x: Rational| if l.included { End::Included(x) } else { End::Excluded(x) };
        Range { low: end(ends[0], Rational::ZERO), high: end(ends[1], Rational::ONE) }
    };
    if range.is_empty() || at.is_domain && range.finite().is_none_or(|(a, b)| a >= b) {
        wrong(scope, format!("the range of `{name}` is empty"), "write the smaller end first");
        return None;
    }
    scope.analytic.angles.push(new);
    for (edge, limit) in edges.into_iter().zip(limits) {
        let (Some(edge), Some(limit)) = (edge, limit) else { continue };
        let relation = if limit.included { Relation::NonNegative } else { Relation::Positive };
        let text = declared(name, limits);
        conditions.push(Constraint { value: edge.inside, relation, text, is_end: true });
    }
    Some(range)
}

/// What takes the place of ends whose tangents are irrational; `None` where a tangent is infinite, or the conditions are
/// not.
fn irrational_ends(var: Var, rate: &Rational, ends: &[&Bound]) -> Option<[Option<Edge>; 2]> {
    let [low, high] = ends else { return None };
    let psi = [low, high].map(|l| psi(rate, false, &Rational::ZERO, l));
    let is_finite = |psi: &Rational| psi.abs() < Rational::new(1, 2);
    let mut edges = [None, None];
    for side in 0..2 {
        if !is_finite(&psi[side]) || !is_finite(&psi[1 - side]) {
            return None;
        }
        if !(&psi[side] * &Rational::from(4)).is_integer() {
            edges[side] = Some(edge(var, &psi[side], &psi[1 - side])?);
        }
    }
    Some(edges)
}

/// x at an end of the range, for reading, such as `tan(α/2)`, `tanh(1)` or `(a + h)`.
fn of_end(angle: &Angle, end: &Bound) -> String {
    let Linear { number, pi, parts } = &end.value;
    let alone = parts.is_empty() && angle.shift.is_zero() && !angle.turns;
    match angle.kind {
        Kind::Hyperbolic if alone && pi.is_zero() => format!("tanh({})", number * &angle.rate),
        Kind::Circular if alone && number.is_zero() => {
            format!("tan({})", multiple_of_pi(&(pi * &angle.rate)))
        }
        _ => {
            let sum = end.text.contains(' ');
            let name = if sum { format!("({})", end.text) } else { end.text.clone() };
            Angle { name, ..angle.clone() }.tangent_name()
        }
    }
}

/// Whether the upper of two ends is above the lower one for all values of the parameters.
fn ordered(scope: &Scope<'_>, ends: &[&Bound], known: &[Parameter]) -> bool {
    let [low, high] = ends else { return false };
    let mut width = high.value.clone();
    let turned = low.value.scaled(&Rational::from(-1));
    width.pi += &turned.pi;
    width.number += &turned.number;
    for (var, factor, _) in &turned.parts {
        match width.parts.iter_mut().find(|(v, ..)| v == var) {
            Some((_, known, _)) => *known += factor,
            None => width.parts.push((*var, factor.clone(), false)),
        }
    }
    if width.pi.is_negative() || width.number.is_negative() {
        return false;
    }
    // Parameters with a range above 0.
    let positive = |var: Var| {
        let angle = scope.analytic.angles.iter().find(|a| a.itself == var);
        let range = known.iter().find(|p| angle.is_some_and(|a| a.var == p.var)).map(|p| &p.range);
        range.is_some_and(|r| match &r.low {
            End::Included(low) => low.is_positive(),
            End::Excluded(low) => !low.is_negative(),
            End::Infinite => false,
        })
    };
    let some = width.pi.is_positive()
        || width.number.is_positive()
        || width.parts.iter().any(|(_, f, _)| f.is_positive());
    some && width.parts.iter().all(|(var, f, _)| !f.is_negative() && positive(*var))
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
        if let Ok(Some(y)) = scope.angle_at(&angle, &reversed, Span::call_site()) {
            scope.analytic.angles[position].mirror = vec![(angle.var, y), (angle.itself, reversed)];
        }
    }
    Some(())
}

/// Limits of π and exp(r).
fn ranges(scope: &Scope<'_>) -> Vec<(Var, Range)> {
    let open =
        |(low, high): (Rational, Rational)| Range { low: End::Excluded(low), high: End::Excluded(high) };
    let mut all = Vec::new();
    if let Some(pi) = scope.analytic.pi {
        all.push((pi, open(pi_bounds())));
    }
    if let Some((var, exponent)) = &scope.analytic.exponential
        && let Some(bounds) = exponential_bounds(exponent)
    {
        all.push((*var, open(bounds)));
    }
    all
}

/// Numbers below and above π, from π = 16 arctan(1/5) − 4 arctan(1/239).
fn pi_bounds() -> (Rational, Rational) {
    // The partial sums of an alternating series lie on both sides of its value.
    let arctan = |n: i64, terms: u32| {
        let x = Rational::new(1, n);
        (0..terms).fold(Rational::ZERO, |sum, k| {
            let term = &x.pow(2 * k + 1) * &Rational::new(1, i64::from(2 * k + 1));
            if k % 2 == 0 { &sum + &term } else { &sum - &term }
        })
    };
    let bound = |terms: u32| {
        let (a, b) = (arctan(5, terms), arctan(239, terms + 1));
        &(&Rational::from(16) * &a) - &(&Rational::from(4) * &b)
    };
    (bound(16), bound(15))
}

/// Numbers below and above exp(r), r > 0, from the series of exp(r/2^k), r/2^k ≤ 1/2; `None` for large r.
fn exponential_bounds(r: &Rational) -> Option<(Rational, Rational)> {
    const TERMS: u32 = 16;
    let half = Rational::new(1, 2);
    let (mut x, mut squarings) = (r.clone(), 0);
    while x > half {
        x = &x * &half;
        squarings += 1;
        if squarings > 6 {
            return None;
        }
    }
    let (mut term, mut low) = (Rational::ONE, Rational::ONE);
    for k in 1..=TERMS {
        term = &(&term * &x) * &Rational::new(1, i64::from(k));
        low += &term;
    }
    // The rest of the series is less than its first term times 2.
    let high = &low + &(&term + &term);
    Some(
        (0..squarings).fold((low, high), |(a, b), _| (rounded(&(&a * &a), false), rounded(&(&b * &b), true))),
    )
}

/// A number with 80 binary digits after the point, not above or not below another one.
fn rounded(x: &Rational, up: bool) -> Rational {
    let unit = Rational::from(2).pow(80);
    let scaled = (x * &unit).floor();
    let scaled = if up { &scaled + &Rational::ONE } else { scaled };
    scaled.checked_div(&unit).unwrap_or_else(|| x.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_lie_between_their_bounds() {
        let (low, high) = pi_bounds();
        assert!(low.to_f64() <= core::f64::consts::PI && core::f64::consts::PI <= high.to_f64());
        assert!(low < high && &high - &low < Rational::from(10).pow(18).recip().unwrap());
        for r in [Rational::new(1, 7), Rational::ONE, Rational::from(3), Rational::from(20)] {
            let (low, high) = exponential_bounds(&r).expect("not too large");
            let x = r.to_f64().exp();
            assert!(low.to_f64() <= x * (1.0 + 1e-14) && x * (1.0 - 1e-14) <= high.to_f64(), "{r}");
            assert!((&high - &low).to_f64() < 1e-9 * x, "{r}");
        }
    }
}
