//! Where a denominator vanishes on the declared ranges.

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::decide::{Budget, Coordinate, Decision, Relation, decide};

/// Whether and where a polynomial vanishes.
pub(super) enum Zero {
    /// It is different from zero everywhere.
    Nowhere,
    /// It is zero here.
    At(Vec<(Var, Coordinate)>),
    /// The budget is spent; what is left to decide.
    Undecided(String),
}

/// A zero of a polynomial in a box: the box is connected, so that a polynomial without zeros has one sign.
pub(super) fn zero(polynomial: &Poly, region: &Region, budget: u32) -> Zero {
    let positive = match decide(polynomial, Relation::Positive, region, &mut Budget::scaled(budget)) {
        Decision::Proved(_) => return Zero::Nowhere,
        Decision::Refuted(witness) => witness,
        Decision::Undecided(left) => return Zero::Undecided(left),
    };
    if positive.value.is_zero() {
        return Zero::At(positive.point);
    }
    let negative = match decide(&-polynomial, Relation::Positive, region, &mut Budget::scaled(budget)) {
        Decision::Proved(_) => return Zero::Nowhere,
        Decision::Refuted(witness) => witness,
        Decision::Undecided(left) => return Zero::Undecided(left),
    };
    if negative.value.is_zero() {
        return Zero::At(negative.point);
    }
    between(polynomial, &positive.point, &negative.point, budget)
}

/// A zero between two points at which the signs differ: on the way from one to the other along the axes, which
/// stays inside the box.
fn between(polynomial: &Poly, a: &[(Var, Coordinate)], b: &[(Var, Coordinate)], budget: u32) -> Zero {
    let mut at = a.to_vec();
    for k in 0..at.len() {
        let var = at[k].0;
        let next = b.iter().find(|(v, _)| *v == var).map_or_else(|| at[k].1.clone(), |(_, c)| c.clone());
        let (Coordinate::Rational(from), Coordinate::Rational(to)) = (at[k].1.clone(), next) else {
            return Zero::Undecided(String::from(
                "the sign of the denominator changes on the declared ranges",
            ));
        };
        let mut edge = polynomial.clone();
        for (other, c) in at.iter().filter(|(v, _)| *v != var) {
            if let Coordinate::Rational(c) = c {
                edge = edge.at(*other, c);
            }
        }
        let (low, high) = if from <= to { (from, to.clone()) } else { (to.clone(), from) };
        let range = Region { ranges: vec![(var, Range::closed(low, high))] };
        // The square is positive unless the denominator vanishes; for one variable this is always decided.
        match decide(&(&edge * &edge), Relation::Positive, &range, &mut Budget::scaled(budget)) {
            Decision::Refuted(witness) => {
                let zero = witness.point.into_iter().find(|(v, _)| *v == var);
                if let Some((_, c)) = zero {
                    at[k].1 = c;
                }
                return Zero::At(at);
            }
            Decision::Undecided(left) => return Zero::Undecided(left),
            Decision::Proved(_) => at[k].1 = Coordinate::Rational(to),
        }
    }
    Zero::Undecided(String::from("the sign of the denominator changes on the declared ranges"))
}
