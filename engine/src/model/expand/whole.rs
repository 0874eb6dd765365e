//! A family on its whole domain, of one span or of several, and its claims.

use std::rc::Rc;

use basis_prover::collections::map::SortedMap;
use basis_prover::collections::sort::{sort, sort_by_key};

use super::build;
use super::claims::{self, Wanted, has};
use super::fixed;
use super::spans::{self, ends};
use crate::claim::{Claim, ClaimKind};
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::angle::{Anew, Given};
use crate::model::obligation::Obligation;
use crate::model::{Family, Library};
use crate::source::SourceId;
use crate::syntax::{self, RangeDecl, StatementKind};
use basis_prover::collections::list::Listed;

/// Expands a family of one order; `None`, or anything with messages, cannot be used.
pub(crate) fn family<'a>(
    library: &'a Library<'a>,
    unit: usize,
    source: SourceId,
    written: &'a syntax::Family,
    order: &[i64],
) -> (Option<Family>, Diagnostics) {
    anew(library, (unit, source), written, order, &Anew::default())
}

/// Expands a family of one order with values of shape parameters, or for some claims.
fn anew<'a>(
    library: &'a Library<'a>,
    (unit, source): (usize, SourceId),
    written: &'a syntax::Family,
    order: &[i64],
    with: &Anew,
) -> (Option<Family>, Diagnostics) {
    match spans::spans(written) {
        Some(decls) => on_spans(library, (unit, source), written, order, (decls, with)),
        None => build::piece(library, (unit, source), written, order, None, with),
    }
}

/// Claims look at each span beside all others.
const MAX_SPANS: usize = 200;

/// Expands a family on several spans.
fn on_spans<'a>(
    library: &'a Library<'a>,
    (unit, source): (usize, SourceId),
    written: &'a syntax::Family,
    order: &[i64],
    (decls, with): (&[RangeDecl], &Anew),
) -> (Option<Family>, Diagnostics) {
    let mut diagnostics = Diagnostics::default();
    let wrong = |span, message: String, help: &str| {
        Diagnostic::error(library.place(source, span), message).help(help)
    };
    let own = &decls[0].name.text;
    if let Some(other) = decls.iter().find(|d| d.name.text != *own) {
        let message = format!("spans are those of one variable: `{own}` is named more than once");
        diagnostics.push(wrong(
            other.name.span,
            message,
            "a family has several spans, or several domain variables",
        ));
        return (None, diagnostics);
    }
    if let Some(decl) = decls.get(MAX_SPANS) {
        let message = format!("a family has at most {MAX_SPANS} spans");
        let help = "split the domain, or write one family for each part";
        diagnostics.push(wrong(decl.name.span, message, help));
        return (None, diagnostics);
    }
    let formulas = written.statements.iter().filter_map(|s| match &s.kind {
        StatementKind::Function(def) => Some(def),
        _ => None,
    });
    for def in formulas {
        let count = 1 + def.further.len();
        if count > 1 && count != decls.len() {
            let message = format!(
                "{} for {}",
                crate::plural::count(count, "formula"),
                crate::plural::count(decls.len(), "span")
            );
            let help = "write one formula for each span, separated by `|`, or one for all of them";
            diagnostics.push(wrong(def.name.span, message, help));
        }
    }
    for pair in decls.windows(2) {
        let closed = |limit: &Option<syntax::Limit>| limit.as_ref().is_some_and(|l| l.included);
        if !closed(&pair[0].high) || !closed(&pair[1].low) {
            let (message, help) = if pair[0].high.is_none() && pair[1].low.is_none()
                || pair[0].low.is_none() && pair[1].high.is_none()
            {
                (
                    "the range of a variable has two parts",
                    "write both ends in one chain, `domain 0 <= t <= 1;`",
                )
            } else {
                ("an inner knot belongs to both of its spans", "write `domain 0 <= x <= 1, 1 <= x <= 3;`")
            };
            diagnostics.push(wrong(pair[1].name.span, String::from(message), help));
        }
    }
    if !diagnostics.is_empty() {
        return (None, diagnostics);
    }
    let mut pieces: Vec<Rc<Family>> = Vec::new();
    for k in 0..decls.len() {
        let span = Some((k, decls.len()));
        let (piece, errors) = build::piece(library, (unit, source), written, order, span, with);
        let Some(piece) = piece.filter(|_| errors.is_empty()) else { return (None, errors) };
        pieces.push(Rc::new(piece));
    }
    for (k, pair) in pieces.windows(2).enumerate() {
        let (Some((_, end)), Some((start, _))) = (ends(&pair[0]), ends(&pair[1])) else { continue };
        if end != start {
            let (end, start) = (end.display(&pair[0].names), start.display(&pair[1].names));
            let message = format!("the spans do not touch: one ends at {end}, the next begins at {start}");
            let help = "write the spans in their order, each beginning where the one before ends";
            diagnostics.push(wrong(decls[k + 1].name.span, message, help));
            return (None, diagnostics);
        }
    }
    let mut whole = Family::clone(&pieces[0]);
    for piece in &pieces[1..] {
        for obligation in &piece.obligations {
            if whole.obligations.iter().all(|known| known.goal != obligation.goal) {
                whole.obligations.push(obligation.clone());
            }
        }
    }
    whole.pieces = pieces;
    (Some(whole), diagnostics)
}

