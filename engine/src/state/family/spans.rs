//! Claims about families on several spans.

use std::rc::Rc;

use super::{Said, Saying};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::claim::{Claim, ClaimKind};
use crate::model::Family;
use crate::model::ends::reversed;
use crate::state::verdict::{Evidence, Stated, Verdict, Witness};
use basis_kernel::Statement;
use basis_prover::collections::list::{Listed, Mapped as _};

/// What a statement is about, with its span.
fn on(piece: &Family, of: &str) -> String {
    let spans: Vec<String> = piece.domain.iter().map(|p| piece.declared(p)).listed();
    format!("{of} on {}", spans.join(", "))
}

/// The claim on one span.
fn on_span<'f>(family: &'f Family, claim: &Claim, part: &(usize, ClaimKind)) -> Option<(&'f Family, Claim)> {
    let piece = family.pieces.get(part.0)?;
    Some((piece, Claim { kind: part.1.clone(), ..claim.clone() }))
}

/// What a claim says on all its spans.
pub(super) fn statements(
    family: &Family,
    claim: &Claim,
    parts: &[(usize, ClaimKind)],
    saying: &mut Saying<'_>,
) -> Option<Vec<Stated>> {
    let mut all = Vec::new();
    for part in parts {
        let (piece, claim) = on_span(family, claim, part)?;
        for Said { mut stated, .. } in super::said(piece, &claim, saying)? {
            stated.of = on(piece, &stated.of);
            all.push(stated);
        }
    }
    Some(all)
}

/// What refutes the claim on a span at a point, see [`super::at_point`].
pub(super) fn at_point(
    family: &Family,
    claim: &Claim,
    parts: &[(usize, ClaimKind)],
    of: &str,
    point: &[(Var, Rational)],
) -> Option<[Statement; 2]> {
    let here = |part| {
        let (piece, claim) = on_span(family, claim, part)?;
        let of = of.strip_suffix(&on(piece, ""))?;
        super::at_point(piece, &claim, of, point)
    };
    parts.iter().find_map(here)
}

/// Decides a claim on all its spans: false if it is on one of them.
pub(super) fn decide(family: &Family, claim: &Claim, parts: &[(usize, ClaimKind)]) -> Verdict {
    let (mut found, mut steps, mut ways) = (None, Vec::new(), Vec::new());
    let mut open = None;
    for part in parts {
        let Some((piece, claim)) = on_span(family, claim, part) else { continue };
        match super::decide::decide(piece, &claim) {
            Verdict::Proved(evidence) => {
                ways.extend_from_slice(evidence.ways());
                let (method, proofs) = evidence.into_parts();
                found = found.or(Some(method));
                steps.extend(proofs.into_iter().map(|(of, proof)| (on(piece, &of), proof)));
            }
            Verdict::Refuted(witness) => {
                let stated = on(piece, witness.of_statement());
                let mut witness = witness.about(&stated);
                say_span(family, parts, part.0, &mut witness);
                return Verdict::Refuted(Box::new(witness));
            }
            Verdict::Undecided(left) => open = open.or(Some(left)),
        }
    }
    match open {
        Some(left) => Verdict::Undecided(left),
        None => Verdict::Proved(Evidence::new(found.unwrap_or_default(), steps).by(ways)),
    }
}

/// Says which span is meant: of an equation, which holds on others perhaps, and where the point is an inner knot, that of two spans.
fn say_span(family: &Family, parts: &[(usize, ClaimKind)], span: usize, witness: &mut Witness) {
    let Some(piece) = family.pieces.get(span) else { return };
    let here = on(piece, "");
    let here = here.trim_start();
    let is_equation = matches!(witness.refutation().statement(), Statement::Zero { .. });
    if let (true, Some(first)) = (is_equation && !are_the_same(family, parts), witness.notes.first_mut()) {
        *first = format!("{here}, {first}");
    } else if is_inner_knot(family, span, &witness.point()) == Some(true) {
        witness.notes.push(format!("there the functions are those {here}"));
    }
}

