//! Families on several neighbouring spans of one variable. Each span is a family of its own, with the formulas of that
//! span; what is claimed of the whole is claimed on every span, or of its knots.

use std::rc::Rc;

use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::{End, Range};
use crate::model::Family;
use crate::model::angle::Kind;
use crate::model::scope::Scope;
use crate::syntax::{self, RangeDecl, StatementKind};
use basis_prover::collections::list::Listed;
use basis_prover::{Coordinate, typical};

/// The ranges of a domain of several spans: those of one variable that is named more than once.
pub(super) fn spans(written: &syntax::Family) -> Option<&[RangeDecl]> {
    let decls = written.statements.iter().find_map(|s| match &s.kind {
        StatementKind::Domain(decls) => Some(decls.as_slice()),
        _ => None,
    })?;
    let (first, rest) = decls.split_first()?;
    rest.iter().any(|d| d.name.text == first.name.text).then_some(decls)
}

/// The two ends of the domain of a family on an interval in the variable itself.
pub(crate) fn ends(family: &Family) -> Option<(Fraction, Fraction)> {
    let (var, low, high) = family.interval()?;
    Some(match family.analytic.angle(var) {
        None => (Fraction::constant(low.clone()), Fraction::constant(high.clone())),
        Some(angle) if angle.kind == Kind::Linear => (angle.low.clone(), &angle.low + &angle.width),
        Some(angle) => (angle.limits[0].clone(), angle.limits[1].clone()),
    })
}

/// Whether the spans of a family are their own mirror image, and those that hold angles hold the same ones.
pub(super) fn are_symmetric(pieces: &[Rc<Family>]) -> bool {
    let all: Option<Vec<(Fraction, Fraction)>> = pieces.iter().map(|piece| ends(piece)).collect();
    let Some(all) = all else { return false };
    let (Some((low, _)), Some((_, high))) = (all.first(), all.last()) else { return false };
    let sum = low + high;
    let turned = |(a, b): &(Fraction, Fraction)| (&sum - b, &sum - a);
    let angle = |piece: &Rc<Family>| {
        let (var, ..) = piece.interval()?;
        let angle = piece.analytic.angle(var).filter(|angle| angle.kind != Kind::Linear)?;
        Some((angle.kind, angle.rate.clone(), angle.turns))
    };
    let spans = all.iter().zip(pieces);
    spans
        .clone()
        .zip(spans.rev())
        .all(|((span, piece), (mirrored, other))| *span == turned(mirrored) && angle(piece) == angle(other))
}

impl Scope<'_> {
    /// Whether a value of the domain variable lies in another span than this one; of two that share a knot in neither. Where it
    /// depends on shape parameters it is looked at with typical values of these: that it stays in the span is then to be shown.
    pub(crate) fn lies_elsewhere(&self, y: &Fraction, range: &Range, family: &Family) -> bool {
        if self.span.is_none() {
            return false;
        }
        if let Some(y) = self.analytic.number(y) {
            return !range.contains(&y);
        }
        // A number that is irrational is no end of a span where that end is rational, nor where it is none.
        let Some(piece) = family.pieces(&[], &[], true).into_iter().next() else { return true };
        let point =
            piece.ranges.iter().map(|(var, range)| (*var, Coordinate::Rational(typical(range)))).listed();
        let put = |y: Fraction, (var, value): (Var, Coordinate)| match value {
            Coordinate::Rational(value) => y.substitute(var, &Fraction::constant(value)),
            Coordinate::Algebraic(_) => None,
        };
        let y = piece.image(&point).into_iter().try_fold(y.clone(), put);
        y.and_then(|y| self.analytic.number(&y)).is_none_or(|y| !range.contains(&y))
    }

    /// The range of the domain variable on a span for a value that depends on shape parameters: without inner knots, at which
    /// a claim would be about two spans.
    pub(super) fn between_knots(&self, range: &Range, is_constant: bool) -> Range {
        let Some((k, count)) = self.span.filter(|_| !is_constant) else { return range.clone() };
        let open = |end: &End, is_knot: bool| match end.value().filter(|_| is_knot) {
            Some(x) => End::Excluded(x.clone()),
            None => end.clone(),
        };
        Range { low: open(&range.low, k > 0), high: open(&range.high, k + 1 < count) }
    }
}
