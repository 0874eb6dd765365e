//! Quotients whose denominators have a sign only where premises hold, and what is nowhere 0 there.
//!
//! Where d ≥ 0, n/d has the sign of n wherever it is defined; and everywhere that of n·d.
//!
//! (c·x + r)² is positive where a premise g ≥ 0 holds if g is negative wherever x = −r/c.

use basis_kernel::{Quotient, Relation, Statement};
use basis_prover::of_negative;

use super::{Accept, Seen, Sign, inside};
use crate::algebra::divisors::factor::checked_factor;
use crate::algebra::poly::{Poly, PolyExt as _};

/// Ways for a denominator, with each of which those for the numerator are tried.
const MAX_BELOW: usize = 3;

impl Sign<'_> {
    /// For a quotient whose denominator has both signs in the box, or does not: that the denominator has the sign where the
    /// premises hold that it has at a point there, and the numerator the right one; or that their product has the sign of the
    /// quotient.
    pub(super) fn above_and_below(
        &self,
        depth: usize,
        has_both_signs: bool,
        accept: &mut Accept<'_>,
    ) -> bool {
        let Quotient { numerator, denominator } = &self.value;
        let Some(depth) = depth.checked_sub(1).filter(|_| denominator.as_constant().is_none()) else {
            return false;
        };
        let Some(point) = inside(denominator, self.domain) else { return false };
        let is_negative = denominator.eval(&point).is_negative();
        let sign = |p: &Poly, relation| Sign {
            value: Quotient::from(if is_negative { -p } else { p.clone() }),
            relation,
            domain: self.domain,
        };
        let by_any_way = |sign: &Sign<'_>, accept: &mut Accept<'_>| {
            Seen::new(&sign.value, self.domain)
                .filter(|seen| !seen.refutes(sign.relation, self.domain))
                .is_some_and(|seen| sign.enough(&seen, depth, accept))
        };
        // Where the denominator is 0 there is no value.
        let (above, below) = (sign(numerator, self.relation), sign(denominator, Relation::NonNegative));
        let seen = Seen::new(&below.value, self.domain);
        let Some(seen) = seen.filter(|seen| seen.fails(below.relation) == has_both_signs) else {
            return false;
        };
        let mut tried = 0;
        let mut found = false;
        below.enough(&seen, depth, &mut |of_below| {
            tried += 1;
            found = by_any_way(&above, &mut |of_above| accept([&of_below[..], &of_above].concat()));
            found || tried == MAX_BELOW
        });
        let product = Sign { value: Quotient::from(numerator * denominator), ..*self };
        found || by_any_way(&product, accept)
    }

    /// For an even power of c·x + r, where c is a number and x does not occur in r: that a premise fails where x is −r/c.
    pub(super) fn by_zeros(&self) -> Option<Vec<Statement>> {
        let Quotient { numerator, denominator } = &self.value;
        if self.relation != Relation::Positive || !denominator.is_one() {
            return None;
        }
        let (number, factors) = basis_prover::working(1, &mut |work| checked_factor(numerator, work))?;
        let [(base, exponent)] = &factors[..] else { return None };
        if !exponent.is_multiple_of(2) || !number.is_positive() {
            return None;
        }
        base.variables().into_iter().find_map(|x| {
            let [rest, factor] = &base.coefficients_in(x)[..] else { return None };
            let zero = rest.scale(&-&factor.as_constant()?.recip()?);
            let fails = |(g, premise): &(Poly, Relation)| {
                let relation = of_negative(*premise);
                let value = Quotient::from(-&g.substitute(x, &zero));
                Sign { value, relation, domain: self.domain }.if_seen()
            };
            self.domain.premises.iter().find_map(fails).map(|fails| vec![fails])
        })
    }
}
