//! Expands a family as it is written into exact functions.

use proc_macro2::Span;

use super::{angles, claims, functions, indices, names, shapes, spans};
use crate::algebra::fraction::{Fraction, set_known_factors};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::diagnostic::{Diagnostics, Place};
pub(super) use crate::model::formula::numbers::checked_range;
use crate::model::formula::numbers::{budget_value, range_of};
use crate::model::scope::{Scope, Stage};
use crate::model::{Family, Function, Library, Parameter};
use crate::source::SourceId;
use crate::syntax::{self, Name, RangeDecl, StatementKind};
use basis_prover::collections::list::{Listed, Mapped};

/// Expands a family of one order; `None`, or anything with messages, cannot be used.
pub(crate) fn family<'a>(
    library: &'a Library<'a>,
    unit: usize,
    source: SourceId,
    written: &'a syntax::Family,
    order: &[i64],
) -> (Option<Family>, Diagnostics) {
    match spans::spans(written) {
        Some(decls) => spans::family(library, (unit, source), written, order, decls),
        None => piece(library, (unit, source), written, order, None),
    }
}

/// Expands a family of one order on one span; `span` is its number among how many.
pub(super) fn piece<'a>(
    library: &'a Library<'a>,
    (unit, source): (usize, SourceId),
    written: &'a syntax::Family,
    order: &[i64],
    span: Option<(usize, usize)>,
) -> (Option<Family>, Diagnostics) {
    let mut scope = Scope::new(library, unit, source);
    scope.span = span;
    scope.constants = written.orders.iter().zip(order).map(|(g, v)| (g.name.text.clone(), *v)).listed();
    scope.order = scope.constants.len();
    names::plan(&mut scope, written);
    let result = build(&mut scope, written);
    (result, scope.diagnostics.into_inner())
}

fn build<'a>(scope: &mut Scope<'a>, written: &'a syntax::Family) -> Option<Family> {
    scope.unread.clone_from(&written.unread);
    for statement in &written.statements {
        match &statement.kind {
            StatementKind::Domain(ranges) => {
                scope.coming.extend(ranges.iter().map(|range| range.name.text.clone()));
            }
            StatementKind::Simplex(names) => scope.coming.extend(names.iter().map(|name| name.text.clone())),
            _ => {}
        }
    }
    set_known_factors(Vec::new());
    let (shapes, domain) = if angles::occur(written) {
        match angles::declare(scope, written) {
            Some((shapes, domain)) => {
                set_known_factors(scope.analytic.denominators());
                (Some(shapes), Some(domain))
            }
            // Nothing has a meaning without the angles.
            None => return None,
        }
    } else {
        (shapes::shapes(scope, written), domain(scope, written))
    };
    let budget = budget(scope, written);
    scope.cut_short |= written.incomplete;
    functions::define(scope, written);
    if scope.functions.is_empty() {
        if scope.cut_short {
            return None;
        }
        let error =
            scope.error(written.name.span, format!("the family `{}` has no functions", written.name.text));
        scope.report(error.help("write `b[0] = …;`, or `b[i] = … for i in 0..=n;`"));
        return None;
    }
    indices::check_indices(scope, written);
    let (shapes, (domain, dependent)) = (shapes?, domain?);
    // A function whose formula went wrong is left out here; the family is then not used, except to look for
    // more mistakes in its claims.
    let functions: Vec<Function> = scope
        .functions
        .iter()
        .filter_map(|(index, value)| Some(Function { index: index.clone(), value: value.clone()? }))
        .listed();
    for f in &functions {
        scope.fits(scope.budget.run().keep(&f.value), written.name.span)?;
    }
    let whole = functions.len() == scope.functions.len() && !scope.cut_short;
    let over = common_denominator(scope, &functions, written.name.span)?;
    let mut family = Family {
        name: written.name.text.clone(),
        doc: written.doc.clone(),
        order: scope.constants.clone(),
        source: scope.source,
        place: scope.place(written.name.span),
        names: scope.names.clone(),
        shapes: shapes.parameters,
        constraints: shapes.constraints,
        determined: scope.determined.clone(),
        domain,
        dependent,
        analytic: scope.analytic.clone(),
        function_name: scope.function_name.clone(),
        written: lines_of_functions(scope, written, functions.len()),
        functions,
        over,
        pieces: Vec::new(),
        base: core::mem::take(&mut scope.base),
        obligations: Vec::new(),
        budget,
    };
    scope.settle(&|shapes_only| family.parts(shapes_only), family.budget);
    family.obligations = core::mem::take(&mut scope.obligations);
    if whole && scope.diagnostics.borrow().is_empty() {
        return Some(family);
    }
    scope.stage = Stage::Broken;
    claims::look_for_mistakes(scope, written, &family);
    None
}