/// The claims of a family on several spans: each on all spans together.
fn claims_on_spans<'a>(
    library: &'a Library<'a>,
    unit: usize,
    written: &'a syntax::Family,
    family: &Family,
    wanted: &mut Wanted<'_>,
) -> (Vec<Claim>, Vec<Obligation>, Diagnostics) {
    let mut by_span = Vec::new();
    let mut obligations = family.obligations.clone();
    let mut diagnostics = Diagnostics::default();
    for (k, piece) in family.pieces.iter().enumerate() {
        let spans = Some((k, &family.pieces[..]));
        let (all, more, errors) = claims::on_span(library, (unit, written), piece, spans, wanted);
        diagnostics.extend(errors.into_list());
        for obligation in more {
            if obligations.iter().all(|known| known.goal != obligation.goal) {
                obligations.push(obligation);
            }
        }
        by_span.push(all);
    }
    let mut result: Vec<Claim> = Vec::new();
    for (number, statement) in written.statements.iter().enumerate().filter(|(n, _)| wanted.has(*n)) {
        let StatementKind::Claim(claim) = &statement.kind else { continue };
        let of = |all: &Vec<Claim>| all.iter().filter(|c| c.statement.number.0 == number).cloned().listed();
        let parts: Vec<(usize, Vec<Claim>)> =
            by_span.iter().map(of).enumerate().filter(|(_, all)| !all.is_empty()).listed();
        let Some((_, first)) = parts.first() else {
            if matches!(claim.kind, syntax::ClaimKind::At(..)) {
                let place = library.place_to(family.source, statement.span, statement.last);
                let message = "the point lies in none of the spans";
                diagnostics.push(Diagnostic::error(place, message).help("choose a point in the domain"));
            }
            continue;
        };
        for (j, claim) in first.iter().enumerate() {
            // A function has one bound of its rounding errors on all spans: relative where it is on each of them.
            let whole = matches!(
                claim.kind,
                ClaimKind::Symmetric
                    | ClaimKind::Independent(_)
                    | ClaimKind::Smooth(_)
                    | ClaimKind::Rounding(_)
            );
            let kinds = parts.iter().filter_map(|(k, all)| Some((*k, all.get(j)?.kind.clone()))).listed();
            let kind = if whole { claim.kind.clone() } else { ClaimKind::Spans(kinds) };
            result.push(Claim { kind, ..claim.clone() });
        }
    }
    (result, obligations, diagnostics)
}

/// The claims that some statements make of a family that is expanded.
fn claims_of<'a>(
    library: &'a Library<'a>,
    unit: usize,
    written: &'a syntax::Family,
    family: &Family,
    wanted: &mut Wanted<'_>,
) -> (Vec<Claim>, Vec<Obligation>, Diagnostics) {
    if family.pieces.is_empty() {
        claims::on_span(library, (unit, written), family, None, wanted)
    } else {
        claims_on_spans(library, unit, written, family, wanted)
    }
}

