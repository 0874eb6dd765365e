//! Families on several spans: on each of them formulas of its own, and claims that are about several.

use std::rc::Rc;

use super::scope::{Reader, Scope, is_plain, places};
use super::{Claimed, Compared, Comparison, Formulas, Sign, Term};
use crate::algebra::rational::Rational;
use crate::claim::{Claim, ClaimKind};
use crate::model::{Family, Library};
use crate::syntax;

/// The formulas of a family on several spans, and of its claims.
pub(super) fn of(
    library: &Library<'_>,
    family: &Family,
    (unit, written): (usize, &syntax::Family),
    claims: &[Claim],
) -> Option<Formulas> {
    let mut reader = Reader::new(library);
    let mut scopes = Vec::new();
    for (k, piece) in family.pieces.iter().enumerate() {
        if !is_plain(piece) || !piece.analytic.is_empty() {
            return None;
        }
        let mut scope = Scope::new(unit, piece, written);
        scope.span = Some(k);
        reader.functions_of(&scope, piece, written)?;
        scopes.push(Rc::new(scope));
    }
    for scope in &scopes {
        scope.siblings.replace(scopes.iter().map(Rc::downgrade).collect());
    }
    let functions = family.pieces.iter().zip(&scopes).map(|(piece, s)| places(piece, &s.functions.borrow()));
    let spans = functions.collect::<Option<Vec<Vec<usize>>>>()?;
    let mut on_spans = Vec::new();
    for (k, (piece, scope)) in family.pieces.iter().zip(&scopes).enumerate() {
        let kinds: Vec<Option<&ClaimKind>> = claims.iter().map(|claim| on(&claim.kind, k)).collect();
        on_spans.push(reader.claims(scope, written, piece, &kinds)?);
    }
    let mut together = |number: usize, claim: &Claim| match &claim.kind {
        ClaimKind::Spans(parts) => {
            let mut claimed = Claimed::default();
            for (k, _) in parts {
                let part = on_spans.get(*k)?.get(number)?.as_ref()?;
                claimed.fixed.clone_from(&part.fixed);
                claimed.all.extend(part.all.iter().map(|c| Compared { span: *k, ..c.clone() }));
            }
            Some(claimed)
        }
        ClaimKind::Smooth(order) => {
            let all = smooth(&mut reader, family, &scopes, *order)?;
            Some(Claimed { fixed: Vec::new(), all })
        }
        ClaimKind::Symmetric => Some(Claimed { fixed: Vec::new(), all: symmetric(family, &scopes)? }),
        _ => None,
    };
    let claims = claims.iter().enumerate().map(|(number, claim)| together(number, claim)).collect();
    let functions = spans.first()?.clone();
    Some(Formulas { definitions: reader.definitions, functions, spans, claims })
}

/// What a claim says on a span.
fn on(kind: &ClaimKind, span: usize) -> Option<&ClaimKind> {
    let ClaimKind::Spans(parts) = kind else { return None };
    parts.iter().find_map(|(k, kind)| (*k == span).then_some(kind))
}

/// The functions on a span, at the point itself.
fn calls(scope: &Scope<'_>) -> Vec<Term> {
    scope.functions.borrow().iter().map(|(_, f)| scope.call(*f)).collect()
}

/// The domain variable with its ends.
fn interval(piece: &Family) -> Option<(usize, &Rational, &Rational)> {
    let (var, low, high) = piece.interval()?;
    Some((var.0, low, high))
}

/// At each inner knot the derivatives from both sides, function by function.
fn smooth(
    reader: &mut Reader<'_, '_>,
    family: &Family,
    scopes: &[Rc<Scope<'_>>],
    order: u32,
) -> Option<Vec<Compared>> {
    let mut all = Vec::new();
    for (k, (pair, sides)) in family.pieces.windows(2).zip(scopes.windows(2)).enumerate() {
        let (var, _, knot) = interval(&pair[0])?;
        let at = |f: &Term| f.put(&|v| (v == var).then(|| Term::Number(knot.clone())));
        for (mut left, mut right) in calls(&sides[0]).into_iter().zip(calls(&sides[1])) {
            for derivative in 0..=order {
                if derivative > 0 {
                    left = reader.differentiated(&sides[0], &left, var);
                    right = reader.differentiated(&sides[1], &right, var);
                }
                let equal = Compared::new(at(&left), Comparison::Equal, at(&right));
                all.push(Compared { span: k, ..equal });
            }
        }
    }
    Some(all)
}

/// b[i] on a span is b[n − i] on the span that takes its place when the domain is reversed.
fn symmetric(family: &Family, scopes: &[Rc<Scope<'_>>]) -> Option<Vec<Compared>> {
    let mut all = Vec::new();
    let mirrored = family.pieces.iter().zip(scopes).rev();
    for (k, ((piece, scope), (other, turned))) in family.pieces.iter().zip(scopes).zip(mirrored).enumerate() {
        let ((var, low, _), (_, _, high)) = (interval(piece)?, interval(other)?);
        let place =
            Term::Sum(vec![(Sign::Plus, Term::Number(low + high)), (Sign::Minus, Term::Variable(var))]);
        for (this, that) in calls(scope).into_iter().zip(calls(turned).into_iter().rev()) {
            let image = that.put(&|v| (v == var).then(|| place.clone()));
            all.push(Compared { span: k, ..Compared::new(this, Comparison::Equal, image) });
        }
    }
    Some(all)
}
