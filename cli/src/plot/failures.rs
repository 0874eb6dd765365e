//! Points at which claims fail.

use basis_engine::algebra::fraction::Fraction;
use basis_engine::algebra::rational::{self, Rational, ToFloat as _};
use basis_engine::model::Parameter;
use basis_engine::model::angle::Angle;
use basis_engine::query::function_of;
use basis_engine::state::as_declared;
use basis_engine::{Checked, Family, Verdict, Witness};
use basis_kernel::collections::sort::sort_by;

use super::values::{Functions, pieces};

/// A claim that is refuted, with the point at which it fails.
#[derive(Clone, Debug)]
pub(super) struct Failure {
    /// Whether the spec declares it false.
    pub(super) declared: bool,
    /// The shape values there, by variable; nothing for those that play no part.
    pub(super) shapes: Vec<Option<Rational>>,
    /// The span of the domain on which it fails, counted from zero.
    pub(super) piece: usize,
    /// The domain variables of that span there; nothing for those on which it does not depend.
    pub(super) at: Vec<Option<Rational>>,
    /// The function that it is about, if it is one.
    pub(super) function: Option<usize>,
    /// What fails there, in words.
    pub(super) text: String,
}

impl Failure {
    /// Whether it is worth a picture: what is declared false only where there is a point to mark.
    pub(super) fn is_shown(&self) -> bool {
        !self.declared || self.at.iter().all(Option::is_some)
    }
}

/// The counterexamples to claims about a family: first to those that it declares true, then to those that it declares
/// false.
pub(super) fn failures(family: &Family, checked: &Checked) -> Vec<Failure> {
    let mut all = Vec::new();
    for (claim, verdict) in &checked.claims {
        let Verdict::Refuted(witness) = verdict else { continue };
        let declared = as_declared(claim.expected, verdict);
        // Of a shape parameter that plays no part any value will do, and one is there.
        let value = |p: &Parameter| of_name(witness, &p.name);
        let Some(shapes) = family.shapes.iter().map(value).collect::<Option<Vec<_>>>() else { continue };
        let labels: Vec<String> = (0..family.functions.len()).map(|k| family.function_label(k)).collect();
        let function = labels.iter().position(|label| *label == witness.of);
        let notes = witness.notes.join("; ").replace('`', "");
        let text = format!("{}{}: {notes}", claim.text, if declared { ", declared false" } else { "" });
        let (piece, at) = place(family, witness, &shapes, function);
        let function = function.or_else(|| function_of(family, &witness.of));
        let plays = |p: &Parameter| coordinate(witness, &p.name);
        let shapes = family.shapes.iter().map(plays).collect();
        all.push(Failure { declared, shapes, piece, at, function, text });
    }
    sort_by(&mut all, |a, b| a.declared.cmp(&b.declared));
    all
}

/// The span on which the claim fails, with the place there. A knot is on two spans; of these it is the one on which the
/// function has the value of the counterexample, or the first if no function is named.
fn place(
    family: &Family,
    witness: &Witness,
    shapes: &[Rational],
    function: Option<usize>,
) -> (usize, Vec<Option<Rational>>) {
    let on = |piece: &Family| -> Vec<Option<Rational>> {
        piece.domain.iter().map(|p| domain_value(piece, p, witness, shapes)).collect()
    };
    let places: Vec<_> = pieces(family).into_iter().map(|piece| (piece, on(piece))).collect();
    let inside = |(piece, at): &(&Family, Vec<Option<Rational>>)| {
        piece.domain.iter().zip(at).all(|(p, x)| x.as_ref().is_none_or(|x| p.range.contains(x)))
    };
    let distance = |(piece, at): &(&Family, Vec<Option<Rational>>)| {
        let at: Option<Vec<Rational>> = at.iter().cloned().collect();
        let value = function.zip(at).and_then(|(k, at)| Functions::new(piece, shapes).value(k, &at));
        value.map_or(0.0, |value| (value - witness.value.to_f64()).abs())
    };
    let there = places.iter().enumerate().filter(|(_, place)| inside(place));
    let nearest = there.min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b)));
    let found = nearest.map_or(0, |(k, _)| k);
    (found, places.into_iter().nth(found).map(|(_, at)| at).unwrap_or_default())
}

/// The value of a domain variable. A counterexample has x = low + width·y where the variable y runs from 0 to 1, as between
/// ends that are shape parameters; nothing where these ends are no rational numbers.
fn domain_value(family: &Family, p: &Parameter, witness: &Witness, shapes: &[Rational]) -> Option<Rational> {
    let Some(angle) = family.analytic.angle(p.var) else { return coordinate(witness, &p.name) };
    let Some(x) = coordinate(witness, &angle.tangent_name()) else {
        return end(p, angle, &coordinate(witness, &angle.name)?);
    };
    let known = |f: &Fraction| {
        let all = family.shapes.iter().zip(shapes);
        let put = |f: Fraction, (shape, x): (&Parameter, &Rational)| {
            f.substitute(shape.var, &Fraction::constant(x.clone()))
        };
        all.into_iter().try_fold(f.clone(), put)?.as_constant()
    };
    (&x - &known(&angle.low)?).checked_div(&known(&angle.width)?)
}

/// An end of the range at which an angle is the given number; there a counterexample names the angle itself.
fn end(p: &Parameter, angle: &Angle, number: &Rational) -> Option<Rational> {
    let ends = [&p.range.low, &p.range.high];
    let there = |k: &usize| angle.limits[*k].as_constant().as_ref() == Some(number);
    ends[(0..2).find(there)?].value().cloned()
}

/// A rational coordinate of a counterexample, if it plays a part.
fn coordinate(witness: &Witness, name: &str) -> Option<Rational> {
    if witness.idle.iter().any(|idle| idle == name) {
        return None;
    }
    of_name(witness, name)
}

/// A rational coordinate of a counterexample.
fn of_name(witness: &Witness, name: &str) -> Option<Rational> {
    let (_, coordinate) = witness.at.iter().find(|(known, _)| known == name)?;
    rational::parse(&coordinate.value(name))
}
