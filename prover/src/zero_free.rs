//! Denominators: polynomials that vanish nowhere on a box.

use std::rc::Rc;

use basis_kernel::{Domain, Quotient, Relation, Statement};

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{Range, Region};
use crate::algebra::rational::Rational;
use crate::budget::Budget;
use crate::coordinate::Coordinate;
use crate::decide::{Failure, Shown, decide};
use crate::sign::{Found, search};

/// Whether and where a polynomial vanishes.
#[derive(Clone, Debug)]
pub enum ZeroFree {
    /// It, or its negative, is positive everywhere.
    Proved(Shown),
    /// It is zero here.
    Zero(Vec<(Var, Coordinate)>),
    /// The budget is spent; what is left to decide, in words.
    Undecided(String),
}

impl ZeroFree {
    /// Where the polynomial is zero, if a point is known.
    pub fn zero(self) -> Option<Vec<(Var, Coordinate)>> {
        match self {
            Self::Zero(point) => Some(point),
            Self::Proved(_) | Self::Undecided(_) => None,
        }
    }
}

/// Looks for a zero of a polynomial in a domain without premises: that is connected, so that a polynomial without zeros
/// has one sign.
pub fn zero_free(polynomial: &Poly, domain: &Rc<Domain>, budget: u32) -> ZeroFree {
    let (mut signs, mut open) = (Vec::new(), None);
    for p in [polynomial.clone(), -polynomial] {
        let value = Quotient::from(p);
        let statement = Statement::Sign { value, relation: Relation::Positive, domain: Rc::clone(domain) };
        match decide(statement, &Vec::new(), budget) {
            Ok(shown) => return ZeroFree::Proved(shown),
            // The other sign may be proved.
            Err(Failure::Undecided(left)) => open = open.or(Some(left)),
            Err(Failure::Refuted(found)) => {
                if found.refutation.value().is_some_and(Rational::is_zero) {
                    return ZeroFree::Zero(found.point);
                }
                signs.push(found.point);
            }
        }
    }
    if let Some(left) = open {
        return ZeroFree::Undecided(left);
    }
    match &signs[..] {
        [positive, negative] => zero_between(polynomial, positive, negative, budget),
        _ => ZeroFree::Undecided(String::from(CHANGES)),
    }
}

const CHANGES: &str = "the sign of the denominator changes on the declared ranges";

/// A zero between two points at which the signs differ: on the way from one to the other along the axes, which
/// stays inside the box.
pub fn zero_between(
    polynomial: &Poly,
    a: &[(Var, Coordinate)],
    b: &[(Var, Coordinate)],
    budget: u32,
) -> ZeroFree {
    let mut at = a.to_vec();
    for k in 0..at.len() {
        let var = at[k].0;
        let next = b.iter().find(|(v, _)| *v == var).map_or_else(|| at[k].1.clone(), |(_, c)| c.clone());
        let (Coordinate::Rational(from), Coordinate::Rational(to)) = (at[k].1.clone(), next) else {
            return ZeroFree::Undecided(String::from(CHANGES));
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
        match search(&(&edge * &edge), Relation::Positive, &range, &mut Budget::scaled(budget)) {
            Found::Point(point) => {
                if let Some((_, c)) = point.into_iter().find(|(v, _)| *v == var) {
                    at[k].1 = c;
                }
                return ZeroFree::Zero(at);
            }
            Found::Nothing(left) => return ZeroFree::Undecided(left),
            Found::Proof(..) => at[k].1 = Coordinate::Rational(to),
        }
    }
    ZeroFree::Undecided(String::from(CHANGES))
}
