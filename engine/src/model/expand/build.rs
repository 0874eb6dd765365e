//! Expands a family as it is written into exact functions.

use proc_macro2::Span;

use super::domain::domain;
use super::{angles, claims, functions, names, occurs, shapes};
use crate::algebra::fraction::{Fraction, set_known_factors};
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::diagnostic::{Diagnostics, Place};
use crate::model::angle::Anew;
use crate::model::budget::SPLIT;
use crate::model::formula::numbers::budget_value;
use crate::model::scope::{Scope, Stage};
use crate::model::{Family, Function, Library};
use crate::source::SourceId;
use crate::syntax::{self, Factor, StatementKind};
use basis_prover::collections::list::Listed;

/// Expands a family of one order on one span; `span` is its number among how many, `anew` with what it is expanded anew.
pub(super) fn piece<'a>(
    library: &'a Library<'a>,
    (unit, source): (usize, SourceId),
    written: &'a syntax::Family,
    order: &[i64],
    span: Option<(usize, usize)>,
    anew: &Anew,
) -> (Option<Family>, Diagnostics) {
    let mut scope = Scope::new(library, unit, source);
    scope.anew.clone_from(anew);
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
            StatementKind::Product(factors) => {
                scope.coming.extend(factors.iter().flat_map(Factor::names).map(|name| name.text.clone()));
            }
            _ => {}
        }
    }
    set_known_factors(Vec::new());
    // All statements are looked through, for each span again.
    let statements = written.statements.len() as u64 / 2;
    scope.within(scope.budget.step(statements), written.name.span, SPLIT)?;
    let (shapes, domain) = if let Some(place) = occurs::first(written) {
        match angles::declare(scope, written, place) {
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
        // Loops and conditions that were reported leave no functions over.
        if scope.cut_short || !scope.diagnostics.borrow().is_empty() {
            return None;
        }
        let error =
            scope.error(written.name.span, format!("the family `{}` has no functions", written.name.text));
        scope.report(error.help("write `b[0] = …;`, or `b[i] = … for i in 0..=n;`"));
        return None;
    }
    functions::check_indices(scope, written);
    let (shapes, (domain, simplices)) = (shapes?, domain?);
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
        simplices,
        analytic: scope.analytic.clone(),
        function_name: scope.function_name.clone(),
        written: lines_of_functions(scope, written, functions.len()),
        functions,
        over,
        pieces: Vec::new(),
        base: core::mem::take(&mut scope.base),
        nonnegative: Vec::new(),
        truncations: None,
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
    // As polynomials, of which it is a multiple of all denominators: numbers in it are variables.
    scope.budget.set_roots(&[]);
    for f in functions {
        let denom = Fraction::from(f.value.denom().clone());
        // Of m/d in lowest terms the numerator is what of m is not in d.
        let rest = scope.fits(scope.budget.div(&denom, &over), span)?;
        over = scope.fits(scope.budget.mul(&over, &Fraction::from(rest.numer().clone())), span)?;
    }
    scope.budget.set_roots(&scope.analytic.roots);
    Some(over.numer().normalized())
}

fn budget(scope: &mut Scope<'_>, written: &syntax::Family) -> u32 {
    let mut budget = 1;
    for statement in &written.statements {
        let StatementKind::Budget(value) = &statement.kind else { continue };
        budget = names::attempt(scope, &mut |scope| budget_value(scope, value)).unwrap_or(budget);
    }
    budget
}

/// The lines of the statements that define functions outside of `base`; none where each of them has a statement of its
/// own and can be read from its expanded form, without angles and exponentials, or where the spec is no text.
fn lines_of_functions(scope: &Scope<'_>, written: &syntax::Family, functions: usize) -> Vec<String> {
    /// More lines explain nothing.
    const MOST: usize = 40;
    let defines =
        |s: &&syntax::Statement| matches!(s.kind, StatementKind::Function(_) | StatementKind::Raise(_));
    let statements = written.statements.iter().filter(defines).listed();
    let mut lines = Vec::new();
    if statements.len() == functions && scope.analytic.is_empty() {
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