/// The least common multiple of the denominators of functions, if a domain variable occurs in one of them; otherwise 1.
fn common_denominator(scope: &Scope<'_>, functions: &[Function], span: Span) -> Option<Poly> {
    let rational = |f: &Function| scope.is_over_domain(&Fraction::from(f.value.denom().clone()));
    let mut over = Fraction::constant(Rational::ONE);
    // On several spans a function has one factor on all of them.
    let several = scope.span.is_some() && functions.iter().any(|f| f.value.as_poly().is_none());
    if !several && !functions.iter().any(rational) {
        return Some(Poly::one());
    }
    for f in functions {
        let denom = Fraction::from(f.value.denom().clone());
        // Of m/d in lowest terms the numerator is what of m is not in d.
        let rest = scope.fits(scope.budget.div(&denom, &over), span)?;
        over = scope.fits(scope.budget.mul(&over, &Fraction::from(rest.numer().clone())), span)?;
    }
    Some(over.numer().normalized())
}

/// The range of the span that is expanded.
pub(super) fn of_span<'d>(scope: &Scope<'_>, decls: &'d [RangeDecl]) -> &'d [RangeDecl] {
    scope.span.and_then(|(k, _)| decls.get(k..=k)).unwrap_or(decls)
}

/// The independent domain variables, and the last barycentric coordinate of a simplex.
pub(super) type Domain = (Vec<Parameter>, Option<Parameter>);

/// The domain variables come after the shape parameters: the independent ones, and the last barycentric
/// coordinate of a simplex.
pub(super) fn domain(scope: &mut Scope<'_>, written: &syntax::Family) -> Option<Domain> {
    let mut found: Option<(Span, Option<Domain>)> = None;
    for statement in &written.statements {
        if !matches!(statement.kind, StatementKind::Domain(_) | StatementKind::Simplex(_)) {
            continue;
        }
        if let Some((first, _)) = &found {
            let first = scope.place(*first);
            let error = scope
                .error(statement.span, "the domain is declared twice")
                .also(first, "first declared here");
            scope.report(
                error.help("list several variables in one statement: `domain 0 <= u <= 1, 0 <= v <= 1;`"),
            );
            continue;
        }
        let domain = match &statement.kind {
            StatementKind::Domain(decls) => {
                let decls = of_span(scope, decls);
                intervals(scope, decls, &statement.doc).map(|list| (list, None))
            }
            StatementKind::Simplex(names) => simplex(scope, names, &statement.doc),
            _ => None,
        };
        found = Some((statement.span, domain));
    }
    match found {
        Some((_, domain)) => domain,
        // The domain may be what could not be read.
        None if written.incomplete => None,
        None => {
            let error =
                scope.error(written.name.span, format!("the family `{}` has no domain", written.name.text));
            scope.report(error.help("write `domain 0 <= t <= 1;`"));
            None
        }
    }
}

