//! Denominators in floats: which rounding could make 0 or negative, and the form in which it cannot.
//!
//! A denominator W has no zeros, but its Bernstein coefficients may have both signs, as those of (t − m)² + c² have.
//! Where W is small beside them the sum of its terms has few digits left, and with fewer than none the wrong sign. Of
//! degree 2 with a number a > 0 as the coefficient of t² it is a·(t + b)² + c, whose parts are not negative where c is
//! not: then it is computed so. Any other one is cut off at 0 from the side on which it lies: what is divided by it
//! then is infinite or NaN, which can be seen, and not a number of the wrong sign, which cannot.

use super::sign::has_one_sign;
use super::{Builder, Input, Node, Ref};
use crate::algebra::poly::Poly;
use crate::algebra::rational::Rational;
use crate::model::Family;
use basis_prover::typical;

/// What is known of the sign of a denominator's floats.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Its Bernstein coefficients have one sign.
    Kept,
    /// Coefficients have both signs, and the sign of the denominator is not known.
    Unknown,
    /// Coefficients have both signs, but the denominator is positive.
    Positive,
    /// Coefficients have both signs, but the denominator is negative.
    Negative,
}

/// a·(t + b)² + c
#[derive(Clone, Debug)]
pub struct Completed {
    leading: Rational,
    shift: Poly,
    rest: Poly,
}

impl Sign {
    /// That at one point at which all conditions hold: a family is made only when its denominator is proved to vanish nowhere
    /// where they do, and it has one sign on a convex set. Conditions that are not linear may leave several parts.
    pub(super) fn of(family: &Family, bernstein: &[Poly]) -> Self {
        if has_one_sign(bernstein, &family.region()) {
            return Self::Kept;
        }
        let mut value = family.over.clone();
        let mut premises: Vec<Poly> = family.constraints.iter().map(|c| c.value.clone()).collect();
        for (var, range) in family.region().ranges {
            let at = typical(&range);
            value = value.at(var, &at);
            for premise in &mut premises {
                *premise = premise.at(var, &at);
            }
        }
        let sign = |p: &Poly| p.as_constant().map_or(0, |c| c.signum());
        let is_convex = family.constraints.iter().all(|c| c.value.total_degree() <= 1);
        match sign(&value) {
            _ if !is_convex => Self::Unknown,
            _ if premises.iter().any(|p| sign(p) <= 0) => Self::Unknown,
            1 => Self::Positive,
            -1 => Self::Negative,
            _ => Self::Unknown,
        }
    }
}

impl Completed {
    /// Of a denominator in t itself, or in a coordinate of the unit interval; `None` where it has no such form.
    pub(super) fn of(family: &Family) -> Option<Self> {
        let [c, b, a] = &family.over.coefficients_in(family.interval()?.0)[..] else { return None };
        let leading = a.as_constant().filter(Rational::is_positive)?;
        let half = (&leading * &Rational::from(2)).recip()?;
        let shift = b.scale(&half);
        let rest = c - &(&shift * &shift).scale(&leading);
        // That of 1, so that it is not negative.
        let is_fine = has_one_sign(&[rest.clone(), Poly::one()], &family.region());
        is_fine.then_some(Self { leading, shift, rest })
    }
}

impl Builder {
    /// The value of a completed square, whose rest is not negative.
    pub(super) fn completed(&mut self, form: &Completed, t: Ref) -> Ref {
        let root = if form.shift.is_zero() {
            t
        } else {
            let shift = self.scalar(&form.shift);
            let root = match self.node(shift) {
                Node::Neg(shift) => Node::Difference(t, *shift),
                _ => Node::Sum(t, shift),
            };
            self.push(root)
        };
        let mut square = self.squared(root);
        if !form.leading.is_one() {
            let leading = self.number(form.leading.clone());
            square = self.push(Node::Product(leading, square));
        }
        let rest = self.scalar(&form.rest);
        self.push(Node::Sum(square, rest))
    }

    /// A denominator that is cut off at 0 where rounding could take it beyond.
    pub(super) fn kept(&mut self, denominator: Ref, sign: &Sign) -> Ref {
        match sign {
            Sign::Kept | Sign::Unknown => denominator,
            Sign::Positive => self.push(Node::CutOff(denominator)),
            Sign::Negative => {
                let size = self.neg(denominator);
                let size = self.push(Node::CutOff(size));
                self.neg(size)
            }
        }
    }

    /// The variable of a completed square: the parameter, or a coordinate of the unit interval.
    pub(super) fn parameter_of(&mut self, family: &Family, x: Ref) -> Ref {
        if family.analytic.is_empty() { self.input(Input::Coordinate(0)) } else { x }
    }
}
