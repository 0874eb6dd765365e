//! A claim about the sign of a polynomial, and its parts.

use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::{End, Range};
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;
use crate::refusal::{Refusal, fits};
use crate::statement::Relation;

/// Proofs within each other.
const MAX_DEPTH: usize = 100;

/// A polynomial, what is claimed of it, and the ranges of exactly its variables, none of them empty or a single number.
pub(super) struct Claim {
    pub(super) poly: Poly,
    pub(super) relation: Relation,
    pub(super) ranges: Vec<(Var, Range)>,
    pub(super) depth: usize,
}

impl Claim {
    /// A claim about another polynomial, a part of this one, on the same ranges.
    pub(super) fn part(&self, poly: Poly, relation: Relation) -> Result<Self, Refusal> {
        fits(self.depth < MAX_DEPTH, "the proof is nested too deeply")?;
        let variables = poly.variables();
        let known = variables.iter().all(|v| self.ranges.iter().any(|(w, _)| w == v));
        fits(known, "a part has other variables than the whole")?;
        let ranges = self.ranges.iter().filter(|(v, _)| variables.contains(v)).cloned().collect();
        Ok(Self { poly, relation, ranges, depth: self.depth + 1 })
    }

    /// The same claim where a variable has a value.
    pub(super) fn slice(&self, var: Var, x: &Rational, work: &mut Work) -> Result<Self, Refusal> {
        work.spend_at(&self.poly, var, x).ok_or(Refusal::Spent)?;
        self.part(self.poly.at(var, x), self.relation)
    }

    /// The range of a variable that occurs.
    pub(super) fn range(&self, var: Var) -> Result<&Range, Refusal> {
        let found = self.ranges.iter().find(|(v, _)| *v == var);
        found.map(|(_, r)| r).ok_or(Refusal::Unfit("a variable does not occur"))
    }
}

/// What is left of a polynomial that is not zero after division by one that is not constant, and how often it could be
/// divided.
pub(super) fn divided(poly: Poly, by: &Poly, work: &mut Work) -> Result<(Poly, u32), Refusal> {
    let (mut left, mut count) = (poly, 0);
    loop {
        work.spend((left.len() * by.len()) as u64 * (1 + (left.max_bits() + by.max_bits()) / 64))
            .ok_or(Refusal::Spent)?;
        let Some(quotient) = left.div_exact(by) else { return Ok((left, count)) };
        (left, count) = (quotient, count + 1);
    }
}

/// Whether a number is in a range and not one of its ends.
pub(super) fn inside(range: &Range, x: &Rational) -> bool {
    range.low.value().is_none_or(|a| a < x) && range.high.value().is_none_or(|b| x < b)
}

/// The range without its ends.
pub(super) fn without_ends(range: &Range) -> Range {
    let open = |end: &End| end.value().cloned().map_or(End::Infinite, End::Excluded);
    Range { low: open(&range.low), high: open(&range.high) }
}
