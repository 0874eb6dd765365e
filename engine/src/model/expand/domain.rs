//! The domain of a family, without angles: intervals, simplices and their products.

use proc_macro2::Span;

use super::names;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::model::formula::numbers::range_of;
use crate::model::scope::Scope;
use crate::model::words::PI;
use crate::model::{Barycentric, Parameter};
use crate::syntax::{self, Factor, Name, RangeDecl, StatementKind};
use basis_prover::collections::list::Listed;

/// What stands where an end of an interval is no number.
const OF_INTERVALS: &str = "the ends of an interval in a domain of several variables are numbers; a triangle is `domain triangle (u, v, w);`, with w = 1 - u - v";

/// The range of the span that is expanded.
pub(super) fn of_span<'d>(scope: &Scope<'_>, decls: &'d [RangeDecl]) -> &'d [RangeDecl] {
    scope.span.and_then(|(k, _)| decls.get(k..=k)).unwrap_or(decls)
}

/// The independent domain variables, and the simplices among the factors.
pub(super) type Domain = (Vec<Parameter>, Vec<Barycentric>);

/// The domain variables come after the shape parameters: the independent ones, then the last barycentric coordinates of
/// simplices.
pub(super) fn domain(scope: &mut Scope<'_>, written: &syntax::Family) -> Option<Domain> {
    let mut found: Option<(Span, Option<Domain>)> = None;
    for statement in &written.statements {
        if !matches!(statement.kind, StatementKind::Domain(_) | StatementKind::Product(_)) {
            continue;
        }
        if let Some((first, _)) = &found {
            let first = scope.place(*first);
            let error = scope
                .error(statement.span, "the domain is declared twice")
                .also(first, "first declared here");
            scope.report(error.help(
                "list several variables in one statement, `domain 0 <= u <= 1, 0 <= v <= 1;`, and spans of one, `domain 0 <= t <= 1, 1 <= t <= 2;`",
            ));
            continue;
        }
        let domain = match &statement.kind {
            StatementKind::Domain(decls) => {
                let decls = of_span(scope, decls);
                intervals(scope, decls, &statement.doc).map(|list| (list, Vec::new()))
            }
            StatementKind::Product(factors) => product(scope, factors, &statement.doc),
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
            // Names without a meaning are most likely those of its variables.
            scope.cut_short = true;
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
                        let parameter = if scope.coming.len() == 1 && range.low.value().is_some() {
                            format!(", or let a shape parameter be the end: `shape {a} < c; domain {a} <= {name} <= c;`")
                        } else {
                            String::new()
                        };
                        scope
                            .error(decl.name.span, format!("the domain of `{name}` has no end on one side"))
                            .help(format!("write both ends, such as `domain {a} <= {name} <= {b};`{parameter}"))
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

/// The variables of a product, the last coordinate of each simplex after all independent ones.
fn product(scope: &mut Scope<'_>, factors: &[Factor], doc: &[String]) -> Option<Domain> {
    let names = factors.iter().flat_map(Factor::names).listed();
    for (k, name) in names.iter().enumerate() {
        if names[..k].iter().any(|other| other.text == name.text) {
            let error = scope.error(name.span, format!("`{}` is already a domain variable", name.text));
            scope.report(error.label("declared again here").help("choose another name"));
            // The others are known in formulas.
            for (k, name) in names.iter().enumerate() {
                if names[..k].iter().all(|other| other.text != name.text) {
                    let var = variable(scope, name);
                    scope.domain.extend(var);
                }
            }
            return None;
        }
    }
    let (mut domain, mut places) = (Vec::new(), Vec::new());
    let mut fine = true;
    for factor in factors {
        match factor {
            Factor::Range(decl) if !has_rational_ends(scope, decl) => {
                let var = variable(scope, &decl.name);
                scope.domain.extend(var);
                fine = false;
            }
            Factor::Range(decl) => match intervals(scope, core::slice::from_ref(decl), doc) {
                Some(own) => domain.extend(own),
                None => fine = false,
            },
            Factor::Simplex(names) => {
                let start = scope.domain.len();
                let (last, independent) = names.split_last()?;
                for name in independent {
                    domain.push(coordinate(scope, name, doc)?);
                    scope.domain.extend(domain.last().map(|p| p.var));
                    scope.ends.push((Fraction::zero(), Fraction::constant(Rational::ONE)));
                }
                places.push((start..scope.domain.len(), last));
            }
        }
    }
    let mut simplices = Vec::new();
    for (places, last) in places {
        simplices.push(Barycentric { places, last: coordinate(scope, last, doc)? });
    }
    scope.simplices.clone_from(&simplices);
    fine.then_some((domain, simplices))
}

/// Whether the ends of an interval beside a simplex are rational numbers; reports one that is not.
fn has_rational_ends(scope: &Scope<'_>, decl: &RangeDecl) -> bool {
    let varies = |name: &String| scope.variable(name).is_some() || PI.contains(&name.as_str());
    let Some(limit) = decl.low.iter().chain(&decl.high).find(|l| l.value.has_name(&varies)) else {
        return true;
    };
    let error =
        scope.error(limit.value.span, "the ends of an interval beside a simplex are rational numbers");
    let name = &decl.name.text;
    scope.report(error.help(format!(
        "write `-1 <= {name} <= 1`, and put in its place what runs from one end to the other"
    )));
    false
}

/// A barycentric coordinate.
fn coordinate(scope: &mut Scope<'_>, name: &Name, doc: &[String]) -> Option<Parameter> {
    let var = variable(scope, name)?;
    let place = scope.place(name.span);
    Some(Parameter { name: name.text.clone(), doc: doc.to_vec(), place, var, range: Range::unit() })
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

/// The declared range, with exact ends.
fn range(scope: &mut Scope<'_>, decl: &RangeDecl) -> Option<Range> {
    names::attempt(scope, &mut |scope| {
        let ends = (decl.low.as_ref(), decl.high.as_ref());
        range_of(scope, decl.name.span, ends, Some(OF_INTERVALS), &|| decl.name.text.clone())
    })
}
