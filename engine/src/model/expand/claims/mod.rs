//! From claims as they are written to what is claimed: of properties here, of equations and inequalities exact
//! differences (`relation`), with the shape values that a claim names (`values`).

mod relation;
mod values;

use std::rc::Rc;

use proc_macro2::Span;

use self::relation::{nothing_claimed, relation};
use self::values::{bound_text, describe_values, exceptions, neighbour};
use super::fixed::fixed;
use super::{names, spans};
use crate::algebra::fraction::set_known_factors;
use crate::claim::{Claim, ClaimKind, Joint, Statement};
#[cfg(not(any(test, feature = "rounding")))]
use crate::diagnostic::Diagnostic;
use crate::diagnostic::Diagnostics;
use crate::model::angle::Anew;
use crate::model::formula::print::Printer;
use crate::model::obligation::Obligation;
use crate::model::scope::Scope;
use crate::model::{Family, Library};
use crate::syntax::{self, Binding, StatementKind};
use basis_prover::collections::list::Mapped;

/// Statements of a family whose claims are asked for.
pub(super) struct Wanted<'g> {
    /// Their numbers, ascending.
    pub(super) numbers: Vec<usize>,
    /// With what the family is expanded.
    pub(super) anew: &'g Anew,
}

impl Wanted<'_> {
    /// Whether the statement with a number is among them.
    pub(super) fn has(&self, number: usize) -> bool {
        has(&self.numbers, number)
    }
}

/// Whether a number is among others, which are ascending.
pub(super) fn has(numbers: &[usize], number: usize) -> bool {
    numbers.binary_search(&number).is_ok()
}

/// The claims of a family on one span, which has a number among those of all.
///
/// Statements that turn out to be mistaken are no longer wanted: a mistake is reported once.
pub(super) fn on_span<'a>(
    library: &'a Library<'a>,
    (unit, written): (usize, &'a syntax::Family),
    family: &Family,
    spans: Option<(usize, &[Rc<Family>])>,
    wanted: &mut Wanted<'_>,
) -> (Vec<Claim>, Vec<Obligation>, Diagnostics) {
    let mut scope = Scope::of_family(library, unit, family);
    scope.anew.clone_from(wanted.anew);
    scope.span = spans.map(|(k, all)| (k, all.len()));
    scope.siblings = spans.map(|(_, all)| (all.to_vec(), written));
    set_known_factors(family.analytic.denominators());
    names::plan(&mut scope, written);
    scope.inherit(&family.obligations);
    let mut all = Vec::new();
    for f in &family.functions {
        // What the scope has copied.
        let _ = scope.budget.copy(&f.value);
    }
    // The same values as before; their errors are reported already.
    for def in names::names(written) {
        names::declare(&mut scope, &def.name);
        names::force(&mut scope, &def.name.text);
    }
    for (number, statement) in written.statements.iter().enumerate() {
        match &statement.kind {
            StatementKind::Claim(_) if library.run().is_stopped() => {}
            StatementKind::Claim(_) if !wanted.has(number) => {}
            StatementKind::Claim(claim) => {
                scope.budget.refill();
                let first = all.len();
                let errors = scope.diagnostics.borrow().errors();
                one(&mut scope, family, claim, (number, statement), &mut all);
                if !scope.settle(&|shapes_only| family.parts(shapes_only), family.budget) {
                    all.truncate(first); // what they say has no meaning somewhere
                }
                if scope.diagnostics.borrow().errors() > errors
                    && let Ok(position) = wanted.numbers.binary_search(&number)
                {
                    wanted.numbers.remove(position);
                }
                for claim in &mut all[first..] {
                    claim.doc.clone_from(&statement.doc);
                }
            }
            _ => {}
        }
    }
    (all, scope.obligations, scope.diagnostics.into_inner())
}

/// Reports what is wrong with the claims of a family that has errors already.
pub(crate) fn look_for_mistakes(scope: &mut Scope<'_>, written: &syntax::Family, family: &Family) {
    for (number, statement) in written.statements.iter().enumerate() {
        if let StatementKind::Claim(claim) = &statement.kind
            && is_about(scope, family, number)
        {
            one(scope, family, claim, (0, statement), &mut Vec::new());
        }
    }
}