/// Whether a claim says the same on all spans, as one about integrals does.
fn are_the_same(family: &Family, parts: &[(usize, ClaimKind)]) -> bool {
    let values = |kind: &ClaimKind| match kind {
        ClaimKind::Relation { differences, .. } => Some(differences.mapped(|(_, d)| d.value.clone())),
        _ => None,
    };
    let Some(first) = parts.first().and_then(|(_, kind)| values(kind)) else { return false };
    let depends = |f: &Fraction| family.domain.iter().any(|p| f.depends_on(p.var));
    !first.iter().any(depends) && parts.iter().all(|(_, kind)| values(kind).as_ref() == Some(&first))
}

/// Whether a point is an end of a span that is no end of the domain.
fn is_inner_knot(family: &Family, span: usize, point: &str) -> Option<bool> {
    let piece = family.pieces.get(span)?;
    let own = piece.domain.first()?;
    let variable = piece.analytic.angle(own.var).map_or(&own.name, |angle| &angle.name);
    let [low, high] = piece.end_texts()?;
    let value = |name: &str| point.split(", ").find_map(|part| part.strip_prefix(name)?.strip_prefix(" = "));
    // A knot is a number or a shape parameter, and the point is written by its name or its value.
    let is_at = |end: &String| value(variable).is_some_and(|x| x == end || Some(x) == value(end));
    Some(span > 0 && is_at(&low) || span + 1 < family.pieces.len() && is_at(&high))
}

/// At each inner knot the derivatives from both sides.
pub(super) fn smooth(family: &Family, order: u32, work: &mut Work) -> Option<Vec<(String, Fraction)>> {
    let mut differences = Vec::new();
    for pair in family.pieces.windows(2) {
        let own = pair[0].domain.first()?;
        let variable = pair[0].analytic.angle(own.var).map_or(&own.name, |angle| &angle.name);
        let knot = &pair[0].end_texts()?[1];
        let at = |piece: &Rc<Family>, k: usize, upper: bool, work: &mut Work| {
            piece.derivatives_at_end(&piece.functions[k].value, order, upper, work)
        };
        for k in 0..family.functions.len() {
            let (left, right) = (at(&pair[0], k, true, work)?, at(&pair[1], k, false, work)?);
            for (order, (a, b)) in left.iter().zip(&right).enumerate() {
                let b_name = family.function_label(k);
                let name = match order {
                    0 => b_name,
                    1 => format!("D({b_name})"),
                    _ => format!("D({b_name}, {order})"),
                };
                let of = format!("({name} before {variable} = {knot}) - ({name} after it)");
                differences.push((of, a.sub_within(b, work)?));
            }
        }
    }
    Some(differences)
}

/// b[i] on a span is b[n − i] on the span that takes its place when the domain is reversed.
pub(super) fn symmetric(family: &Family, work: &mut Work) -> Option<Vec<(String, Fraction)>> {
    let mut differences = Vec::new();
    let count = family.functions.len();
    for (piece, mirrored) in family.pieces.iter().zip(family.pieces.iter().rev()) {
        // The place in the other span of a place in this one.
        let turned = reversed(piece, mirrored, work)?;
        for k in 0..count {
            let mut image = mirrored.functions[count - 1 - k].value.clone();
            let (last, others) = turned.split_last()?;
            for (var, place) in others {
                image = image.substitute_within(*var, place, work).ok()??;
            }
            let own = &piece.functions[k].value;
            // Equal functions need no common divisor.
            let difference = if image.is_with(last.0, &last.1, own) {
                Fraction::zero()
            } else {
                own.sub_within(&image.substitute_within(last.0, &last.1, work).ok()??, work)?
            };
            let (this, that) = (family.function_label(k), family.function_label(count - 1 - k));
            let of = on(piece, &format!("{this} - {that} reversed"));
            differences.push((of, difference));
        }
    }
    Some(differences)
}
