//! Why there is no bound, and for which ranges of shape parameters there is one.

use basis_prover::collections::list::{Listed, Mapped};

use super::{Bound, Error, point, values};
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::Var;
use crate::algebra::range::{DisplayRange as _, End, Range};
use crate::algebra::rational::Rational;
use crate::model::{Family, Parameter};

/// Parts of the ranges of all other variables at which it is looked whether values grow.
const PLACES: [[i64; 2]; 3] = [[1, 2], [1, 3], [4, 5]];

/// Ends that are tried in place of those that are left out: in place of 0 the reciprocal.
const ENDS: [i64; 3] = [64, 16, 4];

/// A bound of at most this many ε is named, and no shorter range is tried.
const SMALL: i64 = 1000;

/// What is said in place of a bound of a function, or of points where there is none, after `no bound`.
pub fn advice(family: &Family, function: Option<usize>) -> String {
    let mut text = String::from("no bound");
    match growing(family, function) {
        Some(growing) => text += &format!(": {growing}"),
        None => text += " found",
    }
    if let Some((ranges, bound)) = narrower(family, function) {
        text += &format!("; for `{ranges}` {bound}");
    }
    text
}

/// Which values grow beyond all bounds, and where.
fn growing(family: &Family, function: Option<usize>) -> Option<String> {
    let spans =
        if family.pieces.is_empty() { vec![family] } else { family.pieces.iter().map(|p| &**p).listed() };
    for span in spans.iter().filter(|span| !span.analytic.is_transcendental()) {
        let parameters = span.shapes.iter().chain(span.domain_variables()).listed();
        for p in &parameters {
            for (end, is_upper) in [(&p.range.low, false), (&p.range.high, true)] {
                if end.is_included() {
                    continue;
                }
                let grows =
                    |k: &usize| PLACES.iter().any(|part| grows(span, *k, p, end.value(), part) == Some(true));
                let found =
                    (0..span.functions.len()).filter(|k| function.is_none_or(|f| f == *k)).find(grows);
                if let Some(k) = found {
                    let to = end.value().map_or_else(
                        || String::from(if is_upper { "infinity" } else { "minus infinity" }),
                        ToString::to_string,
                    );
                    let (label, name) = (family.function_label(k), family.name_of(p));
                    return Some(format!(
                        "the values of `{label}` grow beyond all bounds where {name} goes to {to}"
                    ));
                }
            }
        }
    }
    None
}

/// Whether a function grows without end along a variable, all others being a part of their ranges from their lower
/// ends.
fn grows(
    family: &Family,
    k: usize,
    along: &Parameter,
    end: Option<&Rational>,
    part: &[i64; 2],
) -> Option<bool> {
    let part = Rational::new(part[0], part[1]);
    let mut f: Fraction = family.functions[k].value.clone();
    for angle in &family.analytic.angles {
        f = f.substitute(angle.itself, &Fraction::var(angle.var))?;
    }
    for p in family.shapes.iter().chain(family.domain_variables()).filter(|p| p.var != along.var) {
        let one = Rational::ONE;
        let place = match (p.range.low.value(), p.range.high.value()) {
            (Some(low), Some(high)) => low + &(&(high - low) * &part),
            (Some(low), None) => low + &one,
            (None, Some(high)) => high - &one,
            (None, None) => part.clone(),
        };
        f = f.substitute(p.var, &Fraction::constant(place))?;
    }
    let var: Var = along.var;
    let (above, below) = (f.numer(), f.denom());
    if above.variables().iter().chain(&below.variables()).any(|other| *other != var) {
        return None;
    }
    Some(match end {
        Some(end) => below.at(var, end).is_zero() && !above.at(var, end).is_zero(),
        None => above.degree(var) > below.degree(var),
    })
}

/// Ranges of shape parameters for which there is a bound, as they are written, and this bound.
fn narrower(family: &Family, function: Option<usize>) -> Option<(String, String)> {
    let is_open = |p: &Parameter| !(p.range.low.is_included() && p.range.high.is_included());
    let spans = family.pieces.iter().map(|piece| &**piece).chain([family]);
    if spans.into_iter().any(|span| span.analytic.is_transcendental()) || !family.shapes.iter().any(is_open) {
        return None;
    }
    let mut best: Option<(Family, Error)> = None;
    for end in ENDS {
        let narrow = within(family, end);
        let found = match function {
            Some(k) => values(&narrow).and_then(|all| all.into_iter().nth(k).flatten()),
            None => point(&narrow),
        };
        let Some(Bound { error, .. }) = found else { continue };
        let is_small = *error.epsilons() <= Rational::from(SMALL);
        if best.as_ref().is_none_or(|(_, known)| error.epsilons() < known.epsilons()) {
            best = Some((narrow, error));
        }
        if is_small {
            break;
        }
    }
    let (narrow, error) = best?;
    let open = narrow.shapes.iter().zip(&family.shapes).filter(|(_, p)| is_open(p));
    let ranges = open.map(|(p, _)| p.range.display(family.name_of(p)).to_string()).listed();
    let of = if function.is_some() { "" } else { " times the largest control point" };
    Some((ranges.join(", "), format!("it is {error}{of}")))
}

/// The family with other ends of ranges in place of those that are left out.
fn within(family: &Family, end: i64) -> Family {
    let mut narrow = family.clone();
    let ranges = family.shapes.mapped(|p| (p.var, closed(&p.range, &Rational::from(end))));
    let own = |shapes: &mut Vec<Parameter>| {
        for p in shapes {
            if let Some((_, range)) = ranges.iter().find(|(var, _)| *var == p.var) {
                p.range = range.clone();
            }
        }
    };
    own(&mut narrow.shapes);
    for piece in &mut narrow.pieces {
        own(&mut std::rc::Rc::make_mut(piece).shapes);
    }
    narrow
}

fn closed(range: &Range, most: &Rational) -> Range {
    let least = most.recip().unwrap_or(Rational::ONE);
    // Of a range with two ends a part of its length.
    let step = match range.finite() {
        Some((low, high)) => &(high - low) * &least,
        None => least,
    };
    let (zero, low, high) = (Rational::ZERO, range.low.value(), range.high.value());
    let inner = |own: &End, other: Option<&Rational>, sign: i64| {
        let sign = Rational::from(sign);
        match own.value() {
            Some(x) if own.is_included() => x.clone(),
            Some(x) => x - &(&step * &sign),
            None => other.unwrap_or(&zero) + &(most * &sign),
        }
    };
    Range::closed(inner(&range.low, high, -1), inner(&range.high, low, 1))
}