/// Whether a statement is about a family as it is expanded, and not about one that is expanded anew.
fn is_about(scope: &Scope<'_>, family: &Family, number: usize) -> bool {
    let own = &scope.anew.statements;
    let mut others = family.analytic.finer.iter();
    has(own, number) || own.is_empty() && others.all(|group| !has(group, number))
}

/// Appends the claims that one statement makes, which has a number in the family.
fn one(
    scope: &mut Scope<'_>,
    family: &Family,
    claim: &syntax::Claim,
    (number, statement): (usize, &syntax::Statement),
    all: &mut Vec<Claim>,
) {
    let (span, last) = (statement.span, statement.last);
    let mut push =
        |scope: &Scope<'_>, text: String, (span, last): (Span, Span), by: Statement, kind: ClaimKind| {
            let run = scope.budget.run();
            let counted = run.claim(text.len()).and_then(|()| kind.kept(run));
            let fine = scope.fits(counted, span).is_some();
            if fine {
                let place = scope.library.place_to(scope.source, span, last);
                let (doc, expected) = (Vec::new(), claim.expected);
                all.push(Claim { text, doc, expected, place, statement: by, kind, about: None });
            }
            fine
        };
    let by = Statement { number: (number, 0), text: claim.text.clone(), range: "".into() };
    match &claim.kind {
        syntax::ClaimKind::Relation(relation) => {
            self::relation(scope, relation, &[], None, &mut |scope, text, kind| {
                push(scope, text, (span, last), by.clone(), kind)
            });
        }
        syntax::ClaimKind::At(bindings, relations) => {
            let Some(fixed) = fixed(scope, family, bindings) else { return };
            let printer = Printer { constants: &scope.constants, component: None };
            let part = |b: &Binding| format!("{} = {}", bound_text(&printer, b), printer.print(&b.value));
            let parts: Vec<String> = bindings.mapped(part);
            let at = parts.join(", ");
            for (equation, relation) in relations.iter().enumerate() {
                let (text, range) = (relation.text.clone(), relation.range.clone());
                let by = Statement { number: (number, equation), text, range };
                let place = (relation.span, relation.last);
                self::relation(scope, relation, &fixed, Some(&at), &mut |scope, text, kind| {
                    push(scope, format!("at {at}: {text}"), place, by.clone(), kind)
                });
            }
        }
        property => {
            let mut any = false;
            let fine = scope.each(&claim.loops, &mut |scope| {
                any = true;
                let made = self::property(scope, family, property, span);
                made.is_some_and(|(text, kind)| push(scope, text, (span, last), by.clone(), kind))
            });
            // A condition may well hold for other orders.
            if fine && !any && scope.constants.is_empty() {
                nothing_claimed(scope, &claim.loops, span);
            }
        }
    }
}

