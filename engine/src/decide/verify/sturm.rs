//! Counts the real roots of a polynomial in one variable by Sturm's theorem.

use super::{check, spend};
use crate::algebra::poly::{Poly, Var};
use crate::algebra::range::Range;
use crate::algebra::rational::Rational;
use crate::algebra::work::Work;

/// Coefficients, constant first, the last one not zero.
type Coefficients = Vec<Rational>;

/// Polynomials in one variable with their Sturm sequences.
pub(super) struct Sturm {
    sequences: Vec<Vec<Coefficients>>,
}

impl Sturm {
    /// For polynomials in one variable, none of them zero.
    pub(super) fn new<'a>(
        polys: impl Iterator<Item = &'a Poly>,
        var: Var,
        work: &mut Work,
    ) -> Result<Self, String> {
        let mut sequences = Vec::new();
        for p in polys {
            // The numbers of a sequence grow to as many bits as the degree times those of the coefficients.
            let degree = u64::from(p.degree(var));
            let words = 1 + degree.saturating_mul(p.max_bits()) / 64;
            spend(work, (degree * degree).saturating_mul(words))?;
            sequences.push(sequence(dense(p, var)?));
        }
        Ok(Self { sequences })
    }

    /// How many operations on machine words it takes to evaluate all sequences at numbers, a few times each.
    pub(super) fn cost(&self, numbers: &[&Rational]) -> u64 {
        let bits: u64 = numbers.iter().map(|x| x.bits()).sum();
        let one = |p: &Coefficients| {
            let len = p.len() as u64;
            let own = p.iter().map(Rational::bits).max().unwrap_or(0) / 64;
            len.saturating_mul(4 * numbers.len() as u64 + len.saturating_mul(bits) / 16)
                .saturating_add(len.saturating_mul(own).saturating_mul(numbers.len() as u64))
        };
        self.sequences.iter().flatten().map(one).fold(0, u64::saturating_add)
    }

    /// Whether a number is a root of one of the polynomials.
    pub(super) fn is_root(&self, x: &Rational) -> bool {
        self.sequences.iter().any(|s| s.first().is_some_and(|p| value(p, x).is_zero()))
    }

    /// The number of roots strictly between two numbers, `None` standing for no limit; a root of several polynomials
    /// counts for each of them.
    pub(super) fn count(&self, low: Option<&Rational>, high: Option<&Rational>) -> usize {
        let roots = |s: &Vec<Coefficients>| {
            // Sturm: V(low) − V(high) roots in low < x ≤ high.
            let to_high = variations(s, low, false).saturating_sub(variations(s, high, true));
            let at_high = high.is_some_and(|x| s.first().is_some_and(|p| value(p, x).is_zero()));
            to_high.saturating_sub(usize::from(at_high))
        };
        self.sequences.iter().map(roots).sum()
    }

    /// Checks that numbers inside a range lie in different ones of the intervals into which the roots cut it, one in
    /// each, in increasing order.
    pub(super) fn separated(&self, numbers: &[&Rational], range: &Range) -> Result<(), String> {
        for x in numbers {
            check(super::inside(range, x), || format!("the sample {x} is outside of its range"))?;
            check(!self.is_root(x), || format!("the sample {x} is a root"))?;
        }
        check(numbers.windows(2).all(|w| w[0] < w[1]), || "samples are not in increasing order".into())?;
        let (Some(first), Some(last)) = (numbers.first(), numbers.last()) else {
            return Err("there is no sample".into());
        };
        let outside =
            self.count(range.low.value(), Some(*first)) + self.count(Some(*last), range.high.value());
        check(outside == 0, || "an outer interval is without a sample".into())?;
        let one = numbers.windows(2).all(|w| self.count(Some(w[0]), Some(w[1])) == 1);
        check(one, || "there is not one root between neighbouring samples".into())
    }
}

/// The Sturm sequence of the polynomial without its multiple roots.
fn sequence(p: Coefficients) -> Vec<Coefficients> {
    let slope = derivative(&p);
    let common = gcd(p.clone(), slope);
    let square_free = if common.len() > 1 { quotient(p, &common) } else { p };
    let mut next = whole(derivative(&square_free));
    let mut sequence = vec![whole(square_free)];
    while let Some(last) = sequence.last() {
        if next.is_empty() {
            break;
        }
        let rest = remainder(last.clone(), &next);
        sequence.push(next);
        next = rest.iter().map(|c| -c).collect();
    }
    sequence
}

/// The changes of sign of a sequence at a number, or below or above all roots.
fn variations(sequence: &[Coefficients], x: Option<&Rational>, up: bool) -> usize {
    let far = |p: &Coefficients| {
        let lead = p.last().map_or(0, Rational::signum);
        if up || p.len() % 2 == 1 { lead } else { -lead }
    };
    let sign = |p: &Coefficients| x.map_or_else(|| far(p), |x| value(p, x).signum());
    let signs: Vec<i32> = sequence.iter().map(sign).filter(|s| *s != 0).collect();
    signs.windows(2).filter(|w| w[0] != w[1]).count()
}

/// The coefficients; an error for 0 and when another variable occurs.
fn dense(p: &Poly, var: Var) -> Result<Coefficients, String> {
    let all: Option<Coefficients> = p.coefficients_in(var).iter().map(Poly::as_constant).collect();
    let all = all.ok_or("a polynomial of a level depends on a higher variable")?;
    check(!p.is_zero(), || "a polynomial of a level vanishes over a sample".into())?;
    Ok(all)
}

fn value(p: &[Rational], x: &Rational) -> Rational {
    p.iter().rev().fold(Rational::ZERO, |v, c| &(&v * x) + c)
}

fn derivative(p: &[Rational]) -> Coefficients {
    p.iter().enumerate().skip(1).map(|(k, c)| c * &Rational::from(k as i64)).collect()
}

/// Multiplied by a positive number, so that the coefficients are whole without common factor.
fn whole(mut p: Coefficients) -> Coefficients {
    let content = p.iter().fold(Rational::ZERO, |g, c| g.gcd(c));
    if let Some(factor) = content.recip() {
        for c in &mut p {
            *c *= &factor;
        }
    }
    p
}

/// The quotient.
fn quotient(mut p: Coefficients, divisor: &[Rational]) -> Coefficients {
    let Some(lead) = divisor.last() else { return p };
    let mut quotient = Coefficients::new();
    while p.len() >= divisor.len() {
        let shift = p.len() - divisor.len();
        let factor = p.pop().map_or(Rational::ZERO, |top| &top / lead);
        for (k, c) in divisor.iter().take(divisor.len() - 1).enumerate() {
            p[k + shift] -= &(c * &factor);
        }
        quotient.insert(0, factor);
    }
    quotient
}

/// A positive multiple of the remainder, with whole coefficients.
fn remainder(mut p: Coefficients, divisor: &[Rational]) -> Coefficients {
    let Some(lead) = divisor.last() else { return p };
    while p.len() >= divisor.len() {
        let shift = p.len() - divisor.len();
        let top = p.pop().unwrap_or(Rational::ZERO);
        let top = if lead.is_negative() { -top } else { top };
        for c in &mut p {
            *c *= &lead.abs();
        }
        for (k, c) in divisor.iter().take(divisor.len() - 1).enumerate() {
            p[k + shift] -= &(c * &top);
        }
    }
    while p.last().is_some_and(Rational::is_zero) {
        p.pop();
    }
    whole(p)
}

fn gcd(mut a: Coefficients, mut b: Coefficients) -> Coefficients {
    while !b.is_empty() {
        let rest = remainder(a, &b);
        a = b;
        b = rest;
    }
    a
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
