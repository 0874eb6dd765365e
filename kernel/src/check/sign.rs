//! Signs of polynomials on boxes.
//!
//! **Theorems.** p of degree 1 in x lies between its values at the ends of the range of x. A product has the product of
//! the signs of its factors. A square is not negative. A box is the union of its relatively open faces.

use super::claim::{Claim, divided, inside, without_ends};
use super::{bernstein, levels, slices};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Region};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::certificate::{FactorSign, SignProof, Signed};
use crate::refusal::{Refusal, fits, shown};
use crate::statement::Relation;

/// Checks that p ≥ 0 (> 0) on a box; a variable without a range stands for all real numbers.
pub(super) fn check(
    p: &Poly,
    relation: Relation,
    region: &Region,
    proof: &SignProof,
    work: &mut Work,
) -> Result<(), Refusal> {
    if region.ranges.iter().any(|(_, r)| r.is_empty()) {
        return fits(*proof == SignProof::direct(), "nothing has to be proved on an empty box");
    }
    let mut poly = p.clone();
    for (var, range) in &region.ranges {
        if let (End::Included(a), End::Included(b)) = (&range.low, &range.high)
            && a == b
        {
            work.spend_at(&poly, *var, a).ok_or(Refusal::Spent)?;
            poly = poly.at(*var, a);
        }
    }
    let ranges = poly.variables().into_iter().map(|v| (v, region.range(v))).collect();
    Claim { poly, relation, ranges, depth: 0 }.check(proof, work)
}

/// Checks that f or −f has a sign, as is said; whether it is −f.
pub(super) fn signed(
    f: &Poly,
    relation: Relation,
    region: &Region,
    signed: &Signed,
    work: &mut Work,
) -> Result<bool, Refusal> {
    match signed {
        Signed::Positive(proof) => check(f, relation, region, proof, work).map(|()| false),
        Signed::Negative(proof) => check(&-f, relation, region, proof, work).map(|()| true),
    }
}

impl Claim {
    /// Checks a proof of the claim.
    fn check(&self, proof: &SignProof, work: &mut Work) -> Result<(), Refusal> {
        if let Some(value) = self.poly.as_constant() {
            fits(*proof == SignProof::direct(), "a number needs no proof")?;
            return shown(self.relation.holds(&value), "a number is not as claimed");
        }
        match proof {
            SignProof::Cuts(cuts) => bernstein::cuts(self, cuts, work),
            SignProof::Corners { var, low, high, middle } => {
                let middle = middle.as_ref().map(|(x, proof)| (x, &**proof));
                self.corners(*var, [low, high], middle, work)
            }
            SignProof::Factors { factors, rest } => self.factors(factors, rest, work),
            SignProof::Squares { squares, rest } => self.squares(squares, rest, work),
            SignProof::Faces(faces) => self.faces(faces, work),
            SignProof::Cells(cells) => levels::cells(self, cells, work),
            SignProof::Slices(slices) => slices::slices(self, slices, Self::check, work),
        }
    }

    /// p = c + m·x lies between its values at the ends of the range of x.
    fn corners(
        &self,
        var: Var,
        [low, high]: [&SignProof; 2],
        middle: Option<(&Rational, &SignProof)>,
        work: &mut Work,
    ) -> Result<(), Refusal> {
        let range = self.range(var)?;
        fits(self.poly.degree(var) == 1, "the polynomial is not of degree 1 in the variable of the corners")?;
        let slope = self.poly.derivative(var);
        let mut strict = false;
        for (end, sign, proof) in [(&range.low, -1, low), (&range.high, 1, high)] {
            let mut part = match end.value() {
                Some(x) => self.slice(var, x, work)?,
                None => self.part(slope.scale(&Rational::from(sign)), self.relation)?,
            };
            if end.is_included() {
                strict = true;
            } else {
                part.relation = Relation::NonNegative;
            }
            part.check(proof, work)?;
        }
        let finite = range.low != End::Infinite || range.high != End::Infinite;
        fits(finite, "a range without ends has no corners")?;
        if let Some((x, proof)) = middle {
            fits(inside(range, x), "the middle is not strictly inside its range")?;
            self.slice(var, x, work)?.check(proof, work)?;
            strict = true;
        }
        shown(strict || self.relation == Relation::NonNegative, "nothing shows that the value is not zero")
    }