/// The claim of a property, as text and as what is claimed.
fn property(
    scope: &mut Scope<'_>,
    family: &Family,
    written: &syntax::ClaimKind,
    span: Span,
) -> Option<(String, ClaimKind)> {
    Some(match written {
        syntax::ClaimKind::PartitionOfUnity => {
            (String::from("partition_of_unity"), ClaimKind::PartitionOfUnity)
        }
        syntax::ClaimKind::Nonnegative => (String::from("nonnegative"), ClaimKind::Nonnegative),
        syntax::ClaimKind::Symmetric if scope.span.is_some() => {
            let (k, _) = scope.span?;
            let pieces = scope.siblings.as_ref().map(|(pieces, _)| &pieces[..])?;
            if !spans::are_symmetric(pieces) {
                let error = scope.error(span, "`symmetric` needs spans that are symmetric");
                scope.report(error.help("claim equations on the spans"));
                return None;
            }
            if k > 0 {
                return None; // said on the first span for all
            }
            (String::from("symmetric"), ClaimKind::Symmetric)
        }
        syntax::ClaimKind::Independent(_) if scope.span.is_some_and(|(k, _)| k > 0) => return None,
        syntax::ClaimKind::Continuity(..) if scope.span.is_some() => {
            let error = scope.error(span, "`continuity` is about segments of one span");
            scope.report(error.help("write `smooth(1)` for continuous derivatives at the inner knots"));
            return None;
        }
        syntax::ClaimKind::Smooth(order) => {
            let Some((k, _)) = scope.span else {
                let error = scope.error(span, "`smooth` is about the inner knots of several spans");
                scope.report(
                    error.help(
                        "name the domain variable once for each span: `domain 0 <= x <= 1, 1 <= x <= 3;`",
                    ),
                );
                return None;
            };
            let value = scope.whole(order, "the number of continuous derivatives")?;
            let Some(order) = u32::try_from(value).ok().filter(|k| *k <= crate::model::budget::MAX_DEGREE)
            else {
                let error = scope.error(order.span, format!("{value} continuous derivatives make no sense"));
                scope.report(error.help("write a number from 0 to the degree"));
                return None;
            };
            if k > 0 {
                return None; // said on the first span for all
            }
            (format!("smooth({order})"), ClaimKind::Smooth(order))
        }
        syntax::ClaimKind::Symmetric | syntax::ClaimKind::Continuity(..) if family.leaves_an_end_out() => {
            let name =
                if matches!(written, syntax::ClaimKind::Symmetric) { "symmetric" } else { "continuity" };
            let error = scope.error(span, format!("`{name}` is about a domain with both ends"));
            scope
                .report(error.help("include the ends of the domain, `<=`, or claim equations in its inside"));
            return None;
        }
        syntax::ClaimKind::Symmetric => (String::from("symmetric"), ClaimKind::Symmetric),
        syntax::ClaimKind::Independent(exceptions) => {
            let except = self::exceptions(scope, family, exceptions)?;
            let parts: Vec<String> = except.mapped(|values| describe_values(values, family));
            let text = if parts.is_empty() {
                String::from("independent")
            } else {
                format!("independent except {}", parts.join(", "))
            };
            (text, ClaimKind::Independent(except))
        }
        syntax::ClaimKind::TotallyPositive => {
            if family.interval().is_none() || scope.span.is_some() {
                let error = scope.error(span, "`totally_positive` is about functions on one interval");
                scope.report(error.help(if scope.span.is_some() {
                    "of functions on several spans it is not decided; claim it of a family on one of them"
                } else {
                    "claim it of the factors of functions on a box"
                }));
                return None;
            }
            (String::from("totally_positive"), ClaimKind::TotallyPositive)
        }
        syntax::ClaimKind::Continuity(order, next) => {
            let value = scope.whole(order, "the number of continuous derivatives")?;
            let Some(order) = u32::try_from(value).ok().filter(|k| *k <= crate::model::budget::MAX_DEGREE)
            else {
                let error = scope.error(order.span, format!("{value} continuous derivatives make no sense"));
                scope.report(error.help("write a number from 0 to the degree"));
                return None;
            };
            if family.interval().is_none() || family.functions.iter().any(|f| f.index.len() != 1) {
                let error = scope.error(
                    span,
                    "only segments of curves have neighbours: `continuity` needs one domain variable and one index",
                );
                scope.report(error.help("claim in a `theorem` how two patches join"));
                return None;
            }
            let mut text = format!("continuity({order})");
            let mut joint = Joint { order, next: Vec::new(), free: Vec::new() };
            if !next.is_empty() {
                let printer = Printer { constants: &scope.constants, component: None };
                let part = |b: &Binding| format!("{} = {}", bound_text(&printer, b), printer.print(&b.value));
                text += &format!(" with {}", next.mapped(part).join(", "));
                joint = neighbour(scope, family, next, order, span)?;
            }
            (text, ClaimKind::Continuity(joint))
        }
        #[cfg(not(any(test, feature = "rounding")))]
        syntax::ClaimKind::Rounding(_) => {
            let place = scope.place(span);
            scope.report(Diagnostic::needs_feature(place, "claims about rounding need", "rounding"));
            return None;
        }
        #[cfg(any(test, feature = "rounding"))]
        syntax::ClaimKind::Rounding(bound) => {
            let value = scope.number(bound, "a bound of rounding errors")?;
            if !value.is_positive() {
                let error = scope.error(bound.span, "a bound of rounding errors is a positive number of ε");
                scope.report(error.help("`basis explain` shows the bound that can be proved"));
                return None;
            }
            (format!("rounding <= {value}"), ClaimKind::Rounding(value))
        }
        syntax::ClaimKind::Relation(_) | syntax::ClaimKind::At(..) => return None,
    })
}

/// Takes a claim; whether there is room for it.
type Push<'p> = dyn FnMut(&Scope<'_>, String, ClaimKind) -> bool + 'p;
