//! Counterexamples as points of the names of a family.

use basis_kernel::Quotient;
use basis_prover::collections::list::Listed;
use basis_prover::{Coordinate, Counterexample, typical};

use super::beside;
use crate::algebra::fraction::Fraction;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::model::Family;
use crate::model::chart::Piece;

/// The names of the domain variables.
pub(super) fn domain_names(family: &Family) -> Vec<String> {
    let angles = family.domain.iter().filter_map(|p| family.analytic.angle(p.var));
    let other = angles.flat_map(|a| [a.name.clone(), a.tangent_name()]);
    family.domain_variables().map(|p| p.name.clone()).chain(other).listed()
}

/// A counterexample as a point of the names, complete with what `at` fixes and with values for what plays no part.
pub(super) fn named_point(
    family: &Family,
    found: &Counterexample,
    fixed: &[(Var, Fraction)],
    piece: &Piece,
) -> Vec<(String, Coordinate)> {
    // What plays no part in the image of a box has a value, too.
    let absent = |var: &Var| found.point.iter().all(|(v, _)| v != var);
    let idle = piece.ranges.iter().filter(|(var, _)| absent(var)).map(|(var, r)| (*var, typical(r))).listed();
    let image = |value: &Fraction| {
        let put = |p: Poly| idle.iter().fold(p, |p, (var, x)| p.at(*var, x));
        let quotient = piece.pull_back_fraction(value)?;
        found.evaluate(&Quotient {
            numerator: put(quotient.numerator),
            denominator: put(quotient.denominator),
        })
    };
    // On each simplex no more than what is left, and its last coordinate.
    let one = || (Rational::ONE, Fraction::constant(Rational::ONE));
    let mut rest: Vec<(Rational, Fraction)> = family.simplices.iter().map(|_| one()).listed();
    let mut all: Vec<(String, Coordinate)> = Vec::new();
    for (k, parameter) in family.shapes.iter().chain(&family.domain).enumerate() {
        let var = parameter.var;
        let place = k.checked_sub(family.shapes.len());
        let simplex = family.simplices.iter().position(|s| place.is_some_and(|k| s.places.contains(&k)));
        let mut on_simplex = simplex.and_then(|number| rest.get_mut(number));
        let given = found.point.iter().find(|(v, _)| *v == var).map(|(_, c)| c.clone());
        let fixed_value = fixed.iter().find(|(v, _)| *v == var).map(|(_, f)| f);
        if let Some((_, last)) = &mut on_simplex {
            *last = &*last - &fixed_value.cloned().unwrap_or_else(|| Fraction::var(var));
        }
        let known = if piece.steps.is_empty() {
            // Where all variables have values there are coordinates for those that are fixed, too.
            fixed_value.and_then(|f| beside::value_at(family, found, f)).or(given)
        } else {
            image(fixed_value.unwrap_or(&Fraction::var(var)))
        };
        let value = known.unwrap_or_else(|| {
            let simple = typical(&parameter.range);
            let Some((left, last)) = &mut on_simplex else { return Coordinate::Rational(simple) };
            let simple = simple.min(left.clone());
            *last = last.substitute(var, &Fraction::constant(simple.clone())).unwrap_or_else(Fraction::zero);
            Coordinate::Rational(simple)
        });
        if let (Some((left, _)), Coordinate::Rational(x)) = (on_simplex, &value) {
            *left -= x;
        }
        all.push((parameter.name.clone(), value));
    }
    beside::name_angles(family, found, fixed, &mut all);
    // In the order of the spec, each last coordinate after the others of its simplex.
    for (simplex, (_, last)) in family.simplices.iter().zip(rest).rev() {
        let at = family.shapes.len() + simplex.places.end;
        let value = found.evaluate(&last.quotient());
        if let Some(value) = value {
            all.insert(at.min(all.len()), (simplex.last.name.clone(), value));
        }
    }
    all
}
