//! Real roots in an interval.
//!
//! **Theorem** (Sturm 1829). Let p₀ be a polynomial without multiple roots, p₁ its derivative, and each further one the
//! negative remainder of the two before, up to positive factors. With V(x) the number of changes of sign in p₀(x),
//! p₁(x), …, there are V(a) − V(b) roots with a < x ≤ b.

use super::claim::inside;
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::univariate::Univariate;
use crate::algebra::work::Work;
use crate::refusal::{Refusal, fits, shown};

/// Polynomials in one variable with their Sturm sequences.
pub(super) struct Sturm {
    sequences: Vec<Vec<Univariate>>,
}

impl Sturm {
    /// For polynomials in one variable, none of them zero.
    pub(super) fn new<'a>(
        polys: impl Iterator<Item = &'a Poly>,
        var: Var,
        work: &mut Work,
    ) -> Result<Self, Refusal> {
        let mut sequences = Vec::new();
        for p in polys {
            let p = Univariate::from_poly(p, var);
            let p = p.ok_or(Refusal::Unfit("a polynomial of a level depends on a higher variable"))?;
            shown(!p.is_zero(), "a polynomial of a level vanishes over a sample")?;
            sequences.push(sequence(&p, work).ok_or(Refusal::Spent)?);
        }
        Ok(Self { sequences })
    }

    /// The work of evaluating all sequences at numbers a few times each, in operations on machine words.
    pub(super) fn cost(&self, numbers: &[&Rational]) -> u64 {
        let bits: u64 = numbers.iter().map(|x| x.bits()).sum();
        let one = |p: &Univariate| {
            let len = p.degree() as u64 + 1;
            let own = p.max_bits() / 64;
            len.saturating_mul(4 * numbers.len() as u64 + len.saturating_mul(bits) / 16)
                .saturating_add(len.saturating_mul(own).saturating_mul(numbers.len() as u64))
        };
        self.sequences.iter().flatten().map(one).fold(0, u64::saturating_add)
    }

    /// Whether a number is a root of one of the polynomials.
    pub(super) fn is_root(&self, x: &Rational) -> bool {
        self.sequences.iter().any(|s| s[0].sign_at(x) == 0)
    }

    /// The number of roots strictly between two numbers, `None` standing for no limit; a root of several polynomials
    /// counts for each of them.
    pub(super) fn count(&self, low: Option<&Rational>, high: Option<&Rational>) -> usize {
        let roots = |s: &Vec<Univariate>| {
            let to_high = variations(s, low, false).saturating_sub(variations(s, high, true));
            to_high.saturating_sub(usize::from(high.is_some_and(|x| s[0].sign_at(x) == 0)))
        };
        self.sequences.iter().map(roots).sum()
    }

    /// Checks that numbers inside a range lie in different ones of the intervals into which the roots cut it, one in
    /// each, in increasing order.
    pub(super) fn separated(&self, numbers: &[&Rational], range: &Range) -> Result<(), Refusal> {
        for x in numbers {
            fits(inside(range, x), "a sample is outside of its range")?;
            shown(!self.is_root(x), "a sample is a root")?;
        }
        fits(numbers.windows(2).all(|w| w[0] < w[1]), "samples are not in increasing order")?;
        let (Some(first), Some(last)) = (numbers.first(), numbers.last()) else {
            return Err(Refusal::Unfit("there is no sample"));
        };
        let outside =
            self.count(range.low.value(), Some(*first)) + self.count(Some(*last), range.high.value());
        shown(outside == 0, "an outer interval is without a sample")?;
        let one = numbers.windows(2).all(|w| self.count(Some(w[0]), Some(w[1])) == 1);
        shown(one, "there is not one root between neighbouring samples")
    }
}

/// The Sturm sequence of a polynomial without its multiple roots; `None` when the work is spent.
fn sequence(p: &Univariate, work: &mut Work) -> Option<Vec<Univariate>> {
    let first = p.square_free_part(work)?;
    let mut next = first.derivative().primitive();
    let mut sequence = vec![first];
    while !next.is_zero() {
        let last = &sequence[sequence.len() - 1];
        let rest = last.remainder(&next, work)?;
        sequence.push(next);
        next = rest.scale(&Rational::from(-1));
    }
    Some(sequence)
}

/// The changes of sign of a sequence at a number, or below or above all roots.
fn variations(sequence: &[Univariate], x: Option<&Rational>, up: bool) -> usize {
    let sign = |p: &Univariate| x.map_or_else(|| p.sign_at_infinity(up), |x| p.sign_at(x));
    let signs: Vec<i32> = sequence.iter().map(sign).filter(|s| *s != 0).collect();
    signs.windows(2).filter(|w| w[0] != w[1]).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_roots_between_limits() {
        let x = Poly::var(Var(0));
        let n = Poly::integer;
        // x² (x − 1) (x² − 2)
        let factors = [x.pow(2), &x - &n(1), &x.pow(2) - &n(2)];
        let sturm = Sturm::new(factors.iter(), Var(0), &mut Work::unlimited()).expect("not zero");
        let r = Rational::from;
        assert_eq!(sturm.count(None, None), 4);
        assert_eq!(sturm.count(Some(&r(0)), Some(&r(1))), 0);
        assert_eq!(sturm.count(Some(&r(-2)), Some(&r(1))), 2);
        assert_eq!(sturm.count(Some(&r(0)), None), 2);
        assert_eq!(sturm.count(None, Some(&r(0))), 1);
        let range = Range::closed(r(-1), r(2));
        let (half, low, high) = (Rational::new(1, 2), Rational::new(-1, 2), Rational::new(6, 5));
        let top = Rational::new(3, 2);
        assert_eq!(sturm.separated(&[&low, &half, &high, &top], &range), Ok(()));
        assert!(sturm.separated(&[&low, &half, &top], &range).is_err());
        assert!(sturm.separated(&[&half, &high, &top], &range).is_err());
        assert!(sturm.separated(&[&low, &half, &high], &range).is_err());
    }
}