    /// p = ∏ fᵉ·r: a factor is divided out as often as possible; the signs multiply.
    fn factors(&self, factors: &[(Poly, FactorSign)], rest: &Signed, work: &mut Work) -> Result<(), Refusal> {
        let mut left = self.poly.clone();
        let mut negative = false;
        for (base, sign) in factors {
            fits(base.as_constant().is_none(), "a factor is a number")?;
            let (quotient, exponent) = divided(left, base, work)?;
            left = quotient;
            let odd = exponent % 2 == 1;
            fits(exponent > 0, "a factor does not divide the polynomial")?;
            match sign {
                FactorSign::Any => {
                    let square = !odd && self.relation == Relation::NonNegative;
                    shown(square, "the sign of a factor is open")?;
                }
                FactorSign::Known(signed) => negative ^= self.signed(base, signed, work)? && odd,
            }
        }
        negative ^= self.signed(&left, rest, work)?;
        shown(!negative, "the product of the signs is negative")
    }

    /// p = Σ c·f² + r: what is left of p without the squares is as claimed.
    fn squares(
        &self,
        squares: &[(Rational, Poly)],
        rest: &SignProof,
        work: &mut Work,
    ) -> Result<(), Refusal> {
        let mut left = self.poly.clone();
        for (factor, base) in squares {
            shown(factor.is_positive(), "a square is multiplied by a number that is not positive")?;
            let length =
                (left.len() + base.len().pow(2)) as u64 * (1 + (left.max_bits() + factor.bits()) / 64);
            work.spend(length).and_then(|()| work.spend_product(base, base)).ok_or(Refusal::Spent)?;
            left = &left - &(base * base).scale(factor);
        }
        self.part(left, self.relation)?.check(rest, work)
    }

    /// Whether f < 0 (≤ 0) is what is proved, and not f > 0 (≥ 0).
    fn signed(&self, f: &Poly, signed: &Signed, work: &mut Work) -> Result<bool, Refusal> {
        let (poly, proof, negative) = match signed {
            Signed::Positive(proof) => (f.clone(), proof, false),
            Signed::Negative(proof) => (-f, proof, true),
        };
        self.part(poly, self.relation)?.check(proof, work).map(|()| negative)
    }

    /// p > 0 on each of the open faces.
    fn faces(&self, proofs: &[SignProof], work: &mut Work) -> Result<(), Refusal> {
        fits(self.relation == Relation::Positive, "faces are for p > 0 only")?;
        // The choices by variable, the first variable slowest.
        let choices: Vec<Vec<Option<&Rational>>> = self
            .ranges
            .iter()
            .map(|(_, range)| {
                let ends = [&range.low, &range.high].into_iter().filter(|e| e.is_included()).map(End::value);
                [None].into_iter().chain(ends).collect()
            })
            .collect();
        let count = choices.iter().try_fold(1_usize, |n, c| n.checked_mul(c.len()));
        fits(count == Some(proofs.len()), "the number of faces is another one")?;
        for (number, proof) in proofs.iter().enumerate() {
            let mut rest = number;
            let mut poly = self.poly.clone();
            let mut open = Vec::new();
            for ((var, range), choices) in self.ranges.iter().zip(&choices).rev() {
                match choices[rest % choices.len()] {
                    Some(x) => {
                        work.spend_at(&poly, *var, x).ok_or(Refusal::Spent)?;
                        poly = poly.at(*var, x);
                    }
                    None => open.insert(0, (*var, without_ends(range))),
                }
                rest /= choices.len();
            }
            let face = Self { poly: poly.clone(), relation: self.relation, ranges: open, depth: self.depth };
            face.part(poly, self.relation)?.check(proof, work)?;
        }
        Ok(())
    }
}