fn intervals(scope: &mut Scope<'_>, decls: &[RangeDecl], doc: &[String]) -> Option<Vec<Parameter>> {
    let mut domain = Some(Vec::new());
    for decl in decls {
        let range = range(scope, decl);
        let variable = variable(scope, &decl.name);
        let bounded = range.filter(|range| {
            let bounded = range.finite().is_some_and(|(a, b)| a < b);
            if !bounded {
                let name = &decl.name.text;
                let error = match range.finite() {
                    Some((a, b)) if a == b => scope
                        .error(decl.name.span, format!("the domain of `{name}` is a single point"))
                        .help(format!("let the upper end be above {a}")),
                    _ => {
                        let end = |end: &End, other: &str| {
                            end.value().map_or_else(|| String::from(other), Rational::to_string)
                        };
                        let (a, b) = (end(&range.low, "0"), end(&range.high, "1"));
                        scope
                            .error(decl.name.span, format!("the domain of `{name}` has no end on one side"))
                            .help(format!("write both ends, such as `domain {a} <= {name} <= {b};`"))
                    }
                };
                scope.report(error);
            }
            bounded
        });
        match (bounded, variable, &mut domain) {
            (Some(range), Some(var), Some(list)) => {
                scope.domain.push(var);
                if let Some((low, high)) = range.finite() {
                    scope.ends.push((Fraction::constant(low.clone()), Fraction::constant(high.clone())));
                }
                let place = scope.place(decl.name.span);
                list.push(Parameter { name: decl.name.text.clone(), doc: doc.to_vec(), place, var, range });
            }
            (_, var, _) => {
                scope.domain.extend(var);
                domain = None;
            }
        }
    }
    domain
}

fn simplex(scope: &mut Scope<'_>, names: &[Name], doc: &[String]) -> Option<Domain> {
    let mut all = Vec::new();
    for name in names {
        let var = variable(scope, name)?;
        scope.domain.push(var);
        let place = scope.place(name.span);
        all.push(Parameter { name: name.text.clone(), doc: doc.to_vec(), place, var, range: Range::unit() });
    }
    let last = all.pop()?;
    scope.domain = all.mapped(|p| p.var);
    scope.dependent = Some(last.var);
    Some((all, Some(last)))
}

/// The most shape parameters and domain variables of a family.
const MAX_VARIABLES: usize = 64;

/// A new variable, unless the name is taken.
pub(super) fn variable(scope: &mut Scope<'_>, name: &Name) -> Option<Var> {
    if scope.names.len() >= MAX_VARIABLES {
        if scope.names.len() == MAX_VARIABLES {
            // A name that nothing can have: said once, and unknown names are those that have no room.
            scope.names.push(String::new());
            scope.unread.insert(0, String::new());
            let message =
                format!("a family has at most {MAX_VARIABLES} shape parameters and domain variables");
            scope.report(scope.error(name.span, message));
        }
        return None;
    }
    if !scope.check_free(name) {
        return None;
    }
    let var = Var(scope.names.len());
    scope.names.push(name.text.clone());
    Some(var)
}

fn budget(scope: &mut Scope<'_>, written: &syntax::Family) -> u32 {
    let mut budget = 1;
    for statement in &written.statements {
        let StatementKind::Budget(value) = &statement.kind else { continue };
        budget = names::attempt(scope, &mut |scope| budget_value(scope, value)).unwrap_or(budget);
    }
    budget
}

/// The declared range, with exact ends.
fn range(scope: &mut Scope<'_>, decl: &RangeDecl) -> Option<Range> {
    names::attempt(scope, &mut |scope| {
        range_of(scope, decl.name.span, decl.low.as_ref(), decl.high.as_ref(), &|| decl.name.text.clone())
    })
}

/// The lines of the statements that define functions outside of `base`; none where each of them has a statement of its own, or the spec
/// is no text.
fn lines_of_functions(scope: &Scope<'_>, written: &syntax::Family, functions: usize) -> Vec<String> {
    /// More lines explain nothing.
    const MOST: usize = 40;
    let defines =
        |s: &&syntax::Statement| matches!(s.kind, StatementKind::Function(_) | StatementKind::Raise(_));
    let statements = written.statements.iter().filter(defines).listed();
    let mut lines = Vec::new();
    if statements.len() == functions {
        return lines;
    }
    let text = scope.library.sources().get(scope.source).text.as_deref().unwrap_or_default();
    for statement in statements {
        let Place::Text(_, range) = scope.place(statement.span) else { return Vec::new() };
        let statement = text.get(range).unwrap_or_default();
        for (k, line) in statement.trim_end_matches(';').lines().enumerate() {
            let line = line.trim();
            let indent = if k == 0 || line == "}" { "" } else { "    " };
            lines.push(format!("{indent}{line}"));
        }
    }
    // A fence would end the block in which the lines are shown.
    if lines.len() > MOST || lines.iter().any(|line| line.contains("```")) { Vec::new() } else { lines }
}
