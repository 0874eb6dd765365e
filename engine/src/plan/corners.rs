//! Polynomials in hyperbolic tangents that are differences of nearly equal numbers where exponentials are large.
//!
//! The tangent T = tanh(v·α) of a shape parameter α goes to 1 as α grows, and to −1 as it falls; near these two ends only 1 − T
//! and 1 + T have digits, which evaluators compute without differences. A polynomial that is 0 at an end of one T has such a
//! factor, which is taken out. One in several variables may be 0 at a *corner*, an end for each of them, and have none:
//! 1 − T₁T₂, or λ + 1 − T with λ ≥ 0. As a sum of powers of T it has no digits near that corner.
//!
//! On a range from a to b of T, with the distances s = b − T and x = T − a, which have all their digits, a polynomial is
//! Σ binomial(d, k) c(k) s^(d−k) x^k / (b − a)^d with its Bernstein coefficients c(k), polynomials in the other variables, in which
//! the same is done as long as they are 0 at a corner: 1 − T₁T₂ = s₁ + x₁s₂. Where all numbers that are added have one sign, the
//! result has a small relative error at the corner as well.

use basis_prover::collections::list::Listed;

use crate::algebra::number::binomial;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::rational::Rational;
use crate::model::angle::Kind;
use crate::model::bernstein::bernstein_on;
use crate::model::{Family, Parameter};

/// With more corners than this, or more coefficients, a polynomial is left as it is.
const MOST: usize = 256;

/// The variables of the coefficients of a family, with the ends of their ranges.
#[derive(Clone, Default)]
pub(super) struct Corners {
    tangents: Vec<(Var, [Rational; 2])>,
    /// With the values that stand for the ends.
    others: Vec<(Var, Vec<Rational>)>,
}

impl Corners {
    /// Those of a family whose tangents are measured from 0.
    pub(super) fn of(family: &Family) -> Self {
        let mut all = Self::default();
        for p in &family.shapes {
            let ends = [p.range.low.value(), p.range.high.value()];
            match family.analytic.angle(p.var) {
                Some(angle) if angle.kind == Kind::Hyperbolic => {
                    let [low, high] = tangent_ends(p);
                    all.tangents.push((p.var, [low, high]));
                }
                _ if ends == [None, None] => all.others.push((p.var, vec![Rational::ONE])),
                _ => all.others.push((p.var, ends.into_iter().flatten().cloned().listed())),
            }
        }
        all.others.extend(family.analytic.values().into_iter().map(|(var, value)| (var, vec![value])));
        all
    }

    /// The first tangent that a polynomial has, with its ends.
    pub(super) fn tangent(&self, p: &Poly) -> Option<(Var, &[Rational; 2])> {
        self.tangents.iter().find(|(var, _)| p.depends_on(*var)).map(|(var, ends)| (*var, ends))
    }

    /// Whether a polynomial is 0 at a corner with all tangents at 1 or −1, and not for all tangents beside it.
    pub(super) fn cancels(&self, p: &Poly) -> bool {
        self.beside(p).is_some_and(|all| all.iter().any(|p| self.at_ends(p).iter().any(Rational::is_zero)))
    }

    /// Whether a polynomial has few coefficients in distances.
    pub(super) fn is_short(&self, p: &Poly) -> bool {
        let factors = self.tangents.iter().map(|(var, _)| u64::from(p.degree(*var)) + 1);
        factors.fold(1, u64::saturating_mul) <= MOST as u64
    }

    /// The values of a polynomial at its corners, where these are not 0 for all tangents.
    pub(super) fn values(&self, p: &Poly) -> Vec<Rational> {
        self.beside(p).map_or_else(Vec::new, |all| all.iter().flat_map(|p| self.at_ends(p)).listed())
    }

    /// Whether a coefficient of a polynomial, without tangents, is 0 at a corner of the other variables where that is not 0.
    pub(super) fn vanishes(&self, coefficient: &Poly, of: &Poly) -> bool {
        let Some(corners) = self.corners_beside(of) else { return true };
        let at = |p: &Poly, corner: &[(Var, Rational)]| {
            corner.iter().fold(p.clone(), |p, (var, value)| p.at(*var, value))
        };
        corners.iter().any(|corner| at(coefficient, corner).is_zero() && !at(of, corner).is_zero())
    }

    /// The corners of the other variables of a polynomial; `None` where there are many.
    fn corners_beside(&self, p: &Poly) -> Option<Vec<Vec<(Var, Rational)>>> {
        let mut all = vec![Vec::new()];
        for var in p.variables() {
            if self.tangents.iter().any(|(tangent, _)| *tangent == var) {
                continue;
            }
            let one = [Rational::ONE];
            let values = self.others.iter().find(|(other, _)| *other == var);
            let values = values.map_or(&one[..], |(_, values)| values);
            let with = |corner: &Vec<(Var, Rational)>, value: &Rational| {
                let mut corner = corner.clone();
                corner.push((var, value.clone()));
                corner
            };
            all = all.iter().flat_map(|corner| values.iter().map(|value| with(corner, value))).listed();
            if all.len() > MOST {
                return None;
            }
        }
        Some(all)
    }

    /// A polynomial at all corners of the other variables, but where it is 0; `None` where there are many.
    fn beside(&self, p: &Poly) -> Option<Vec<Poly>> {
        let at = |corner: &Vec<(Var, Rational)>| {
            corner.iter().fold(p.clone(), |p, (var, value)| p.at(*var, value))
        };
        let mut all = self.corners_beside(p)?.iter().map(at).listed();
        all.retain(|p| !p.is_zero());
        let tangents = self.tangents.iter().filter(|(var, _)| p.depends_on(*var)).count();
        (all.len() << tangents.min(16) <= MOST).then_some(all)
    }

    /// The values of a polynomial in tangents where each of these is at an end that is 1 or −1.
    fn at_ends(&self, p: &Poly) -> Vec<Rational> {
        let mut all = vec![p.clone()];
        for (var, ends) in self.tangents.iter().filter(|(var, _)| p.depends_on(*var)) {
            let ends = ends.iter().filter(|end| !end.is_zero()).listed();
            all = all.iter().flat_map(|p| ends.iter().map(|end| p.at(*var, end))).listed();
        }
        all.iter().filter_map(Poly::as_constant).listed()
    }
}

/// The ends of the range of a hyperbolic tangent: −1 or 0, and 0 or 1.
pub(super) fn tangent_ends(p: &Parameter) -> [Rational; 2] {
    let is_negative = p.range.low.value().is_none_or(Rational::is_negative);
    let is_positive = p.range.high.value().is_none_or(Rational::is_positive);
    let low = if is_negative { -Rational::ONE } else { Rational::ZERO };
    [low, if is_positive { Rational::ONE } else { Rational::ZERO }]
}

/// The coefficients of s^(d−k) x^k in a polynomial of degree d in a variable from `low` to `high`, where these are the distances to
/// the ends.
pub(super) fn by_distances(p: &Poly, var: Var, [low, high]: &[Rational; 2]) -> Vec<Poly> {
    let width = high - low;
    let degree = p.degree(var);
    let scale = width.pow(degree).recip().unwrap_or(Rational::ONE);
    let bernstein = bernstein_on(p, var, [low, high], degree);
    let scaled = |(k, c): (usize, &Poly)| c.scale(&(&scale * &binomial(degree, k as u32)));
    bernstein.iter().enumerate().map(scaled).listed()
}