/// A family that is expanded anew, and the numbers of the statements that are about it, ascending.
struct Apart {
    with: Anew,
    family: Option<Rc<Family>>,
    errors: Diagnostics,
    numbers: Vec<usize>,
}

/// The statements about values of shape parameters, or about smaller parts of the angles, with which the family has to be
/// expanded anew.
fn apart<'a>(
    library: &'a Library<'a>,
    unit: usize,
    written: &'a syntax::Family,
    family: &Family,
) -> Vec<Apart> {
    let mut all: Vec<Apart> = Vec::new();
    // The groups of statements by their numbers: whole groups would be compared for every statement.
    let groups = &family.analytic.finer;
    let numbered = groups.iter().enumerate();
    let mut group_of = numbered.flat_map(|(k, group)| group.iter().map(move |number| (*number, k))).listed();
    sort(&mut group_of);
    // Boxed, because there may be thousands of keys, which move when one comes between them.
    let mut known: SortedMap<Box<(Given, Option<usize>)>, usize> = SortedMap::new();
    for (number, statement) in written.statements.iter().enumerate() {
        let StatementKind::Claim(syntax::Claim { kind, .. }) = &statement.kind else { continue };
        let given = match kind {
            syntax::ClaimKind::At(bindings, _) => {
                fixed::without_tangents(library, unit, written, family, bindings)
            }
            _ => Given::new(),
        };
        let found = group_of.binary_search_by_key(&number, |(of, _)| *of).ok();
        let group = found.map(|position| group_of[position].1).filter(|_| given.is_empty());
        if given.is_empty() && group.is_none() {
            continue;
        }
        let at = *known.get_or_insert_with(Box::new((given.clone(), group)), || all.len());
        if at == all.len() {
            let statements = group.and_then(|k| groups.get(k)).cloned().unwrap_or_default();
            let with = Anew { given, statements };
            let order = family.order.iter().map(|(_, value)| *value).listed();
            let (there, errors) = anew(library, (unit, family.source), written, &order, &with);
            let family = there.filter(|_| errors.is_empty()).map(Rc::new);
            all.push(Apart { with, family, errors, numbers: Vec::new() });
        }
        all[at].numbers.push(number);
    }
    all
}

/// The claims of a family that is expanded; claims with errors are left out and reported.
pub(crate) fn claims<'a>(
    library: &'a Library<'a>,
    unit: usize,
    written: &'a syntax::Family,
    family: &Family,
) -> (Vec<Claim>, Vec<Obligation>, Diagnostics) {
    let mut numbers = (0..written.statements.len()).listed();
    let apart = apart(library, unit, written, family);
    // With a value that goes wrong they are about the family as it is.
    let is_apart = |of: &&Apart| of.family.is_some() || !of.with.statements.is_empty();
    for of in apart.iter().filter(is_apart) {
        numbers.retain(|number| !has(&of.numbers, *number));
    }
    let mut wanted = Wanted { numbers, anew: &Anew::default() };
    let (mut all, mut obligations, mut diagnostics) = claims_of(library, unit, written, family, &mut wanted);
    for Apart { with, family, errors, numbers } in apart {
        let Some(family) = family else {
            if !with.statements.is_empty() {
                diagnostics.extend(errors.into_list());
            }
            continue;
        };
        let mut wanted = Wanted { numbers, anew: &with };
        let (own, more, errors) = claims_of(library, unit, written, &family, &mut wanted);
        all.extend(own.into_iter().map(|claim| Claim { about: Some(Rc::clone(&family)), ..claim }));
        for obligation in more {
            if obligations.iter().all(|known| known.goal != obligation.goal) {
                obligations.push(obligation);
            }
        }
        diagnostics.extend(errors.into_list());
    }
    sort_by_key(&mut all, |claim| claim.statement.number);
    (all, obligations, diagnostics)
}
